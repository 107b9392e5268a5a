/* Where a strip is cut: zones that no splice plate may touch, and positions outside of them with
 * as few cuts as possible. lam_splice_cuts is called by fab/flat/sheet.c. */
#include "fab/flat/axis.h"
#include "fab/flat/splice.h"

#include <math.h>
#include <stdlib.h>

/* Where no cut may be: open intervals of positions along the axis, sorted and without overlaps
 * (after merge). */
typedef struct interval {
  double low, high;
} interval;

typedef struct closed_zones {
  int count;
  interval *items;
} closed_zones;

/* For qsort: by their beginnings. */
static int compare_intervals(const void *left, const void *right) {
  const interval *a = left, *b = right;
  return (a->low > b->low) - (a->low < b->low);
}

/* Sorts the zones and joins those that overlap; intervals that only touch stay apart, for a cut
 * may be where they do. */
static void merge(closed_zones *zones) {
  qsort(zones->items, (size_t)zones->count, sizeof *zones->items, compare_intervals);
  int count = 0;
  for (int i = 0; i < zones->count; i++) {
    if (count && zones->items[i].low < zones->items[count - 1].high)
      zones->items[count - 1].high = fmax(zones->items[count - 1].high, zones->items[i].high);
    else
      zones->items[count++] = zones->items[i];
  }
  zones->count = count;
}

/* The allowed position nearest to x that is not above it. */
static double at_most(const closed_zones *zones, double x) {
  for (int i = zones->count - 1; i >= 0; i--)
    if (x > zones->items[i].low && x < zones->items[i].high) x = zones->items[i].low;
  return x;
}
/* The allowed position nearest to x that is not below it. */
static double at_least(const closed_zones *zones, double x) {
  for (int i = 0; i < zones->count; i++)
    if (x > zones->items[i].low && x < zones->items[i].high) x = zones->items[i].high;
  return x;
}

/* The zones around the ends, around slots (widened by their width), around marks (when marks is
 * true) and around avoided cuts. A zone is widened by half a plate, for it holds positions of
 * cuts. */
static closed_zones find_zones(lam_arena *arena, const lam_flat *flat, const lam_axis *axis,
                               const lam_splice *splice, bool marks, const double *avoid,
                               int avoid_count) {
  closed_zones zones = {
      0, LAM_NEW(arena, interval, 2 + flat->slot_count + flat->path_count + avoid_count)};

  /* Beyond the ends nothing is allowed; `far` is longer than any strip. */
  double far = 1e3 * (1 + axis->length), reach = splice->half;
  zones.items[zones.count++] = (interval){-far, reach + splice->hole};
  zones.items[zones.count++] = (interval){axis->length - reach - splice->hole, far};

  for (int i = 0; i < flat->slot_count; i++) {
    double low = flat->slots[i].low, high = flat->slots[i].high, width = high - low;
    zones.items[zones.count++] = (interval){low - width - reach, high + width + reach};
  }

  for (int i = 0; marks && i < flat->path_count; i++) {
    const lam_path *path = &flat->paths[i];
    double low = far, high = -far;
    for (int k = 0; k < path->count && path->layer != LAM_LAYER_CUT; k++) {
      double s = lam_axis_locate(axis, path->points[k]).x;
      low = fmin(low, s);
      high = fmax(high, s);
    }
    if (low <= high) zones.items[zones.count++] = (interval){low - reach, high + reach};
  }

  for (int i = 0; i < avoid_count; i++)
    zones.items[zones.count++] = (interval){avoid[i] - 2 * reach, avoid[i] + 2 * reach};

  merge(&zones);
  return zones;
}

/* The last possible position of every cut, each as far as it can be from the one before: with as
 * few cuts as there can be. Returns their number; -1 when a zone is longer than `longest`, or
 * when there are more cuts than the capacity. */
static int latest(const closed_zones *zones, double length, double longest, double *cuts,
                  int capacity) {
  int count = 0;
  double from = 0;
  while (length - from > longest) {
    double cut = at_most(zones, from + longest);
    if (cut <= from || count == capacity) return -1;
    cuts[count++] = from = cut;
  }
  return count;
}

/* The first possible position of each of count cuts, found from the end of the strip. */
static void earliest(const closed_zones *zones, double length, double longest, double *cuts,
                     int count) {
  double to = length;
  for (int i = count - 1; i >= 0; i--) cuts[i] = to = at_least(zones, to - longest);
}

/* Between its first and its last position every cut has free play; fraction picks a target in it,
 * moved to the nearest allowed position that stays in the play and within `longest` of the cut
 * before. cuts receives count positions. */
static void choose(const closed_zones *zones, double longest, double fraction, const double *first,
                   const double *last, double *cuts, int count) {
  double before = 0;
  for (int i = 0; i < count; i++) {
    double low = first[i], high = fmin(last[i], before + longest);
    double target = fmin(fmax(low + fraction * (last[i] - low), low), high);
    double down = at_most(zones, target), up = at_least(zones, target);
    bool down_fits = down >= low, up_fits = up <= high;

    cuts[i] = down_fits && (!up_fits || target - down <= up - target) ? down : up_fits ? up : low;
    before = cuts[i];
  }
}

/* See the header. Capacity: a piece between two cuts is nearly longest, or a zone lies in
 * between. */
int lam_splice_cuts(lam_arena *arena, const lam_flat *flat, double longest, const double *avoid,
                    int avoid_count, double fraction, double **cuts) {
  lam_axis axis = lam_axis_make(arena, flat->axis, flat->axis_count);
  lam_splice splice = lam_splice_for(flat->height);
  int capacity =
      2 + flat->slot_count + flat->path_count + 2 * (int)fmin(axis.length / longest, 1e6);
  double *first = LAM_NEW(arena, double, capacity), *last = LAM_NEW(arena, double, capacity);
  *cuts = LAM_NEW(arena, double, capacity);

  /* Wishes are given up in turn: marks, then avoided cuts, then both. */
  for (int attempt = 0; attempt < 4; attempt++) {
    bool marks = attempt % 2 == 0;
    closed_zones zones =
        find_zones(arena, flat, &axis, &splice, marks, avoid, attempt < 2 ? avoid_count : 0);

    int count = latest(&zones, axis.length, longest, last, capacity);
    if (count < 0) continue;

    earliest(&zones, axis.length, longest, first, count);
    choose(&zones, longest, fraction, first, last, *cuts, count);
    return count;
  }
  return -1;
}
