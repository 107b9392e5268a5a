/* Laying surfaces flat: energies, the development of a cone, disks of triangles. Energies come from
 * an independent program (see tests/cases/developable/boundaries.json). */
#include "developable_fixture.h"
#include "surf/flatten/flatten.h"

static const int grids[3] = {10, 20, 40};

static void energies_are_those_of_the_minimum(void **state) {
  dev_fixture *f = *state;
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) {
    lam_spline_surface s = dev_solved(f->arena, c);
    for (int k = 0; k < 3; k++) {
      lam_flat_mesh mesh = lam_flat_grid(f->arena, &s, grids[k], LAM_FLAT_CHORDS);
      lam_flattening flat = lam_flatten(f->arena, &mesh);
      double expected = json_number_value(json_array_get(json_object_get(c, "energy"), (size_t)k));
      assert_true(flat.converged);
      assert_int_equal(flat.flips, 0);
      dev_close(dev_name(c), "energy", flat.energy, expected, 1e-3);
      if (k == 2)
        dev_close(dev_name(c), "largest strain", flat.max_strain, dev_number(c, "strain_40"), 0.01);
    }
  }
}

/* The cone x^2 + y^2 = z^2 develops to polar coordinates: distance r from the apex, angle phi sin
 * 45 deg. Along u the angle falls and along v the distance grows, so the development is not
 * mirrored. */
static double cone_error(dev_fixture *f, const lam_spline_surface *s, int cells,
                         lam_flat_length length) {
  lam_flat_mesh mesh = lam_flat_grid(f->arena, s, cells, length);
  lam_flattening flat = lam_flatten(f->arena, &mesh);
  lam_vec2 *truth = LAM_NEW(f->arena, lam_vec2, mesh.vertex_count),
           *x = LAM_NEW(f->arena, lam_vec2, mesh.vertex_count);
  memcpy(x, flat.points, (size_t)mesh.vertex_count * sizeof *x);
  for (int v = 0; v < mesh.vertex_count; v++) {
    double r = lam_length(mesh.vertices[v]),
           angle = atan2(mesh.vertices[v].y, mesh.vertices[v].x) / sqrt(2);
    truth[v] = (lam_vec2){r * cos(angle), r * sin(angle)};
  }
  return lam_flat_align(mesh.vertex_count, truth, x);
}

/* Chords: second order, rms 1.05e-5 at 40 cells (independent program: 1.0529e-5). Lengths on the
 * surface: fourth order, at 40 cells below a nanometer on two meters. */
static void a_cone_develops_to_fourth_order(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D1"));
  dev_close("D1", "rms with chords", cone_error(f, &s, 40, LAM_FLAT_CHORDS), 1.052906990e-5, 1e-3);
  double e20 = cone_error(f, &s, 20, LAM_FLAT_GEODESICS),
         e40 = cone_error(f, &s, 40, LAM_FLAT_GEODESICS);
  if (e40 > 1e-9) fail_msg("rms distance %.3g m from the development of the cone", e40);
  if (e20 / e40 < 12 || e20 / e40 > 20)
    fail_msg("the error falls by %.3g from 20 to 40 cells, expected about 16", e20 / e40);
}

/* Conjugate gradients from the rectangle find the same minimum, but turn triangles over on D2. */
static void conjugate_gradients_agree_except_where_they_fold(void **state) {
  dev_fixture *f = *state;
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) {
    lam_spline_surface s = dev_solved(f->arena, c);
    lam_flat_mesh mesh = lam_flat_grid(f->arena, &s, 10, LAM_FLAT_CHORDS);
    lam_flattening flat = lam_flatten_conjugate(f->arena, &mesh, 20000);
    double expected = json_number_value(json_array_get(json_object_get(c, "energy"), 0));
    if (dev_name(c)[1] == '2')
      assert_true(flat.flips > 0 && flat.energy > 1e3 * expected);
    else
      dev_close(dev_name(c), "energy", flat.energy, expected, 1e-3);
  }
}

/* The same surface as a bare disk of triangles, from a start on a circle: the same minimum. */
static void a_disk_finds_the_minimum_from_a_circle(void **state) {
  dev_fixture *f = *state;
  static const char *const names[] = {"D2", "D3", "D5"};
  for (int k = 0; k < 3; k++) {
    json_t *c = dev_case(f, names[k]);
    lam_spline_surface s = dev_solved(f->arena, c);
    lam_flat_mesh grid = lam_flat_grid(f->arena, &s, 20, LAM_FLAT_CHORDS), disk;
    assert_true(lam_flat_disk(f->arena, grid.vertex_count, grid.vertices, NULL, grid.triangle_count,
                              grid.triangles, &disk));
    assert_int_equal(disk.edge_count, grid.edge_count);
    lam_flattening flat = lam_flatten(f->arena, &disk);
    assert_int_equal(flat.flips, 0);
    dev_close(names[k], "energy", flat.energy,
              json_number_value(json_array_get(json_object_get(c, "energy"), 1)), 1e-3);
    int *loop;
    assert_int_equal(lam_flat_boundary(f->arena, &disk, &loop), 80);
  }
}

static void what_is_no_disk_is_refused(void **state) {
  dev_fixture *f = *state;
  static const lam_vec3 x[6] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 0}, {3, 1, 0}};
  static const int closed[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                   bow[2][3] = {{0, 1, 2}, {1, 4, 5}};
  static const int fan[3][3] = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  lam_flat_mesh mesh;
  assert_false(lam_flat_disk(f->arena, 4, x, NULL, 4, closed, &mesh));
  assert_false(lam_flat_disk(f->arena, 6, x, NULL, 2, bow, &mesh));
  assert_false(lam_flat_disk(f->arena, 5, x, NULL, 3, fan, &mesh));
}

/* A sheet stretched by 1.5 one way has the ratio 1.5; turned and moved points are put back exactly.
 */
static void figures_of_known_maps(void **state) {
  (void)state;
  static const lam_vec3 x[3] = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}};
  static const int triangle[1][3] = {{0, 1, 2}};
  static const lam_vec2 flat[3] = {{0, 0}, {2, 0}, {0, 1}};
  lam_flat_mesh mesh = {
      .vertex_count = 3, .vertices = x, .triangle_count = 1, .triangles = triangle};
  double ratio;
  dev_near(lam_flat_anisotropy(&mesh, flat, &ratio), 1.5, 1e-14);
  dev_near(ratio, 1.5, 1e-14);
  lam_vec2 moved[3];
  for (int i = 0; i < 3; i++)
    moved[i] =
        (lam_vec2){5 + 0.6 * flat[i].x - 0.8 * flat[i].y, -2 + 0.8 * flat[i].x + 0.6 * flat[i].y};
  assert_true(lam_flat_align(3, flat, moved) < 1e-14);
  dev_near(moved[1].x, 2, 1e-14);
}

/* Largest ratio of singular values at 40 cells: parameter lines over the paper's rectangle, and the
 * flattening. */
static void textures_are_drawn_out_less_when_laid_flat_first(void **state) {
  dev_fixture *f = *state;
  static const struct {
    const char *name;
    double parameters, flat;
  } expected[] = {{"D1", 1.69, 1},
                  {"D3", 2.93, 1.0137},
                  {"D4", 1.36, 1.0016},
                  {"D6", 2.94, 1.0043},
                  {"D7", 2.65, 1.0018}};
  for (int k = 0; k < 5; k++) {
    lam_spline_surface s = dev_solved(f->arena, dev_case(f, expected[k].name));
    lam_flat_mesh mesh = lam_flat_grid(f->arena, &s, 40, LAM_FLAT_CHORDS);
    dev_near(lam_flat_anisotropy(&mesh, mesh.start, NULL), expected[k].parameters, 0.0051);
    dev_near(lam_flat_anisotropy(&mesh, lam_flatten(f->arena, &mesh).points, NULL),
             expected[k].flat, 1e-4);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      DEV_TEST(energies_are_those_of_the_minimum),
      DEV_TEST(a_cone_develops_to_fourth_order),
      DEV_TEST(conjugate_gradients_agree_except_where_they_fold),
      DEV_TEST(a_disk_finds_the_minimum_from_a_circle),
      DEV_TEST(what_is_no_disk_is_refused),
      cmocka_unit_test(figures_of_known_maps),
      DEV_TEST(textures_are_drawn_out_less_when_laid_flat_first),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
