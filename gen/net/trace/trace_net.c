/* Nets of two families of traced lines. Line i of family 1 starts at the seed s_i of the base line
 * of family 0, and line j of family 0 at the seed t_j of the base line of family 1. Vertex (i, j)
 * is where they cross: with T the arc length on the one and S on the other, Newton's method for
 * P_i(T) = Q_j(S) in (u, v), whose Jacobian are the directions of the lines. Crossings are followed
 * outward from the base lines, each beginning at its neighbor. Called by trace_start.c. */
#include "net/trace/trace_net.h"
#include "mesh/net.h"

#include <math.h>
#include <string.h>

/* Where a line of each family cross. */
typedef struct crossing {
  bool found;
  double S, T; /* arc length on the line of family 0 and of family 1 */
  double u, v;
} crossing;

/* Two families of lines and their crossings. */
typedef struct weave {
  lam_arena *arena;
  const lam_line_field *field[2]; /* of family 0 and 1 */
  lam_line base[2];               /* the lines of both families through `at` */
  int n, m;                       /* seeds */
  double *s, *t;                  /* of the seeds; increasing */
  lam_line *across[2];            /* across[0][j]: family 0; across[1][i]: family 1 */
  crossing *at;                   /* n x m */
} weave;

/* ---- lines and crossings ---- */

/* The direction of a line of the family at a seed on the other base line, in the sense of the
 * family's own base line: both turn to the same side of the other base line. False: the field has
 * no direction there. */
static bool direction_at_seed(const weave *w, int family, const lam_line_point *seed,
                              lam_vec2 *way) {
  lam_vec2 d[2];
  if (!lam_line_directions(w->field[family], seed->y[0], seed->y[1], d)) return false;
  *way = d[w->field[family]->branch];

  lam_vec2 other = {seed->y[2], seed->y[3]};
  lam_line_point middle = lam_line_at(&w->base[family], 0),
                 base = lam_line_at(&w->base[!family], 0);
  double turn =
      (base.y[2] * middle.y[3] - base.y[3] * middle.y[2]) * (other.x * way->y - other.y * way->x);
  if (turn < 0) way->x = -way->x, way->y = -way->y;
  return true;
}

/* The lines of both families through the seeds; those without a direction stay empty. */
static void trace_lines(weave *w) {
  for (int family = 0; family < 2; family++) {
    int count = family ? w->n : w->m;
    const double *seeds = family ? w->s : w->t;
    double reach = 4 * w->field[family]->size;
    w->across[family] = LAM_NEW(w->arena, lam_line, count);

    for (int k = 0; k < count; k++) {
      lam_line_point seed = lam_line_at(&w->base[!family], seeds[k]);
      lam_vec2 way;
      if (direction_at_seed(w, family, &seed, &way))
        w->across[family][k] = lam_line_trace(w->arena, w->field[family], seed.y[0], seed.y[1], way,
                                              reach, reach, NULL);
    }
  }
}

/* The crossing of line i of family 1 and line j of family 0, by Newton's method from the guess in
 * c->S and c->T; false when the lines do not cross near it. Beyond its end a line stays at its
 * end, and three iterations there give up. */
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

/* Index of the seed next to k towards the base line (at 0); -1 when the base line
 * itself is next. */
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

/* All crossings, from the base lines outward. A crossing needs those next to it towards both base
 * lines: what they have moved against their seeds is the guess for it. */
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

/* The rectangle of seeds [low, high] with the most area, in arc lengths, in which all lines
 * cross; the base lines run through it. As a crossing needs those between it and the base lines,
 * the two outer lines of family 1 decide. False: there is none of at least one cell. */
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

/* cells + 1 seeds from one arc length to another. */
static double *even_seeds(lam_arena *arena, double from, double to, int cells) {
  double *seeds = LAM_NEW(arena, double, cells + 1);
  for (int k = 0; k <= cells; k++) seeds[k] = from + (to - from) * k / cells;
  return seeds;
}

/* from <= to; a range that does not reach 0 has no multiples on that side. */
int lam_spaced_range(double spacing, int cells, double *from, double *to) {
  double slack = 1e-9;
  int back = (int)fmin(fmax(floor(-*from / spacing + slack), 0), cells);
  int ahead = (int)fmin(fmax(floor(*to / spacing + slack), 0), cells);

  /* half on each side, and what one side lacks on the other */
  int behind = back < cells / 2 ? back : cells / 2;
  if (ahead > cells - behind) ahead = cells - behind;
  if (behind + ahead < cells) behind = back < cells - ahead ? back : cells - ahead;

  *from = -behind * spacing, *to = ahead * spacing;
  return behind + ahead;
}

/* Seeds at multiples of the spacing on a line, count <= cells + 1 of them. */
static double *spaced_seeds(lam_arena *arena, const lam_line *line, double spacing, int cells,
                            int *count) {
  double from = lam_line_first(line), to = lam_line_last(line);
  int fit = lam_spaced_range(spacing, cells, &from, &to);
  *count = fit + 1;
  return even_seeds(arena, from, to, fit ? fit : 1);
}

/* ---- the mesh ---- */

/* Where the lines i and j cross, in space. */
static lam_vec3 position(const weave *w, int i, int j) {
  const crossing *c = &w->at[i * w->m + j];
  return lam_surface_point(w->field[0]->surface, LAM_CHART_NATURAL, 0, c->u, c->v);
}

/* Whether the first and the last line of a rectangle in the direction `way` (0: along family 0)
 * are the same points. */
static bool closes(const weave *w, const int low[2], const int high[2], int way) {
  if (high[way] - low[way] < 3) return false;
  for (int k = low[!way]; k <= high[!way]; k++) {
    lam_vec3 a = way ? position(w, k, low[1]) : position(w, low[0], k);
    lam_vec3 b = way ? position(w, k, high[1]) : position(w, high[0], k);
    if (!(lam_distance(a, b) <= 1e-7 * w->field[0]->size)) return false;
  }
  return true;
}

/* The mesh of a rectangle; where it closes, the last line is the first one again. */
static lam_mesh make_mesh(const weave *w, const int low[2], const int high[2]) {
  bool closed[2] = {closes(w, low, high, 0), closes(w, low, high, 1)};
  int n = high[0] - low[0] + !closed[0], m = high[1] - low[1] + !closed[1];
  lam_mesh mesh = lam_mesh_grid(w->arena, n, m, closed[0], closed[1]);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) mesh.vertices[i * m + j] = position(w, low[0] + i, low[1] + j);
  return mesh;
}

/* ---- the net ---- */

/* Lines through the seeds, their crossings and the largest rectangle; false: there is none. */
static bool weave_lines(weave *w, int low[2], int high[2]) {
  trace_lines(w);
  find_crossings(w);
  return largest(w, low, high);
}

/* Seeds at a given spacing around `at`. */
static bool weave_spaced(weave *w, const int grid[2], double spacing, int low[2], int high[2]) {
  w->s = spaced_seeds(w->arena, &w->base[0], spacing, grid[0], &w->n);
  w->t = spaced_seeds(w->arena, &w->base[1], spacing, grid[1], &w->m);
  return w->n >= 2 && w->m >= 2 && weave_lines(w, low, high);
}

/* Grid cells as far as the lines reach. A first pass with many lines finds where they all cross;
 * then the grid is laid over that part, which shrinks until the whole grid is in it. The last
 * rectangle is taken after a few passes in any case. */
static bool weave_whole(weave *w, const int grid[2], int low[2], int high[2]) {
  enum { probes = 24, passes = 4 };
  double from[2], to[2];
  for (int k = 0; k < 2; k++)
    from[k] = lam_line_first(&w->base[k]), to[k] = lam_line_last(&w->base[k]);

  for (int pass = 0; pass < passes; pass++) {
    bool probing = pass == 0;
    w->n = 1 + (probing ? probes : grid[0]), w->m = 1 + (probing ? probes : grid[1]);
    w->s = even_seeds(w->arena, from[0], to[0], w->n - 1);
    w->t = even_seeds(w->arena, from[1], to[1], w->m - 1);
    if (!weave_lines(w, low, high)) return false;

    bool whole = low[0] == 0 && low[1] == 0 && high[0] == w->n - 1 && high[1] == w->m - 1;
    if (whole && !probing) break;
    from[0] = w->s[low[0]], to[0] = w->s[high[0]], from[1] = w->t[low[1]], to[1] = w->t[high[1]];
  }
  return true;
}

/* Base lines through `at`, then the lines through seeds on them. */
bool lam_weave_net(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                   const double at[2], const int grid[2], double spacing, lam_mesh *mesh) {
  weave w = {.arena = arena, .field = {&field[0], &field[1]}};
  int low[2], high[2];
  for (int k = 0; k < 2; k++)
    w.base[k] = lam_line_trace(arena, &field[k], at[0], at[1], d[k], 4 * field[k].size,
                               4 * field[k].size, NULL);

  bool woven =
      spacing > 0 ? weave_spaced(&w, grid, spacing, low, high) : weave_whole(&w, grid, low, high);
  if (woven) *mesh = make_mesh(&w, low, high);
  return woven;
}
