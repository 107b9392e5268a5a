/* Where nets come from: subdivision, samples of surfaces, noise. */
#include "net_fixture.h"

static lam_mesh catmull_clark(net_fixture *f, const lam_mesh *mesh) {
  lam_net net = net_built(f, mesh);
  return lam_net_catmull_clark(f->arena, &net);
}

/* One step of the cube [-1, 1]^3 by hand. Faces: their centers. Edges: ((0,1,1) + ((0,0,1) +
 * (0,1,0)) / 2) / 2 = (0, 3/4, 3/4). Vertices: (F + 2 E) / 3 with F = 1/3, E = 2/3: 5/9. */
static void catmull_clark_of_the_cube(void **state) {
  net_fixture *f = *state;
  lam_mesh cube = net_cube(f->arena), round = catmull_clark(f, &cube);
  assert_int_equal(round.vertex_count, 8 + 12 + 6);
  for (int v = 0; v < 26; v++) {
    lam_vec3 x = round.vertices[v];
    double size[3] = {fabs(x.x), fabs(x.y), fabs(x.z)}, sum = size[0] + size[1] + size[2];
    double most = fmax(size[0], fmax(size[1], size[2])),
           least = fmin(size[0], fmin(size[1], size[2]));
    if (v < 8)
      assert_near(lam_distance(x, lam_scale(cube.vertices[v], 5. / 9)), 0, 1e-15);
    else
      assert_near(sum, v < 20 ? 1.5 : 1, 1e-15);
    if (v >= 8) assert_near(most, v < 20 ? .75 : 1, 1e-15);
    if (v >= 8) assert_near(least, 0, 0);
  }
}

/* Limit points: (n^2 v + 4 sum e + sum f) / (n (n + 5)) over the ring of the first step. At a
 * corner (9 * 5/9 + 6 + 1) / 24 = 1/2; at the middle of a face (16 + 12 + 20/9) / 36 = 68/81. The
 * error shrinks by a factor 4 (regular) to 2.4 (valence 3) per step. */
static void catmull_clark_converges_to_its_limit(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_round_cube(f);
  for (int step = 0; step < 5; step++) mesh = catmull_clark(f, &mesh);
  for (int v = 0; v < 8; v++) assert_near(fabs(mesh.vertices[v].x), .5, 1e-3);
  for (int v = 20; v < 26; v++) assert_near(lam_length(mesh.vertices[v]), 68. / 81, 2e-4);
  lam_net net = net_built(f, &mesh);
  assert_int_equal(net.irregular_count, 8);
  assert_int_equal(net.mesh.vertex_count - net.edge_count + net.mesh.face_count, 2);
}

/* A plane grid with spacing 1 becomes the one with spacing 1/2, borders and corners included. */
static void both_schemes_keep_plane_grids(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 6, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_mesh fine[2] = {lam_net_catmull_clark(f->arena, &net), lam_net_four_point(f->arena, &net)};
  for (int scheme = 0; scheme < 2; scheme++) {
    lam_net refined = net_built(f, &fine[scheme]);
    assert_int_equal(refined.mesh.vertex_count, 7 * 11);
    assert_int_equal(refined.polyline_count, 7 + 11);
    bool seen[7 * 11] = {false};
    for (int v = 0; v < 77; v++) {
      lam_vec3 x = lam_scale(refined.mesh.vertices[v], 2);
      int i = (int)lround(x.x), j = (int)lround(x.y);
      assert_near(lam_distance(x, lam_v3(i, j, 0)), 0, 1e-14);
      assert_false(seen[11 * i + j]);
      seen[11 * i + j] = true;
    }
    for (int e = 0; e < refined.edge_count; e++) {
      lam_vec3 a = refined.mesh.vertices[refined.edges[e].vertex[0]],
               b = refined.mesh.vertices[refined.edges[e].vertex[1]];
      assert_near(fabs(b.x - a.x), refined.edges[e].family == 0 ? .5 : 0,
                  1e-14); /* families keep their direction */
    }
  }
}

static double bicubic(double x, double y) {
  return 1 + x - .3 * y + .2 * x * x * x - .1 * x * x * y * y * y + .05 * y * y -
         .02 * x * x * x * y * y * y;
}
static double biquadratic(double x, double y) {
  return 2 - x + .4 * y * y + .1 * x * x * y * y - .2 * x * x * y;
}
static lam_vec3 cubic_grid(double i, double j) {
  return lam_v3(i - 3, j - 3, bicubic(i - 3, j - 3));
}
static lam_vec3 quadratic_grid(double i, double j) {
  return lam_v3(i - 3, j - 3, biquadratic(i - 3, j - 3));
}

/* Four points reproduce cubics, the three at an end quadratics: exactly, over a 7 x 7 grid. */
static void four_point_reproduces_polynomials(void **state) {
  net_fixture *f = *state;
  lam_mesh cubic = net_grid(f->arena, 7, 7, cubic_grid),
           quadratic = net_grid(f->arena, 7, 7, quadratic_grid);
  lam_net nets[2] = {net_built(f, &cubic), net_built(f, &quadratic)};
  lam_mesh fine = lam_net_four_point(f->arena, &nets[0]),
           smooth = lam_net_four_point(f->arena, &nets[1]);
  int inner = 0;
  for (int v = 0; v < fine.vertex_count; v++) {
    lam_vec3 x = fine.vertices[v], y = smooth.vertices[v];
    assert_near(y.z, biquadratic(y.x, y.y), 1e-13);
    if (fabs(x.x) > 2 || fabs(x.y) > 2) continue;
    inner++;
    assert_near(x.z, bicubic(x.x, x.y), 1e-12);
  }
  assert_int_equal(inner, 9 * 9);
}

/* Old vertices keep index and place to the bit, on nets of every topology; the refined net has the
 * same Euler number, twice the boundary, and the same irregular vertices. */
static void four_point_keeps_old_vertices(void **state) {
  net_fixture *f = *state;
  lam_mesh meshes[] = {net_torus(f->arena, 5, 7, 3, 1),
                       net_tube(f->arena, 5, 3),
                       net_round_cube(f),
                       net_monkey(f, 3, 0),
                       net_monkey(f, 3, 1),
                       net_grid(f->arena, 2, 2, net_saddle),
                       net_grid(f->arena, 3, 2, net_saddle)};
  for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
    lam_net net = net_built(f, &meshes[i]);
    lam_mesh fine = lam_net_four_point(f->arena, &net);
    lam_net refined = net_built(f, &fine);
    assert_memory_equal(fine.vertices, meshes[i].vertices,
                        sizeof(lam_vec3) * (size_t)meshes[i].vertex_count);
    assert_int_equal(fine.vertex_count,
                     net.mesh.vertex_count + net.edge_count + net.mesh.face_count);
    assert_int_equal(fine.face_count, 4 * net.mesh.face_count);
    assert_int_equal(fine.vertex_count - refined.edge_count + fine.face_count,
                     net.mesh.vertex_count - net.edge_count + net.mesh.face_count);
    assert_int_equal(refined.irregular_count, net.irregular_count);
    assert_int_equal(refined.loop_count, net.loop_count);
    for (int l = 0; l < net.loop_count; l++)
      assert_int_equal(refined.loops[l].count, 2 * net.loops[l].count);
  }
}

/* On a circle of n points the rule puts a new point at radius (9 cos(pi/n) - cos(3 pi/n)) / 8:
 * 0.99755 for 12. */
static void four_point_goes_around_the_seam(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_tube(f->arena, 12, 4);
  lam_net net = net_built(f, &mesh);
  lam_mesh fine = lam_net_four_point(f->arena, &net);
  double radius = lam_length(lam_v3(mesh.vertices[0].x, mesh.vertices[0].y, 0));
  for (int e = 0; e < net.edge_count; e++) {
    lam_vec3 x = fine.vertices[net.mesh.vertex_count + e];
    if (net.edges[e].family != 0 || fabs(x.z + 1.5) > 1e-9) continue;
    assert_near(hypot(x.x, x.y) / radius, (9 * cos(net_pi / 12) - cos(net_pi / 4)) / 8, 1e-14);
  }
}

/* SplitMix64 with the seed 1234567: the published first outputs are 6457827717110365317,
 * 3203168211198807973, 9817491932198370423. */
static void noise_is_the_same_everywhere(void **state) {
  net_fixture *f = *state;
  lam_mesh a = net_grid(f->arena, 9, 9, net_plane), b = net_grid(f->arena, 9, 9, net_plane);
  lam_mesh c = net_grid(f->arena, 9, 9, net_plane), still = net_grid(f->arena, 9, 9, net_plane);
  lam_mesh_perturb(&a, .25, 1234567);
  lam_mesh_perturb(&b, .25, 1234567);
  lam_mesh_perturb(&c, .25, 1234568);
  assert_memory_equal(a.vertices, b.vertices, sizeof(lam_vec3) * 81);
  static const uint64_t first[3] = {6457827717110365317u, 3203168211198807973u,
                                    9817491932198370423u};
  double d[3];
  for (int i = 0; i < 3; i++) d[i] = .25 * (2 * ((double)(first[i] >> 11) * 0x1p-53) - 1);
  assert_near(lam_distance(a.vertices[0], lam_v3(d[0], d[1], d[2])), 0, 1e-16);
  double longest = 0, apart = 0;
  for (int v = 0; v < 81; v++) {
    longest = fmax(longest, lam_distance(a.vertices[v], still.vertices[v]));
    apart = fmax(apart, lam_distance(a.vertices[v], c.vertices[v]));
  }
  assert_true(longest <= .25 && longest > .2 && apart > .2);
  lam_mesh_perturb(&b, 0, 9);
  assert_memory_equal(a.vertices, b.vertices, sizeof(lam_vec3) * 81);
}

/* Around the flat point of the monkey saddle: the middle is the first vertex, every vertex lies on
 * the surface z = Re(2 w^3 / 3), and all sectors are copies: z changes sign from one to the next.
 */
static void branched_charts_close_around_the_flat_point(void **state) {
  net_fixture *f = *state;
  enum { n = 4, per_sector = n * (n + 1) };
  lam_mesh mesh = net_monkey(f, n, 0);
  assert_near(lam_length(mesh.vertices[0]), 0, 0);
  for (int v = 1; v < mesh.vertex_count; v++) {
    lam_vec3 x = mesh.vertices[v], y = mesh.vertices[1 + (v - 1 + per_sector) % (6 * per_sector)];
    assert_near(y.z, -x.z, 1e-14);
    double c = .5, s = sqrt(.75); /* a sixth of a turn about z */
    assert_near(hypot(y.x - (c * x.x - s * x.y), y.y - (s * x.x + c * x.y)), 0, 1e-14);
  }
  lam_net net = net_built(f, &mesh);
  assert_int_equal(net.ring_start[1] - net.ring_start[0], 6);
}

/* The catenoid closes: as many vertices around as cells, no seam. */
static void closed_surfaces_have_no_seam(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_sampled(f, "catenoid", "{}", LAM_CHART_PRINCIPAL, 12, 5, 0);
  net_no_errors(f, "catenoid");
  lam_net net = net_built(f, &mesh);
  assert_int_equal(net.loop_count, 2);
  assert_int_equal(net.irregular_count, 0);
  double ratio = 0;
  for (int e = 0; e < net.edge_count; e++)
    ratio = fmax(ratio, lam_distance(mesh.vertices[net.edges[e].vertex[0]],
                                     mesh.vertices[net.edges[e].vertex[1]]));
  assert_below(ratio, 4 * lam_net_mean_edge(&net, mesh.vertices));
}

static void starts_that_cannot_be_are_refused(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *surface, *keys;
    lam_chart chart;
    int n, m, hole;
    const char *why;
  } rows[] = {
      {"enneper", "{order: 2}", LAM_CHART_ASYMPTOTIC, 4, 5, 0, "both numbers must be equal"},
      {"enneper", "{order: 2}", LAM_CHART_ASYMPTOTIC, 4, 4, 4, "at most 3"},
      {"enneper", "{order: 1}", LAM_CHART_ASYMPTOTIC, 4, 4, 1, "no flat point"},
      {"sphere", "{}", LAM_CHART_ASYMPTOTIC, 4, 4, 0, "no asymptotic lines"},
      {"catenoid", "{}", LAM_CHART_PRINCIPAL, 2, 4, 0, "at least 3"},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    net_sampled(f, rows[i].surface, rows[i].keys, rows[i].chart, rows[i].n, rows[i].m,
                rows[i].hole);
    if (f->errors.count != 1) fail_msg("%s: %d errors", rows[i].surface, f->errors.count);
    if (!strstr(f->errors.first->text, rows[i].why))
      fail_msg("\"%s\" does not say \"%s\"", f->errors.first->text, rows[i].why);
  }
}

/* size: the larger horizontal extent; ground: the lowest point at 0; rotate: a quarter turn about x
 * takes y to z. */
static void placing_scales_turns_and_grounds(void **state) {
  net_fixture *f = *state;
  lam_row row = {.head = lam_registry_find(&lam_surfaces, "enneper")};
  row.params = net_params(f, row.head->keys, row.head->params_size, "{}");
  lam_surface surface = lam_surface_make(f->arena, &row, &f->errors);
  lam_placement_keys plain = {0}, placed = {.size = 7,
                                            .size_given = true,
                                            .rotate = {net_pi / 2, 0, 0},
                                            .ground = true};
  lam_mesh a, b;
  int grid[2] = {6, 6};
  assert_true(lam_net_start(f->arena, &surface, LAM_CHART_NATURAL, grid, 0, &plain,
                            (lam_location){0}, &f->errors, &a, NULL));
  assert_true(lam_net_start(f->arena, &surface, LAM_CHART_NATURAL, grid, 0, &placed,
                            (lam_location){0}, &f->errors, &b, NULL));
  lam_vec3 low = {9, 9, 9}, high = {-9, -9, -9};
  for (int v = 0; v < b.vertex_count; v++) {
    low = lam_v3(fmin(low.x, b.vertices[v].x), fmin(low.y, b.vertices[v].y),
                 fmin(low.z, b.vertices[v].z));
    high = lam_v3(fmax(high.x, b.vertices[v].x), fmax(high.y, b.vertices[v].y), 0);
  }
  assert_near(low.z, 0, 0);
  assert_near(fmax(high.x - low.x, high.y - low.y), 7, 1e-13);
  double scale = (b.vertices[1].x - b.vertices[0].x) / (a.vertices[1].x - a.vertices[0].x);
  for (int v = 0; v < b.vertex_count; v++) {
    lam_vec3 d = lam_scale(lam_sub(a.vertices[v], a.vertices[0]), scale),
             e = lam_sub(b.vertices[v], b.vertices[0]);
    assert_near(lam_distance(e, lam_v3(d.x, -d.z, d.y)), 0, 1e-13);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(catmull_clark_of_the_cube),
      NET_TEST(catmull_clark_converges_to_its_limit),
      NET_TEST(both_schemes_keep_plane_grids),
      NET_TEST(four_point_reproduces_polynomials),
      NET_TEST(four_point_keeps_old_vertices),
      NET_TEST(four_point_goes_around_the_seam),
      NET_TEST(noise_is_the_same_everywhere),
      NET_TEST(branched_charts_close_around_the_flat_point),
      NET_TEST(closed_surfaces_have_no_seam),
      NET_TEST(starts_that_cannot_be_are_refused),
      NET_TEST(placing_scales_turns_and_grounds),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
