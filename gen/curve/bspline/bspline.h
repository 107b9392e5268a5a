/* Polynomial splines with values of any dimension, f(t) = sum N_i(t) c_i, and exact changes of
 * their representation.
 *
 * A curve has values of dimension 3, or of dimension 4 when it is rational (w x, w y, w z, w); the
 * rows of a surface's control net are values too. So what stands here serves curves (curve/curve.h)
 * and both directions of surfaces (surf/spline_edit.h).
 *
 * Everywhere: knots are sound (lam_knots_problem returns NULL), `dimension` >= 1, results are owned
 * by the arena and never share arrays that the caller may change later, unless said otherwise.
 * Parameters lie in the domain [knots[degree], knots[count]]. */
#ifndef LAM_CURVE_BSPLINE_BSPLINE_H
#define LAM_CURVE_BSPLINE_BSPLINE_H

#include "core/arena.h"
#include <stdbool.h>

typedef struct lam_bspline {
  int degree, count, dimension;
  const double *knots;  /* count + degree + 1 */
  const double *values; /* count x dimension: the coefficients */
} lam_bspline;

/* f and its derivatives: result has (order + 1) * dimension entries, order <= LAM_BASIS_MAX_DEGREE.
 * Allocates nothing.
 */
void lam_bspline_eval(const lam_bspline *f, double t, int order, double *result);
/* How often t is a knot of f. */
int lam_bspline_multiplicity(const lam_bspline *f, double t);
/* Largest distance between coefficients of two splines with the same knots and degree: a bound on
 * max |f - g|. */
double lam_bspline_gap(const lam_bspline *f, const lam_bspline *g);

/* ---- knots (bspline_knots.c) ---- */
/* Inserts the knot t until it stands `multiplicity` <= degree + 1 times (Boehm's algorithm). f
 * itself when it does. */
lam_bspline lam_bspline_insert(lam_arena *arena, lam_bspline f, double t, int multiplicity);
/* The same for `count` different knots, with one allocation. */
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
/* Removes the inner knot t once when that moves f by at most `tolerance`. deviation: a bound on the
 * change, also when the knot stays; may be NULL. False: the knot stays (or t is no inner knot) and
 * *result is f. */
bool lam_bspline_remove(lam_arena *arena, lam_bspline f, double t, double tolerance,
                        lam_bspline *result, double *deviation);

/* ---- Bezier pieces (bspline_pieces.c) ---- */
typedef struct lam_pieces {
  int degree, count, dimension;
  const double *breaks; /* count + 1, ascending */
  const double
      *values; /* count x (degree + 1) x dimension; neighbors repeat the point that they share */
  const int
      *multiplicity; /* count + 1: of the knots that f had at the breaks; the ends: degree + 1 */
} lam_pieces;
/* The Bezier points of all pieces of f. extra: further breaks inside the domain, ascending (NULL
 * when extra_count is 0); they get multiplicity 0 where f has no knot. */
lam_pieces lam_bspline_pieces(lam_arena *arena, lam_bspline f, int extra_count,
                              const double *extra);
/* The clamped spline with these pieces, whose inner knots have the multiplicities of the pieces, 0
 * to degree. Precondition: the pieces join that smoothly. Each coefficient is the blossom of the
 * piece at its knot average. */
lam_bspline lam_bspline_from_pieces(lam_arena *arena, const lam_pieces *pieces);
/* The value of the symmetric multi-affine form (blossom) of Bezier piece k at `degree` arguments;
 * result: dimension. */
void lam_pieces_blossom(const lam_pieces *pieces, int k, const double *arguments, double *result,
                        double *work);

/* ---- degree (bspline_degree.c) ---- */
/* The same spline with degree `target`, degree <= target <= LAM_BASIS_MAX_DEGREE, clamped; every
 * inner knot is repeated as often as keeps its smoothness. */
lam_bspline lam_bspline_elevate(lam_arena *arena, lam_bspline f, int target);
/* The spline g of one degree less that minimizes the integral of |f - g|^2, with the value and the
 * derivatives below order `ends` of f at both ends. Inner knots lose one repetition, but not the
 * last. Exact when f is an elevated spline. deviation: a bound on max |f - g|; may be NULL.
 * Preconditions: degree >= 2, 0 <= ends <= degree / 2. */
lam_bspline lam_bspline_reduce(lam_arena *arena, lam_bspline f, int ends, double *deviation);
/* Inner knots that are nearer than 1e-12 of the domain to one of a spline earlier in the list
 * become that one, so that they count as one in products and sums. Precondition: the same domain.
 */
void lam_bspline_snap(lam_arena *arena, int count, lam_bspline *list);
/* Brings all splines to the highest of their degrees and to common knots. Inner knots of different
 * splines that are nearer than 1e-12 of the domain count as one, that of the first. Precondition:
 * the same domain. */
void lam_bspline_match(lam_arena *arena, int count, lam_bspline *list);
/* a f + b g, with degree and knots matched. Preconditions: the same domain and dimension. */
lam_bspline lam_bspline_combine(lam_arena *arena, double a, lam_bspline f, double b, lam_bspline g);

/* ---- product (bspline_product.c) ---- */
/* s f for a scalar spline s (dimension 1), of the sum of the degrees (at most LAM_BASIS_MAX_DEGREE)
 * and the smoothness of the rougher factor at every knot. Preconditions: the same domain; knots of
 * the two are equal or well apart. */
lam_bspline lam_bspline_product(lam_arena *arena, lam_bspline s, lam_bspline f);

#endif
