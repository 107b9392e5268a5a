/* The constraints `angle` and `orthogonal`: the families of a net cross at one angle. Listed in
 * constraints.c; isogonal, asymptotic, S-, CMC and DIG nets (net/kinds) add them. */
#include "con/circle.h"
#include "con/constraint.h"
#include "con/kernel.h"
#include "core/numbers.h"
#include <math.h>

/* Angle of the two tangents of a regular star (thesis 3.1, isogonal net; its eq. 3.1 as printed is
 * another condition), with e_k = (v_k - v) / |v_k - v|:
 *   T1 = unit(e1 - e3),  T2 = unit(e2 - e4),  r = T1 . T2 - cos(angle)   (dimensionless)
 *   dr/dT1 = T2, dr/dT2 = T1;  p[0] = cos(angle) */
static void tangent_angle(int n, const double *x, const double *p, double *r, double *J) {
  (void)n;
  lam_vec3 e[4];
  double length[4];
  lam_unit_edges(x, 4, e, length);
  lam_vec3 a = lam_sub(e[0], e[2]), b = lam_sub(e[1], e[3]);
  double la = lam_length(a), lb = lam_length(b);
  lam_vec3 T1 = lam_scale(a, 1 / la), T2 = lam_scale(b, 1 / lb);
  r[0] = lam_dot(T1, T2) - p[0];
  if (!J) return;

  lam_vec3 da = lam_unit_pullback(T1, la, T2), db = lam_unit_pullback(T2, lb, T1);
  lam_vec3 de[4] = {da, db, lam_scale(da, -1), lam_scale(db, -1)};
  lam_edges_row(J, 4, e, length, de);
}

/* The same with the tangents of the circles through three consecutive vertices (thesis 3.2.3,
 * def. 10), with E_k = v_k - v:
 *   t1 = unit(E1 |E3|^2 - E3 |E1|^2),  t2 likewise from E2, E4,  r = t1 . t2 - cos(angle)
 * The derivatives by t1 and t2 go through circle.h to the E_k. */
static void circle_angle(int n, const double *x, const double *p, double *r, double *J) {
  lam_vec3 v = lam_local(x, 0), E[4];
  for (int k = 0; k < 4; k++) E[k] = lam_sub(lam_local(x, k + 1), v);
  lam_vec3 a = lam_circle_tangent(E[0], E[2]), b = lam_circle_tangent(E[1], E[3]);
  double la = lam_length(a), lb = lam_length(b);
  lam_vec3 t1 = lam_scale(a, 1 / la), t2 = lam_scale(b, 1 / lb);
  r[0] = lam_dot(t1, t2) - p[0];
  if (!J) return;

  lam_vec3 dE[4] = {{0, 0, 0}};
  lam_circle_pullback(E[0], E[2], lam_unit_pullback(t1, la, t2), &dE[0], &dE[2]);
  lam_circle_pullback(E[1], E[3], lam_unit_pullback(t2, lb, t1), &dE[1], &dE[3]);
  for (int c = 0; c < n; c++) J[c] = 0;
  lam_star_row(J, 4, dE);
}

/* The block of both constraints. */
static void add_angle(lam_scope *scope, const char *name, double cosine, bool border, int tangents,
                      double weight) {
  lam_block block = {.name = name, .rows = 1, .weight = weight, .arity = 5, .param_count = 1};
  block.kernel = tangents == LAM_TANGENTS_CIRCLE ? circle_angle : tangent_angle;
  block.count = lam_scope_stars(scope, border, &block.nodes);
  block.params = LAM_NEW(scope->problem->arena, double, block.count);
  for (int i = 0; i < block.count; i++) block.params[i] = cosine;
  lam_problem_add(scope->problem, block);
}

static void add_given(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_angle_params *given = params;
  add_angle(scope, "angle", cos(given->angle), given->border, given->tangents, weight);
}

/* The cosine is 0 exactly, which cos(90 degrees) is not. Without params: inner stars, bisectors. */
static void add_orthogonal(lam_scope *scope, const void *params, double weight,
                           lam_location location) {
  (void)location;
  static const lam_star_params plain = {false, LAM_TANGENTS_BISECTOR};
  const lam_star_params *given = params ? params : &plain;
  add_angle(scope, "orthogonal", 0, given->border, given->tangents, weight);
}

static const char *const tangent_choices[] = {"bisector", "circle", NULL};

/* The keys that both constraints have; `of` is the struct of their parameters. */
#define BORDER(of)                                                                                 \
  LAM_FLAG_KEY(of, "border", border, "no",                                                         \
               "Reentrant corners of the border, which have four edges, take part.")
#define TANGENTS(of)                                                                               \
  LAM_CHOICE_KEY(of, "tangents", tangents, "bisector", tangent_choices,                            \
                 "Tangent of a polyline at a vertex. bisector: halfway between its two edges; "    \
                 "circle: of the circle through the vertex and its two neighbors, which unequal "  \
                 "edges do not turn.")

static const lam_key angle_keys[] = {
    LAM_ANGLE_KEY(lam_angle_params, "angle", angle, "60 deg", 5 * LAM_DEGREE, 175 * LAM_DEGREE,
                  "Angle between the two families at every regular vertex."),
    BORDER(lam_angle_params),
    TANGENTS(lam_angle_params),
    {0}};

static const lam_key orthogonal_keys[] = {BORDER(lam_star_params), TANGENTS(lam_star_params), {0}};

const lam_constraint_kind lam_con_angle = {
    {"angle", "Constant angle",
     "The two families of polylines cross at the same angle everywhere, so that all nodes are "
     "alike. On an asymptotic net this fixes the ratio of the principal curvatures: "
     "tan^2(angle / 2) = -k1 / k2.",
     "T1.T2 = cos(angle), T1 = unit(e1 - e3), T2 = unit(e2 - e4)",
     "thesis 3.1, def. 5 and 3.2.3, def. 10", angle_keys, sizeof(lam_angle_params)},
    add_given};

const lam_constraint_kind lam_con_orthogonal = {
    {"orthogonal", "Right angles",
     "The two families of polylines cross at 90 degrees everywhere. On an asymptotic net the "
     "surface is then a minimal surface, on a net of equal spherical stars a surface of constant "
     "mean curvature.",
     "T1.T2 = 0, T1 = unit(e1 - e3), T2 = unit(e2 - e4)",
     "thesis 3.1, corrected, and 3.2.3, def. 10", orthogonal_keys, sizeof(lam_star_params)},
    add_orthogonal};
