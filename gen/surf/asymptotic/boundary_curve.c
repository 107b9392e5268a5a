/* Boundary curves of an asymptotic quadrilateral: their points, evaluation, and measures. Called
 * by the other files of this folder; fab/parts/skin_measure.c evaluates them, too. */
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/asymptotic/quad_parts.h"

/* For a rational curve A = W r, the derivatives follow from A^(k) = sum_j binomial(k,j) W^(j)
 * r^(k-j). */
void lam_quad_curve_eval(const lam_quad_curve *curve, double t, lam_vec3 jet[4]) {
  double values[4 * LAM_BASIS_MAX_VALUES], w[4] = {0};
  int span = lam_basis_span(curve->degree, curve->count, curve->knots, t),
      width = curve->degree + 1;
  lam_basis_eval(curve->degree, curve->knots, span, t, 3, values);

  for (int k = 0; k < 4; k++) {
    jet[k] = lam_v3(0, 0, 0);
    for (int j = 0; j < width; j++) {
      int at = span - curve->degree + j;
      double weight = values[k * width + j] * (curve->weights ? curve->weights[at] : 1);
      jet[k] = lam_along(jet[k], weight, curve->points[at]);
      w[k] += weight;
    }
  }
  if (!curve->weights) return;

  jet[0] = lam_scale(jet[0], 1 / w[0]);
  jet[1] = lam_scale(lam_along(jet[1], -w[1], jet[0]), 1 / w[0]);
  jet[2] = lam_scale(lam_along(lam_along(jet[2], -2 * w[1], jet[1]), -w[2], jet[0]), 1 / w[0]);
  jet[3] = lam_scale(
      lam_along(lam_along(lam_along(jet[3], -3 * w[1], jet[2]), -3 * w[2], jet[1]), -w[3], jet[0]),
      1 / w[0]);
}

/* The second point is corner + u1 / n r', with u1 the first knot distance and n the degree. A
 * straight curve gets the chord as its tangent. */
void lam_quad_boundary_start(lam_arena *arena, const lam_quad_corners *corners,
                             const lam_quad_recipe *recipe, lam_quad_boundary *boundary) {
  for (int i = 0; i < 4; i++) {
    lam_quad_curve *c = &boundary->curve[i];
    lam_vec3 chord;
    c->degree = recipe->degree;
    c->knots =
        lam_knots_repeat(arena, c->degree, recipe->inner, corners->knots[i % 2], 1, &c->count);
    c->points = LAM_NEW(arena, lam_vec3, c->count);
    c->straight = corners->side[i][0] == 0;
    for (int e = 0; e < 2; e++)
      c->points[e ? c->count - 1 : 0] = corners->corner[lam_quad_corner_of[i][e]];
    chord = lam_sub(c->points[c->count - 1], c->points[0]);

    for (int e = 0; e < 2; e++) {
      double width = e ? 1 - c->knots[c->count - 1] : c->knots[c->degree + 1];
      lam_vec3 tangent = c->straight ? chord : corners->tangent[i][e];
      c->points[e ? c->count - 2 : 1] =
          lam_along(c->points[e ? c->count - 1 : 0], (e ? -width : width) / c->degree, tangent);
    }

    for (int j = 2; j < c->count - 2; j++)
      c->points[j] = lam_mix(c->points[1], c->points[c->count - 2], (j - 1.0) / (c->count - 3));
  }
}

/* Slide and cross of the third point, its coordinates in the edges at the corner, and curvature
 * and torsion at end e of curve i. */
static void measure_end(lam_quad_boundary *b, int i, int e) {
  const lam_quad_curve *c = &b->curve[i];
  lam_quad_end o = lam_quad_other[i][e];
  lam_vec3 edge = lam_quad_edge(c, e), cross = lam_quad_edge(&b->curve[o.curve], o.end),
           m = lam_cross(edge, cross);
  lam_vec3 third = lam_sub(c->points[e ? c->count - 3 : 2], c->points[e ? c->count - 1 : 0]),
           jet[4];

  b->slide[i][e] = lam_dot(lam_cross(third, cross), m) / lam_dot(m, m);
  b->cross[i][e] = lam_dot(lam_cross(edge, third), m) / lam_dot(m, m);

  lam_quad_curve_eval(c, e, jet);
  lam_vec3 bend = lam_cross(jet[1], jet[2]);
  b->curvature[i][e] = c->straight ? 0 : lam_length(bend) / pow(lam_length(jet[1]), 3);
  b->torsion[i][e] = c->straight ? 0 : lam_dot(bend, jet[3]) / lam_dot(bend, bend);
}

/* |r''|^2 of a polynomial of degree n has degree 2n - 4: n nodes are more than enough. */
lam_quad_rule lam_quad_rule_make(const lam_quad_curve *c) {
  lam_quad_rule rule = {.count = c->weights ? LAM_QUAD_RULE_MAX : c->degree};
  lam_gauss_rule(rule.count, rule.nodes, rule.weights);
  return rule;
}

/* Span by span. */
double lam_quad_curve_bending(const lam_quad_curve *c, const lam_quad_rule *rule) {
  double sum = 0;
  for (int k = c->degree; k < c->count; k++) {
    double width = c->knots[k + 1] - c->knots[k];
    for (int g = 0; width > 0 && g < rule->count; g++) {
      lam_vec3 jet[4];
      lam_quad_curve_eval(c, c->knots[k] + width * rule->nodes[g], jet);
      sum += width * rule->weights[g] * lam_dot(jet[2], jet[2]);
    }
  }
  return sum;
}

/* All measures of a boundary whose points are final. */
void lam_quad_boundary_measure(lam_quad_boundary *boundary) {
  boundary->energy = 0;
  for (int i = 0; i < 4; i++) {
    for (int e = 0; e < 2; e++) measure_end(boundary, i, e);
    lam_quad_rule rule = lam_quad_rule_make(&boundary->curve[i]);
    boundary->energy += lam_quad_curve_bending(&boundary->curve[i], &rule);
  }
}
