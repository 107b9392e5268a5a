/* Connectivity of a quad mesh: edges, one-rings and the two families. lam_net_build is called
 * wherever a mesh becomes a net (design/net_stage.c, net/multilevel.c, library); lines,
 * stars and loops come from net_lines.c. The normals, mean edge and grids here serve all rooms. */
#include "mesh/net.h"
#include "mesh/net_lines.h"

#include <string.h>

/* Half-edge h = 4 f + k runs from corner k to corner k + 1 of face f. */
static int start_of(const lam_mesh *mesh, int h) { return mesh->faces[h >> 2][h & 3]; }
static int end_of(const lam_mesh *mesh, int h) { return mesh->faces[h >> 2][(h + 1) & 3]; }
static int previous_of(int h) { return (h & ~3) | ((h + 3) & 3); }

typedef struct builder {
  lam_arena *arena;
  lam_errors *errors;
  lam_location location;
  lam_net *net;
  int *twin;       /* per half-edge, -1 on the boundary */
  int *edge_of;    /* per half-edge */
  int *first_half; /* per edge: the half-edge that it was made for */
  /* Edges found so far, in a list at their end with the smaller index; -1 ends a list. Valences
   * are small, so lists are searched. */
  int *first_edge, *next_edge;
} builder;

/* ---- faces ---- */

/* Whether face f has four different corners among the vertices, which are marked as used. Adds an
 * error when not. */
static bool check_face(const builder *b, int f, bool *used) {
  const lam_mesh *mesh = &b->net->mesh;
  const int *corner = mesh->faces[f];
  if (corner[3] < 0) {
    lam_error_add(b->errors, b->location, NULL,
                  "face %d is a triangle; a net needs faces with four corners", f + 1);
    return false;
  }

  for (int k = 0; k < 4; k++) {
    if (corner[k] < 0 || corner[k] >= mesh->vertex_count) {
      lam_error_add(b->errors, b->location, NULL,
                    "face %d names vertex %d; the mesh has vertices 1 to %d", f + 1, corner[k] + 1,
                    mesh->vertex_count);
      return false;
    }
    used[corner[k]] = true;
    for (int l = 0; l < k; l++)
      if (corner[l] == corner[k]) {
        lam_error_add(b->errors, b->location, NULL, "face %d names vertex %d twice", f + 1,
                      corner[k] + 1);
        return false;
      }
  }
  return true;
}

/* Whether all faces are quads, every vertex has a face, and there is a face. Adds errors when not:
 * the first bad face, or the first unused vertex. */
static bool check_faces(const builder *b) {
  const lam_mesh *mesh = &b->net->mesh;
  int before = b->errors->count;
  bool *used = LAM_NEW(b->arena, bool, mesh->vertex_count);
  for (int f = 0; f < mesh->face_count; f++)
    if (!check_face(b, f, used)) return false;

  for (int v = 0; v < mesh->vertex_count; v++)
    if (!used[v]) {
      lam_error_add(b->errors, b->location, NULL, "vertex %d belongs to no face", v + 1);
      break;
    }
  if (mesh->face_count == 0) lam_error_add(b->errors, b->location, NULL, "the mesh has no faces");
  return b->errors->count == before;
}

/* ---- edges ---- */

/* The edge of half-edge h among those made so far, or -1. */
static int find_edge(const builder *b, int h) {
  const lam_mesh *mesh = &b->net->mesh;
  int from = start_of(mesh, h), to = end_of(mesh, h), e = b->first_edge[from < to ? from : to];
  while (e >= 0 && !lam_edge_joins(&b->net->edges[e], from, to)) e = b->next_edge[e];
  return e;
}

/* Makes an edge of the first half-edge between two vertices: its face is on the left. */
static int open_edge(builder *b, int h) {
  const lam_mesh *mesh = &b->net->mesh;
  int from = start_of(mesh, h), to = end_of(mesh, h), low = from < to ? from : to;
  int e = b->net->edge_count++;
  b->net->edges[e] = (lam_edge){{from, to}, {h >> 2, -1}, 0};
  b->first_half[e] = h;
  b->next_edge[e] = b->first_edge[low];
  b->first_edge[low] = e;
  return e;
}

/* Gives edge e its second half-edge. False with an error: it has two already, or both run the same
 * way, so that the faces disagree in orientation. */
static bool close_edge(builder *b, int e, int h) {
  lam_edge *edge = &b->net->edges[e];
  int from = start_of(&b->net->mesh, h), to = end_of(&b->net->mesh, h);
  if (edge->face[1] >= 0) {
    lam_error_add(b->errors, b->location, NULL,
                  "the edge of vertices %d and %d has more than two faces", from + 1, to + 1);
    return false;
  }
  if (edge->vertex[0] == from) {
    lam_error_add(b->errors, b->location, NULL,
                  "faces %d and %d at the edge of vertices %d and %d disagree in orientation",
                  edge->face[0] + 1, (h >> 2) + 1, from + 1, to + 1);
    return false;
  }

  edge->face[1] = h >> 2;
  b->twin[h] = b->first_half[e];
  b->twin[b->first_half[e]] = h;
  return true;
}

/* Pairs half-edges into edges, in the order of the faces. */
static bool pair_edges(builder *b) {
  int n = b->net->mesh.vertex_count, half_edges = 4 * b->net->mesh.face_count;
  b->net->edges = LAM_NEW(b->arena, lam_edge, half_edges);
  b->first_edge = LAM_NEW(b->arena, int, n);
  b->next_edge = LAM_NEW(b->arena, int, half_edges);
  b->first_half = LAM_NEW(b->arena, int, half_edges);
  memset(b->first_edge, -1, sizeof(int) * (size_t)n);

  for (int h = 0; h < half_edges; h++) {
    int e = find_edge(b, h);
    b->twin[h] = -1;
    if (e < 0)
      e = open_edge(b, h);
    else if (!close_edge(b, e, h))
      return false;
    b->edge_of[h] = e;
  }
  return true;
}

/* ---- rings ---- */

/* Per vertex: the half-edge with which its ring begins, and the number of its faces. On the
 * boundary that is the boundary half-edge, elsewhere the first one of the faces' order. False with
 * an error: a vertex has two boundary half-edges. */
static bool find_outgoing(builder *b, int *outgoing, int *fan) {
  lam_net *net = b->net;

  /* downwards, so that the first half-edge of an inner vertex is written last */
  for (int h = 4 * net->mesh.face_count - 1; h >= 0; h--) {
    int v = start_of(&net->mesh, h);
    fan[v]++;
    if (b->twin[h] < 0) {
      if (net->boundary[v]) {
        lam_error_add(b->errors, b->location, NULL, "vertex %d touches the boundary more than once",
                      v + 1);
        return false;
      }
      net->boundary[v] = true;
      outgoing[v] = h;
    } else if (!net->boundary[v]) {
      outgoing[v] = h;
    }
  }
  return true;
}

/* Writes the ends of the edges around a vertex counterclockwise to ring, *count of them, beginning
 * with half-edge `first`: after the edge v -> a of a face comes v -> b, b being the corner before
 * v. Returns the number of faces passed. */
static int walk_around(const builder *b, int first, int *ring, int *count) {
  const lam_mesh *mesh = &b->net->mesh;
  int faces = 0, h = first;
  *count = 0;

  do {
    ring[(*count)++] = end_of(mesh, h);
    faces++;
    int p = previous_of(h);
    if (b->twin[p] < 0) { /* the last edge of a boundary vertex */
      ring[(*count)++] = start_of(mesh, p);
      break;
    }
    h = b->twin[p];
  } while (h != first);
  return faces;
}

/* One-rings of all vertices. False with an error when the faces of a vertex do not hang together
 * around it. */
static bool order_rings(builder *b) {
  lam_net *net = b->net;
  int n = net->mesh.vertex_count;
  int *outgoing = LAM_NEW(b->arena, int, n), *fan = LAM_NEW(b->arena, int, n);
  net->ring_start = LAM_NEW(b->arena, int, n + 1);
  net->ring = LAM_NEW(b->arena, int, 2 * net->edge_count);
  net->boundary = LAM_NEW(b->arena, bool, n);
  memset(outgoing, -1, sizeof(int) * (size_t)n);
  if (!find_outgoing(b, outgoing, fan)) return false;

  for (int v = 0; v < n; v++) {
    int first = net->ring_start[v], valence;
    int faces = walk_around(b, outgoing[v], net->ring + first, &valence);
    if (faces != fan[v]) {
      lam_error_add(b->errors, b->location, NULL, "the faces at vertex %d do not form one fan",
                    v + 1);
      return false;
    }
    net->ring_start[v + 1] = first + valence;
    if (!net->boundary[v] && faces != 4) net->irregular_count++;
  }
  return true;
}

/* ---- families ---- */

/* Colors the edges of face f, alternating, so that its first colored edge keeps its color; without
 * one its first edge is of family 0. Counts the edges that have the other color already. */
static void color_face(builder *b, bool *colored, int f) {
  lam_net *net = b->net;
  const int *edge_of = b->edge_of + 4 * f;
  int color = 0;
  for (int k = 0; k < 4; k++)
    if (colored[edge_of[k]]) {
      color = net->edges[edge_of[k]].family ^ (k & 1);
      break;
    }

  for (int k = 0; k < 4; k++) {
    int e = edge_of[k], family = color ^ (k & 1);
    if (colored[e] && net->edges[e].family != family) net->family_conflicts++;
    if (!colored[e]) net->edges[e].family = family;
    colored[e] = true;
  }
}

/* Two-colors the edges: opposite edges of a face belong to the same family, neighboring ones do
 * not. The color spreads from the first face of every connected piece. */
static void color_families(builder *b) {
  int faces = b->net->mesh.face_count, *queue = LAM_NEW(b->arena, int, faces);
  bool *seen = LAM_NEW(b->arena, bool, faces);
  bool *colored = LAM_NEW(b->arena, bool, b->net->edge_count);

  for (int seed = 0; seed < faces; seed++) {
    if (seen[seed]) continue;
    int head = 0, tail = 0;
    queue[tail++] = seed;
    seen[seed] = true;
    while (head < tail) {
      int f = queue[head++];
      color_face(b, colored, f);
      for (int k = 0; k < 4; k++) {
        int twin = b->twin[4 * f + k], neighbor = twin >> 2;
        if (twin < 0 || seen[neighbor]) continue;
        seen[neighbor] = true;
        queue[tail++] = neighbor;
      }
    }
  }
}

/* ---- the whole ---- */

/* The net's own copy of the mesh, so that the caller's may change. */
static lam_mesh copy_mesh(lam_arena *arena, const lam_mesh *mesh) {
  lam_mesh copy = *mesh;
  copy.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  copy.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)mesh->face_count, sizeof *mesh->faces);
  memcpy(copy.vertices, mesh->vertices, sizeof(lam_vec3) * (size_t)mesh->vertex_count);
  memcpy(copy.faces, mesh->faces, sizeof *mesh->faces * (size_t)mesh->face_count);
  return copy;
}

/* Every step needs what the ones before it found. */
bool lam_net_build(lam_arena *arena, const lam_mesh *mesh, lam_location location,
                   lam_errors *errors, lam_net *net) {
  *net = (lam_net){.mesh = *mesh};
  builder b = {.arena = arena, .errors = errors, .location = location, .net = net};
  if (!check_faces(&b)) return false;

  net->mesh = copy_mesh(arena, mesh);
  b.twin = LAM_NEW(arena, int, 4 * mesh->face_count);
  b.edge_of = LAM_NEW(arena, int, 4 * mesh->face_count);
  if (!pair_edges(&b) || !order_rings(&b)) return false;

  color_families(&b);
  lam_net_trace_lines(arena, net);
  lam_net_list_stars(arena, net);
  lam_net_trace_loops(arena, net);
  return true;
}

/* The first edge of every face, from (i, j) to (i + 1, j), runs along family 0. */
lam_mesh lam_mesh_grid(lam_arena *arena, int n, int m, bool closed_u, bool closed_v) {
  int rows = closed_u ? n : n - 1, columns = closed_v ? m : m - 1;
  lam_mesh mesh = {n * m, LAM_NEW(arena, lam_vec3, n * m), rows * columns, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)mesh.face_count, sizeof *mesh.faces);
  for (int i = 0, f = 0; i < rows; i++)
    for (int j = 0; j < columns; j++, f++) {
      int i1 = (i + 1) % n, j1 = (j + 1) % m;
      int corners[4] = {i * m + j, i1 * m + j, i1 * m + j1, i * m + j1};
      memcpy(mesh.faces[f], corners, sizeof corners);
    }
  return mesh;
}

/* ---- positions ---- */

/* The unit normal of vertex v: along the sum of e_k x e_(k+1) over its unit edges, which is cyclic
 * inside and open on the boundary. */
static lam_vec3 normal_at(const lam_net *net, const lam_vec3 *positions, int v) {
  int first = net->ring_start[v], valence = lam_net_valence(net, v);
  lam_vec3 sum = {0, 0, 0};
  lam_vec3 start = lam_unit(lam_sub(positions[net->ring[first]], positions[v])), before = start;
  for (int k = 1; k < valence; k++) {
    lam_vec3 e = lam_unit(lam_sub(positions[net->ring[first + k]], positions[v]));
    sum = lam_add(sum, lam_cross(before, e));
    before = e;
  }
  if (!net->boundary[v]) sum = lam_add(sum, lam_cross(before, start));
  return lam_unit(sum);
}

void lam_net_normals(const lam_net *net, const lam_vec3 *positions, lam_vec3 *normals) {
  for (int v = 0; v < net->mesh.vertex_count; v++) normals[v] = normal_at(net, positions, v);
}

/* Every edge counts once. */
double lam_net_mean_edge(const lam_net *net, const lam_vec3 *positions) {
  double sum = 0;
  for (int e = 0; e < net->edge_count; e++)
    sum += lam_distance(positions[net->edges[e].vertex[0]], positions[net->edges[e].vertex[1]]);
  return net->edge_count ? sum / net->edge_count : 0;
}
