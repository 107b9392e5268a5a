/* Polynomial splines with values of any dimension, f(t) = sum N_i(t) c_i, and exact changes of
 * their representation.
 *
 * A curve has values of dimension 3, or of dimension 4 when it is rational (w x, w y, w z, w); the
 * rows of a surface's control net are values too. So what stands here serves curves (curve/curve.h)
 * and both directions of surfaces (surf/spline/spline_edit.h).
 *
 * Everywhere: knots are sound (lam_knots_problem returns NULL), `dimension` >= 1, results are owned
 * by the arena and never share arrays that the caller may change later, unless said otherwise.
 * Parameters lie in the domain [knots[degree], knots[count]]. */
#ifndef LAM_CURVE_BSPLINE_BSPLINE_H
#define LAM_CURVE_BSPLINE_BSPLINE_H

#include "core/arena.h"
#include <stdbool.h>

/* A spline. The arrays belong to whoever made them; lam_bspline is passed by value. */
typedef struct lam_bspline {
  int degree, count, dimension;
  const double *knots;  /* count + degree + 1 */
  const double *values; /* count x dimension: the coefficients */
} lam_bspline;

/* f and its derivatives: result has (order + 1) * dimension entries, the k-th derivative at
 * result[k * dimension]. Precondition: order <= LAM_BASIS_MAX_DEGREE. Allocates nothing. */
void lam_bspline_eval(const lam_bspline *f, double t, int order, double *result);
/* How often t is a knot of f (exact comparison). */
int lam_bspline_multiplicity(const lam_bspline *f, double t);
/* Largest distance between coefficients of two splines with the same knots, degree and dimension:
 * a bound on max |f - g|, because the functions are positive and sum to 1. */
double lam_bspline_gap(const lam_bspline *f, const lam_bspline *g);

/* ---- knots (bspline_knots.c) ---- */
/* Inserts the knot t until it stands `multiplicity` <= degree + 1 times (Boehm's algorithm).
 * Where it does already, f itself, with its arrays. Precondition: t lies in the domain. */
lam_bspline lam_bspline_insert(lam_arena *arena, lam_bspline f, double t, int multiplicity);
/* The same for `count` different knots t[0 .. count - 1], with one allocation. */
lam_bspline lam_bspline_insert_all(lam_arena *arena, lam_bspline f, int count, const double *t,
                                   int multiplicity);
/* The part over [low, high], low < high, with clamped ends. */
lam_bspline lam_bspline_part(lam_arena *arena, lam_bspline f, double low, double high);
/* The same spline with clamped ends. */
lam_bspline lam_bspline_clamp(lam_arena *arena, lam_bspline f);
/* g(t) = f(low + high - t) over the same domain [low, high]. */
lam_bspline lam_bspline_reverse(lam_arena *arena, lam_bspline f);
/* The same coefficients over [low, high] instead of the domain: knots are mapped affinely. */
lam_bspline lam_bspline_move_domain(lam_arena *arena, lam_bspline f, double low, double high);
/* Removes the inner knot t once when that moves f by at most `tolerance` (in the units of the
 * values).
 *
 * result     the spline without the knot; f when the knot stays
 * deviation  a bound on the change, also when the knot stays; infinite when t is no inner knot;
 *            may be NULL
 *
 * Returns false when the knot stays. */
bool lam_bspline_remove(lam_arena *arena, lam_bspline f, double t, double tolerance,
                        lam_bspline *result, double *deviation);

/* ---- Bezier pieces (bspline_pieces.c) ---- */
/* The Bezier points of a spline, piece by piece. */
typedef struct lam_pieces {
  int degree, count, dimension;
  const double *breaks; /* count + 1, ascending */
  /* count x (degree + 1) x dimension; neighbors repeat the point that they share */
  const double *values;
  const int *multiplicity; /* count + 1: of the knots of f at the breaks; degree + 1 at the ends */
} lam_pieces;
/* The Bezier points of all pieces of f. extra: further breaks inside the domain, ascending (NULL
 * when extra_count is 0); they get multiplicity 0 where f has no knot. */
lam_pieces lam_bspline_pieces(lam_arena *arena, lam_bspline f, int extra_count,
                              const double *extra);
/* The clamped spline with these pieces, whose inner knots have the multiplicities of the pieces,
 * 0 to degree. Precondition: the pieces join that smoothly. */
lam_bspline lam_bspline_from_pieces(lam_arena *arena, const lam_pieces *pieces);

/* ---- degree (bspline_degree.c) ---- */
/* The same spline with degree `target`, degree <= target <= LAM_BASIS_MAX_DEGREE, clamped; every
 * inner knot is repeated as often as keeps its smoothness. */
lam_bspline lam_bspline_elevate(lam_arena *arena, lam_bspline f, int target);
/* The spline g of one degree less that minimizes the integral of |f - g|^2, with the value and
 * the derivatives below order `ends` of f at both ends. Inner knots lose one repetition, but not
 * the last. Exact when f is an elevated spline. deviation: a bound on max |f - g|; may be NULL.
 * Preconditions: degree >= 2, 0 <= ends <= degree / 2. */
lam_bspline lam_bspline_reduce(lam_arena *arena, lam_bspline f, int ends, double *deviation);
/* Makes inner knots equal that differ only by rounding, so that they count as one in
 * lam_bspline_match and lam_bspline_product: an inner knot nearer than 1e-12 of the domain to one
 * of a spline earlier in the list becomes that one. list: count splines, changed in place.
 * Precondition: the same domain. */
void lam_bspline_snap(lam_arena *arena, int count, lam_bspline *list);
/* Brings all splines of the list, in place, to the highest of their degrees and to common knots
 * (lam_bspline_snap included). Afterwards all share one knot array. Precondition: the same
 * domain. */
void lam_bspline_match(lam_arena *arena, int count, lam_bspline *list);

/* ---- product (bspline_product.c) ---- */
/* s f for a scalar spline s (dimension 1), of the sum of the degrees (at most LAM_BASIS_MAX_DEGREE)
 * and the smoothness of the rougher factor at every knot. Preconditions: the same domain; knots of
 * the two are equal or well apart. */
lam_bspline lam_bspline_product(lam_arena *arena, lam_bspline s, lam_bspline f);

#endif
