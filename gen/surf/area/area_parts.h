/* Shared by the files of least-area surfaces: the area and its variations as functions of the
 * control points. */
#ifndef LAM_SURF_AREA_AREA_PARTS_H
#define LAM_SURF_AREA_AREA_PARTS_H

#include "solve/factor.h"
#include "surf/area/least_area.h"

enum {
  LAM_AREA_WIDTH = LAM_LEAST_AREA_MAX_DEGREE + 1,
  LAM_AREA_LOCAL = LAM_AREA_WIDTH * LAM_AREA_WIDTH, /* functions that share a span, at most */
  LAM_AREA_TERMS =
      10 /* numbers of a pair of points: s, the symmetric part n n^T s (6), the skew part (3) */
};

/* Gauss places of one direction, with the functions that do not vanish there. */
typedef struct lam_area_rule {
  int degree, spans, places; /* places per span */
  const int *first;          /* of the functions on a span */
  const double *weights;     /* spans x places, with the width of the span */
  const double *at;          /* parameters, spans x places */
  const double *values;      /* spans x places x (value, derivative) x (degree + 1) */
} lam_area_rule;
lam_area_rule lam_area_rule_make(lam_arena *arena, const lam_spline_surface *surface, int d,
                                 int places);

/* A quadrature place: functions and the surface. */
typedef struct lam_area_place {
  double weight;
  double r[LAM_AREA_LOCAL], ru[LAM_AREA_LOCAL],
      rv[LAM_AREA_LOCAL]; /* rational functions, v fastest */
  lam_vec3 x, u, v;
} lam_area_place;

/* The area of a surface with fixed weights and knots, and room for its variations. */
typedef struct lam_area_form {
  lam_spline_surface surface;       /* its points are not used */
  lam_area_rule rule[2], second[2]; /* for the area and its slope; for the second variation */
  double mean_curvature;
  int local;          /* functions per span */
  int inner[2];       /* free rows and columns */
  int window;         /* neighbors of a point, itself included, that come after it or are itself */
  double *blocks;     /* inner points x window x LAM_AREA_TERMS */
  double *element;    /* pairs of a span x LAM_AREA_TERMS */
  lam_vec3 *gradient; /* inner points */
} lam_area_form;
/* places: Gauss places per span and direction. */
lam_area_form *lam_area_form_make(lam_arena *arena, const lam_spline_surface *surface,
                                  double mean_curvature, int places);
/* The second variation by degree + 1 places per span, or as many as make 16 in a direction: it
 * becomes cheaper, steps change a little, and the surface that they lead to does not. One place
 * less doubles the number of steps. */
void lam_area_form_coarsen(lam_arena *arena, lam_area_form *form);
/* Places per span: degree + 3, and more where that gives less than `along` in a direction: a single
 * rational patch can hide area between the places. */
int lam_area_places(const lam_spline_surface *surface, int along);

/* The functions and the surface at place (k, l) of span (s, t). */
void lam_area_visit(const lam_area_form *form, const lam_vec3 *points, int s, int t, int k, int l,
                    lam_area_place *location);
/* Number of the inner point that is local function a of a span, or -1 on the boundary. */
int lam_area_inner(const lam_area_form *form, int s, int t, int a);

/* Where the block of local functions a and b, b after a or itself, stands in the window of a. */
static inline int lam_area_slot(const lam_area_form *form, int a, int b) {
  int q = form->rule[1].degree + 1;
  return (b / q - a / q) * (2 * q - 1) + b % q - a % q + q - 1;
}

/* Area + 2 H volume; +infinity where a point is not finite. */
double lam_area_value(const lam_area_form *form, const lam_vec3 *points);
/* Fills gradient. */
double lam_area_slope(const lam_area_form *form, const lam_vec3 *points);
/* Fills gradient and blocks; blocks alone. */
double lam_area_vary(const lam_area_form *form, const lam_vec3 *points);
void lam_area_blocks(const lam_area_form *form, const lam_vec3 *points);
/* Gradient and blocks (s alone) of the Dirichlet energy. */
void lam_area_dirichlet(const lam_area_form *form, const lam_vec3 *points);

/* The system of the inner points: components 3 (blocks of all terms) or 1 (s alone). */
typedef struct lam_area_system {
  int components, size;
  const int *column_start, *row;
  double *values;
  lam_factor *factor;
} lam_area_system;
lam_area_system lam_area_system_make(lam_arena *arena, const lam_area_form *form, int components);
/* Factorizes second variation + lambda M, M = s (components 3), or s (components 1). False: not
 * positive definite. */
bool lam_area_system_factor(const lam_area_system *system, const lam_area_form *form,
                            double lambda);
/* step = - A^-1 gradient, for the inner points. */
void lam_area_system_step(lam_arena *arena, const lam_area_system *system, const lam_vec3 *gradient,
                          lam_vec3 *step);

/* to = from, with the inner points moved by t step. to and from may be the same net. */
void lam_area_move(const lam_area_form *form, const lam_vec3 *from, double t, const lam_vec3 *step,
                   lam_vec3 *to);
static inline int lam_area_index(const lam_area_form *form, int inner) { /* in the net */
  return (inner / form->inner[1] + 1) * form->surface.count[1] + inner % form->inner[1] + 1;
}

/* The three methods, from points, which they move. */
void lam_area_newton(lam_arena *arena, const lam_area_form *form,
                     const lam_least_area_options *options, lam_vec3 *points,
                     lam_least_area_result *result);
void lam_area_majorize(lam_arena *arena, const lam_area_form *form,
                       const lam_least_area_options *options, lam_vec3 *points,
                       lam_least_area_result *result);
void lam_area_lbfgs(lam_arena *arena, const lam_area_form *form,
                    const lam_least_area_options *options, lam_vec3 *points,
                    lam_least_area_result *result);

#endif
