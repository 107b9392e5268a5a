#include "net/multilevel.h"

#include <string.h>

/* In a net that was refined by halving, every face has an old vertex, an edge's middle, a face's middle and an edge's
 * middle at its corners, in this order. */
typedef enum place { UNKNOWN, OLD, EDGE, FACE } place;

static int corner_of(const lam_net *net, int f, int v) {
  for (int k = 0; k < 4; k++)
    if (net->mesh.faces[f][k] == v) return k;
  return -1;
}

/* Gives the corners of face f their places; first is the corner of the old vertex. False: against what is known. */
static bool settle(const lam_net *net, int f, int first, place *places) {
  static const place order[4] = {OLD, EDGE, FACE, EDGE};
  for (int k = 0; k < 4; k++) {
    place *at = &places[net->mesh.faces[f][(first + k) & 3]];
    if (*at != UNKNOWN && *at != order[k]) return false;
    *at = order[k];
  }
  return true;
}

/* The corner of the old vertex in a face one of whose edges is settled; -1: it has two like ends. */
static int old_corner(const lam_net *net, int f, const lam_edge *edge, const place *places) {
  for (int k = 0; k < 2; k++) {
    int c = corner_of(net, f, edge->vertex[k]);
    if (places[edge->vertex[k]] == OLD) return c;
    if (places[edge->vertex[k]] == FACE) return (c + 2) & 3;
  }
  return -1;
}

/* Spreads the places from face 0 over the net; edges_of lists the edges of every face. */
static bool spread(lam_arena *arena, const lam_net *net, int (*edges_of)[4], int first, place *places) {
  int faces = net->mesh.face_count, *queue = LAM_NEW(arena, int, faces), head = 0, tail = 0;
  bool *queued = LAM_NEW(arena, bool, faces);
  memset(places, 0, sizeof *places * (size_t)net->mesh.vertex_count);
  for (int seed = 0; seed < faces; seed++) { /* one component after the other */
    if (queued[seed]) continue;
    queued[seed] = true;
    queue[tail++] = seed;
    if (!settle(net, seed, first, places)) return false;
    while (head < tail) {
      int f = queue[head++];
      for (int k = 0; k < 4; k++) {
        const lam_edge *edge = &net->edges[edges_of[f][k]];
        int g = edge->face[0] == f ? edge->face[1] : edge->face[0], old;
        if (g < 0) continue;
        old = old_corner(net, g, edge, places);
        if (old < 0 || !settle(net, g, old, places)) return false;
        if (!queued[g]) queued[g] = true, queue[tail++] = g;
      }
    }
  }
  for (int v = 0; v < net->mesh.vertex_count; v++) { /* middles are regular, and those of faces lie inside */
    int valence = net->ring_start[v + 1] - net->ring_start[v];
    if (places[v] == FACE && (net->boundary[v] || valence != 4)) return false;
    if (places[v] == EDGE && valence != (net->boundary[v] ? 3 : 4)) return false;
  }
  return true;
}

static int (*edges_of_faces(lam_arena *arena, const lam_net *net))[4] {
  int(*edges_of)[4] = (int(*)[4])lam_arena_alloc(arena, (size_t)net->mesh.face_count, sizeof *edges_of);
  int *fill = LAM_NEW(arena, int, net->mesh.face_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++)
      if (net->edges[e].face[side] >= 0) edges_of[net->edges[e].face[side]][fill[net->edges[e].face[side]]++] = e;
  return edges_of;
}

/* The four faces around a face's middle bring one corner each. A corner is listed where it stands in its own face, so
 * that the families keep their names. around: per middle its four faces; face_of: the coarse face of a middle. */
static void coarse_face(const lam_net *net, const int *around, int middle, const int *coarse_of, int face[4]) {
  int f = around[0], at = corner_of(net, f, middle);
  for (int k = 0, first = at + 2; k < 4; k++) {
    face[(first + k) & 3] = coarse_of[net->mesh.faces[f][(at + 2) & 3]];
    int border = net->mesh.faces[f][(at + 3) & 3]; /* the edge that the next face begins with */
    for (int i = 0; i < 4; i++) {
      int g = around[i], there = corner_of(net, g, middle);
      if (net->mesh.faces[g][(there + 1) & 3] != border) continue;
      f = g;
      at = there;
      break;
    }
  }
}

static lam_mesh coarse_mesh(lam_arena *arena, const lam_net *net, const lam_vec3 *positions, const place *places,
                            int *coarse_of, int *middles) {
  int n = net->mesh.vertex_count, faces = net->mesh.face_count;
  int *around = LAM_NEW(arena, int, 4 * n), *fill = LAM_NEW(arena, int, n);
  lam_mesh mesh = {.vertices = LAM_NEW(arena, lam_vec3, n)};
  mesh.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)(faces / 4), sizeof *mesh.faces);
  for (int v = 0; v < n; v++) {
    coarse_of[v] = -1;
    if (places[v] != OLD) continue;
    coarse_of[v] = mesh.vertex_count;
    mesh.vertices[mesh.vertex_count++] = positions[v];
  }
  for (int f = 0; f < faces; f++)
    for (int k = 0; k < 4; k++) {
      int v = net->mesh.faces[f][k];
      if (places[v] == FACE) around[4 * v + fill[v]++] = f;
    }
  for (int v = 0; v < n; v++) {
    if (places[v] != FACE) continue;
    middles[mesh.face_count] = v;
    coarse_face(net, around + 4 * v, v, coarse_of, mesh.faces[mesh.face_count++]);
  }
  return mesh;
}

/* The middle of every coarse edge, in fine; every middle of an edge has two old neighbors. False: an edge has two. */
static bool match_edges(lam_arena *arena, const lam_net *fine, const place *places, const int *coarse_of,
                        const lam_net *coarse, int *middle_of_edge) {
  int n = coarse->mesh.vertex_count, *first = LAM_NEW(arena, int, n), *next = LAM_NEW(arena, int, coarse->edge_count);
  for (int v = 0; v < n; v++) first[v] = -1;
  for (int e = 0; e < coarse->edge_count; e++) {
    int low = coarse->edges[e].vertex[0] < coarse->edges[e].vertex[1] ? 0 : 1;
    next[e] = first[coarse->edges[e].vertex[low]];
    first[coarse->edges[e].vertex[low]] = e;
    middle_of_edge[e] = -1;
  }
  for (int v = 0; v < fine->mesh.vertex_count; v++) {
    int end[2], ends = 0;
    if (places[v] != EDGE) continue;
    for (int i = fine->ring_start[v]; i < fine->ring_start[v + 1]; i++)
      if (places[fine->ring[i]] == OLD && ends < 2) end[ends++] = coarse_of[fine->ring[i]];
    int low = end[0] < end[1] ? end[0] : end[1], high = end[0] + end[1] - low, e = first[low];
    while (e >= 0 && coarse->edges[e].vertex[0] + coarse->edges[e].vertex[1] != low + high) e = next[e];
    if (ends != 2 || e < 0 || middle_of_edge[e] >= 0) return false;
    middle_of_edge[e] = v;
  }
  return true;
}

static void find_nearest(const lam_net *fine, const place *places, const int *coarse_of, int *nearest) {
  for (int v = 0; v < fine->mesh.vertex_count; v++)
    if (places[v] == OLD) nearest[v] = coarse_of[v];
  for (int pass = 0; pass < 2; pass++) /* middles of edges, then of faces */
    for (int v = 0; v < fine->mesh.vertex_count; v++)
      for (int i = fine->ring_start[v]; i < fine->ring_start[v + 1]; i++)
        if (places[v] == (pass ? FACE : EDGE) && places[fine->ring[i]] == (pass ? EDGE : OLD)) {
          nearest[v] = nearest[fine->ring[i]];
          break;
        }
}

bool lam_net_coarsen(lam_arena *arena, const lam_net *fine, const lam_vec3 *positions, int least_faces,
                     lam_coarse *coarse) {
  int n = fine->mesh.vertex_count;
  if (fine->mesh.face_count % 4 != 0 || fine->mesh.face_count / 4 < least_faces) return false;
  place *places = LAM_NEW(arena, place, n);
  int(*edges_of)[4] = edges_of_faces(arena, fine);
  bool found = false;
  for (int first = 0; first < 4 && !found; first++) found = spread(arena, fine, edges_of, first, places);
  if (!found) return false;
  int *coarse_of = LAM_NEW(arena, int, n), *middles = LAM_NEW(arena, int, fine->mesh.face_count);
  lam_mesh mesh = coarse_mesh(arena, fine, positions, places, coarse_of, middles);
  lam_errors quiet = {.arena = arena}; /* a closed net of few cells may have no coarse net: that is no error */
  if (!lam_net_build(arena, &mesh, (lam_place){0}, &quiet, &coarse->net)) return false;
  coarse->fine = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++)
    if (places[v] == OLD) coarse->fine[coarse_of[v]] = v;
  int *middle_of_edge = coarse->fine + mesh.vertex_count, *middle_of_face = middle_of_edge + coarse->net.edge_count;
  if (mesh.vertex_count + coarse->net.edge_count + mesh.face_count != n ||
      !match_edges(arena, fine, places, coarse_of, &coarse->net, middle_of_edge))
    return false;
  for (int f = 0; f < mesh.face_count; f++) middle_of_face[f] = middles[f];
  coarse->nearest = LAM_NEW(arena, int, n);
  find_nearest(fine, places, coarse_of, coarse->nearest);
  return true;
}

void lam_coarse_refine(lam_arena *arena, const lam_coarse *coarse, lam_vec3 *positions) {
  lam_mesh refined = lam_net_four_point(arena, &coarse->net);
  for (int v = 0; v < refined.vertex_count; v++) positions[coarse->fine[v]] = refined.vertices[v];
}
