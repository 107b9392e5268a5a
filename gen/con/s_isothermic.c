/* The constraint `s-isothermic`: touching spheres and incircles. Listed in constraints.c;
 * net/kinds/s_isothermic_net.c adds it.
 *
 * S-isothermic net (thesis 3.5.3, definition 26): spheres at the vertices that touch along the
 * edges, and in every face an incircle through the points where they touch. Beside the vertices v
 * the unknowns are a radius rho per vertex, and a center c and a radius R per face. */
#include "con/constraint.h"
#include "con/kernel.h"
#include "mesh/tangential.h"

/* Spheres of neighbors touch: with E = v1 - v0,
 *   r = |E| - rho0 - rho1  (length),  dr/dv1 = E / |E| = -dr/dv0, dr/drho_k = -1
 * Nodes: v0, v1, rho0, rho1. */
static void touching(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 E = lam_sub(lam_local(x, 1), lam_local(x, 0));
  double length = lam_length(E);
  r[0] = length - x[6] - x[7];
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = 0;
  lam_vec3 e = lam_scale(E, 1 / length);
  lam_add_to(J, 1, e);
  lam_add_to(J, 0, lam_scale(e, -1));
  J[6] = J[7] = -1;
}

/* The circle of a face is orthogonal to the spheres at its corners: with d = v_k - c,
 *   r_k = (|d|^2 - rho_k^2 - R^2) / 2  (length^2)
 *   dr_k/dv_k = d = -dr_k/dc, dr_k/drho_k = -rho_k, dr_k/dR = -R
 * Nodes: v0 .. v3, rho0 .. rho3, (c, R). */
static void orthogonal_spheres(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  const double *rho = x + 12, R = x[19];
  lam_vec3 center = lam_v3(x[16], x[17], x[18]);
  for (int c = 0; J && c < 4 * n; c++) J[c] = 0;

  for (int k = 0; k < 4; k++) {
    lam_vec3 d = lam_sub(lam_local(x, k), center);
    r[k] = (lam_dot(d, d) - rho[k] * rho[k] - R * R) / 2;
    if (!J) continue;
    double *row = J + k * n;
    lam_add_to(row, k, d);
    row[12 + k] = -rho[k];
    row[16] = -d.x, row[17] = -d.y, row[18] = -d.z, row[19] = -R;
  }
}

/* The center lies in the plane of the face:
 *   r = N . F  (length),  F = c - v0,  N = unit(d1 x d2),  d1 = v2 - v0,  d2 = v3 - v1
 *   dr/dd1 = d2 x g, dr/dd2 = g x d1, dr/dF = N with g = (F - N (N.F)) / |d1 x d2|
 * Nodes: v0 .. v3, (c, R). */
static void center_in_plane(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 v0 = lam_local(x, 0), F = lam_sub(lam_local(x, 4), v0);
  lam_vec3 d1 = lam_sub(lam_local(x, 2), v0), d2 = lam_sub(lam_local(x, 3), lam_local(x, 1)),
           M = lam_cross(d1, d2);
  double size = lam_length(M);
  lam_vec3 N = lam_scale(M, 1 / size);
  r[0] = lam_dot(N, F);
  if (!J) return;

  for (int c = 0; c < n; c++) J[c] = 0;
  lam_vec3 g = lam_scale(lam_along(F, -r[0], N), 1 / size), r1 = lam_cross(d2, g),
           r2 = lam_cross(g, d1);
  lam_add_to(J, 0, lam_scale(lam_add(r1, N), -1));
  lam_add_to(J, 1, lam_scale(r2, -1));
  lam_add_to(J, 2, r1);
  lam_add_to(J, 3, r2);
  lam_add_to(J, 4, N);
}

/* ---- nodes and blocks ---- */

/* The nodes of the further unknowns. */
typedef struct extra {
  int *radius; /* per vertex: rho */
  int *circle; /* per face: (c, R) */
} extra;

/* The node of face f; it starts as the incircle of mesh/tangential.h. */
static int circle_node(lam_scope *scope, const lam_vec3 *positions, int f) {
  lam_vec3 corners[4];
  for (int k = 0; k < 4; k++) corners[k] = positions[scope->net->mesh.faces[f][k]];
  lam_incircle circle = lam_incircle_of(corners);
  double start[4] = {circle.center.x, circle.center.y, circle.center.z, circle.radius};
  return lam_problem_node(scope->problem, 4, start);
}

/* Makes the nodes; radii start at the mean tangents of the faces. */
static extra add_nodes(lam_scope *scope) {
  lam_problem *problem = scope->problem;
  const lam_mesh *mesh = &scope->net->mesh;
  lam_vec3 *positions = LAM_NEW(problem->arena, lam_vec3, mesh->vertex_count);
  double *radii = LAM_NEW(problem->arena, double, mesh->vertex_count);
  extra nodes = {LAM_NEW(problem->arena, int, mesh->vertex_count),
                 LAM_NEW(problem->arena, int, mesh->face_count)};
  lam_problem_positions(problem, positions);
  lam_net_sphere_radii(scope->net, positions, radii);

  for (int v = 0; v < mesh->vertex_count; v++)
    nodes.radius[v] = lam_problem_node(problem, 1, &radii[v]);
  for (int f = 0; f < mesh->face_count; f++) nodes.circle[f] = circle_node(scope, positions, f);
  return nodes;
}

/* One element of `touching` per edge. */
static void add_edges(lam_scope *scope, const extra *more, lam_block block) {
  const lam_net *net = scope->net;
  int *nodes = LAM_NEW(scope->problem->arena, int, 4 * net->edge_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      nodes[4 * e + k] = net->edges[e].vertex[k];
      nodes[4 * e + 2 + k] = more->radius[net->edges[e].vertex[k]];
    }

  block.kernel = touching;
  block.rows = 1;
  block.count = net->edge_count;
  block.arity = 4;
  block.nodes = nodes;
  lam_problem_add(scope->problem, block);
}

/* One element of `orthogonal_spheres` per face. */
static void add_circles(lam_scope *scope, const extra *more, lam_block block) {
  const lam_mesh *mesh = &scope->net->mesh;
  int *nodes = LAM_NEW(scope->problem->arena, int, 9 * mesh->face_count);
  for (int f = 0; f < mesh->face_count; f++) {
    for (int k = 0; k < 4; k++) {
      nodes[9 * f + k] = mesh->faces[f][k];
      nodes[9 * f + 4 + k] = more->radius[mesh->faces[f][k]];
    }
    nodes[9 * f + 8] = more->circle[f];
  }

  block.kernel = orthogonal_spheres;
  block.rows = 4;
  block.count = mesh->face_count;
  block.arity = 9;
  block.nodes = nodes;
  lam_problem_add(scope->problem, block);
}

/* One element of `center_in_plane` per face. */
static void add_centers(lam_scope *scope, const extra *more, lam_block block) {
  const lam_mesh *mesh = &scope->net->mesh;
  int *nodes = LAM_NEW(scope->problem->arena, int, 5 * mesh->face_count);
  for (int f = 0; f < mesh->face_count; f++) {
    for (int k = 0; k < 4; k++) nodes[5 * f + k] = mesh->faces[f][k];
    nodes[5 * f + 4] = more->circle[f];
  }

  block.kernel = center_in_plane;
  block.rows = 1;
  block.count = mesh->face_count;
  block.arity = 5;
  block.nodes = nodes;
  lam_problem_add(scope->problem, block);
}

/* Flat faces are the constraint of planar_face.c; the rest are the three kernels above. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  extra more = add_nodes(scope);
  lam_con_planar_face.add(scope, params, weight, location);
  const lam_block block = {.name = "s-isothermic", .weight = weight};
  add_edges(scope, &more, block);
  add_circles(scope, &more, block);
  add_centers(scope, &more, block);
}

const lam_constraint_kind lam_con_s_isothermic = {
    {"s-isothermic", "Touching incircles and spheres",
     "Every face is flat and has an incircle; incircles of neighbors touch their common edge in "
     "the same point, where the spheres around its two vertices touch each other. Radii of the "
     "spheres, centers and radii of the circles are further unknowns.",
     "|v_i - v_j| = rho_i + rho_j; |v - c|^2 = rho^2 + R^2; N.(c - v) = 0",
     "thesis 3.5.3, definition 26", NULL, 0},
    add};
