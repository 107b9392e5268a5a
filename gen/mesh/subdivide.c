#include "mesh/net.h"

/* New vertices: old ones, then one per edge, then one per face. Face f with corners a b c d and
 * edge points becomes four. */
static lam_mesh refine(lam_arena *arena, const lam_net *net, int *edge_of) {
  const lam_mesh *old = &net->mesh;
  int nv = old->vertex_count, ne = net->edge_count, nf = old->face_count;
  /* edges around each vertex, to find the edge of a face's side */
  int *first = LAM_NEW(arena, int, nv + 1), *list = LAM_NEW(arena, int, ne),
      *fill = LAM_NEW(arena, int, nv);
  for (int e = 0; e < ne; e++) {
    int low = net->edges[e].vertex[0] < net->edges[e].vertex[1] ? net->edges[e].vertex[0]
                                                                : net->edges[e].vertex[1];
    first[low + 1]++;
  }
  for (int v = 0; v < nv; v++) first[v + 1] += first[v];
  for (int e = 0; e < ne; e++) {
    int low = net->edges[e].vertex[0] < net->edges[e].vertex[1] ? net->edges[e].vertex[0]
                                                                : net->edges[e].vertex[1];
    list[first[low] + fill[low]++] = e;
  }
  lam_mesh mesh = {nv + ne + nf, LAM_NEW(arena, lam_vec3, nv + ne + nf), 4 * nf, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)mesh.face_count, sizeof *mesh.faces);
  for (int f = 0; f < nf; f++)
    for (int k = 0; k < 4; k++) {
      int a = old->faces[f][k], b = old->faces[f][(k + 1) & 3], low = a < b ? a : b;
      for (int i = first[low]; i < first[low + 1]; i++) {
        const int *v = net->edges[list[i]].vertex;
        if ((v[0] == a && v[1] == b) || (v[0] == b && v[1] == a)) edge_of[4 * f + k] = list[i];
      }
    }
  /* the first new edge of a face stays in the family of its first old edge */
  for (int f = 0; f < nf; f++) {
    int c = nv + ne + f;
    for (int k = 0; k < 4; k++) {
      int corner = old->faces[f][k], next = nv + edge_of[4 * f + k],
          before = nv + edge_of[4 * f + ((k + 3) & 3)];
      int corners[4][4] = {{corner, next, c, before},
                           {before, corner, next, c},
                           {c, before, corner, next},
                           {next, c, before, corner}};
      for (int i = 0; i < 4; i++) mesh.faces[4 * f + k][i] = corners[k][i];
    }
  }
  return mesh;
}

static lam_vec3 middle(lam_vec3 a, lam_vec3 b) { return lam_scale(lam_add(a, b), .5); }

lam_mesh lam_net_catmull_clark(lam_arena *arena, const lam_net *net) {
  int nv = net->mesh.vertex_count, ne = net->edge_count, nf = net->mesh.face_count;
  const lam_vec3 *x = net->mesh.vertices;
  int *edge_of = LAM_NEW(arena, int, 4 * nf);
  lam_mesh mesh = refine(arena, net, edge_of);
  lam_vec3 *vertex = mesh.vertices, *edge = vertex + nv, *face = edge + ne;
  for (int f = 0; f < nf; f++) {
    const int *c = net->mesh.faces[f];
    face[f] = middle(middle(x[c[0]], x[c[2]]), middle(x[c[1]], x[c[3]]));
  }
  lam_vec3 *faces = LAM_NEW(arena, lam_vec3, nv), *edges = LAM_NEW(arena, lam_vec3, nv);
  for (int e = 0; e < ne; e++) {
    const lam_edge *old = &net->edges[e];
    lam_vec3 half = middle(x[old->vertex[0]], x[old->vertex[1]]);
    bool border = old->face[1] < 0;
    edge[e] = border ? half : middle(half, middle(face[old->face[0]], face[old->face[1]]));
    for (int k = 0; k < 2; k++) {
      int v = old->vertex[k];
      if (border || !net->boundary[v]) edges[v] = lam_add(edges[v], half);
    }
  }
  for (int f = 0; f < nf; f++)
    for (int k = 0; k < 4; k++)
      faces[net->mesh.faces[f][k]] = lam_add(faces[net->mesh.faces[f][k]], face[f]);
  for (int v = 0; v < nv; v++) {
    int n = net->ring_start[v + 1] - net->ring_start[v];
    if (net->boundary[v]) /* the two border edges' middles, and the vertex; corners stay */
      vertex[v] = n == 2 ? x[v] : lam_add(lam_scale(x[v], .5), lam_scale(edges[v], .25));
    else /* (F + 2 E + (n - 3) V) / n with means F of faces and E of edge middles */
      vertex[v] =
          lam_scale(lam_add(lam_add(lam_scale(faces[v], 1.0 / n), lam_scale(edges[v], 2.0 / n)),
                            lam_scale(x[v], n - 3)),
                    1.0 / n);
  }
  return mesh;
}

/* (-a + 9 b + 9 c - d) / 16 between b and c; at an end the missing point is continued
 * quadratically, which gives (3 b + 6 c - d) / 8 or its mirror image. */
static lam_vec3 between(const lam_vec3 *a, lam_vec3 b, lam_vec3 c, const lam_vec3 *d) {
  if (a && d) return lam_scale(lam_sub(lam_scale(lam_add(b, c), 9), lam_add(*a, *d)), 1.0 / 16);
  if (d) return lam_scale(lam_sub(lam_add(lam_scale(b, 3), lam_scale(c, 6)), *d), 1.0 / 8);
  if (a) return lam_scale(lam_sub(lam_add(lam_scale(c, 3), lam_scale(b, 6)), *a), 1.0 / 8);
  return middle(b, c);
}

lam_mesh lam_net_four_point(lam_arena *arena, const lam_net *net) {
  int nv = net->mesh.vertex_count, ne = net->edge_count, nf = net->mesh.face_count;
  const lam_vec3 *x = net->mesh.vertices;
  int *edge_of = LAM_NEW(arena, int, 4 * nf);
  lam_mesh mesh = refine(arena, net, edge_of);
  lam_vec3 *vertex = mesh.vertices, *edge = vertex + nv, *face = edge + ne;
  for (int v = 0; v < nv; v++) vertex[v] = x[v];
  /* an edge lies on exactly one polyline */
  int *line_edge = LAM_NEW(arena, int, nv + 1), *at = LAM_NEW(arena, int, 2 * ne + 1);
  for (int e = 0; e < ne; e++) line_edge[net->edges[e].vertex[0]]++;
  for (int v = 0, sum = 0; v <= nv; v++) {
    int count = line_edge[v];
    line_edge[v] = sum;
    sum += count;
  }
  int *fill = LAM_NEW(arena, int, nv);
  for (int e = 0; e < ne; e++)
    at[line_edge[net->edges[e].vertex[0]] + fill[net->edges[e].vertex[0]]++] = e;
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    int n = line->count, segments = line->closed ? n : n - 1;
    for (int s = 0; s < segments; s++) {
      int b = line->vertices[s], c = line->vertices[(s + 1) % n];
      bool has_a = line->closed || s > 0, has_d = line->closed || s + 2 < n;
      lam_vec3 a = has_a ? x[line->vertices[(s + n - 1) % n]] : x[b],
               d = has_d ? x[line->vertices[(s + 2) % n]] : x[c];
      lam_vec3 point = between(has_a ? &a : NULL, x[b], x[c], has_d ? &d : NULL);
      for (int side = 0; side < 2; side++) {
        int from = side ? c : b, to = side ? b : c;
        for (int i = line_edge[from]; i < line_edge[from + 1]; i++)
          if (net->edges[at[i]].vertex[1] == to) edge[at[i]] = point;
      }
    }
  }
  /* the point of a face: across it from edge to opposite edge, continued into the neighboring
   * faces, for both families
   */
  for (int f = 0; f < nf; f++) {
    lam_vec3 sum = {0, 0, 0};
    for (int k = 0; k < 2; k++) {
      lam_vec3 outer[2];
      bool has[2] = {false, false};
      for (int side = 0; side < 2; side++) {
        int e = edge_of[4 * f + k + 2 * side];
        int g = net->edges[e].face[0] == f ? net->edges[e].face[1] : net->edges[e].face[0];
        for (int l = 0; g >= 0 && l < 4; l++)
          if (edge_of[4 * g + l] == e) {
            outer[side] = edge[edge_of[4 * g + ((l + 2) & 3)]];
            has[side] = true;
          }
      }
      sum = lam_add(sum, between(has[0] ? &outer[0] : NULL, edge[edge_of[4 * f + k]],
                                 edge[edge_of[4 * f + k + 2]], has[1] ? &outer[1] : NULL));
    }
    face[f] = lam_scale(sum, .5);
  }
  return mesh;
}
