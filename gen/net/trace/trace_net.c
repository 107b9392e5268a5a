/* Nets of two families of traced lines. Line i of family 1 starts at the seed s_i of the base line
 * of family 0, and line j of family 0 at the seed t_j of the base line of family 1. Vertex (i, j)
 * is where they cross: with T the arc length on the one and S on the other, Newton's method for
 * P_i(T) = Q_j(S) in (u, v), whose Jacobian are the directions of the lines. Crossings are followed
 * outward from the base lines, each beginning at its neighbor. */
#include "net/trace/trace_net.h"
#include "mesh/net.h"

#include <math.h>
#include <string.h>

typedef struct crossing {
  bool found;
  double S, T;
  double u, v;
} crossing;

typedef struct weave {
  lam_arena *arena;
  const lam_line_field *field[2]; /* of family 0 and 1 */
  lam_line base[2];
  int n, m;            /* seeds */
  double *s, *t;       /* of the seeds; increasing */
  lam_line *across[2]; /* across[0][j]: family 0; across[1][i]: family 1 */
  crossing *at;        /* n x m */
} weave;

/* ---- lines and crossings ---- */

static void trace_lines(weave *w) {
  for (int family = 0; family < 2; family++) {
    int count = family ? w->n : w->m;
    const double *seeds = family ? w->s : w->t;
    w->across[family] = LAM_NEW(w->arena, lam_line, count);
    lam_line_point middle = lam_line_at(&w->base[family], 0);
    for (int k = 0; k < count; k++) {
      lam_line_point seed = lam_line_at(&w->base[!family], seeds[k]);
      /* the sense of the base line, carried along the other base line */
      lam_vec2 d[2];
      if (!lam_line_directions(w->field[family], seed.y[0], seed.y[1], d)) continue;
      lam_vec2 way = d[w->field[family]->branch];
      lam_vec2 other = {seed.y[2], seed.y[3]};
      lam_line_point base = lam_line_at(&w->base[!family], 0);
      double turn =
          (base.y[2] * middle.y[3] - base.y[3] * middle.y[2]) * (other.x * way.y - other.y * way.x);
      if (turn < 0) way.x = -way.x, way.y = -way.y;
      double reach = 4 * w->field[family]->size;
      w->across[family][k] =
          lam_line_trace(w->arena, w->field[family], seed.y[0], seed.y[1], way, reach, reach, NULL);
    }
  }
}

/* Newton from a guess; false when the lines do not cross near it. Beyond its end a line stays at
 * its end. */
static bool cross(const weave *w, int i, int j, crossing *c) {
  const lam_line *P = &w->across[1][i], *Q = &w->across[0][j];
  double size = w->field[0]->size;
  if (!P->count || !Q->count) return false;
  for (int iteration = 0, outside = 0; iteration < 30 && outside < 3; iteration++) {
    lam_line_point p = lam_line_at(P, c->T), q = lam_line_at(Q, c->S);
    double du = q.y[0] - p.y[0], dv = q.y[1] - p.y[1], det = p.y[2] * -q.y[3] + q.y[2] * p.y[3];
    double dT = (du * -q.y[3] + q.y[2] * dv) / det, dS = (p.y[2] * dv - p.y[3] * du) / det;
    if (!isfinite(dT + dS)) return false;
    c->u = p.y[0], c->v = p.y[1];
    if (fabs(dT) + fabs(dS) < 1e-10 * size) return true;
    outside += fabs(p.s - c->T) + fabs(q.s - c->S) > 1e-9 * size; /* beyond the ends */
    c->T = p.s + dT, c->S = q.s + dS;
  }
  return false;
}

/* Index of the seed before k on its way from the base (at 0): -1 when the base itself comes before
 * it. */
static int inward(const double *seeds, int count, int k) {
  int next = seeds[k] > 0 ? k - 1 : k + 1;
  return seeds[k] == 0 || next < 0 || next >= count || seeds[next] * seeds[k] < 0 ? -1 : next;
}

/* Seeds in the order of their distance from the base. */
static int *outward_order(lam_arena *arena, const double *seeds, int count) {
  int *order = LAM_NEW(arena, int, count), high = 0;
  while (high < count && seeds[high] < 0) high++;
  for (int k = 0, low = high - 1; k < count; k++)
    order[k] = low < 0 || (high < count && seeds[high] <= -seeds[low]) ? high++ : low--;
  return order;
}

static void find_crossings(weave *w) {
  int *rows = outward_order(w->arena, w->s, w->n), *columns = outward_order(w->arena, w->t, w->m);
  w->at = LAM_NEW(w->arena, crossing, w->n * w->m);
  for (int a = 0; a < w->n; a++)
    for (int b = 0; b < w->m; b++) {
      int i = rows[a], j = columns[b], before_i = inward(w->s, w->n, i),
          before_j = inward(w->t, w->m, j);
      const crossing *left = before_i < 0 ? NULL : &w->at[before_i * w->m + j];
      const crossing *below = before_j < 0 ? NULL : &w->at[i * w->m + before_j];
      if ((left && !left->found) || (below && !below->found)) continue;
      crossing guess = {.S = w->s[i], .T = w->t[j]};
      if (left) guess.S += left->S - w->s[before_i];
      if (below) guess.T += below->T - w->t[before_j];
      guess.found = cross(w, i, j, &guess);
      w->at[i * w->m + j] = guess;
    }
}

/* ---- the rectangle ---- */

/* The rectangle of most area, in arc lengths, around the base lines in which all lines cross. What
 * is found is monotone: a crossing needs those between it and the base. False: there is none of at
 * least one cell. */
static bool largest(const weave *w, int low[2], int high[2]) {
  double best = 0;
  int up = 0, right = 0; /* the first seeds that are not before the base */
  while (right < w->n - 1 && w->s[right] < 0) right++;
  while (up < w->m - 1 && w->t[up] < 0) up++;
  for (int i0 = 0; i0 <= right; i0++)
    for (int i1 = right > i0 ? right : i0 + 1; i1 < w->n; i1++) {
      int j0 = up, j1 = up;
      if (!w->at[i0 * w->m + up].found || !w->at[i1 * w->m + up].found) continue;
      while (j0 > 0 && w->at[i0 * w->m + j0 - 1].found && w->at[i1 * w->m + j0 - 1].found) j0--;
      while (j1 + 1 < w->m && w->at[i0 * w->m + j1 + 1].found && w->at[i1 * w->m + j1 + 1].found)
        j1++;
      double area = (w->s[i1] - w->s[i0]) * (w->t[j1] - w->t[j0]);
      if (!(area > best * (1 + 1e-12))) continue;
      best = area;
      low[0] = i0, high[0] = i1, low[1] = j0, high[1] = j1;
    }
  return best > 0;
}

static double *even_seeds(lam_arena *arena, double from, double to, int cells) {
  double *seeds = LAM_NEW(arena, double, cells + 1);
  for (int k = 0; k <= cells; k++) seeds[k] = from + (to - from) * k / cells;
  return seeds;
}

/* Multiples of the spacing within a line, at most `cells` of them, half of them on each side where
 * the line allows. */
static double *spaced_seeds(lam_arena *arena, const lam_line *line, double spacing, int cells,
                            int *count) {
  double slack = 1e-9;
  int back = (int)fmin(floor(-lam_line_first(line) / spacing + slack), cells);
  int ahead = (int)fmin(floor(lam_line_last(line) / spacing + slack), cells);
  int behind = back < cells / 2 ? back : cells / 2;
  if (ahead > cells - behind) ahead = cells - behind;
  if (behind + ahead < cells) behind = back < cells - ahead ? back : cells - ahead;
  *count = behind + ahead + 1;
  return even_seeds(arena, -behind * spacing, ahead * spacing, behind + ahead ? behind + ahead : 1);
}

/* ---- the mesh ---- */

static lam_vec3 position(const weave *w, int i, int j) {
  const crossing *c = &w->at[i * w->m + j];
  return lam_surface_point(w->field[0]->surface, LAM_CHART_NATURAL, 0, c->u, c->v);
}

/* Whether the first and the last line of a rectangle are the same points. */
static bool closes(const weave *w, const int low[2], const int high[2], int way) {
  if (high[way] - low[way] < 3) return false;
  for (int k = low[!way]; k <= high[!way]; k++) {
    lam_vec3 a = way ? position(w, k, low[1]) : position(w, low[0], k);
    lam_vec3 b = way ? position(w, k, high[1]) : position(w, high[0], k);
    if (!(lam_distance(a, b) <= 1e-7 * w->field[0]->size)) return false;
  }
  return true;
}

static lam_mesh make_mesh(const weave *w, const int low[2], const int high[2]) {
  bool closed[2] = {closes(w, low, high, 0), closes(w, low, high, 1)};
  int n = high[0] - low[0] + !closed[0], m = high[1] - low[1] + !closed[1];
  lam_mesh mesh = lam_mesh_grid(w->arena, n, m, closed[0], closed[1]);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) mesh.vertices[i * m + j] = position(w, low[0] + i, low[1] + j);
  return mesh;
}

static void weave_lines(weave *w) {
  trace_lines(w);
  find_crossings(w);
}

bool lam_weave_net(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                   const double at[2], const int grid[2], double spacing, lam_mesh *mesh) {
  enum { probes = 24, passes = 4 };
  weave w = {.arena = arena, .field = {&field[0], &field[1]}};
  int low[2], high[2];
  for (int k = 0; k < 2; k++)
    w.base[k] = lam_line_trace(arena, &field[k], at[0], at[1], d[k], 4 * field[k].size,
                               4 * field[k].size, NULL);
  if (spacing > 0) {
    w.s = spaced_seeds(arena, &w.base[0], spacing, grid[0], &w.n);
    w.t = spaced_seeds(arena, &w.base[1], spacing, grid[1], &w.m);
    if (w.n < 2 || w.m < 2) return false;
    weave_lines(&w);
    if (!largest(&w, low, high)) return false;
    *mesh = make_mesh(&w, low, high);
    return true;
  }
  double from[2], to[2];
  for (int k = 0; k < 2; k++)
    from[k] = lam_line_first(&w.base[k]), to[k] = lam_line_last(&w.base[k]);
  for (int pass = 0; pass < passes; pass++) {
    bool probing = pass == 0;
    w.n = 1 + (probing ? probes : grid[0]), w.m = 1 + (probing ? probes : grid[1]);
    w.s = even_seeds(arena, from[0], to[0], w.n - 1);
    w.t = even_seeds(arena, from[1], to[1], w.m - 1);
    weave_lines(&w);
    if (!largest(&w, low, high)) return false;
    bool whole = low[0] == 0 && low[1] == 0 && high[0] == w.n - 1 && high[1] == w.m - 1;
    if (whole && !probing) break;
    from[0] = w.s[low[0]], to[0] = w.s[high[0]], from[1] = w.t[low[1]], to[1] = w.t[high[1]];
  }
  *mesh = make_mesh(&w, low, high);
  return true;
}
