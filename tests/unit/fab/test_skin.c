/* Skins over nets: cells of nets with irregular vertices, vertex data, patches, shells; frames
 * along a boundary. */
#include "core/numbers.h"
#include "fab_fixture.h"

#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "fab/parts/skin.h"

typedef struct skin_keys { /* as in gen/fab/parts/skin.c */
  int from, every, subdivisions, pieces, material;
  double thickness, offset;
} skin_keys;

static skin_keys row_keys(void) {
  return (skin_keys){.every = 2, .subdivisions = 4, .thickness = 0.01, .material = 0};
}

/* x = (u, v, u v): u- and v-lines are straight asymptotic lines. With w = 1 + u^2 + v^2 the torsion
 * of the u-lines is sqrt(-K) = 1 / w (Beltrami-Enneper), the normal (-v, -u, 1) / sqrt(w): the
 * conormal is (-v, -u, 1). */
static lam_vec3 hypar(double u, double v) { return lam_v3(u, v, u * v); }

/* The catenoid in asymptotic parameters: cosh(p) cos(q), cosh(p) sin(q), p with p = (u + v) / 2, q
 * = (v - u) / 2. */
static lam_vec3 catenoid(double u, double v) {
  double p = 0.5 * (u + v), q = 0.5 * (v - u);
  return lam_v3(cosh(p) * cos(q), cosh(p) * sin(q), p);
}

static lam_skin_net cells_of(lam_arena *arena, lam_mesh mesh, int every, lam_workshop *shop) {
  *shop = fixture_workshop(arena, &mesh);
  return lam_skin_net_make(arena, shop->net, every);
}

/* Discrete Lelieuvre normals of points on straight lines are those of the surface, and linear along
 * the lines; h = 1/8, slopes over two edges. They are found by relaxation, and good enough to start
 * from. */
static void conormals_of_a_hypar(void **state) {
  lam_workshop shop;
  lam_skin_net cells = cells_of(*state, fixture_grid(*state, 17, 17, hypar), 2, &shop);
  assert_int_equal(cells.cell_count, 64);
  assert_int_equal(cells.uncovered + cells.irregular, 0);
  for (int v = 0; v < shop.net->mesh.vertex_count; v++) {
    const lam_conormal_vertex *x = &cells.vertices[v];
    double error = lam_distance(x->conormal, lam_v3(-x->point.y, -x->point.x, 1)), slopes = 0;
    for (int d = 0; d < 2; d++) slopes += lam_length(x->slope[d]);
    if (!(error < 2e-3)) fail_msg("the conormal is %g off", error);
    if (!(fabs(slopes - 2 * 2.0 / 8) < 0.02)) fail_msg("slopes %g, expected 0.5", slopes);
  }
}

/* Cells of a grid that every does not divide leave the rest uncovered: 10 x 7 faces in cells of 3 x
 * 3 are 3 x 2. */
static void what_does_not_fit_is_counted(void **state) {
  lam_workshop shop;
  lam_skin_net cells = cells_of(*state, fixture_grid(*state, 11, 8, catenoid), 3, &shop);
  assert_int_equal(cells.cell_count, 6);
  assert_int_equal(cells.uncovered, 70 - 54);
}

static const double *measure_of(const lam_workshop *shop, const char *name) {
  return &fixture_measure(shop, "skin", name)->max;
}

/* Every corner of a patch is a vertex of the net, exactly. */
static void check_corners(const lam_workshop *shop, const lam_spline_surface *s) {
  int m = s->count[0], n = s->count[1];
  const lam_vec3 corners[4] = {s->points[0], s->points[n - 1], s->points[(m - 1) * n],
                               s->points[m * n - 1]};
  for (int k = 0; k < 4; k++) {
    int v = 0;
    while (v < shop->net->mesh.vertex_count &&
           lam_distance(shop->net->mesh.vertices[v], corners[k]) > 0)
      v++;
    if (v == shop->net->mesh.vertex_count) fail_msg("corner %d of %s is no vertex", k, s->name);
  }
}

/* Neighbors meet without gap or crease, edges are asymptotic curves and run on through vertices; K
 * < 0. All of it measured from the patches; they are to be exact but for rounding. */
static void check_skin(lam_workshop *shop, const skin_keys *keys, int patches) {
  static const char *const exact[] = {"normal_jump", "edge_normal_curvature", "edge_kink"};
  fixture_make(shop, "skin", keys);
  if (shop->errors->count) fail_msg("%s", shop->errors->first->text);
  assert_int_equal(shop->surface_count, patches);
  for (int k = 0; k < 3; k++)
    if (!(*measure_of(shop, exact[k]) < 1e-9))
      fail_msg("%s is %g", exact[k], *measure_of(shop, exact[k]));
  assert_true(*measure_of(shop, "gap") < 1e-12);
  assert_true(*measure_of(shop, "gaussian_curvature") < 0);
  assert_true(*measure_of(shop, "not_saddle") == 0);
  assert_true(*measure_of(shop, "cells_left_out") == 0);
  assert_true(*measure_of(shop, "unsound_pieces") == 0);
  assert_true(shop->stages[0].converged);
  for (int k = 0; k < patches; k++) check_corners(shop, &shop->surfaces[k]);
}

/* One closed solid. The volume is area times thickness to the first order (H = 0): the area of the
 * triangles of the net. Gaussian curvature is -1 / cosh(p)^4, p in [-1, 1]: -1 to -0.17637. */
static void a_catenoid_gets_a_skin(void **state) {
  for (int every = 1; every <= 4; every *= 2) {
    lam_mesh mesh = fixture_grid(*state, 17, 17, catenoid);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    skin_keys keys = row_keys();
    keys.every = every;
    check_skin(&shop, &keys, 256 / every / every);
    assert_int_equal(shop.part_count, 1);
    lam_solid_facts facts;
    assert_int_equal(lam_solid_measure(&shop.parts[0].solid, true, &facts), LAM_OK);
    assert_true(facts.closed && facts.oriented && facts.manifold && facts.self_intersections == 0);
    lam_trimesh fine = lam_mesh_triangles(*state, &mesh);
    double volume = lam_trimesh_area(&fine) * keys.thickness;
    if (!(fabs(facts.volume - volume) < 5e-3 * volume))
      fail_msg("volume %g, expected %g", facts.volume, volume);
    const lam_measure *k = fixture_measure(&shop, "skin", "gaussian_curvature");
    if (!(k->min > -1.02 && k->min < -0.97 && k->max < -0.17 && k->max > -0.19))
      fail_msg("every %d: K from %g to %g", every, k->min, k->max);
  }
}

/* The same cells over a net twice as fine: the vertices between the corners come closer at least
 * with the square. */
static void finer_nets_are_met_closer(void **state) {
  double distance[3];
  for (int k = 0; k < 3; k++) {
    lam_mesh mesh = fixture_grid(*state, (4 << k) + 1, (4 << k) + 1, catenoid);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    skin_keys keys = row_keys();
    keys.every = 1 << k;
    check_skin(&shop, &keys, 16);
    distance[k] = k ? *measure_of(&shop, "net_distance") : 0;
  }
  if (!(distance[1] < 2e-3 && distance[2] < distance[1] / 3.5))
    fail_msg("%g m, %g m", distance[1], distance[2]);
}

/* The straight lines of x^2 + y^2 - z^2 = 1 all around: cells and families close up. Over every
 * second one of 24 lines of each family; K = -1 / (1 + 2 z^2)^2. */
static void a_hyperboloid_closes(void **state) {
  enum { LINES = 24, ROWS = 9 };
  const double step = 2 * LAM_PI / LINES;
  lam_mesh mesh = {ROWS * LINES, LAM_NEW(*state, lam_vec3, ROWS * LINES), 0, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(*state, (ROWS - 2) * LINES, sizeof *mesh.faces);
  for (int i = 0; i < ROWS; i++)
    for (int j = 0; j < LINES; j++) { /* lines touch the waist at a and b and cross at the middle
                                         angle, tan((a-b)/2) high */
      double middle = (j + 0.5 * (i % 2)) * step, z = tan((i - ROWS / 2) * step / 2),
             r = sqrt(1 + z * z);
      mesh.vertices[i * LINES + j] = lam_v3(r * cos(middle), r * sin(middle), z);
    }
  for (int i = 0; i + 2 < ROWS; i++)
    for (int j = 0; j < LINES; j++) {
      int right = (j + i % 2) % LINES, left = (right + LINES - 1) % LINES;
      const int face[4] = {i * LINES + j, (i + 1) * LINES + right, (i + 2) * LINES + j,
                           (i + 1) * LINES + left};
      memcpy(mesh.faces[mesh.face_count++], face, sizeof face);
    }
  lam_workshop shop = fixture_workshop(*state, &mesh);
  skin_keys keys = row_keys();
  keys.every = 1;
  check_skin(&shop, &keys, (ROWS - 2) * LINES);
  const lam_measure *k = fixture_measure(&shop, "skin", "gaussian_curvature");
  double z = tan((ROWS / 2) * step / 2),
         end = -pow(1 + 2 * z * z, -2); /* a corner, near which no place is measured */
  if (!(fabs(k->min + 1) < 0.02 && k->max < end && k->max > end - 0.05))
    fail_msg("K from %g to %g", k->min, k->max);
}

/* Lines of a sphere are no asymptotic curves. */
static lam_vec3 sphere(double u, double v) {
  return lam_v3(cos(u) * cos(v), sin(u) * cos(v), sin(v));
}

static void other_nets_are_refused(void **state) {
  lam_mesh mesh = fixture_grid(*state, 9, 9, sphere);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  skin_keys keys = row_keys();
  fixture_make(&shop, "skin", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_non_null(strstr(shop.errors->first->text, "expected an asymptotic net"));
}

/* Straight lines are asymptotic curves of every skin: k_n = 0 to rounding. Cells as solids of their
 * own touch their neighbors: together they have the volume of the whole. */
static void a_hypar_keeps_its_lines(void **state) {
  double volume[2] = {0, 0};
  for (int pieces = 0; pieces < 2; pieces++) {
    lam_mesh mesh = fixture_grid(*state, 13, 13, hypar);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    skin_keys keys = row_keys();
    keys.pieces = pieces;
    check_skin(&shop, &keys, 36);
    assert_int_equal(shop.part_count, pieces ? 36 : 1);
    for (int i = 0; i < shop.part_count; i++)
      volume[pieces] += lam_trimesh_volume(&shop.parts[i].solid);
  }
  assert_true(fabs(volume[0] - volume[1]) < 1e-12);
}

/* Six sectors around a flat point, 2 faces along each side, every 1: 24 cells, of which the six
 * around the middle have an irregular corner. z = Re w^3 is a monkey saddle; here only its
 * connectivity matters. */
static void cells_at_an_irregular_vertex_are_left_out(void **state) {
  enum { SECTORS = 6, N = 2 };
  lam_mesh mesh = {1 + SECTORS * N * (N + 1), LAM_NEW(*state, lam_vec3, 1 + SECTORS * N * (N + 1)),
                   0, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(*state, SECTORS * N * N, sizeof *mesh.faces);
  for (int s = 0; s < SECTORS; s++)
    for (int a = 1; a <= N; a++)
      for (int b = 0; b <= N; b++) {
        double r = hypot(a, b), angle = (s + atan2(b, a) * 2 / LAM_PI) * LAM_PI / 3;
        mesh.vertices[1 + (s * N + a - 1) * (N + 1) + b] =
            lam_v3(r * cos(angle), r * sin(angle), 0.05 * r * r * r * sin(3 * angle));
      }
#define VERTEX(s, a, b)                                                                            \
  ((a) == 0 ? ((b) == 0 ? 0 : 1 + (((s) + 1) % SECTORS * N + (b)-1) * (N + 1))                     \
            : 1 + ((s)*N + (a)-1) * (N + 1) + (b))
  for (int s = 0; s < SECTORS; s++)
    for (int a = 0; a < N; a++)
      for (int b = 0; b < N; b++) {
        const int face[4] = {VERTEX(s, a, b), VERTEX(s, a + 1, b), VERTEX(s, a + 1, b + 1),
                             VERTEX(s, a, b + 1)};
        memcpy(mesh.faces[mesh.face_count++], face, sizeof face);
      }
  lam_workshop shop;
  lam_skin_net cells = cells_of(*state, mesh, 1, &shop);
  assert_int_equal(shop.net->irregular_count, 1);
  assert_int_equal(cells.cell_count, 18);
  assert_int_equal(cells.irregular, 6);
  assert_int_equal(cells.uncovered, 0);
}

static void no_cell_is_an_error(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, catenoid);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  skin_keys keys = row_keys();
  keys.every = 7;
  fixture_make(&shop, "skin", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_string_equal(shop.errors->first->key, "every");
}

/* Plates of 0.1 m x 0.1 m x 5 mm with pins of 10 mm x 10 mm x 0.1 m, 5 along each side of a patch
 * over the unit square: closed, and as far outside as the gap. */
static void frames_stand_outside(void **state) {
  struct {
    int count, material;
    double size, gap, thickness;
  } keys = {5, 0, 0.1, 0.03, 0.005};
  static const double knots[4] = {0, 0, 1, 1};
  const lam_vec3 points[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0.3}}; /* z = 0.3 u v */
  lam_mesh mesh = fixture_grid(*state, 5, 5, hypar);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_workshop_surface(&shop,
                       (lam_spline_surface){"s", {1, 1}, {2, 2}, {knots, knots}, points, NULL});
  fixture_make(&shop, "frames", &keys);
  assert_int_equal(shop.part_count, 1);
  const lam_part *part = &shop.parts[0];
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(&part->solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold && facts.self_intersections == 0);
  assert_true(fabs(facts.volume - (0.1 * 0.1 * 0.005 + 0.01 * 0.01 * 0.1)) < 1e-12);
  assert_int_equal(part->instance_count, 20);
  for (int i = 0; i < 20; i++) {
    const lam_pose *f = &part->instances[i];
    assert_true(fabs(lam_dot(lam_cross(f->axis[0], f->axis[1]), f->axis[2]) - 1) < 1e-12);
    lam_vec3 out =
        lam_along(f->origin, keys.gap, f->axis[1]); /* outside the unit square, seen from above */
    assert_true(fmax(fmax(-out.x, out.x - 1), fmax(-out.y, out.y - 1)) > 0.9 * keys.gap);
    double u = f->origin.x, v = f->origin.y; /* normal of z = 0.3 u v */
    assert_true(lam_angle(f->axis[2], lam_v3(-0.3 * v, -0.3 * u, 1)) < 1e-7);
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(conormals_of_a_hypar),    TEST(what_does_not_fit_is_counted),
      TEST(a_catenoid_gets_a_skin),  TEST(finer_nets_are_met_closer),
      TEST(a_hyperboloid_closes),    TEST(other_nets_are_refused),
      TEST(a_hypar_keeps_its_lines), TEST(cells_at_an_irregular_vertex_are_left_out),
      TEST(no_cell_is_an_error),     TEST(frames_stand_outside),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
