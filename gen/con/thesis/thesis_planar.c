/* Planar stars and faces in the form of the thesis, with normals as unknowns: for asymptotic nets,
 * K-nets, S-nets and planar quads (net/kinds). Also the nodes and normals that all thesis_*.c
 * share. */
#include "con/kernel.h"
#include "con/thesis/thesis.h"

enum { most_valence = 12 };

int lam_thesis_vector_node(lam_problem *problem, lam_vec3 start) {
  return lam_problem_node(problem, 3, (double[]){start.x, start.y, start.z});
}

/* Normals of the net where its vertices are now: starts of the auxiliary unknowns. */
void lam_thesis_normals(lam_scope *scope, lam_vec3 **positions, lam_vec3 **normals) {
  lam_problem *problem = scope->problem;
  *positions = LAM_NEW(problem->arena, lam_vec3, problem->vertex_count);
  *normals = LAM_NEW(problem->arena, lam_vec3, problem->vertex_count);
  lam_problem_positions(problem, *positions);
  lam_net_normals(scope->net, *positions, *normals);
}

/* Writes n^2 - 1 and its derivative 2 n to a row of a Jacobian with n columns (NULL: not wanted);
 * the normal is the k-th vector of the element. */
static void unit_row(const double *x, int n, int k, double *r, double *row) {
  lam_vec3 N = lam_local(x, k);
  *r = lam_dot(N, N) - 1;
  if (!row) return;
  for (int c = 0; c < n; c++) row[c] = 0;
  lam_add_to(row, k, lam_scale(N, 2));
}

/* Writes n . (v_b - v_a) and its derivatives, n by v_b, -n by v_a, v_b - v_a by n, to a row; the
 * normal is the k-th vector of the element. */
static void normal_row(const double *x, int n, int k, int a, int b, double *r, double *row) {
  lam_vec3 N = lam_local(x, k), E = lam_sub(lam_local(x, b), lam_local(x, a));
  *r = lam_dot(N, E);
  if (!row) return;
  for (int c = 0; c < n; c++) row[c] = 0;
  lam_add_to(row, a, lam_scale(N, -1));
  lam_add_to(row, b, N);
  lam_add_to(row, k, E);
}

/* Star of valence m (thesis 3.6.2), unknowns v, v_1..v_m, n:
 *   r_k = n . (v_k - v)  (length),  r_(m+1) = n^2 - 1 */
static void planar_star(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  int m = n / 3 - 2;
  for (int k = 0; k < m; k++) normal_row(x, n, m + 1, 0, k + 1, r + k, J ? J + k * n : NULL);
  unit_row(x, n, m + 1, r + m, J ? J + m * n : NULL);
}

/* Face (thesis 3.1), unknowns v_0..v_3, n:
 *   r_k = n . (v_(k+1) - v_k)  (length, k = 0..3, cyclic),  r_4 = n^2 - 1 */
static void planar_face(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  for (int k = 0; k < 4; k++) normal_row(x, n, 4, k, (k + 1) & 3, r + k, J ? J + k * n : NULL);
  unit_row(x, n, 4, r + 4, J ? J + 4 * n : NULL);
}

static bool takes_part(const lam_net *net, int v, int valence, bool border) {
  return lam_net_valence(net, v) == valence && (border || !net->boundary[v]);
}

/* The block of all stars of one valence; every star gets a node for its normal. */
static void add_stars(lam_scope *scope, int valence, bool border, const lam_vec3 *normals) {
  const lam_net *net = scope->net;
  lam_problem *problem = scope->problem;
  int n = net->mesh.vertex_count, count = 0, arity = valence + 2;
  for (int v = 0; v < n; v++) count += takes_part(net, v, valence, border);
  int *nodes = LAM_NEW(problem->arena, int, count *arity), *to = nodes;
  for (int v = 0; v < n; v++) {
    if (!takes_part(net, v, valence, border)) continue;
    *to++ = v;
    for (int k = 0; k < valence; k++) *to++ = net->ring[net->ring_start[v] + k];
    *to++ = lam_thesis_vector_node(problem, normals[v]);
  }

  lam_block block = {.name = "planar-star", .kernel = planar_star, .weight = 1};
  block.rows = valence + 1;
  block.count = count;
  block.arity = arity;
  block.nodes = nodes;
  lam_problem_add(problem, block);
}

/* Normals start at those of the net. */
void lam_thesis_planar_stars(lam_scope *scope, bool border) {
  const lam_net *net = scope->net;
  lam_vec3 *positions, *normals;
  lam_thesis_normals(scope, &positions, &normals);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    scope->skipped += !net->boundary[v] && lam_net_valence(net, v) > most_valence;
  for (int valence = 3; valence <= most_valence; valence++)
    add_stars(scope, valence, border, normals);
}

/* Normals start along the product of the diagonals. */
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
    lam_vec3 normal = lam_unit(lam_cross(lam_sub(v[2], v[0]), lam_sub(v[3], v[1])));
    *to++ = lam_thesis_vector_node(problem, normal);
  }

  lam_block block = {.name = "planar-face", .kernel = planar_face, .rows = 5, .weight = 1};
  block.count = mesh->face_count;
  block.arity = 5;
  block.nodes = nodes;
  lam_problem_add(problem, block);
}
