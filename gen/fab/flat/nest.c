#include "fab/flat/nest.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* A free rectangle of a sheet. Free rectangles do not overlap. */
typedef struct room {
  int sheet;
  double x, y, width, height;
} room;

typedef struct rooms {
  lam_arena *arena;
  int count, capacity;
  room *items;
} rooms;

typedef struct turn {
  double width, height;
  int index;
} turn;

static void add_room(rooms *list, room space) {
  if (list->count == list->capacity) {
    int capacity = list->capacity ? 2 * list->capacity : 64;
    room *items = LAM_NEW(list->arena, room, capacity);
    if (list->count) memcpy(items, list->items, (size_t)list->count * sizeof *items);
    list->items = items;
    list->capacity = capacity;
  }
  list->items[list->count++] = space;
}

static int compare_turns(const void *left, const void *right) {
  const turn *a = left, *b = right;
  if (a->height != b->height) return a->height > b->height ? -1 : 1;
  if (a->width != b->width) return a->width > b->width ? -1 : 1;
  return a->index - b->index;
}

/* The room that is least too high; among equals the one on the first sheet, then the lowest, then
 * the leftmost. */
static int best_room(const rooms *list, double width, double height) {
  const double slack = 1e-9; /* sums of lengths are not exact */
  int best = -1;
  for (int i = 0; i < list->count; i++) {
    const room *a = &list->items[i], *b = best < 0 ? NULL : &list->items[best];
    if (a->width + slack < width || a->height + slack < height) continue;
    if (b && a->height > b->height + slack) continue;
    bool better = !b || a->height < b->height - slack || a->sheet < b->sheet ||
                  (a->sheet == b->sheet && (a->y < b->y || (a->y == b->y && a->x < b->x)));
    if (better) best = i;
  }
  return best;
}

int lam_nest(lam_arena *arena, lam_nest_item *items, int count, double width, double height) {
  turn *order = LAM_NEW(arena, turn, count);
  for (int i = 0; i < count; i++) order[i] = (turn){items[i].width, items[i].height, i};
  qsort(order, (size_t)count, sizeof *order, compare_turns);
  rooms list = {.arena = arena};
  int sheets = 0;
  for (int i = 0; i < count; i++) {
    lam_nest_item *item = &items[order[i].index];
    int at = best_room(&list, item->width, item->height);
    if (at < 0) {
      add_room(&list, (room){sheets++, 0, 0, width, height});
      at = list.count - 1;
    }
    room space = list.items[at];
    item->sheet = space.sheet;
    item->x = space.x;
    item->y = space.y;
    /* Right of the item a room of its height, above it one of the full width: a shelf. */
    list.items[at] = (room){space.sheet, space.x + item->width, space.y,
                            fmax(0, space.width - item->width), item->height};
    add_room(&list, (room){space.sheet, space.x, space.y + item->height, space.width,
                           fmax(0, space.height - item->height)});
  }
  return sheets;
}
