/* Polygons whose sides are moved along their normals until they meet again. Called by
 * fab/flat/sheet.c.
 *
 * Every side becomes its line, moved by the distance; neighbors meet at the corner
 *
 *   v + d (m + n) / (1 + m.n)     m, n: unit normals of the sides before and after v.
 *
 * As long as every side keeps its direction, every corner and middle its distance from all sides,
 * and no two sides cross, this is the exact offset, and moving back gives the polygon again.
 * Otherwise something has vanished or closed up. */
#include "fab/flat/path_offset.h"
#include "fab/flat/path.h"

#include <math.h>

/* Sides shorter than that may vanish: they are traces of rounding and of curves that were cut off.
 * No corner moves farther than that from where it should be. In meters. */
static const double negligible = 1e-5;
/* Corners that stick out by more than this many times the distance are cut off: 29 degrees. */
static const double miter_limit = 4;

/* A side that is left: where it begins, its direction, its length. */
typedef struct side {
  lam_vec2 start, along;
  double length;
} side;

/* ---- the sides ---- */

/* The sides of the polygon, counterclockwise; points at the same place are one. Returns their
 * number. */
static int make_sides(const lam_vec2 *points, int count, side *sides) {
  const lam_path path = {.count = count, .points = (lam_vec2 *)points};
  bool reversed = lam_path_area(&path) < 0;
  int n = 0;
  for (int i = 0; i < count; i++) {
    lam_vec2 a = points[reversed ? count - 1 - i : i];
    lam_vec2 b = points[reversed ? (2 * count - 2 - i) % count : (i + 1) % count];
    double length = hypot(b.x - a.x, b.y - a.y);
    if (length < 1e-9) continue;
    sides[n++] = (side){a, lam_v2((b.x - a.x) / length, (b.y - a.y) / length), length};
  }
  return n;
}

/* The corner from which side b follows side a: where their lines meet, or where b begins when they
 * are nearly parallel. After a side between them has vanished, that is not where it was. */
static lam_vec2 corner_of(const side *a, const side *b) {
  double sine = a->along.x * b->along.y - a->along.y * b->along.x;
  lam_vec2 gap = lam_v2(b->start.x - a->start.x, b->start.y - a->start.y);
  double t = (gap.x * b->along.y - gap.y * b->along.x) / sine;
  lam_vec2 meet = lam_v2(a->start.x + t * a->along.x, a->start.y + t * a->along.y);
  bool near = hypot(meet.x - b->start.x, meet.y - b->start.y) < negligible;
  return fabs(sine) > 1e-6 && near ? meet : b->start;
}

/* ---- corners ---- */

/* The moved corner or corners between two sides; see above. Returns how many: where the tip would
 * be too long, a cut at the distance across it, whose ends are d tan(turn / 4) along the sides. */
static int move_corner(const side *a, const side *b, double d, lam_vec2 corners[2]) {
  lam_vec2 v = corner_of(a, b), m = {a->along.y, -a->along.x}, n = {b->along.y, -b->along.x};
  double cosine = m.x * n.x + m.y * n.y, sine = m.x * n.y - m.y * n.x, sum = 1 + cosine;

  if (sine * d > 0 && sum < 2 / (miter_limit * miter_limit)) {
    double t = tan(fabs(atan2(sine, cosine)) / 4), s = fabs(d);
    corners[0] = lam_v2(v.x + d * m.x + s * t * a->along.x, v.y + d * m.y + s * t * a->along.y);
    corners[1] = lam_v2(v.x + d * n.x - s * t * b->along.x, v.y + d * n.y - s * t * b->along.y);
    return 2;
  }

  double k = d / fmax(sum, 1e-12);
  corners[0] = corners[1] = lam_v2(v.x + k * (m.x + n.x), v.y + k * (m.y + n.y));
  return 1;
}

/* Every side from its moved corner to the next one: the first that has turned around, or -1. */
static int find_turned(const side *sides, int n, double d) {
  for (int i = 0; i < n; i++) {
    lam_vec2 from[2], to[2];
    move_corner(&sides[(i + n - 1) % n], &sides[i], d, from);
    move_corner(&sides[i], &sides[(i + 1) % n], d, to);
    lam_vec2 moved = lam_v2(to[0].x - from[1].x, to[0].y - from[1].y);
    if (moved.x * sides[i].along.x + moved.y * sides[i].along.y <= 0) return i;
  }
  return -1;
}

/* Takes out sides that turn around, when they are negligible. Returns the number of those that are
 * left; less than 3: another one vanishes. */
static int drop_turned(side *sides, int n, double d) {
  for (int i; n >= 3 && (i = find_turned(sides, n, d)) >= 0;) {
    if (sides[i].length > negligible) return 0;
    for (int k = i; k + 1 < n; k++) sides[k] = sides[k + 1];
    n--;
  }
  return n;
}

/* ---- whether nothing has closed up ---- */

/* The distance of p from a side, or `most` when it is more than that. */
static double distance_within(const side *s, lam_vec2 p, double most) {
  double along = (p.x - s->start.x) * s->along.x + (p.y - s->start.y) * s->along.y;
  double across = (p.y - s->start.y) * s->along.x - (p.x - s->start.x) * s->along.y;
  double beyond = fmax(fmax(-along, along - s->length), 0);
  return fmin(fabs(across) < most ? hypot(across, beyond) : most, most);
}

/* Whether every corner and the middle of every moved side keep the distance d from all n sides, as
 * far as rounding lets them. */
static bool keeps_distance(const side *sides, int n, const lam_vec2 *points, int count, double d,
                           double rounding) {
  for (int i = 0; i < count; i++) {
    lam_vec2 p = points[i], q = points[(i + 1) % count];
    lam_vec2 middle = lam_v2((p.x + q.x) / 2, (p.y + q.y) / 2);
    for (int k = 0; k < n; k++)
      if (distance_within(&sides[k], p, d) < d - rounding ||
          distance_within(&sides[k], middle, d) < d - rounding)
        return false;
  }
  return true;
}

/* See the header. */
bool lam_offset_polygon(lam_arena *arena, const lam_vec2 *points, int count, double distance,
                        lam_vec2 *result, int *result_count) {
  *result_count = 0;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  side *sides = LAM_NEW(arena, side, count);
  int all = make_sides(points, count, sides), n = drop_turned(sides, all, distance), made = 0;

  for (int i = 0; i < n && n >= 3; i++)
    made += move_corner(&sides[(i + n - 1) % n], &sides[i], distance, result + made);

  double d = fabs(distance), rounding = (n < all ? 2 * negligible : 1e-9) + 1e-6 * d;
  bool apart = keeps_distance(sides, n, result, made, d, rounding);
  lam_arena_release(arena, mark);

  lam_path moved = {.closed = true, .count = made, .points = result};
  if (made < 3 || !apart || lam_path_area(&moved) <= 0 || lam_path_crossings(&moved)) return false;
  *result_count = made;
  return true;
}
