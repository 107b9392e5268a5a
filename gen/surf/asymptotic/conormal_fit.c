/* The conormals of a whole skin. Called by skin_patches.c.
 *
 * Where two asymptotic curves cross, their torsions are opposite (Beltrami-Enneper), so that one
 * vector nu = N / sqrt|tau| serves both: r_u = s nu x nu_u, r_v = -s nu x nu_v. Along an edge nu
 * is a quartic with the conormals n0, n1 and the slopes d0, d1 of its ends and a middle control
 * point c2 of its own. The edge ends at its vertex when c(x) = s integral nu x nu' - (P1 - P0) =
 * 0,
 *
 *   35 integral nu x nu' = 5 n0 x d0 + 18 n0 x c2 - 3 n0 x d1 + 17 n0 x n1 + 2 d0 x c2
 *                          - d0 x d1 / 2 + 3 d0 x n1 - 2 c2 x d1 + 18 c2 x n1 - 5 d1 x n1
 *
 * about 6 equations for 15 unknowns at every vertex. With straight edges nu is linear, and the
 * equations are those of the discrete Lelieuvre normals, which every discrete asymptotic net
 * has. A discrete net is not quite one of lines on a smooth surface: cubics have to make up for
 * that by rotating the edges at all vertices in their tangent planes, which adds up along a
 * line; quartics do it each by itself.
 *
 * Newton's method, with the steps that are least in the sum of |dx|^2 / m among those with c + J
 * dx = 0:
 *
 *   dx = -m J^T y,   J m J^T y = c
 *
 * three unknowns y for every edge, connected with the edges at both ends. A conormal that moves
 * by d turns the tangent plane by d / |nu|, a slope that moves by d moves the curve by |nu| d:
 * hence m = |nu|^2 and 1 / |nu|^2. */
#include "solve/factor.h"
#include "surf/asymptotic/conormal.h"

#include <stdlib.h>
#include <string.h>

enum { STEPS = 40, HALVINGS = 8 };
enum { VECTORS = 3 }; /* of a vertex: conormal and slopes */

/* Misses, in mean edges: where the steps stop, and what counts as converged. */
static const double tolerance = 1e-14, sufficient = 1e-11;

/* Share by which the diagonal is raised, for edges that depend on each other. */
static const double ridge = 1e-14;

typedef struct block {
  double at[3][3];
} block;

/* Two edges that share a vertex, or an edge and itself: a 3 x 3 block of the matrix. */
typedef struct pair {
  int high, low; /* rows and columns */
  int start;     /* of the block in every column of `low`: first entry, from the diagonal */
} pair;

enum { PARTS = 5 }; /* of an edge: n0, d0, c2, d1, n1 */
/* The end of the edge to which a part belongs; c2 belongs to none. */
static const int end_of[PARTS] = {0, 0, 0, 1, 1};

typedef struct fit {
  lam_arena *arena;
  int vertex_count, edge_count, vector_count;
  const lam_conormal_vertex *vertices;
  const lam_conormal_arc *edges;
  double unit;              /* meters */
  lam_vec3 *x, *step;       /* VECTORS per vertex, then one per edge; in sqrt(unit) */
  double *metric;           /* m of each */
  lam_vec3 *chord;          /* per edge: P1 - P0 */
  block (*jacobian)[PARTS]; /* per edge */
  int pair_count;
  pair *pairs;
  int *column, *row; /* the lower triangle of J m J^T by columns, 3 unknowns per edge */
  double *values, *right;
  lam_factor *factor;
} fit;

/* The number in x of part k of an edge. */
static int vector_of(const fit *f, int edge, int k) {
  const lam_conormal_arc *e = &f->edges[edge];
  int end = end_of[k];
  if (k == 2) return VECTORS * f->vertex_count + edge;
  return VECTORS * e->vertex[end] + (k % 2 ? 1 + (e->turn[end] & 1) : 0);
}

/* With which sign part k of an edge is taken: slopes are turned by a half turn. */
static double sign_of(const fit *f, int edge, int k) {
  return k % 2 && f->edges[edge].turn[end_of[k]] & 2 ? -1 : 1;
}

/* c of an edge at x and, where jacobian is not NULL, its derivatives by the five parts. */
static lam_vec3 edge_miss(const fit *f, int edge, const lam_vec3 *x, block *jacobian) {
  static const double factor[PARTS][PARTS] = {
      {0, 5, 18, -3, 17}, {0, 0, 2, -0.5, 3}, {0, 0, 0, -2, 18}, {0, 0, 0, 0, -5}, {0}};
  lam_vec3 sum = lam_scale(f->chord[edge], -1), y[PARTS];
  for (int k = 0; k < PARTS; k++) y[k] = x[vector_of(f, edge, k)];
  for (int k = 0; jacobian && k < PARTS; k++) jacobian[k] = (block){{{0}}};

  for (int i = 0; i < PARTS; i++)
    for (int j = i + 1; j < PARTS; j++) {
      double w =
          f->edges[edge].sign * sign_of(f, edge, i) * sign_of(f, edge, j) * factor[i][j] / 35;
      sum = lam_along(sum, w, lam_cross(y[i], y[j]));

      /* d (a x b) = -b x da + a x db. */
      for (int k = 0; jacobian && k < 2; k++) {
        double(*at)[3] = jacobian[k ? j : i].at;
        lam_vec3 v = lam_scale(k ? y[i] : y[j], k ? w : -w);
        at[0][1] -= v.z, at[0][2] += v.y;
        at[1][0] += v.z, at[1][2] -= v.x;
        at[2][0] -= v.y, at[2][1] += v.x;
      }
    }
  return sum;
}

/* b^T v. */
static lam_vec3 transposed_times(const block *b, lam_vec3 v) {
  lam_vec3 sum = {0, 0, 0};
  for (int r = 0; r < 3; r++)
    sum = lam_along(sum, (&v.x)[r], lam_v3(b->at[r][0], b->at[r][1], b->at[r][2]));
  return sum;
}

/* The largest |c| of all edges; not a number when one is. */
static double largest_miss(const fit *f, const lam_vec3 *x) {
  double most = 0;
  for (int k = 0; k < f->edge_count; k++) {
    double size = lam_length(edge_miss(f, k, x, NULL));
    if (!(size <= most)) most = size;
  }
  return most;
}

/* ---- the equations ---- */

/* The order of pairs in the matrix: by columns, then rows. */
static int by_edges(const void *a, const void *b) {
  const pair *p = a, *q = b;
  return p->low != q->low ? p->low - q->low : p->high - q->high;
}

/* Lists the pairs of edges that share a vertex, ascending and once, and every edge with itself. */
static void find_pairs(fit *f) {
  int n = f->edge_count, *first = LAM_NEW(f->arena, int, f->vertex_count + 1), total = 0;
  int *at = LAM_NEW(f->arena, int, f->vertex_count), *edge = LAM_NEW(f->arena, int, 2 * n);

  /* The edges of every vertex v: edge[first[v]] to edge[first[v + 1] - 1]. */
  for (int k = 0; k < 2 * n; k++) first[f->edges[k / 2].vertex[k % 2] + 1]++;
  for (int v = 0; v < f->vertex_count; v++) {
    total += first[v + 1] * (first[v + 1] + 1) / 2;
    first[v + 1] += first[v];
  }
  for (int k = 0; k < 2 * n; k++) {
    int v = f->edges[k / 2].vertex[k % 2];
    edge[first[v] + at[v]++] = k / 2;
  }

  f->pairs = LAM_NEW(f->arena, pair, total);
  total = 0;
  for (int v = 0; v < f->vertex_count; v++)
    for (int i = first[v]; i < first[v + 1]; i++)
      for (int j = first[v]; j <= i; j++)
        f->pairs[total++] =
            edge[i] < edge[j] ? (pair){edge[j], edge[i], 0} : (pair){edge[i], edge[j], 0};

  qsort(f->pairs, (size_t)total, sizeof *f->pairs, by_edges);
  for (int k = 0; k < total; k++)
    if (!k || by_edges(&f->pairs[k], &f->pairs[f->pair_count - 1]))
      f->pairs[f->pair_count++] = f->pairs[k];
}

/* The columns of the lower triangle, from the pairs in their order. */
static void find_columns(fit *f) {
  int entries = 0;
  f->column = LAM_NEW(f->arena, int, 3 * f->edge_count + 1);
  f->row = LAM_NEW(f->arena, int, 9 * f->pair_count);

  for (int k = 0, end = 0; k < f->pair_count; k = end) {
    int low = f->pairs[k].low;
    while (end < f->pair_count && f->pairs[end].low == low) end++;

    for (int c = 0; c < 3; c++) {
      f->column[3 * low + c] = entries;
      for (int i = k; i < end; i++) {
        f->pairs[i].start = 3 * (i - k);
        for (int r = i == k ? c : 0; r < 3; r++) f->row[entries++] = 3 * f->pairs[i].high + r;
      }
    }
  }
  f->column[3 * f->edge_count] = entries;
}

/* A fill-reducing order of the edges, expanded to unknowns. */
static const int *find_order(const fit *f) {
  int n = f->edge_count, *start = LAM_NEW(f->arena, int, n + 1), *fill = LAM_NEW(f->arena, int, n);
  int *neighbor = LAM_NEW(f->arena, int, 2 * f->pair_count), *order = LAM_NEW(f->arena, int, n);
  int *unknowns = LAM_NEW(f->arena, int, 3 * n);

  for (int k = 0; k < f->pair_count; k++) {
    const pair *p = &f->pairs[k];
    start[p->low + 1] += p->high != p->low;
    start[p->high + 1] += p->high != p->low;
  }
  for (int k = 0; k < n; k++) start[k + 1] += start[k];

  for (int k = 0; k < f->pair_count; k++) {
    const pair *p = &f->pairs[k];
    if (p->high == p->low) continue;
    neighbor[start[p->low] + fill[p->low]++] = p->high;
    neighbor[start[p->high] + fill[p->high]++] = p->low;
  }

  lam_factor_order(f->arena, n, start, neighbor, order);
  for (int k = 0; k < 3 * n; k++) unknowns[k] = 3 * order[k / 3] + k % 3;
  return unknowns;
}

/* The pattern of the matrix, which stays the same in all steps, and its analysis. */
static void find_pattern(fit *f) {
  find_pairs(f);
  find_columns(f);
  f->values = LAM_NEW(f->arena, double, f->column[3 * f->edge_count]);
  f->right = LAM_NEW(f->arena, double, 3 * f->edge_count);
  f->factor = lam_factor_analyze(f->arena, 3 * f->edge_count, f->column, f->row, find_order(f));
}

/* The block of J m J^T of two edges. */
static block product(const fit *f, int a, int b) {
  block out = {{{0}}};
  for (int i = 0; i < PARTS; i++)
    for (int j = 0; j < PARTS; j++) {
      int vector = vector_of(f, a, i);
      if (vector != vector_of(f, b, j)) continue;

      for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
          for (int k = 0; k < 3; k++)
            out.at[r][c] +=
                f->metric[vector] * f->jacobian[a][i].at[r][k] * f->jacobian[b][j].at[c][k];
    }
  return out;
}

/* Values and right side of J m J^T y = c at x. */
static void assemble(fit *f) {
  for (int k = 0; k < f->edge_count; k++) {
    lam_vec3 miss = edge_miss(f, k, f->x, f->jacobian[k]);
    memcpy(f->right + 3 * k, &miss, sizeof miss);
  }

  for (int k = 0; k < f->pair_count; k++) {
    const pair *p = &f->pairs[k];
    block b = product(f, p->high, p->low);
    for (int c = 0; c < 3; c++)
      for (int r = p->high == p->low ? c : 0; r < 3; r++)
        f->values[f->column[3 * p->low + c] + p->start - c + r] =
            b.at[r][c] * (r == c && p->high == p->low ? 1 + ridge : 1);
  }
}

/* One step, halved until the equations are met better, HALVINGS - 1 times at most. missed: the
 * largest miss, before and after. False: the equations depend on each other too much for a step. */
static bool take_step(fit *f, double *missed) {
  double size = 0;
  assemble(f);
  if (!lam_factor_refactor(f->factor, f->values)) return false;
  lam_factor_solve(f->factor, f->right, f->right);

  for (int k = 0; k < 3 * f->edge_count; k++) size += fabs(f->right[k]);
  if (!isfinite(size)) return false;

  /* dx = -m J^T y. */
  for (int v = 0; v < f->vector_count; v++) f->step[v] = lam_v3(0, 0, 0);
  for (int k = 0; k < f->edge_count; k++) {
    lam_vec3 y = {f->right[3 * k], f->right[3 * k + 1], f->right[3 * k + 2]};
    for (int i = 0; i < PARTS; i++) {
      int v = vector_of(f, k, i);
      f->step[v] = lam_along(f->step[v], -f->metric[v], transposed_times(&f->jacobian[k][i], y));
    }
  }

  /* Every further attempt takes half of the last step back. */
  double length = 1, reached = INFINITY;
  for (int attempt = 0; attempt < HALVINGS; attempt++, length /= 2) {
    for (int v = 0; v < f->vector_count; v++)
      f->x[v] = lam_along(f->x[v], attempt ? -length : length, f->step[v]);
    reached = largest_miss(f, f->x);
    if (reached <= (1 - length / 10) * *missed) break;
  }
  *missed = reached;
  return true;
}

/* The mean length of the edges, m. */
static double mean_edge(const fit *f) {
  double mean = 0;
  for (int k = 0; k < f->edge_count; k++) {
    const int *v = f->edges[k].vertex;
    mean += lam_distance(f->vertices[v[0]].point, f->vertices[v[1]].point) / f->edge_count;
  }
  return mean;
}

/* Sets the middle control point of an edge to that of the cubic with the same ends and slopes. */
static void start_middle(fit *f, int k) {
  lam_vec3 y[PARTS];
  int at = vector_of(f, k, 2);
  for (int i = 0; i < PARTS; i++) y[i] = lam_scale(f->x[vector_of(f, k, i)], sign_of(f, k, i));
  f->x[at] = lam_along(lam_mix(y[0], y[4], 0.5), 1.0 / 6, lam_sub(y[1], y[3]));
  f->metric[at] = (f->metric[vector_of(f, k, 1)] + f->metric[vector_of(f, k, 3)]) / 2;
}

/* The unknowns in the unit of the mean edge, whose square root is that of conormals, and their
 * metric. */
static void prepare(fit *f) {
  int n = f->vector_count = VECTORS * f->vertex_count + f->edge_count;
  f->unit = mean_edge(f);
  f->x = LAM_NEW(f->arena, lam_vec3, n);
  f->step = LAM_NEW(f->arena, lam_vec3, n);
  f->metric = LAM_NEW(f->arena, double, n);

  for (int v = 0; v < VECTORS * f->vertex_count; v++) {
    const lam_conormal_vertex *from = &f->vertices[v / VECTORS];
    int number = v % VECTORS;
    f->x[v] = lam_scale(number ? from->slope[number - 1] : from->conormal, 1 / sqrt(f->unit));
    double square = lam_dot(from->conormal, from->conormal) / f->unit;
    f->metric[v] = number ? 1 / square : square;
  }

  for (int k = 0; k < f->edge_count; k++) start_middle(f, k);
  f->chord = LAM_NEW(f->arena, lam_vec3, f->edge_count);
  f->jacobian = lam_arena_alloc(f->arena, (size_t)f->edge_count, sizeof *f->jacobian);
  for (int k = 0; k < f->edge_count; k++) {
    const int *v = f->edges[k].vertex;
    f->chord[k] = lam_scale(lam_sub(f->vertices[v[1]].point, f->vertices[v[0]].point), 1 / f->unit);
  }
}

/* Steps until the miss is rounding: below tolerance, or small and no longer falling by half. */
lam_skin_fit lam_conormal_fit(lam_arena *arena, int vertex_count, lam_conormal_vertex *vertices,
                              int edge_count, lam_conormal_arc *edges) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  fit f = {
      .arena = arena, .vertex_count = vertex_count, .edge_count = edge_count, .vertices = vertices};
  lam_skin_fit result = {.steps = 0};
  f.edges = edges;

  prepare(&f);
  find_pattern(&f);
  double missed = largest_miss(&f, f.x);
  for (double before = INFINITY; result.steps < STEPS && missed > tolerance; result.steps++) {
    if (before <= sufficient && missed >= before / 2) break; /* rounding */
    before = missed;
    if (!take_step(&f, &missed)) break;
  }

  double root = sqrt(f.unit);
  result.missed = missed * f.unit;
  result.converged = missed <= sufficient;
  for (int v = 0; v < vertex_count; v++) {
    const lam_vec3 *x = f.x + VECTORS * v;
    result.tilt = fmax(result.tilt, lam_angle(vertices[v].conormal, x[0]));
    vertices[v].conormal = lam_scale(x[0], root);
    for (int d = 0; d < 2; d++) vertices[v].slope[d] = lam_scale(x[1 + d], root);
  }
  for (int k = 0; k < edge_count; k++) edges[k].middle = lam_scale(f.x[vector_of(&f, k, 2)], root);
  lam_arena_release(arena, mark);
  return result;
}
