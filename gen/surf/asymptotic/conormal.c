/* An asymptotic curve from conormals. Along an asymptotic curve of torsion tau the vector nu = N /
 * sqrt|tau| satisfies r' = s nu x nu',  s = sign(tau) (Lelieuvre's formula for one curve; N the
 * normal of the surface). The other way round, every nu(t) gives a curve with r'.nu = r''.nu = 0:
 * its osculating planes are perpendicular to nu, and they stay so where the curve is straight or
 * bends the other way, where r' x r'' says nothing. With nu of degree n, the curve has degree 2n -
 * 1: r' = s sum_(i<j) C(n,i) C(n,j) (j-i) / C(2n-2,i+j-1)  c_i x c_j  B_(i+j-1). */
#include "surf/asymptotic/conormal.h"

enum { LAST = LAM_CONORMAL_POINTS - 1, CURVE = LAM_CONORMAL_CURVE };

static const double choose4[] = {1, 4, 6, 4, 1}, choose6[] = {1, 6, 15, 20, 15, 6, 1};

lam_conormal_edge lam_conormal_edge_make(const lam_conormal_vertex *vertices,
                                         const lam_conormal_arc *edge) {
  const lam_conormal_vertex *from = &vertices[edge->vertex[0]], *to = &vertices[edge->vertex[1]];
  lam_conormal_edge out = {.points = {from->point}};
  lam_vec3 *c = out.conormals, *p = out.points, q[CURVE] = {{0, 0, 0}};
  c[0] = from->conormal;
  c[1] = lam_along(from->conormal, 0.25, lam_conormal_slope(from, edge->turn[0]));
  c[2] = edge->middle;
  c[3] = lam_along(to->conormal, -0.25, lam_conormal_slope(to, edge->turn[1]));
  c[4] = to->conormal;
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

typedef struct link {
  int edge, next; /* next link of the same vertex, or -1 */
} link;

int lam_conormal_signs(lam_arena *arena, int vertex_count, const lam_conormal_vertex *vertices,
                       int edge_count, lam_conormal_arc *edges) {
  int *first = LAM_NEW(arena, int, vertex_count), *sign = LAM_NEW(arena, int, vertex_count);
  int *queue = LAM_NEW(arena, int, vertex_count), contradictions = 0;
  link *links = LAM_NEW(arena, link, 2 * edge_count);
  for (int v = 0; v < vertex_count; v++) first[v] = -1;
  for (int k = 0; k < 2 * edge_count; k++) {
    int v = edges[k / 2].vertex[k % 2];
    links[k] = (link){k / 2, first[v]};
    first[v] = k;
  }
  for (int start = 0; start < vertex_count; start++) {
    if (sign[start] || first[start] < 0) continue;
    int head = 0, tail = 0;
    double votes = 0;
    queue[tail++] = start;
    sign[start] = 1; /* of the curve along the first direction of a vertex */
    while (head < tail) {
      int v = queue[head++];
      for (int k = first[v]; k >= 0; k = links[k].next) {
        lam_conormal_arc *e = &edges[links[k].edge];
        int w = e->vertex[1 - k % 2];
        e->sign = e->turn[k % 2] & 1 ? -sign[v] : sign[v];
        lam_vec3 chord = lam_sub(vertices[e->vertex[1]].point, vertices[e->vertex[0]].point);
        lam_vec3 turned =
            lam_cross(vertices[e->vertex[0]].conormal, vertices[e->vertex[1]].conormal);
        votes += e->sign * lam_dot(turned, chord) / lam_dot(chord, chord);
        if (sign[w]) continue;
        sign[w] = e->turn[1 - k % 2] & 1 ? -e->sign : e->sign;
        queue[tail++] = w;
      }
    }
    for (int i = 0; votes < 0 && i < tail; i++) sign[queue[i]] *= -1;
  }
  for (int k = 0; k < edge_count; k++) {
    lam_conormal_arc *e = &edges[k];
    int at[2];
    for (int i = 0; i < 2; i++) at[i] = e->turn[i] & 1 ? -sign[e->vertex[i]] : sign[e->vertex[i]];
    e->sign = at[0];
    lam_vec3 chord = lam_sub(vertices[e->vertex[1]].point, vertices[e->vertex[0]].point);
    lam_vec3 turned = lam_cross(vertices[e->vertex[0]].conormal, vertices[e->vertex[1]].conormal);
    contradictions += at[0] != at[1] || e->sign * lam_dot(turned, chord) < 0;
  }
  return contradictions;
}
