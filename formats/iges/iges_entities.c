/* Rational B-spline surfaces (128) and curves (126), lines (110), arcs (100) and polylines (106)
 * of an IGES file, and what trims its surfaces. Called by iges_read.c; lines and parameters come
 * from iges_file.c. */
#include "formats/iges/iges_entities.h"
#include "core/numbers.h"

#include <string.h>

enum { largest_degree = 1000, plane_curve = 5 };

/* ---- surfaces ---- */

/* K1, K2, M1, M2, five flags, knots in u and v: the head of entity 128. Counts are K + 1. A number
 * takes at least one letter of the list, which bounds what is allocated. False with a message. */
static bool read_surface_head(lam_iges_reader *r, lam_iges_parameters *list,
                              lam_spline_surface *s) {
  int most = (int)strlen(list->at), flag, *degree = s->degree, *count = s->count;
  for (int d = 0; d < 2; d++)
    if (!lam_iges_integer(r, list, 1, most, &count[d])) return false;
  for (int d = 0; d < 2; d++) {
    count[d]++;
    if (!lam_iges_integer(r, list, 1, largest_degree, &degree[d])) return false;
  }
  if ((long)count[0] * count[1] > most) return lam_iges_fail(r, "parameters are missing");

  for (int i = 0; i < 5; i++)
    if (!lam_iges_integer(r, list, 0, 1, &flag)) return false;
  for (int d = 0; d < 2; d++) {
    double *knots = LAM_NEW(r->arena, double, count[d] + degree[d] + 1);
    if (!lam_iges_numbers(r, list, knots, (size_t)(count[d] + degree[d] + 1))) return false;
    s->knots[d] = knots;
  }
  return true;
}

/* The head, then all weights, then all points, both with u running fastest; the domain at the end
 * is not needed. Weights that are all the same and positive make a polynomial surface. */
bool lam_iges_surface(lam_iges_reader *r, int at, lam_spline_surface *s) {
  lam_iges_parameters list;
  lam_iges_matrix m;
  r->entity = 128;
  r->directory_line = at;
  if (!lam_iges_matrix_of(r, at, &m) || !lam_iges_open(r, at, &list)) return false;

  int *count = s->count;
  if (!read_surface_head(r, &list, s)) return false;
  size_t total = (size_t)count[0] * (size_t)count[1];
  double *numbers = LAM_NEW(r->arena, double, 4 * total),
         *weights = LAM_NEW(r->arena, double, total);
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, total);
  if (!lam_iges_numbers(r, &list, numbers, 4 * total)) return false;

  bool rational = false;
  for (int j = 0; j < count[1]; j++)
    for (int i = 0; i < count[0]; i++) {
      size_t to = (size_t)i * (size_t)count[1] + (size_t)j,
             from = (size_t)j * (size_t)count[0] + (size_t)i;
      points[to] = lam_scale(lam_iges_moved(&m, numbers + total + 3 * from), r->unit);
      weights[to] = numbers[from];
      rational |= weights[to] != numbers[0];
    }

  s->points = points;
  s->weights = rational || !(numbers[0] > 0) ? weights : NULL;
  const char *problem = lam_spline_problem(s);
  return problem ? lam_iges_fail(r, lam_arena_printf(r->arena, "it has %s", problem)) : true;
}

/* ---- curves ---- */

/* Entity 126: K, M, four flags, knots, weights, points, the range of parameters. The curve is cut
 * to the part of its range inside its domain, when that is not empty. */
static bool read_spline(lam_iges_reader *r, lam_iges_parameters *list, const lam_iges_matrix *m,
                        lam_spline_curve *c) {
  int most = (int)strlen(list->at), flag;
  if (!lam_iges_integer(r, list, 1, most, &c->count) ||
      !lam_iges_integer(r, list, 1, largest_degree, &c->degree))
    return false;
  c->count++;
  if (c->count > most) return lam_iges_fail(r, "parameters are missing");
  for (int i = 0; i < 4; i++)
    if (!lam_iges_integer(r, list, 0, 1, &flag)) return false;

  int n = c->count, total = n + c->degree + 1;
  double *knots = LAM_NEW(r->arena, double, total),
         *numbers = LAM_NEW(r->arena, double, 4 * (size_t)n), range[2];
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, n);
  if (!lam_iges_numbers(r, list, knots, (size_t)total) ||
      !lam_iges_numbers(r, list, numbers, 4 * (size_t)n) || !lam_iges_numbers(r, list, range, 2))
    return false;

  bool rational = false;
  for (int i = 0; i < n; i++) {
    points[i] = lam_scale(lam_iges_moved(m, numbers + n + 3 * i), r->unit);
    rational |= numbers[i] != numbers[0];
  }

  c->knots = knots;
  c->points = points;
  c->weights = rational || !(numbers[0] > 0) ? numbers : NULL;
  const char *problem = lam_curve_problem(c);
  if (problem) return lam_iges_fail(r, lam_arena_printf(r->arena, "it has %s", problem));

  double low = fmax(range[0], knots[c->degree]), high = fmin(range[1], knots[n]);
  if (low < high) *c = lam_curve_part(r->arena, c, low, high);
  return true;
}

/* Entity 110: X, Y, Z of the start and of the end. */
static bool read_line(lam_iges_reader *r, lam_iges_parameters *list, const lam_iges_matrix *m,
                      lam_spline_curve *c) {
  double x[6];
  if (!lam_iges_numbers(r, list, x, 6)) return false;
  *c = lam_curve_line(r->arena, lam_scale(lam_iges_moved(m, x), r->unit),
                      lam_scale(lam_iges_moved(m, x + 3), r->unit));
  return true;
}

/* Entity 100: ZT, then X and Y of the center, the start and the end: a circle counterclockwise in
 * a plane parallel to z = 0. An end at the start makes a full turn. */
static bool read_arc(lam_iges_reader *r, lam_iges_parameters *list, const lam_iges_matrix *m,
                     lam_spline_curve *c) {
  double x[7];
  if (!lam_iges_numbers(r, list, x, 7)) return false;
  double radius = hypot(x[3] - x[1], x[4] - x[2]), from = atan2(x[4] - x[2], x[3] - x[1]),
         to = atan2(x[6] - x[2], x[5] - x[1]);

  if (!(radius > 0)) return lam_iges_fail(r, "its radius is 0");
  if (to - from <= 1e-12) to += 2 * LAM_PI;

  *c = lam_curve_arc(r->arena, lam_v3(x[1], x[2], x[0]), lam_v3(radius, 0, 0), lam_v3(0, radius, 0),
                     from, to);
  /* Rational curves may be transformed by their control points, when the map is affine. */
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, c->count);
  for (int i = 0; i < c->count; i++) {
    const double p[3] = {c->points[i].x, c->points[i].y, c->points[i].z};
    points[i] = lam_scale(lam_iges_moved(m, p), r->unit);
  }
  c->points = points;
  return true;
}

/* Entity 106: the form of the data (1: pairs of x and y at one z; 2: x, y, z; 3: the same with a
 * vector behind), the number of points, the points. A polyline when the form number of the entity
 * is 11 to 13, otherwise count stays 0. */
static bool read_polyline(lam_iges_reader *r, lam_iges_parameters *list, const lam_iges_matrix *m,
                          lam_spline_curve *c) {
  int form, n, most = (int)strlen(list->at),
               entity_form = lam_iges_field(r, r->directory_line + 1, 4);
  if (entity_form < 11 || entity_form > 13) return true;
  if (!lam_iges_integer(r, list, 1, 3, &form) || !lam_iges_integer(r, list, 2, most, &n))
    return false;

  double *knots = LAM_NEW(r->arena, double, n + 2), x[6] = {0};
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, n);
  if (form == 1 && !lam_iges_numbers(r, list, &x[2], 1)) return false;
  for (int i = 0; i < n; i++) {
    if (!lam_iges_numbers(r, list, x, form == 1 ? 2 : form == 2 ? 3 : 6)) return false;
    points[i] = lam_scale(lam_iges_moved(m, x), r->unit);
  }
  /* A straight line of degree 1: whole numbers, the first and the last one twice. */
  for (int i = 0; i < n + 2; i++) knots[i] = i == 0 ? 0 : i > n ? n - 1 : i - 1;
  *c = (lam_spline_curve){1, n, knots, points, NULL};
  return true;
}

/* The use flag of an entity: digits 5 and 6 of the status in the ninth field. */
static int use_of(const lam_iges_reader *r, int at) { return lam_iges_field(r, at, 8) / 100 % 100; }

/* Finds the reader of the entity's type; there is none for entities that are no curve. */
bool lam_iges_curve(lam_iges_reader *r, int at, lam_spline_curve *curve) {
  static const struct {
    int type;
    bool (*read)(lam_iges_reader *r, lam_iges_parameters *list, const lam_iges_matrix *m,
                 lam_spline_curve *c);
  } readers[] = {{126, read_spline}, {110, read_line}, {100, read_arc}, {106, read_polyline}};

  *curve = (lam_spline_curve){0};
  for (size_t i = 0; i < sizeof readers / sizeof *readers; i++) {
    lam_iges_parameters list;
    lam_iges_matrix m;
    if (lam_iges_field(r, at, 0) != readers[i].type || use_of(r, at) == plane_curve) continue;

    r->entity = readers[i].type;
    r->directory_line = at;
    if (!lam_iges_matrix_of(r, at, &m) || !lam_iges_open(r, at, &list) ||
        !readers[i].read(r, &list, &m, curve))
      return false;

    const char *problem = curve->count ? lam_curve_problem(curve) : NULL;
    if (problem) return lam_iges_fail(r, lam_arena_printf(r->arena, "it has %s", problem));
  }
  return true;
}

/* ---- trimming ---- */

/* The directory line (from 0) that the next parameter points to; -1: none, or none that begins an
 * entry. */
static int next_pointer(lam_iges_reader *r, lam_iges_parameters *list) {
  double number;
  if (!lam_iges_numbers(r, list, &number, 1)) return -1;
  int line = number >= 1 && number < r->directory.count ? (int)number : 0;
  return line % 2 ? line - 1 : -1;
}

enum { composite = 102, boundary = 141, on_surface = 142, deepest = 2 };

/* The curves that the entity at line `at` consists of or stands for: a composite curve (102), a
 * curve on a surface (142) or a boundary (141). in_space: those in space, otherwise those in the
 * parameters of the surface. Returns their directory lines (-1: one that is none), count of them;
 * count is 0 for a curve that is simple. What cannot be read ends the list. */
static int *constituents(lam_iges_reader *r, int at, bool in_space, int *count) {
  lam_iges_parameters list;
  int type = lam_iges_field(r, at, 0), n = 0, most = r->directory.count;
  double skipped[3];
  *count = 0;
  if ((type != composite && type != on_surface && type != boundary) || !lam_iges_open(r, at, &list))
    return NULL;
  int *lines = LAM_NEW(r->arena, int, strlen(list.at) + 1); /* a letter for each at least */

  /* 142: how it was made, the surface, the curve in its parameters, the curve in space */
  if (type == on_surface) {
    if (!lam_iges_numbers(r, &list, skipped, 1)) return lines;
    next_pointer(r, &list);
    int plane = next_pointer(r, &list), space = next_pointer(r, &list);
    lines[(*count)++] = in_space ? space : plane;
    return lines;
  }

  /* 141: type, preference, surface, n; then n curves in space, each with its sense and those in the
   * parameters. 102: n, then n curves */
  if (type == boundary && !lam_iges_numbers(r, &list, skipped, 3)) return lines;
  if (!lam_iges_integer(r, &list, 0, most, &n)) return lines;

  for (int i = 0; i < n && !list.ended; i++) {
    int own = next_pointer(r, &list), inside = 0;
    if (in_space || type == composite) lines[(*count)++] = own;

    if (type == composite) continue;
    if (!lam_iges_numbers(r, &list, skipped, 1) || !lam_iges_integer(r, &list, 0, most, &inside))
      return lines;
    for (int k = 0; k < inside && !list.ended; k++) {
      int plane = next_pointer(r, &list);
      if (!in_space) lines[(*count)++] = plane;
    }
  }
  return lines;
}

/* Whether the curve at line `at`, or one that it consists of, leaves the boundary of the clamped
 * surface. What cannot be read does not. */
static bool leaves(lam_iges_reader *r, int at, const lam_spline_surface *clamped, int depth) {
  lam_spline_curve curve;
  int count;
  if (at < 0) return false;

  if (lam_iges_curve(r, at, &curve) && curve.count)
    return !lam_curve_is_border(r->arena, &curve, clamped);

  if (depth == deepest) return false;
  const int *lines = constituents(r, at, true, &count);
  for (int i = 0; i < count; i++)
    if (leaves(r, lines[i], clamped, depth + 1)) return true;
  return false;
}

/* Marks the curve at line `at` (-1: none) and, when it is a composite one, its constituents. */
static void mark(lam_iges_reader *r, int at, bool *plane) {
  int count;
  if (at < 0 || plane[at]) return;
  plane[at] = true;
  const int *lines =
      lam_iges_field(r, at, 0) == composite ? constituents(r, at, false, &count) : NULL;
  for (int i = 0; lines && i < count; i++) plane[lines[i] < 0 ? at : lines[i]] = true;
}

/* Messages of what cannot be read go into a list of their own, which is dropped. */
void lam_iges_mark_plane_curves(lam_iges_reader *r, bool *plane) {
  lam_errors *errors = r->scan.errors, ignored = {.arena = r->arena};
  r->scan.errors = &ignored;

  for (int at = 0, count; at < r->directory.count; at += 2) {
    int type = lam_iges_field(r, at, 0);
    if (type != on_surface && type != boundary) continue;
    const int *lines = constituents(r, at, false, &count);
    for (int i = 0; i < count; i++) mark(r, lines[i], plane);
  }

  r->scan.errors = errors;
}

/* Entity 144: the surface, whether there is an outer boundary, the number of inner ones, the
 * outer, the inner ones. Entity 143: type, the surface, the number of boundaries, the
 * boundaries. */
bool lam_iges_trims(lam_iges_reader *r, int at, int *surface) {
  lam_errors *errors = r->scan.errors, ignored = {.arena = r->arena};
  lam_iges_parameters list;
  lam_spline_surface s = {0};
  bool trimmed = lam_iges_field(r, at, 0) == 144, trims = false;
  *surface = -1;
  r->scan.errors = &ignored;

  if (lam_iges_open(r, at, &list)) {
    double type;
    int outer = 1, inner = 0, count = 0;
    if (!trimmed) lam_iges_numbers(r, &list, &type, 1);
    *surface = next_pointer(r, &list);

    bool read = trimmed ? lam_iges_integer(r, &list, 0, 1, &outer) &&
                              lam_iges_integer(r, &list, 0, r->directory.count, &inner)
                        : lam_iges_integer(r, &list, 0, r->directory.count, &count);
    if (trimmed) count = 1 + inner;

    if (read && *surface >= 0 && lam_iges_field(r, *surface, 0) == 128 &&
        lam_iges_surface(r, *surface, &s)) {
      s = lam_spline_clamped(r->arena, &s);
      for (int i = 0; i < count && !trims; i++) trims = leaves(r, next_pointer(r, &list), &s, 0);
    }
  }

  r->scan.errors = errors;
  return trims;
}
