/* Every measure of a net, where its value is known by hand, and the names of degenerate states. */
#include "net_fixture.h"

static const double root2 = 1.41421356237309504880, undefined = NAN;

static lam_measure measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, mesh->vertices, name);
}

static lam_vec3 turned(double i, double j) { /* net_plane turned about the x axis and moved */
  return lam_v3(i + 7, .6 * j - 3, .8 * j + 1);
}

/* A unit grid of 4 x 5 vertices in any plane: 31 edges of length 1, angles of 90 degrees, nothing
 * else. */
static void a_unit_grid(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *name;
    double value;
    long count;
  } rows[] = {
      /* undefined: flat, or no axis, no start, no reference given */
      {"star_planarity", 0, 6},
      {"face_planarity", 0, 12},
      {"angle_deviation", 0, 6},
      {"crossing_angle", 90, 6},
      {"turning_angle", 0, 6},
      {"edge_length", 1, 31},
      {"shortest_edge", 1, 1},
      {"foldovers", 0, 1},
      {"overlaps", 0, 1},
      {"flatness", 0, 1},
      {"circularity", 0, 12},
      {"conicality", 0, 6},
      {"cross_ratio", 0, 12},
      {"incircle_contact", 0, 31},
      {"edge_variation", 0, 1},
      {"opposite_edge_difference", 0, 12},
      {"star_sphericity", 0, 6},
      {"star_curvature", 0, 6},
      {"curvature_spread", 0, 1},
      {"circle_angle_deviation", 0, 6},
      {"turning_angle_u", 0, 6},
      {"turning_angle_v", 0, 6},
      {"edge_ratio", 1, 12},
      {"mean_curvature", 0, 6},
      {"gauss_curvature", 0, 6},
      {"curvature_ratio", undefined, 0},
      {"cotangent_mean_curvature", 0, 6},
      {"gauss_image_area", 0, 1},
      {"gauss_image_area_signed", 0, 1},
      {"angle_defect", 0, 6},
      {"principal_deviation", undefined, 0},
      {"distance_to_reference", undefined, 0},
      {"distance_from_reference", undefined, 0},
      {"opposite_angle", 0, 6},
      {"angle_spread", 0, 6},
      {"geodesic_error_u", 0, 6},
      {"geodesic_error_v", 0, 6},
      {"orthogonality", 0, 6},
      {"straightness_u", 0, 12},
      {"straightness_v", 0, 10},
      {"clairaut_u", undefined, 0},
      {"clairaut_v", undefined, 0},
      {"edge_variation_u", 0, 15},
      {"edge_variation_v", 0, 16},
      {"spacing_u", 0, 20},
      {"spacing_v", 0, 20},
      {"edge_strain", undefined, 0},
      {"shear_strain", undefined, 0},
      {"surface_gauss_curvature", undefined, 0},
      {"coverage", undefined, 0},
      {"parameter_distortion", 1, 12},
      {"parameter_stretch", 1, 12},
      {"parameter_compression", 1, 12},
  };
  lam_mesh meshes[2] = {net_grid(f->arena, 4, 5, net_plane), net_grid(f->arena, 4, 5, turned)};
  for (int i = 0; i < 2; i++) {
    lam_net net = net_built(f, &meshes[i]);
    int count;
    lam_measuring in = lam_measuring_of(f->arena, &net, meshes[i].vertices);
    lam_measure *all = lam_net_measure(&in, NULL, &count);
    assert_int_equal(count, sizeof rows /
                                sizeof *rows); /* every measure has a row here, but the slow ones */
    for (int k = 0; k < count; k++) {
      int r = 0;
      while (r < count && strcmp(all[k].name, rows[r].name) != 0) r++;
      if (r == count) fail_msg("%s has no row here", all[k].name);
      assert_int_equal(all[k].count, rows[r].count);
      if (rows[r].count == 0)
        assert_true(isnan(all[k].min) && isnan(all[k].max) && isnan(all[k].mean));
      if (rows[r].count == 0) continue;
      assert_near(all[k].min, rows[r].value, 1e-13);
      assert_near(all[k].max, rows[r].value, 1e-13);
      assert_near(all[k].mean, rows[r].value, 1e-13);
    }
  }
}

/* The neighbors of a star with arms of 1 raised by +h, -h, +h, -h: the plane stays, four points are
 * h away, the mean edge is sqrt(1 + h^2). */
static void a_star_out_of_plane(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  double h = .1;
  mesh.vertices[1].z = mesh.vertices[7].z = h;
  mesh.vertices[3].z = mesh.vertices[5].z = -h;
  lam_measure m = measured(f, &mesh, "star_planarity");
  assert_near(m.max, h / sqrt(1 + h * h), 1e-15);
  assert_int_equal(m.count, 1);
  /* opposite neighbors at equal height: each line turns by twice the slope */
  assert_near(measured(f, &mesh, "turning_angle").max, 2 * atan(h) * 180 / net_pi, 1e-12);
  assert_near(measured(f, &mesh, "turning_angle_u").max, 2 * atan(h) * 180 / net_pi, 1e-12);
  assert_near(measured(f, &mesh, "turning_angle_v").max, 2 * atan(h) * 180 / net_pi, 1e-12);
  mesh.vertices[3].z = mesh.vertices[5].z =
      0; /* family 0 runs through 1, 4, 7; family 1 through 3, 4, 5 */
  mesh.vertices[1].z = mesh.vertices[7].z = 0;
  mesh.vertices[7].y += h;
  assert_near(measured(f, &mesh, "turning_angle_u").max, atan(h) * 180 / net_pi, 1e-12);
  assert_near(measured(f, &mesh, "turning_angle_v").max, 0, 1e-12);
  assert_near(measured(f, &mesh, "crossing_angle").max, 90 - atan(h) / 2 * 180 / net_pi, 1e-12);
}

/* A center at height 1 over a ring in the plane: about its plane of best fit z = 1/5, it stands out
 * by 4/5. Any valence: the peaks of the cube, (1, 1, 1) over three neighbors in the plane x + y + z
 * = 1 is 2/sqrt 3 high, over a fit at a quarter. */
static void stars_of_any_valence(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  mesh.vertices[4].z = 1;
  assert_near(measured(f, &mesh, "star_planarity").max, .8 / root2, 1e-14);
  lam_mesh cube = net_cube(f->arena);
  lam_measure m = measured(f, &cube, "star_planarity");
  assert_int_equal(m.count, 8);
  assert_near(m.max, .75 * 2 / sqrt(3) / 2, 1e-14);
  assert_near(m.mean, m.max, 1e-14);
}

/* A unit square with one corner raised by h: d1 = (1,1,h), d2 = (-1,1,0); the distance of the
 * diagonals is |E.(d1 x d2)| / |d1 x d2| with E = (1,0,0), d1 x d2 = (-h, -h, 2). */
static void a_twisted_quad(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 2, 2, net_plane);
  double h = .3;
  mesh.vertices[3].z = h;
  assert_near(measured(f, &mesh, "face_planarity").max,
              h / sqrt(4 + 2 * h * h) / ((sqrt(2 + h * h) + root2) / 2), 1e-15);
  assert_near(measured(f, &mesh, "edge_length").max, sqrt(1 + h * h), 1e-15);
  assert_near(measured(f, &mesh, "edge_length").mean, (1 + sqrt(1 + h * h)) / 2, 1e-15);
  assert_near(measured(f, &mesh, "shortest_edge").max, 2 / (1 + sqrt(1 + h * h)), 1e-15);
}

static lam_vec3 sheared(double i, double j) { return lam_v3(i + .5 * j, sqrt(.75) * j, 0); }

/* Rhombi of 60 degrees. */
static void a_sheared_grid(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 5, 5, sheared);
  lam_net net = net_built(f, &mesh);
  assert_near(lam_net_measure_one(f->arena, &net, mesh.vertices, "crossing_angle").max, 60, 1e-12);
  static const char *const names[] = {"angle_deviation", NULL};
  int count;
  static const double targets[3] = {60, 90, 75};
  for (int i = 0; i < 3; i++) {
    lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
    in.target_angle = targets[i] * net_pi / 180;
    lam_measure *m = lam_net_measure(&in, names, &count);
    assert_int_equal(count, 1);
    assert_near(m->max, targets[i] - 60, 1e-12);
    assert_near(m->mean, targets[i] - 60, 1e-12);
  }
}

/* A strip folded back onto itself: the three edges across it are folded. A right-angled bend is
 * none. */
static void a_folded_net(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 5, 4, net_plane);
  for (int v = 0; v < 20; v++)
    if (mesh.vertices[v].x > 2)
      mesh.vertices[v].x = 4 - mesh.vertices[v].x, mesh.vertices[v].z = .1;
  lam_measure m = measured(f, &mesh, "foldovers");
  assert_near(m.max, 3, 0);
  assert_int_equal(m.count, 1);
  lam_mesh cube = net_cube(f->arena);
  assert_near(measured(f, &cube, "foldovers").max, 0, 0);
}

static lam_vec3 wave(double i, double j) { return lam_v3(i, j, (int)i % 2 ? .25 : -.25); }

/* Rows at +-1/4 over 0 <= x <= 7, 0 <= y <= 3 with the corners left out: the height is 1/4
 * everywhere, the variance of x over the 28 other vertices is (4 * 42 - 4 * 12.25) / 28 = 4.25; x
 * and z correlate slightly, so the fit is a little better than z = 0. */
static void flatness_is_thickness_over_length(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 8, 4, wave);
  double flat = measured(f, &mesh, "flatness").max;
  assert_below(flat, .25 / sqrt(4.25));
  assert_near(flat, .25 / sqrt(4.25), .006);
  mesh.vertices[0].z = mesh.vertices[3].z = mesh.vertices[28].z = mesh.vertices[31].z =
      9; /* corners belong to no star */
  assert_near(measured(f, &mesh, "flatness").max, flat, 1e-15);
  lam_mesh quad = net_grid(f->arena, 2, 2, net_plane); /* no stars at all: every vertex counts */
  quad.vertices[0].z = quad.vertices[3].z = .1, quad.vertices[1].z = quad.vertices[2].z = -.1;
  assert_near(measured(f, &quad, "flatness").max, .1 / .5, 1e-14);
}

/* What is not a number stays visible, wherever it comes. */
static void not_a_number_is_not_hidden(void **state) {
  net_fixture *f = *state;
  for (int v = 0; v < 9; v += 2) {
    lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
    mesh.vertices[v].z = NAN;
    assert_true(isnan(measured(f, &mesh, "edge_length").max));
    assert_true(isnan(measured(f, &mesh, "edge_length").mean));
    assert_true(isnan(measured(f, &mesh, "edge_length").min));
  }
}

/* A single quad has no star: its angles are undefined, not 0. */
static void what_no_element_has_is_undefined(void **state) {
  net_fixture *f = *state;
  lam_mesh quad = net_grid(f->arena, 2, 2, net_plane);
  lam_measure m = measured(f, &quad, "turning_angle");
  assert_int_equal(m.count, 0);
  assert_true(isnan(m.min) && isnan(m.max) && isnan(m.mean));
}

/* Cells of 1 x 1 stretched to 1 x 2.5. */
static void smallest_and_largest(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  for (int v = 0; v < 9; v++) mesh.vertices[v].y *= 2.5;
  lam_measure m = measured(f, &mesh, "edge_length");
  assert_near(m.min, 1, 1e-15);
  assert_near(m.max, 2.5, 1e-15);
  assert_near(m.mean, 1.75, 1e-15);
  assert_near(measured(f, &mesh, "edge_ratio").min, 2.5, 1e-15);
}

static const char *state_of(net_fixture *f, const lam_mesh *before, lam_vec3 (*move)(lam_vec3 x)) {
  lam_net net = net_built(f, before);
  lam_vec3 *after = LAM_NEW(f->arena, lam_vec3, before->vertex_count);
  for (int v = 0; v < before->vertex_count; v++) after[v] = move(before->vertices[v]);
  return lam_net_degenerate(f->arena, &net, before->vertices, after);
}

static lam_vec3 stay(lam_vec3 x) { return x; }
static lam_vec3 shrink(lam_vec3 x) { return lam_scale(x, .04); }
static lam_vec3 explode(lam_vec3 x) { return lam_scale(x, 25); }
static lam_vec3 flatten(lam_vec3 x) { return lam_v3(x.x, x.y, .01 * x.z); }
static lam_vec3 fold(lam_vec3 x) { return x.x > 2.5 ? lam_v3(5 - x.x, x.y, x.z + .2) : x; }
/* the second column next to the first, whose height is twice its own */
static lam_vec3 squeeze(lam_vec3 x) {
  return x.x > .5 && x.x < 1.5 ? lam_v3(.001, x.y, 2 * x.z) : x;
}
static lam_vec3 ruin(lam_vec3 x) {
  return x.x > 1.5 && x.x < 2.5 && x.y > .5 && x.y < 1.5 ? lam_v3(x.x, NAN, x.z) : x;
}
static lam_vec3 larger(lam_vec3 x) { return lam_scale(x, 3); }

static void degenerate_states_have_names(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 6, 6, net_saddle), plane = net_grid(f->arena, 6, 6, net_plane);
  static const struct {
    lam_vec3 (*move)(lam_vec3 x);
    const char *name;
  } rows[] = {{shrink, "shrunk"}, {explode, "flown apart"}, {flatten, "flattened"},
              {fold, "folded"},   {squeeze, "collapsed"},   {ruin, "not a number"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    const char *text = state_of(f, &mesh, rows[i].move);
    if (!text || strncmp(text, rows[i].name, strlen(rows[i].name)) != 0)
      fail_msg("%s instead of %s", text ? text : "nothing", rows[i].name);
  }
  assert_null(state_of(f, &mesh, stay));
  assert_null(state_of(f, &mesh, larger));
  assert_null(state_of(f, &plane, stay)); /* a plane that was a plane */
  assert_null(state_of(f, &plane, larger));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(a_unit_grid),
      NET_TEST(a_star_out_of_plane),
      NET_TEST(stars_of_any_valence),
      NET_TEST(a_twisted_quad),
      NET_TEST(a_sheared_grid),
      NET_TEST(a_folded_net),
      NET_TEST(flatness_is_thickness_over_length),
      NET_TEST(not_a_number_is_not_hidden),
      NET_TEST(what_no_element_has_is_undefined),
      NET_TEST(smallest_and_largest),
      NET_TEST(degenerate_states_have_names),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
