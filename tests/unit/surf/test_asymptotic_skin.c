/* Skins of patches over nets of asymptotic curves. */
#include "surf/asymptotic/asymptotic_skin.h"
#include "tests/unit/asymptotic_quad_fixture.h"

static lam_skin_vertex *vertices_of(quad_fixture *f, const json_t *c, int count[2]) {
  const json_t *points = json_object_get(c, "vertices");
  static const char *const names[] = {"tangent_u", "tangent_v", "ku", "kv"};
  count[0] = (int)json_array_size(points);
  count[1] = (int)json_array_size(json_array_get(points, 0));
  lam_skin_vertex *vertices = LAM_NEW(f->arena, lam_skin_vertex, count[0] * count[1]);
  for (int k = 0; k < count[0] * count[1]; k++) {
    size_t i = k / count[1], j = k % count[1];
    vertices[k].point = quad_vector(json_array_get(json_array_get(points, i), j));
    for (int d = 0; d < 2; d++) {
      vertices[k].tangent[d] =
          quad_vector(json_array_get(json_array_get(json_object_get(c, names[d]), i), j));
      vertices[k].curvature[d] =
          quad_number(json_array_get(json_object_get(c, names[2 + d]), i), j);
    }
    vertices[k].torsion = quad_number(json_array_get(json_object_get(c, "tau_u"), i), j);
  }
  return vertices;
}

/* Two patches along their common edge: the same points, the same normals. */
static void assert_smooth(const char *id, const lam_spline_surface *a, const lam_spline_surface *b,
                          int direction) {
  for (int g = 0; g <= 20; g++) {
    lam_vec3 p[3][3], q[3][3];
    double t = g / 20.0;
    quad_jet(a, direction ? t : 1, direction ? 1 : t, p);
    quad_jet(b, direction ? t : 0, direction ? 0 : t, q);
    double gap = lam_distance(p[0][0], q[0][0]);
    double angle = lam_angle(lam_cross(p[1][0], p[0][1]), lam_cross(q[1][0], q[0][1]));
    if (!(gap <= 1e-12)) fail_msg("%s: gap of %g m", id, gap);
    if (!(angle <= 1e-10)) fail_msg("%s: crease of %g rad", id, angle);
  }
}

/* Gaussian curvature is negative everywhere inside, as on every surface with two asymptotic
 * directions. Returns the least sine between the parameter lines. */
static double assert_saddle(const char *id, const lam_spline_surface *s) {
  double least = 1;
  for (int g = 0; g < 15 * 15; g++) {
    lam_vec3 jet[3][3];
    quad_jet(s, (g / 15 + 0.5) / 15, (g % 15 + 0.5) / 15, jet);
    lam_vec3 n = lam_cross(jet[1][0], jet[0][1]);
    double k = lam_dot(n, jet[2][0]) * lam_dot(n, jet[0][2]) - pow(lam_dot(n, jet[1][1]), 2);
    if (!(k < 0)) fail_msg("%s: K is not negative in a patch", id);
    least = fmin(least, lam_length(n) / lam_length(jet[1][0]) / lam_length(jet[0][1]));
  }
  return least;
}

/* The catenoid in asymptotic parameters, and a discrete asymptotic net with fitted tangents:
 * expected energies were computed independently. */
static void test_skins(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "skins.json"), *c;
  size_t number;
  assert_int_equal(json_array_size(cases), 2);
  json_array_foreach(cases, number, c) {
    const char *id = json_string_value(json_object_get(c, "id"));
    int count[2];
    lam_skin_vertex *vertices = vertices_of(f, c, count);
    int rows = count[0] - 1, columns = count[1] - 1;
    lam_asymptotic_patch *patches = LAM_NEW(f->arena, lam_asymptotic_patch, rows * columns);
    if (!lam_asymptotic_skin_make(f->arena, count, vertices, (lam_location){0}, &f->errors,
                                  patches))
      fail_msg("%s: %s", id, f->errors.first->text);
    double energy = 0, sine = 1;
    lam_quad_corners q = {.side = {{1, 1}, {1, 1}, {1, 1}, {1, 1}}}; /* no side is straight */
    for (int k = 0; k < rows * columns; k++) {
      quad_assert_asymptotic(id, &patches[k].surface, &q, 1e-10);
      sine = fmin(sine, assert_saddle(id, &patches[k].surface));
      energy += patches[k].energy;
      if (k / columns + 1 < rows)
        assert_smooth(id, &patches[k].surface, &patches[k + columns].surface, 0);
      if (k % columns + 1 < columns)
        assert_smooth(id, &patches[k].surface, &patches[k + 1].surface, 1);
    }
    quad_assert_close(id, "energy", energy, json_number_value(json_object_get(c, "energy")), 1e-8);
    quad_assert_close(id, "least sine", sine, json_number_value(json_object_get(c, "min_sine")),
                      1e-3);
  }
}

/* The discrete asymptotic net from its points alone. An independent fit stopped at the sum
 * 0.0105875700, with tangent planes up to 0.389 deg from the planes of the stars; the minimum lies
 * little below. */
static void test_fit(void **state) {
  quad_fixture *f = *state;
  json_t *c = json_array_get(quad_cases(f, "skins.json"), 1);
  int count[2];
  double start, tilt = 0;
  lam_skin_vertex *v = vertices_of(f, c, count);
  for (int k = 0; k < count[0] * count[1]; k++) v[k] = (lam_skin_vertex){.point = v[k].point};
  double sum = lam_asymptotic_skin_fit(f->arena, count, v, (lam_location){0}, &f->errors, &start);
  assert_true(start > 10 * sum);
  assert_true(sum <= 0.01058757 && sum > 0.01058);
  for (int i = 1; i + 1 < count[0]; i++)
    for (int j = 1; j + 1 < count[1]; j++) {
      int k = i * count[1] + j;
      lam_vec3 star = lam_cross(lam_sub(v[k + count[1]].point, v[k].point),
                                lam_sub(v[k + 1].point, v[k].point));
      tilt = fmax(tilt, lam_angle(star, lam_cross(v[k].tangent[0], v[k].tangent[1])));
    }
  assert_near(tilt * 180 / net_pi, 0.389, 0.02);
  lam_asymptotic_patch patches[16];
  assert_true(lam_asymptotic_skin_make(f->arena, count, v, (lam_location){0}, &f->errors, patches));
  lam_quad_corners q = {.side = {{1, 1}, {1, 1}, {1, 1}, {1, 1}}};
  for (int k = 0; k < 16; k++) {
    quad_assert_asymptotic("fitted", &patches[k].surface, &q, 1e-10);
    assert_saddle("fitted", &patches[k].surface);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_skins), QUAD_TEST(test_fit)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
