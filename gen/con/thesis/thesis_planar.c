#include "con/kernel.h"
#include "con/thesis/thesis.h"

enum { most_valence = 12 };

int lam_thesis_vector_node(lam_problem *problem, lam_vec3 start) {
  return lam_problem_node(problem, 3, (double[]){start.x, start.y, start.z});
}

/* Writes n^2 - 1 and its derivative to a row; the normal is the k-th vector of the element. */
static void unit_row(const double *x, int n, int k, double *r, double *row) {
  lam_vec3 N = lam_local(x, k);
  *r = lam_dot(N, N) - 1;
  if (!row) return;
  for (int c = 0; c < n; c++) row[c] = 0;
  lam_add_to(row, k, lam_scale(N, 2));
}

/* Writes n . (v_b - v_a) and its derivative to a row; the normal is the k-th vector of the element.
 */
static void normal_row(const double *x, int n, int k, int a, int b, double *r, double *row) {
  lam_vec3 N = lam_local(x, k), E = lam_sub(lam_local(x, b), lam_local(x, a));
  *r = lam_dot(N, E);
  if (!row) return;
  for (int c = 0; c < n; c++) row[c] = 0;
  lam_add_to(row, a, lam_scale(N, -1));
  lam_add_to(row, b, N);
  lam_add_to(row, k, E);
}

/* Star of valence m, unknowns v, v_1..v_m, n:  r_k = n . (v_k - v)  (length),  r_(m+1) = n^2 - 1 */
static void planar_star(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  int m = n / 3 - 2;
  for (int k = 0; k < m; k++) normal_row(x, n, m + 1, 0, k + 1, r + k, J ? J + k * n : NULL);
  unit_row(x, n, m + 1, r + m, J ? J + m * n : NULL);
}

/* Face, unknowns v_0..v_3, n:  r_k = n . (v_(k+1) - v_k)  (length),  r_5 = n^2 - 1 */
static void planar_face(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  for (int k = 0; k < 4; k++) normal_row(x, n, 4, k, (k + 1) & 3, r + k, J ? J + k * n : NULL);
  unit_row(x, n, 4, r + 4, J ? J + 4 * n : NULL);
}

static bool takes_part(const lam_net *net, int v, int valence, bool border) {
  return net->ring_start[v + 1] - net->ring_start[v] == valence && (border || !net->boundary[v]);
}

void lam_thesis_planar_stars(lam_scope *scope, bool border) {
  const lam_net *net = scope->net;
  lam_problem *problem = scope->problem;
  int n = net->mesh.vertex_count;
  lam_vec3 *x = LAM_NEW(problem->arena, lam_vec3, n),
           *normals = LAM_NEW(problem->arena, lam_vec3, n);
  lam_problem_positions(problem, x);
  lam_net_normals(net, x, normals);
  for (int v = 0; v < n; v++)
    scope->skipped +=
        !net->boundary[v] && net->ring_start[v + 1] - net->ring_start[v] > most_valence;
  for (int valence = 3; valence <= most_valence; valence++) {
    int count = 0, arity = valence + 2;
    for (int v = 0; v < n; v++) count += takes_part(net, v, valence, border);
    int *nodes = LAM_NEW(problem->arena, int, count *arity), *to = nodes;
    for (int v = 0; v < n; v++) {
      if (!takes_part(net, v, valence, border)) continue;
      *to++ = v;
      for (int k = 0; k < valence; k++) *to++ = net->ring[net->ring_start[v] + k];
      *to++ = lam_thesis_vector_node(problem, normals[v]);
    }
    lam_problem_add(problem, (lam_block){.name = "planar-star",
                                         .kernel = planar_star,
                                         .rows = valence + 1,
                                         .weight = 1,
                                         .count = count,
                                         .arity = arity,
                                         .nodes = nodes});
  }
}

void lam_thesis_planar_faces(lam_scope *scope) {
  const lam_mesh *mesh = &scope->net->mesh;
  lam_problem *problem = scope->problem;
  int *nodes = LAM_NEW(problem->arena, int, 5 * mesh->face_count), *to = nodes;
  for (int f = 0; f < mesh->face_count; f++) {
    lam_vec3 v[4];
    for (int k = 0; k < 4; k++) {
      v[k] = lam_local(problem->x, mesh->faces[f][k]);
      *to++ = mesh->faces[f][k];
    }
    *to++ = lam_thesis_vector_node(problem,
                                   lam_unit(lam_cross(lam_sub(v[2], v[0]), lam_sub(v[3], v[1]))));
  }
  lam_problem_add(problem, (lam_block){.name = "planar-face",
                                       .kernel = planar_face,
                                       .rows = 5,
                                       .weight = 1,
                                       .count = mesh->face_count,
                                       .arity = 5,
                                       .nodes = nodes});
}
