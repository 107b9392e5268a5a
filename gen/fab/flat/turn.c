/* Turning a piece so that it fits a sheet: the box of least area around a convex outline has a side
 * along one of its edges, so that only those directions are tried. Called by fab/flat/sheet.c. */
#include "fab/flat/turn.h"

#include <math.h>
#include <stdlib.h>

static const double slack = 1e-9; /* meters: rounding of what fits exactly */

/* ---- the convex hull ---- */

static int compare(const void *one, const void *other) {
  const lam_vec2 *a = one, *b = other;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  return (a->y > b->y) - (a->y < b->y);
}

/* Whether a, b, c turn to the left. */
static bool turns_left(lam_vec2 a, lam_vec2 b, lam_vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
}

/* Appends the points[from], points[from + step] ... to a chain that turns to the left only; the
 * points below `base` stay. Returns its length. */
static int grow_chain(lam_vec2 *chain, int length, int base, lam_vec2 point) {
  while (length > base + 1 && !turns_left(chain[length - 2], chain[length - 1], point)) length--;
  chain[length++] = point;
  return length;
}

/* The hull of all points, counterclockwise (monotone chains from left to right and back); the first
 * point stands at the end once more. Returns how many there are; *hull is in arena. */
static int convex_hull(lam_arena *arena, const lam_path *paths, int count, lam_vec2 **hull) {
  int n = 0;
  for (int i = 0; i < count; i++) n += paths[i].count;
  lam_vec2 *points = LAM_NEW(arena, lam_vec2, n);
  *hull = LAM_NEW(arena, lam_vec2, 2 * n + 1);

  n = 0;
  for (int i = 0; i < count; i++)
    for (int k = 0; k < paths[i].count; k++) points[n++] = paths[i].points[k];
  if (n) qsort(points, (size_t)n, sizeof *points, compare);

  int length = 0;
  for (int i = 0; i < n; i++) length = grow_chain(*hull, length, 0, points[i]);
  int base = length - 1;
  for (int i = n - 2; i >= 0; i--) length = grow_chain(*hull, length, base, points[i]);
  return length;
}

/* ---- boxes ---- */

/* The size of the box of a hull that is turned. */
static lam_vec2 turned_size(const lam_vec2 *hull, int count, const lam_motion *turn) {
  const lam_path outline = {.count = count, .points = (lam_vec2 *)hull};
  lam_vec2 min = {INFINITY, INFINITY}, max = {-INFINITY, -INFINITY};
  for (int i = 0; i < outline.count; i++) {
    lam_vec2 p = lam_motion_apply(turn, outline.points[i]);
    min = lam_v2(fmin(min.x, p.x), fmin(min.y, p.y));
    max = lam_v2(fmax(max.x, p.x), fmax(max.y, p.y));
  }
  return lam_v2(max.x - min.x, max.y - min.y);
}

static bool fits(lam_vec2 size, const double room[2]) {
  return size.x <= room[0] + slack && size.y <= room[1] + slack;
}

/* A piece that fits as it lies, or turned by a quarter, is not looked at any further. */
bool lam_turn_to_fit(lam_arena *arena, const lam_path *paths, int count, const double room[2],
                     lam_motion *turn) {
  const lam_motion as_is = {1, 0, {0, 0}}, quarter = {0, 1, {0, 0}};
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_vec2 *hull;
  int n = convex_hull(arena, paths, count, &hull);

  *turn = as_is;
  bool found = n < 3 || fits(turned_size(hull, n, &as_is), room);
  if (!found && fits(turned_size(hull, n, &quarter), room)) {
    *turn = quarter;
    found = true;
  }

  /* An edge along x, or along y. */
  double least = INFINITY;
  for (int i = 0; i < 2 * (n - 1) && (!found || least < INFINITY); i++) {
    lam_vec2 a = hull[i / 2], b = hull[i / 2 + 1];
    double length = hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0)) continue;
    lam_motion along = {(b.x - a.x) / length, -(b.y - a.y) / length, {0, 0}};
    if (i % 2) along = (lam_motion){-along.sine, along.cosine, {0, 0}};

    lam_vec2 size = turned_size(hull, n, &along);
    if (!fits(size, room) || size.x * size.y >= least * (1 - 1e-12)) continue;
    least = size.x * size.y;
    *turn = along;
    found = true;
  }

  lam_arena_release(arena, mark);
  return found;
}
