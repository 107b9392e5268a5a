/* Tidying of meshes that other programs have written. Called by library/start_mesh.c. */
#include "mesh/tidy.h"
#include "core/solid/triangles.h"

#include <stdint.h>
#include <string.h>

/* Vertices closer than this share of the mesh's diagonal lie at the same place: files have few
 * digits, and rounding is no distance. */
static const double same_place = 1e-9;

static int corner_count(const int *face) { return face[3] < 0 ? 3 : 4; }

/* Whether all faces name vertices that the mesh has. */
static bool is_valid(const lam_mesh *mesh) {
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < corner_count(mesh->faces[f]); k++)
      if (mesh->faces[f][k] < 0 || mesh->faces[f][k] >= mesh->vertex_count) return false;
  return true;
}

/* A copy of the faces, which may be changed. */
static void own_faces(lam_arena *arena, lam_mesh *mesh) {
  int(*faces)[4] = lam_arena_alloc(arena, (size_t)mesh->face_count, sizeof *faces);
  if (mesh->face_count) memcpy(faces, mesh->faces, (size_t)mesh->face_count * sizeof *faces);
  mesh->faces = faces;
}

/* ---- places ---- */

/* Vertices by the cell of a grid that they lie in: lists in a hash table. */
typedef struct places {
  double cell; /* side of a cell, meters: vertices closer than it lie in neighboring cells */
  lam_vec3 low;
  uint64_t mask;
  int *first, *next; /* per slot, per vertex; -1: none */
} places;

static places places_new(lam_arena *arena, const lam_mesh *mesh, double cell, lam_vec3 low) {
  places p = {.cell = cell, .low = low, .mask = 15};
  while (p.mask < (uint64_t)mesh->vertex_count) p.mask = 2 * p.mask + 1;
  p.first = LAM_NEW(arena, int, p.mask + 1);
  p.next = LAM_NEW(arena, int, mesh->vertex_count);
  memset(p.first, -1, (p.mask + 1) * sizeof *p.first);
  return p;
}

/* The slot of the cell that lies (dx, dy, dz) cells from that of x. */
static uint64_t slot_of(const places *p, lam_vec3 x, int dx, int dy, int dz) {
  const double at[3] = {floor((x.x - p->low.x) / p->cell) + dx,
                        floor((x.y - p->low.y) / p->cell) + dy,
                        floor((x.z - p->low.z) / p->cell) + dz};
  uint64_t hash = 0;
  for (int k = 0; k < 3; k++) {
    hash = (hash ^ (uint64_t)(int64_t)at[k]) * 0xff51afd7ed558ccdULL;
    hash ^= hash >> 33;
  }
  return hash & p->mask;
}

/* The first of the vertices added so far that lies within `within` of x; -1: none does. */
static int find_near(const places *p, const lam_mesh *mesh, lam_vec3 x, double within) {
  int found = -1;
  for (int i = 0; i < 27; i++)
    for (int v = p->first[slot_of(p, x, i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)]; v >= 0;
         v = p->next[v])
      if (lam_distance(mesh->vertices[v], x) <= within && (found < 0 || v < found)) found = v;
  return found;
}

/* Per vertex: the first one that lies within the distance of it, or itself. Vertices that have such
 * a one are no place for later ones, so that chains do not creep along. */
static int *first_at_place(lam_arena *arena, const lam_mesh *mesh, double distance) {
  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  double rounding = same_place * lam_distance(low, high), within = fmax(distance, rounding);
  places p = places_new(arena, mesh, within > 0 ? within : 1, low);
  int *same = LAM_NEW(arena, int, mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++) same[v] = v;
  if (!isfinite(within)) return same; /* coordinates near the largest number */

  for (int v = 0; v < mesh->vertex_count; v++) {
    int earlier = find_near(&p, mesh, mesh->vertices[v], within);
    if (earlier >= 0) {
      same[v] = earlier;
      continue;
    }
    uint64_t slot = slot_of(&p, mesh->vertices[v], 0, 0, 0);
    p.next[v] = p.first[slot];
    p.first[slot] = v;
  }
  return same;
}

/* The places at which more than one vertex lies. */
static int count_doubled(lam_arena *arena, const lam_mesh *mesh) {
  const int *same = first_at_place(arena, mesh, 0);
  bool *counted = LAM_NEW(arena, bool, mesh->vertex_count);
  int count = 0;
  for (int v = 0; v < mesh->vertex_count; v++) {
    if (same[v] == v || counted[same[v]]) continue;
    counted[same[v]] = true;
    count++;
  }
  return count;
}

/* ---- welding ---- */

/* Whether a face has two corners that become one, and had not before. */
static bool collapses(const int *face, const int *same) {
  for (int k = 0; k < corner_count(face); k++)
    for (int l = 0; l < k; l++)
      if (face[k] != face[l] && same[face[k]] == same[face[l]]) return true;
  return false;
}

/* Faces name the first vertex of every place; the others are in no face then. False: a face would
 * collapse. */
static bool weld(lam_arena *arena, lam_mesh *mesh, double tolerance, lam_tidied *found, int *face) {
  const int *same = first_at_place(arena, mesh, tolerance);
  for (*face = 0; *face < mesh->face_count; ++*face)
    if (collapses(mesh->faces[*face], same)) return false;

  own_faces(arena, mesh);
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < corner_count(mesh->faces[f]); k++)
      mesh->faces[f][k] = same[mesh->faces[f][k]];
  for (int v = 0; v < mesh->vertex_count; v++) found->welded += same[v] != v;
  return true;
}

/* ---- vertices in no face ---- */

/* Leaves out vertices in no face; returns how many. */
static int leave_out_unused(lam_arena *arena, lam_mesh *mesh) {
  int *number = LAM_NEW(arena, int, mesh->vertex_count), count = 0;
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < corner_count(mesh->faces[f]); k++) number[mesh->faces[f][k]] = 1;
  for (int v = 0; v < mesh->vertex_count; v++) number[v] = number[v] ? count++ : -1;
  int unused = mesh->vertex_count - count;
  if (!unused) return 0;

  lam_vec3 *vertices = LAM_NEW(arena, lam_vec3, count);
  for (int v = 0; v < mesh->vertex_count; v++)
    if (number[v] >= 0) vertices[number[v]] = mesh->vertices[v];
  own_faces(arena, mesh);
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < corner_count(mesh->faces[f]); k++)
      mesh->faces[f][k] = number[mesh->faces[f][k]];

  mesh->vertices = vertices;
  mesh->vertex_count = count;
  return unused;
}

/* ---- orientation ---- */

/* Half-edge h = 4 f + k runs from corner k of face f to the next one. */
typedef struct halves {
  const lam_mesh *mesh;
  uint64_t mask;
  int *first, *next; /* lists of half-edges: per slot of their ends; per half-edge; -1: no more */
} halves;

static void ends_of(const lam_mesh *mesh, int h, int *from, int *to) {
  const int *face = mesh->faces[h >> 2];
  *from = face[h & 3];
  *to = face[((h & 3) + 1) % corner_count(face)];
}

/* The same for both directions of an edge. */
static uint64_t edge_slot(const halves *s, int from, int to) {
  uint64_t low = (uint64_t)(from < to ? from : to), high = (uint64_t)(from < to ? to : from);
  uint64_t hash = (low << 32 | high) * 0xff51afd7ed558ccdULL;
  return (hash ^ (hash >> 33)) & s->mask;
}

static halves halves_new(lam_arena *arena, const lam_mesh *mesh) {
  halves s = {.mesh = mesh, .mask = 15, .next = LAM_NEW(arena, int, 4 * (size_t)mesh->face_count)};
  while (s.mask < 4 * (uint64_t)mesh->face_count) s.mask = 2 * s.mask + 1;
  s.first = LAM_NEW(arena, int, s.mask + 1);
  memset(s.first, -1, (s.mask + 1) * sizeof *s.first);

  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < corner_count(mesh->faces[f]); k++) {
      int from, to;
      ends_of(mesh, 4 * f + k, &from, &to);
      uint64_t slot = edge_slot(&s, from, to);
      s.next[4 * f + k] = s.first[slot];
      s.first[slot] = 4 * f + k;
    }
  return s;
}

/* Whether two faces have the same corners, in whatever order. */
static bool same_corners(const int *a, const int *b) {
  for (int k = 0; k < corner_count(a); k++) {
    bool found = false;
    for (int l = 0; l < corner_count(b); l++) found |= a[k] == b[l];
    if (!found) return false;
  }
  return corner_count(a) == corner_count(b);
}

/* The only other half-edge between the ends of h; -1: there is none, or there are several, or its
 * face is the same one or has the same corners. *against: they run against each other, as they
 * should. */
static int partner_of(const halves *s, int h, bool *against) {
  int from, to, a, b, partner = -1;
  ends_of(s->mesh, h, &from, &to);
  for (int g = s->first[edge_slot(s, from, to)]; g >= 0; g = s->next[g]) {
    ends_of(s->mesh, g, &a, &b);
    bool joins = (a == from && b == to) || (a == to && b == from);
    if (g == h || !joins) continue;
    if (partner >= 0) return -1;
    partner = g;
    *against = a == to;
  }
  bool unclear = partner >= 0 && same_corners(s->mesh->faces[h >> 2], s->mesh->faces[partner >> 2]);
  return unclear ? -1 : partner;
}

/* Spreads orientation from a face over all that are reached across edges of two faces: turn is 1
 * for faces that agree with it, -1 for the others, 0 before. Returns how many are in list. */
static int spread(const halves *s, int seed, int *turn, int *list) {
  int count = 0;
  turn[seed] = 1;
  list[count++] = seed;
  for (int i = 0; i < count; i++)
    for (int k = 0, f = list[i]; k < corner_count(s->mesh->faces[f]); k++) {
      bool against = false;
      int partner = partner_of(s, 4 * f + k, &against), g = partner >> 2;
      if (partner < 0 || turn[g]) continue;
      turn[g] = against ? turn[f] : -turn[f];
      list[count++] = g;
    }
  return count;
}

/* Turns a face: its first corner stays. */
static void turn_face(int *face) {
  int last = corner_count(face) - 1, kept = face[1];
  face[1] = face[last];
  face[last] = kept;
}

/* Turns the smaller part of every piece. Returns how many faces were turned. Pieces with one side
 * keep an edge at which faces disagree. */
static int agree(lam_arena *arena, lam_mesh *mesh) {
  halves s = halves_new(arena, mesh);
  int *turn = LAM_NEW(arena, int, mesh->face_count), *list = LAM_NEW(arena, int, mesh->face_count);
  int turned = 0;
  for (int seed = 0; seed < mesh->face_count; seed++) {
    if (turn[seed]) continue;
    int count = spread(&s, seed, turn, list), others = 0;
    for (int i = 0; i < count; i++) others += turn[list[i]] < 0;

    bool smaller = 2 * others > count; /* the seed is of the smaller part */
    for (int i = 0; smaller && i < count; i++) turn[list[i]] = -turn[list[i]];
    turned += smaller ? count - others : others;
  }
  if (!turned) return 0;

  own_faces(arena, mesh);
  for (int f = 0; f < mesh->face_count; f++)
    if (turn[f] < 0) turn_face(mesh->faces[f]);
  return turned;
}

/* ---- pieces ---- */

/* The end of the chain from vertex v, which is shortened on the way. */
static int root_of(int *parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/* Faces that share a vertex hang together. */
static int count_pieces(lam_arena *arena, const lam_mesh *mesh) {
  int *parent = LAM_NEW(arena, int, mesh->vertex_count), pieces = mesh->vertex_count;
  for (int v = 0; v < mesh->vertex_count; v++) parent[v] = v;
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 1; k < corner_count(mesh->faces[f]); k++) {
      int a = root_of(parent, mesh->faces[f][0]), b = root_of(parent, mesh->faces[f][k]);
      if (a == b) continue;
      parent[a > b ? a : b] = a < b ? a : b;
      pieces--;
    }
  return pieces;
}

/* ---- the whole ---- */

/* Wrong numbers of vertices are left for lam_net_build to tell. */
bool lam_mesh_tidy(lam_arena *arena, lam_mesh *mesh, double tolerance, lam_tidied *found,
                   int *face) {
  *found = (lam_tidied){0};
  if (!is_valid(mesh)) return true;

  if (tolerance >= 0 && !weld(arena, mesh, tolerance, found, face)) return false;
  found->unused = leave_out_unused(arena, mesh) - found->welded;
  found->turned = agree(arena, mesh);
  found->doubled = count_doubled(arena, mesh);
  found->pieces = count_pieces(arena, mesh);
  return true;
}
