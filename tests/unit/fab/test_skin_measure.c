/* What is measured of skins, and the plates along a boundary: on patches whose seams, curvatures
 * and frames are known in closed form. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/parts/skin.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

static const double c = 0.3;
static const double linear[4] = {0, 0, 1, 1}, quadratic[6] = {0, 0, 0, 1, 1, 1};

/* Two bilinear patches side by side: z = c u v over [0,1]^2, and z = c (2 - u) v over [1,2] x
 * [0,1]. The second one is turned by half a turn in its parameters when asked for. */
static void two_patches(lam_spline_surface s[2], bool turned) {
  static const lam_vec3 first[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, .3}};
  static const lam_vec3 second[4] = {{1, 0, 0}, {1, 1, .3}, {2, 0, 0}, {2, 1, 0}};
  static const lam_vec3 half_turn[4] = {{2, 1, 0}, {2, 0, 0}, {1, 1, .3}, {1, 0, 0}};
  for (int k = 0; k < 2; k++)
    s[k] = (lam_spline_surface){
        "s", {1, 1}, {2, 2}, {linear, linear}, k == 0 ? first : turned ? half_turn : second, NULL};
}

/* Along the seam u = 1 the normals are (-c v, -c, 1) and (c v, -c, 1): the jump is 2 atan(c v /
 * sqrt(1 + c^2)), largest at v = 1, sampled at v = 0, 1/16 ... 1. The sides v = 1 climb by c and
 * fall by c: a kink of 2 atan c; those at v = 0 run straight on. Every one of the four ends is
 * looked at. */
static void seams_and_kinks(void **state) {
  for (int turned = 0; turned < 2; turned++) {
    lam_spline_surface s[2];
    two_patches(s, turned);
    lam_skin_mesh mesh = lam_skin_mesh_make(*state, 2, s, 3);
    lam_skin_facts f = lam_skin_measure(*state, &mesh, s);
    double sum = 0;
    for (int g = 0; g < 17; g++) sum += 2 * atan(c * g / 16 / sqrt(1 + c * c)) / 17;
    assert_int_equal(f.seams, 1);
    assert_near(f.gap, 0, 1e-15);
    assert_near(f.jump, 2 * atan(c / sqrt(1 + c * c)), 1e-12);
    assert_near(f.jump_sum, sum, 1e-7); /* the jump at v = 0 is 0 to the root of rounding */
    assert_int_equal(f.joints, 4);
    assert_near(f.kink, 2 * atan(c), 1e-12);
  }
}

/* Straight sides are asymptotic curves. K = -c^2 / (1 + c^2 (u^2 + v^2))^2; the parameter lines
 * (1, 0, c v) and (0, 1, c u) have the sine sqrt(1 + c^2 (u^2 + v^2)) over the product of their
 * lengths; the bending energy of a patch is 2 x_uv^2 = 2 c^2. Samples are at 1/16, 3/16 ...
 * 15/16. */
static void curvature_and_energy(void **state) {
  lam_spline_surface s[2];
  two_patches(s, false);
  lam_skin_mesh mesh = lam_skin_mesh_make(*state, 2, s, 2);
  lam_skin_facts f = lam_skin_measure(*state, &mesh, s);
  double q = c * c * 225 / 256, near = c * c / 256;
  assert_int_equal(f.sides, 8);
  assert_int_equal(f.exact, 8);
  assert_near(f.slant, 0, 1e-12);
  assert_near(f.slant_sum, 0, 1e-12);
  assert_int_equal(f.samples, 2 * 64);
  assert_int_equal(f.domes, 0);
  /* the second patch is the first one mirrored: u runs from its high side */
  assert_near(f.largest_k, -c * c / pow(1 + 2 * q, 2), 1e-12);
  assert_near(f.least_k, -c * c / pow(1 + 2 * near, 2), 1e-12);
  assert_near(f.least_sine, sqrt(1 + 2 * q) / (1 + q), 1e-12);
  assert_near(f.energy, 4 * c * c, 1e-12);
  assert_near(f.largest_energy, 2 * c * c, 1e-12);
}

/* A patch over [0,1]^2 with control points at z = a_i + b_j. */
static lam_spline_surface quadric(lam_arena *arena, double a, double b) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 9);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      points[3 * i + j] = lam_v3(.5 * i, .5 * j, (i == 2 ? a : 0) + (j == 2 ? b : 0));
  return (lam_spline_surface){"s", {2, 2}, {3, 3}, {quadratic, quadratic}, points, NULL};
}

/* z = (u^2 - v^2)/2: with w^2 = 1 + u^2 + v^2 the curvature is K = -1/w^4, and along u the normal
 * curvature 1 / (w (1 + u^2)), so that |k_n| / sqrt(-K) = w / (1 + u^2); likewise along v. At the
 * sides v = 0 and u = 0 that is 1/sqrt(1 + t^2), at v = 1 and u = 1 sqrt(2 + t^2) / (1 + t^2). */
static void slants_of_a_saddle(void **state) {
  lam_spline_surface s = quadric(*state, .5, -.5);
  lam_skin_mesh mesh = lam_skin_mesh_make(*state, 1, &s, 1);
  lam_skin_facts f = lam_skin_measure(*state, &mesh, &s);
  double sum = 0;
  for (int g = 1; g < 16; g++) {
    double t2 = g * g / 256.;
    sum += 2 * (1 / sqrt(1 + t2) + sqrt(2 + t2) / (1 + t2)) / 15;
  }
  assert_int_equal(f.sides, 4);
  assert_int_equal(f.exact, 0);
  assert_near(f.slant, sqrt(2 + 1. / 256) / (1 + 1. / 256), 1e-12);
  assert_near(f.slant_sum, sum, 1e-10);
  assert_near(f.energy, 2, 1e-12); /* z_uu^2 + z_vv^2 */
  assert_int_equal(f.seams + f.joints, 0);
}

/* z = (u^2 + v^2)/2 curls everywhere: K = 1/w^4 > 0. */
static void domes_are_counted(void **state) {
  lam_spline_surface s = quadric(*state, .5, .5);
  lam_skin_mesh mesh = lam_skin_mesh_make(*state, 1, &s, 1);
  lam_skin_facts f = lam_skin_measure(*state, &mesh, &s);
  assert_int_equal(f.domes, 64);
  assert_near(f.largest_k, pow(1 + 2. / 256, -2), 1e-12);
}

/* Facets and pieces: 2 patches of 3 x 3 facets share 4 points of their seam; a third patch lies far
 * away. A shell of a plane square, from 0.1 m below to 0.3 m above. */
static void patches_share_their_points(void **state) {
  static const lam_vec3 far[4] = {{5, 0, 1}, {5, 2, 1}, {8, 0, 1}, {8, 2, 1}};
  lam_spline_surface s[3];
  int piece[3];
  two_patches(s, true);
  s[2] = (lam_spline_surface){"s", {1, 1}, {2, 2}, {linear, linear}, far, NULL};
  lam_skin_mesh mesh = lam_skin_mesh_make(*state, 3, s, 3);
  assert_int_equal(mesh.point_count, 16 + 12 + 16);
  assert_int_equal(lam_skin_pieces(*state, &mesh, piece), 2);
  assert_true(piece[0] == 0 && piece[1] == 0 && piece[2] == 1);
  static const int expected[3][4] = {{-1, -1, -1, 1}, {-1, -1, -1, 0}, {-1, -1, -1, -1}};
  for (int k = 0; k < 12; k++)
    assert_int_equal(mesh.neighbors[k / 4][k % 4], expected[k / 4][k % 4]);
  lam_trimesh solid = lam_skin_shell(*state, &mesh, piece, 1, -.1, .3);
  lam_vec3 min, max;
  lam_points_bounds(solid.vertices, solid.vertex_count, &min, &max);
  assert_near(lam_trimesh_volume(&solid), 6 * .4, 1e-12);
  assert_near(min.z, .9, 1e-15);
  assert_near(max.z, 1.3, 1e-15);
  assert_int_equal(solid.triangle_count, 2 * 18 + 4 * 6);
  lam_part part = {.solid = lam_skin_shell(*state, &mesh, piece, 0, -.1, .3)};
  assert_true(lam_part_is_sound(*state, &part));
}

/* Knots may begin anywhere: here u from 2 to 5 and v from -1 to 3, over [0, 3] x [0, 4]. */
static const double shifted[2][4] = {{2, 2, 5, 5}, {-1, -1, 3, 3}};
static const lam_vec3 field[4] = {{0, 0, 0}, {0, 4, 0}, {3, 0, 0}, {3, 4, 0}};
static const lam_spline_surface elsewhere = {"s",   {1, 1}, {2, 2}, {shifted[0], shifted[1]},
                                             field, NULL};

static void knots_may_begin_anywhere(void **state) {
  lam_skin_mesh mesh = lam_skin_mesh_make(*state, 1, &elsewhere, 4);
  for (int k = 0; k < 25; k++) {
    lam_vec3 p = mesh.points[mesh.grid[k]];
    assert_near(lam_distance(p, lam_v3(.75 * (k / 5), k % 5, 0)), 0, 1e-14);
  }
}

/* Two by two faces and a tab of one face, whose corners are the first vertices: no cell of 2 x 2
 * starts there, but one does at the next corners. The tab stays uncovered. */
static void cells_start_where_they_can(void **state) {
  lam_mesh mesh = {11, LAM_NEW(*state, lam_vec3, 11), 5, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(*state, 5, sizeof *mesh.faces);
  static const int faces[5][4] = {
      {0, 2, 3, 1}, {2, 5, 6, 3}, {3, 6, 7, 4}, {5, 8, 9, 6}, {6, 9, 10, 7}};
  memcpy(mesh.faces, faces, sizeof faces);
  for (int v = 0; v < 11; v++) {
    double x = v < 2 ? -1 : (v - 2) / 3, y = v < 2 ? v : (v - 2) % 3;
    mesh.vertices[v] = lam_v3(x, y, .1 * x * y);
  }
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_skin_net cells = lam_skin_net_make(*state, shop.net, 2);
  assert_int_equal(cells.cell_count, 1);
  assert_int_equal(cells.uncovered, 1);
  assert_int_equal(cells.irregular, 0);
  int back, corners = 0;
  for (int k = 0; k < 4; k++) corners += 1 << cells.cells[0].vertex[k];
  assert_int_equal(corners, 1 << 2 | 1 << 4 | 1 << 8 | 1 << 10);
  /* along its first side, edge by edge */
  int v = lam_skin_walk(shop.net, cells.sides[0][0][0], cells.sides[0][0][1], 2, &back);
  assert_int_equal(v, cells.cells[0].vertex[1]);
  assert_int_equal(lam_skin_walk(shop.net, v, back, 2, &back), cells.cells[0].vertex[0]);
}

/* On z = u v the conormal is (-v, -u, 1), linear along the lines: over an edge of 2/3 it changes by
 * 2/3, at all vertices of a net with lines of four vertices only. (Lengths of conormals are relaxed
 * from estimates: within 2 %.) */
static lam_vec3 saddle(double u, double v) { return lam_v3(u, v, u * v); }

static void short_lines_have_slopes_too(void **state) {
  lam_mesh mesh = fixture_grid(*state, 4, 4, saddle);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_skin_net cells = lam_skin_net_make(*state, shop.net, 1);
  assert_int_equal(cells.cell_count, 9);
  for (int v = 0; v < 16; v++)
    for (int d = 0; d < 2; d++)
      assert_near_named(lam_length(cells.vertices[v].slope[d]), 2. / 3, .014, "slope");
}

/* The catenoid in asymptotic parameters, p = (u + v)/2 and q = (v - u)/2. */
static lam_vec3 catenoid(double u, double v) {
  double p = (u + v) / 2, q = (v - u) / 2;
  return lam_v3(cosh(p) * cos(q), cosh(p) * sin(q), p);
}

/* Half a turn about the x axis takes (u, v) to (-u, -v): slopes are as long there, also near both
 * ends of a line, where the five vertices of a polynomial are shifted inward. */
static void slopes_are_symmetric(void **state) {
  lam_mesh mesh = fixture_grid(*state, 9, 9, catenoid);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_skin_net cells = lam_skin_net_make(*state, shop.net, 1);
  for (int v = 0; v < 81; v++) {
    const lam_vec3 *a = cells.vertices[v].slope, *b = cells.vertices[80 - v].slope;
    double p[2] = {lam_length(a[0]), lam_length(a[1])}, q[2] = {lam_length(b[0]), lam_length(b[1])};
    assert_near(fmax(p[0], p[1]), fmax(q[0], q[1]), 1e-9);
    assert_near(fmin(p[0], p[1]), fmin(q[0], q[1]), 1e-9);
  }
}

/* On a torus no line ends: cells start anywhere, and take all 6 x 4 faces one by one or by
 * fours. */
static void closed_nets_have_cells(void **state) {
  for (int every = 1; every <= 2; every++) {
    lam_mesh mesh = lam_mesh_grid(*state, 6, 4, true, true);
    for (int i = 0; i < 24; i++) {
      double u = i / 4 * LAM_PI / 3, v = i % 4 * LAM_PI / 2;
      mesh.vertices[i] = lam_v3((3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v));
    }
    lam_workshop shop = fixture_workshop(*state, &mesh);
    lam_skin_net cells = lam_skin_net_make(*state, shop.net, every);
    assert_int_equal(cells.cell_count, every == 1 ? 24 : 6);
    assert_int_equal(cells.uncovered + cells.irregular, 0);
  }
}

/* ---- the row `skin` on the design's own surfaces ---- */

typedef struct skin_keys { /* as in gen/fab/parts/skin.c */
  int from, every, subdivisions, pieces, material;
  double thickness, offset;
} skin_keys;

static lam_vec3 plane(double u, double v) { return lam_v3(u, v, 0); }

static lam_workshop shop_with(void **state, const lam_spline_surface *s) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 3, 3, plane);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  if (s) lam_workshop_surface(&shop, *s);
  return shop;
}

/* A plane sheet of 3 m x 2 m, 40 mm thick with its middle 100 mm above, of oak. */
static void sheets_of_surfaces(void **state) {
  static const lam_vec3 corners[4] = {{5, 0, 1}, {5, 2, 1}, {8, 0, 1}, {8, 2, 1}};
  lam_spline_surface s = {"s", {1, 1}, {2, 2}, {linear, linear}, corners, NULL};
  lam_workshop shop = shop_with(state, &s), none = shop_with(state, NULL);
  skin_keys keys = {.from = 1, .subdivisions = 2, .thickness = .04, .offset = .1, .material = 15};
  fixture_make(&shop, "skin", &keys);
  fixture_make(&shop, "skin", &keys);
  assert_int_equal(shop.part_count, 2);
  assert_string_equal(shop.parts[0].name, "S1");
  assert_string_equal(shop.parts[1].name, "T1");
  const lam_part *part = &shop.parts[0];
  lam_vec3 min, max;
  lam_points_bounds(part->solid.vertices, part->solid.vertex_count, &min, &max);
  assert_near(min.z, 1.08, 1e-12);
  assert_near(max.z, 1.12, 1e-12);
  assert_near(part->mass, 690 * 6 * .04, 1e-9);
  assert_string_equal(part->facts[0].name, "thickness");
  assert_near(part->facts[0].value, .04, 0);
  assert_near(part->facts[1].value, part->mass, 0);
  assert_near(fixture_measure(&shop, "skin", "patch_count")->max, 1, 0);
  assert_near(fixture_measure(&shop, "skin", "piece_mass")->max, 690 * .24, 1e-9);
  assert_near(fixture_measure(&shop, "skin", "piece_mass")->mean, 690 * .24, 1e-9);
  assert_near(fixture_measure(&shop, "skin", "piece_mass_sum")->max, 690 * .24, 1e-9);
  assert_near(fixture_measure(&shop, "skin", "unsound_pieces")->max, 0, 0);
  assert_true(shop.stages[0].converged);
  fixture_make(&none, "skin", &keys);
  assert_string_equal(none.errors->first->key, "from");
}

/* ---- the row `frames` ---- */

typedef struct frames_keys {
  int count, material;
  double size, gap, thickness;
} frames_keys; /* as in gen/fab/parts/moving_frames.c */

/* Plates of 100 mm, 30 mm outside, with a pin of a quarter or of twice the thickness, whatever is
 * less: 10 mm here; then 25 mm. Volumes are plate and pin. */
static void frames_are_plates_with_a_pin(void **state) {
  lam_spline_surface s = quadric(*state, 0, 0);
  for (int k = 0; k < 2; k++) {
    double t = k ? .02 : .005, pin = k ? .025 : .01;
    frames_keys keys = {3, 0, .1, .03, t};
    lam_workshop shop = shop_with(state, &s);
    fixture_make(&shop, "frames", &keys);
    const lam_part *part = &shop.parts[0];
    lam_vec3 min, max;
    lam_points_bounds(part->solid.vertices, part->solid.vertex_count, &min, &max);
    assert_near(min.x, -.05, 1e-15);
    assert_near(max.x, .05, 1e-15);
    assert_near(min.y, .03, 1e-15);
    assert_near(max.y, .13, 1e-15);
    assert_near(min.z, -t / 2, 1e-15);
    assert_near(max.z, t / 2 + .1, 1e-15);
    assert_near(lam_trimesh_volume(&part->solid), .01 * t + pin * pin * .1, 1e-15);
    for (int v = 32; v < 36; v++) { /* the top of the pin, over the middle of the plate */
      assert_near(fabs(part->solid.vertices[v].x), pin / 2, 1e-15);
      assert_near(fabs(part->solid.vertices[v].y - .08), pin / 2, 1e-15);
    }
    assert_true(lam_part_is_sound(*state, part));
    assert_string_equal(part->name, "T1");
    assert_int_equal(part->congruence, 1);
    assert_near(fixture_measure(&shop, "frames", "frame_count")->max, 12, 0);
  }
}

/* On the unit square, three along each side at 1/6, 1/2, 5/6: v = 0, u = 0, v = 1, u = 1 in turn.
 * Outward is y, up is z, and x follows from them. */
static void frames_look_outward(void **state) {
  lam_spline_surface s = quadric(*state, 0, 0);
  lam_workshop shop = shop_with(state, &s);
  frames_keys keys = {3, 0, .1, .03, .005};
  fixture_make(&shop, "frames", &keys);
  static const lam_vec3 outward[4] = {{0, -1, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  for (int i = 0; i < 12; i++) {
    const lam_pose *f = &shop.parts[0].instances[i];
    double t = (i % 3 + .5) / 3;
    lam_vec3 at = i / 3 == 0   ? lam_v3(t, 0, 0)
                  : i / 3 == 1 ? lam_v3(0, t, 0)
                  : i / 3 == 2 ? lam_v3(t, 1, 0)
                               : lam_v3(1, t, 0);
    assert_near(lam_distance(f->origin, at), 0, 1e-15);
    assert_near(lam_distance(f->axis[1], outward[i / 3]), 0, 1e-15);
    assert_near(lam_distance(f->axis[2], lam_v3(0, 0, 1)), 0, 1e-15);
    assert_near(lam_distance(f->axis[0], lam_cross(f->axis[1], f->axis[2])), 0, 1e-15);
  }
}

static void frames_stand_on_any_knots(void **state) {
  lam_workshop shop = shop_with(state, &elsewhere);
  frames_keys keys = {2, 0, .1, .03, .005};
  fixture_make(&shop, "frames", &keys);
  static const lam_vec3 at[8] = {{.75, 0, 0}, {2.25, 0, 0}, {0, 1, 0}, {0, 3, 0},
                                 {.75, 4, 0}, {2.25, 4, 0}, {3, 1, 0}, {3, 3, 0}};
  for (int i = 0; i < 8; i++)
    assert_near(lam_distance(shop.parts[0].instances[i].origin, at[i]), 0, 1e-14);
}

/* A plane patch between a straight side and a parabola: the curved side lies in the tangent plane
 * (sine 0). On the parabolic cylinder z = u^2 the two curved sides stand square to it (sine 1), and
 * straight sides have no osculating plane. z = u^2 + v/2 leans: the curves lie in planes y = const,
 * the normal (-2u, -1/2, 1) is at an angle to y with the cosine 1/2 / sqrt(5/4 + 4 u^2). */
static void frames_tell_their_tilt(void **state) {
  lam_spline_surface s[3] = {quadric(*state, 0, 0), quadric(*state, 1, 0), quadric(*state, 1, 0)};
  ((lam_vec3 *)s[0].points)[5].y += .25; /* the middle of the side v = 1 */
  for (int k = 0; k < 9; k++) ((lam_vec3 *)s[2].points)[k].z += .25 * (k % 3);
  double least = 0, sum = 0;
  for (int i = 0; i < 3; i++) {
    double u = (i + .5) / 3, cosine = .5 / sqrt(1.25 + 4 * u * u), sine = sqrt(1 - cosine * cosine);
    least = fmax(least, sine);
    sum += sine / 3;
  }
  const double expected[3][2] = {{0, 0}, {1, 1}, {least, sum}};
  const long count[3] = {3, 6, 6};
  for (int k = 0; k < 3; k++) {
    lam_workshop shop = shop_with(state, &s[k]);
    frames_keys keys = {3, 0, .1, .03, .005};
    fixture_make(&shop, "frames", &keys);
    const lam_measure *m = fixture_measure(&shop, "frames", "normal_binormal_sine");
    assert_near(m->max, expected[k][0], 1e-12);
    assert_near(m->mean, expected[k][1], 1e-12);
    assert_int_equal(m->count, count[k]);
  }
  lam_workshop none = shop_with(state, NULL);
  frames_keys keys = {3, 0, .1, .03, .005};
  fixture_make(&none, "frames", &keys);
  assert_int_equal(none.errors->count, 1);
  assert_int_equal(none.part_count, 0);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(seams_and_kinks),
      TEST(curvature_and_energy),
      TEST(slants_of_a_saddle),
      TEST(domes_are_counted),
      TEST(patches_share_their_points),
      TEST(knots_may_begin_anywhere),
      TEST(cells_start_where_they_can),
      TEST(short_lines_have_slopes_too),
      TEST(slopes_are_symmetric),
      TEST(closed_nets_have_cells),
      TEST(sheets_of_surfaces),
      TEST(frames_are_plates_with_a_pin),
      TEST(frames_look_outward),
      TEST(frames_stand_on_any_knots),
      TEST(frames_tell_their_tilt),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
