#include "con/constraint.h"
#include "con/kernel.h"

/* Planar vertex star (asymptotic net, thesis 3.3).
 *   N = unit((e1 - e3) x (e2 - e4)),  e_k = (v_k - v) / |v_k - v|
 *   r1 = N . e1,  r2 = N . e2                         (dimensionless)
 * N is orthogonal to e1 - e3 and e2 - e4, so N.e3 = r1 and N.e4 = r2: two equations make all five
 * vertices coplanar. With M = (e1 - e3) x (e2 - e4) and g = (c - N (N.c)) / |M|:  dr/da = b x g,
 * dr/db = g x a, dr/dc = N for r = N.c. */
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

/* A star of any valence m: with S = sum e_k x e_(k+1) and N = S / |S|, r_k = N . e_k. Nodes:
 * center, then the ring. */
enum { most_valence = 12 };

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
    lam_vec3 g = lam_scale(lam_along(e[i], -r[i], N), 1 / size);
    lam_vec3 de[most_valence]; /* S contains e_(k-1) x e_k + e_k x e_(k+1): dS.g = de_k . ((e_(k+1)
                                  - e_(k-1)) x g) */
    for (int k = 0; k < m; k++) de[k] = lam_cross(lam_sub(e[(k + 1) % m], e[(k + m - 1) % m]), g);
    de[i] = lam_add(de[i], N);
    lam_edges_row(row, m, e, length, de);
  }
}

/* Border vertex with its two border edges e1, e3 and its inner edge e2: r = N . e1, N = unit((e1 -
 * e3) x e2). */
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

static void add_half_stars(lam_scope *scope, double weight) {
  const int *nodes;
  int count = lam_scope_half_stars(scope, &nodes);
  lam_problem_add(scope->problem, (lam_block){.name = "planar-star",
                                              .kernel = planar_half_star,
                                              .rows = 1,
                                              .weight = weight,
                                              .count = count,
                                              .arity = 4,
                                              .nodes = nodes});
}

static void add_fans(lam_scope *scope, double weight) {
  const lam_net *net = scope->net;
  for (int valence = 3; valence <= most_valence; valence++) {
    int count = 0, *nodes = NULL;
    for (int pass = 0; pass < 2; pass++) {
      if (pass) nodes = LAM_NEW(scope->problem->arena, int, count *(valence + 1));
      count = 0;
      for (int v = 0; valence != 4 && v < net->mesh.vertex_count; v++) {
        if (net->boundary[v] || net->ring_start[v + 1] - net->ring_start[v] != valence) continue;
        if (nodes) {
          nodes[count * (valence + 1)] = v;
          for (int k = 0; k < valence; k++)
            nodes[count * (valence + 1) + 1 + k] = net->ring[net->ring_start[v] + k];
        }
        count++;
      }
    }
    lam_problem_add(scope->problem, (lam_block){.name = "planar-star",
                                                .kernel = planar_fan,
                                                .rows = valence,
                                                .weight = weight,
                                                .count = count,
                                                .arity = valence + 1,
                                                .nodes = nodes});
  }
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_star_params *given = params;
  const int *nodes;
  long skipped = scope->skipped;
  int count = lam_scope_stars(scope, given && given->border, &nodes);
  scope->skipped = skipped; /* irregular stars are handled below, but for the largest */
  for (int v = 0; v < scope->net->mesh.vertex_count; v++)
    scope->skipped += !scope->net->boundary[v] &&
                      scope->net->ring_start[v + 1] - scope->net->ring_start[v] > most_valence;
  lam_problem_add(scope->problem, (lam_block){.name = "planar-star",
                                              .kernel = planar_star,
                                              .rows = 2,
                                              .weight = weight,
                                              .count = count,
                                              .arity = 5,
                                              .nodes = nodes});
  add_fans(scope, weight);
  if (given && given->border) add_half_stars(scope, weight);
}

const lam_constraint_kind lam_con_planar_star = {
    {"planar-star", "Planar vertex stars",
     "Every interior vertex lies in one plane with its neighbors: the polylines then follow "
     "asymptotic curves, and "
     "strips "
     "normal to the net unroll straight. Possible only where the surface is saddle-shaped (K < 0); "
     "on a dome the only "
     "solution is a plane. Vertices of any valence take part.",
     "N.e1 = N.e2 = 0, N = unit((e1 - e3) x (e2 - e4))", "thesis 3.3", lam_star_keys,
     sizeof(lam_star_params)},
    add};
