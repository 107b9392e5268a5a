/* What the tests of spline surfaces share: comparison at random parameters. */
#ifndef LAM_TESTS_SPLINE_SURFACE_FIXTURE_H
#define LAM_TESTS_SPLINE_SURFACE_FIXTURE_H

#include "curve_fixture.h"
#include "surf/spline/spline_edit.h"

static const double exact = 1e-12; /* points are of size 1 */

static inline lam_vec3 at(const lam_spline_surface *s, double u, double v) {
  lam_vec3 x;
  lam_spline_surface_derivatives(s, u, v, 0, &x);
  return x;
}

static inline void same(const lam_spline_surface *a, const lam_spline_surface *b, const double u[2],
                        const double v[2]) {
  for (int d = 0; d < 2; d++)
    assert_null(
        lam_knots_problem(b->degree[d], b->count[d], b->count[d] + b->degree[d] + 1, b->knots[d]));
  for (int i = 0; i < 30; i++) {
    double p = i == 0 ? u[0] : next_in(u[0], u[1]), q = i == 1 ? v[1] : next_in(v[0], v[1]);
    near3(at(b, p, q), at(a, p, q), exact);
  }
}

#endif
