/* The second variation of the area as 3 x 3 blocks of pairs of control points, and the quadratic
 * Dirichlet energy in the same form. Called by area_newton.c, lbfgs.c, majorize.c and area_solve.c;
 * area_system.c makes a sparse system of the blocks.
 *
 * With E, F, G, a = |x_u x x_v| = sqrt(EG - F^2), n = x_u x x_v / a and a variation with p = dx_u,
 * q = dx_v:
 *
 *   a'  = p.(x_v x n) + q.(n x x_u) = (p.(G x_u - F x_v) + q.(E x_v - F x_u)) / a
 *   a'' = (G (p.n)^2 - 2 F (p.n)(q.n) + E (q.n)^2) / a + 2 n.(p x q)
 *
 * For functions f and g of two control points this is the 3 x 3 block s n n^T + t [n], with
 *
 *   s = (G f_u g_u - F (f_u g_v + f_v g_u) + E f_v g_v) / a
 *   t = f_u g_v - f_v g_u,   [n]_cd = n.(e_c x e_d)
 *
 * and s alone is the block of I/2 (Wu & Wang, step 5), M.
 *
 * Constant mean curvature H: the volume V = 1/3 integral x.(x_u x x_v) is added 2 H times;
 * V' = integral dx.(x_u x x_v), and its second variation adds
 * 1/2 (f g_u - g f_u) [x_v] - 1/2 (f g_v - g f_v) [x_u]. */
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* The functions of a span that belong to inner points. */
typedef struct inner_functions {
  int count, local[LAM_AREA_LOCAL], point[LAM_AREA_LOCAL];
} inner_functions;

/* Lists those of span (s, t). */
static void find_inner(const lam_area_form *form, int s, int t, inner_functions *inner) {
  inner->count = 0;
  for (int a = 0; a < form->local; a++) {
    int point = lam_area_inner(form, s, t, a);
    if (point < 0) continue;
    inner->local[inner->count] = a;
    inner->point[inner->count++] = point;
  }
}

/* Adds s, s n n^T and t n of every pair of functions at a node to form->element; metric is
 * weight / a times (E, F, G). */
static void add_pairs(const lam_area_form *form, const inner_functions *inner,
                      const lam_area_node *node, const double metric[3], lam_vec3 n) {
  double *e = form->element, w = node->weight, u[LAM_AREA_LOCAL], v[LAM_AREA_LOCAL];
  double symmetric[6] = {n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z},
         skew[3] = {n.x, n.y, n.z};
  for (int a = 0; a < inner->count; a++) {
    u[a] = node->ru[inner->local[a]];
    v[a] = node->rv[inner->local[a]];
  }

  for (int a = 0; a < inner->count; a++) {
    double su = metric[2] * u[a] - metric[1] * v[a], sv = metric[0] * v[a] - metric[1] * u[a],
           fu = w * u[a], fv = w * v[a];
    for (int b = a; b < inner->count; b++, e += LAM_AREA_TERMS) {
      double s = su * u[b] + sv * v[b], t = fu * v[b] - fv * u[b];
      e[0] += s;
      for (int c = 0; c < 6; c++) e[1 + c] += s * symmetric[c];
      for (int c = 0; c < 3; c++) e[7 + c] += t * skew[c];
    }
  }
}

/* Adds 2 H times the second variation of the volume; it is skew, as [x_u] and [x_v] are. */
static void add_volume_pairs(const lam_area_form *form, const inner_functions *inner,
                             const lam_area_node *node) {
  double half = form->mean_curvature * node->weight, *e = form->element;
  for (int k = 0; k < inner->count; k++)
    for (int l = k; l < inner->count; l++, e += LAM_AREA_TERMS) {
      int a = inner->local[k], b = inner->local[l];
      double u = half * (node->r[a] * node->ru[b] - node->r[b] * node->ru[a]);
      double v = half * (node->r[a] * node->rv[b] - node->r[b] * node->rv[a]);

      lam_vec3 t = lam_along(lam_scale(node->v, u), -v, node->u);
      e[7] += t.x;
      e[8] += t.y;
      e[9] += t.z;
    }
}

/* Adds the sums of one span to the blocks of its points. */
static void scatter(const lam_area_form *form, const inner_functions *inner) {
  const double *e = form->element;
  for (int a = 0; a < inner->count; a++)
    for (int b = a; b < inner->count; b++, e += LAM_AREA_TERMS) {
      int slot = lam_area_slot(form, inner->local[a], inner->local[b]);
      double *to = form->blocks + ((size_t)inner->point[a] * form->window + slot) * LAM_AREA_TERMS;
      for (int c = 0; c < LAM_AREA_TERMS; c++) to[c] += e[c];
    }
}

/* Adds a node to the sums of its span. dirichlet: with the metric of the plane and without a
 * normal, for which s is the block of the Dirichlet energy. */
static void add_node(const lam_area_form *form, const inner_functions *inner,
                     const lam_area_node *node, bool dirichlet) {
  lam_vec3 u = node->u, v = node->v, normal = lam_cross(u, v), n = {0};
  double E = lam_dot(u, u), F = lam_dot(u, v), G = lam_dot(v, v), a = lam_length(normal),
         w = node->weight;
  if (dirichlet) {
    add_pairs(form, inner, node, (double[3]){w, 0, w}, n);
    return;
  }

  /* A node without a tangent plane has no normal, and counts like one that almost has none. */
  double least = 1e-14 * (E + G), scale = E + G > 0 ? w / fmax(a, least) : 0;
  if (a > least) n = lam_scale(normal, 1 / a);
  add_pairs(form, inner, node, (double[3]){scale * E, scale * F, scale * G}, n);
  if (form->mean_curvature != 0) add_volume_pairs(form, inner, node);
}

/* Fills the blocks, span after span, by the rule of the second variation. */
static void fill_blocks(const lam_area_form *form, const lam_vec3 *points, bool dirichlet) {
  lam_area_node node;
  inner_functions inner;
  const lam_area_rule *ru = &form->second[0], *rv = &form->second[1];
  int total = form->inner[0] * form->inner[1];
  memset(form->blocks, 0, (size_t)total * form->window * LAM_AREA_TERMS * sizeof *form->blocks);

  for (int s = 0; s < ru->spans; s++)
    for (int t = 0; t < rv->spans; t++) {
      find_inner(form, s, t, &inner);
      memset(form->element, 0,
             (size_t)(inner.count * (inner.count + 1) / 2) * LAM_AREA_TERMS * sizeof(double));
      for (int k = 0; k < ru->nodes; k++)
        for (int l = 0; l < rv->nodes; l++) {
          lam_area_node_eval(form, form->second, points, s, t, k, l, &node);
          add_node(form, &inner, &node, dirichlet);
        }
      scatter(form, &inner);
    }
}

double lam_area_vary(const lam_area_form *form, const lam_vec3 *points) {
  fill_blocks(form, points, false);
  return lam_area_slope(form, points);
}
void lam_area_blocks(const lam_area_form *form, const lam_vec3 *points) {
  fill_blocks(form, points, false);
}

/* Adds sum R_a,u x_u + R_a,v x_v of a node of span (s, t), the gradient of the Dirichlet energy. */
static void add_dirichlet_gradient(const lam_area_form *form, int s, int t,
                                   const lam_area_node *node) {
  for (int a = 0; a < form->local; a++) {
    int point = lam_area_inner(form, s, t, a);
    if (point < 0) continue;
    lam_vec3 sum = lam_along(lam_scale(node->u, node->ru[a]), node->rv[a], node->v);
    form->gradient[point] = lam_along(form->gradient[point], node->weight, sum);
  }
}

/* The energy is quadratic: its gradient is its Hessian times the points, those of the boundary
 * included. */
void lam_area_dirichlet(const lam_area_form *form, const lam_vec3 *points) {
  lam_area_node node;
  memset(form->gradient, 0, (size_t)(form->inner[0] * form->inner[1]) * sizeof *form->gradient);
  for (int s = 0; s < form->second[0].spans; s++)
    for (int t = 0; t < form->second[1].spans; t++)
      for (int k = 0; k < form->second[0].nodes; k++)
        for (int l = 0; l < form->second[1].nodes; l++) {
          lam_area_node_eval(form, form->second, points, s, t, k, l, &node);
          add_dirichlet_gradient(form, s, t, &node);
        }
  fill_blocks(form, points, true);
}
