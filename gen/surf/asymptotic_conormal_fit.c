/* The conormals of a whole skin. Where two asymptotic curves cross, their torsions are opposite (Beltrami-Enneper), so
 * that one vector nu = N / sqrt|tau| serves both: r_u = s nu x nu_u, r_v = -s nu x nu_v. Along an edge nu is the cubic
 * with the conormals n0, n1 and the slopes d0, d1 of its ends, and the edge ends at its vertex when
 *   s integral nu x nu' = s (n0 x n1 + (n0 x d0 - n0 x d1 + d0 x n1 + n1 x d1) / 5 - d0 x d1 / 30) = P1 - P0.
 * These are about 6 equations for 9 unknowns at every vertex. With straight edges nu is linear, and the equations are
 * those of the discrete Lelieuvre normals, which every discrete asymptotic net has.
 *
 * What is left free goes to fairness: third derivatives along edges, nu''' = 12 (n0 - n1) + 6 (d0 + d1), jumps of the
 * second derivatives where edges continue each other, and the distance from the start; each times the length of the
 * conormals at the start, because r^(k) is about nu x nu^(k). */
#include "solve/guided.h"
#include "surf/asymptotic_conormal.h"

#include <stdlib.h>

/* Residual: the end of the edge less the vertex. Unknown: n0, d0, n1, d1. p: s, the signs of d0 and d1, P1 - P0. */
static void chord(int n, const double *x, const double *p, double *r, double *J) {
  static const double pair[4][4] = {{0, 0.2, 1, -0.2}, {0, 0, 0.2, -1.0 / 30}, {0, 0, 0, 0.2}, {0, 0, 0, 0}};
  const double way[4] = {1, p[1], 1, p[2]};
  for (int c = 0; c < 3; c++) r[c] = -p[3 + c];
  for (int i = 0; J && i < 3 * n; i++) J[i] = 0;
  for (int a = 0; a < 4; a++)
    for (int b = a + 1; b < 4; b++) {
      double w = p[0] * way[a] * way[b] * pair[a][b];
      const double *f = x + 3 * a, *g = x + 3 * b;
      for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        r[c] += w * (f[d] * g[e] - f[e] * g[d]);
        if (!J) continue;
        J[c * n + 3 * a + d] += w * g[e];
        J[c * n + 3 * a + e] -= w * g[d];
        J[c * n + 3 * b + e] += w * f[d];
        J[c * n + 3 * b + d] -= w * f[e];
      }
    }
}

/* Residual: sum of p_k times unknown vector k, less the vector that follows in p. */
static void combination(int n, const double *x, const double *p, double *r, double *J) {
  for (int i = 0; J && i < 3 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    r[c] = -p[n / 3 + c];
    for (int k = 0; k < n / 3; k++) {
      r[c] += p[k] * x[3 * k + c];
      if (J) J[c * n + 3 * k + c] = p[k];
    }
  }
}

typedef struct fit {
  lam_arena *arena;
  lam_problem *problem;
  int vertex_count, edge_count;
  lam_conormal_vertex *vertices;
  const lam_conormal_arc *edges;
  int *node;   /* per vertex, or -1 */
  int used;    /* nodes of conormals; those of slopes follow */
  double unit; /* meters */
  double *weight;
} fit;

static int slope_node(const fit *f, int v, int turn) { return f->used + 2 * f->node[v] + (turn & 1); }
static double slope_sign(int turn) { return turn & 2 ? -1 : 1; }

static void add(fit *f, const char *name, lam_kernel kernel, lam_role role, double weight, int count, int arity,
                const int *nodes, int param_count, double *params) {
  lam_problem_add(f->problem, (lam_block){.name = name,
                                          .kernel = kernel,
                                          .rows = 3,
                                          .linear = role == LAM_FAIRNESS,
                                          .role = role,
                                          .weight = weight,
                                          .count = count,
                                          .arity = arity,
                                          .nodes = nodes,
                                          .param_count = param_count,
                                          .params = params});
}

static void add_edges(fit *f, double third) {
  enum { CHORD = 6, THIRD = 7 };
  int *nodes = LAM_NEW(f->arena, int, 4 * f->edge_count);
  double *chords = LAM_NEW(f->arena, double, CHORD * f->edge_count);
  double *thirds = LAM_NEW(f->arena, double, THIRD * f->edge_count);
  for (int k = 0; k < f->edge_count; k++) {
    const lam_conormal_arc *e = &f->edges[k];
    lam_vec3 span = lam_sub(f->vertices[e->vertex[1]].point, f->vertices[e->vertex[0]].point);
    double *p = chords + CHORD * k, *q = thirds + THIRD * k;
    p[0] = e->sign;
    for (int c = 0; c < 3; c++) p[3 + c] = (&span.x)[c] / f->unit;
    double w = (f->weight[f->node[e->vertex[0]]] + f->weight[f->node[e->vertex[1]]]) / 2;
    for (int i = 0; i < 2; i++) {
      nodes[4 * k + 2 * i] = f->node[e->vertex[i]];
      nodes[4 * k + 2 * i + 1] = slope_node(f, e->vertex[i], e->turn[i]);
      p[1 + i] = slope_sign(e->turn[i]);
      q[2 * i] = (i ? -12 : 12) * w;
      q[2 * i + 1] = 6 * w * slope_sign(e->turn[i]);
    }
  }
  add(f, "chord", chord, LAM_HARD, 1, f->edge_count, 4, nodes, CHORD, chords);
  add(f, "third derivative", combination, LAM_FAIRNESS, third, f->edge_count, 4, nodes, THIRD, thirds);
}

/* nu'' where an edge continues another one: 6 (n2 - n0) - 2 d0 - 8 d1 - 2 d2. */
static void add_jumps(fit *f, double weight) {
  enum { JUMP = 8 };
  int(*out)[4] = lam_arena_alloc(f->arena, (size_t)f->used, sizeof *out), count = 0;
  for (int k = 0; k < 2 * f->edge_count; k++) { /* 1 + edge and end, by the direction in which it leaves the vertex */
    const lam_conormal_arc *e = &f->edges[k / 2];
    out[f->node[e->vertex[k % 2]]][(e->turn[k % 2] + 2 * (k % 2)) & 3] = 1 + k;
  }
  int *nodes = LAM_NEW(f->arena, int, 10 * f->used);
  double *params = LAM_NEW(f->arena, double, 2 * JUMP * f->used);
  for (int v = 0; v < f->vertex_count; v++)
    for (int axis = 0; axis < 2 && f->node[v] >= 0; axis++) {
      const int *at = out[f->node[v]];
      if (!at[axis] || !at[axis + 2]) continue;
      int *node = nodes + 5 * count;
      double *p = params + JUMP * count++, w = f->weight[f->node[v]];
      for (int side = 0; side < 2; side++) {
        int k = at[axis + 2 * side] - 1, far = 1 - k % 2;
        const lam_conormal_arc *e = &f->edges[k / 2];
        int turn = e->turn[far] + 2 * (k % 2) + 2 * side; /* along the axis */
        node[2 * side] = f->node[e->vertex[far]];
        node[2 * side + 1] = slope_node(f, e->vertex[far], turn);
        p[2 * side] = (side ? -6 : 6) * w;
        p[2 * side + 1] = -2 * w * slope_sign(turn);
      }
      node[4] = slope_node(f, v, axis);
      p[4] = -8 * w;
    }
  add(f, "second derivative", combination, LAM_FAIRNESS, weight, count, 5, nodes, JUMP, params);
}

static void add_closeness(fit *f, double conormal, double slope) {
  int *nodes = LAM_NEW(f->arena, int, 3 * f->used);
  double *params = LAM_NEW(f->arena, double, 12 * f->used);
  for (int k = 0; k < 3 * f->used; k++) {
    nodes[k] = k;
    double w = f->weight[k < f->used ? k : (k - f->used) / 2];
    params[4 * k] = w;
    for (int c = 0; c < 3; c++) params[4 * k + 1 + c] = w * f->problem->x[3 * k + c];
  }
  add(f, "conormal", combination, LAM_FAIRNESS, conormal, f->used, 1, nodes, 4, params);
  add(f, "slope", combination, LAM_FAIRNESS, slope, 2 * f->used, 1, nodes + f->used, 4, params + 4 * f->used);
}

static double knob(const char *name, double otherwise) { return getenv(name) ? atof(getenv(name)) : otherwise; }
#include <stdio.h>

lam_skin_fit lam_conormal_fit(lam_arena *arena, int vertex_count, lam_conormal_vertex *vertices, int edge_count,
                              const lam_conormal_arc *edges) {
  fit f = {.arena = arena, .vertex_count = vertex_count, .edge_count = edge_count, .vertices = vertices};
  f.edges = edges;
  f.node = LAM_NEW(arena, int, vertex_count);
  for (int v = 0; v < vertex_count; v++) f.node[v] = -1;
  for (int k = 0; k < edge_count; k++) {
    f.unit += lam_distance(vertices[edges[k].vertex[0]].point, vertices[edges[k].vertex[1]].point) / edge_count;
    for (int i = 0; i < 2; i++) f.node[edges[k].vertex[i]] = 0;
  }
  lam_vec3 *start = LAM_NEW(arena, lam_vec3, vertex_count);
  double root = sqrt(f.unit);
  for (int v = 0; v < vertex_count; v++) {
    if (f.node[v] < 0) continue;
    f.node[v] = f.used;
    start[f.used++] = lam_scale(vertices[v].conormal, 1 / root);
  }
  f.problem = lam_problem_new(arena, f.used, start);
  f.weight = LAM_NEW(arena, double, f.used);
  for (int k = 0; k < f.used; k++) f.weight[k] = lam_length(start[k]);
  for (int v = 0; v < vertex_count; v++)
    for (int d = 0; d < 2 && f.node[v] >= 0; d++) {
      lam_vec3 slope = lam_scale(vertices[v].slope[d], 1 / root);
      lam_problem_node(f.problem, 3, &slope.x);
    }
  add_edges(&f, knob("K3", 1));
  add_jumps(&f, knob("K2", 1));
  add_closeness(&f, knob("KN", 0.01), knob("KD", 0.01));
  lam_schedule schedule = lam_schedule_default();
  schedule.fairness = knob("KW", 1);
  schedule.hold = (int)knob("KH", 1);
  schedule.decay = knob("KQ", 0.2);
  schedule.floor = knob("KF", 1e-3);
  schedule.tolerance = 1e-13;
  schedule.max_iterations = 60;
  lam_solution s = lam_guided_solve(f.problem, &schedule, NULL);
  if (getenv("KV")) {
    for (int i = 0; i < s.history_count; i++) fprintf(stderr, "%d %g\n", i, s.history[i]);
    fprintf(stderr, "%s, %d unknowns %d equations, %d iterations, residual %g, %g s, factor %g s, assembly %g\n",
            s.reason, s.unknowns, s.residuals, s.iterations, s.residual, s.seconds_total, s.seconds_factor,
            s.seconds_assembly);
  }
  lam_skin_fit result = {.converged = s.converged, .reason = s.reason, .iterations = s.iterations};
  result.residual = s.residual * f.unit;
  for (int v = 0; v < vertex_count; v++) {
    if (f.node[v] < 0) continue;
    const double *x = f.problem->x + 3 * f.node[v], *y = f.problem->x + 3 * (f.used + 2 * f.node[v]);
    lam_vec3 before = vertices[v].conormal;
    vertices[v].conormal = lam_v3(root * x[0], root * x[1], root * x[2]);
    result.tilt = fmax(result.tilt, lam_angle(before, vertices[v].conormal));
    for (int d = 0; d < 2; d++)
      vertices[v].slope[d] = lam_v3(root * y[3 * d], root * y[3 * d + 1], root * y[3 * d + 2]);
  }
  return result;
}
