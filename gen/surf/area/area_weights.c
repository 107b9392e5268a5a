/* Least area with free weights. Called by least_area.c when the inner weights are to be free.
 *
 * Unknowns of an inner point a: X = w P and w. With x = sum X_a S_a, S_a = N_a / W:
 *
 *   dx  = S_a e_c by X_a,              dx  = -S_a x by w_a
 *   d2x = -S_a S_b e_c by X_a, w_b,    d2x = 2 S_a S_b x by w_a, w_b
 *
 * The second variation along fields with (p, q) = (y_u, y_v) is alpha.p' + beta.q' with
 *
 *   alpha = n (G p.n - F q.n) / a + q x n,   beta = n (E q.n - F p.n) / a + n x p
 *
 * and d2x adds the first variation f_u.(d2x)_u + f_v.(d2x)_v, f_u = (G x_u - F x_v) / a, f_v =
 * (E x_v - F x_u) / a. Weights stay between bounds by projection (Bertsekas, Projected Newton
 * methods, 1982): those that sit at a bound and want to pass it are left out of the step. */
#include "core/numeric/dense.h"
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* The variation (p, q) = (y_u, y_v) of one unknown at a node, with its alpha and beta, and the
 * same of the metric: (G p - F q) / a and (E q - F p) / a. */
typedef struct field {
  int unknown;
  double r, ru, rv; /* S_a and its derivatives */
  lam_vec3 p, q, alpha, beta, metric_p, metric_q;
} field;

/* The surface at a node: its metric, unit normal, first variation (f_u, f_v), and x.f_u, x.f_v. */
typedef struct metric {
  double E, F, G, a;
  lam_vec3 n, fu, fv;
  double xu, xv;
} metric;

typedef struct projected {
  lam_area_form *form;
  int n;                            /* unknowns: X, w of every inner point */
  double low, high;                 /* bounds of the weights */
  lam_vec3 *points;                 /* of the net */
  double *weights;                  /* of the net; the form's surface uses them */
  double *x, *trial;                /* n: the unknowns, here and after a step */
  double *step, *gradient;          /* n */
  double *second, *metric, *factor; /* n x n, lower triangles */
  bool *held;                       /* n: left out of the step */
} projected;

/* Sets the inner points and weights of the net to those of the unknowns x. */
static void put(projected *s, const double *x) {
  for (int k = 0; k < s->n / 4; k++) {
    int at = lam_area_index(s->form, k);
    s->weights[at] = x[4 * k + 3];
    s->points[at] = lam_scale(lam_v3(x[4 * k], x[4 * k + 1], x[4 * k + 2]), 1 / x[4 * k + 3]);
  }
}

/* The surface at a node; not finite where it has no tangent plane (a = 0). */
static metric metric_of(const lam_area_node *node) {
  lam_vec3 u = node->u, v = node->v, normal = lam_cross(u, v);
  double E = lam_dot(u, u), F = lam_dot(u, v), G = lam_dot(v, v), a = lam_length(normal);
  metric m = {.E = E, .F = F, .G = G, .a = a, .n = lam_scale(normal, 1 / a)};
  m.fu = lam_along(lam_scale(u, G / a), -F / a, v);
  m.fv = lam_along(lam_scale(v, E / a), -F / a, u);
  m.xu = lam_dot(node->x, m.fu);
  m.xv = lam_dot(node->x, m.fv);
  return m;
}

/* Sets the variation of unknown c of a point: X_x, X_y, X_z or w; r, ru and rv of the field are
 * set. */
static void set_field(field *f, int c, const lam_area_node *node, const metric *m) {
  static const lam_vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  f->p = c < 3 ? lam_scale(axes[c], f->ru)
               : lam_scale(lam_along(lam_scale(node->x, f->ru), f->r, node->u), -1);
  f->q = c < 3 ? lam_scale(axes[c], f->rv)
               : lam_scale(lam_along(lam_scale(node->x, f->rv), f->r, node->v), -1);

  double pn = lam_dot(f->p, m->n), qn = lam_dot(f->q, m->n);
  f->alpha = lam_along(lam_cross(f->q, m->n), (m->G * pn - m->F * qn) / m->a, m->n);
  f->beta = lam_along(lam_cross(m->n, f->p), (m->E * qn - m->F * pn) / m->a, m->n);
  f->metric_p = lam_along(lam_scale(f->p, m->G / m->a), -m->F / m->a, f->q);
  f->metric_q = lam_along(lam_scale(f->q, m->E / m->a), -m->F / m->a, f->p);
}

/* The variations at a node of span (span_u, span_v), four for every inner function. Returns their
 * number. */
static int fill_fields(const projected *s, int span_u, int span_v, const lam_area_node *node,
                       const metric *m, field *fields) {
  int count = 0, q = s->form->rule[1].degree + 1;

  for (int b = 0; b < s->form->local; b++) {
    int inner = lam_area_inner(s->form, span_u, span_v, b);
    if (inner < 0) continue;
    int at = (s->form->rule[0].first[span_u] + b / q) * s->form->surface.count[1] +
             s->form->rule[1].first[span_v] + b % q;

    double w = 1 / s->weights[at];
    for (int c = 0; c < 4; c++, count++) {
      field *f = &fields[count];
      f->unknown = 4 * inner + c;
      f->r = node->r[b] * w;
      f->ru = node->ru[b] * w;
      f->rv = node->rv[b] * w;
      set_field(f, c, node, m);
    }
  }
  return count;
}

/* alpha.p' + beta.q' of two unknowns, and what d2x adds where one or both of them are weights;
 * r, ru, rv are S_a S_b and its derivatives. */
static double second_variation(const field *f, const field *g, const metric *m) {
  int c = f->unknown % 4, d = g->unknown % 4;
  double r = f->r * g->r, ru = f->ru * g->r + f->r * g->ru, rv = f->rv * g->r + f->r * g->rv;
  double value = lam_dot(f->alpha, g->p) + lam_dot(f->beta, g->q);
  if (c == 3 && d == 3)
    value += 2 * (ru * m->xu + rv * m->xv + 2 * m->a * r);
  else if (c == 3 || d == 3)
    value -= ru * (&m->fu.x)[c == 3 ? d : c] + rv * (&m->fv.x)[c == 3 ? d : c];
  return value;
}

/* Adds a node of span (span_u, span_v) to the gradient, the second variation and the metric. */
static void add_node(projected *s, int span_u, int span_v, const lam_area_node *node) {
  field fields[4 * LAM_AREA_LOCAL];
  metric m = metric_of(node);
  double w = node->weight;
  if (!(m.a > 1e-14 * (m.E + m.G))) return;
  int count = fill_fields(s, span_u, span_v, node, &m, fields);

  for (int i = 0; i < count; i++) {
    const field *f = &fields[i];
    s->gradient[f->unknown] += w * (lam_dot(f->p, m.fu) + lam_dot(f->q, m.fv));
    for (int j = 0; j <= i; j++) {
      const field *g = &fields[j];

      /* The lower triangle: inner points ascend. */
      size_t at = (size_t)f->unknown * (size_t)s->n + (size_t)g->unknown;
      s->second[at] += w * second_variation(f, g, &m);
      s->metric[at] += w * (lam_dot(f->metric_p, g->p) + lam_dot(f->metric_q, g->q));
    }
  }
}

/* Gradient, second variation and metric at x, and which weights are held at their bounds. */
static void vary(projected *s) {
  size_t size = (size_t)s->n * (size_t)s->n * sizeof(double);
  const lam_area_form *form = s->form;
  lam_area_node node;
  memset(s->gradient, 0, (size_t)s->n * sizeof(double));
  memset(s->second, 0, size);
  memset(s->metric, 0, size);

  put(s, s->x);
  for (int i = 0; i < form->rule[0].spans; i++)
    for (int j = 0; j < form->rule[1].spans; j++)
      for (int k = 0; k < form->rule[0].nodes; k++)
        for (int l = 0; l < form->rule[1].nodes; l++) {
          lam_area_node_eval(form, form->rule, s->points, i, j, k, l, &node);
          add_node(s, i, j, &node);
        }

  for (int k = 0; k < s->n; k++)
    s->held[k] = k % 4 == 3 && ((s->x[k] <= s->low && s->gradient[k] > 0) ||
                                (s->x[k] >= s->high && s->gradient[k] < 0));
}

/* Solves (second variation + lambda metric) step = -gradient with the held unknowns left out;
 * false: not positive definite. */
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

/* The area after the step, whose weights are projected into the bounds. */
static double try_step(projected *s) {
  for (int k = 0; k < s->n; k++) {
    s->trial[k] = s->x[k] + s->step[k];
    if (k % 4 == 3) s->trial[k] = fmin(fmax(s->trial[k], s->low), s->high);
  }
  put(s, s->trial);
  return lam_area_value(s->form, s->points);
}

/* The unknowns and arrays for a minimization that begins at the start, its weights brought into
 * the bounds. */
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
  s.form = lam_area_form_make(arena, &shape, 0, lam_area_node_count(start, 64));

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

/* One step, lambda raised until the area of the result does not rise and lowered after; false: no
 * step goes down, and everything stays. */
static bool descend(projected *s, double *lambda, lam_least_area_result *result) {
  for (; *lambda < 1e8; *lambda *= 4) {
    if (!find_step(s, *lambda)) continue;
    result->evaluations++;
    double next = try_step(s);
    if (!(next <= result->area)) continue;

    result->area = next;
    memcpy(s->x, s->trial, (size_t)s->n * sizeof(double));
    *lambda = fmax(1e-9, *lambda / 4);
    return true;
  }
  return false;
}

/* Damped Newton steps. */
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
    if (!descend(&s, &lambda, &result)) {
      result.reason = "no step goes down any more";
      break;
    }
    result.converged = before - result.area <= options->tolerance * before;
  }

  if (result.converged) result.reason = "the area falls no more";
  put(&s, s.x);
  result.surface = s.form->surface;
  result.surface.points = s.points;
  return result;
}
