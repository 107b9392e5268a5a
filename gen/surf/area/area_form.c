/* The area as a function of the control points.
 *
 * With E, F, G, a = |x_u x x_v| = sqrt(EG - F^2), n = x_u x x_v / a and a variation with p = dx_u,
 * q = dx_v: a'  = p.(x_v x n) + q.(n x x_u) = (p.(G x_u - F x_v) + q.(E x_v - F x_u)) / a, a'' = (G
 * (p.n)^2 - 2 F (p.n)(q.n) + E (q.n)^2) / a + 2 n.(p x q). For functions f and g of two control
 * points this is the 3 x 3 block s n n^T + t [n], with s = (G f_u g_u - F (f_u g_v + f_v g_u) + E
 * f_v g_v) / a,   t = f_u g_v - f_v g_u,   [n]_cd = n.(e_c x e_d), and s alone is the block of I/2
 * (Wu & Wang, step 5), M. Constant mean curvature H: the volume V = 1/3 integral x.(x_u x x_v) is
 * added 2 H times; V' = integral dx.(x_u x x_v), and its second variation adds 1/2 (f g_u - g f_u)
 * [x_v] - 1/2 (f g_v - g f_v) [x_u]. */
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_parts.h"
#include <limits.h>
#include <math.h>
#include <string.h>

lam_area_rule lam_area_rule_make(lam_arena *arena, const lam_spline_surface *surface, int d,
                                 int places) {
  int p = surface->degree[d], count = surface->count[d], spans = 0;
  const double *knots = surface->knots[d];
  for (int i = p; i < count; i++) spans += knots[i + 1] > knots[i];
  int *first = LAM_NEW(arena, int, spans);
  double *weights = LAM_NEW(arena, double, spans *places),
         *parameters = LAM_NEW(arena, double, spans *places),
         *values = LAM_NEW(arena, double, spans *places * 2 * (p + 1)),
         *at = LAM_NEW(arena, double, places), *w = LAM_NEW(arena, double, places);
  lam_gauss_rule(places, at, w);
  for (int i = p, s = 0; i < count; i++) {
    double width = knots[i + 1] - knots[i];
    if (!(width > 0)) continue;
    first[s] = i - p;
    for (int k = 0; k < places; k++) {
      weights[s * places + k] = width * w[k];
      parameters[s * places + k] = knots[i] + width * at[k];
      lam_basis_eval(p, knots, i, knots[i] + width * at[k], 1,
                     values + (s * places + k) * 2 * (p + 1));
    }
    s++;
  }
  return (lam_area_rule){p, spans, places, first, weights, parameters, values};
}

int lam_area_places(const lam_spline_surface *surface, int along) {
  int degree = surface->degree[0] > surface->degree[1] ? surface->degree[0] : surface->degree[1],
      spans = INT_MAX;
  for (int d = 0; d < 2; d++) {
    int count = 0;
    for (int i = surface->degree[d]; i < surface->count[d]; i++)
      count += surface->knots[d][i + 1] > surface->knots[d][i];
    if (count < spans) spans = count;
  }
  int few = (along + spans - 1) / spans;
  return degree + 3 > few ? degree + 3 : few;
}

lam_area_form *lam_area_form_make(lam_arena *arena, const lam_spline_surface *surface,
                                  double mean_curvature, int places) {
  lam_area_form *form = LAM_NEW(arena, lam_area_form, 1);
  form->surface = *surface;
  form->mean_curvature = mean_curvature;
  for (int d = 0; d < 2; d++) {
    form->rule[d] = form->second[d] = lam_area_rule_make(arena, surface, d, places);
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

void lam_area_form_coarsen(lam_arena *arena, lam_area_form *form) {
  enum { along = 16 };
  for (int d = 0; d < 2; d++) {
    int few = form->rule[d].degree + 1,
        places = (along + form->rule[d].spans - 1) / form->rule[d].spans;
    if (places < few) places = few;
    if (places < form->rule[d].places)
      form->second[d] = lam_area_rule_make(arena, &form->surface, d, places);
  }
}

static void visit(const lam_area_form *form, const lam_area_rule rule[2], const lam_vec3 *points,
                  int s, int t, int k, int l, lam_area_place *location) {
  const lam_area_rule *ru = &rule[0], *rv = &rule[1];
  int p = ru->degree + 1, q = rv->degree + 1, at[2] = {s * ru->places + k, t * rv->places + l};
  const double *f = ru->values + at[0] * 2 * p, *g = rv->values + at[1] * 2 * q,
               *weights = form->surface.weights;
  int columns = form->surface.count[1], corner = ru->first[s] * columns + rv->first[t];
  double w = 0, wu = 0, wv = 0;
  location->weight = ru->weights[at[0]] * rv->weights[at[1]];
  for (int i = 0, a = 0; i < p; i++)
    for (int j = 0; j < q; j++, a++) {
      double weight = weights ? weights[corner + i * columns + j] : 1;
      w += location->r[a] = weight * f[i] * g[j];
      wu += location->ru[a] = weight * f[p + i] * g[j];
      wv += location->rv[a] = weight * f[i] * g[q + j];
    }
  if (weights) {
    double scale = 1 / w;
    for (int a = 0; a < p * q; a++) {
      location->r[a] *= scale;
      location->ru[a] = scale * (location->ru[a] - location->r[a] * wu);
      location->rv[a] = scale * (location->rv[a] - location->r[a] * wv);
    }
  }
  lam_vec3 x = {0}, u = {0}, v = {0};
  for (int i = 0, a = 0; i < p; i++)
    for (int j = 0; j < q; j++, a++) {
      lam_vec3 point = points[corner + i * columns + j];
      x = lam_along(x, location->r[a], point);
      u = lam_along(u, location->ru[a], point);
      v = lam_along(v, location->rv[a], point);
    }
  location->x = x;
  location->u = u;
  location->v = v;
}

void lam_area_visit(const lam_area_form *form, const lam_vec3 *points, int s, int t, int k, int l,
                    lam_area_place *location) {
  visit(form, form->rule, points, s, t, k, l, location);
}

int lam_area_inner(const lam_area_form *form, int s, int t, int a) {
  int q = form->rule[1].degree + 1, i = form->rule[0].first[s] + a / q - 1,
      j = form->rule[1].first[t] + a % q - 1;
  return i >= 0 && i < form->inner[0] && j >= 0 && j < form->inner[1] ? i * form->inner[1] + j : -1;
}

/* The functions of a span that belong to inner points. */
typedef struct inner_functions {
  int count, local[LAM_AREA_LOCAL], point[LAM_AREA_LOCAL];
} inner_functions;

static void find_inner(const lam_area_form *form, int s, int t, inner_functions *inner) {
  inner->count = 0;
  for (int a = 0; a < form->local; a++) {
    int point = lam_area_inner(form, s, t, a);
    if (point < 0) continue;
    inner->local[inner->count] = a;
    inner->point[inner->count++] = point;
  }
}

/* s, s n n^T and t n of every pair of functions; metric = weight / a (E, F, G). */
static void add_pairs(const lam_area_form *form, const inner_functions *inner,
                      const lam_area_place *location, const double metric[3], lam_vec3 n) {
  double *e = form->element, w = location->weight, u[LAM_AREA_LOCAL], v[LAM_AREA_LOCAL];
  double symmetric[6] = {n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z},
         skew[3] = {n.x, n.y, n.z};
  for (int a = 0; a < inner->count; a++) {
    u[a] = location->ru[inner->local[a]];
    v[a] = location->rv[inner->local[a]];
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

static void add_volume_pairs(const lam_area_form *form, const inner_functions *inner,
                             const lam_area_place *location) {
  double half = form->mean_curvature * location->weight, *e = form->element;
  for (int k = 0; k < inner->count; k++)
    for (int l = k; l < inner->count; l++, e += LAM_AREA_TERMS) {
      int a = inner->local[k], b = inner->local[l];
      double u = half * (location->r[a] * location->ru[b] - location->r[b] * location->ru[a]);
      double v = half * (location->r[a] * location->rv[b] - location->r[b] * location->rv[a]);
      lam_vec3 t = lam_along(lam_scale(location->v, u), -v, location->u);
      e[7] += t.x;
      e[8] += t.y;
      e[9] += t.z;
    }
}

/* The sums of one span go to where the points keep them. */
static void scatter(const lam_area_form *form, const inner_functions *inner) {
  const double *e = form->element;
  for (int a = 0; a < inner->count; a++)
    for (int b = a; b < inner->count; b++, e += LAM_AREA_TERMS) {
      int slot = lam_area_slot(form, inner->local[a], inner->local[b]);
      double *to = form->blocks + ((size_t)inner->point[a] * form->window + slot) * LAM_AREA_TERMS;
      for (int c = 0; c < LAM_AREA_TERMS; c++) to[c] += e[c];
    }
}

static void add_place(const lam_area_form *form, const inner_functions *inner,
                      const lam_area_place *location, bool dirichlet) {
  lam_vec3 u = location->u, v = location->v, normal = lam_cross(u, v), n = {0};
  double E = lam_dot(u, u), F = lam_dot(u, v), G = lam_dot(v, v), a = lam_length(normal),
         w = location->weight;
  double least = 1e-14 * (E + G), scale = E + G > 0 ? w / fmax(a, least) : 0;
  if (dirichlet) {
    add_pairs(form, inner, location, (double[3]){w, 0, w}, n);
    return;
  }
  if (a > least) n = lam_scale(normal, 1 / a);
  add_pairs(form, inner, location, (double[3]){scale * E, scale * F, scale * G}, n);
  if (form->mean_curvature != 0) add_volume_pairs(form, inner, location);
}

static void fill_blocks(const lam_area_form *form, const lam_vec3 *points, bool dirichlet) {
  lam_area_place location;
  inner_functions inner;
  const lam_area_rule *ru = &form->second[0], *rv = &form->second[1];
  int total = form->inner[0] * form->inner[1];
  memset(form->blocks, 0, (size_t)total * form->window * LAM_AREA_TERMS * sizeof *form->blocks);
  for (int s = 0; s < ru->spans; s++)
    for (int t = 0; t < rv->spans; t++) {
      find_inner(form, s, t, &inner);
      memset(form->element, 0,
             (size_t)(inner.count * (inner.count + 1) / 2) * LAM_AREA_TERMS * sizeof(double));
      for (int k = 0; k < ru->places; k++)
        for (int l = 0; l < rv->places; l++) {
          visit(form, form->second, points, s, t, k, l, &location);
          add_place(form, &inner, &location, dirichlet);
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

/* The energy is quadratic: its gradient is its Hessian times the points, those of the boundary
 * included. */
void lam_area_dirichlet(const lam_area_form *form, const lam_vec3 *points) {
  lam_area_place location;
  memset(form->gradient, 0, (size_t)(form->inner[0] * form->inner[1]) * sizeof *form->gradient);
  for (int s = 0; s < form->second[0].spans; s++)
    for (int t = 0; t < form->second[1].spans; t++)
      for (int k = 0; k < form->second[0].places; k++)
        for (int l = 0; l < form->second[1].places; l++) {
          visit(form, form->second, points, s, t, k, l, &location);
          for (int a = 0; a < form->local; a++) {
            int point = lam_area_inner(form, s, t, a);
            if (point < 0) continue;
            lam_vec3 sum =
                lam_along(lam_scale(location.u, location.ru[a]), location.rv[a], location.v);
            form->gradient[point] = lam_along(form->gradient[point], location.weight, sum);
          }
        }
  fill_blocks(form, points, true);
}

void lam_area_move(const lam_area_form *form, const lam_vec3 *from, double t, const lam_vec3 *step,
                   lam_vec3 *to) {
  int total = form->inner[0] * form->inner[1],
      all = form->surface.count[0] * form->surface.count[1];
  if (to != from) memcpy(to, from, (size_t)all * sizeof *to);
  for (int k = 0; k < total; k++)
    to[lam_area_index(form, k)] = lam_along(from[lam_area_index(form, k)], t, step[k]);
}
