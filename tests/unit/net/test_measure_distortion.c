/* How much nets are drawn out against their pictures in the plane, and the color maps of it; the
 * curvature of the surface that a net lies on. */
#include "net_fixture.h"

#include "formats/format.h"
#include "formats/plot/color_scale.h"
#include "net/measures/layout.h"
#include "net/measures/measure_map.h"
#include "surf/spline/spline_surface.h"
#include "tests/unit/design_fixture.h"

extern const lam_format lam_format_plot, lam_format_plot_gltf;

static lam_measure measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, net.mesh.vertices, name);
}

/* Parallelograms with sides of 1 at 50 degrees, seen from unit squares: s1^2 + s2^2 = 2, s1 s2 =
 * sin 50. The net is flat as it is. */
static lam_vec3 sheared(double i, double j) {
  double angle = 50 * net_pi / 180;
  return lam_v3(i + j * cos(angle), j * sin(angle) * .6, j * sin(angle) * .8);
}

static void a_sheared_plane(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 6, 5, sheared);
  double area = sin(50 * net_pi / 180), sum = sqrt(2 + 2 * area), difference = sqrt(2 - 2 * area);
  const double s1 = (sum + difference) / 2, s2 = (sum - difference) / 2;
  const struct {
    const char *name;
    double value;
  } expected[] = {{"parameter_stretch", s1},         {"parameter_compression", s2},
                  {"parameter_distortion", s1 / s2}, {"flattening_stretch", 1},
                  {"flattening_compression", 1},     {"flattening_distortion", 1}};
  for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
    lam_measure m = measured(f, &mesh, expected[k].name);
    assert_int_equal(m.count, 20);
    assert_near(m.min, expected[k].value, 1e-10);
    assert_near(m.max, expected[k].value, 1e-10);
  }
}

/* Strips of 1 and 3 wide: the rectangle has cells of 2, so that the net is half as wide here, one
 * and a half times there. */
static lam_vec3 uneven(double i, double j) { return lam_v3(i < 1 ? i : 1 + 3 * (i - 1), j, 0); }

static void uneven_cells(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 4, uneven);
  lam_measure s1 = measured(f, &mesh, "parameter_stretch"),
              s2 = measured(f, &mesh, "parameter_compression");
  assert_near(s1.min, 1, 1e-14);
  assert_near(s1.max, 1.5, 1e-14);
  assert_near(s2.min, .5, 1e-14);
  assert_near(s2.max, 1, 1e-14);
}

/* Closed nets have neither picture; an L has no rectangle but can be laid flat. */
static lam_vec3 flat(double i, double j) { return lam_v3(i, j, 0); }

static void nets_without_a_picture(void **state) {
  net_fixture *f = *state;
  lam_mesh ring = lam_mesh_grid(f->arena, 12, 3, true, false);
  for (int v = 0; v < 36; v++)
    ring.vertices[v] = lam_v3(cos(v / 3 * net_pi / 6), sin(v / 3 * net_pi / 6), v % 3);
  assert_int_equal(measured(f, &ring, "flattening_distortion").count, 0);
  assert_int_equal(measured(f, &ring, "parameter_distortion").count, 0);
  lam_mesh square = net_grid(f->arena, 4, 4, flat), corner = square;
  corner.face_count = 0;
  corner.vertex_count = 12;
  corner.faces = (int(*)[4])lam_arena_alloc(f->arena, 9, sizeof *corner.faces);
  for (int k = 0; k < square.face_count;
       k++) { /* without the last row of the last column: vertices 0 to 11 and three */
    bool kept = true;
    for (int c = 0; c < 4; c++) kept &= square.faces[k][c] < 14;
    if (kept) memcpy(corner.faces[corner.face_count++], square.faces[k], sizeof *corner.faces);
  }
  corner.vertex_count = 14;
  assert_int_equal(corner.face_count, 7);
  assert_int_equal(measured(f, &corner, "parameter_distortion").count, 0);
  lam_measure m = measured(f, &corner, "flattening_distortion");
  assert_int_equal(m.count, 7);
  assert_near(m.max, 1, 1e-10);
}

/* ---- designs ---- */

/* Against the surface's derivatives in the middle of every face: the map from the rectangle takes
 * its sides to x_u, x_v. A face is a 32nd of the surface wide, and its medians differ from the
 * derivatives by the square of that. */
static void parameter_distortion_is_that_of_the_derivatives(void **state) {
  net_fixture *f = *state;
  lam_model model = design_built(f->arena, "templates/designs/distortion-comparison.yaml", 0, NULL);
  const lam_map *map = &model.maps[1];
  assert_string_equal(map->summary.name, "parameter_distortion");
  assert_int_equal(map->count, 32 * 32);
  const lam_nurbs *nurbs = lam_nurbs_make(f->arena, model.surfaces);
  double w = map->layout[33 * 33 - 1].x - map->layout[0].x,
         h = map->layout[33 * 33 - 1].y - map->layout[0].y;
  for (int face = 0; face < map->count; face++) {
    const int *c = model.net->faces[face];
    double u = 0, v = 0;
    for (int k = 0; k < 4; k++) u += c[k] / 33 / 128., v += c[k] % 33 / 128.;
    lam_jet jet;
    lam_nurbs_eval(nurbs, u, v, &jet);
    double E = lam_dot(jet.u, jet.u) / w / w, F = lam_dot(jet.u, jet.v) / w / h,
           G = lam_dot(jet.v, jet.v) / h / h;
    double root =
        hypot(E - G, 2 * F); /* squares of the singular values: eigenvalues of the first form */
    assert_near(map->values[face], sqrt((E + G + root) / (E + G - root)), .03);
  }
}

/* Both maps of distortion share their colors, the curvature does not; each shows what it compares
 * the net with. */
static void maps_are_compared_on_one_scale(void **state) {
  net_fixture *f = *state;
  const char *const plots = "plots=[flattening_distortion, parameter_distortion, gauss_curvature]";
  lam_model model =
      design_built(f->arena, "templates/designs/distortion-comparison.yaml", 1, &plots);
  const lam_map *m = model.maps;
  assert_true(m[0].range[0] == fmin(m[0].summary.min, m[1].summary.min));
  assert_true(m[0].range[1] == fmax(m[0].summary.max, m[1].summary.max));
  assert_memory_equal(m[0].range, m[1].range, sizeof m[0].range);
  assert_true(m[2].range[0] == 0 && m[2].range[1] == 0 && !m[2].layout);
  lam_color_scale a = lam_map_scale(&m[0]), b = lam_map_scale(&m[1]);
  assert_true(a.low == b.low && a.high == b.high && !a.constant && !b.constant);
  for (int i = 0; i < 3; i++) {
    lam_text out = {.arena = f->arena};
    assert_int_equal(lam_format_plot.write(&model, i, &out), LAM_OK);
    int faces = 0;
    for (const char *at = out.data; (at = strstr(at, " class=\"line\"/>")); at++) faces++;
    assert_int_equal(faces, (i < 2 ? 2 : 1) * 1024);
    assert_true((strstr(out.data, "<g class=\"layout\"") != NULL) == (i < 2));
    lam_text scene = {
        .arena = f->arena}; /* faces have their own four vertices, in space and in the layout */
    assert_int_equal(lam_format_plot_gltf.write(&model, i, &scene), LAM_OK);
    scene.data[scene.length - 1] = 0;
    const char *expected = i < 2 ? "\"count\":8192" : "\"count\":1089";
    if (!strstr(scene.data + 20, expected)) fail_msg("the scene has no %s", expected);
  }
}

/* max|K| of the surface of least mean square: .276873, at a corner (independent program, see
 * tests/cases/developable/boundaries.json). Twice the size has a quarter of the curvature. */
static void the_curvature_of_the_surface_is_that_of_its_size(void **state) {
  net_fixture *f = *state;
  static const char path[] = "templates/designs/li-deng-general.yaml";
  const char *const at_4[] = {"surface.size=4 m", "surface.rotate=[30 deg, 0, 0]"},
                    *const at_8[] = {"surface.size=8 m"};
  double K[3];
  lam_model models[3] = {design_built(f->arena, path, 0, NULL),
                         design_built(f->arena, path, 1, at_4),
                         design_built(f->arena, path, 1, at_8)};
  for (int k = 0; k < 3; k++) {
    assert_string_equal(models[k].maps[0].summary.name, "surface_gauss_curvature");
    assert_int_equal(models[k].maps[0].summary.count, 33 * 33);
    K[k] = fmax(fabs(models[k].maps[0].summary.min), fabs(models[k].maps[0].summary.max));
  }
  assert_near(K[0], .276873, 1e-5);
  assert_near(K[1] / K[2], 4, 1e-9);
}

/* A net that is moved off its parameter lines no longer tells where on the surface its vertices
 * are. */
static void a_moved_net_has_no_surface(void **state) {
  net_fixture *f = *state;
  const char *const moved[] = {"net={kind: free, grid: [8, 8], noise: 0.1}"},
                    *const kept[] = {"net={kind: free, grid: [8, 8]}"};
  static const char path[] = "templates/designs/li-deng-general.yaml";
  assert_int_equal(design_built(f->arena, path, 1, kept).maps[0].summary.count, 81);
  assert_int_equal(design_built(f->arena, path, 1, moved).maps[0].summary.count, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(a_sheared_plane),
      NET_TEST(uneven_cells),
      NET_TEST(nets_without_a_picture),
      NET_TEST(parameter_distortion_is_that_of_the_derivatives),
      NET_TEST(maps_are_compared_on_one_scale),
      NET_TEST(the_curvature_of_the_surface_is_that_of_its_size),
      NET_TEST(a_moved_net_has_no_surface),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
