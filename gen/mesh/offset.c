/* Offsets and Gauss images of circular and conical nets: the plates of fab/parts/support.c stand on
 * the normals and axes, fab/parts/gauss_image.c shows the image. */
#include "mesh/offset.h"
#include "core/numeric/fit.h"

#include <math.h>
#include <string.h>

/* Where the entries of vertex v stand in the ring follows from the next corner of each face. */
int *lam_net_face_rings(lam_arena *arena, const lam_net *net) {
  const lam_mesh *mesh = &net->mesh;
  int length = net->ring_start[mesh->vertex_count], *ring = LAM_NEW(arena, int, length);
  for (int i = 0; i < length; i++) ring[i] = -1;

  /* a face lies to the left of its edge from a corner to the next one */
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 4; k++) {
      int v = mesh->faces[f][k], i = net->ring_start[v];
      while (net->ring[i] != mesh->faces[f][(k + 1) % 4]) i++;
      ring[i] = f;
    }
  return ring;
}

/* Along the product of the diagonals. */
void lam_net_face_normals(const lam_net *net, const lam_vec3 *x, lam_vec3 *normals) {
  for (int f = 0; f < net->mesh.face_count; f++) {
    const int *c = net->mesh.faces[f];
    normals[f] = lam_unit(lam_cross(lam_sub(x[c[2]], x[c[0]]), lam_sub(x[c[3]], x[c[1]])));
  }
}

/* ---- vertex offset ---- */

/* The vector n in the mirror that bisects the edge from vertex a to vertex b. */
static lam_vec3 mirrored(const lam_vec3 *x, int a, int b, lam_vec3 n) {
  lam_vec3 e = lam_unit(lam_sub(x[b], x[a]));
  return lam_along(n, -2 * lam_dot(n, e), e);
}

/* Spanning trees of the connected pieces: the parent of every vertex, of a root itself, and the
 * vertices in an order in which parents come first. */
static void span(lam_arena *arena, const lam_net *net, int **parents, int **vertices) {
  int n = net->mesh.vertex_count, reached = 0;
  int *order = LAM_NEW(arena, int, n), *parent = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++) parent[v] = -1;

  for (int root = 0; root < n; root++) {
    if (parent[root] >= 0) continue;
    parent[root] = root;
    order[reached++] = root;
    for (int i = reached - 1; i < reached; i++)
      for (int k = net->ring_start[order[i]]; k < net->ring_start[order[i] + 1]; k++)
        if (parent[net->ring[k]] < 0) {
          parent[net->ring[k]] = order[i];
          order[reached++] = net->ring[k];
        }
  }
  *parents = parent;
  *vertices = order;
}

/* The largest |n_j - mirrored n_i| over the edges. */
static double largest_mismatch(const lam_net *net, const lam_vec3 *x, const lam_vec3 *normals) {
  double mismatch = 0;
  for (int e = 0; e < net->edge_count; e++) {
    const int *v = net->edges[e].vertex;
    double d = lam_distance(normals[v[1]], mirrored(x, v[0], v[1], normals[v[0]]));
    if (!(d <= mismatch)) mismatch = d; /* so that NaN stays */
  }
  return mismatch;
}

/* The normal at v is Q_v n_0 with a product Q_v of mirrors along a spanning tree, so the sum of
 * N_v.Q_v n_0 is largest for n_0 along the sum of Q_v^T N_v. Mirrors are their own transposes: that
 * sum is gathered from the leaves to the root. */
double lam_net_mirrored_normals(lam_arena *arena, const lam_net *net, const lam_vec3 *x,
                                lam_vec3 *normals) {
  int n = net->mesh.vertex_count, *order, *parent;
  lam_vec3 *sum = LAM_NEW(arena, lam_vec3, n);
  lam_net_normals(net, x, sum);
  span(arena, net, &parent, &order);

  for (int i = n - 1; i >= 0; i--) {
    int v = order[i], up = parent[v];
    if (up != v) sum[up] = lam_add(sum[up], mirrored(x, v, up, sum[v]));
  }

  /* back from the root to the leaves */
  for (int i = 0; i < n; i++) {
    int v = order[i], up = parent[v];
    normals[v] = lam_unit(up == v ? sum[v] : mirrored(x, up, v, normals[up]));
  }
  return largest_mismatch(net, x, normals);
}

/* ---- face offset ---- */

enum { most_valence = 64 };

/* The shortest w with M w = right, M being the sum of n_k n_k^T over `count` unit normals. Left out
 * are the directions in which the faces ask for nothing: those whose eigenvalue is at most count
 * times the square of an angle under which faces lie in the same plane. */
static lam_vec3 shortest_solution(double M[3][3], int count, lam_vec3 right) {
  static const double same_plane = 1e-16; /* the square of that angle */
  double value[3], vector[3][3];
  lam_vec3 w = {0, 0, 0};
  lam_eigen3(M, value, vector);
  for (int i = 0; i < 3; i++) {
    lam_vec3 d = lam_v3(vector[0][i], vector[1][i], vector[2][i]);
    if (value[i] > same_plane * count) w = lam_along(w, lam_dot(d, right) / value[i], d);
  }
  return w;
}

/* The axis a with n_k.a = 1 for the unit normals of the faces around a vertex: a = u + w with u
 * along the mean normal; w solves n_k.w = 1 - n_k.u in the least squares by the shortest vector. u
 * is split off because normals of neighbors differ little, and w is as small. */
static lam_vec3 cone_axis(const lam_vec3 *n, int count) {
  lam_vec3 u = {0, 0, 0}, right = {0, 0, 0};
  for (int k = 0; k < count; k++) u = lam_add(u, n[k]);
  u = lam_unit(u);

  /* normal equations: sum of n_k n_k^T w = sum of n_k (n_k.(n_k - u)) */
  double M[3][3] = {{0}};
  for (int k = 0; k < count; k++) {
    const double c[3] = {n[k].x, n[k].y, n[k].z};
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) M[i][j] += c[i] * c[j];
    right = lam_along(right, lam_dot(n[k], lam_sub(n[k], u)), n[k]);
  }
  return lam_add(u, shortest_solution(M, count, right));
}

/* Every vertex for itself. */
double lam_net_cone_axes(lam_arena *arena, const lam_net *net, const lam_vec3 *x, lam_vec3 *axes) {
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, net->mesh.face_count), around[most_valence];
  int *rings = lam_net_face_rings(arena, net);
  double miss = 0;
  lam_net_face_normals(net, x, normals);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int count = 0;
    for (int i = net->ring_start[v]; i < net->ring_start[v + 1] && count < most_valence; i++)
      if (rings[i] >= 0) around[count++] = normals[rings[i]];
    axes[v] = cone_axis(around, count);

    for (int k = 0; k < count; k++) {
      double d = fabs(lam_dot(around[k], axes[v]) - 1);
      if (!(d <= miss)) miss = d; /* so that NaN stays */
    }
  }
  return miss;
}

void lam_net_offset(const lam_net *net, const lam_vec3 *x, const lam_vec3 *directions,
                    double distance, lam_vec3 *out) {
  for (int v = 0; v < net->mesh.vertex_count; v++)
    out[v] = lam_along(x[v], distance, directions[v]);
}

/* The normal of the plane of the edge and its first direction against the second direction. */
double lam_net_edge_twist(const lam_net *net, const lam_vec3 *x, const lam_vec3 *directions,
                          int edge) {
  const int *v = net->edges[edge].vertex;
  lam_vec3 plane = lam_unit(lam_cross(lam_sub(x[v[1]], x[v[0]]), directions[v[0]]));
  return fabs(lam_dot(plane, lam_unit(directions[v[1]])));
}

/* ---- Gauss image ---- */

/* Puts a face into the image for every inner vertex of valence 4; its corners are faces of the net,
 * for which used becomes 1. */
static void put_faces(const lam_net *net, const int *rings, lam_mesh *image, int *used) {
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (net->boundary[v] || lam_net_valence(net, v) != 4) continue;
    for (int k = 0; k < 4; k++) {
      int face = rings[net->ring_start[v] + k];
      image->faces[image->face_count][k] = face;
      used[face] = 1;
    }
    image->face_count++;
  }
}

/* index holds first which normals are corners of the image, then their vertices there, or -1. */
lam_mesh lam_net_gauss_image(lam_arena *arena, const lam_net *net, const lam_vec3 *x,
                             int *vertex_of_face) {
  int nf = net->mesh.face_count, nv = net->mesh.vertex_count, *index = LAM_NEW(arena, int, nf);
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, nf);
  lam_mesh image = {0, LAM_NEW(arena, lam_vec3, nf), 0, NULL};
  image.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)nv, sizeof *image.faces);
  lam_net_face_normals(net, x, normals);
  put_faces(net, lam_net_face_rings(arena, net), &image, index);

  /* number the normals that are used, and name them so in the faces */
  for (int f = 0; f < nf; f++) {
    if (index[f]) image.vertices[image.vertex_count] = normals[f];
    index[f] = index[f] ? image.vertex_count++ : -1;
  }
  for (int i = 0; i < image.face_count; i++)
    for (int k = 0; k < 4; k++) image.faces[i][k] = index[image.faces[i][k]];
  if (vertex_of_face) memcpy(vertex_of_face, index, sizeof *index * (size_t)nf);
  return image;
}
