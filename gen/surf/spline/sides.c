/* Four curves become the sides of a patch: which is which, which way it runs, and corners that
 * meet exactly. Called by sides_keys.c. */
#include "surf/spline/sides.h"
#include "curve/curve.h"
#include <float.h>
#include <string.h>

static const double same_point = 1e-6; /* of the size */

/* An arrangement: which curve is side i, and whether it runs backwards. */
typedef struct arrangement {
  int curve[LAM_SIDES];
  bool reversed[LAM_SIDES];
} arrangement;

/* The ends of the curves: [curve][0: start, 1: end]. */
typedef lam_vec3 curve_ends[LAM_SIDES][2];

/* The gap at corner (u,v), where side 2 v has its end u, and side 2 u + 1 its end v. */
static lam_sides_gap gap_at(const arrangement *a, curve_ends ends, int u, int v) {
  int i = 2 * v, j = 2 * u + 1;
  lam_sides_gap gap = {0, {a->curve[i], a->curve[j]}, {u != a->reversed[i], v != a->reversed[j]}};
  gap.distance = lam_distance(ends[gap.curve[0]][gap.end[0]], ends[gap.curve[1]][gap.end[1]]);
  return gap;
}

/* The first arrangement whose ends all meet, or the one of the least sum of gaps. worst: its
 * largest gap. Curve 0 always is v = 0; the three orders are those that say which curve lies
 * across from it. */
static arrangement arrange(curve_ends ends, double tolerance, lam_sides_gap *worst) {
  static const int orders[][LAM_SIDES] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}};
  arrangement best = {0};
  double least = INFINITY;

  /* For each order of the curves all 16 ways for them to run. */
  for (int k = 0; k < 3 * 16; k++) {
    arrangement a;
    memcpy(a.curve, orders[k / 16], sizeof a.curve);
    for (int i = 0; i < LAM_SIDES; i++) a.reversed[i] = k >> i & 1;

    double sum = 0;
    lam_sides_gap most = {-1, {0, 0}, {0, 0}};
    for (int corner = 0; corner < 4; corner++) {
      lam_sides_gap gap = gap_at(&a, ends, corner / 2, corner % 2);
      if (gap.distance > most.distance) most = gap;
      sum += gap.distance;
    }

    bool fits = most.distance <= tolerance;
    if (!fits && !(sum < least)) continue;
    best = a;
    least = sum;
    *worst = most;
    if (fits) break;
  }
  return best;
}

/* The largest distance of a control point from the first one, m. */
static double size_of(const lam_sides *given) {
  double size = 0;
  for (int i = 0; i < LAM_SIDES; i++)
    for (int k = 0; k < given->side[i].count; k++)
      size = fmax(size, lam_distance(given->side[0].points[0], given->side[i].points[k]));
  return size;
}

/* The spline over [0,1] with clamped ends, backwards when `reversed`. */
static lam_bspline normalize(lam_arena *arena, lam_bspline f, bool reversed) {
  f = lam_bspline_move_domain(arena, lam_bspline_clamp(arena, f), 0, 1);
  return reversed ? lam_bspline_reverse(arena, f) : f;
}

/* A curve whose weights are all the same, to rounding, needs none. */
static lam_spline_curve without_equal_weights(lam_spline_curve curve) {
  for (int i = 0; curve.weights && i < curve.count; i++)
    if (fabs(curve.weights[i] / curve.weights[0] - 1) > 4 * DBL_EPSILON) return curve;
  curve.weights = NULL;
  return curve;
}

/* Corner (u,v): side 2 v has its end u there, side 2 u + 1 its end v. Both become their
 * middle. */
static void close_corners(lam_vec3 *const points[LAM_SIDES], const lam_sides *sides) {
  for (int u = 0; u < 2; u++)
    for (int v = 0; v < 2; v++) {
      lam_vec3 *p = &points[2 * v][u ? sides->side[2 * v].count - 1 : 0];
      lam_vec3 *q = &points[2 * u + 1][v ? sides->side[2 * u + 1].count - 1 : 0];
      *p = *q = lam_mix(*p, *q, 0.5);
    }
}

/* Where the curves start and end. */
static void find_ends(const lam_sides *given, curve_ends ends) {
  for (int i = 0; i < LAM_SIDES; i++)
    for (int end = 0; end < 2; end++) {
      const lam_spline_curve *c = &given->side[i];
      lam_spline_curve_eval(c, c->knots[end ? c->count : c->degree], 0, &ends[i][end]);
    }
}

/* list[i]: side i as a spline, and the derivatives across it. In either direction d the knots of
 * the two sides and of the derivatives across them that differ by rounding are made equal. */
static void snap_opposite(lam_arena *arena, lam_bspline list[LAM_SIDES][2]) {
  for (int d = 0; d < 2; d++) {
    lam_bspline all[4] = {list[d][0], list[d + 2][0]};
    int count = 2;
    for (int i = d; i < LAM_SIDES; i += 2)
      if (list[i][1].count) all[count++] = list[i][1];

    lam_bspline_snap(arena, count, all);

    list[d][0] = all[0];
    list[d + 2][0] = all[1];
    for (int i = LAM_SIDES - 2 + d; i >= 0; i -= 2)
      if (list[i][1].count) list[i][1] = all[--count];
  }
}

/* Arranges the curves, makes opposite sides alike, then closes the corners. */
bool lam_sides_join(lam_arena *arena, const lam_sides *given, lam_sides *sides,
                    lam_sides_gap *gap) {
  curve_ends ends;
  double size = size_of(given);
  find_ends(given, ends);
  arrangement a = arrange(ends, same_point * size, gap);
  if (!(size > 0) || gap->distance > same_point * size) return false;

  lam_bspline list[LAM_SIDES][2];
  for (int i = 0; i < LAM_SIDES; i++) {
    lam_spline_curve curve = without_equal_weights(given->side[a.curve[i]]);
    list[i][0] = normalize(arena, lam_spline_curve_net(arena, &curve, false), a.reversed[i]);
    list[i][1] = given->across[a.curve[i]];
    if (list[i][1].count) list[i][1] = normalize(arena, list[i][1], a.reversed[i]);
  }
  snap_opposite(arena, list);

  /* Points are copied, as their ends are moved to the corners. */
  lam_sides joined = {0};
  lam_vec3 *points[LAM_SIDES];
  for (int i = 0; i < LAM_SIDES; i++) {
    joined.side[i] = lam_spline_curve_from_net(arena, list[i][0]);
    joined.across[i] = list[i][1];
    points[i] = LAM_NEW(arena, lam_vec3, joined.side[i].count);
    memcpy(points[i], joined.side[i].points, (size_t)joined.side[i].count * sizeof *points[i]);
    joined.side[i].points = points[i];
  }
  close_corners(points, &joined);
  *sides = joined;
  return true;
}
