/* Measures a triangle mesh: counts, orientation, area, volume, moments. Called by
 * fab/lamella/lamella_checks.c and library/compare_meshes.c. What needs exact predicates, the
 * self-intersections, is asked of solid_shim.cc. */
#include "core/solid/solid.h"
#include "core/numbers.h"

#include "core/solid/solid_exact.h"
#include "core/solid/topology.h"
#include "core/solid/triangles.h"

/* A connected component of the mesh. */
typedef struct piece {
  double volume;
  lam_vec3 min, max;
  int first; /* triangle */
} piece;

/* What is measured; coordinates are taken from the origin. */
typedef struct measuring {
  const lam_trimesh *mesh;
  const int *component;
  lam_vec3 origin; /* the middle of the bounding box: keeps the sums small */
  int piece_count;
  piece *pieces;
} measuring;

static void corners_of(const measuring *m, int triangle, lam_vec3 p[3]) {
  for (int k = 0; k < 3; k++)
    p[k] = lam_sub(m->mesh->vertices[m->mesh->triangles[triangle][k]], m->origin);
}

/* Volume and bounds of every piece, from the tetrahedra between its triangles and the origin.
 * Components are numbered by first appearance, so a new number is the next piece. */
static void find_pieces(measuring *m) {
  for (int i = 0; i < m->mesh->triangle_count; i++) {
    piece *one = &m->pieces[m->component[i]];
    lam_vec3 p[3], low, high;
    corners_of(m, i, p);
    lam_points_bounds(p, 3, &low, &high);

    if (m->component[i] == m->piece_count) {
      *one = (piece){.min = low, .max = high, .first = i};
      m->piece_count++;
    }
    one->min = lam_v3(fmin(one->min.x, low.x), fmin(one->min.y, low.y), fmin(one->min.z, low.z));
    one->max = lam_v3(fmax(one->max.x, high.x), fmax(one->max.y, high.y), fmax(one->max.z, high.z));
    one->volume += lam_dot(p[0], lam_cross(p[1], p[2])) / 6;
  }
}

/* Whether p lies in the box of the piece. */
static bool holds(const piece *outer, lam_vec3 p) {
  return p.x > outer->min.x && p.x < outer->max.x && p.y > outer->min.y && p.y < outer->max.y &&
         p.z > outer->min.z && p.z < outer->max.z;
}

/* How often the pieces other than `own` that may hold p wind around it: the sum of the solid angles
 * of their triangles over 4 pi (A. Van Oosterom, J. Strackee, The solid angle of a plane triangle,
 * 1983). */
static double winding(const measuring *m, int own, lam_vec3 p) {
  double sum = 0;
  for (int i = 0; i < m->mesh->triangle_count; i++) {
    int c = m->component[i];
    if (c == own || !holds(&m->pieces[c], p)) continue;

    lam_vec3 q[3];
    corners_of(m, i, q);
    for (int k = 0; k < 3; k++) q[k] = lam_sub(q[k], p);

    double a = lam_length(q[0]), b = lam_length(q[1]), l = lam_length(q[2]);
    double below =
        a * b * l + lam_dot(q[0], q[1]) * l + lam_dot(q[1], q[2]) * a + lam_dot(q[2], q[0]) * b;
    sum += atan2(lam_dot(q[0], lam_cross(q[1], q[2])), below);
  }
  return sum / (2 * LAM_PI);
}

/* Every piece has its outside outside: a positive volume, or, for a cavity, a negative one inside
 * another piece. */
static bool outside_is_outside(const measuring *m) {
  for (int c = 0; c < m->piece_count; c++) {
    if (m->pieces[c].volume > 0) continue;
    lam_vec3 p[3];
    corners_of(m, m->pieces[c].first, p);
    bool may_be_cavity = false;
    for (int d = 0; d < m->piece_count && !may_be_cavity; d++)
      may_be_cavity = d != c && holds(&m->pieces[d], p[0]);
    if (!may_be_cavity || winding(m, c, p[0]) < 0.5) return false;
  }
  return true;
}

/* The sum of the triangles' areas and its centroid; the origin when there is no area. */
static double measure_area(const measuring *m, lam_vec3 *centroid) {
  double area = 0;
  lam_vec3 sum = {0};
  for (int i = 0; i < m->mesh->triangle_count; i++) {
    lam_vec3 p[3];
    corners_of(m, i, p);
    double a = lam_length(lam_cross(lam_sub(p[1], p[0]), lam_sub(p[2], p[0]))) / 2;
    area += a;
    sum = lam_along(sum, a / 3, lam_add(p[0], lam_add(p[1], p[2])));
  }
  *centroid = area > 0 ? lam_add(m->origin, lam_scale(sum, 1 / area)) : m->origin;
  return area;
}

/* Sums over the tetrahedra (origin, a, b, c) with D = a . (b x c), s = a + b + c:
 *   volume D/6,
 *   first moments D/24 s,
 *   second moments D/120 (a a' + b b' + c c' + s s'),
 * shifted to the centroid. The inertia tensor is trace(C) 1 - C with C the second moments; its
 * products are entries of the tensor, that is -integral of xy. */
static void measure_volume(const measuring *m, lam_solid_facts *facts) {
  double volume = 0, c[6] = {0};
  lam_vec3 first = {0};
  for (int i = 0; i < m->mesh->triangle_count; i++) {
    lam_vec3 p[4];
    corners_of(m, i, p);
    p[3] = lam_add(p[0], lam_add(p[1], p[2]));

    double D = lam_dot(p[0], lam_cross(p[1], p[2]));
    volume += D / 6;
    first = lam_along(first, D / 24, p[3]);

    for (int k = 0; k < 4; k++) {
      const lam_vec3 q = p[k];
      const double products[6] = {q.x * q.x, q.y * q.y, q.z * q.z, q.x * q.y, q.y * q.z, q.z * q.x};
      for (int l = 0; l < 6; l++) c[l] += D / 120 * products[l];
    }
  }

  facts->volume = volume;
  if (volume == 0) return;

  /* The theorem of parallel axes, then C to the tensor: xx = C_yy + C_zz, xy = -C_xy, ... */
  lam_vec3 g = lam_scale(first, 1 / volume);
  facts->centroid = lam_add(m->origin, g);
  const double shift[6] = {g.x * g.x, g.y * g.y, g.z * g.z, g.x * g.y, g.y * g.z, g.z * g.x};
  for (int l = 0; l < 6; l++) c[l] -= volume * shift[l];
  for (int l = 0; l < 3; l++) facts->inertia[l] = c[(l + 1) % 3] + c[(l + 2) % 3];
  for (int l = 3; l < 6; l++) facts->inertia[l] = -c[l];
}

/* Facts of the topology alone. The genus follows from Euler's formula, V - E + F = 2 (components
 * - genus). */
static void count(const lam_topology *t, lam_solid_facts *facts) {
  facts->vertices = t->vertices;
  facts->closed = t->closed;
  facts->oriented = t->oriented;
  facts->manifold = !t->nonmanifold_edges && t->fans == t->vertices;
  facts->boundary_edges = t->boundary_edges;
  facts->nonmanifold_edges = t->nonmanifold_edges;
  facts->components = t->components;
  facts->euler = t->vertices - t->edges + facts->triangles;

  int handles = 2 * t->components - facts->euler;
  facts->genus = facts->closed && facts->manifold && handles % 2 == 0 ? handles / 2 : -1;
}

/* The bounds of the vertices that triangles use. */
static void bound(lam_arena *arena, const lam_trimesh *mesh, lam_solid_facts *facts) {
  lam_vec3 *used = LAM_NEW(arena, lam_vec3, 3 * (size_t)mesh->triangle_count);
  for (int i = 0; i < mesh->triangle_count; i++)
    for (int k = 0; k < 3; k++) used[3 * i + k] = mesh->vertices[mesh->triangles[i][k]];
  lam_points_bounds(used, 3 * mesh->triangle_count, &facts->min, &facts->max);
}

/* The area is measured of every mesh, volume and orientation of a closed one. */
static lam_status measure(lam_arena *arena, const lam_trimesh *mesh, lam_solid_facts *facts) {
  int *component = LAM_NEW(arena, int, mesh->triangle_count);
  int(*fan)[3] = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof *fan);
  lam_topology topology;
  lam_status status = lam_topology_make(mesh, component, fan, &topology);
  if (status != LAM_OK) return status;

  count(&topology, facts);
  bound(arena, mesh, facts);
  measuring m = {mesh, component, lam_mix(facts->min, facts->max, 0.5), 0,
                 LAM_NEW(arena, piece, topology.components)};

  facts->area = measure_area(&m, &facts->centroid);
  if (topology.boundary_edges || !mesh->triangle_count) return LAM_OK;

  find_pieces(&m);
  facts->oriented = facts->oriented && outside_is_outside(&m);
  measure_volume(&m, facts);
  return LAM_OK;
}

/* The arena ends before CGAL is asked: nothing may jump across its frames. */
lam_status lam_solid_measure(const lam_trimesh *mesh, bool self_intersections,
                             lam_solid_facts *facts) {
  *facts = (lam_solid_facts){.triangles = mesh->triangle_count, .self_intersections = -1};
  if (mesh->triangle_count < 0) return LAM_BAD_INPUT;

  lam_arena *arena = lam_arena_new();
  if (!arena) return LAM_NO_MEMORY;
  jmp_buf point;
  if (!LAM_ARENA_TRY(arena, point)) {
    lam_arena_free(arena);
    return LAM_NO_MEMORY;
  }

  lam_status status = measure(arena, mesh, facts);
  lam_arena_free(arena);
  if (status == LAM_OK && self_intersections)
    status = lam_solid_self_intersections(mesh, &facts->self_intersections);
  return status;
}
