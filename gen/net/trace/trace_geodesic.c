/* Nets of geodesics. Every geodesic carries the width j of the strip between it and its
 * neighbors, j'' + K j = 0, with these starts:
 *   parallels   j = 1, j' = the geodesic curvature of the base line
 *   at a pole   j = 0, j' = 1
 *
 * Where j has shrunk to a tenth of what it would be in a plane, neighbors are about to meet, and
 * the net ends before (do Carmo, Differential Geometry of Curves and Surfaces, 4-6 and 5-5).
 * Called by trace_start.c. */
#include "core/numbers.h"
#include "mesh/net.h"
#include "net/trace/trace_net.h"

#include <math.h>
#include <string.h>

/* The point of a line at arc length s, in space. */
static lam_vec3 position(const lam_line *line, double s) {
  lam_line_point p = lam_line_at(line, s);
  return lam_surface_point(line->field->surface, LAM_CHART_NATURAL, 0, p.y[0], p.y[1]);
}

/* The same in (u, v). */
static lam_vec2 parameters(const lam_line *line, double s) {
  lam_line_point p = lam_line_at(line, s);
  return (lam_vec2){p.y[0], p.y[1]};
}

/* Points in (u, v) of lines (columns of them) at equal arc lengths from s0 to s1. */
static lam_cells cells_on(lam_arena *arena, const lam_line *lines, int columns, int rows, double s0,
                          double s1) {
  lam_cells cells = {rows, columns, LAM_NEW(arena, lam_vec2, rows * columns)};
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < columns; j++)
      cells.at[i * columns + j] = parameters(&lines[j], s0 + (s1 - s0) * i / (rows - 1));
  return cells;
}

/* ---- parallels ---- */

/* The geodesic at right angles to the base line at arc length t, in the sense that makes geodesic
 * and base line a right turn of each other, as family 0 and 1 are. With the base line's tangent T
 * and N = n x T, the geodesic starts along -N and j' = <x'', N>. */
static lam_line geodesic_from(lam_arena *arena, const lam_line_field *field, const lam_line *base,
                              double t, double reach) {
  lam_line_point p = lam_line_at(base, t);
  lam_jet jet;
  lam_surface_eval(field->surface, p.y[0], p.y[1], &jet);
  lam_curvature c = lam_jet_curvature(&jet);

  double du = p.y[2], dv = p.y[3], det = c.E * c.G - c.F * c.F;
  lam_vec3 tangent = lam_along(lam_scale(jet.u, du), dv, jet.v),
           normal = lam_cross(c.normal, tangent);
  /* x'' but for a multiple of the tangent: a parameter line's u'' and v'' are along it */
  lam_vec3 second =
      lam_along(lam_along(lam_scale(jet.uu, du * du), 2 * du * dv, jet.uv), dv * dv, jet.vv);

  /* -N in coordinates: (E F; F G) d = (a, b) */
  double a = -lam_dot(normal, jet.u), b = -lam_dot(normal, jet.v),
         j[2] = {1, lam_dot(second, normal)};
  lam_vec2 d = {(c.G * a - c.F * b) / det, (c.E * b - c.F * a) / det};
  return lam_line_trace(arena, field, p.y[0], p.y[1], d, reach, reach, j);
}

/* The part of the base line and of its geodesics with the most area that all geodesics between
 * cover: part is {t0, t1, s0, s1}, t along the base line and s along the geodesics. False:
 * there is none. */
static bool largest_strip(lam_arena *arena, const lam_line_field *field, const lam_line *base,
                          double part[4]) {
  enum { probes = 48 };
  double ahead[probes + 1], back[probes + 1], t[probes + 1], best = 0;
  for (int k = 0; k <= probes; k++) {
    t[k] = lam_line_first(base) + (lam_line_last(base) - lam_line_first(base)) * k / probes;
    lam_line line = geodesic_from(arena, field, base, t[k], 4 * field->size);
    back[k] = lam_line_first(&line), ahead[k] = lam_line_last(&line);
  }

  for (int first = 0; first < probes; first++) {
    double s0 = back[first], s1 = ahead[first];
    for (int last = first + 1; last <= probes; last++) {
      s0 = fmax(s0, back[last]), s1 = fmin(s1, ahead[last]);
      double area = (t[last] - t[first]) * (s1 - s0);
      if (!(area > best * (1 + 1e-9))) continue;
      best = area;
      part[0] = t[first], part[1] = t[last], part[2] = s0, part[3] = s1;
    }
  }
  return best > 0;
}

/* Whether the geodesics 0 and m, at both ends of the base line, are the same from s0 to s1. */
static bool base_closes(const lam_line *lines, int m, double s0, double s1, double size) {
  for (int k = 0; k <= 4; k++) {
    double s = s0 + (s1 - s0) * k / 4;
    if (!(lam_distance(position(&lines[0], s), position(&lines[m], s)) <= 1e-7 * size))
      return false;
  }
  return m >= 3;
}

/* Rows are points at equal distance from the base line, columns are geodesics. */
bool lam_geodesic_parallel_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                               int base, const int grid[2], double spacing, lam_mesh *mesh,
                               lam_cells *cells) {
  lam_line_field along = *field;
  along.chart = LAM_CHART_NATURAL;
  along.branch = !base; /* u = const runs along v */
  double part[4], reach = 4 * field->size;
  lam_vec2 d = base ? (lam_vec2){-1, 0} : (lam_vec2){0, 1};
  lam_line line = lam_line_trace(arena, &along, at[0], at[1], d, reach, reach, NULL);
  if (!largest_strip(arena, field, &line, part)) return false;

  int n = grid[0], m = grid[1];
  if (spacing > 0) {
    n = lam_spaced_range(spacing, n, &part[2], &part[3]);
    m = lam_spaced_range(spacing, m, &part[0], &part[1]);
  }
  if (n < 1 || m < 1) return false;

  /* Between the probes of largest_strip a geodesic may be a little shorter: the grid gives way. */
  lam_line *lines = LAM_NEW(arena, lam_line, m + 1);
  for (int j = 0; j <= m; j++) {
    lines[j] = geodesic_from(arena, field, &line, part[0] + (part[1] - part[0]) * j / m, reach);
    if (spacing == 0) part[2] = fmax(part[2], lam_line_first(&lines[j]));
    if (spacing == 0) part[3] = fmin(part[3], lam_line_last(&lines[j]));
  }
  if (!(part[3] > part[2])) return false;

  *cells = cells_on(arena, lines, m + 1, n + 1, part[2], part[3]);
  bool closed = base_closes(lines, m, part[2], part[3], field->size);
  int columns = m + !closed;
  *mesh = lam_mesh_grid(arena, n + 1, columns, false, closed);
  for (int i = 0; i <= n; i++)
    for (int j = 0; j < columns; j++)
      mesh->vertices[i * columns + j] = position(&lines[j], part[2] + (part[3] - part[2]) * i / n);
  return true;
}

/* ---- polar ---- */

/* Rows are circles around the pole, columns are spokes: geodesics that leave it evenly. Without a
 * spacing the rings divide the shortest spoke; with one, there are as many as all spokes reach. */
bool lam_geodesic_polar_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                            const int grid[2], int hole, double spacing, lam_mesh *mesh,
                            lam_cells *cells) {
  int spokes = grid[1], rings = grid[0], first = hole > 1 ? hole : 1;
  double reach = spacing > 0 ? spacing * rings : 4 * field->size;
  lam_line *lines = LAM_NEW(arena, lam_line, spokes + 1);
  lam_vec2 d[2];
  if (spokes < 3 || !lam_line_directions(field, at[0], at[1], d)) return false;

  for (int j = 0; j < spokes; j++) {
    double angle = 2 * LAM_PI * j / spokes, c = cos(angle), s = sin(angle), width[2] = {0, 1};
    lam_vec2 way = {c * d[0].x + s * d[1].x, c * d[0].y + s * d[1].y};
    lines[j] = lam_line_trace(arena, field, at[0], at[1], way, 0, reach, width);
    if (spacing == 0) reach = fmin(reach, lam_line_last(&lines[j]));
  }

  if (spacing > 0) {
    double shortest = reach;
    for (int j = 0; j < spokes; j++) shortest = fmin(shortest, lam_line_last(&lines[j]));
    rings = (int)floor(shortest / spacing + 1e-9);
    reach = rings * spacing;
  }
  if (rings <= first || !(reach > 0)) return false;

  lines[spokes] = lines[0];
  *cells = cells_on(arena, lines, spokes + 1, rings - first + 1, reach * first / rings, reach);
  *mesh = lam_mesh_grid(arena, rings - first + 1, spokes, false, true);
  for (int i = first; i <= rings; i++)
    for (int j = 0; j < spokes; j++)
      mesh->vertices[(i - first) * spokes + j] = position(&lines[j], reach * i / rings);
  return true;
}
