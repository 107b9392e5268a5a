#include "con/constraint.h"
#include "con/kernel.h"
#include <math.h>

/* Angle of the two tangents of a regular star (thesis 3.1, isogonal net; its eq. 3.1 as printed is another condition).
 *   T1 = unit(e1 - e3),  T2 = unit(e2 - e4),  r = T1 . T2 - cos(angle),  p[0] = cos(angle) */
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

static void add_angle(lam_scope *scope, const char *name, double cosine, bool border, double weight) {
  lam_block block = {.name = name, .kernel = tangent_angle, .rows = 1, .weight = weight, .arity = 5, .param_count = 1};
  block.count = lam_scope_stars(scope, border, &block.nodes);
  block.params = LAM_NEW(scope->problem->arena, double, block.count);
  for (int i = 0; i < block.count; i++) block.params[i] = cosine;
  lam_problem_add(scope->problem, block);
}

static void add_given(lam_scope *scope, const void *params, double weight, lam_place place) {
  (void)place;
  const lam_angle_params *given = params;
  add_angle(scope, "angle", cos(given->angle), given->border, weight);
}

static void add_orthogonal(lam_scope *scope, const void *params, double weight, lam_place place) {
  (void)place;
  const lam_star_params *given = params;
  add_angle(scope, "orthogonal", 0, given && given->border, weight);
}

static const lam_key angle_keys[] = {{.name = "angle",
                                      .type = LAM_KEY_NUMBER,
                                      .unit = LAM_UNIT_ANGLE,
                                      .offset = offsetof(lam_angle_params, angle),
                                      .count = 1,
                                      .initial = "60 deg",
                                      .min = 5 * (3.14159265358979323846 / 180),
                                      .max = 175 * (3.14159265358979323846 / 180),
                                      .doc = "Angle between the two families at every regular vertex."},
                                     {.name = "border",
                                      .type = LAM_KEY_FLAG,
                                      .offset = offsetof(lam_angle_params, border),
                                      .count = 1,
                                      .initial = "no",
                                      .doc = "Reentrant corners of the border, which have four edges, take part."},
                                     {0}};

const lam_constraint_kind lam_con_angle = {{"angle", "Constant angle",
                                            "The two families of polylines cross at the same angle everywhere, so that "
                                            "all nodes are alike. On an asymptotic net this "
                                            "fixes the ratio of the principal curvatures: tan^2(angle / 2) = -k1 / k2.",
                                            "unit(e1 - e3) . unit(e2 - e4) = cos(angle)", "thesis 3.1, definition 4",
                                            angle_keys, sizeof(lam_angle_params)},
                                           add_given};

const lam_constraint_kind lam_con_orthogonal = {{"orthogonal", "Right angles",
                                                 "The two families of polylines cross at 90 degrees everywhere. On an "
                                                 "asymptotic net the surface is then a minimal surface.",
                                                 "unit(e1 - e3) . unit(e2 - e4) = 0", "thesis 3.1, corrected",
                                                 lam_star_keys, sizeof(lam_star_params)},
                                                add_orthogonal};
