/* Lines, stars and boundary loops of a net whose edges and rings are known: the last steps of
 * lam_net_build (net.c). */
#include "mesh/net_lines.h"
#include "mesh/edge_table.h"

#include <stdlib.h>
#include <string.h>

/* ---- polylines ---- */

/* The line that is being traced: buffer[low .. high]. */
typedef struct tracer {
  lam_net *net;
  lam_edge_table edges;
  bool *done;  /* per edge: it lies on a line already */
  int *buffer; /* room for all edges on both sides of its middle */
  int low, high;
} tracer;

/* line_continues at a vertex of the boundary: along a straight border (three edges), or through a
 * reentrant corner with its three faces (four edges). Neighbors two apart continue each other. */
static int line_continues_on_boundary(const lam_net *net, int from, int at) {
  const int *ring = net->ring + net->ring_start[at];
  int valence = lam_net_valence(net, at);
  if (valence != 3 && valence != 4) return -1;

  for (int k = 0; k + 2 < valence; k++) {
    if (ring[k] == from) return ring[k + 2];
    if (ring[k + 2] == from) return ring[k];
  }
  return -1;
}

/* The neighbor of vertex `at` to which the line that comes from the neighbor `from` goes on; -1: it
 * ends here. */
static int line_continues(const lam_net *net, int from, int at) {
  if (net->boundary[at]) return line_continues_on_boundary(net, from, at);
  if (lam_net_valence(net, at) != 4) return -1;

  const int *ring = net->ring + net->ring_start[at];
  for (int k = 0; k < 4; k++)
    if (ring[k] == from) return ring[(k + 2) & 3];
  return -1;
}

/* Prolongs the line that began with edge `first` at its end, or at its beginning, until it ends or
 * meets an edge that is done. True: that edge is `first`, so the line is closed. */
static bool prolong(tracer *t, int first, bool backwards) {
  for (;;) {
    int at = backwards ? t->buffer[t->low] : t->buffer[t->high];
    int from = backwards ? t->buffer[t->low + 1] : t->buffer[t->high - 1];
    int to = line_continues(t->net, from, at);
    if (to < 0) return false;

    int step = lam_edge_table_find(&t->edges, at, to);
    if (t->done[step]) return step == first;
    t->done[step] = true;
    if (backwards)
      t->buffer[--t->low] = to;
    else
      t->buffer[++t->high] = to;
  }
}

/* Turns v[0 .. n - 1] around. */
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

  /* three reversals rotate the array to the left by low */
  reverse(v, low);
  reverse(v + low, n - low);
  reverse(v, n);
  if (v[1] > v[n - 1]) reverse(v + 1, n - 1);
}

/* The whole line of edge e, which is not done yet. Its vertices are owned by arena. */
static lam_polyline trace_line(tracer *t, lam_arena *arena, int e) {
  const lam_edge *edge = &t->net->edges[e];
  t->done[e] = true;
  t->low = t->net->edge_count + 1;
  t->high = t->low + 1;
  t->buffer[t->low] = edge->vertex[0];
  t->buffer[t->high] = edge->vertex[1];
  bool closed = prolong(t, e, false) || prolong(t, e, true);
  if (closed) t->high--; /* the first vertex came a second time */

  int count = t->high - t->low + 1;
  lam_polyline line = {edge->family, closed, count, LAM_NEW(arena, int, count)};
  memcpy(line.vertices, t->buffer + t->low, sizeof(int) * (size_t)count);
  orient_line(&line);
  return line;
}

/* The order of lines (for qsort): by family, then by the first two vertices. */
static int compare_lines(const void *a, const void *b) {
  const lam_polyline *p = a, *q = b;
  if (p->family != q->family) return p->family - q->family;
  return p->vertices[0] != q->vertices[0] ? p->vertices[0] - q->vertices[0]
                                          : p->vertices[1] - q->vertices[1];
}

/* The order of the lines does not depend on the order of the edges. */
void lam_net_trace_lines(lam_arena *arena, lam_net *net) {
  tracer t = {.net = net, .edges = lam_edge_table_new(arena, net)};
  t.done = LAM_NEW(arena, bool, net->edge_count);
  t.buffer = LAM_NEW(arena, int, 2 * net->edge_count + 4);
  net->polylines = LAM_NEW(arena, lam_polyline, net->edge_count);
  for (int e = 0; e < net->edge_count; e++)
    if (!t.done[e]) net->polylines[net->polyline_count++] = trace_line(&t, arena, e);
  qsort(net->polylines, (size_t)net->polyline_count, sizeof *net->polylines, compare_lines);
}

/* ---- stars ---- */

/* Per vertex: the next one on its line of family 0; -1: there is none. */
static int *next_along_u(lam_arena *arena, const lam_net *net) {
  int n = net->mesh.vertex_count, *ahead = LAM_NEW(arena, int, n);
  memset(ahead, -1, sizeof(int) * (size_t)n);
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->family != 0) continue;
    for (int i = 0; i + 1 < line->count; i++) ahead[line->vertices[i]] = line->vertices[i + 1];
    if (line->closed) ahead[line->vertices[line->count - 1]] = line->vertices[0];
  }
  return ahead;
}

/* A star is the ring of a regular inner vertex, turned so that +u comes first. */
void lam_net_list_stars(lam_arena *arena, lam_net *net) {
  int n = net->mesh.vertex_count;
  net->stars = LAM_NEW(arena, lam_star, n);
  net->star_of_vertex = LAM_NEW(arena, int, n);
  const int *ahead = next_along_u(arena, net);
  for (int v = 0; v < n; v++) {
    const int *ring = net->ring + net->ring_start[v];
    net->star_of_vertex[v] = -1;
    if (net->boundary[v] || lam_net_valence(net, v) != 4) continue;

    int k = 0;
    while (k < 3 && ring[k] != ahead[v]) k++;
    if (ring[k] != ahead[v]) k = 0; /* only where families conflict */
    net->star_of_vertex[v] = net->star_count;
    net->stars[net->star_count++] =
        (lam_star){v, {ring[k], ring[(k + 1) & 3], ring[(k + 2) & 3], ring[(k + 3) & 3]}};
  }
}

/* ---- boundary loops ---- */

/* Follows the boundary from vertex v until it comes back; marks its vertices as done. Writes into
 * vertices, which has room for the rest of the boundary. */
static lam_polyline trace_loop(const int *ahead, int v, bool *done, int *vertices) {
  lam_polyline loop = {-1, true, 0, vertices};
  for (int at = v; !done[at]; at = ahead[at]) {
    done[at] = true;
    loop.vertices[loop.count++] = at;
  }
  return loop;
}

/* Every boundary vertex has one boundary edge that leaves it with the surface on its left. */
void lam_net_trace_loops(lam_arena *arena, lam_net *net) {
  int n = net->mesh.vertex_count, boundary_edges = 0, *ahead = LAM_NEW(arena, int, n);
  for (int e = 0; e < net->edge_count; e++) {
    const lam_edge *edge = &net->edges[e];
    if (edge->face[1] >= 0) continue;
    ahead[edge->vertex[0]] = edge->vertex[1]; /* the face on its left */
    boundary_edges++;
  }

  bool *done = LAM_NEW(arena, bool, n);
  int *pool = LAM_NEW(arena, int, boundary_edges);
  net->loops = LAM_NEW(arena, lam_polyline, boundary_edges);
  for (int v = 0; v < n; v++) {
    if (!net->boundary[v] || done[v]) continue;
    lam_polyline loop = trace_loop(ahead, v, done, pool);
    pool += loop.count;
    net->loops[net->loop_count++] = loop;
  }
}
