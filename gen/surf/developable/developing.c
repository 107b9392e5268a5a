/* Quick steps that the methods for approximately developable surfaces share. Called by
 * developable_newton.c, developable_paper.c, minimax.c and developable_solve.c. */
#include "surf/developable/developable_parts.h"

/* Points of the boundary stay; inner ones move by three numbers of the step each. */
void lam_developing_try(const lam_developing *d, const double *step) {
  for (int i = 0; i < d->total; i++) {
    int k = d->norm->unknown[i];
    d->trial[i] = k < 0 ? d->x[i] : lam_add(d->x[i], lam_v3(step[k], step[k + 1], step[k + 2]));
  }
}

void lam_developing_accept(lam_developing *d) {
  lam_vec3 *before = d->x;
  d->x = d->trial;
  d->trial = before;
}

bool lam_developing_sound(const lam_developing *d, const lam_gauss_value *value) {
  return isfinite(value->power) && value->ratio > 1e-4 && value->area < 4 * d->area;
}

/* Developable to rounding: max |K| below 1e-10 over the square of the boundary's size. */
bool lam_developing_curved(lam_developing *d) {
  d->scale = lam_gauss_norm_eval(d->norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL).max;
  return d->scale * d->size * d->size > 1e-10;
}

/* Empty spans of repeated knots do not count. */
int lam_spline_spans(const lam_spline_surface *s) {
  int most = 0;
  for (int d = 0; d < 2; d++) {
    int count = 0;
    for (int k = s->degree[d]; k < s->count[d]; k++) count += s->knots[d][k] < s->knots[d][k + 1];
    most = count > most ? count : most;
  }
  return most;
}

int lam_developing_nodes(const lam_spline_surface *s, int each) {
  int degree = s->degree[0] > s->degree[1] ? s->degree[0] : s->degree[1];
  return each > 2 * degree + 4 ? each : 2 * degree + 4;
}
