#include "mesh/net.h"

#include <stdlib.h>
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
  int *twin;    /* per half-edge, -1 on the boundary */
  int *edge_of; /* per half-edge */
} builder;

static bool check_faces(const builder *b) {
  const lam_mesh *mesh = &b->net->mesh;
  int before = b->errors->count;
  bool *used = LAM_NEW(b->arena, bool, mesh->vertex_count);
  for (int f = 0; f < mesh->face_count; f++) {
    const int *corner = mesh->faces[f];
    if (corner[3] < 0) {
      lam_error_add(b->errors, b->location, NULL,
                    "face %d is a triangle; a net needs faces with four corners", f + 1);
      return false;
    }
    for (int k = 0; k < 4; k++) {
      if (corner[k] < 0 || corner[k] >= mesh->vertex_count) {
        lam_error_add(b->errors, b->location, NULL,
                      "face %d names vertex %d; the mesh has vertices 1 to %d", f + 1,
                      corner[k] + 1, mesh->vertex_count);
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
  }
  for (int v = 0; v < mesh->vertex_count; v++)
    if (!used[v]) {
      lam_error_add(b->errors, b->location, NULL, "vertex %d belongs to no face", v + 1);
      break;
    }
  if (mesh->face_count == 0) lam_error_add(b->errors, b->location, NULL, "the mesh has no faces");
  return b->errors->count == before;
}

/* Pairs half-edges into edges. Edges of a vertex (the smaller end) are kept in a list: valences are
 * small. */
static bool pair_edges(builder *b) {
  lam_net *net = b->net;
  const lam_mesh *mesh = &net->mesh;
  int half_edges = 4 * mesh->face_count;
  net->edges = LAM_NEW(b->arena, lam_edge, half_edges);
  int *first = LAM_NEW(b->arena, int, mesh->vertex_count),
      *next = LAM_NEW(b->arena, int, half_edges);
  int *half_edge_of = LAM_NEW(b->arena, int, half_edges);
  memset(first, -1, sizeof(int) * (size_t)mesh->vertex_count);
  for (int h = 0; h < half_edges; h++) {
    int from = start_of(mesh, h), to = end_of(mesh, h), low = from < to ? from : to, e = first[low];
    while (e >= 0 && !(net->edges[e].vertex[0] == from && net->edges[e].vertex[1] == to) &&
           !(net->edges[e].vertex[0] == to && net->edges[e].vertex[1] == from))
      e = next[e];
    b->twin[h] = -1;
    if (e < 0) {
      e = net->edge_count++;
      net->edges[e] = (lam_edge){{from, to}, {h >> 2, -1}, 0};
      half_edge_of[e] = h;
      next[e] = first[low];
      first[low] = e;
    } else if (net->edges[e].face[1] >= 0) {
      lam_error_add(b->errors, b->location, NULL,
                    "the edge of vertices %d and %d has more than two faces", from + 1, to + 1);
      return false;
    } else if (net->edges[e].vertex[0] == from) {
      lam_error_add(b->errors, b->location, NULL,
                    "faces %d and %d at the edge of vertices %d and %d disagree in orientation",
                    net->edges[e].face[0] + 1, (h >> 2) + 1, from + 1, to + 1);
      return false;
    } else {
      net->edges[e].face[1] = h >> 2;
      b->twin[h] = half_edge_of[e];
      b->twin[half_edge_of[e]] = h;
    }
    b->edge_of[h] = e;
  }
  return true;
}

/* Counterclockwise one-rings: after the edge v -> a of a face comes the edge v -> b, b being the
 * corner before v. */
static bool order_rings(builder *b) {
  lam_net *net = b->net;
  const lam_mesh *mesh = &net->mesh;
  int half_edges = 4 * mesh->face_count, n = mesh->vertex_count;
  int *outgoing = LAM_NEW(b->arena, int, n), *fan = LAM_NEW(b->arena, int, n);
  net->ring_start = LAM_NEW(b->arena, int, n + 1);
  net->ring = LAM_NEW(b->arena, int, 2 * net->edge_count);
  net->boundary = LAM_NEW(b->arena, bool, n);
  memset(outgoing, -1, sizeof(int) * (size_t)n);
  for (int h = half_edges - 1; h >= 0; h--) {
    int v = start_of(mesh, h);
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
  for (int v = 0, filled = 0; v < n; v++) {
    net->ring_start[v] = filled;
    int faces = 0, h = outgoing[v];
    do {
      net->ring[filled++] = end_of(mesh, h);
      faces++;
      int p = previous_of(h);
      if (b->twin[p] < 0) {
        net->ring[filled++] = start_of(mesh, p);
        break;
      }
      h = b->twin[p];
    } while (h != outgoing[v]);
    if (faces != fan[v]) {
      lam_error_add(b->errors, b->location, NULL, "the faces at vertex %d do not form one fan",
                    v + 1);
      return false;
    }
    net->ring_start[v + 1] = filled;
    if (!net->boundary[v] && faces != 4) net->irregular_count++;
  }
  return true;
}

/* Two-colors the edges: opposite edges of a face belong to the same family, neighboring ones do
 * not. */
static void color_families(builder *b) {
  lam_net *net = b->net;
  int faces = net->mesh.face_count, *queue = LAM_NEW(b->arena, int, faces);
  bool *seen = LAM_NEW(b->arena, bool, faces), *colored = LAM_NEW(b->arena, bool, net->edge_count);
  for (int seed = 0; seed < faces; seed++) {
    if (seen[seed]) continue;
    int head = 0, tail = 0;
    queue[tail++] = seed;
    seen[seed] = true;
    while (head < tail) {
      int f = queue[head++], color = 0;
      for (int k = 0; k < 4; k++)
        if (colored[b->edge_of[4 * f + k]]) {
          color = net->edges[b->edge_of[4 * f + k]].family ^ (k & 1);
          break;
        }
      for (int k = 0; k < 4; k++) {
        int h = 4 * f + k, e = b->edge_of[h], family = color ^ (k & 1);
        if (colored[e] && net->edges[e].family != family) net->family_conflicts++;
        if (!colored[e]) net->edges[e].family = family;
        colored[e] = true;
        if (b->twin[h] >= 0 && !seen[b->twin[h] >> 2]) {
          seen[b->twin[h] >> 2] = true;
          queue[tail++] = b->twin[h] >> 2;
        }
      }
    }
  }
}

/* The half-edge or reversed half-edge that continues the line from -> at, or -1. */
static int line_continues(const lam_net *net, int from, int at) {
  const int *ring = net->ring + net->ring_start[at];
  int valence = net->ring_start[at + 1] - net->ring_start[at];
  if (net->boundary[at]) { /* along a straight border, or through a reentrant corner with its three
                              faces */
    if (valence != 3 && valence != 4) return -1;
    for (int k = 0; k + 2 < valence; k++) {
      if (ring[k] == from) return ring[k + 2];
      if (ring[k + 2] == from) return ring[k];
    }
    return -1;
  }
  if (valence != 4) return -1;
  for (int k = 0; k < 4; k++)
    if (ring[k] == from) return ring[(k + 2) & 3];
  return -1;
}

static int edge_between(const lam_net *net, const int *edge_first, const int *edge_list, int a,
                        int c) {
  for (int i = edge_first[a]; i < edge_first[a + 1]; i++) {
    const lam_edge *e = &net->edges[edge_list[i]];
    if (e->vertex[0] == c || e->vertex[1] == c) return edge_list[i];
  }
  return -1;
}

static int compare_lines(const void *a, const void *b) {
  const lam_polyline *p = a, *q = b;
  if (p->family != q->family) return p->family - q->family;
  return p->vertices[0] != q->vertices[0] ? p->vertices[0] - q->vertices[0]
                                          : p->vertices[1] - q->vertices[1];
}

static void reverse(int *v, int n) {
  for (int i = 0; i < n / 2; i++) {
    int swap = v[i];
    v[i] = v[n - 1 - i];
    v[n - 1 - i] = swap;
  }
}

/* Open lines start at their end with the smaller index; closed ones at their smallest index,
 * towards its smaller neighbor. */
static void orient_line(lam_polyline *line) {
  int n = line->count, *v = line->vertices;
  if (!line->closed) {
    if (v[0] > v[n - 1]) reverse(v, n);
    return;
  }
  int low = 0;
  for (int i = 1; i < n; i++)
    if (v[i] < v[low]) low = i;
  reverse(v, low); /* rotate left by low */
  reverse(v + low, n - low);
  reverse(v, n);
  if (v[1] > v[n - 1]) reverse(v + 1, n - 1);
}

static void trace_lines(builder *b) {
  lam_net *net = b->net;
  int n = net->mesh.vertex_count;
  int *first = LAM_NEW(b->arena, int, n + 1), *list = LAM_NEW(b->arena, int, 2 * net->edge_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) first[net->edges[e].vertex[k] + 1]++;
  for (int v = 0; v < n; v++) first[v + 1] += first[v];
  int *fill = LAM_NEW(b->arena, int, n);
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      int v = net->edges[e].vertex[k];
      list[first[v] + fill[v]++] = e;
    }
  bool *done = LAM_NEW(b->arena, bool, net->edge_count);
  net->polylines = LAM_NEW(b->arena, lam_polyline, net->edge_count);
  int *buffer = LAM_NEW(b->arena, int, 2 * net->edge_count + 4);
  for (int e = 0; e < net->edge_count; e++) {
    if (done[e]) continue;
    done[e] = true;
    /* forwards from the middle of the buffer, then backwards */
    int low = net->edge_count + 1, high = low + 1;
    buffer[low] = net->edges[e].vertex[0];
    buffer[high] = net->edges[e].vertex[1];
    bool closed = false;
    for (int side = 0; side < 2 && !closed; side++)
      for (;;) {
        int at = side ? buffer[low] : buffer[high],
            from = side ? buffer[low + 1] : buffer[high - 1];
        int to = line_continues(net, from, at);
        if (to < 0) break;
        int step = edge_between(net, first, list, at, to);
        if (done[step]) {
          closed = step == e;
          break;
        }
        done[step] = true;
        if (side)
          buffer[--low] = to;
        else
          buffer[++high] = to;
      }
    if (closed) high--;
    lam_polyline line = {net->edges[e].family, closed, high - low + 1,
                         LAM_NEW(b->arena, int, high - low + 1)};
    memcpy(line.vertices, buffer + low, sizeof(int) * (size_t)line.count);
    orient_line(&line);
    net->polylines[net->polyline_count++] = line;
  }
  qsort(net->polylines, (size_t)net->polyline_count, sizeof *net->polylines, compare_lines);
}

static void list_stars(builder *b) {
  lam_net *net = b->net;
  int n = net->mesh.vertex_count;
  net->stars = LAM_NEW(b->arena, lam_star, n);
  net->star_of_vertex = LAM_NEW(b->arena, int, n);
  int *ahead = LAM_NEW(b->arena, int, n); /* next vertex on the line of family 0 */
  memset(ahead, -1, sizeof(int) * (size_t)n);
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->family != 0) continue;
    for (int i = 0; i + 1 < line->count; i++) ahead[line->vertices[i]] = line->vertices[i + 1];
    if (line->closed) ahead[line->vertices[line->count - 1]] = line->vertices[0];
  }
  for (int v = 0; v < n; v++) {
    const int *ring = net->ring + net->ring_start[v];
    net->star_of_vertex[v] = -1;
    if (net->boundary[v] || net->ring_start[v + 1] - net->ring_start[v] != 4) continue;
    int k = 0;
    while (k < 3 && ring[k] != ahead[v]) k++;
    if (ring[k] != ahead[v]) k = 0; /* only where families conflict */
    net->star_of_vertex[v] = net->star_count;
    net->stars[net->star_count++] =
        (lam_star){v, {ring[k], ring[(k + 1) & 3], ring[(k + 2) & 3], ring[(k + 3) & 3]}};
  }
}

static void trace_loops(builder *b) {
  lam_net *net = b->net;
  const lam_mesh *mesh = &net->mesh;
  int n = mesh->vertex_count, boundary_edges = 0, *ahead = LAM_NEW(b->arena, int, n);
  for (int h = 0; h < 4 * mesh->face_count; h++)
    if (b->twin[h] < 0) {
      ahead[start_of(mesh, h)] = end_of(mesh, h);
      boundary_edges++;
    }
  bool *done = LAM_NEW(b->arena, bool, n);
  net->loops = LAM_NEW(b->arena, lam_polyline, boundary_edges);
  int *pool = LAM_NEW(b->arena, int, boundary_edges);
  for (int v = 0; v < n; v++) {
    if (!net->boundary[v] || done[v]) continue;
    lam_polyline loop = {-1, true, 0, pool};
    for (int at = v; !done[at]; at = ahead[at]) {
      done[at] = true;
      loop.vertices[loop.count++] = at;
    }
    pool += loop.count;
    net->loops[net->loop_count++] = loop;
  }
}

bool lam_net_build(lam_arena *arena, const lam_mesh *mesh, lam_location location,
                   lam_errors *errors, lam_net *net) {
  *net = (lam_net){.mesh = *mesh};
  builder b = {arena, errors, location, net, NULL, NULL};
  if (!check_faces(&b)) return false;
  net->mesh.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  memcpy(net->mesh.vertices, mesh->vertices, sizeof(lam_vec3) * (size_t)mesh->vertex_count);
  net->mesh.faces =
      (int(*)[4])lam_arena_alloc(arena, (size_t)mesh->face_count, sizeof *mesh->faces);
  memcpy(net->mesh.faces, mesh->faces, sizeof *mesh->faces * (size_t)mesh->face_count);
  b.twin = LAM_NEW(arena, int, 4 * mesh->face_count);
  b.edge_of = LAM_NEW(arena, int, 4 * mesh->face_count);
  if (!pair_edges(&b) || !order_rings(&b)) return false;
  color_families(&b);
  trace_lines(&b);
  list_stars(&b);
  trace_loops(&b);
  return true;
}

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

void lam_net_normals(const lam_net *net, const lam_vec3 *positions, lam_vec3 *normals) {
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int first = net->ring_start[v], valence = net->ring_start[v + 1] - first;
    lam_vec3 sum = {0, 0, 0};
    lam_vec3 start = lam_unit(lam_sub(positions[net->ring[first]], positions[v])), before = start;
    for (int k = 1; k < valence; k++) {
      lam_vec3 e = lam_unit(lam_sub(positions[net->ring[first + k]], positions[v]));
      sum = lam_add(sum, lam_cross(before, e));
      before = e;
    }
    if (!net->boundary[v]) sum = lam_add(sum, lam_cross(before, start));
    normals[v] = lam_unit(sum);
  }
}

double lam_net_mean_edge(const lam_net *net, const lam_vec3 *positions) {
  double sum = 0;
  for (int e = 0; e < net->edge_count; e++)
    sum += lam_distance(positions[net->edges[e].vertex[0]], positions[net->edges[e].vertex[1]]);
  return net->edge_count ? sum / net->edge_count : 0;
}
