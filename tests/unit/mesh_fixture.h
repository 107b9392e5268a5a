/* Meshes with known measures, shared by the tests about meshes. */
#ifndef LAM_TESTS_MESH_FIXTURE_H
#define LAM_TESTS_MESH_FIXTURE_H

#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "tests/unit/asserts.h"

static const double mesh_pi = LAM_PI;

/* A closed box from a to b: volume is the product of its sides, 8 vertices, 12 triangles. */
static inline lam_trimesh mesh_box(lam_arena *arena, lam_vec3 a, lam_vec3 b) {
  static const int triangles[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                       {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                       {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  lam_trimesh mesh = {8, LAM_NEW(arena, lam_vec3, 8), 12,
                      lam_arena_alloc(arena, 12, sizeof *mesh.triangles)};
  for (int i = 0; i < 8; i++)
    mesh.vertices[i] = lam_v3(i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z);
  for (int i = 0; i < 12; i++)
    for (int k = 0; k < 3; k++) mesh.triangles[i][k] = triangles[i][k];
  return mesh;
}

static inline lam_trimesh mesh_cube(lam_arena *arena, double x, double y, double z, double side) {
  return mesh_box(arena, lam_v3(x, y, z), lam_v3(x + side, y + side, z + side));
}

/* A torus of n x m quads, each cut into two triangles; Euler number 0, genus 1. */
static inline lam_trimesh mesh_torus(lam_arena *arena, double R, double r, int n, int m) {
  lam_trimesh mesh = {n * m, LAM_NEW(arena, lam_vec3, n * m), 0, NULL};
  mesh.triangles = lam_arena_alloc(arena, 2 * (size_t)(n * m), sizeof *mesh.triangles);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double u = 2 * mesh_pi * i / n, v = 2 * mesh_pi * j / m, c = R + r * cos(v);
      int a = i * m + j, b = (i + 1) % n * m + j, d = i * m + (j + 1) % m,
          e = (i + 1) % n * m + (j + 1) % m;
      mesh.vertices[a] = lam_v3(c * cos(u), c * sin(u), r * sin(v));
      int *t = mesh.triangles[mesh.triangle_count++], *s = mesh.triangles[mesh.triangle_count++];
      t[0] = a, t[1] = b, t[2] = e;
      s[0] = a, s[1] = e, s[2] = d;
    }
  return mesh;
}

/* A closed bar through n sections of four corners, which run counterclockwise seen from the far
 * end. */
static inline lam_trimesh mesh_tube(lam_arena *arena, int n, lam_vec3 (*sections)[4]) {
  lam_trimesh mesh = {4 * n, &sections[0][0], 0, NULL};
  mesh.triangles = lam_arena_alloc(arena, 8 * (size_t)n, sizeof *mesh.triangles);
  for (int i = 0; i + 1 < n; i++)
    for (int k = 0; k < 4; k++) {
      int a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      int *s = mesh.triangles[mesh.triangle_count++], *t = mesh.triangles[mesh.triangle_count++];
      s[0] = a, s[1] = b + 4, s[2] = a + 4;
      t[0] = a, t[1] = b, t[2] = b + 4;
    }
  for (int k = 1; k < 3; k++) {
    int *s = mesh.triangles[mesh.triangle_count++], *t = mesh.triangles[mesh.triangle_count++],
        last = 4 * (n - 1);
    s[0] = 0, s[1] = k + 1, s[2] = k;
    t[0] = last, t[1] = last + k, t[2] = last + k + 1;
  }
  return lam_trimesh_weld(arena, &mesh, 0);
}

static inline lam_trimesh mesh_inverted(lam_arena *arena, const lam_trimesh *mesh) {
  lam_trimesh result = lam_trimesh_join(arena, &mesh, 1);
  for (int i = 0; i < result.triangle_count; i++) {
    int swap = result.triangles[i][1];
    result.triangles[i][1] = result.triangles[i][2];
    result.triangles[i][2] = swap;
  }
  return result;
}

static inline lam_trimesh mesh_pair(lam_arena *arena, const lam_trimesh *a, const lam_trimesh *b) {
  const lam_trimesh *both[2] = {a, b};
  lam_trimesh joined = lam_trimesh_join(arena, both, 2);
  return lam_trimesh_weld(arena, &joined, 0);
}

#endif
