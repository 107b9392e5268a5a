/* Nets that the tests of connectivity, constraints, solver and measures share. */
#ifndef LAM_TESTS_NET_FIXTURE_H
#define LAM_TESTS_NET_FIXTURE_H

#include "core/numbers.h"
#include "design/design.h"
#include "net/net_kind.h"
#include "net/trace/start.h"
#include "tests/unit/asserts.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

static const double net_pi = LAM_PI;

typedef struct net_fixture {
  lam_arena *arena;
  lam_errors errors;
  uint64_t random;
} net_fixture;

static inline int net_set_up(void **state) {
  static net_fixture f;
  f = (net_fixture){.arena = lam_arena_new(), .random = 2024};
  f.errors.arena = f.arena;
  *state = &f;
  return f.arena ? 0 : -1;
}

static inline int net_tear_down(void **state) {
  lam_arena_free(((net_fixture *)*state)->arena);
  return 0;
}

#define NET_TEST(function) cmocka_unit_test_setup_teardown(function, net_set_up, net_tear_down)

/* A fixed sequence of numbers in (-1, 1). */
static inline double net_random(net_fixture *f) {
  f->random = f->random * 6364136223846793005u + 1442695040888963407u;
  return 2 * ((double)(f->random >> 11) / 9007199254740992.0) - 1;
}

static inline void net_no_errors(const net_fixture *f, const char *what) {
  if (f->errors.count) fail_msg("%s: %s", what, f->errors.first->text);
}

static inline lam_net net_built(net_fixture *f, const lam_mesh *mesh) {
  lam_net net;
  lam_net_build(f->arena, mesh, (lam_location){0}, &f->errors, &net);
  net_no_errors(f, "building a net");
  return net;
}

/* A grid at f(i, j). */
static inline lam_mesh net_grid(lam_arena *arena, int n, int m,
                                lam_vec3 (*at)(double i, double j)) {
  lam_mesh mesh = lam_mesh_grid(arena, n, m, false, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) mesh.vertices[i * m + j] = at(i, j);
  return mesh;
}

static inline lam_vec3 net_plane(double i, double j) { return lam_v3(i, j, 0); }
/* K < 0 everywhere: z = x y / 6. */
static inline lam_vec3 net_saddle(double i, double j) {
  return lam_v3(i, j, (i - 2) * (j - 2.5) / 6);
}

/* A torus of n x m vertices, closed in both directions: Euler number 0. */
static inline lam_mesh net_torus(lam_arena *arena, int n, int m, double R, double r) {
  lam_mesh mesh = lam_mesh_grid(arena, n, m, true, true);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double u = 2 * net_pi * i / n, v = 2 * net_pi * j / m, c = R + r * cos(v);
      mesh.vertices[i * m + j] = lam_v3(c * cos(u), c * sin(u), r * sin(v));
    }
  return mesh;
}

/* A bulging tube: closed along u, two boundary loops without corners. */
static inline lam_mesh net_tube(lam_arena *arena, int n, int m) {
  lam_mesh mesh = lam_mesh_grid(arena, n, m, true, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double u = 2 * net_pi * i / n, z = j - (m - 1) / 2.0, r = 1.5 + .1 * z * z;
      mesh.vertices[i * m + j] = lam_v3(r * cos(u), r * sin(u), z);
    }
  return mesh;
}

/* The cube [-1, 1]^3, faces counterclockwise seen from outside; vertex k has x, y, z from the bits
 * 1, 2, 4 of k. */
static inline lam_mesh net_cube(lam_arena *arena) {
  static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  lam_mesh mesh = {8, LAM_NEW(arena, lam_vec3, 8), 6,
                   (int(*)[4])lam_arena_alloc(arena, 6, sizeof *mesh.faces)};
  memcpy(mesh.faces, faces, sizeof faces);
  for (int k = 0; k < 8; k++)
    mesh.vertices[k] = lam_v3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  return mesh;
}

/* Catmull-Clark of the cube: 26 vertices, 24 faces, eight vertices of valence 3. */
static inline lam_mesh net_round_cube(net_fixture *f) {
  lam_mesh cube = net_cube(f->arena);
  lam_net net = net_built(f, &cube);
  return lam_net_catmull_clark(f->arena, &net);
}

/* A net's start on a surface: kind and keys as in a design. */
static inline lam_mesh net_sampled(net_fixture *f, const char *surface, const char *keys,
                                   lam_chart chart, int n, int m, int hole) {
  const lam_row_head *head = lam_registry_find(&lam_surfaces, surface);
  assert_non_null(head);
  lam_row row = {.head = head, .params = lam_arena_alloc(f->arena, 1, head->params_size + 1)};
  if (head->keys)
    lam_keys_parse(f->arena, head->keys, keys, strlen(keys), NULL, &f->errors, row.params);
  lam_surface made = lam_surface_make(f->arena, &row, &f->errors);
  net_no_errors(f, surface);
  lam_placement_keys placing = {0};
  lam_mesh mesh = {0};
  lam_net_start(f->arena, &made, chart, (int[2]){n, m}, hole, &placing, (lam_location){0},
                &f->errors, &mesh, NULL);
  return mesh;
}

/* The monkey saddle (Enneper's surface of order 2) around its flat point: a vertex of valence 6. */
static inline lam_mesh net_monkey(net_fixture *f, int n, int hole) {
  return net_sampled(f, "enneper", "{order: 2}", LAM_CHART_ASYMPTOTIC, n, n, hole);
}

/* Vertices and quads of an OBJ file. */
static inline lam_mesh net_obj(lam_arena *arena, const char *path) {
  lam_mesh mesh = {0, LAM_NEW(arena, lam_vec3, 4096), 0,
                   (int(*)[4])lam_arena_alloc(arena, 4096, sizeof *mesh.faces)};
  char line[256];
  FILE *file = fopen(path, "r");
  if (!file) fail_msg("cannot open %s", path);
  while (file && fgets(line, sizeof line, file)) {
    lam_vec3 v;
    int f[4];
    if (sscanf(line, "v %lf %lf %lf", &v.x, &v.y, &v.z) == 3)
      mesh.vertices[mesh.vertex_count++] = v;
    if (sscanf(line, "f %d %d %d %d", &f[0], &f[1], &f[2], &f[3]) == 4) {
      for (int k = 0; k < 4; k++) mesh.faces[mesh.face_count][k] = f[k] - 1;
      mesh.face_count++;
    }
    assert_true(mesh.vertex_count < 4096 && mesh.face_count < 4096);
  }
  fclose(file);
  return mesh;
}

/* Fills a parameter struct from a design text; zeroed memory of the arena. */
static inline void *net_params(net_fixture *f, const lam_key *keys, size_t size, const char *text) {
  void *params = lam_arena_alloc(f->arena, 1, size + 1);
  if (keys) lam_keys_parse(f->arena, keys, text, strlen(text), NULL, &f->errors, params);
  net_no_errors(f, text);
  return params;
}

#endif
