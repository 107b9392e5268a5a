/* Least area with free weights. Unknowns of an inner point a: X = w P and w; x = sum X_a S_a, S_a =
 * N_a / W: dx = S_a e_c by X_a,  dx = -S_a x by w_a;   d2x = -S_a S_b e_c by X_a, w_b,   d2x = 2
 * S_a S_b x by w_a, w_b. The second variation along fields with (p, q) = (y_u, y_v) is alpha.p' +
 * beta.q' with alpha = n (G p.n - F q.n) / a + q x n,   beta = n (E q.n - F p.n) / a + n x p, and
 * d2x adds the first variation f_u.(d2x)_u + f_v.(d2x)_v, f_u = (G x_u - F x_v) / a, f_v = (E x_v -
 * F x_u) / a. Weights stay between bounds by projection (Bertsekas, Projected Newton methods,
 * 1982): those that sit at a bound and want to pass it are left out of the step. */
#include "core/numeric/dense.h"
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

typedef struct field {
  int unknown;
  lam_vec3 p, q, alpha, beta, metric_p, metric_q;
} field;

typedef struct projected {
  lam_area_form *form;
  int n; /* unknowns: X, w of every inner point */
  double low, high;
  lam_vec3 *points; /* of the net */
  double *weights;  /* of the net; the form's surface uses them */
  double *x, *trial, *step, *gradient, *second, *metric, *factor;
  bool *held;
} projected;

static void put(projected *s, const double *x) {
  for (int k = 0; k < s->n / 4; k++) {
    int at = lam_area_index(s->form, k);
    s->weights[at] = x[4 * k + 3];
    s->points[at] = lam_scale(lam_v3(x[4 * k], x[4 * k + 1], x[4 * k + 2]), 1 / x[4 * k + 3]);
  }
}

/* Variations of a place, four for every inner function of the span: count of them. */
static int fill_fields(const projected *s, int span_u, int span_v, const lam_area_place *location,
                       lam_vec3 n, double E, double F, double G, double a, field *fields,
                       double (*functions)[3]) {
  static const lam_vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int count = 0, q = s->form->rule[1].degree + 1;
  for (int b = 0; b < s->form->local; b++) {
    int inner = lam_area_inner(s->form, span_u, span_v, b);
    if (inner < 0) continue;
    int at = (s->form->rule[0].first[span_u] + b / q) * s->form->surface.count[1] +
             s->form->rule[1].first[span_v] + b % q;
    double w = 1 / s->weights[at], r = location->r[b] * w, ru = location->ru[b] * w,
           rv = location->rv[b] * w;
    for (int c = 0; c < 4; c++, count++) {
      field *f = &fields[count];
      f->unknown = 4 * inner + c;
      f->p = c < 3 ? lam_scale(axes[c], ru)
                   : lam_scale(lam_along(lam_scale(location->x, ru), r, location->u), -1);
      f->q = c < 3 ? lam_scale(axes[c], rv)
                   : lam_scale(lam_along(lam_scale(location->x, rv), r, location->v), -1);
      double pn = lam_dot(f->p, n), qn = lam_dot(f->q, n);
      f->alpha = lam_along(lam_cross(f->q, n), (G * pn - F * qn) / a, n);
      f->beta = lam_along(lam_cross(n, f->p), (E * qn - F * pn) / a, n);
      f->metric_p = lam_along(lam_scale(f->p, G / a), -F / a, f->q);
      f->metric_q = lam_along(lam_scale(f->q, E / a), -F / a, f->p);
      functions[count][0] = r;
      functions[count][1] = ru;
      functions[count][2] = rv;
    }
  }
  return count;
}

static void add_place(projected *s, int span_u, int span_v, const lam_area_place *location) {
  field fields[4 * LAM_AREA_LOCAL];
  double functions[4 * LAM_AREA_LOCAL][3];
  lam_vec3 u = location->u, v = location->v, normal = lam_cross(u, v);
  double E = lam_dot(u, u), F = lam_dot(u, v), G = lam_dot(v, v), a = lam_length(normal),
         w = location->weight;
  if (!(a > 1e-14 * (E + G))) return;
  int count = fill_fields(s, span_u, span_v, location, lam_scale(normal, 1 / a), E, F, G, a, fields,
                          functions);
  lam_vec3 fu = lam_along(lam_scale(u, G / a), -F / a, v),
           fv = lam_along(lam_scale(v, E / a), -F / a, u);
  double xu = lam_dot(location->x, fu), xv = lam_dot(location->x, fv);
  for (int i = 0; i < count; i++) {
    const field *f = &fields[i];
    int c = f->unknown % 4;
    s->gradient[f->unknown] += w * (lam_dot(f->p, fu) + lam_dot(f->q, fv));
    for (int j = 0; j <= i; j++) {
      const field *g = &fields[j];
      int d = g->unknown % 4;
      double r = functions[i][0] * functions[j][0],
             ru = functions[i][1] * functions[j][0] + functions[i][0] * functions[j][1],
             rv = functions[i][2] * functions[j][0] + functions[i][0] * functions[j][2];
      double value = lam_dot(f->alpha, g->p) + lam_dot(f->beta, g->q);
      if (c == 3 && d == 3)
        value += 2 * (ru * xu + rv * xv + 2 * a * r);
      else if (c == 3 || d == 3)
        value -= ru * (&fu.x)[c == 3 ? d : c] + rv * (&fv.x)[c == 3 ? d : c];
      size_t at = (size_t)f->unknown * (size_t)s->n +
                  (size_t)g->unknown; /* inner points ascend: the lower triangle */
      s->second[at] += w * value;
      s->metric[at] += w * (lam_dot(f->metric_p, g->p) + lam_dot(f->metric_q, g->q));
    }
  }
}

static void vary(projected *s) {
  size_t size = (size_t)s->n * (size_t)s->n * sizeof(double);
  const lam_area_form *form = s->form;
  lam_area_place location;
  memset(s->gradient, 0, (size_t)s->n * sizeof(double));
  memset(s->second, 0, size);
  memset(s->metric, 0, size);
  put(s, s->x);
  for (int i = 0; i < form->rule[0].spans; i++)
    for (int j = 0; j < form->rule[1].spans; j++)
      for (int k = 0; k < form->rule[0].places; k++)
        for (int l = 0; l < form->rule[1].places; l++) {
          lam_area_visit(form, s->points, i, j, k, l, &location);
          add_place(s, i, j, &location);
        }
  for (int k = 0; k < s->n; k++)
    s->held[k] = k % 4 == 3 && ((s->x[k] <= s->low && s->gradient[k] > 0) ||
                                (s->x[k] >= s->high && s->gradient[k] < 0));
}

/* The step for this lambda, with the unknowns that are held left out. */
static bool find_step(projected *s, double lambda) {
  for (int i = 0; i < s->n; i++)
    for (int j = 0; j <= i; j++) {
      size_t at = (size_t)i * (size_t)s->n + (size_t)j;
      s->factor[at] = s->held[i] || s->held[j] ? i == j : s->second[at] + lambda * s->metric[at];
    }
  if (!lam_cholesky_factor(s->n, s->factor)) return false;
  for (int k = 0; k < s->n; k++) s->step[k] = s->held[k] ? 0 : -s->gradient[k];
  lam_cholesky_solve(s->n, s->factor, s->step);
  return true;
}

/* The area after the step, projected into the bounds. */
static double try_step(projected *s) {
  for (int k = 0; k < s->n; k++) {
    s->trial[k] = s->x[k] + s->step[k];
    if (k % 4 == 3) s->trial[k] = fmin(fmax(s->trial[k], s->low), s->high);
  }
  put(s, s->trial);
  return lam_area_value(s->form, s->points);
}

static projected prepare(lam_arena *arena, const lam_spline_surface *start, double low,
                         double high) {
  projected s = {.low = low, .high = high};
  int all = start->count[0] * start->count[1];
  s.n = 4 * (start->count[0] - 2) * (start->count[1] - 2);
  s.points = LAM_NEW(arena, lam_vec3, all);
  s.weights = LAM_NEW(arena, double, all);
  for (int k = 0; k < all; k++) {
    s.points[k] = start->points[k];
    s.weights[k] = start->weights ? start->weights[k] : 1;
  }
  lam_spline_surface shape = *start;
  shape.points = s.points;
  shape.weights = s.weights;
  s.form = lam_area_form_make(arena, &shape, 0, lam_area_places(start, 64));
  double **vectors[] = {&s.x, &s.trial, &s.step, &s.gradient},
         **matrices[] = {&s.second, &s.metric, &s.factor};
  for (int k = 0; k < 4; k++) *vectors[k] = LAM_NEW(arena, double, s.n);
  for (int k = 0; k < 3; k++) *matrices[k] = LAM_NEW(arena, double, (size_t)s.n *(size_t)s.n);
  s.held = LAM_NEW(arena, bool, s.n);
  for (int k = 0; k < s.n / 4; k++) {
    int at = lam_area_index(s.form, k);
    double w = fmin(fmax(s.weights[at], low), high);
    lam_vec3 X = lam_scale(s.points[at], w);
    memcpy(s.x + 4 * k, (double[4]){X.x, X.y, X.z, w}, 4 * sizeof(double));
  }
  return s;
}

lam_least_area_result lam_least_area_weights(lam_arena *arena, const lam_spline_surface *start,
                                             double low, double high,
                                             const lam_least_area_options *options) {
  lam_least_area_result result = {.reason = "as many steps as allowed"};
  projected s = prepare(arena, start, low, high);
  double lambda = 1e-3;
  put(&s, s.x);
  result.area = lam_area_value(s.form, s.points);
  for (; result.iterations < options->most && !result.converged; result.iterations++) {
    double before = result.area;
    vary(&s);
    for (; lambda < 1e8; lambda *= 4) {
      if (!find_step(&s, lambda)) continue;
      result.evaluations++;
      result.area = try_step(&s);
      if (result.area <= before) break;
    }
    if (!(lambda < 1e8)) {
      result.area = before;
      result.reason = "no step goes down any more";
      break;
    }
    memcpy(s.x, s.trial, (size_t)s.n * sizeof(double));
    lambda = fmax(1e-9, lambda / 4);
    result.converged = before - result.area <= options->tolerance * before;
  }
  if (result.converged) result.reason = "the area falls no more";
  put(&s, s.x);
  result.surface = s.form->surface;
  result.surface.points = s.points;
  return result;
}
