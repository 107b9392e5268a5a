/* Nesting with a list of free rectangles that is cut as it is filled (a guillotine packing in
 * shelves). Called by fab/flat/sheet.c, for pieces of one material and thickness at a time. */
#include "fab/flat/nest.h"
#include "core/grow.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* A free rectangle of a sheet. Free rectangles do not overlap. */
typedef struct free_rect {
  int sheet;
  double x, y, width, height;
} free_rect;

typedef struct free_rects {
  lam_arena *arena;
  int count, capacity;
  free_rect *items;
} free_rects;

/* An item as it is sorted: index is its number among the caller's items. */
typedef struct ranked_item {
  double width, height;
  int index;
} ranked_item;

static void add_free(free_rects *list, free_rect space) {
  LAM_APPEND(list->arena, list->items, list->count, list->capacity, space);
}

/* For qsort: the highest first, then the widest, then the order of the items. */
static int compare_sizes(const void *left, const void *right) {
  const ranked_item *a = left, *b = right;
  if (a->height != b->height) return a->height > b->height ? -1 : 1;
  if (a->width != b->width) return a->width > b->width ? -1 : 1;
  return a->index - b->index;
}

/* The free rectangle that the item fits with least height to spare; among equals the one on the
 * first sheet, then the lowest, then the leftmost. -1 when it fits none. */
static int best_fit(const free_rects *list, double width, double height) {
  const double slack = 1e-9; /* sums of lengths are not exact */
  int best = -1;
  for (int i = 0; i < list->count; i++) {
    const free_rect *a = &list->items[i], *b = best < 0 ? NULL : &list->items[best];
    if (a->width + slack < width || a->height + slack < height) continue;
    if (b && a->height > b->height + slack) continue;

    bool better = !b || a->height < b->height - slack || a->sheet < b->sheet ||
                  (a->sheet == b->sheet && (a->y < b->y || (a->y == b->y && a->x < b->x)));
    if (better) best = i;
  }

  return best;
}

/* Highest items first: each is put in the lower left corner of a free rectangle, which it cuts
 * in two. */
int lam_nest(lam_arena *arena, lam_nest_item *items, int count, double width, double height) {
  ranked_item *order = LAM_NEW(arena, ranked_item, count);
  for (int i = 0; i < count; i++) order[i] = (ranked_item){items[i].width, items[i].height, i};
  qsort(order, (size_t)count, sizeof *order, compare_sizes);

  free_rects list = {.arena = arena};
  int sheets = 0;
  for (int i = 0; i < count; i++) {
    lam_nest_item *item = &items[order[i].index];
    /* Where no free rectangle is large enough, a new sheet is begun. */
    int at = best_fit(&list, item->width, item->height);
    if (at < 0) {
      add_free(&list, (free_rect){sheets++, 0, 0, width, height});
      at = list.count - 1;
    }

    free_rect space = list.items[at];
    item->sheet = space.sheet;
    item->x = space.x;
    item->y = space.y;

    /* What is left of the rectangle: right of the item as high as it is, above it all along. */
    list.items[at] = (free_rect){space.sheet, space.x + item->width, space.y,
                                 fmax(0, space.width - item->width), item->height};
    add_free(&list, (free_rect){space.sheet, space.x, space.y + item->height, space.width,
                                fmax(0, space.height - item->height)});
  }

  return sheets;
}
