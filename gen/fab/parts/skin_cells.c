/* Cells and vertices of a skin from a net of any connectivity. Every vertex has its own
 * directions: entry j of its ring is j quarter turns from the first one, so that the cells need
 * no families that agree all over the net. Called by skin.c, and for walks along sides by
 * skin_measure.c. */
#include "fab/parts/skin.h"

#include <string.h>

enum { LINE = 5 }; /* vertices of a line that a polynomial is put through */

/* How many neighbors a vertex has. */
static int valence(const lam_net *net, int v) {
  return net->ring_start[v + 1] - net->ring_start[v];
}

/* Two lines run through the vertex, or end there. */
static bool is_regular(const lam_net *net, int v) {
  return net->boundary[v] ? valence(net, v) <= 4 : valence(net, v) == 4;
}

/* The entry of the ring of v, counted from its start, that holds the neighbor; -1: none. */
static int slot_of(const lam_net *net, int v, int neighbor) {
  for (int j = 0; j < valence(net, v); j++)
    if (net->ring[net->ring_start[v] + j] == neighbor) return j;
  return -1;
}

/* The entry `turns` quarter turns from slot, counterclockwise; -1: outside the net. At a boundary
 * vertex the ring begins at the boundary, and the quarter turns that it lacks lie outside. */
static int turn(const lam_net *net, int v, int slot, int turns) {
  int n = valence(net, v);
  if (!net->boundary[v]) return (slot + turns + n) % n;
  if (n > 4) return -1;
  slot = (slot + turns + 4) % 4;
  return slot < n ? slot : -1;
}

/* Straight ahead is two quarter turns from where the walk came from, at regular vertices only. */
int lam_skin_walk(const lam_net *net, int v, int slot, int steps, int *back) {
  for (int k = 0; k < steps; k++) {
    if (k) {
      if (!is_regular(net, v)) return -1;
      slot = turn(net, v, *back, 2);
    }
    if (slot < 0 || slot >= valence(net, v)) return -1;
    int next = net->ring[net->ring_start[v] + slot];
    *back = slot_of(net, next, v);
    v = next;
  }
  return v;
}

/* ---- derivatives at vertices ---- */

/* Vertices of the line through v along direction `axis` (0, 1), of which v has number `at`;
 * returns how many. There are LINE of them where the line is long enough: two on each side, or
 * more on one side where the other ends. */
static int line_through(const lam_net *net, int v, int axis, int line[LINE], int *at) {
  int way[2][LINE], length[2] = {0, 0}, back;
  for (int side = 0; side < 2; side++) {
    int slot = axis + 2 * side;
    if (slot >= valence(net, v)) continue;
    while (length[side] < LINE - 1) {
      int w = lam_skin_walk(net, v, slot, length[side] + 1, &back);
      if (w < 0 || w == v) break;
      way[side][length[side]++] = w;
      if (!is_regular(net, w)) break;
    }
  }

  int behind = length[1] < LINE / 2 ? length[1] : LINE / 2;
  if (length[0] < LINE - 1 - behind) behind = LINE - 1 - length[0];
  if (behind > length[1]) behind = length[1];
  int ahead = length[0] < LINE - 1 - behind ? length[0] : LINE - 1 - behind;

  for (int k = 0; k < behind; k++) line[k] = way[1][behind - 1 - k];
  line[behind] = v;
  for (int k = 0; k < ahead; k++) line[behind + 1 + k] = way[0][k];
  *at = behind;
  return behind + 1 + ahead;
}

/* Weights of the derivative at number `at` of the polynomial through count numbers at 0, 1, 2
 * ...: with L_i(t) = prod (t - j) / (i - j),
 *   L_i' = sum over k != i of 1 / (i - k) prod over j != i, k of (t - j) / (i - j). */
static void derivative_weights(int count, int at, double weights[LINE]) {
  for (int i = 0; i < count; i++) {
    weights[i] = 0;
    for (int k = 0; k < count; k++) {
      if (k == i) continue;
      double product = 1.0 / (i - k);
      for (int j = 0; j < count; j++)
        if (j != i && j != k) product *= (double)(at - j) / (i - j);
      weights[i] += product;
    }
  }
}

/* The derivatives of a vector along both lines through a vertex, per edge of the net. Irregular
 * vertices at the ends of a line are left out: their values fit no line. */
static void differentiate(const lam_net *net, int v, const lam_vec3 *values, lam_vec3 out[2]) {
  for (int d = 0; d < 2; d++) {
    int line[LINE], at, count = line_through(net, v, d, line, &at);
    double first[LINE];
    while (count > 1 && !is_regular(net, line[count - 1])) count--;
    int skip = count > 1 && !is_regular(net, line[0]);

    derivative_weights(count - skip, at - skip, first);
    out[d] = lam_v3(0, 0, 0);
    for (int k = skip; k < count; k++)
      out[d] = lam_along(out[d], first[k - skip], lam_sub(values[line[k]], values[v]));
  }
}

/* The discrete Lelieuvre normals: parallel to the normals n of the vertex stars, with |nu_i x
 * nu_j| = |p_j - p_i| for all edges as well as possible. With l the logarithms of their lengths,
 * l_i + l_j = log(|p_j - p_i| / |n_i x n_j|): relaxed by a few sweeps from 0. These sums say
 * nothing about alternating parts of l, which do not arise then. One vector per vertex, owned by
 * arena. */
static lam_vec3 *make_conormals(lam_arena *arena, const lam_net *net) {
  enum { SWEEPS = 20 };
  int n = net->mesh.vertex_count, *count = LAM_NEW(arena, int, n);
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, n);
  double *size = LAM_NEW(arena, double, n), *wanted = LAM_NEW(arena, double, net->edge_count);
  double *change = LAM_NEW(arena, double, n);

  lam_net_normals(net, x, normals);
  /* Edges at irregular vertices, and those along which the normal does not turn, say nothing
   * (NaN). */
  for (int e = 0; e < net->edge_count; e++) {
    int a = net->edges[e].vertex[0], b = net->edges[e].vertex[1];
    double turn = lam_length(lam_cross(normals[a], normals[b]));
    wanted[e] = is_regular(net, a) && is_regular(net, b) && turn > 1e-9
                    ? log(lam_distance(x[a], x[b]) / turn)
                    : NAN;
    for (int k = 0; k < 2 && !isnan(wanted[e]); k++) count[net->edges[e].vertex[k]]++;
  }

  for (int sweep = 0; sweep < SWEEPS; sweep++) {
    for (int v = 0; v < n; v++) change[v] = 0;
    for (int e = 0; e < net->edge_count; e++) {
      int a = net->edges[e].vertex[0], b = net->edges[e].vertex[1];
      if (isnan(wanted[e])) continue;
      change[a] += (wanted[e] - size[a] - size[b]) / 2 / count[a];
      change[b] += (wanted[e] - size[a] - size[b]) / 2 / count[b];
    }
    for (int v = 0; v < n; v++) size[v] += change[v];
  }

  for (int v = 0; v < n; v++) normals[v] = lam_scale(normals[v], exp(size[v]));
  return normals;
}

/* Points, conormals and their slopes per side of a cell, that is per `every` edges. */
static lam_conormal_vertex *make_vertices(lam_arena *arena, const lam_net *net, int every) {
  int n = net->mesh.vertex_count;
  lam_conormal_vertex *vertices = LAM_NEW(arena, lam_conormal_vertex, n);
  const lam_vec3 *conormals = make_conormals(arena, net);

  for (int v = 0; v < n; v++) {
    vertices[v].point = net->mesh.vertices[v];
    if (!is_regular(net, v)) continue;
    vertices[v].conormal = conormals[v];
    differentiate(net, v, conormals, vertices[v].slope);
    for (int d = 0; d < 2; d++) vertices[v].slope[d] = lam_scale(vertices[v].slope[d], every);
  }
  return vertices;
}

/* ---- cells ---- */

/* The search for cells over the faces of the net. */
typedef struct search {
  const lam_net *net;
  int every, *face; /* per entry of net->ring: the face to its left, or -1 */
  bool *taken;      /* per face */
  lam_skin_net *out;
} search;

/* The face to the left of every way out of a vertex. */
static void find_faces(lam_arena *arena, search *s) {
  const lam_net *net = s->net;
  int entries = net->ring_start[net->mesh.vertex_count];
  s->face = LAM_NEW(arena, int, entries);
  for (int i = 0; i < entries; i++) s->face[i] = -1;
  for (int f = 0; f < net->mesh.face_count; f++)
    for (int k = 0; k < 4; k++) {
      int v = net->mesh.faces[f][k];
      s->face[net->ring_start[v] + slot_of(net, v, net->mesh.faces[f][(k + 1) % 4])] = f;
    }
}

/* The face left of the way out of v by slot, or -1. */
static int face_at(const search *s, int v, int slot) {
  return slot < 0 ? -1 : s->face[s->net->ring_start[v] + slot];
}

/* The faces of the cell at v between slot and the next entry, in rows; false when some are
 * missing or taken. Inside the cell all vertices must be regular. faces has room for every x
 * every. */
static bool cell_faces(const search *s, int v, int slot, int *faces) {
  int row = v, out = slot, up, back, every = s->every;
  for (int i = 0; i < every; i++) {
    up = turn(s->net, row, out, 1); /* from `row` to the left */

    int at = row, ahead = out;
    /* Along a row, with the faces on the left of `ahead`. */
    for (int j = 0; j < every; j++) {
      int f = face_at(s, at, ahead);
      if (f < 0 || s->taken[f]) return false;
      faces[i * every + j] = f;
      if (j + 1 == every) break;
      if (up < 0 || (j && !is_regular(s->net, at))) return false;
      at = lam_skin_walk(s->net, at, up, 1, &back);
      if (!is_regular(s->net, at)) return false;
      up = turn(s->net, at, back, 2);
      ahead = turn(s->net, at, back, 1);
    }

    /* To the beginning of the next row. */
    if (i + 1 == every) break;
    row = lam_skin_walk(s->net, row, out, 1, &back);
    if (!is_regular(s->net, row)) return false;
    out = turn(s->net, row, back, 2);
    if (out < 0) return false;
  }
  return true;
}

/* Looks for the cell with the corner v between slot and the next entry; takes its faces and
 * returns true when there is one. corner receives its corners. A cell with an irregular corner is
 * taken and counted, but not kept. */
static bool try_cell(search *s, int v, int slot, int *faces, int corner[4]) {
  const lam_net *net = s->net;
  int next = turn(net, v, slot, 1), back_a, back_b, back_c, back_d, every = s->every;
  if (next < 0 || !cell_faces(s, v, slot, faces)) return false;

  /* Both ways around, from v over a and from v over b, must come to the same opposite corner. */
  int a = lam_skin_walk(net, v, slot, every, &back_a),
      b = lam_skin_walk(net, v, next, every, &back_b);
  if (a < 0 || b < 0) return false;
  int left = turn(net, a, back_a, -1), right = turn(net, b, back_b, 1);
  int c = left < 0 ? -1 : lam_skin_walk(net, a, left, every, &back_c);
  int d = right < 0 ? -1 : lam_skin_walk(net, b, right, every, &back_d);
  if (c < 0 || c != d) return false;

  const int corners[4] = {v, a, c, b};
  memcpy(corner, corners, sizeof corners);
  for (int k = 0; k < every * every; k++) s->taken[faces[k]] = true;

  for (int k = 0; k < 4; k++)
    if (!is_regular(net, corner[k])) {
      s->out->irregular++;
      return true;
    }

  lam_skin_cell *cell = &s->out->cells[s->out->cell_count];
  const int turns[4] = {slot, back_a + 2, back_c + 1, back_b + 1};
  const int sides[4][2] = {{v, slot}, {v, next}, {b, right}, {a, left}};
  for (int k = 0; k < 4; k++) {
    cell->vertex[k] = corner[k];
    cell->turn[k] = turns[k] & 3;
  }
  memcpy(s->out->sides[s->out->cell_count++], sides, sizeof sides);
  return true;
}

/* All cells that are reached from a vertex, corner by corner. seen, queue: per vertex. */
static void spread(search *s, int start, bool *seen, int *queue, int *faces) {
  int head = 0, tail = 0;
  queue[tail++] = start;
  seen[start] = true;

  while (head < tail) {
    int v = queue[head++], corner[4];
    for (int j = 0; j < valence(s->net, v); j++) {
      if (!try_cell(s, v, j, faces, corner)) continue;
      for (int k = 0; k < 4; k++) {
        if (seen[corner[k]]) continue;
        seen[corner[k]] = true;
        queue[tail++] = corner[k];
      }
    }
  }
}

/* Closes the part of the net that hangs together with a vertex: cells from two starts would not
 * fit each other. closed, queue: per vertex. */
static void close_component(const lam_net *net, int start, bool *closed, int *queue) {
  int head = 0, tail = 0;
  queue[tail++] = start;
  closed[start] = true;

  while (head < tail) {
    int v = queue[head++];
    for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
      if (closed[net->ring[i]]) continue;
      closed[net->ring[i]] = true;
      queue[tail++] = net->ring[i];
    }
  }
}

/* The order in which vertices are tried, 0 first. Cells start where lines end for certain: at
 * corners of the boundary, then at its reentrant corners and at irregular vertices; other inner
 * and boundary vertices come last. */
static int rank(const lam_net *net, int v) {
  if (net->boundary[v]) return valence(net, v) == 2 ? 0 : valence(net, v) == 3 ? 3 : 1;
  return valence(net, v) == 4 ? 4 : 2;
}

/* One start per piece of the net: the first vertex, in the order of ranks, at which there is a
 * cell. */
lam_skin_net lam_skin_net_make(lam_arena *arena, const lam_net *net, int every) {
  int n = net->mesh.vertex_count, count = net->mesh.face_count;
  lam_skin_net out = {.every = every, .uncovered = 0, .vertices = make_vertices(arena, net, every)};
  out.cells = LAM_NEW(arena, lam_skin_cell, count);
  out.sides = lam_arena_alloc(arena, (size_t)count, sizeof *out.sides);

  search s = {.net = net, .every = every, .taken = LAM_NEW(arena, bool, count), .out = &out};
  find_faces(arena, &s);
  bool *seen = LAM_NEW(arena, bool, n), *closed = LAM_NEW(arena, bool, n);
  int *queue = LAM_NEW(arena, int, n), *faces = LAM_NEW(arena, int, every *every);

  for (int order = 0; order < 5; order++)
    for (int v = 0; v < n; v++) {
      if (rank(net, v) != order || closed[v]) continue;
      int before = out.cell_count + out.irregular;
      memset(seen, 0, (size_t)n * sizeof *seen);
      spread(&s, v, seen, queue, faces);
      if (out.cell_count + out.irregular > before) close_component(net, v, closed, queue);
    }

  for (int f = 0; f < count; f++) out.uncovered += !s.taken[f];
  return out;
}
