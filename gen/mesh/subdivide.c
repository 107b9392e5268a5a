/* Subdivision of nets: Catmull-Clark, and the interpolating 4-point rule, which net/multilevel.c
 * and design/net_stage.c refine nets with. Both share the connectivity of the finer mesh. */
#include "mesh/edge_table.h"
#include "mesh/net.h"

/* A finer mesh in the making. Its new vertices stand in the order old vertices, edges, faces. */
typedef struct refinement {
  const lam_net *net;
  lam_mesh mesh;
  lam_vec3 *vertex, *edge, *face; /* new positions, parts of mesh.vertices */
  int *edge_of;                   /* of face f from corner k to corner k + 1: edge_of[4 * f + k] */
} refinement;

/* ---- connectivity ---- */

/* Fills edge_of. */
static void find_sides(refinement *r, const lam_edge_table *edges) {
  for (int f = 0; f < r->net->mesh.face_count; f++) {
    const int *c = r->net->mesh.faces[f];
    for (int k = 0; k < 4; k++)
      r->edge_of[4 * f + k] = lam_edge_table_find(edges, c[k], c[(k + 1) & 3]);
  }
}

/* The four new faces of face f, one per corner. Each begins at the corner that makes its first edge
 * one of the family of the old face's first edge. */
static void split_face(refinement *r, int f) {
  int nv = r->net->mesh.vertex_count, center = nv + r->net->edge_count + f;
  for (int k = 0; k < 4; k++) {
    int corner = r->net->mesh.faces[f][k];
    int next = nv + r->edge_of[4 * f + k], before = nv + r->edge_of[4 * f + ((k + 3) & 3)];
    int around[4] = {corner, next, center, before}; /* counterclockwise */
    for (int i = 0; i < 4; i++) r->mesh.faces[4 * f + k][i] = around[(i - k) & 3];
  }
}

/* Connectivity of the finer mesh; its positions are zero. */
static refinement refine(lam_arena *arena, const lam_net *net, const lam_edge_table *edges) {
  int nv = net->mesh.vertex_count, ne = net->edge_count, nf = net->mesh.face_count;
  refinement r = {.net = net, .edge_of = LAM_NEW(arena, int, 4 * nf)};
  r.mesh = (lam_mesh){nv + ne + nf, LAM_NEW(arena, lam_vec3, nv + ne + nf), 4 * nf, NULL};
  r.mesh.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)(4 * nf), sizeof *r.mesh.faces);
  r.vertex = r.mesh.vertices, r.edge = r.vertex + nv, r.face = r.edge + ne;
  find_sides(&r, edges);
  for (int f = 0; f < nf; f++) split_face(&r, f);
  return r;
}

static lam_vec3 middle(lam_vec3 a, lam_vec3 b) { return lam_scale(lam_add(a, b), .5); }

/* ---- Catmull-Clark ---- */

/* Edge points: the mean of the two ends and the two face points; on the border the middle. Sums up
 * per vertex the middles of its edges, on the border those of the two border edges alone. */
static void smooth_edges(refinement *r, lam_vec3 *middles) {
  const lam_vec3 *x = r->net->mesh.vertices;
  for (int e = 0; e < r->net->edge_count; e++) {
    const lam_edge *old = &r->net->edges[e];
    lam_vec3 half = middle(x[old->vertex[0]], x[old->vertex[1]]);
    bool border = old->face[1] < 0;
    r->edge[e] = border ? half : middle(half, middle(r->face[old->face[0]], r->face[old->face[1]]));

    for (int k = 0; k < 2; k++) {
      int v = old->vertex[k];
      if (border || !r->net->boundary[v]) middles[v] = lam_add(middles[v], half);
    }
  }
}

/* The new position of vertex v at x with n edges: (F + 2 E + (n - 3) x) / n with the means F of its
 * face points and E of its edges' middles, given as sums. On the border (E + x) / 2; corners
 * stay. */
static lam_vec3 smooth_vertex(lam_vec3 x, int n, bool border, lam_vec3 faces, lam_vec3 middles) {
  if (border) return n == 2 ? x : lam_add(lam_scale(x, .5), lam_scale(middles, .25));
  lam_vec3 means = lam_add(lam_scale(faces, 1.0 / n), lam_scale(middles, 2.0 / n));
  return lam_scale(lam_add(means, lam_scale(x, n - 3)), 1.0 / n);
}

/* Face points, edge points from these, vertices from both. */
lam_mesh lam_net_catmull_clark(lam_arena *arena, const lam_net *net) {
  const lam_mesh *old = &net->mesh;
  const lam_vec3 *x = old->vertices;
  lam_edge_table edges = lam_edge_table_new(arena, net);
  refinement r = refine(arena, net, &edges);
  for (int f = 0; f < old->face_count; f++) {
    const int *c = old->faces[f];
    r.face[f] = middle(middle(x[c[0]], x[c[2]]), middle(x[c[1]], x[c[3]]));
  }

  lam_vec3 *faces = LAM_NEW(arena, lam_vec3, old->vertex_count);
  lam_vec3 *middles = LAM_NEW(arena, lam_vec3, old->vertex_count);
  smooth_edges(&r, middles);
  for (int f = 0; f < old->face_count; f++)
    for (int k = 0; k < 4; k++) {
      lam_vec3 *sum = &faces[old->faces[f][k]];
      *sum = lam_add(*sum, r.face[f]);
    }

  for (int v = 0; v < old->vertex_count; v++)
    r.vertex[v] =
        smooth_vertex(x[v], lam_net_valence(net, v), net->boundary[v], faces[v], middles[v]);
  return r.mesh;
}

/* ---- 4-point rule ---- */

/* (-a + 9 b + 9 c - d) / 16 between b and c; at an end the missing point (NULL) is continued
 * quadratically, which gives (3 b + 6 c - d) / 8 or its mirror image. */
static lam_vec3 between(const lam_vec3 *a, lam_vec3 b, lam_vec3 c, const lam_vec3 *d) {
  if (a && d) return lam_scale(lam_sub(lam_scale(lam_add(b, c), 9), lam_add(*a, *d)), 1.0 / 16);
  if (d) return lam_scale(lam_sub(lam_add(lam_scale(b, 3), lam_scale(c, 6)), *d), 1.0 / 8);
  if (a) return lam_scale(lam_sub(lam_add(lam_scale(c, 3), lam_scale(b, 6)), *a), 1.0 / 8);
  return middle(b, c);
}

/* The point of the s-th edge of a line, from this edge and those before and after it. */
static lam_vec3 point_on_line(const lam_polyline *line, int s, const lam_vec3 *x) {
  int n = line->count;
  const lam_vec3 *before = &x[line->vertices[(s + n - 1) % n]];
  const lam_vec3 *after = &x[line->vertices[(s + 2) % n]];
  return between(line->closed || s > 0 ? before : NULL, x[line->vertices[s]],
                 x[line->vertices[(s + 1) % n]], line->closed || s + 2 < n ? after : NULL);
}

/* The points of all edges: every edge lies on exactly one line. */
static void interpolate_edges(refinement *r, const lam_edge_table *edges) {
  for (int l = 0; l < r->net->polyline_count; l++) {
    const lam_polyline *line = &r->net->polylines[l];
    int n = line->count, segments = line->closed ? n : n - 1;
    for (int s = 0; s < segments; s++) {
      int e = lam_edge_table_find(edges, line->vertices[s], line->vertices[(s + 1) % n]);
      r->edge[e] = point_on_line(line, s, r->net->mesh.vertices);
    }
  }
}

/* The point of the edge that lies opposite to edge e of face f in the face on its other side; NULL:
 * there is no such face. */
static const lam_vec3 *beyond(const refinement *r, int f, int e) {
  const lam_edge *edge = &r->net->edges[e];
  int g = edge->face[0] == f ? edge->face[1] : edge->face[0];
  for (int l = 0; g >= 0 && l < 4; l++)
    if (r->edge_of[4 * g + l] == e) return &r->edge[r->edge_of[4 * g + ((l + 2) & 3)]];
  return NULL;
}

/* The point in the middle of face f on the way across it from its edge k to its edge k + 2. */
static lam_vec3 point_across(const refinement *r, int f, int k) {
  int in = r->edge_of[4 * f + k], out = r->edge_of[4 * f + k + 2];
  return between(beyond(r, f, in), r->edge[in], r->edge[out], beyond(r, f, out));
}

/* Edges along the lines first; a face point is the mean of the two ways across the face. */
lam_mesh lam_net_four_point(lam_arena *arena, const lam_net *net) {
  lam_edge_table edges = lam_edge_table_new(arena, net);
  refinement r = refine(arena, net, &edges);
  for (int v = 0; v < net->mesh.vertex_count; v++) r.vertex[v] = net->mesh.vertices[v];
  interpolate_edges(&r, &edges);

  for (int f = 0; f < net->mesh.face_count; f++) {
    lam_vec3 sum = {0, 0, 0}; /* of both families */
    for (int k = 0; k < 2; k++) sum = lam_add(sum, point_across(&r, f, k));
    r.face[f] = lam_scale(sum, .5);
  }
  return r.mesh;
}
