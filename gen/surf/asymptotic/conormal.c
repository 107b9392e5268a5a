/* An asymptotic curve from conormals, and the signs of torsion along a net. Called by
 * skin_patches.c.
 *
 * Along an asymptotic curve of torsion tau the vector nu = N / sqrt|tau| satisfies r' = s nu x
 * nu', s = sign(tau) (Lelieuvre's formula for one curve; N the normal of the surface). The other
 * way round, every nu(t) gives a curve with r'.nu = r''.nu = 0: its osculating planes are
 * perpendicular to nu, and they stay so where the curve is straight or bends the other way,
 * where r' x r'' says nothing. With nu of degree n, the curve has degree 2n - 1:
 *
 *   r' = s sum_(i<j) C(n,i) C(n,j) (j-i) / C(2n-2,i+j-1)  c_i x c_j  B_(i+j-1) */
#include "surf/asymptotic/conormal.h"

enum { LAST = LAM_CONORMAL_POINTS - 1, CURVE = LAM_CONORMAL_CURVE };

/* The binomial coefficients of 4 and of 6 = 2 * 4 - 2. */
static const double choose4[] = {1, 4, 6, 4, 1}, choose6[] = {1, 6, 15, 20, 15, 6, 1};

/* The points follow from r' by sums, from both ends to the middle, so that both ends are exact. */
lam_conormal_edge lam_conormal_edge_make(const lam_conormal_vertex *vertices,
                                         const lam_conormal_arc *edge) {
  const lam_conormal_vertex *from = &vertices[edge->vertex[0]], *to = &vertices[edge->vertex[1]];
  lam_conormal_edge out = {.points = {from->point}};
  lam_vec3 *c = out.conormals, *p = out.points, q[CURVE] = {{0, 0, 0}};

  /* The control points of the conormals: those of the vertices, with their slopes, and the
   * edge's own. */
  c[0] = from->conormal;
  c[1] = lam_along(from->conormal, 0.25, lam_conormal_slope(from, edge->turn[0]));
  c[2] = edge->middle;
  c[3] = lam_along(to->conormal, -0.25, lam_conormal_slope(to, edge->turn[1]));
  c[4] = to->conormal;

  /* Those of r', of degree 6. */
  for (int i = 0; i < LAST; i++)
    for (int j = i + 1; j <= LAST; j++) {
      int k = i + j - 1;
      q[k] = lam_along(q[k], edge->sign * choose4[i] * choose4[j] * (j - i) / choose6[k],
                       lam_cross(c[i], c[j]));
    }

  p[CURVE] = to->point;
  for (int k = 0; k < CURVE / 2; k++) {
    p[k + 1] = lam_along(p[k], 1.0 / CURVE, q[k]);
    p[CURVE - 1 - k] = lam_along(p[CURVE - k], -1.0 / CURVE, q[CURVE - 1 - k]);
  }
  return out;
}

/* ---- signs ---- */

/* The end of an edge at a vertex. */
typedef struct link {
  int edge, next; /* next link of the same vertex, or -1 */
} link;

/* The edges as a graph, and the signs of its vertices: of the torsion of the curve along the first
 * direction of a vertex, 0 where it is not known yet. */
typedef struct graph {
  const lam_conormal_vertex *vertices;
  lam_conormal_arc *edges;
  int *first; /* first link of a vertex, or -1; link 2 e + i is end i of edge e */
  link *links;
  int *sign;
} graph;

/* Links the ends of all edges to their vertices. */
static graph make_graph(lam_arena *arena, int vertex_count, const lam_conormal_vertex *vertices,
                        int edge_count, lam_conormal_arc *edges) {
  graph g = {vertices, edges, LAM_NEW(arena, int, vertex_count),
             LAM_NEW(arena, link, 2 * edge_count), LAM_NEW(arena, int, vertex_count)};
  for (int v = 0; v < vertex_count; v++) g.first[v] = -1;
  for (int k = 0; k < 2 * edge_count; k++) {
    int v = edges[k / 2].vertex[k % 2];
    g.links[k] = (link){k / 2, g.first[v]};
    g.first[v] = k;
  }
  return g;
}

/* The sign of the torsion of an edge from that of the vertex at its end i: an odd number of quarter
 * turns leads to the other curve, which has the opposite torsion. */
static int edge_sign(const lam_conormal_arc *e, int i, int vertex_sign) {
  return e->turn[i] & 1 ? -vertex_sign : vertex_sign;
}

/* (nu0 x nu1).chord of an edge: positive where its torsion is positive, by Lelieuvre's formula. */
static double edge_turn(const graph *g, const lam_conormal_arc *e, lam_vec3 *chord) {
  const lam_conormal_vertex *from = &g->vertices[e->vertex[0]], *to = &g->vertices[e->vertex[1]];
  *chord = lam_sub(to->point, from->point);
  return lam_dot(lam_cross(from->conormal, to->conormal), *chord);
}

/* Gives signs to the part of the graph that is connected with `start`, so that its edges agree with
 * their conormals on the whole. queue: room for all vertices. */
static void spread_signs(const graph *g, int start, int *queue) {
  int head = 0, tail = 0;
  double votes = 0;
  queue[tail++] = start;
  g->sign[start] = 1;
  while (head < tail) {
    int v = queue[head++];
    for (int k = g->first[v]; k >= 0; k = g->links[k].next) {
      lam_conormal_arc *e = &g->edges[g->links[k].edge];
      int w = e->vertex[1 - k % 2];
      lam_vec3 chord;
      e->sign = edge_sign(e, k % 2, g->sign[v]);
      double turn = edge_turn(g, e, &chord);
      votes += e->sign * turn / lam_dot(chord, chord);
      if (g->sign[w]) continue;

      g->sign[w] = edge_sign(e, 1 - k % 2, e->sign);
      queue[tail++] = w;
    }
  }

  for (int i = 0; votes < 0 && i < tail; i++) g->sign[queue[i]] *= -1;
}

/* Signs spread from a vertex along all edges; a vote of the edges decides between the two choices
 * of every connected part. */
int lam_conormal_signs(lam_arena *arena, int vertex_count, const lam_conormal_vertex *vertices,
                       int edge_count, lam_conormal_arc *edges) {
  graph g = make_graph(arena, vertex_count, vertices, edge_count, edges);
  int *queue = LAM_NEW(arena, int, vertex_count), contradictions = 0;
  for (int start = 0; start < vertex_count; start++)
    if (!g.sign[start] && g.first[start] >= 0) spread_signs(&g, start, queue);

  for (int k = 0; k < edge_count; k++) {
    lam_conormal_arc *e = &edges[k];
    int at[2];
    lam_vec3 chord;
    for (int i = 0; i < 2; i++) at[i] = edge_sign(e, i, g.sign[e->vertex[i]]);
    e->sign = at[0];
    contradictions += at[0] != at[1] || e->sign * edge_turn(&g, e, &chord) < 0;
  }
  return contradictions;
}
