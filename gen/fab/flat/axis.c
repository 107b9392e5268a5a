/* Coordinates along and across the middle line of a developed strip. Called by fab/flat/face.c,
 * splice.c and splice_cuts.c, and by the flat patterns of fab/lamella. */
#include "fab/flat/axis.h"

#include <assert.h>
#include <math.h>

static lam_vec2 minus(lam_vec2 a, lam_vec2 b) { return lam_v2(a.x - b.x, a.y - b.y); }
static double dot(lam_vec2 a, lam_vec2 b) { return a.x * b.x + a.y * b.y; }
static lam_vec2 unit(lam_vec2 a) {
  double length = hypot(a.x, a.y);
  return length > 0 ? lam_v2(a.x / length, a.y / length) : a;
}

/* The tangent at an inner point is the bisector of the unit edges before and after it, at an
 * end the edge itself. Normals are tangents turned left by a right angle. */
lam_axis lam_axis_make(lam_arena *arena, const lam_vec2 *points, int count) {
  assert(count >= 2);
  lam_vec2 *normals = LAM_NEW(arena, lam_vec2, count);
  double *s = LAM_NEW(arena, double, count);

  lam_vec2 along = {0, 0};
  for (int i = 0; i < count; i++) {
    lam_vec2 next = i + 1 < count ? unit(minus(points[i + 1], points[i])) : along;
    lam_vec2 tangent = unit(lam_v2(along.x + next.x, along.y + next.y));
    normals[i] = lam_v2(-tangent.y, tangent.x);
    along = next;
    s[i] = i ? s[i - 1] + hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y) : 0;
  }

  return (lam_axis){count, points, normals, s, s[count - 1]};
}

/* Position runs linearly along a segment, and on beyond the ends. Normals are mixed between the
 * ends of the segment, so that lines across the strip turn steadily from one corner to the
 * next. */
lam_vec2 lam_axis_point(const lam_axis *axis, double s, double h, lam_vec2 *normal) {
  int low = 0, high = axis->count - 1; /* the segment low, low + 1 that holds s */
  while (high - low > 1) {
    int half = (low + high) / 2;
    if (axis->s[half] <= s)
      low = half;
    else
      high = half;
  }

  lam_vec2 a = axis->points[low], b = axis->points[low + 1], m = axis->normals[low],
           n = axis->normals[low + 1];
  double span = axis->s[low + 1] - axis->s[low], t = span > 0 ? (s - axis->s[low]) / span : 0;

  double turn = fmin(fmax(t, 0), 1); /* normals stay as they are beyond the ends */
  lam_vec2 up = unit(lam_v2(m.x + (n.x - m.x) * turn, m.y + (n.y - m.y) * turn));
  if (normal) *normal = up;

  return lam_v2(a.x + (b.x - a.x) * t + up.x * h, a.y + (b.y - a.y) * t + up.y * h);
}

/* Tries the segments one by one. The foot of the perpendicular is kept within the segment,
 * except beyond the ends of the axis. The first of equally near segments is taken. */
lam_vec2 lam_axis_locate(const lam_axis *axis, lam_vec2 point) {
  double best = INFINITY;
  lam_vec2 found = {0, 0};
  for (int i = 0; i + 1 < axis->count; i++) {
    lam_vec2 a = axis->points[i], step = minus(axis->points[i + 1], a), t = unit(step),
             from = minus(point, a);
    double length = hypot(step.x, step.y), along = dot(from, t);

    double low = i == 0 ? -INFINITY : 0, high = i + 2 == axis->count ? INFINITY : length;
    double foot = fmin(fmax(along, low), high);
    double distance = hypot(along - foot, dot(from, lam_v2(-t.y, t.x)));

    if (distance >= best) continue;
    best = distance;
    double across = dot(from, lam_v2(-t.y, t.x));
    found = lam_v2(axis->s[i] + foot, across < 0 ? -distance : distance);
  }

  return found;
}
