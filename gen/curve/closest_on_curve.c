/* The nearest point of a curve by branch and bound on its Bezier pieces. Called by
 * surf/spline/surface_join.c. */
#include "curve/closest_on_curve.h"
#include "curve/bspline/basis.h"

enum {
  COARSE = 3,   /* halvings before Newton's method is tried */
  DEEPEST = 10, /* halvings of a piece at most */
  STEPS = 30    /* of Newton's method */
};

typedef struct closest_search {
  const lam_spline_curve *curve;
  lam_vec3 target;
  lam_closest best;
} closest_search;

/* Keeps the point at t when it is nearer than the best so far. */
static void offer(closest_search *s, double t) {
  lam_vec3 x;
  lam_spline_curve_eval(s->curve, t, 0, &x);
  double distance = lam_distance(x, s->target);
  if (distance < s->best.distance) s->best = (lam_closest){t, distance, x};
}

/* Newton's method for (x - target) . x' = 0 inside [a, b]; where a step leaves the bracket, or
 * the second derivative is not positive, half the bracket is taken. */
static void polish(closest_search *s, double a, double b) {
  double low = a, high = b, t = a + (b - a) / 2;
  for (int step = 0; step < STEPS; step++) {
    lam_vec3 x[3];
    lam_spline_curve_eval(s->curve, t, 2, x);
    lam_vec3 away = lam_sub(x[0], s->target);
    double slope = lam_dot(away, x[1]), bend = lam_dot(x[1], x[1]) + lam_dot(away, x[2]);

    if (slope == 0) break;
    if (slope > 0)
      high = t;
    else
      low = t;

    double next = bend > 0 ? t - slope / bend : low + (high - low) / 2;
    if (!(next >= low && next <= high)) next = low + (high - low) / 2;
    if (next == t) break;
    t = next;
  }

  offer(s, t);
}

/* The distance from the target to the box of the points of a piece: the piece is no nearer, as
 * its weights are positive (convex hull). piece: degree + 1 homogeneous points. */
static double box_distance(int degree, const double *piece, lam_vec3 target) {
  double p[3] = {target.x, target.y, target.z}, sum = 0;
  for (int c = 0; c < 3; c++) {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i <= degree; i++) {
      low = fmin(low, piece[4 * i + c] / piece[4 * i + 3]);
      high = fmax(high, piece[4 * i + c] / piece[4 * i + 3]);
    }
    double out = fmax(0, fmax(low - p[c], p[c] - high));
    sum += out * out;
  }
  return sqrt(sum);
}

/* De Casteljau's algorithm at the middle; left and right become the Bezier points of the halves. */
static void halve(int degree, const double *piece, double *left, double *right) {
  for (int i = 0; i < 4 * (degree + 1); i++) right[i] = piece[i];
  for (int r = 0; r <= degree; r++) {
    for (int c = 0; c < 4; c++) left[4 * r + c] = right[c];
    for (int i = 0; i < 4 * (degree - r); i++) right[i] = (right[i] + right[i + 4]) / 2;
  }
}

/* Looks through the piece over [a, b], the nearer half first, so that the farther one is more
 * often left out. The first levels only offer their middles: a good bound before Newton's method
 * is worth its price. */
static void search(closest_search *s, const double *piece, double a, double b, int depth) {
  int degree = s->curve->degree;
  if (box_distance(degree, piece, s->target) >= s->best.distance) return;

  double middle = a + (b - a) / 2, left[4 * LAM_BASIS_MAX_VALUES], right[4 * LAM_BASIS_MAX_VALUES];
  if (depth < COARSE) offer(s, middle);
  if (depth >= COARSE) polish(s, a, b);
  if (depth == DEEPEST) return;

  halve(degree, piece, left, right);
  bool first = box_distance(degree, left, s->target) <= box_distance(degree, right, s->target);
  search(s, first ? left : right, first ? a : middle, first ? middle : b, depth + 1);
  search(s, first ? right : left, first ? middle : a, first ? b : middle, depth + 1);
}

/* The ends of the pieces are offered first: together with the insides that is the whole curve. */
lam_closest lam_spline_curve_closest(lam_arena *arena, const lam_spline_curve *curve,
                                     lam_vec3 point) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  closest_search s = {curve, point, {.distance = INFINITY}};
  lam_pieces pieces = lam_bspline_pieces(arena, lam_spline_curve_net(arena, curve, true), 0, NULL);
  for (int k = 0; k <= pieces.count; k++) offer(&s, pieces.breaks[k]);
  for (int k = 0; k < pieces.count; k++)
    search(&s, pieces.values + (size_t)k * (pieces.degree + 1) * 4, pieces.breaks[k],
           pieces.breaks[k + 1], 0);
  lam_arena_release(arena, mark);
  return s.best;
}
