/* Initial nets sampled from a surface, set in their position, and shaken when asked. Called by
 * design/net_stage.c and bench/bench_run.c; traced lines come from trace_start.c. */
#include "net/trace/start.h"
#include "core/solid/triangles.h"
#include "net/trace/trace.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* What is sampled, and where messages go. */
typedef struct sampling {
  lam_arena *arena;
  const lam_surface *surface;
  lam_chart chart;
  const int *grid; /* cells along both families */
  int hole;        /* rings left out around a flat point */
  const lam_placement_keys *placing;
  lam_location location;
  lam_errors *errors;
} sampling;

/* ---- a rectangle of chart coordinates ---- */

/* Fills the mesh of grid cells over the ranges that placing gives, else over the chart's own,
 * closed where the chart is. parameters: in the natural chart those of the vertices. */
static bool sample_grid(const sampling *s, lam_mesh *mesh, lam_vec2 **parameters) {
  const lam_surface *surface = s->surface;
  const int *grid = s->grid;
  double p[2], q[2];
  bool closed[2] = {false, false};
  surface->kind->domain(surface->data, s->chart, p, q, closed);
  if (s->placing->u_given) memcpy(p, s->placing->u, sizeof p), closed[0] = false;
  if (s->placing->v_given) memcpy(q, s->placing->v, sizeof q), closed[1] = false;

  int n = grid[0] + !closed[0], m = grid[1] + !closed[1];
  if ((closed[0] && n < 3) || (closed[1] && m < 3)) {
    lam_error_add(s->errors, s->location, "net.grid",
                  "%d x %d cells; a closed direction needs at least 3", grid[0], grid[1]);
    return false;
  }

  *mesh = lam_mesh_grid(s->arena, n, m, closed[0], closed[1]);
  lam_vec2 *at = LAM_NEW(s->arena, lam_vec2, n * m);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      lam_vec2 *c = &at[i * m + j];
      *c = (lam_vec2){p[0] + (p[1] - p[0]) * i / grid[0], q[0] + (q[1] - q[0]) * j / grid[1]};
      mesh->vertices[i * m + j] = lam_surface_point(surface, s->chart, 0, c->x, c->y);
    }
  if (s->chart == LAM_CHART_NATURAL) *parameters = at;
  return true;
}

/* ---- sectors around a flat point ---- */

/* What sectors ask of the keys: equal numbers of cells, one reach for all, and a hole
 * that leaves cells. */
static bool check_sectors(const sampling *s) {
  int n = s->grid[0];
  const lam_placement_keys *placing = s->placing;
  if (s->grid[0] != s->grid[1]) {
    lam_error_add(s->errors, s->location, "net.grid",
                  "[%d, %d]; around a flat point both numbers must be equal", s->grid[0],
                  s->grid[1]);
    return false;
  }

  if (placing->v_given || (placing->u_given && placing->u[0] != 0)) {
    lam_error_add(
        s->errors, s->location, "surface.u",
        "around a flat point only u: [0, reach] is meant, the same for all sectors; no v");
    return false;
  }

  if (s->hole >= n) {
    lam_error_add(s->errors, s->location, "net.hole",
                  "%d rings, but every sector has %d; expected at most %d", s->hole, n, n - 1);
    return false;
  }
  return true;
}

/* Number of vertex (a, b) of a sector, 0 <= a, b <= n, around a flat point, which has the number
 * 0. A sector owns a >= 1, b < n; its side a = 0 belongs to the next sector's side b = 0. Numbers
 * run to sectors n (n + 1). */
static int sector_vertex(int sectors, int n, int sector, int a, int b) {
  if (a == 0 && b == 0) return 0;
  if (a == 0) {
    sector = (sector + 1) % sectors;
    a = b;
    b = 0;
  }
  return 1 + (sector * n + a - 1) * (n + 1) + b;
}

/* Appends the cells of a sector to the faces of the mesh, by sector_vertex, and samples
 * their corners into points, where used does not yet say that they are there. reach: of
 * the chart's parameters. */
static void add_sector(const sampling *s, int sectors, int sector, double reach, lam_mesh *mesh,
                       lam_vec3 *points, bool *used) {
  static const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  int n = s->grid[0];
  for (int a = 0; a < n; a++)
    for (int b = 0; b < n; b++) {
      if (a < s->hole && b < s->hole) continue;

      int *face = mesh->faces[mesh->face_count++];
      for (int k = 0; k < 4; k++) {
        int ca = a + corner[k][0], cb = b + corner[k][1],
            v = sector_vertex(sectors, n, sector, ca, cb);
        face[k] = v;
        if (used[v]) continue;
        used[v] = true;
        points[v] = lam_surface_point(s->surface, s->chart, sector, reach * ca / n, reach * cb / n);
      }
    }
}

/* Gives the mesh the points in use, in their order, and its faces their new numbers. */
static void keep_used(lam_arena *arena, int all, const lam_vec3 *points, const bool *used,
                      lam_mesh *mesh) {
  int *index = LAM_NEW(arena, int, all);
  mesh->vertex_count = 0;
  mesh->vertices = LAM_NEW(arena, lam_vec3, all);
  for (int v = 0; v < all; v++)
    if (used[v]) {
      mesh->vertices[mesh->vertex_count] = points[v];
      index[v] = mesh->vertex_count++;
    }

  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 4; k++) mesh->faces[f][k] = index[mesh->faces[f][k]];
}

/* Fills a mesh of sectors, n x n cells each, that share the flat point and their sides. */
static bool sample_sectors(const sampling *s, lam_mesh *mesh) {
  const lam_surface *surface = s->surface;
  int n = s->grid[0], sectors = surface->kind->sectors(surface->data, s->chart);
  double p[2], q[2];
  bool closed[2];
  surface->kind->domain(surface->data, s->chart, p, q, closed);
  double reach = s->placing->u_given ? s->placing->u[1] : p[1];
  if (!check_sectors(s)) return false;

  int all = 1 + sectors * n * (n + 1);
  lam_vec3 *points = LAM_NEW(s->arena, lam_vec3, all);
  bool *used = LAM_NEW(s->arena, bool, all);
  mesh->faces =
      (int(*)[4])lam_arena_alloc(s->arena, (size_t)(sectors * n * n), sizeof *mesh->faces);
  mesh->face_count = 0;
  for (int sector = 0; sector < sectors; sector++)
    add_sector(s, sectors, sector, reach, mesh, points, used);
  keep_used(s->arena, all, points, used, mesh);
  return true;
}

/* ---- position ---- */

/* v turned about the x, the y and the z axis, in this order; radians. */
static lam_vec3 turned(lam_vec3 v, const double angle[3]) {
  double c = cos(angle[0]), s = sin(angle[0]);
  v = lam_v3(v.x, c * v.y - s * v.z, s * v.y + c * v.z);
  c = cos(angle[1]), s = sin(angle[1]);
  v = lam_v3(c * v.x + s * v.z, v.y, -s * v.x + c * v.z);
  c = cos(angle[2]), s = sin(angle[2]);
  return lam_v3(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
}

lam_vec3 lam_placement_apply(const lam_placement *placement, lam_vec3 x) {
  x = lam_scale(turned(x, placement->rotate), placement->scale);
  x.z += placement->lift;
  return x;
}

/* Turns, scales and grounds what was sampled, and tells how in placed, which may be NULL. False,
 * with an error, when a vertex is not finite. */
static bool place_mesh(const lam_placement_keys *placing, lam_location location, lam_errors *errors,
                       lam_mesh *mesh, lam_placement *placed) {
  for (int v = 0; v < mesh->vertex_count; v++) {
    mesh->vertices[v] = turned(mesh->vertices[v], placing->rotate);
    lam_vec3 x = mesh->vertices[v];
    if (!isfinite(x.x + x.y + x.z)) {
      lam_error_add(errors, location, "surface",
                    "the surface is singular inside u, v; choose smaller ranges");
      return false;
    }
  }

  /* `size` is the larger horizontal extent after rotation */
  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  double extent = fmax(high.x - low.x, high.y - low.y);
  lam_placement done = {.rotate = {placing->rotate[0], placing->rotate[1], placing->rotate[2]},
                        .scale = 1};
  if (placing->size_given && extent > 0) {
    done.scale = placing->size / extent;
    for (int v = 0; v < mesh->vertex_count; v++)
      mesh->vertices[v] = lam_scale(mesh->vertices[v], done.scale);
  }

  if (placing->ground) done.lift = lam_mesh_ground(mesh);
  if (placed) *placed = done;
  return true;
}

/* ---- the start ---- */

/* Whether the chart is branched: sectors around a flat point. */
static bool is_branched(const sampling *s) {
  const lam_surface *surface = s->surface;
  return surface->kind->sectors && surface->kind->sectors(surface->data, s->chart) > 0;
}

/* A chart in closed form is sampled: sectors where it is branched, else a rectangle. Any other
 * one is traced. */
bool lam_net_start(lam_arena *arena, const lam_surface *surface, lam_chart chart, const int grid[2],
                   int hole, const lam_placement_keys *placing, lam_location location,
                   lam_errors *errors, lam_mesh *mesh, lam_placement *placed) {
  double p[2], q[2];
  bool closed[2];
  if (chart >= LAM_CHART_COUNT || !surface->kind->domain(surface->data, chart, p, q, closed)) {
    lam_trace_options plain = {0};
    return lam_net_start_traced(arena, surface, chart, grid, hole, &plain, placing, location,
                                errors, mesh, placed);
  }

  sampling s = {arena, surface, chart, grid, hole, placing, location, errors};
  bool branched = is_branched(&s);
  if (!branched && hole > 0) {
    lam_error_add(errors, location, "net.hole", "%d, but %s has no flat point here; expected 0",
                  hole, surface->kind->head.name);
    return false;
  }

  lam_vec2 *parameters = NULL;
  bool sampled = branched ? sample_sectors(&s, mesh) : sample_grid(&s, mesh, &parameters);
  if (!sampled || !place_mesh(placing, location, errors, mesh, placed)) return false;
  if (placed) placed->parameters = parameters;
  return true;
}

/* Traced lines know no parameters of a chart: placed->parameters is NULL. */
bool lam_net_start_traced(lam_arena *arena, const lam_surface *surface, lam_chart chart,
                          const int grid[2], int hole, const struct lam_trace_options *options,
                          const lam_placement_keys *placing, lam_location location,
                          lam_errors *errors, lam_mesh *mesh, lam_placement *placed) {
  lam_traced traced;
  if (!lam_trace_net(arena, surface, chart, grid, hole, options, placing, location, errors, mesh,
                     &traced) ||
      !place_mesh(placing, location, errors, mesh, placed))
    return false;

  if (placed) {
    placed->coverage = traced.coverage;
    memcpy(placed->cells, traced.cells, sizeof traced.cells);
  }
  return true;
}

/* Two passes: the lowest vertex, then the move. */
double lam_mesh_ground(lam_mesh *mesh) {
  double lowest = INFINITY;
  for (int v = 0; v < mesh->vertex_count; v++) lowest = fmin(lowest, mesh->vertices[v].z);
  for (int v = 0; v < mesh->vertex_count; v++) mesh->vertices[v].z -= lowest;
  return -lowest;
}

/* SplitMix64: a counter through a mixing function; the same on every machine. In [0, 1). */
static double random_unit(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Random vectors in a ball: those of a cube until one lies in it. The three coordinates are drawn
 * one after the other, for the order in which arguments are evaluated is not defined. */
void lam_mesh_perturb(lam_mesh *mesh, double noise, int seed) {
  uint64_t state = (uint64_t)seed;
  for (int v = 0; v < mesh->vertex_count; v++) {
    double d[3];
    do {
      for (int c = 0; c < 3; c++) d[c] = 2 * random_unit(&state) - 1;
    } while (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > 1);
    mesh->vertices[v] = lam_along(mesh->vertices[v], noise, lam_v3(d[0], d[1], d[2]));
  }
}
