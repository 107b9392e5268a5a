/* A surface from its four sides. A curve is handled as a strip: a surface with two equal rows of points. */
#include "curve/basis.h"
#include "surf/least_area.h"
#include <math.h>

static const double same_knot = 1e-9, same_point = 1e-6; /* the domain is [0,1]; of the size of the boundary */

/* The strip over [0,1], backwards when `reversed`. */
static lam_spline_surface make_strip(lam_arena *arena, const lam_boundary_curve *curve, bool reversed) {
  static const double across[] = {0, 0, 1, 1};
  int n = curve->count, total = n + curve->degree + 1;
  double *knots = LAM_NEW(arena, double, total), *weights = LAM_NEW(arena, double, 2 * n);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 2 * n);
  if (!curve->knots) lam_knots_clamped(curve->degree, n, knots);
  double low = curve->knots ? curve->knots[0] : 0, high = curve->knots ? curve->knots[total - 1] : 1;
  for (int i = 0; i < total && curve->knots; i++) {
    double t = (curve->knots[reversed ? total - 1 - i : i] - low) / (high - low);
    knots[i] = reversed ? 1 - t : t;
  }
  for (int i = 0; i < 2 * n; i++) {
    int from = reversed ? n - 1 - i / 2 : i / 2;
    points[i] = curve->points[from];
    weights[i] = curve->weights ? curve->weights[from] : 1;
  }
  return (lam_spline_surface){NULL, {curve->degree, 1}, {n, 2}, {knots, across}, points, weights};
}

/* Gives both strips the knots of both. */
static void share_knots(lam_arena *arena, lam_spline_surface *a, lam_spline_surface *b) {
  for (int i = a->degree[0] + 1;; i++) {
    bool more[2] = {i < a->count[0], i < b->count[0]};
    if (!more[0] && !more[1]) return;
    double s = more[0] ? a->knots[0][i] : INFINITY, t = more[1] ? b->knots[0][i] : INFINITY;
    if (s < t - same_knot) *b = lam_spline_surface_insert(arena, b, 0, s);
    if (t < s - same_knot) *a = lam_spline_surface_insert(arena, a, 0, t);
  }
}

/* Which of the curves run backwards: [0] starts where [1] does, [2] where [1] ends, [3] where [0] ends. */
static bool orient(const lam_boundary_curve curves[4], bool reversed[4]) {
  lam_vec3 ends[4][2];
  double size = 0;
  for (int i = 0; i < 4; i++) {
    ends[i][0] = curves[i].points[0];
    ends[i][1] = curves[i].points[curves[i].count - 1];
    size = fmax(size, lam_distance(ends[i][0], ends[0][0]) + lam_distance(ends[i][0], ends[i][1]));
  }
  for (int way = 0; way < 16; way++) {
    double gap = 0;
    for (int i = 0; i < 4; i++) reversed[i] = way >> i & 1;
#define END(i, end) ends[i][(end) != reversed[i]]
    gap = fmax(lam_distance(END(0, 0), END(1, 0)), lam_distance(END(0, 1), END(3, 0)));
    gap = fmax(gap, fmax(lam_distance(END(1, 1), END(2, 0)), lam_distance(END(2, 1), END(3, 1))));
#undef END
    if (gap <= same_point * size) return true;
  }
  return false;
}

static double end_weight(const lam_spline_surface *strip, int end) {
  return strip->weights[end ? 2 * strip->count[0] - 1 : 0];
}

/* Scales the weights of a strip so that it starts with this one. */
static void scale_weights(lam_arena *arena, lam_spline_surface *strip, double first) {
  double *weights = LAM_NEW(arena, double, 2 * strip->count[0]), factor = first / end_weight(strip, 0);
  for (int i = 0; i < 2 * strip->count[0]; i++) weights[i] = factor * strip->weights[i];
  strip->weights = weights;
}

lam_boundary_problem lam_spline_surface_between(lam_arena *arena, const lam_boundary_curve curves[4],
                                                lam_spline_surface *surface) {
  bool reversed[4];
  lam_spline_surface strip[4];
  if (!orient(curves, reversed)) return LAM_BOUNDARY_OPEN;
  for (int i = 0; i < 4; i++) strip[i] = make_strip(arena, &curves[i], reversed[i]);
  for (int i = 0; i < 4; i++) {
    int degree = (int)fmax(3, fmax(curves[i].degree, curves[(i + 2) % 4].degree));
    strip[i] = lam_spline_surface_elevate(arena, &strip[i], (int[2]){degree, 1});
  }
  scale_weights(arena, &strip[1], end_weight(&strip[0], 0));
  scale_weights(arena, &strip[3], end_weight(&strip[0], 1));
  scale_weights(arena, &strip[2], end_weight(&strip[1], 1));
  if (fabs(end_weight(&strip[2], 1) / end_weight(&strip[3], 1) - 1) > 1e-9) return LAM_BOUNDARY_WEIGHTS;
  for (int i = 0; i < 2; i++) share_knots(arena, &strip[i], &strip[i + 2]);
  int m = strip[0].count[0], n = strip[1].count[0];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, m * n);
  double *weights = LAM_NEW(arena, double, m *n);
  for (int i = 0; i < m * n; i++) weights[i] = 1;
  for (int side = 3; side >= 0; side--)
    for (int k = 0; k < strip[side].count[0]; k++) {
      int at = side % 2 ? (side == 3 ? m - 1 : 0) * n + k : k * n + (side == 2 ? n - 1 : 0);
      points[at] = strip[side].points[2 * k];
      weights[at] = strip[side].weights[2 * k];
    }
  *surface = (lam_spline_surface){
      NULL, {strip[0].degree[0], strip[1].degree[0]}, {m, n}, {strip[0].knots[0], strip[1].knots[0]}, points, weights};
  return LAM_BOUNDARY_SOUND;
}
