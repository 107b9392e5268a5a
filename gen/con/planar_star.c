/* The constraint `planar-star`: every vertex in one plane with its neighbors. Listed in
 * constraints.c; asymptotic nets and K-nets (net/kinds) add it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Irregular vertices of a larger valence are skipped. */
enum { most_valence = 12 };

/* Planar vertex star (asymptotic net, thesis 3.3).
 *   N = unit((e1 - e3) x (e2 - e4)),  e_k = (v_k - v) / |v_k - v|
 *   r1 = N . e1,  r2 = N . e2                         (dimensionless)
 * N is orthogonal to e1 - e3 and e2 - e4, so N.e3 = r1 and N.e4 = r2: two equations make all five
 * vertices coplanar. For r = N.c with a = e1 - e3, b = e2 - e4, M = a x b and g = (c - N (N.c)) /
 * |M|:  dr/da = b x g, dr/db = g x a, dr/dc = N. */
static void planar_star(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 e[4];
  double length[4];
  lam_unit_edges(x, 4, e, length);
  lam_vec3 a = lam_sub(e[0], e[2]), b = lam_sub(e[1], e[3]), M = lam_cross(a, b);
  double size = lam_length(M);
  lam_vec3 N = lam_scale(M, 1 / size);

  for (int i = 0; i < 2; i++) {
    r[i] = lam_dot(N, e[i]);
    if (!J) continue;
    double *row = J + i * n;
    lam_vec3 g = lam_scale(lam_along(e[i], -r[i], N), 1 / size);
    lam_vec3 da = lam_cross(b, g), db = lam_cross(g, a);
    lam_vec3 de[4] = {da, db, lam_scale(da, -1), lam_scale(db, -1)};
    de[i] = lam_add(de[i], N);
    lam_edges_row(row, 4, e, length, de);
  }
}

/* A star of any valence m up to 12: with S = sum e_k x e_(k+1) and N = S / |S|,
 *   r_k = N . e_k   (m rows, dimensionless)
 * S contains e_(k-1) x e_k + e_k x e_(k+1), so dS.g = de_k . ((e_(k+1) - e_(k-1)) x g) with g as
 * above. Nodes: center, then the ring. */
static void planar_fan(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  int m = n / 3 - 1;
  lam_vec3 e[most_valence], S = {0, 0, 0};
  double length[most_valence];
  lam_unit_edges(x, m, e, length);
  for (int k = 0; k < m; k++) S = lam_add(S, lam_cross(e[k], e[(k + 1) % m]));
  double size = lam_length(S);
  lam_vec3 N = lam_scale(S, 1 / size);

  for (int i = 0; i < m; i++) {
    r[i] = lam_dot(N, e[i]);
    if (!J) continue;
    double *row = J + i * n;
    lam_vec3 g = lam_scale(lam_along(e[i], -r[i], N), 1 / size), de[most_valence];
    for (int k = 0; k < m; k++) de[k] = lam_cross(lam_sub(e[(k + 1) % m], e[(k + m - 1) % m]), g);
    de[i] = lam_add(de[i], N);
    lam_edges_row(row, m, e, length, de);
  }
}

/* Border vertex with its two border edges e1, e3 and its inner edge e2:
 *   r = N . e1   (dimensionless),  N = unit((e1 - e3) x e2), Jacobian as in planar_star, b = e2 */
static void planar_half_star(int n, const double *x, const double *p, double *r, double *J) {
  (void)n, (void)p;
  lam_vec3 e[3];
  double length[3];
  lam_unit_edges(x, 3, e, length);
  lam_vec3 a = lam_sub(e[0], e[2]), M = lam_cross(a, e[1]);
  double size = lam_length(M);
  lam_vec3 N = lam_scale(M, 1 / size);
  r[0] = lam_dot(N, e[0]);
  if (!J) return;

  lam_vec3 g = lam_scale(lam_along(e[0], -r[0], N), 1 / size), da = lam_cross(e[1], g);
  lam_vec3 de[3] = {lam_add(da, N), lam_cross(g, a), lam_scale(da, -1)};
  lam_edges_row(J, 3, e, length, de);
}

/* ---- blocks ---- */

/* Border vertices with one inner edge. */
static void add_half_stars(lam_scope *scope, double weight) {
  lam_block block = {.name = "planar-star", .kernel = planar_half_star, .rows = 1, .arity = 4};
  block.weight = weight;
  block.count = lam_scope_half_stars(scope, &block.nodes);
  lam_problem_add(scope->problem, block);
}

/* Writes the inner vertices of a valence with their rings to nodes, which may be NULL. Returns
 * their number. */
static int fans(const lam_net *net, int valence, int *nodes) {
  int count = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (net->boundary[v] || lam_net_valence(net, v) != valence) continue;
    if (nodes) {
      int *to = nodes + count * (valence + 1);
      to[0] = v;
      for (int k = 0; k < valence; k++) to[1 + k] = net->ring[net->ring_start[v] + k];
    }
    count++;
  }
  return count;
}

/* One block per valence of irregular vertices. */
static void add_fans(lam_scope *scope, double weight) {
  for (int valence = 3; valence <= most_valence; valence++) {
    if (valence == 4) continue;
    int count = fans(scope->net, valence, NULL);
    int *nodes = LAM_NEW(scope->problem->arena, int, count *(valence + 1));
    fans(scope->net, valence, nodes);

    lam_block block = {.name = "planar-star", .kernel = planar_fan, .rows = valence};
    block.weight = weight;
    block.count = count;
    block.arity = valence + 1;
    block.nodes = nodes;
    lam_problem_add(scope->problem, block);
  }
}

/* Irregular stars are fans, so only the largest ones are skipped. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_star_params *given = params;
  const lam_net *net = scope->net;
  bool border = given && given->border;
  long skipped = scope->skipped;
  lam_star_block_add(scope, "planar-star", planar_star, 2, border, weight);
  scope->skipped = skipped;
  for (int v = 0; v < net->mesh.vertex_count; v++)
    scope->skipped += !net->boundary[v] && lam_net_valence(net, v) > most_valence;

  add_fans(scope, weight);
  if (border) add_half_stars(scope, weight);
}

const lam_constraint_kind lam_con_planar_star = {
    {"planar-star", "Planar vertex stars",
     "Every interior vertex lies in one plane with its neighbors: the polylines then follow "
     "asymptotic curves, and strips normal to the net unroll straight. Possible only where the "
     "surface is saddle-shaped (K < 0); on a dome the only solution is a plane. Vertices of any "
     "valence take part.",
     "N.e1 = N.e2 = 0, N = unit((e1 - e3) x (e2 - e4))", "thesis 3.3", lam_star_keys,
     sizeof(lam_star_params)},
    add};
