/* Nets of two families of traced lines. Line i of family 1 starts at the seed s_i of the base line
 * of family 0, and line j of family 0 at the seed t_j of the base line of family 1. Vertex (i, j)
 * is where they cross: with T the arc length on the one and S on the other, Newton's method for
 * P_i(T) = Q_j(S) in (u, v), whose Jacobian are the directions of the lines. Crossings are followed
 * outward from the base lines, each beginning at its neighbor. Lines that come back to where others
 * are laid already end there. Called by trace_start.c. */
#include "net/trace/trace_net.h"
#include "mesh/net.h"

#include <math.h>
#include <stdlib.h>
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
  double from[2], to[2];          /* arc lengths that seeds may lie between on them */
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

/* ---- lines already laid ---- */

/* A cell between the seeds i, i + 1 and j, j + 1, and how far from `at` it begins, meters. */
typedef struct cell {
  int i, j;
  double away;
} cell;

/* Distance of the gap between two seeds from the base line. */
static double gap_away(const double *seeds, int k) {
  return fmax(fmax(seeds[k], -seeds[k + 1]), 0);
}

/* From near to far; cells at the same distance by their numbers. */
static int by_distance(const void *a, const void *b) {
  const cell *p = a, *q = b;
  if (p->away != q->away) return p->away < q->away ? -1 : 1;
  return p->i != q->i ? p->i - q->i : p->j - q->j;
}

/* Whether all corners of a cell are found; corner: out, in (u, v), in order around it. */
static bool corners_of(const weave *w, int i, int j, lam_vec2 corner[4]) {
  const crossing *c[4] = {&w->at[i * w->m + j], &w->at[(i + 1) * w->m + j],
                          &w->at[(i + 1) * w->m + j + 1], &w->at[i * w->m + j + 1]};
  bool found = true;
  for (int k = 0; k < 4; k++) {
    found = found && c[k]->found;
    corner[k] = (lam_vec2){c[k]->u, c[k]->v};
  }
  return found;
}

/* Twice the area of a cell in (u, v), with the sense of its corners. */
static double turn_of(const lam_vec2 c[4]) {
  return (c[2].x - c[0].x) * (c[3].y - c[1].y) - (c[2].y - c[0].y) * (c[3].x - c[1].x);
}

/* Seen from the base line, the crossing of cell k that is farther out, and the last seed on its
 * side. */
static void outward(const double *seeds, int count, int k, int *first, int *last) {
  bool up = seeds[k] + seeds[k + 1] >= 0;
  *first = up ? k + 1 : 0;
  *last = up ? count - 1 : k;
}

/* A cell cannot be laid: its outer corner is no crossing, nor are those beyond it. */
static void give_up(weave *w, int i, int j) {
  int i0, i1, j0, j1;
  outward(w->s, w->n, i, &i0, &i1);
  outward(w->t, w->m, j, &j0, &j1);
  for (int a = i0; a <= i1; a++)
    for (int b = j0; b <= j1; b++) w->at[a * w->m + b].found = false;
}

/* Lays the cells from `at` outward. One that would lie on those before it, or is turned over, ends
 * the lines there. */
static void lay_cells(weave *w) {
  enum { points = 512 };
  int count = (w->n - 1) * (w->m - 1);
  cell *cells = LAM_NEW(w->arena, cell, count);
  for (int k = 0; k < count; k++) {
    int i = k / (w->m - 1), j = k % (w->m - 1);
    cells[k] = (cell){i, j, fmax(gap_away(w->s, i), gap_away(w->t, j))};
  }
  qsort(cells, (size_t)count, sizeof *cells, by_distance);

  lam_line_point a = lam_line_at(&w->base[0], 0), b = lam_line_at(&w->base[1], 0);
  double sense = a.y[2] * b.y[3] - a.y[3] * b.y[2];
  lam_pattern *pattern = lam_pattern_new(w->arena, w->field[0], points);
  for (int k = 0; k < count; k++) {
    lam_vec2 corner[4];
    if (!corners_of(w, cells[k].i, cells[k].j, corner)) continue;
    if (!(turn_of(corner) * sense > 0) || !lam_pattern_lay(pattern, corner))
      give_up(w, cells[k].i, cells[k].j);
  }
}

/* ---- the rectangle ---- */

/* Where the lines i and j cross, in space. */
static lam_vec3 position(const weave *w, int i, int j) {
  const crossing *c = &w->at[i * w->m + j];
  return lam_surface_point(w->field[0]->surface, LAM_CHART_NATURAL, 0, c->u, c->v);
}

/* Sums of the areas of cells, m^2: sums[i * m + j] of those before the lines i and j. Cells without
 * four corners have none. */
static double *area_sums(const weave *w) {
  double *sums = LAM_NEW(w->arena, double, w->n * w->m);
  for (int i = 0; i + 1 < w->n; i++)
    for (int j = 0; j + 1 < w->m; j++) {
      lam_vec2 corner[4];
      double area = 0;
      if (corners_of(w, i, j, corner))
        area = lam_length(lam_cross(lam_sub(position(w, i + 1, j + 1), position(w, i, j)),
                                    lam_sub(position(w, i, j + 1), position(w, i + 1, j)))) /
               2;

      double *at = &sums[(i + 1) * w->m + j + 1];
      *at = area + at[-1] + at[-w->m] - at[-w->m - 1];
    }
  return sums;
}

/* The rectangle of seeds [low, high] with the most area in which all lines cross; the base lines
 * run through it. As a crossing needs those between it and the base lines, the two outer lines of
 * family 1 decide. False: there is none of at least one cell. */
static bool largest(const weave *w, int low[2], int high[2]) {
  double best = 0;
  const double *sums = area_sums(w);
  int m = w->m, up = 0, right = 0; /* the first seeds that are not before the base */
  while (right < w->n - 1 && w->s[right] < 0) right++;
  while (up < m - 1 && w->t[up] < 0) up++;

  for (int i0 = 0; i0 <= right; i0++)
    for (int i1 = right > i0 ? right : i0 + 1; i1 < w->n; i1++) {
      int j0 = up, j1 = up;
      if (!w->at[i0 * m + up].found || !w->at[i1 * m + up].found) continue;
      while (j0 > 0 && w->at[i0 * m + j0 - 1].found && w->at[i1 * m + j0 - 1].found) j0--;
      while (j1 + 1 < m && w->at[i0 * m + j1 + 1].found && w->at[i1 * m + j1 + 1].found) j1++;

      double area = sums[i1 * m + j1] - sums[i0 * m + j1] - sums[i1 * m + j0] + sums[i0 * m + j0];
      if (!(area > best * (1 + 1e-9))) continue;
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

/* Seeds at multiples of the spacing on the base line of a family, count <= cells + 1 of them. */
static double *spaced_seeds(const weave *w, int family, double spacing, int cells, int *count) {
  double from = w->from[family], to = w->to[family];
  int fit = lam_spaced_range(spacing, cells, &from, &to);
  *count = fit + 1;
  return even_seeds(w->arena, from, to, fit ? fit : 1);
}

/* ---- the mesh ---- */

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
  lay_cells(w);
  return largest(w, low, high);
}

/* Seeds at a given spacing around `at`. */
static bool weave_spaced(weave *w, const int grid[2], double spacing, int low[2], int high[2]) {
  w->s = spaced_seeds(w, 0, spacing, grid[0], &w->n);
  w->t = spaced_seeds(w, 1, spacing, grid[1], &w->m);
  return w->n >= 2 && w->m >= 2 && weave_lines(w, low, high);
}

/* Grid cells as far as the lines reach. A first pass with many lines finds where they all cross;
 * then the grid is laid over that part, which shrinks until the whole grid is in it. The last
 * rectangle is taken after a few passes in any case. */
static bool weave_whole(weave *w, const int grid[2], int low[2], int high[2]) {
  enum { probes = 24, passes = 4 };
  double from[2] = {w->from[0], w->from[1]}, to[2] = {w->to[0], w->to[1]};

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

/* The crossings of a rectangle in (u, v). */
static lam_cells cells_of(const weave *w, const int low[2], const int high[2]) {
  lam_cells cells = {high[0] - low[0] + 1, high[1] - low[1] + 1, NULL};
  cells.at = LAM_NEW(w->arena, lam_vec2, cells.rows * cells.columns);
  for (int i = 0; i < cells.rows; i++)
    for (int j = 0; j < cells.columns; j++) {
      const crossing *c = &w->at[(low[0] + i) * w->m + low[1] + j];
      cells.at[i * cells.columns + j] = (lam_vec2){c->u, c->v};
    }
  return cells;
}

/* A pattern of fields over (u, v), and where a line has entered each of them. */
enum { visit_side = 64 };
typedef struct visits {
  const lam_line_field *field;
  bool entered[visit_side][visit_side];
  double s[visit_side][visit_side]; /* arc length there */
} visits;

/* Enters the field of a point of the line. False when the line was there before, and is not only
 * still there. */
static bool enter(visits *v, const lam_line_point *p) {
  const lam_line_field *field = v->field;
  int at[2];
  for (int c = 0; c < 2; c++) {
    double share = (p->y[c] - field->low[c]) / (field->high[c] - field->low[c]);
    at[c] = (int)fmin(fmax(floor(share * visit_side), 0), visit_side - 1);
  }
  bool *entered = &v->entered[at[0]][at[1]];
  double *s = &v->s[at[0]][at[1]];
  if (*entered && fabs(p->s - *s) > field->size / 8) return false;
  *entered = true;
  *s = p->s;
  return true;
}

/* A line may come back beside itself and go on so for long: no net can use it twice. Both halves of
 * the base line of a family go on, step by step, until they enter where it was before. A line that
 * closes ends by itself. */
static void end_where_it_returns(weave *w, int family) {
  const lam_line *line = &w->base[family];
  if (line->end[1] == LAM_END_CLOSED) return;
  lam_arena_mark mark = lam_arena_mark_get(w->arena);
  visits *v = LAM_NEW(w->arena, visits, 1);
  v->field = w->field[family];

  double step = v->field->size / (3 * visit_side), reached[2] = {0, 0};
  double end[2] = {w->from[family], w->to[family]};
  bool going[2] = {true, true};
  for (int k = 0; going[0] || going[1]; k++)
    for (int way = 0; way < 2; way++) {
      if (!going[way]) continue;
      double s = fmin(k * step, fabs(end[way])) * (way ? 1 : -1);
      lam_line_point p = lam_line_at(line, s);
      going[way] = enter(v, &p);
      if (going[way]) reached[way] = s;
      if (s == end[way]) going[way] = false;
    }
  w->from[family] = reached[0], w->to[family] = reached[1];
  lam_arena_release(w->arena, mark);
}

/* Base lines through `at`, as far as they are of use. */
static weave base_lines(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                        const double at[2]) {
  weave w = {.arena = arena, .field = {&field[0], &field[1]}};
  double reach = 4 * field->size;
  for (int k = 0; k < 2; k++) {
    w.base[k] = lam_line_trace(arena, &field[k], at[0], at[1], d[k], reach, reach, NULL);
    w.from[k] = lam_line_first(&w.base[k]), w.to[k] = lam_line_last(&w.base[k]);
    end_where_it_returns(&w, k);
  }
  return w;
}

/* Base lines, then the lines through seeds on them. */
bool lam_weave_net(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                   const double at[2], const int grid[2], double spacing, lam_mesh *mesh,
                   lam_cells *cells) {
  weave w = base_lines(arena, field, d, at);
  int low[2], high[2];
  bool woven =
      spacing > 0 ? weave_spaced(&w, grid, spacing, low, high) : weave_whole(&w, grid, low, high);
  if (!woven) return false;

  *mesh = make_mesh(&w, low, high);
  *cells = cells_of(&w, low, high);
  return true;
}

/* One pass only. */
bool lam_weave_roughly(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                       const double at[2], lam_cells *cells) {
  enum { rough = 12 }; /* cells */
  weave w = base_lines(arena, field, d, at);
  int low[2], high[2];
  w.n = w.m = 1 + rough;
  w.s = even_seeds(arena, w.from[0], w.to[0], rough);
  w.t = even_seeds(arena, w.from[1], w.to[1], rough);
  if (!weave_lines(&w, low, high)) return false;
  *cells = cells_of(&w, low, high);
  return true;
}
