/* Paths of flat patterns: growing lists, circular holes, rotation and shift, bounds, areas and
 * crossings. Called by all that draws patterns (fab/flat, fab/lamella, fab/parts). */
#include "fab/flat/path.h"
#include "core/grow.h"
#include "core/numbers.h"

#include <math.h>
#include <string.h>

/* The points are copied first: the list may move while it grows, they do not. */
lam_path *lam_paths_add(lam_paths *paths, lam_layer layer, bool closed, int count,
                        const lam_vec2 *points) {
  lam_path path = {.layer = layer,
                   .closed = closed,
                   .count = count,
                   .points = LAM_NEW(paths->arena, lam_vec2, count)};
  if (count) memcpy(path.points, points, (size_t)count * sizeof *points);
  LAM_APPEND(paths->arena, paths->items, paths->count, paths->capacity, path);
  return &paths->items[paths->count - 1];
}

/* A regular n-gon of circumradius R has the area n/2 R^2 sin(2 pi/n); it equals pi r^2 for R =
 * r sqrt(2 pi / (n sin(2 pi/n))). */
void lam_paths_hole(lam_paths *paths, lam_vec2 center, double diameter) {
  enum { CORNERS = 48 };
  double step = 2 * LAM_PI / CORNERS;
  double radius = diameter / 2 * sqrt(step / sin(step));

  lam_vec2 points[CORNERS];
  for (int i = 0; i < CORNERS; i++)
    points[i] = lam_v2(center.x + radius * cos(step * i), center.y + radius * sin(step * i));
  lam_path *hole = lam_paths_add(paths, LAM_LAYER_CUT, true, CORNERS, points);
  hole->hole = true;
  hole->radius = diameter / 2;
}

/* The corners keep their ratio to the circle. */
void lam_path_resize(lam_path *circle, lam_vec2 *points, double radius) {
  lam_vec2 center = lam_path_center(circle);
  double scale = radius / circle->radius;
  for (int i = 0; i < circle->count; i++)
    points[i] = lam_v2(center.x + scale * (circle->points[i].x - center.x),
                       center.y + scale * (circle->points[i].y - center.y));
  circle->points = points;
  circle->radius = radius;
}

lam_vec2 lam_motion_apply(const lam_motion *motion, lam_vec2 point) {
  return lam_v2(motion->cosine * point.x - motion->sine * point.y + motion->move.x,
                motion->sine * point.x + motion->cosine * point.y + motion->move.y);
}

/* Everything but the points is the same in the copies. */
lam_path *lam_paths_placed(lam_arena *arena, const lam_path *paths, int count,
                           const lam_motion *motion) {
  lam_path *placed = LAM_NEW(arena, lam_path, count);
  for (int i = 0; i < count; i++) {
    placed[i] = paths[i];
    placed[i].points = LAM_NEW(arena, lam_vec2, paths[i].count);
    for (int k = 0; k < paths[i].count; k++)
      placed[i].points[k] = lam_motion_apply(motion, paths[i].points[k]);
  }
  return placed;
}

/* The first point begins the bounds; without points they stay zero. */
void lam_paths_bounds(const lam_path *paths, int count, lam_vec2 *min, lam_vec2 *max) {
  bool any = false;
  *min = *max = lam_v2(0, 0);
  for (int i = 0; i < count; i++)
    for (int k = 0; k < paths[i].count; k++) {
      lam_vec2 point = paths[i].points[k];
      if (!any) *min = *max = point;
      any = true;
      *min = lam_v2(fmin(min->x, point.x), fmin(min->y, point.y));
      *max = lam_v2(fmax(max->x, point.x), fmax(max->y, point.y));
    }
}

/* Marks and open paths enclose nothing; the orientation of a path does not matter. */
double lam_paths_area(const lam_path *paths, int count) {
  double area = 0;
  for (int i = 0; i < count; i++)
    if (paths[i].layer == LAM_LAYER_CUT && paths[i].closed)
      area += fabs(lam_path_area(&paths[i])) * (paths[i].hole ? -1 : 1);
  return area;
}

/* Twice the signed area of a, b, p: on which side of the line p lies. */
static double side_of(lam_vec2 a, lam_vec2 b, lam_vec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/* Whether the segments a b and p q cross in an inner point of both; boxes apart along x are
 * told first. */
static bool cross(lam_vec2 a, lam_vec2 b, lam_vec2 p, lam_vec2 q) {
  if (fmax(a.x, b.x) < fmin(p.x, q.x) || fmax(p.x, q.x) < fmin(a.x, b.x)) return false;
  return side_of(a, b, p) * side_of(a, b, q) < 0 && side_of(p, q, a) * side_of(p, q, b) < 0;
}

/* Every pair of sides that are not neighbors; the last side, n - 1 to 0, is only met as a
 * second one. */
long lam_path_crossings(const lam_path *path) {
  int n = path->count;
  const lam_vec2 *x = path->points;
  long crossings = 0;
  for (int i = 0; i < n; i++)
    for (int k = i + 2; k < n; k++) crossings += cross(x[i], x[i + 1], x[k], x[(k + 1) % n]);
  return crossings;
}

void lam_flat_set_paths(lam_flat *flat, const lam_paths *paths) {
  flat->paths = paths->items;
  flat->path_count = paths->count;
  lam_paths_bounds(paths->items, paths->count, &flat->min, &flat->max);
}
