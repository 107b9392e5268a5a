/* Developing strips: closed forms, and the straightness of lamellas on asymptotic nets. */
#include "core/numbers.h"
#include "fab/flat/unroll.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

enum { n = 25 };

/* Planes through one straight line: the line stays straight, whatever the twist; all three ways
 * agree on its length. */
static void twisted_straight_strip(void **state) {
  (void)state;
  lam_vec3 x[n], m[n];
  lam_vec2 flat[n];
  for (int i = 0; i < n; i++) {
    double s = i + 0.3 * sin(i), a = 0.4 * i;
    x[i] = lam_v3(s, 2 * s, 0);
    m[i] = lam_add(lam_scale(lam_unit(lam_v3(-2, 1, 0)), cos(a)), lam_v3(0, 0, sin(a)));
  }
  lam_unroll(x, m, n, flat);
  assert_near(lam_straightness(flat, n), 0, 1e-14);
  assert_near(flat[n - 1].x, lam_distance(x[0], x[n - 1]), 1e-12);
  lam_unroll_angles(x, m, n, flat);
  assert_near(lam_straightness(flat, n), 0, 1e-14);
}

/* On a cylinder along m any polyline perpendicular to m unrolls straight; with m in the plane of an
 * arc the strip is flat already and keeps its sagitta: R (1 - cos(a/2)), over the length of the
 * inscribed polyline. */
static void cylinder_and_plane(void **state) {
  (void)state;
  lam_vec3 x[n], up[n], out[n];
  lam_vec2 flat[n];
  double step = 0.05, radius = 3, half = step * (n - 1) / 2;
  for (int i = 0; i < n; i++) {
    double a = i * step - half;
    x[i] = lam_v3(radius * sin(a), radius * cos(a), 0);
    up[i] = lam_v3(0, 0, 1);
    out[i] = lam_v3(sin(a), cos(a), 0);
  }
  double length = (n - 1) * 2 * radius * sin(step / 2), sagitta = radius * (1 - cos(half));
  lam_unroll(x, up, n, flat);
  assert_near(lam_straightness(flat, n), 0, 1e-15);
  assert_near(flat[n - 1].x, length, 1e-12);
  lam_unroll_triangles(x, up, 0.1, n, flat);
  assert_near(lam_straightness(flat, n), 0, 1e-13);
  lam_unroll(x, out, n, flat);
  assert_near(lam_straightness(flat, n), sagitta / length, 1e-14);
  lam_unroll_angles(x, out, n, flat);
  assert_near(lam_straightness(flat, n), sagitta / length, 1e-14);
  lam_unroll_triangles(x, out, 0.1, n, flat);
  assert_near(lam_straightness(flat, n), sagitta / length, 1e-13);
}

/* A pyramid over a regular polygon: the edges lie in its faces, and unroll around the apex at the
 * distance of the slant edges. m points to the apex. */
static void pyramid(void **state) {
  (void)state;
  lam_vec3 x[n], m[n];
  lam_vec2 flat[n];
  double radius = 1.5, apex = 2, slant = hypot(radius, apex);
  for (int i = 0; i < n; i++) {
    double a = 2 * LAM_PI * i / (2 * n);
    x[i] = lam_v3(radius * cos(a), radius * sin(a), 0);
    m[i] = lam_unit(lam_sub(lam_v3(0, 0, apex), x[i]));
  }
  lam_unroll(x, m, n, flat);
  /* the apex over the first edge, in the flat plane */
  double edge = hypot(flat[1].x, flat[1].y), height = sqrt(slant * slant - edge * edge / 4);
  for (int i = 0; i < n; i++) {
    assert_near(hypot(flat[i].x - edge / 2, flat[i].y - height), slant, 1e-12);
    if (i) assert_near(hypot(flat[i].x - flat[i - 1].x, flat[i].y - flat[i - 1].y), edge, 1e-12);
  }
}

/* The case meshes of a prototype, each an optimized asymptotic net of 17 x 17 vertices, and the
 * largest deviation it measured over the 15 + 15 lines inside. By angles alone lines are straight
 * up to the 12 digits of the files. */
static const struct {
  const char *path;
  double planes;
} nets[] = {{"tests/cases/nets/10_anet_enneper_final.obj", 4.84e-5},
            {"tests/cases/nets/11_anet_catenoid_final.obj", 4.42e-5},
            {"tests/cases/nets/12_anet_scherk_final.obj", 3.68e-5},
            {"tests/cases/nets/13_anet_crpc60_final.obj", 1.54e-4},
            {"tests/cases/nets/14_anet_pseudosphere_final.obj", 1e-10}};

typedef struct straightness {
  double planes, angles, triangles;
} straightness;

static straightness measure_net(lam_arena *arena, const char *path) {
  lam_mesh mesh = fixture_obj(arena, path, 1);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  straightness most = {0, 0, 0};
  for (int l = 0; l < shop.net->polyline_count; l++) {
    const lam_polyline *line = &shop.net->polylines[l];
    if (shop.net->boundary[line->vertices[1]]) continue;
    lam_vec3 x[64], m[64];
    lam_vec2 flat[64];
    assert_true(line->count <= 64);
    int count = line->count - 2; /* without the ends, which have no planar star */
    for (int i = 0; i < count; i++) {
      x[i] = shop.net->mesh.vertices[line->vertices[i + 1]];
      m[i] = shop.normals[line->vertices[i + 1]];
    }
    lam_unroll(x, m, count, flat);
    most.planes = fmax(most.planes, lam_straightness(flat, count));
    lam_unroll_angles(x, m, count, flat);
    most.angles = fmax(most.angles, lam_straightness(flat, count));
    lam_unroll_triangles(x, m, 0.25 * lam_net_mean_edge(shop.net, shop.net->mesh.vertices), count,
                         flat);
    most.triangles = fmax(most.triangles, lam_straightness(flat, count));
  }
  return most;
}

static void asymptotic_nets_unroll_straight(void **state) {
  for (size_t k = 0; k < sizeof nets / sizeof nets[0]; k++) {
    straightness s = measure_net(fixture_arena(state), nets[k].path);
    print_message("%s: planes %.3g, angles %.3g, triangles %.3g\n", nets[k].path, s.planes,
                  s.angles, s.triangles);
    if (!(s.angles <= 1e-10)) fail_msg("%s: by angles %g", nets[k].path, s.angles);
    if (!(s.planes <= 1.15 * nets[k].planes))
      fail_msg("%s: by planes %g, expected about %g", nets[k].path, s.planes, nets[k].planes);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(twisted_straight_strip), cmocka_unit_test(cylinder_and_plane),
      cmocka_unit_test(pyramid),
      cmocka_unit_test_setup_teardown(asymptotic_nets_unroll_straight, fixture_setup,
                                      fixture_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
