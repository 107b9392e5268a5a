/* In a subdivided net every face has a corner that was a vertex before, two that were in the middle
 * of edges, and one that was in the middle of a face: the pattern CORNER, SIDE, MIDDLE, SIDE. One
 * face's pattern fixes its neighbors', so there are four patterns per connected piece: the first
 * that contradicts itself nowhere and has the fewest middles on the boundary is taken. Around every
 * middle lies one coarse face. */
#include "mesh/coarsen.h"

#include <limits.h>
#include <string.h>

typedef enum role { UNKNOWN, CORNER, SIDE, MIDDLE } role;
static const role pattern[4] = {CORNER, SIDE, MIDDLE, SIDE};

typedef struct builder {
  lam_arena *arena;
  const lam_net *net;
  int (*neighbors)[4]; /* of a face; -1: none */
  role *roles;         /* per vertex */
  int *turn;           /* per face: where its CORNER is; -1: not known */
  int *queue;          /* faces of the piece, in the order in which they were reached */
  int queued;
} builder;

static int valence(const lam_net *net, int v) {
  return net->ring_start[v + 1] - net->ring_start[v];
}

/* Puts the pattern on face f, its CORNER at `turn`; false when that contradicts what is known. */
static bool put(builder *b, int f, int turn) {
  const int *c = b->net->mesh.faces[f];
  for (int k = 0; k < 4; k++) {
    role *known = &b->roles[c[(turn + k) & 3]];
    if (*known != UNKNOWN && *known != pattern[k]) return false;
  }
  for (int k = 0; k < 4; k++) b->roles[c[(turn + k) & 3]] = pattern[k];
  b->turn[f] = turn;
  return true;
}

static void forget(builder *b) {
  for (int i = 0; i < b->queued; i++) {
    b->turn[b->queue[i]] = -1;
    for (int k = 0; k < 4; k++) b->roles[b->net->mesh.faces[b->queue[i]][k]] = UNKNOWN;
  }
  b->queued = 0;
}

/* Spreads the pattern from a face over its piece. */
static bool spread(builder *b, int seed, int turn) {
  b->queue[b->queued++] = seed;
  if (!put(b, seed, turn)) return false;
  for (int head = 0; head < b->queued; head++)
    for (int k = 0; k < 4; k++) {
      int g = b->neighbors[b->queue[head]][k], t = 0;
      if (g < 0 || b->turn[g] >= 0) continue;
      b->queue[b->queued++] = g;
      while (t < 4 && !put(b, g, t)) t++;
      if (t == 4) return false;
    }
  return true;
}

/* The number of middles on the boundary of the piece; INT_MAX when a coarse face would not be a
 * quad. */
static int cost(const builder *b) {
  const lam_net *net = b->net;
  int found = 0;
  for (int i = 0; i < b->queued; i++)
    for (int k = 0; k < 4; k++) {
      int v = net->mesh.faces[b->queue[i]][k], n = valence(net, v);
      bool corner_or_straight = net->boundary[v] ? n <= 3 : n == 4;
      if (b->roles[v] != CORNER && !corner_or_straight) return INT_MAX;
      found += b->roles[v] == MIDDLE && net->boundary[v];
    }
  return found;
}

/* Whether the piece of face `seed` has a pattern, which is left in roles and turn. */
static bool find_pattern(builder *b, int seed) {
  int best = -1, least = INT_MAX;
  for (int turn = 0; turn < 4; turn++) {
    int now = spread(b, seed, turn) ? cost(b) : INT_MAX;
    if (now < least) best = turn, least = now;
    forget(b);
  }
  if (best >= 0) spread(b, seed, best);
  b->queued = 0;
  return best >= 0;
}

static void find_neighbors(builder *b) {
  const lam_net *net = b->net;
  memset(b->neighbors, -1, sizeof *b->neighbors * (size_t)net->mesh.face_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      int f = net->edges[e].face[side], k = 0;
      if (f < 0) continue;
      while (b->neighbors[f][k] >= 0) k++;
      b->neighbors[f][k] = net->edges[e].face[!side];
      if (b->neighbors[f][k] < 0) b->neighbors[f][k] = INT_MIN; /* taken: outside */
    }
}

/* The corners of the coarse face around the middle of faces[0..count-1], which are in increasing
 * order, into `corners`: counterclockwise, beginning so that the first edge belongs to the family
 * of the first edge of faces[0]. With two faces the middle lies on a border, whose two SIDEs become
 * corners; a single face stays as it is. */
static void surround(const builder *b, const int *faces, int count, int corners[4]) {
  const int(*mesh)[4] = (const int(*)[4])b->net->mesh.faces;
  int turn = b->turn[faces[0]];
  if (count == 1) {
    memcpy(corners, mesh[faces[0]], 4 * sizeof *corners);
    return;
  }
  if (count == 4) {
    for (int k = 0, at = faces[0]; k < 4; k++) {
      int t = b->turn[at], side = mesh[at][(t + 1) & 3], next = 0;
      corners[(turn + k) & 3] = mesh[at][t];
      while (faces[next] == at || mesh[faces[next]][(b->turn[faces[next]] + 3) & 3] != side) next++;
      at = faces[next];
    }
    return;
  }
  /* the face after faces[0] counterclockwise shares its first SIDE, the face before it its second
   */
  const int *f = mesh[faces[0]], *g = mesh[faces[1]];
  int other = b->turn[faces[1]];
  bool after = g[(other + 3) & 3] == f[(turn + 1) & 3];
  corners[turn] = f[turn];
  if (after) {
    corners[(turn + 1) & 3] = g[other];
    corners[(turn + 2) & 3] = g[(other + 1) & 3];
    corners[(turn + 3) & 3] = f[(turn + 3) & 3];
  } else {
    corners[(turn + 1) & 3] = f[(turn + 1) & 3];
    corners[(turn + 2) & 3] = g[(other + 3) & 3];
    corners[(turn + 3) & 3] = g[other];
  }
}

/* The vertices that v is the mean of, in fine indices: those of its neighbors that stay and have
 * `wanted`. */
static void mean_of_neighbors(const lam_net *net, const int *index, const role *roles, role wanted,
                              int v, int parents[4]) {
  int n = 0;
  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
    int w = net->ring[i];
    if (roles[w] == wanted && index[w] >= 0 && n < 2) parents[n] = parents[n + 2] = index[w], n++;
  }
}

static void assemble(builder *b, lam_coarse *coarse) {
  const lam_net *net = b->net;
  int nv = net->mesh.vertex_count, nf = net->mesh.face_count;
  int(*around)[4] = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nv, sizeof *around);
  int *count = LAM_NEW(b->arena, int, nv), *index = LAM_NEW(b->arena, int, nv);
  int(*corners)[4] = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nf, sizeof *corners);
  int *face_of = LAM_NEW(b->arena, int, nv), faces = 0;
  for (int f = 0; f < nf; f++) {
    int middle = net->mesh.faces[f][(b->turn[f] + 2) & 3];
    around[middle][count[middle]++] = f;
  }
  memset(index, -1, sizeof *index * (size_t)nv);
  for (int f = 0; f < nf; f++) {
    int middle = net->mesh.faces[f][(b->turn[f] + 2) & 3];
    if (around[middle][0] != f) continue;
    surround(b, around[middle], count[middle], corners[faces]);
    for (int k = 0; k < 4; k++) index[corners[faces][k]] = 0;
    face_of[middle] = faces++;
  }
  int kept = 0;
  coarse->kept = LAM_NEW(b->arena, int, nv);
  for (int v = 0; v < nv; v++)
    if (index[v] == 0) {
      coarse->kept[kept] = v;
      index[v] = kept++;
    }
  coarse->mesh = (lam_mesh){kept, LAM_NEW(b->arena, lam_vec3, kept), faces, corners};
  for (int v = 0; v < kept; v++) coarse->mesh.vertices[v] = net->mesh.vertices[coarse->kept[v]];
  for (int f = 0; f < faces; f++)
    for (int k = 0; k < 4; k++) corners[f][k] = index[corners[f][k]];
  coarse->parents = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nv, sizeof *coarse->parents);
  for (int v = 0; v < nv; v++) {
    int *parents = coarse->parents[v];
    if (index[v] >= 0)
      for (int k = 0; k < 4; k++) parents[k] = index[v];
    else if (b->roles[v] == SIDE)
      mean_of_neighbors(net, index, b->roles, CORNER, v, parents);
    else if (net->boundary[v]) /* between the SIDEs of the border */
      mean_of_neighbors(net, index, b->roles, SIDE, v, parents);
    else
      memcpy(parents, corners[face_of[v]], 4 * sizeof *parents);
  }
}

const char *lam_net_coarsen(lam_arena *arena, const lam_net *net, lam_coarse *coarse) {
  int nv = net->mesh.vertex_count, nf = net->mesh.face_count;
  builder b = {.arena = arena, .net = net};
  if (nf < 2) return "it has a single face";
  for (int l = 0; l < net->polyline_count; l++)
    if (net->polylines[l].closed && net->polylines[l].count < 6)
      return "a closed line has fewer than 6 edges";
  b.neighbors = (int(*)[4])lam_arena_alloc(arena, (size_t)nf, sizeof *b.neighbors);
  b.roles = LAM_NEW(arena, role, nv);
  b.turn = LAM_NEW(arena, int, nf);
  b.queue = LAM_NEW(arena, int, nf);
  memset(b.turn, -1, sizeof *b.turn * (size_t)nf);
  find_neighbors(&b);
  for (int f = 0; f < nf; f++)
    if (b.turn[f] < 0 && !find_pattern(&b, f))
      return "its lines do not pair up: a closed line has an odd number of edges, or irregular "
             "vertices lie an odd "
             "number of edges apart";
  assemble(&b, coarse);
  return NULL;
}
