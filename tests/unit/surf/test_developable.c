/* Nearly developable surfaces: K and its derivatives, the norm, the minima, and the paper's
 * algorithms. Expected figures come from an independent program (see
 * tests/cases/developable/boundaries.json) unless said otherwise. */
#include "developable_fixture.h"
#include "surf/developable/developable_parts.h"
#include "surf/spline/spline_surface.h"

static double random_in(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 4503599627370496.0 - 1;
}

/* ---- the formula ---- */

static void k_is_that_of_the_fundamental_forms(void **state) {
  (void)state;
  uint64_t seed = 7;
  for (int trial = 0; trial < 200; trial++) {
    lam_vec3 d[LAM_TANGENTS];
    double stretch;
    for (int t = 0; t < LAM_TANGENTS; t++)
      d[t] = lam_v3(random_in(&seed), random_in(&seed), random_in(&seed));
    lam_jet jet = {{0}, d[0], d[1], d[2], d[3], d[4]};
    double K = lam_gauss_derivatives(d, &stretch, NULL, NULL), expected = lam_jet_curvature(&jet).K;
    if (fabs(K - expected) > 1e-12 * fabs(expected) + 1e-13 / pow(stretch, 4))
      fail_msg("K is %.15g, the fundamental forms give %.15g", K, expected);
  }
}

static void derivatives_of_k_agree_with_differences(void **state) {
  (void)state;
  uint64_t seed = 11;
  static const double h = 1e-5;
  for (int trial = 0; trial < 50; trial++) {
    lam_vec3 d[LAM_TANGENTS], first[LAM_TANGENTS], ahead[LAM_TANGENTS], back[LAM_TANGENTS];
    double stretch, second[LAM_GAUSS_VARIABLES * LAM_GAUSS_VARIABLES];
    for (int t = 0; t < LAM_TANGENTS; t++)
      d[t] = lam_v3(random_in(&seed), random_in(&seed), random_in(&seed));
    d[0].x += 3; /* well away from a singular point */
    d[1].y += 3;
    lam_gauss_derivatives(d, &stretch, first, second);
    for (int i = 0; i < LAM_GAUSS_VARIABLES; i++) {
      double *x = &d[i / 3].x + i % 3, kept = *x;
      *x = kept + h;
      double high = lam_gauss_derivatives(d, &stretch, ahead, NULL);
      *x = kept - h;
      double low = lam_gauss_derivatives(d, &stretch, back, NULL);
      *x = kept;
      dev_near((&first[i / 3].x)[i % 3], (high - low) / (2 * h), 1e-8);
      for (int k = 0; k < LAM_GAUSS_VARIABLES; k++)
        dev_near(second[i * LAM_GAUSS_VARIABLES + k],
                 ((&ahead[k / 3].x)[k % 3] - (&back[k / 3].x)[k % 3]) / (2 * h), 1e-8);
    }
  }
}

/* Gradient and full Hessian of the p-th power of the norm, on a spline of two pieces in each
 * direction. */
static void derivatives_of_the_norm_agree_with_differences(void **state) {
  dev_fixture *f = *state;
  static const double powers[] = {2, 4};
  double knots[9];
  uint64_t seed = 5;
  lam_knots_clamped(3, 5, knots);
  lam_vec3 x[25];
  for (int i = 0; i < 25; i++)
    x[i] = lam_v3(i / 5 + 0.2 * random_in(&seed), i % 5 + 0.2 * random_in(&seed),
                  0.5 * random_in(&seed));
  lam_spline_surface s = {.degree = {3, 3}, .count = {5, 5}, .knots = {knots, knots}, .points = x};
  lam_gauss_norm norm = lam_gauss_norm_make(f->arena, &s, 6);
  int n = norm.unknowns;
  assert_int_equal(n, 27);
  double *g = LAM_NEW(f->arena, double, n), *up = LAM_NEW(f->arena, double, n),
         *down = LAM_NEW(f->arena, double, n);
  double *H = LAM_NEW(f->arena, double, n *n);
  for (int p = 0; p < 2; p++) {
    lam_gauss_norm_eval(&norm, x, powers[p], 1, LAM_ORDER_NEWTON, g, H);
    double size = 0;
    for (int i = 0; i < n; i++) size = fmax(size, fabs(H[i * n + i]));
    for (int v = 0; v < 25; v++)
      for (int c = 0; norm.unknown[v] >= 0 && c < 3; c++) {
        double *value = &x[v].x + c, kept = *value, h = 1e-6;
        int i = norm.unknown[v] + c;
        *value = kept + h;
        double high =
            lam_gauss_norm_eval(&norm, x, powers[p], 1, LAM_ORDER_GRADIENT, up, NULL).power;
        *value = kept - h;
        double low =
            lam_gauss_norm_eval(&norm, x, powers[p], 1, LAM_ORDER_GRADIENT, down, NULL).power;
        *value = kept;
        dev_near(g[i], (high - low) / (2 * h), 1e-7 * size);
        for (int k = 0; k < n; k++) {
          double entry = i >= k ? H[i * n + k] : H[k * n + i];
          dev_near(entry, (up[k] - down[k]) / (2 * h), 1e-6 * size);
        }
      }
  }
}

/* ---- the start and the minima ---- */

static void coons_surfaces_are_those_of_the_formula(void **state) {
  dev_fixture *f = *state;
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) {
    lam_spline_surface s = dev_coons(f->arena, c);
    lam_developable_measures m = lam_developable_measure(f->arena, &s, 40, 200);
    dev_close(dev_name(c), "||K|| of the Coons surface", m.l2, dev_number(c, "coons_l2"), 1e-7);
    dev_close(dev_name(c), "max|K| of the Coons surface", m.max, dev_number(c, "coons_max"), 1e-6);
  }
}

static void minima_are_reached(void **state) {
  dev_fixture *f = *state;
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) {
    lam_spline_surface s = dev_solved(f->arena, c);
    lam_developable_measures m = lam_developable_measure(f->arena, &s, 40, 200);
    double least = dev_number(c, "least_l2");
    if (least < 1e-11 && m.l2 > 1e-11)
      fail_msg("%s: ||K|| is %.3g, a developable surface exists", dev_name(c), m.l2);
    if (least > 1e-11) dev_close(dev_name(c), "||K||", m.l2, least, 1e-6);
    if (least > 1e-11)
      dev_close(dev_name(c), "max|K|", m.max, dev_number(c, "max_at_least_l2"), 1e-4);
    dev_near(m.corner_bound, dev_number(c, "corner_bound"), 1e-9);
  }
}

/* On D5 every descent from the symmetric Coons surface stops at .0509208, where two eigenvalues are
 * negative. */
static void saddle_points_are_left(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_coons(f->arena, dev_case(f, "D5"));
  lam_developable_result r =
      lam_developable_solve(f->arena, &s, (lam_developable_options){.power = 2});
  assert_true(r.escapes > 0);
  assert_true(r.norm < 0.0508);
}

/* D1 lies on the circular cone x^2 + y^2 = z^2. The distance of a point is ||(x,y)| - z| / sqrt 2.
 */
static void the_cone_is_found(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D1"));
  const lam_nurbs *nurbs = lam_nurbs_make(f->arena, &s);
  for (int k = 0; k < 121; k++) {
    lam_jet jet;
    lam_nurbs_eval(nurbs, k / 11 / 10., k % 11 / 10., &jet);
    double off = fabs(hypot(jet.x.x, jet.x.y) - jet.x.z) / sqrt(2);
    if (off > 1e-9) fail_msg("a point lies %.3g m off the cone", off); /* the case has 12 digits */
  }
}

/* Algorithms 1 and 2 of the paper, with corrected formulas, reach the same minima (D5: its saddle
 * point). */
static void algorithms_of_the_paper_agree(void **state) {
  dev_fixture *f = *state;
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) for (int method = 1; method <= 2; method++) {
    lam_spline_surface s = dev_coons(f->arena, c);
    lam_developable_result r = lam_developable_solve(
        f->arena, &s,
        (lam_developable_options){
            .method = (lam_developable_method)method, .power = 2, .points = 16});
    double least = dev_number(c, "least_l2"),
           expected = dev_name(c)[1] == '5' ? 0.0509207988 : least;
    assert_true(r.converged);
    double l2 = lam_developable_measure(f->arena, &s, 40, 10).l2;
    if (least < 1e-11)
      assert_true(l2 < 1e-9);
    else
      dev_close(dev_name(c), method == 1 ? "algorithm 1" : "algorithm 2", l2, expected, 1e-4);
  }
}

/* The surface scaled by s has K / s^2; Newton's method takes the same steps. */
static void the_result_does_not_depend_on_the_unit(void **state) {
  dev_fixture *f = *state;
  json_t *c = dev_case(f, "D3");
  lam_spline_surface s = dev_coons(f->arena, c), large = s;
  lam_vec3 *x = LAM_NEW(f->arena, lam_vec3, 16);
  for (int k = 0; k < 16; k++) x[k] = lam_scale(s.points[k], 1000);
  large.points = x;
  lam_developable_result r =
      lam_developable_solve(f->arena, &s, (lam_developable_options){.power = 2});
  lam_developable_result q =
      lam_developable_solve(f->arena, &large, (lam_developable_options){.power = 2});
  dev_close("D3", "||K|| at a thousand times the size", q.norm * 1e6, r.norm, 1e-10);
  for (int k = 0; k < 16; k++)
    assert_true(lam_distance(lam_scale(large.points[k], 1e-3), s.points[k]) < 1e-5);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(k_is_that_of_the_fundamental_forms),
      cmocka_unit_test(derivatives_of_k_agree_with_differences),
      DEV_TEST(derivatives_of_the_norm_agree_with_differences),
      DEV_TEST(coons_surfaces_are_those_of_the_formula),
      DEV_TEST(minima_are_reached),
      DEV_TEST(saddle_points_are_left),
      DEV_TEST(the_cone_is_found),
      DEV_TEST(algorithms_of_the_paper_agree),
      DEV_TEST(the_result_does_not_depend_on_the_unit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
