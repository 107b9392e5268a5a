/* The ground of least area: quadrature rules with tabulated basis functions, the surface at a node,
 * and the numbering of the inner points. Called by the files of this folder that integrate over a
 * surface. The area and its first variation are in area_value.c, the second in area_variation.c. */
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_parts.h"
#include <limits.h>
#include <math.h>
#include <string.h>

/* Knot spans of direction d that are not empty. */
static int span_count(const lam_spline_surface *surface, int d) {
  int count = 0;
  for (int i = surface->degree[d]; i < surface->count[d]; i++)
    count += surface->knots[d][i + 1] > surface->knots[d][i];
  return count;
}

/* Gauss's rule with `nodes` nodes per span of direction d, and the basis functions at the nodes. */
static lam_area_rule make_rule(lam_arena *arena, const lam_spline_surface *surface, int d,
                               int nodes) {
  int p = surface->degree[d], count = surface->count[d], spans = span_count(surface, d);
  const double *knots = surface->knots[d];
  int *first = LAM_NEW(arena, int, spans);
  double *weights = LAM_NEW(arena, double, spans *nodes),
         *parameters = LAM_NEW(arena, double, spans *nodes),
         *values = LAM_NEW(arena, double, spans *nodes * 2 * (p + 1)),
         *at = LAM_NEW(arena, double, nodes), *w = LAM_NEW(arena, double, nodes);
  lam_gauss_rule(nodes, at, w);

  for (int i = p, s = 0; i < count; i++) {
    double width = knots[i + 1] - knots[i];
    if (!(width > 0)) continue;
    first[s] = i - p;
    for (int k = 0; k < nodes; k++) {
      weights[s * nodes + k] = width * w[k];
      parameters[s * nodes + k] = knots[i] + width * at[k];
      lam_basis_eval(p, knots, i, knots[i] + width * at[k], 1,
                     values + (s * nodes + k) * 2 * (p + 1));
    }
    s++;
  }
  return (lam_area_rule){p, spans, nodes, first, weights, parameters, values};
}

/* The direction with fewer spans decides. */
int lam_area_node_count(const lam_spline_surface *surface, int along) {
  int degree = surface->degree[0] > surface->degree[1] ? surface->degree[0] : surface->degree[1],
      spans = INT_MAX;
  for (int d = 0; d < 2; d++) {
    int count = span_count(surface, d);
    if (count < spans) spans = count;
  }
  int few = (along + spans - 1) / spans;
  return degree + 3 > few ? degree + 3 : few;
}

/* The second variation has the same rule, until lam_area_form_coarsen. */
lam_area_form *lam_area_form_make(lam_arena *arena, const lam_spline_surface *surface,
                                  double mean_curvature, int nodes) {
  lam_area_form *form = LAM_NEW(arena, lam_area_form, 1);
  form->surface = *surface;
  form->mean_curvature = mean_curvature;
  for (int d = 0; d < 2; d++) {
    form->rule[d] = form->second[d] = make_rule(arena, surface, d, nodes);
    form->inner[d] = surface->count[d] - 2;
  }

  form->local = (surface->degree[0] + 1) * (surface->degree[1] + 1);
  form->window = (surface->degree[0] + 1) * (2 * surface->degree[1] + 1);
  int total = form->inner[0] * form->inner[1];
  form->blocks = LAM_NEW(arena, double, (size_t)total * form->window * LAM_AREA_TERMS);
  form->element = LAM_NEW(arena, double, form->local *(form->local + 1) / 2 * LAM_AREA_TERMS);
  form->gradient = LAM_NEW(arena, lam_vec3, total);
  return form;
}

/* A direction keeps its rule when it has no more nodes than that. */
void lam_area_form_coarsen(lam_arena *arena, lam_area_form *form) {
  enum { along = 16 };
  for (int d = 0; d < 2; d++) {
    int few = form->rule[d].degree + 1,
        nodes = (along + form->rule[d].spans - 1) / form->rule[d].spans;
    if (nodes < few) nodes = few;
    if (nodes < form->rule[d].nodes) form->second[d] = make_rule(arena, &form->surface, d, nodes);
  }
}

/* The rational functions of a span and their derivatives from the basis functions f in u and g in
 * v, each values and then derivatives: R = w f g / W, R_u = (w f' g - R W_u) / W. Without weights W
 * is 1 and its derivatives are 0. corner: the first control point of the span. */
static void eval_functions(const lam_area_form *form, int corner, const double *f, const double *g,
                           lam_area_node *node) {
  int p = form->rule[0].degree + 1, q = form->rule[1].degree + 1;
  int columns = form->surface.count[1];
  const double *weights = form->surface.weights;
  double w = 0, wu = 0, wv = 0;
  for (int i = 0, a = 0; i < p; i++)
    for (int j = 0; j < q; j++, a++) {
      double weight = weights ? weights[corner + i * columns + j] : 1;
      w += node->r[a] = weight * f[i] * g[j];
      wu += node->ru[a] = weight * f[p + i] * g[j];
      wv += node->rv[a] = weight * f[i] * g[q + j];
    }
  if (!weights) return;

  double scale = 1 / w;
  for (int a = 0; a < p * q; a++) {
    node->r[a] *= scale;
    node->ru[a] = scale * (node->ru[a] - node->r[a] * wu);
    node->rv[a] = scale * (node->rv[a] - node->r[a] * wv);
  }
}

/* x = sum R_a P_a, and its derivatives likewise. */
void lam_area_node_eval(const lam_area_form *form, const lam_area_rule rule[2],
                        const lam_vec3 *points, int s, int t, int k, int l, lam_area_node *node) {
  const lam_area_rule *ru = &rule[0], *rv = &rule[1];
  int p = ru->degree + 1, q = rv->degree + 1, at[2] = {s * ru->nodes + k, t * rv->nodes + l};
  int columns = form->surface.count[1], corner = ru->first[s] * columns + rv->first[t];
  node->weight = ru->weights[at[0]] * rv->weights[at[1]];
  eval_functions(form, corner, ru->values + at[0] * 2 * p, rv->values + at[1] * 2 * q, node);

  lam_vec3 x = {0}, u = {0}, v = {0};
  for (int i = 0, a = 0; i < p; i++)
    for (int j = 0; j < q; j++, a++) {
      lam_vec3 point = points[corner + i * columns + j];
      x = lam_along(x, node->r[a], point);
      u = lam_along(u, node->ru[a], point);
      v = lam_along(v, node->rv[a], point);
    }
  node->x = x;
  node->u = u;
  node->v = v;
}

/* Local functions are numbered with v running fastest. */
int lam_area_inner(const lam_area_form *form, int s, int t, int a) {
  int q = form->rule[1].degree + 1, i = form->rule[0].first[s] + a / q - 1,
      j = form->rule[1].first[t] + a % q - 1;
  return i >= 0 && i < form->inner[0] && j >= 0 && j < form->inner[1] ? i * form->inner[1] + j : -1;
}

/* Points of the boundary are copied. */
void lam_area_move(const lam_area_form *form, const lam_vec3 *from, double t, const lam_vec3 *step,
                   lam_vec3 *to) {
  int total = form->inner[0] * form->inner[1],
      all = form->surface.count[0] * form->surface.count[1];
  if (to != from) memcpy(to, from, (size_t)all * sizeof *to);
  for (int k = 0; k < total; k++)
    to[lam_area_index(form, k)] = lam_along(from[lam_area_index(form, k)], t, step[k]);
}
