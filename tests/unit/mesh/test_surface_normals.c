/* Normals of the surface that a net stands for, on surfaces whose normals have a closed form. */
#include "core/numbers.h"
#include "mesh/surface_normals.h"
#include "tests/unit/asserts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

typedef struct place {
  lam_vec3 x, n;
} place;

/* The largest distance of a normal from the exact one over a net of n x m vertices, u and v evenly
 * from u[0] to u[1] and v[0] to v[1]. */
static double worst(place (*f)(double, double), int n, int m, const double u[2],
                    const double v[2]) {
  lam_arena *arena = lam_arena_new();
  lam_errors errors = {.arena = arena};
  lam_mesh mesh = lam_mesh_grid(arena, n, m, false, false);
  for (int i = 0; i < n * m; i++)
    mesh.vertices[i] =
        f(u[0] + (u[1] - u[0]) * (i / m) / (n - 1), v[0] + (v[1] - v[0]) * (i % m) / (m - 1)).x;

  lam_net net;
  assert_true(lam_net_build(arena, &mesh, (lam_location){0}, &errors, &net));
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, n * m);
  lam_surface_normals(arena, &net, net.mesh.vertices, normals);
  double most = 0;
  for (int i = 0; i < n * m; i++) {
    place p = f(u[0] + (u[1] - u[0]) * (i / m) / (n - 1), v[0] + (v[1] - v[0]) * (i % m) / (m - 1));
    most =
        fmax(most, lam_distance(normals[i], lam_scale(p.n, lam_dot(p.n, normals[i]) < 0 ? -1 : 1)));
  }
  lam_arena_free(arena);
  return most;
}

static place sphere(double u, double v) {
  lam_vec3 n = lam_v3(cos(v) * cos(u), cos(v) * sin(u), sin(v));
  return (place){lam_scale(n, 3.8298), n};
}

/* By parallels and meridians every normal of a sphere is exact, corners and all; also on few lines,
 * where there is less to carry on. */
static void spheres_are_exact(void **state) {
  (void)state;
  assert_below(worst(sphere, 17, 15, (double[]){-.9, .9}, (double[]){-.7, .7}), 1e-13);
  assert_below(worst(sphere, 4, 4, (double[]){-.4, .5}, (double[]){-.3, .7}), 1e-13);
  assert_below(worst(sphere, 3, 4, (double[]){-.4, .5}, (double[]){-.3, .7}), 1e-13);
}

/* Three quarters of a net, with a reentrant corner: lines run through it, and its normal and those
 * of the vertices beside it are exact too. */
static void reentrant_corners_are_exact(void **state) {
  (void)state;
  enum { n = 9, half = 4 };
  lam_arena *arena = lam_arena_new();
  lam_errors errors = {.arena = arena};
  lam_mesh all = lam_mesh_grid(arena, n, n, false, false), mesh = all;
  int number[n * n];
  mesh.vertex_count = mesh.face_count = 0;
  for (int v = 0; v < n * n; v++) {
    if (v / n > half && v % n > half) continue;
    number[v] = mesh.vertex_count;
    mesh.vertices[mesh.vertex_count++] = sphere(.1 * (v / n), .1 * (v % n)).x;
  }
  for (int f = 0; f < all.face_count; f++) {
    int corner[4], first = all.faces[f][0];
    if (first / n >= half && first % n >= half) continue;
    for (int k = 0; k < 4; k++) corner[k] = number[all.faces[f][k]];
    for (int k = 0; k < 4; k++) mesh.faces[mesh.face_count][k] = corner[k];
    mesh.face_count++;
  }

  lam_net net;
  assert_true(lam_net_build(arena, &mesh, (lam_location){0}, &errors, &net));
  assert_int_equal(lam_net_valence(&net, number[half * n + half]), 4);
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, n * n);
  lam_surface_normals(arena, &net, net.mesh.vertices, normals);
  for (int v = 0; v < mesh.vertex_count; v++)
    assert_near(lam_distance(normals[v], lam_unit(net.mesh.vertices[v])), 0, 1e-13);
  lam_arena_free(arena);
}

/* x and z by u along a helix of 45 degrees, y by v along the one that turns the other way. */
static place cylinder(double u, double v) {
  return (place){lam_v3(2 * cos(u - v), 2 * sin(u - v), 2 * (u + v)),
                 lam_v3(cos(u - v), sin(u - v), 0)};
}

/* Helices are orbits of a screw motion: exact at even steps. */
static void helices_are_exact(void **state) {
  (void)state;
  assert_below(worst(cylinder, 9, 9, (double[]){0, 1}, (double[]){0, 1}), 1e-13);
}

/* The catenoid by lines at 45 degrees, which are conformal coordinates turned. */
static place catenoid(double u, double v) {
  double a = (u - v) / sqrt(2), z = (u + v) / sqrt(2);
  return (place){lam_v3(cosh(z) * cos(a), cosh(z) * sin(a), z),
                 lam_scale(lam_v3(cos(a), sin(a), -sinh(z)), 1 / cosh(z))};
}

/* 1.1e-3 at steps of .11, and a quarter at half the step, or less. */
static void other_surfaces_are_near(void **state) {
  (void)state;
  const double range[2] = {-.55, .55};
  double coarse = worst(catenoid, 11, 11, range, range),
         fine = worst(catenoid, 21, 21, range, range);
  assert_below(coarse, 1.2e-3);
  assert_below(fine, coarse / 3.5);
}

/* z = x y by straight lines, and the helicoid by rulings and helices: nets of planar stars, whose
 * border vertices have their edges in the tangent plane too. */
static place saddle(double u, double v) {
  return (place){lam_v3(u, v, u * v), lam_unit(lam_v3(-v, -u, 1))};
}

/* At steps of a = 1/6 in v the plane of a star holds the ruling and the step (r sin a, a) up. */
static place helicoid(double u, double v) {
  double a = 1. / 6;
  return (place){lam_v3(u * cos(v), u * sin(v), v),
                 lam_unit(lam_v3(a * sin(v), -a * cos(v), u * sin(a)))};
}

static void planar_stars_keep_their_planes(void **state) {
  (void)state;
  assert_below(worst(saddle, 12, 12, (double[]){-1, 1}, (double[]){-1, 1}), 1e-14);
  assert_below(worst(helicoid, 9, 13, (double[]){.5, 2.5}, (double[]){0, 2}), 1e-13);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(spheres_are_exact),
      cmocka_unit_test(reentrant_corners_are_exact),
      cmocka_unit_test(helices_are_exact),
      cmocka_unit_test(other_surfaces_are_near),
      cmocka_unit_test(planar_stars_keep_their_planes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
