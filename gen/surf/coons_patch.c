/* Both blends have one form. With functions f_k: the linear 1 - t, t, or Hermite's F0, F1, G0, G1; curves A_k along u
 * (sides, then derivatives across them), B_k along v; and T_kl what A_l and B_k share at the corners,
 *   x(u,v) = sum_k f_k(v) A_k(u) + sum_k f_k(u) B_k(v) - sum_kl f_k(u) f_l(v) T_kl.
 * When f_k and A_k are splines over common knots in u, and f_k and B_k in v, every term is a product of two splines,
 * and the control points of x follow from theirs by the same formula. */
#include "surf/coons_patch.h"
#include "curve/curve.h"
#include <string.h>

enum { MOST = 4 };

/* The splines of one direction over [0,1]: curves[k] and, as the last one, the functions f_k with dimension `terms`. */
typedef struct lam_blend {
  int terms; /* 2 or 4 */
  lam_bspline curves[MOST + 1];
} lam_blend;

static lam_vec3 at_end(const lam_bspline *f, int end, int order) {
  double x[6];
  lam_bspline_eval(f, end, order, x);
  return lam_v3(x[3 * order], x[3 * order + 1], x[3 * order + 2]);
}

/* The line from a to b as a spline. */
static lam_bspline line(lam_arena *arena, lam_vec3 a, lam_vec3 b) {
  static const double knots[] = {0, 0, 1, 1};
  double *values = LAM_NEW(arena, double, 6);
  memcpy(values, (double[]){a.x, a.y, a.z, b.x, b.y, b.z}, 6 * sizeof *values);
  return (lam_bspline){1, 2, 3, knots, values};
}

static lam_bspline functions(int terms) {
  static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, linear[] = {1, 0, 0, 1};
  static const double cubic[] = {1, 0, 0, 0, 1, 0, 1.0 / 3, 0, 0, 1, 0, -1.0 / 3, 0, 1, 0, 0};
  return terms == 2 ? (lam_bspline){1, 2, 2, knots + 2, linear} : (lam_bspline){3, 4, 4, knots, cubic};
}

/* Over [0,1], not matched yet: blends[0] along u with sides 0 and 2, blends[1] along v with sides 1 and 3. */
static void collect(lam_arena *arena, const lam_coons *coons, int terms, lam_blend blends[2]) {
  for (int d = 0; d < 2; d++) {
    blends[d].terms = terms;
    for (int k = 0; k < 2; k++) {
      lam_bspline side = lam_spline_curve_net(arena, &coons->side[2 * k + d], false);
      blends[d].curves[k] = lam_bspline_move_domain(arena, lam_bspline_clamp(arena, side), 0, 1);
    }
    blends[d].curves[terms] = functions(terms);
  }
  for (int d = 0; d < 2 && terms == MOST; d++)
    for (int k = 0; k < 2; k++) {
      lam_bspline given = coons->across[2 * k + d];
      const lam_bspline *ends = blends[1 - d].curves;
      blends[d].curves[2 + k] = given.count ? lam_bspline_move_domain(arena, lam_bspline_clamp(arena, given), 0, 1)
                                            : line(arena, at_end(&ends[0], k, 1), at_end(&ends[1], k, 1));
    }
}

/* What curve l along u and curve k along v say about their corner. Curve l belongs to v = l % 2 and gives the position
 * (l < 2) or the derivative by v; at u = k % 2 it is taken itself (k < 2) or its derivative. */
static void corner(const lam_blend blends[2], int k, int l, lam_vec3 said[2]) {
  said[0] = at_end(&blends[0].curves[l], k % 2, k / 2);
  said[1] = at_end(&blends[1].curves[k], l % 2, l / 2);
}

lam_coons_gaps lam_coons_check(lam_arena *arena, const lam_coons *coons) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_blend blends[2];
  lam_coons_gaps gaps = {0, 0, 0};
  collect(arena, coons, MOST, blends);
  for (int k = 0; k < MOST; k++)
    for (int l = 0; l < MOST; l++) {
      lam_vec3 said[2];
      corner(blends, k, l, said);
      double *gap = k < 2 && l < 2 ? &gaps.corner : k < 2 || l < 2 ? &gaps.slope : &gaps.twist;
      *gap = fmax(*gap, lam_distance(said[0], said[1]));
    }
  lam_arena_release(arena, mark);
  return gaps;
}

static lam_vec3 value(const lam_bspline *f, int i) {
  return lam_v3(f->values[3 * i], f->values[3 * i + 1], f->values[3 * i + 2]);
}

static lam_spline_surface blend(lam_arena *arena, const lam_coons *coons, int terms) {
  lam_blend blends[2];
  lam_vec3 shared[MOST][MOST], said[2];
  collect(arena, coons, terms, blends);
  for (int k = 0; k < terms; k++)
    for (int l = 0; l < terms; l++) {
      corner(blends, k, l, said);
      shared[k][l] = lam_mix(said[0], said[1], 0.5);
    }
  for (int d = 0; d < 2; d++) lam_bspline_match(arena, terms + 1, blends[d].curves);
  const lam_bspline *a = blends[0].curves, *b = blends[1].curves, *f = &a[terms], *g = &b[terms];
  int m = a->count, n = b->count;
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, (size_t)m * n);
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      lam_vec3 x = {0, 0, 0};
      for (int k = 0; k < terms; k++) {
        double fu = f->values[i * terms + k], fv = g->values[j * terms + k];
        x = lam_along(lam_along(x, fv, value(&a[k], i)), fu, value(&b[k], j));
        for (int l = 0; l < terms; l++) x = lam_along(x, -fu * g->values[j * terms + l], shared[k][l]);
      }
      points[i * n + j] = x;
    }
  return (lam_spline_surface){NULL, {a->degree, b->degree}, {m, n}, {a->knots, b->knots}, points, NULL};
}

lam_spline_surface lam_coons_bilinear(lam_arena *arena, const lam_coons *coons) { return blend(arena, coons, 2); }

lam_spline_surface lam_coons_hermite(lam_arena *arena, const lam_coons *coons) { return blend(arena, coons, MOST); }
