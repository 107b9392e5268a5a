/* What the files of least-area surfaces share: the area and its variations as functions of the
 * inner control points. The folder from bottom to top: area_form.c (rules and nodes),
 * area_value.c (area, first variation), area_variation.c (second variation), area_system.c
 * (linear systems), then the methods area_newton.c, majorize.c and lbfgs.c, and area_solve.c,
 * which chooses among them. */
#ifndef LAM_SURF_AREA_AREA_PARTS_H
#define LAM_SURF_AREA_AREA_PARTS_H

#include "solve/factor.h"
#include "surf/area/least_area.h"

enum {
  LAM_AREA_WIDTH = LAM_LEAST_AREA_MAX_DEGREE + 1,
  LAM_AREA_LOCAL = LAM_AREA_WIDTH * LAM_AREA_WIDTH, /* functions that share a span, at most */
  LAM_AREA_TERMS = 10 /* numbers of the 3 x 3 block of a pair of points: s, the symmetric part
                         s n n^T (6: xx, xy, xz, yy, yz, zz), the skew part t n (3) */
};

/* Gauss nodes of one direction, with the basis functions that do not vanish there. */
typedef struct lam_area_rule {
  int degree, spans, nodes; /* nodes per span; spans that are not empty */
  const int *first;         /* spans: the first function on it */
  const double *weights;    /* spans x nodes, with the width of the span */
  const double *at;         /* spans x nodes: the parameters */
  const double *values;     /* spans x nodes x (value, derivative) x (degree + 1) */
} lam_area_rule;

/* A node of the quadrature: the rational functions of its span, and the surface. */
typedef struct lam_area_node {
  double weight;
  double r[LAM_AREA_LOCAL];                      /* (p + 1) (q + 1) functions, v fastest */
  double ru[LAM_AREA_LOCAL], rv[LAM_AREA_LOCAL]; /* their derivatives by u and v */
  lam_vec3 x, u, v;                              /* x, x_u, x_v */
} lam_area_node;

/* The area of a surface with fixed weights and knots, and room for its variations. */
typedef struct lam_area_form {
  lam_spline_surface surface; /* its points are not used */
  lam_area_rule rule[2];      /* for the area and its gradient, in u and v */
  lam_area_rule second[2];    /* for the second variation */
  double mean_curvature;      /* H, 1/m */
  int local;                  /* functions per span */
  int inner[2];               /* rows and columns of inner points */
  int window;                 /* blocks that a point keeps: for itself and its neighbors after it */
  double *blocks;             /* inner points x window x LAM_AREA_TERMS */
  double *element;            /* pairs of a span x LAM_AREA_TERMS */
  lam_vec3 *gradient;         /* inner points */
} lam_area_form;
/* The form of a surface whose area is sought with H = mean_curvature (0: least area), by `nodes`
 * Gauss nodes per span and direction. Owned by the arena. */
lam_area_form *lam_area_form_make(lam_arena *arena, const lam_spline_surface *surface,
                                  double mean_curvature, int nodes);
/* The second variation by degree + 1 nodes per span, or as many as make 16 in a direction: it
 * becomes cheaper, steps change a little, and the surface that they lead to does not. One node less
 * doubles the number of steps. */
void lam_area_form_coarsen(lam_arena *arena, lam_area_form *form);
/* Nodes per span: degree + 3, and more where that gives less than `along` in a direction: a single
 * rational patch can hide area between the nodes. */
int lam_area_node_count(const lam_spline_surface *surface, int along);

/* The functions and the surface with these control points (of the whole net) at node (k, l) of span
 * (s, t). rule: form->rule or form->second. */
void lam_area_node_eval(const lam_area_form *form, const lam_area_rule rule[2],
                        const lam_vec3 *points, int s, int t, int k, int l, lam_area_node *node);
/* Number of the inner point that is local function a of a span, or -1 on the boundary. */
int lam_area_inner(const lam_area_form *form, int s, int t, int a);

/* Where the block of local functions a and b, b after a or itself, stands in the window of a. */
static inline int lam_area_slot(const lam_area_form *form, int a, int b) {
  int q = form->rule[1].degree + 1;
  return (b / q - a / q) * (2 * q - 1) + b % q - a % q + q - 1;
}

/* Area + 2 H volume, m^2, with the control points of the whole net; +infinity where a point is not
 * finite. */
double lam_area_value(const lam_area_form *form, const lam_vec3 *points);
/* The same; sets form->gradient, the first variation. */
double lam_area_slope(const lam_area_form *form, const lam_vec3 *points);
/* The same; sets gradient and blocks, the first and the second variation. */
double lam_area_vary(const lam_area_form *form, const lam_vec3 *points);
/* Sets the blocks alone. */
void lam_area_blocks(const lam_area_form *form, const lam_vec3 *points);
/* Sets gradient and blocks (s alone) of the Dirichlet energy 1/2 integral x_u^2 + x_v^2. */
void lam_area_dirichlet(const lam_area_form *form, const lam_vec3 *points);

/* The system of the inner points: components 3 (blocks of all terms) or 1 (s alone). */
typedef struct lam_area_system {
  int components, size;          /* size: inner points x components */
  const int *column_start, *row; /* lower triangle by columns */
  double *values;
  lam_factor *factor;
} lam_area_system;
/* Analyzes the pattern; no values yet. Owned by the arena. */
lam_area_system lam_area_system_make(lam_arena *arena, const lam_area_form *form, int components);
/* Factorizes second variation + lambda M, M = s (components 3), or s (components 1). False: not
 * positive definite. */
bool lam_area_system_factor(const lam_area_system *system, const lam_area_form *form,
                            double lambda);
/* step = - A^-1 gradient, for the inner points; step and gradient may be the same array.
 * Precondition: the last factorization succeeded. */
void lam_area_system_step(lam_arena *arena, const lam_area_system *system, const lam_vec3 *gradient,
                          lam_vec3 *step);

/* to = from, with the inner points moved by t step. to and from may be the same net. */
void lam_area_move(const lam_area_form *form, const lam_vec3 *from, double t, const lam_vec3 *step,
                   lam_vec3 *to);
/* The number of an inner point in the whole net. */
static inline int lam_area_index(const lam_area_form *form, int inner) {
  return (inner / form->inner[1] + 1) * form->surface.count[1] + inner % form->inner[1] + 1;
}
/* The scalar product of two vectors of points. */
static inline double lam_area_product(int count, const lam_vec3 *a, const lam_vec3 *b) {
  double sum = 0;
  for (int k = 0; k < count; k++) sum += lam_dot(a[k], b[k]);
  return sum;
}
/* What a minimization says that converged. */
static inline const char *lam_area_converged(const lam_least_area_options *options) {
  return options->enough > 0 ? "the area asked for is reached" : "the area falls no more";
}

/* The three methods. points: the whole net, whose inner points are moved. result: area is that of
 * the start on entry; iterations and evaluations are counted, verdict and reason set. The scratch
 * memory is the caller's to give back. */
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
