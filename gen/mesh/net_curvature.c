/* Curvatures of a net by polynomials fitted to the vertices around each vertex (Cazals & Pouget
 * 2005). Called by net/measures/curvature_measures.c. */
#include "mesh/net_curvature.h"
#include "surf/surface.h"

#include <math.h>

/* Terms of a polynomial of degree 4 in two variables; vertices that a fit may use. */
enum { most_terms = 15, most_around = 128 };

typedef struct fitter {
  const lam_net *net;
  const lam_vec3 *x, *normals;
  int *face_start, *faces; /* faces of vertex v: faces[face_start[v] .. face_start[v + 1] - 1] */
  int *stamp;              /* per vertex: 1 + the last vertex that collected this one */
} fitter;

/* ---- the vertices around a vertex ---- */

/* Fills face_start and faces by a counting sort. Counts are entered two further on, so that next[v]
 * is first where the faces of v begin, and after filling where they end: face_start[v + 1]. */
static void find_faces(lam_arena *arena, fitter *f) {
  const lam_mesh *mesh = &f->net->mesh;
  f->face_start = LAM_NEW(arena, int, mesh->vertex_count + 2);
  f->faces = LAM_NEW(arena, int, 4 * (size_t)mesh->face_count);
  int *next = f->face_start + 1;
  for (int i = 0; i < mesh->face_count; i++)
    for (int k = 0; k < 4; k++) next[mesh->faces[i][k] + 1]++;
  for (int v = 0; v < mesh->vertex_count; v++) next[v + 1] += next[v];
  for (int i = 0; i < mesh->face_count; i++)
    for (int k = 0; k < 4; k++) f->faces[next[mesh->faces[i][k]]++] = i;
}

/* Vertices of the rings of faces around v, v first: two rings, or three where the first one touches
 * the boundary. Those whose normal looks away are left out. Returns their number. */
static int collect(fitter *f, int v, int around[most_around]) {
  int count = 1, first = 0, last = 1, rings = 2;
  around[0] = v;
  f->stamp[v] = v + 1;

  /* around[first .. last - 1] are the vertices that the ring before added */
  for (int ring = 0; ring < rings; ring++, first = last, last = count)
    for (int a = first; a < last; a++)
      for (int i = f->face_start[around[a]]; i < f->face_start[around[a] + 1]; i++)
        for (int k = 0; k < 4; k++) {
          int w = f->net->mesh.faces[f->faces[i]][k];
          if (f->stamp[w] == v + 1 || count == most_around) continue;
          f->stamp[w] = v + 1;
          if (ring == 0 && f->net->boundary[w]) rings = 3;
          if (lam_dot(f->normals[v], f->normals[w]) > 0) around[count++] = w;
        }
  return count;
}

/* ---- least squares ---- */

/* Cholesky factor in the lower half; false when A is singular. */
static bool factor(double A[most_terms][most_terms], int n) {
  for (int c = 0; c < n; c++) {
    double diagonal = A[c][c];
    for (int k = 0; k < c; k++) A[c][c] -= A[c][k] * A[c][k];
    if (!(A[c][c] > 1e-9 * diagonal)) return false;
    A[c][c] = sqrt(A[c][c]);
    for (int r = c + 1; r < n; r++) {
      for (int k = 0; k < c; k++) A[r][c] -= A[r][k] * A[c][k];
      A[r][c] /= A[c][c];
    }
  }
  return true;
}

/* b := L^-1 b with the factor L in the lower half of A. */
static void forward(double A[most_terms][most_terms], double *b, int n) {
  for (int r = 0; r < n; r++) {
    for (int k = 0; k < r; k++) b[r] -= A[r][k] * b[k];
    b[r] /= A[r][r];
  }
}

/* b := L^-T b. */
static void backward(double A[most_terms][most_terms], double *b, int n) {
  for (int r = n - 1; r >= 0; r--) {
    for (int k = r + 1; k < n; k++) b[r] -= A[k][r] * b[k];
    b[r] /= A[r][r];
  }
}

/* How much a second-order coefficient (terms 3, 4, 5) grows from errors of the heights: the square
 * root of an entry on the diagonal of the inverse of A = L L^T, |L^-1 e_t|. In a 5 x 5 grid it is
 * 5.7 at the middle and 9.4 beside a corner; it is large where there are too few rows for the
 * degree. */
static double amplification(double L[most_terms][most_terms], int n) {
  double worst = 0;
  for (int t = 3; t < 6; t++) {
    double e[most_terms] = {0}, sum = 0;
    e[t] = 1;
    forward(L, e, n);
    for (int k = 0; k < n; k++) sum += e[k] * e[k];
    worst = fmax(worst, sqrt(sum));
  }
  return worst;
}

/* 1, u, v, u^2, u v, v^2, ...: the terms of degree d are u times those of degree d - 1, and v times
 * the last of them. */
static void monomials(double u, double v, int degree, double row[most_terms]) {
  row[0] = 1;
  for (int d = 1, t = 1; d <= degree; d++, t += d) {
    for (int q = 0; q < d; q++) row[t + q] = u * row[t - d + q];
    row[t + d] = v * row[t - 1];
  }
}

/* Least squares of the height z over the monomials in x and y up to the degree; lengths are divided
 * by size. c: the coefficients. False: too few points, or they leave the second order open. */
static bool fit(const lam_vec3 *local, int count, int degree, double size, double c[most_terms]) {
  int terms = (degree + 1) * (degree + 2) / 2;
  if (count < terms) return false;

  double A[most_terms][most_terms] = {{0}};
  for (int t = 0; t < terms; t++) c[t] = 0;
  for (int i = 0; i < count; i++) {
    double row[most_terms];
    monomials(local[i].x / size, local[i].y / size, degree, row);
    for (int r = 0; r < terms; r++) {
      c[r] += row[r] * local[i].z / size;
      for (int s = 0; s <= r; s++) A[r][s] += row[r] * row[s];
    }
  }

  if (!factor(A, terms) || amplification(A, terms) > 20) return false;
  forward(A, c, terms);
  backward(A, c, terms);
  return true;
}

/* ---- curvature ---- */

/* Curvatures at 0 of the height w(u, v) with coefficients c (lengths divided by size), over the
 * frame a, b, n. With the orthonormal tangents e1 along x_u and e2 = n x e1, the second form is
 * [p q; q r]; it is diagonal after a turn by half the angle of (p - r, 2 q). */
static lam_net_curvature curvature(const double *c, double size, const lam_vec3 frame[3],
                                   int degree) {
  lam_jet jet = {.u = lam_along(frame[0], c[1], frame[2]),
                 .v = lam_along(frame[1], c[2], frame[2]),
                 .uu = lam_scale(frame[2], 2 * c[3] / size),
                 .uv = lam_scale(frame[2], c[4] / size),
                 .vv = lam_scale(frame[2], 2 * c[5] / size)};
  lam_curvature k = lam_jet_curvature(&jet);

  /* x_u = length e1 and x_v = f e1 + g e2: L, M, N in terms of p, q, r, solved for these */
  lam_vec3 e1 = lam_unit(jet.u), e2 = lam_cross(k.normal, e1);
  double f = lam_dot(jet.v, e1), g = lam_dot(jet.v, e2), length = lam_length(jet.u);
  double p = k.L / (length * length), q = (k.M / length - f * p) / g,
         r = (k.N - f * (f * p + 2 * g * q)) / (g * g);
  double turn = atan2(2 * q, p - r) / 2;
  return (lam_net_curvature){degree,
                             k.K,
                             k.H,
                             k.k1,
                             k.k2,
                             {lam_add(lam_scale(e1, cos(turn)), lam_scale(e2, sin(turn))),
                              lam_sub(lam_scale(e2, cos(turn)), lam_scale(e1, sin(turn)))}};
}

/* The curvature at vertex v, by the highest degree that fits. */
static lam_net_curvature curvature_at(fitter *f, int v) {
  lam_net_curvature none = {0};
  if (f->net->boundary[v]) return none;
  int around[most_around];
  int count = collect(f, v, around);

  /* a frame of the tangent plane, a towards the first neighbor, and the vertices in it */
  lam_vec3 n = f->normals[v], e = lam_sub(f->x[f->net->ring[f->net->ring_start[v]]], f->x[v]);
  lam_vec3 a = lam_unit(lam_along(e, -lam_dot(e, n), n)), b = lam_cross(n, a), local[most_around];
  double size = 0, c[most_terms];
  for (int i = 0; i < count; i++) {
    lam_vec3 d = lam_sub(f->x[around[i]], f->x[v]);
    local[i] = lam_v3(lam_dot(d, a), lam_dot(d, b), lam_dot(d, n));
    size = fmax(size, hypot(local[i].x, local[i].y));
  }

  for (int degree = 4; degree >= 2 && size > 0; degree--)
    if (fit(local, count, degree, size, c))
      return curvature(c, size, (lam_vec3[3]){a, b, n}, degree);
  return none;
}

/* What the fits need besides the result is released before it returns. */
lam_net_curvature *lam_net_curvatures(lam_arena *arena, const lam_net *net,
                                      const lam_vec3 *positions) {
  int n = net->mesh.vertex_count;
  lam_net_curvature *out = LAM_NEW(arena, lam_net_curvature, n);
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, n);
  lam_net_normals(net, positions, normals);
  fitter f = {.net = net, .x = positions, .normals = normals, .stamp = LAM_NEW(arena, int, n)};
  find_faces(arena, &f);
  for (int v = 0; v < n; v++) out[v] = curvature_at(&f, v);
  lam_arena_release(arena, mark);
  return out;
}
