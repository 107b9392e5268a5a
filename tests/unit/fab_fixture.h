/* Nets and workshops for tests of fabrication. */
#ifndef LAM_TESTS_FAB_FIXTURE_H
#define LAM_TESTS_FAB_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "fab/lamella/lamella_checks.h"
#include "fab/lamella/lamella_make.h"
#include "mesh/net.h"
#include "mesh/surface_normals.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Quads and vertices of an OBJ file; scaled. */
static inline lam_mesh fixture_obj(lam_arena *arena, const char *path, double scale) {
  lam_mesh mesh = {0, LAM_NEW(arena, lam_vec3, 8192), 0, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(arena, 8192, sizeof *mesh.faces);
  char line[256];
  FILE *file = fopen(path, "r");
  if (!file) fail_msg("cannot open %s", path);
  while (fgets(line, sizeof line, file)) {
    lam_vec3 v;
    int f[4];
    if (sscanf(line, "v %lf %lf %lf", &v.x, &v.y, &v.z) == 3)
      mesh.vertices[mesh.vertex_count++] = lam_scale(v, scale);
    if (sscanf(line, "f %d %d %d %d", &f[0], &f[1], &f[2], &f[3]) == 4) {
      for (int k = 0; k < 4; k++) mesh.faces[mesh.face_count][k] = f[k] - 1;
      mesh.face_count++;
    }
  }
  fclose(file);
  return mesh;
}

/* A grid of n x m vertices at f(u, v) for u, v evenly in [-1, 1]. */
static inline lam_mesh fixture_grid(lam_arena *arena, int n, int m,
                                    lam_vec3 (*f)(double u, double v)) {
  lam_mesh mesh = lam_mesh_grid(arena, n, m, false, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++)
      mesh.vertices[i * m + j] = f(2.0 * i / (n - 1) - 1, 2.0 * j / (m - 1) - 1);
  return mesh;
}

/* An empty workshop around a mesh. */
static inline lam_workshop fixture_workshop(lam_arena *arena, const lam_mesh *mesh) {
  lam_errors *errors = LAM_NEW(arena, lam_errors, 1);
  lam_net *net = LAM_NEW(arena, lam_net, 1);
  errors->arena = arena;
  if (!lam_net_build(arena, mesh, (lam_location){0}, errors, net))
    fail_msg("%s", errors->first->text);
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  lam_surface_normals(arena, net, net->mesh.vertices, normals);
  return (lam_workshop){.arena = arena, .errors = errors, .net = net, .normals = normals};
}

/* 100 mm x 2 mm, single, extended by 0.1 m, clearance 0.25 mm, half-lap, no scissoring: the start
 * for every test. */
static inline lam_lamella_keys fixture_keys(void) {
  static int families[2] = {0, 1};
  return (lam_lamella_keys){.families = {2, families},
                            .height = 0.1,
                            .thickness = 0.002,
                            .every = 1,
                            .extend = 0.1,
                            .joint = {LAM_JOINT_HALF_LAP, 0.00025, 0},
                            .boundary = true};
}

static inline void fixture_make(lam_workshop *shop, const char *kind, const void *keys) {
  const lam_part_kind *row = (const lam_part_kind *)lam_registry_find(&lam_part_kinds, kind);
  assert_non_null(row);
  row->make(shop, keys, (lam_location){"test", 1, 1});
}

/* What is done with a row that stands alone in a design: its keys are checked, then it is made. */
static inline void fixture_row(lam_workshop *shop, const lam_part_kind *kind, void *params) {
  const lam_row row = {.head = &kind->head, .params = params, .location = {"test", 1, 1}};
  int before = shop->errors->count;
  if (kind->check) kind->check(&row, 0, shop->errors);
  if (shop->errors->count == before) kind->make(shop, params, row.location);
}

static inline const lam_measure *fixture_measure(const lam_workshop *shop, const char *stage,
                                                 const char *name) {
  for (int i = 0; i < shop->stage_count; i++)
    for (int k = 0; k < shop->stages[i].measure_count; k++)
      if (strcmp(shop->stages[i].name, stage) == 0 &&
          strcmp(shop->stages[i].measures[k].name, name) == 0)
        return &shop->stages[i].measures[k];
  fail_msg("no measure %s of %s", name, stage);
  return NULL;
}

static inline lam_arena *fixture_arena(void **state) { return *state; }
static inline int fixture_setup(void **state) { return (*state = lam_arena_new()) ? 0 : -1; }
static inline int fixture_teardown(void **state) {
  lam_arena_free(*state);
  return 0;
}

#endif
