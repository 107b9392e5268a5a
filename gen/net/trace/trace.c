/* Lines as solutions of ordinary differential equations in (u, v), by arc length s,
 * with the Runge-Kutta pair 5(4) of Dormand and Prince. Called by trace_start.c,
 * trace_net.c and trace_geodesic.c.
 *
 * Fields of directions. In the orthonormal basis e1 = x_u / |x_u|, e2 = n x e1 the second form is
 * (a b; b c); with D = hypot((a - c)/2, b) and 2 phi = atan2(2b, a - c) the normal curvature
 * towards the angle t is H + D cos 2(t - phi): principal t = phi and phi + pi/2; asymptotic t =
 * phi +- acos(-H/D)/2; diagonal t = phi +- pi/4. phi is known up to pi, as a line's direction is:
 * a branch never becomes the other one. The sign is that of the step before.
 *
 * Geodesics. The tangential part of x'' vanishes: with q = x_uu u'^2 + 2 x_uv u'v' + x_vv v'^2,
 *   (E F; F G)(u'', v'') = -(<x_u, q>, <x_v, q>). */
#include "net/trace/trace.h"
#include "core/grow.h"
#include "core/numbers.h"

#include <math.h>
#include <string.h>

enum { most_points = 20000 }; /* of a half of a line */

/* ---- the right-hand side ---- */

static bool is_geodesic(const lam_line_field *field) { return field->chart >= LAM_CHART_COUNT; }

/* The surface at (u, v) in its orthonormal basis: x_u = length e1, x_v = f e1 + g e2. */
typedef struct basis {
  lam_jet jet;
  lam_curvature c;
  double length, f, g;
} basis;

/* Fills b at (u, v); false where the surface is singular. */
static bool basis_at(const lam_line_field *field, double u, double v, basis *b) {
  lam_surface_eval(field->surface, u, v, &b->jet);
  b->c = lam_jet_curvature(&b->jet);
  b->length = sqrt(b->c.E);
  b->f = b->c.F / b->length;
  b->g = sqrt(b->c.E * b->c.G - b->c.F * b->c.F) / b->length;
  return isfinite(b->c.K) && isfinite(b->g);
}

/* (du, dv) of the unit direction at the angle t from e1. */
static lam_vec2 at_angle(const basis *b, double t) {
  double dv = sin(t) / b->g;
  return (lam_vec2){(cos(t) - b->f * dv) / b->length, dv};
}

/* The vector in space of d = (du, dv). */
static lam_vec3 tangent(const lam_jet *jet, lam_vec2 d) {
  return lam_along(lam_scale(jet->u, d.x), d.y, jet->v);
}

/* The unit direction (du, dv) of a branch, by the formulas at the head of this file; false where
 * there is none: at umbilics, and for asymptotic lines where K >= 0. m is the second form's b in
 * the basis, a its a. */
static bool direction(const lam_line_field *field, const basis *b, int branch, lam_vec2 *d) {
  double a = b->c.L / b->c.E, m = (b->c.M / b->length - b->f * a) / b->g,
         D = (b->c.k1 - b->c.k2) / 2;
  double phi = atan2(2 * m, 2 * (a - b->c.H)) / 2, sign = branch ? -1 : 1,
         angle = branch ? LAM_PI / 2 : 0;

  switch (field->chart) {
  case LAM_CHART_PRINCIPAL:
  case LAM_CHART_DIAGONAL:
  case LAM_CHART_ASYMPTOTIC:
    if (!(D > 1e-9 * (fabs(b->c.H) + D))) return false;
    if (field->chart == LAM_CHART_ASYMPTOTIC && !(fabs(b->c.H) < D)) return false;
    if (field->chart == LAM_CHART_DIAGONAL) angle = sign * LAM_PI / 4;
    if (field->chart == LAM_CHART_ASYMPTOTIC) angle = sign * acos(-b->c.H / D) / 2;
    *d = at_angle(b, phi + angle);
    return true;
  case LAM_CHART_NATURAL:
    *d = branch ? (lam_vec2){0, 1 / sqrt(b->c.G)} : (lam_vec2){1 / b->length, 0};
    return true;
  default:
    *d = at_angle(b, angle);
    return true;
  }
}

bool lam_line_directions(const lam_line_field *field, double u, double v, lam_vec2 d[2]) {
  basis b;
  return basis_at(field, u, v, &b) && direction(field, &b, 0, &d[0]) &&
         direction(field, &b, 1, &d[1]);
}

/* dy/ds at y; toward: the direction of travel in space, which gives a field of directions its
 * sign. Widths of strips change on geodesics only. False where there is no direction. */
static bool slope(const lam_line_field *field, const double y[6], lam_vec3 toward, double dy[6]) {
  basis b;
  memset(dy, 0, 6 * sizeof *dy);
  if (!basis_at(field, y[0], y[1], &b)) return false;
  if (!is_geodesic(field)) {
    lam_vec2 d;
    if (!direction(field, &b, field->branch, &d)) return false;
    double sign = lam_dot(tangent(&b.jet, d), toward) < 0 ? -1 : 1;
    dy[0] = sign * d.x, dy[1] = sign * d.y;
    return true;
  }

  /* The equation of geodesics, solved for u'' and v'', and j'' = -K j. */
  lam_vec3 q = lam_scale(b.jet.uu, y[2] * y[2]);
  q = lam_along(lam_along(q, 2 * y[2] * y[3], b.jet.uv), y[3] * y[3], b.jet.vv);
  double p = -lam_dot(b.jet.u, q), r = -lam_dot(b.jet.v, q), det = b.c.E * b.c.G - b.c.F * b.c.F;
  dy[0] = y[2], dy[1] = y[3];
  dy[2] = (b.c.G * p - b.c.F * r) / det, dy[3] = (b.c.E * r - b.c.F * p) / det;
  dy[4] = y[5], dy[5] = -b.c.K * y[4];
  return true;
}

/* ---- one step ---- */

/* One step of length h from y, by Dormand and Prince: out is the solution of fifth order, error
 * its difference from the one of fourth order, in meters. False when a stage leaves the field. */
static bool step(const lam_line_field *field, const double y[6], double h, double out[6],
                 double *error) {
  static const double A[7][6] = {
      {0},
      {1. / 5},
      {3. / 40, 9. / 40},
      {44. / 45, -56. / 15, 32. / 9},
      {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
      {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  static const double low[7] = {5179. / 57600,    0,           7571. / 16695, 393. / 640,
                                -92097. / 339200, 187. / 2100, 1. / 40};

  lam_jet jet;
  lam_surface_eval(field->surface, y[0], y[1], &jet);
  lam_vec3 toward = tangent(&jet, (lam_vec2){y[2], y[3]});

  /* The last stage is the new point itself (row 6 of A are the weights of fifth order). */
  double k[7][6], difference[6];
  for (int s = 0; s < 7; s++) {
    memcpy(out, y, 6 * sizeof *out);
    for (int i = 0; i < s; i++)
      for (int c = 0; c < 6; c++) out[c] += h * A[s][i] * k[i][c];
    if (!slope(field, out, toward, k[s])) return false;
  }

  for (int c = 0; c < 6; c++) {
    difference[c] = (out[c] - y[c]) / h;
    for (int s = 0; s < 7; s++) difference[c] -= low[s] * k[s][c];
  }
  *error =
      fabs(h) * (fabs(difference[0]) * lam_length(jet.u) + fabs(difference[1]) * lam_length(jet.v));

  /* In a field of directions (du/ds, dv/ds) is not integrated, but taken from the field. */
  if (!is_geodesic(field)) out[2] = k[6][0], out[3] = k[6][1];
  return isfinite(*error);
}

/* How far y lies beyond the border in coordinate c, as a part of the rectangle's
 * side; negative inside. */
static double beyond(const lam_line_field *field, const double y[6], int c) {
  return fmax(field->low[c] - y[c], y[c] - field->high[c]) / (field->high[c] - field->low[c]);
}

/* Parts of the rectangle's side: how far beyond the border a line that runs along it may be, and
 * how near to the border a line ends that crosses it. */
static const double along_border = 1e-9, at_border = 1e-13;

/* Whether the strip of geodesics beside the line is still wide enough, s from its start: a tenth
 * of what it is in a plane (1 beside parallels, |s| around a pole). */
static bool is_wide(const lam_line_field *field, double s, const double y[6]) {
  if (!is_geodesic(field)) return true;
  return y[4] >= .1 * (field->chart == LAM_CHART_GEODESIC_POLAR ? fabs(s) : 1);
}

/* The longest part of the step of length h from `from` that stays inside the rectangle and wide
 * enough, by bisection: to becomes its end. */
static void last_step(const lam_line_field *field, const lam_line_point *from, double h,
                      lam_line_point *to) {
  double low = 0, high = 1, y[6], error;
  *to = *from;

  for (int i = 0; i < 60; i++) {
    double middle = (low + high) / 2;
    bool inside =
        step(field, from->y, middle * h, y, &error) && is_wide(field, from->s + middle * h, y);
    for (int c = 0; c < 2; c++)
      inside = inside && beyond(field, y, c) <= fmax(beyond(field, from->y, c), 0) + at_border;
    if (inside) {
      low = middle;
      to->s = from->s + middle * h;
      memcpy(to->y, y, sizeof y);
    } else
      high = middle;
  }
}

/* Whether the step from a to b passes the start of the line again; then b becomes the point nearest
 * to it. Passing means: from behind to beyond the plane square to the line at its start. */
static bool comes_back(const lam_line_field *field, const lam_line_point *start,
                       const lam_line_point *a, lam_line_point *b) {
  lam_jet zero, now;
  lam_surface_eval(field->surface, start->y[0], start->y[1], &zero);
  lam_surface_eval(field->surface, a->y[0], a->y[1], &now);

  /* Only a line that has gone three steps and is within two steps of its start may be back. */
  double h = b->s - a->s, low = 0, high = 1, error;
  if (lam_distance(now.x, zero.x) > 2 * fabs(h) || fabs(a->s - start->s) < 3 * fabs(h))
    return false;

  lam_vec3 along = lam_scale(tangent(&zero, (lam_vec2){start->y[2], start->y[3]}), h < 0 ? -1 : 1);
  if (lam_dot(lam_sub(now.x, zero.x), along) > 0) return false;
  lam_surface_eval(field->surface, b->y[0], b->y[1], &now);
  if (lam_dot(lam_sub(now.x, zero.x), along) < 0) return false;

  /* Bisection of the step for the point in that plane, which must be the start itself. */
  lam_line_point closing = *b;
  for (int i = 0; i < 50; i++) {
    double middle = (low + high) / 2;
    if (!step(field, a->y, middle * h, closing.y, &error)) return false;
    closing.s = a->s + middle * h;
    lam_surface_eval(field->surface, closing.y[0], closing.y[1], &now);
    *(lam_dot(lam_sub(now.x, zero.x), along) < 0 ? &low : &high) = middle;
  }
  if (lam_distance(now.x, zero.x) > 1e-7 * field->size) return false;
  *b = closing;
  return true;
}

/* ---- whole lines ---- */

/* A growing list of points. */
typedef struct point_list {
  lam_arena *arena;
  int count, capacity;
  lam_line_point *items;
} point_list;

/* Step control: the error of a step stays below tolerance, steps below `least` mean
 * a singularity. Meters. */
typedef struct step_limits {
  double first, least, most, tolerance;
} step_limits;

static step_limits limits_of(const lam_line_field *field) {
  return (step_limits){field->size / 100, 1e-8 * field->size, field->size / 20,
                       field->tolerance * field->size};
}

/* Appends the end of a line whose next step leaves the field, and tells why it ends: at the
 * border, or where geodesics have come together. at: the last point inside; next: that beyond. */
static lam_line_end leave(const lam_line_field *field, const lam_line_point *at, double h,
                          lam_line_point *next, bool inside, point_list *points) {
  last_step(field, at, h, next);
  if (fabs(next->s - at->s) > 1e-13 * field->size)
    LAM_APPEND(points->arena, points->items, points->count, points->capacity, *next);
  return inside ? LAM_END_FOCAL : LAM_END_BORDER;
}

/* One half of a line, from its start and up to length: appends points in the order of travel, and
 * returns why it ends. sense: 1 or -1. */
static lam_line_end trace_half(const lam_line_field *field, const lam_line_point *start,
                               double sense, double length, point_list *points) {
  const step_limits limits = limits_of(field);
  double h = limits.first, error;
  lam_line_point at = *start;
  while (points->count < most_points) {
    double left = length - fabs(at.s);
    if (left <= 1e-12 * field->size) return LAM_END_LENGTH;

    /* Too large an error, or a stage outside the field: a shorter step. */
    lam_line_point next;
    double try = fmin(h, left);
    bool done = step(field, at.y, sense * try, next.y, &error);
    if (!done || error > limits.tolerance) {
      h = try * (done ? fmax(.2, .9 * pow(limits.tolerance / error, .2)) : .25);
      if (h >= limits.least) continue;
      return LAM_END_SINGULAR;
    }

    next.s = at.s + sense * try;
    bool inside = fmax(beyond(field, next.y, 0), beyond(field, next.y, 1)) <= along_border;
    if (!inside || !is_wide(field, next.s, next.y))
      return leave(field, &at, sense * try, &next, inside, points);

    bool closed = !is_geodesic(field) && comes_back(field, start, &at, &next);
    at = next;
    LAM_APPEND(points->arena, points->items, points->count, points->capacity, at);
    if (closed) return LAM_END_CLOSED;

    h = fmin(try * fmin(4, .9 * pow(limits.tolerance / fmax(error, 1e-300), .2)), limits.most);
  }
  return LAM_END_SINGULAR;
}

/* Both halves from their common start, joined; a line that closes has one half. */
lam_line lam_line_trace(lam_arena *arena, const lam_line_field *field, double u, double v,
                        lam_vec2 d, double back, double forward, const double j[2]) {
  lam_jet jet;
  lam_surface_eval(field->surface, u, v, &jet);
  double length = lam_length(tangent(&jet, d));
  lam_line_point start = {0, {u, v, d.x / length, d.y / length, j ? j[0] : 1, j ? j[1] : 0}};

  lam_line line = {.field = field, .end = {LAM_END_LENGTH, LAM_END_LENGTH}};
  point_list half[2] = {{.arena = arena}, {.arena = arena}};
  line.end[1] = trace_half(field, &start, 1, forward, &half[1]);
  if (line.end[1] != LAM_END_CLOSED) line.end[0] = trace_half(field, &start, -1, back, &half[0]);

  int behind = half[0].count;
  line.count = behind + 1 + half[1].count;
  line.points = LAM_NEW(arena, lam_line_point, line.count);
  for (int i = 0; i < behind; i++) line.points[behind - 1 - i] = half[0].items[i];
  line.points[behind] = start;
  for (int i = 0; i < half[1].count; i++) line.points[behind + 1 + i] = half[1].items[i];
  return line;
}

double lam_line_first(const lam_line *line) { return line->points[0].s; }
double lam_line_last(const lam_line *line) { return line->points[line->count - 1].s; }

/* Bisection for the point before s, then one step from it. */
lam_line_point lam_line_at(const lam_line *line, double s) {
  int low = 0, high = line->count - 1;
  s = fmin(fmax(s, lam_line_first(line)), lam_line_last(line));
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (line->points[middle].s <= s)
      low = middle;
    else
      high = middle;
  }
  if (line->count > 1 && line->points[high].s == s) return line->points[high];

  lam_line_point from = line->points[low], to = from;
  double error;
  if (s > from.s && step(line->field, from.y, s - from.s, to.y, &error)) to.s = s;
  return to;
}

/* ---- fields ---- */

/* Diagonal of the box around 9 x 9 points of the surface over ranges of u and v; points that are
 * not finite are left out. */
static double size_over(const lam_surface *surface, double range[2][2]) {
  enum { samples = 9 };
  lam_vec3 low = lam_v3(INFINITY, INFINITY, INFINITY), high = lam_scale(low, -1);
  for (int i = 0; i < samples; i++)
    for (int j = 0; j < samples; j++) {
      double u = range[0][0] + (range[0][1] - range[0][0]) * i / (samples - 1);
      lam_vec3 x = lam_surface_point(surface, LAM_CHART_NATURAL, 0, u,
                                     range[1][0] + (range[1][1] - range[1][0]) * j / (samples - 1));
      if (!isfinite(x.x + x.y + x.z)) continue;
      low = lam_v3(fmin(low.x, x.x), fmin(low.y, x.y), fmin(low.z, x.z));
      high = lam_v3(fmax(high.x, x.x), fmax(high.y, x.y), fmax(high.z, x.z));
    }
  return lam_distance(low, high);
}

/* A range that placing gives is not closed any more, even where it is a whole period. */
lam_line_field lam_line_field_make(const lam_surface *surface, lam_chart chart,
                                   const lam_placement_keys *placing, const double at[2]) {
  lam_line_field field = {.surface = surface, .chart = chart, .tolerance = 1e-11};
  double range[2][2];
  bool closed[2] = {false, false};
  surface->kind->domain(surface->data, LAM_CHART_NATURAL, range[0], range[1], closed);
  if (placing->u_given) memcpy(range[0], placing->u, sizeof range[0]), closed[0] = false;
  if (placing->v_given) memcpy(range[1], placing->v, sizeof range[1]), closed[1] = false;

  for (int c = 0; c < 2; c++) {
    double period = range[c][1] - range[c][0],
           shift = closed[c] && at ? at[c] - period / 2 - range[c][0] : 0;
    field.low[c] = range[c][0] + shift;
    field.high[c] = range[c][1] + shift;
  }
  field.size = size_over(surface, range);
  return field;
}
