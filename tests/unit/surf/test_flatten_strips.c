/* Laying flat what winds around: strips whose pattern is a ring or overlaps itself, long cells,
 * fine grids. */
#include "core/numbers.h"
#include "developable_fixture.h"
#include "surf/flatten/flatten.h"

enum { ALONG = 48, ACROSS = 8 };

typedef lam_vec3 location(double u, double v);

/* ALONG x ACROSS cells over [0, 1]^2, vertex (i, j) at i (ACROSS + 1) + j; normals may be NULL. */
static lam_flat_mesh strip(lam_arena *arena, int along, int across, location *x_of,
                           location *normal_of) {
  int vertices = (along + 1) * (across + 1), count = 0;
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, vertices), *normals = LAM_NEW(arena, lam_vec3, vertices);
  int(*triangles)[3] = lam_arena_alloc(arena, (size_t)(2 * along * across), sizeof *triangles);
  for (int v = 0; v < vertices; v++) {
    double a = v / (across + 1) / (double)along, b = v % (across + 1) / (double)across;
    x[v] = x_of(a, b);
    if (normal_of) normals[v] = normal_of(a, b);
  }
  for (int i = 0; i < along; i++)
    for (int j = 0; j < across; j++) {
      int v = i * (across + 1) + j, next = v + across + 1;
      memcpy(triangles[count++], (int[3]){v, next, next + 1}, sizeof *triangles);
      memcpy(triangles[count++], (int[3]){v, next + 1, v + 1}, sizeof *triangles);
    }
  lam_flat_mesh mesh;
  if (!lam_flat_disk(arena, vertices, x, normal_of ? normals : NULL, count,
                     (const int(*)[3])triangles, &mesh))
    fail_msg("the strip is no disk");
  return mesh;
}

/* Flattens without folding and returns the rms distance from where the vertices belong. */
static double error_of(lam_arena *arena, const lam_flat_mesh *mesh, int across, int along,
                       location *truth_of) {
  lam_flattening flat = lam_flatten(arena, mesh);
  assert_true(flat.converged);
  assert_int_equal(flat.flips, 0);
  lam_vec2 *truth = LAM_NEW(arena, lam_vec2, mesh->vertex_count),
           *x = LAM_NEW(arena, lam_vec2, mesh->vertex_count);
  memcpy(x, flat.points, (size_t)mesh->vertex_count * sizeof *x);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_vec3 p = truth_of(v / (across + 1) / (double)along, v % (across + 1) / (double)across);
    truth[v] = (lam_vec2){p.x, p.y};
  }
  return lam_flat_align(mesh->vertex_count, truth, x);
}

/* 350 degrees of a ring, radii 1.4 and 1: flat already, but far from the disk's start. The second
 * radius is at v = 0, so that u, v turn counterclockwise. */
static lam_vec3 ring(double u, double v) {
  double angle = 350 * LAM_PI / 180 * u, r = 1.4 - 0.4 * v;
  return lam_v3(r * cos(angle), r * sin(angle), 0);
}

static void a_slit_ring_stays(void **state) {
  dev_fixture *f = *state;
  static const int cells[3][2] = {{48, 8}, {24, 24}, {8, 48}};
  for (int k = 0; k < 3; k++) {
    lam_flat_mesh mesh = strip(f->arena, cells[k][0], cells[k][1], ring, NULL);
    double error = error_of(f->arena, &mesh, cells[k][1], cells[k][0], ring);
    if (!(error < 1e-12)) fail_msg("%d x %d cells: off by %.3g m", cells[k][0], cells[k][1], error);
  }
}

/* The tangents of the helix (cos a, sin a, a/2), two turns, from .3 to 1.1 along them. The helix
 * has the curvature 1/(1 + 1/4) = .8, and so has its development: a circle of radius 1.25 run
 * through by 4 pi sqrt(1.25) = 14.05 m, which is 1.79 turns: the pattern lies on itself. */
static const double pitch = 0.5;
static double reach(double v) { return 1.1 - 0.8 * v; }
static lam_vec3 tangent_surface(double u, double v) {
  double a = 4 * LAM_PI * u, t = reach(v);
  return lam_v3(cos(a) - t * sin(a), sin(a) + t * cos(a), pitch * (a + t));
}
static lam_vec3 binormal(double u, double v) {
  double a = 4 * LAM_PI * u;
  (void)v;
  return lam_unit(lam_v3(pitch * sin(a), -pitch * cos(a), 1));
}
static lam_vec3 tangents_of_a_circle(double u, double v) {
  double speed = sqrt(1 + pitch * pitch), radius = speed * speed,
         angle = 4 * LAM_PI * u * speed / radius;
  double t = speed * reach(v);
  return lam_v3(radius * cos(angle) - t * sin(angle), radius * sin(angle) + t * cos(angle), 0);
}

static void a_pattern_may_lie_on_itself(void **state) {
  dev_fixture *f = *state;
  lam_flat_mesh coarse = strip(f->arena, ALONG, ACROSS, tangent_surface, binormal);
  lam_flat_mesh fine = strip(f->arena, 2 * ALONG, 2 * ACROSS, tangent_surface, binormal);
  double e1 = error_of(f->arena, &coarse, ACROSS, ALONG, tangents_of_a_circle);
  double e2 = error_of(f->arena, &fine, 2 * ACROSS, 2 * ALONG, tangents_of_a_circle);
  if (!(e2 < 5e-5)) fail_msg("off by %.3g m", e2);
  if (!(e1 / e2 > 12 && e1 / e2 < 20))
    fail_msg("the error falls by %.3g, expected about 16", e1 / e2);
}

/* One and a half turns of a winding stair, .3 m wide: no developable surface, K = -c^2/(c^2 +
 * r^2)^2 with c = .6. */
static lam_vec3 stair(double u, double v) {
  double a = 3 * LAM_PI * u, r = 1.3 - 0.3 * v;
  return lam_v3(r * cos(a), r * sin(a), 0.6 * a);
}

static void a_winding_stair_does_not_fold(void **state) {
  dev_fixture *f = *state;
  static const int cells[2][2] = {{48, 8}, {24, 24}};
  for (int k = 0; k < 2; k++) {
    lam_flat_mesh mesh = strip(f->arena, cells[k][0], cells[k][1], stair, NULL);
    lam_flattening flat = lam_flatten(f->arena, &mesh);
    assert_true(flat.converged);
    assert_int_equal(flat.flips, 0);
    assert_true(flat.max_strain < 0.02);
  }
}

/* A scroll of three turns, r = .2 (1 + angle): developable, and unfolding leaves nothing but
 * rounding, which the steps after it must not chase. The same holds on a fine grid. */
static lam_vec3 scroll(double u, double v) {
  double a = 6 * LAM_PI * u, r = 0.2 * (1 + a);
  return lam_v3(r * cos(a), r * sin(a), v);
}

static void rounding_is_not_chased(void **state) {
  dev_fixture *f = *state;
  lam_flat_mesh mesh = strip(f->arena, 60, 6, scroll, NULL);
  lam_flattening flat = lam_flatten(f->arena, &mesh);
  assert_true(flat.converged && flat.flips == 0 && flat.max_strain < 1e-12);
  if (flat.iterations > 3) fail_msg("%d steps", flat.iterations);
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D2"));
  mesh = lam_flat_grid(f->arena, &s, 80, LAM_FLAT_GEODESICS);
  flat = lam_flatten(f->arena, &mesh);
  assert_true(flat.converged && flat.flips == 0);
  if (flat.iterations > 10) fail_msg("%d steps", flat.iterations);
}

/* Where the largest curvature is least, most of the sheet is strained; it is laid flat as well. */
static void minimax_surfaces_are_laid_flat(void **state) {
  dev_fixture *f = *state;
  static const char *const names[] = {"D3", "D6"};
  for (int k = 0; k < 2; k++) {
    lam_spline_surface s = dev_coons(f->arena, dev_case(f, names[k]));
    lam_developable_solve(f->arena, &s,
                          (lam_developable_options){.method = LAM_DEVELOPABLE_MINIMAX});
    lam_flat_mesh mesh = lam_flat_grid(f->arena, &s, 40, LAM_FLAT_GEODESICS);
    lam_flattening flat = lam_flatten(f->arena, &mesh);
    assert_true(flat.converged);
    assert_int_equal(flat.flips, 0);
    assert_true(flat.max_strain < 0.03);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      DEV_TEST(a_slit_ring_stays),
      DEV_TEST(a_pattern_may_lie_on_itself),
      DEV_TEST(a_winding_stair_does_not_fold),
      DEV_TEST(rounding_is_not_chased),
      DEV_TEST(minimax_surfaces_are_laid_flat),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
