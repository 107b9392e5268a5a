/* Exact changes of spline curves, made on homogeneous points by the functions of
 * curve/bspline/bspline.h. lam_spline_curve_part is called by mesh/line_curve.c, _map by
 * surf/spline; the others are the curve kernel's face to its users
 * (tests/unit/curve/test_curve_edit.c). */
#include "curve/curve.h"

/* The spline to work on: of dimension 4 only when the curve has weights. */
static lam_bspline net_of(lam_arena *arena, const lam_spline_curve *curve) {
  return lam_spline_curve_net(arena, curve, false);
}

lam_spline_curve lam_spline_curve_insert(lam_arena *arena, lam_spline_curve curve, double t,
                                         int multiplicity) {
  return lam_spline_curve_from_net(
      arena, lam_bspline_insert(arena, net_of(arena, &curve), t, multiplicity));
}

/* What a homogeneous coefficient may move, so that no curve point moves more than tolerance: a
 * deviation d moves points by at most d (1 + max |P|) / min w (Piegl & Tiller, eq. 5.30). */
static double homogeneous_tolerance(const lam_spline_curve *curve, double tolerance) {
  if (!curve->weights) return tolerance;
  double far = 0, least = INFINITY;
  for (int i = 0; i < curve->count; i++) {
    far = fmax(far, lam_length(curve->points[i]));
    least = fmin(least, curve->weights[i]);
  }
  return tolerance * least / (1 + far);
}

/* Every removal uses up its part of the tolerance. */
int lam_spline_curve_remove(lam_arena *arena, lam_spline_curve *curve, double t, int times,
                            double tolerance) {
  lam_bspline net = net_of(arena, curve);
  double left = homogeneous_tolerance(curve, tolerance), moved;
  int removed = 0;
  while (removed < times && lam_bspline_remove(arena, net, t, left, &net, &moved)) {
    left -= moved;
    removed++;
  }
  if (removed) *curve = lam_spline_curve_from_net(arena, net);
  return removed;
}

lam_spline_curve lam_spline_curve_elevate(lam_arena *arena, lam_spline_curve curve, int degree) {
  return lam_spline_curve_from_net(arena,
                                   lam_bspline_elevate(arena, net_of(arena, &curve), degree));
}

lam_spline_curve lam_spline_curve_reduce(lam_arena *arena, lam_spline_curve curve, int ends,
                                         double *deviation) {
  return lam_spline_curve_from_net(
      arena, lam_bspline_reduce(arena, net_of(arena, &curve), ends, deviation));
}

lam_spline_curve lam_spline_curve_part(lam_arena *arena, lam_spline_curve curve, double low,
                                       double high) {
  return lam_spline_curve_from_net(arena,
                                   lam_bspline_part(arena, net_of(arena, &curve), low, high));
}

lam_spline_curve lam_spline_curve_reverse(lam_arena *arena, lam_spline_curve curve) {
  return lam_spline_curve_from_net(arena, lam_bspline_reverse(arena, net_of(arena, &curve)));
}

/* Only the knots change, so a spline without values is moved. */
lam_spline_curve lam_spline_curve_move_domain(lam_arena *arena, lam_spline_curve curve, double low,
                                              double high) {
  lam_bspline net = {curve.degree, curve.count, 0, curve.knots, NULL};
  curve.knots = lam_bspline_move_domain(arena, net, low, high).knots;
  return curve;
}

/* The knots of piece k: p + 1 times its start, p + 1 times its end. */
const lam_spline_curve *lam_spline_curve_pieces(lam_arena *arena, lam_spline_curve curve,
                                                int *count) {
  lam_pieces pieces = lam_bspline_pieces(arena, net_of(arena, &curve), 0, NULL);
  lam_spline_curve *list = LAM_NEW(arena, lam_spline_curve, pieces.count);
  int p = pieces.degree, n = pieces.dimension;

  for (int k = 0; k < pieces.count; k++) {
    double *knots = LAM_NEW(arena, double, 2 * p + 2);
    for (int i = 0; i < 2 * p + 2; i++) knots[i] = pieces.breaks[i > p ? k + 1 : k];
    list[k] = lam_spline_curve_from_net(
        arena, (lam_bspline){p, p + 1, n, knots, pieces.values + (size_t)k * (p + 1) * n});
  }

  *count = pieces.count;
  return list;
}

/* s (w x) over w: multiplying the points by s raises their degree and refines their knots, so the
 * weights are multiplied by the constant 1 in the same space. */
lam_spline_curve lam_spline_curve_scale(lam_arena *arena, lam_bspline s, lam_spline_curve curve) {
  lam_bspline net = net_of(arena, &curve), scaled = lam_bspline_product(arena, s, net);
  if (net.dimension == 3) return lam_spline_curve_from_net(arena, scaled);

  double *ones = LAM_NEW(arena, double, s.count),
         *values = LAM_NEW(arena, double, scaled.count * 4);

  for (int i = 0; i < s.count; i++) ones[i] = 1;
  lam_bspline plain =
      lam_bspline_product(arena, (lam_bspline){s.degree, s.count, 1, s.knots, ones}, net);

  for (int i = 0; i < 4 * scaled.count; i++)
    values[i] = i % 4 == 3 ? plain.values[i] : scaled.values[i];

  scaled.values = values;
  return lam_spline_curve_from_net(arena, scaled);
}

/* Affine maps go through the weights: only the points change. */
lam_spline_curve lam_spline_curve_map(lam_arena *arena, lam_spline_curve curve, lam_pose frame) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, curve.count);
  for (int i = 0; i < curve.count; i++) {
    lam_vec3 p = curve.points[i], x = lam_along(frame.origin, p.x, frame.axis[0]);
    points[i] = lam_along(lam_along(x, p.y, frame.axis[1]), p.z, frame.axis[2]);
  }
  curve.points = points;
  return curve;
}
