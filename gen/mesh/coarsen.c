/* Coarser nets, for net/multilevel.c and design/net_stage.c.
 *
 * In a subdivided net every face has a corner that was a vertex before, two that were in the middle
 * of edges, and one that was in the middle of a face: the pattern CORNER, SIDE, MIDDLE, SIDE. One
 * face's pattern fixes its neighbors', so there are four patterns per connected piece: of those
 * that nowhere contradict themselves the one with the fewest middles on the boundary is taken (the
 * first of them). Around every middle lies one coarse face. */
#include "mesh/coarsen.h"

#include <limits.h>
#include <string.h>

typedef enum role { UNKNOWN, CORNER, SIDE, MIDDLE } role;
static const role pattern[4] = {CORNER, SIDE, MIDDLE, SIDE};

typedef struct builder {
  lam_arena *arena;
  const lam_net *net;
  int (*neighbors)[4]; /* of a face; those that there are come first, then -1 */
  role *roles;         /* per vertex */
  int *turn;           /* per face: where its CORNER is; -1: not known */
  int *queue;          /* faces of the piece, in the order in which they were reached */
  int queued;
} builder;

/* ---- the pattern ---- */

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

/* Takes the pattern away from the faces of the queue. */
static void forget(builder *b) {
  for (int i = 0; i < b->queued; i++) {
    b->turn[b->queue[i]] = -1;
    for (int k = 0; k < 4; k++) b->roles[b->net->mesh.faces[b->queue[i]][k]] = UNKNOWN;
  }
  b->queued = 0;
}

/* Spreads the pattern from face seed over its piece, whose faces it leaves in the queue. False: it
 * contradicts itself. */
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

/* The number of middles on the boundary of the piece, each counted once per face; INT_MAX when a
 * coarse face would not be a quad. */
static int cost(const builder *b) {
  const lam_net *net = b->net;
  int found = 0;
  for (int i = 0; i < b->queued; i++)
    for (int k = 0; k < 4; k++) {
      int v = net->mesh.faces[b->queue[i]][k], n = lam_net_valence(net, v);
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

/* Fills neighbors: for every face those across its edges. */
static void find_neighbors(builder *b) {
  const lam_net *net = b->net;
  memset(b->neighbors, -1, sizeof *b->neighbors * (size_t)net->mesh.face_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      int f = net->edges[e].face[side], g = net->edges[e].face[!side], k = 0;
      if (f < 0 || g < 0) continue;
      while (b->neighbors[f][k] >= 0) k++;
      b->neighbors[f][k] = g;
    }
}

/* ---- coarse faces ---- */

/* The four faces around an inner middle: their CORNERs, counterclockwise. */
static void surround_inside(const builder *b, const int *faces, int corners[4]) {
  const int(*mesh)[4] = (const int(*)[4])b->net->mesh.faces;
  int turn = b->turn[faces[0]];
  for (int k = 0, at = faces[0]; k < 4; k++) {
    int t = b->turn[at], side = mesh[at][(t + 1) & 3], next = 0;
    corners[(turn + k) & 3] = mesh[at][t];

    /* the next face counterclockwise is the one whose second SIDE is this one's first */
    while (faces[next] == at || mesh[faces[next]][(b->turn[faces[next]] + 3) & 3] != side) next++;
    at = faces[next];
  }
}

/* The two faces at a middle on a border, whose two SIDEs on the border become corners. */
static void surround_on_border(const builder *b, const int *faces, int corners[4]) {
  const int *f = b->net->mesh.faces[faces[0]], *g = b->net->mesh.faces[faces[1]];
  int turn = b->turn[faces[0]], other = b->turn[faces[1]];

  /* g comes after f counterclockwise when it shares f's first SIDE, before it otherwise */
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

/* The corners of the coarse face around the middle of faces[0..count-1], which are in increasing
 * order, into `corners`: counterclockwise, beginning so that the first edge belongs to the family
 * of the first edge of faces[0]. A single face stays as it is. */
static void surround(const builder *b, const int *faces, int count, int corners[4]) {
  if (count == 1)
    memcpy(corners, b->net->mesh.faces[faces[0]], 4 * sizeof *corners);
  else if (count == 4)
    surround_inside(b, faces, corners);
  else
    surround_on_border(b, faces, corners);
}

/* The coarse net while it is put together. Indices of vertices are those of the fine net. */
typedef struct assembly {
  int (*around)[4]; /* per middle: the faces around it, in increasing order */
  int *count;       /* per middle: how many */
  int (*corners)[4], faces;
  int *face_of; /* per middle: the coarse face around it */
  int *index;   /* per vertex: its index in the coarse net; -1: it goes */
} assembly;

static int middle_of(const builder *b, int f) {
  return b->net->mesh.faces[f][(b->turn[f] + 2) & 3];
}

/* Fills around and count. */
static void gather_faces(const builder *b, assembly *a) {
  int nv = b->net->mesh.vertex_count;
  a->around = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nv, sizeof *a->around);
  a->count = LAM_NEW(b->arena, int, nv);
  for (int f = 0; f < b->net->mesh.face_count; f++) {
    int middle = middle_of(b, f);
    a->around[middle][a->count[middle]++] = f;
  }
}

/* Makes the coarse faces, in the order of their first fine faces, with fine indices; index becomes
 * 0 for every vertex that is a corner of one. */
static void make_faces(const builder *b, assembly *a) {
  int nv = b->net->mesh.vertex_count, nf = b->net->mesh.face_count;
  a->corners = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nf, sizeof *a->corners);
  a->face_of = LAM_NEW(b->arena, int, nv);
  a->index = LAM_NEW(b->arena, int, nv);
  memset(a->index, -1, sizeof *a->index * (size_t)nv);

  for (int f = 0; f < nf; f++) {
    int middle = middle_of(b, f);
    if (a->around[middle][0] != f) continue;
    int *corners = a->corners[a->faces];
    surround(b, a->around[middle], a->count[middle], corners);
    for (int k = 0; k < 4; k++) a->index[corners[k]] = 0;
    a->face_of[middle] = a->faces++;
  }
}

/* Numbers the vertices that stay, and writes the coarse mesh with these numbers. */
static void keep_vertices(const builder *b, assembly *a, lam_coarse *coarse) {
  int nv = b->net->mesh.vertex_count, kept = 0;
  coarse->kept = LAM_NEW(b->arena, int, nv);
  for (int v = 0; v < nv; v++)
    if (a->index[v] == 0) {
      coarse->kept[kept] = v;
      a->index[v] = kept++;
    }

  coarse->mesh = (lam_mesh){kept, LAM_NEW(b->arena, lam_vec3, kept), a->faces, a->corners};
  for (int v = 0; v < kept; v++) coarse->mesh.vertices[v] = b->net->mesh.vertices[coarse->kept[v]];
  for (int f = 0; f < a->faces; f++)
    for (int k = 0; k < 4; k++) a->corners[f][k] = a->index[a->corners[f][k]];
}

/* ---- parents ---- */

/* The vertices that v is the mean of, in coarse indices: those of its neighbors that stay and have
 * the role `wanted`; the first two of them, twice each. */
static void mean_of_neighbors(const lam_net *net, const int *index, const role *roles, role wanted,
                              int v, int parents[4]) {
  int n = 0;
  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
    int w = net->ring[i];
    if (roles[w] == wanted && index[w] >= 0 && n < 2) parents[n] = parents[n + 2] = index[w], n++;
  }
}

/* Fills the parents of all fine vertices. */
static void find_parents(const builder *b, const assembly *a, lam_coarse *coarse) {
  const lam_net *net = b->net;
  int nv = net->mesh.vertex_count;
  coarse->parents = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nv, sizeof *coarse->parents);

  for (int v = 0; v < nv; v++) {
    int *parents = coarse->parents[v];
    if (a->index[v] >= 0)
      for (int k = 0; k < 4; k++) parents[k] = a->index[v];
    else if (b->roles[v] == SIDE)
      mean_of_neighbors(net, a->index, b->roles, CORNER, v, parents);
    else if (net->boundary[v]) /* between the SIDEs of the border */
      mean_of_neighbors(net, a->index, b->roles, SIDE, v, parents);
    else
      memcpy(parents, a->corners[a->face_of[v]], 4 * sizeof *parents);
  }
}

/* ---- the whole ---- */

/* Finds the pattern of every piece; false: a piece has none. */
static bool find_patterns(builder *b) {
  int nf = b->net->mesh.face_count;
  b->neighbors = (int(*)[4])lam_arena_alloc(b->arena, (size_t)nf, sizeof *b->neighbors);
  b->roles = LAM_NEW(b->arena, role, b->net->mesh.vertex_count);
  b->turn = LAM_NEW(b->arena, int, nf);
  b->queue = LAM_NEW(b->arena, int, nf);
  memset(b->turn, -1, sizeof *b->turn * (size_t)nf);
  find_neighbors(b);
  for (int f = 0; f < nf; f++)
    if (b->turn[f] < 0 && !find_pattern(b, f)) return false;
  return true;
}

/* Patterns first: only when every piece has one is anything written to coarse. */
const char *lam_net_coarsen(lam_arena *arena, const lam_net *net, lam_coarse *coarse) {
  if (net->mesh.face_count < 2) return "it has a single face";
  for (int l = 0; l < net->polyline_count; l++)
    if (net->polylines[l].closed && net->polylines[l].count < 6)
      return "a closed line has fewer than 6 edges";

  builder b = {.arena = arena, .net = net};
  if (!find_patterns(&b))
    return "its lines do not pair up: a closed line has an odd number of edges, or irregular "
           "vertices lie an odd number of edges apart";

  assembly a = {0};
  gather_faces(&b, &a);
  make_faces(&b, &a);
  keep_vertices(&b, &a, coarse);
  find_parents(&b, &a, coarse);
  return NULL;
}
