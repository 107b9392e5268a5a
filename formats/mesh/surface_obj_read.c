/* Free-form curves and surfaces out of Wavefront OBJ (specification 3.0): B-splines and Bezier
 * curves, rational or not. An element begins with `surf` or `curv` and its control points, goes
 * on with `parm` (knots, or for Bezier pieces the parameters at which they meet), and closes with
 * `end`. Called through the row in obj.c. */
#include "core/grow.h"
#include "formats/mesh/obj.h"
#include "formats/scan.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { largest_degree = 1000 };

typedef struct numbers {
  int count, capacity;
  double *items;
} numbers;

typedef enum element_kind { NO_ELEMENT, SURFACE, CURVE } element_kind;

/* What was read so far; surfaces or curves is NULL, and elements of that kind are read but not
 * kept. */
typedef struct reader {
  lam_arena *arena;
  lam_scan scan;
  numbers vertices;      /* four numbers each */
  bool rational, bezier; /* what the last cstype said */
  int degree[2];         /* in u and v; 0: no deg yet */
  const char *group;     /* name of the last one; NULL */
  element_kind element;
  int line; /* where the element begins */
  bool trimmed;
  numbers range, points, knots[2]; /* of the element; points: vertices from 0 */
  numbers short_list;              /* of the statement being read */
  lam_spline_list *surfaces;
  lam_curve_list *curves;
} reader;

static bool fail(reader *r, const char *text) {
  lam_error_add(r->scan.errors, r->scan.location, NULL, "%s", text);
  return false;
}

static void append(lam_arena *arena, numbers *list, double number) {
  LAM_APPEND(arena, list->items, list->count, list->capacity, number);
}

/* The next word of a statement; false at its end. */
static bool next(reader *r, lam_word *word) { return lam_scan_word(&r->scan, word); }

/* Reads up to `most` numbers of a statement into the list, which they replace. False with a
 * message. */
static bool read_numbers(reader *r, const char *what, numbers *list, int most) {
  lam_word word;
  double number;
  list->count = 0;
  while (list->count < most && next(r, &word)) {
    if (!lam_scan_number(&r->scan, word, what, &number)) return false;
    append(r->arena, list, number);
  }
  return true;
}

/* ---- statements ---- */

/* v x y z w: w is 1 when it is left out. */
static bool read_vertex(reader *r) {
  const numbers *xyzw = &r->short_list;
  if (!read_numbers(r, "v", &r->short_list, 4)) return false;
  if (xyzw->count < 3) return fail(r, "v: fewer than three numbers given");
  for (int i = 0; i < 4; i++) append(r->arena, &r->vertices, i < xyzw->count ? xyzw->items[i] : 1);
  return true;
}

/* cstype, rat or not: bezier or bspline; others are refused. */
static bool read_type(reader *r) {
  lam_word word;
  r->rational = false;
  bool any = next(r, &word);
  if (any && lam_word_is(word, "rat")) {
    r->rational = true;
    any = next(r, &word);
  }

  r->bezier = any && lam_word_is(word, "bezier");
  return (any && (r->bezier || lam_word_is(word, "bspline"))) ||
         fail(r, "cstype: expected bspline or bezier");
}

/* deg: one number stands for both directions. */
static bool read_degree(reader *r) {
  const numbers *given = &r->short_list;
  if (!read_numbers(r, "deg", &r->short_list, 2)) return false;
  for (int d = 0; d < 2; d++) {
    double degree = given->count > d ? given->items[d] : given->count ? given->items[0] : 0;
    if (!(degree >= 1 && degree <= largest_degree && degree == (int)degree))
      return fail(r, "deg: expected whole numbers from 1 on");
    r->degree[d] = (int)degree;
  }
  return true;
}

/* The control points of an element: vertices v, v/vt or v/vt/vn; negative ones count back from
 * the last. Only those that stand above are known. */
static bool read_points(reader *r) {
  lam_word word;
  int known = r->vertices.count / 4;
  r->points.count = 0;
  while (next(r, &word)) {
    char text[16] = {0}, *end;
    memcpy(text, word.text, (size_t)(word.length < 15 ? word.length : 15));
    long given = strtol(text, &end, 10), at = given < 0 ? known + given : given - 1;

    if (end == text || (*end && *end != '/') || at < 0 || at >= known) {
      lam_error_add(r->scan.errors, r->scan.location, NULL,
                    "\"%.*s\" given, the number of one of the %d vertices expected",
                    lam_word_shown(word), word.text, known);
      return false;
    }
    append(r->arena, &r->points, (double)at);
  }
  return true;
}

/* An element from its statement: the domain in each direction, then the control points. */
static bool begin(reader *r, element_kind element) {
  r->element = element;
  r->line = r->scan.location.line;
  r->trimmed = false;
  r->knots[0].count = r->knots[1].count = 0;

  int count = element == SURFACE ? 4 : 2;
  if (!r->degree[0]) return fail(r, "no deg before the element");
  if (!read_numbers(r, "range", &r->range, count) || !read_points(r)) return false;
  return r->range.count == count || fail(r, "range: numbers are missing");
}

static bool begin_surface(reader *r) { return begin(r, SURFACE); }
static bool begin_curve(reader *r) { return begin(r, CURVE); }

/* parm u or parm v: replaces what was given before for that direction. */
static bool read_parameters(reader *r) {
  lam_word word;
  if (!next(r, &word)) return fail(r, "parm: expected u or v");
  bool v = lam_word_is(word, "v");
  if (!v && !lam_word_is(word, "u")) return fail(r, "parm: expected u or v");
  return read_numbers(r, "parm", &r->knots[v], INT_MAX);
}

static bool note_trim(reader *r) {
  r->trimmed = true;
  return true;
}

static bool read_group(reader *r) {
  lam_word word;
  r->group = next(r, &word) ? lam_arena_printf(r->arena, "%.*s", word.length, word.text) : NULL;
  return true;
}

/* ---- elements ---- */

/* The knots of direction d and the number of points that they ask for; NULL: too few parameters.
 * Bezier pieces that meet at parameters t0 < t1 < ... have these as knots, each as often as the
 * degree, the first and the last once more. */
static const double *make_knots(reader *r, int d, int *count) {
  const numbers *given = &r->knots[d];
  int degree = r->degree[d];
  if (given->count < 2) return NULL;

  if (!r->bezier) {
    *count = given->count - degree - 1;
    double *copy = LAM_NEW(r->arena, double, given->count);
    memcpy(copy, given->items, (size_t)given->count * sizeof *copy);
    return *count > degree ? copy : NULL;
  }

  if ((long)(given->count - 1) * degree > r->points.count) return NULL;
  *count = (given->count - 1) * degree + 1;
  double *knots = LAM_NEW(r->arena, double, *count + degree + 1);
  for (int i = 0; i < *count + degree + 1; i++) {
    int piece = i == 0 ? 0 : (i - 1) / degree;
    knots[i] = given->items[piece < given->count ? piece : given->count - 1];
  }
  return knots;
}

/* The control points of the element as it lists them, and their weights (NULL when it is not
 * rational). Both are new. */
static lam_vec3 *copy_points(reader *r, const double **weights) {
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, r->points.count);
  double *w = LAM_NEW(r->arena, double, r->points.count);
  for (int i = 0; i < r->points.count; i++) {
    const double *v = r->vertices.items + 4 * (int)r->points.items[i];
    points[i] = lam_v3(v[0], v[1], v[2]);
    w[i] = v[3];
  }
  *weights = r->rational ? w : NULL;
  return points;
}

/* True when there is no problem; otherwise a message with the line where the element begins. */
static bool is_sound(reader *r, const char *problem) {
  r->scan.location.line = problem ? r->line : r->scan.location.line;
  return !problem || fail(r, lam_arena_printf(r->arena, "the element has %s", problem));
}

/* Ends a surface: control points, listed with u running fastest, are turned around, so that v
 * does. A domain inside that of the knots trims it. */
static bool end_surface(reader *r) {
  lam_spline_surface s = {.degree = {r->degree[0], r->degree[1]}};
  for (int d = 0; d < 2; d++)
    if (!(s.knots[d] = make_knots(r, d, &s.count[d])))
      return is_sound(r, "too few parameters (parm) for its degree");

  if ((long)s.count[0] * s.count[1] != r->points.count)
    return is_sound(
        r,
        lam_arena_printf(r->arena, "%d points; expected %ld, as its parameters and degree ask for",
                         r->points.count, (long)s.count[0] * s.count[1]));

  const double *w, *range = r->range.items;
  const lam_vec3 *x = copy_points(r, &w);
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, r->points.count);
  double *weights = LAM_NEW(r->arena, double, r->points.count);
  for (int k = 0; k < r->points.count; k++) {
    int at = k % s.count[0] * s.count[1] + k / s.count[0];
    points[at] = x[k];
    weights[at] = w ? w[k] : 1;
  }

  s.points = points;
  s.weights = w ? weights : NULL;
  if (!is_sound(r, lam_spline_problem(&s))) return false;

  bool trimmed = r->trimmed;
  for (int d = 0; d < 2; d++)
    trimmed |= range[2 * d] > s.knots[d][s.degree[d]] || range[2 * d + 1] < s.knots[d][s.count[d]];
  if (r->surfaces) lam_spline_append(r->arena, r->surfaces, &s, lam_spline_note(trimmed, false));
  return true;
}

/* Ends a curve, which is cut to the part of its domain inside that of the knots, and named by its
 * group. */
static bool end_curve(reader *r) {
  lam_spline_curve c = {.degree = r->degree[0]};
  if (!(c.knots = make_knots(r, 0, &c.count)))
    return is_sound(r, "too few parameters (parm) for its degree");

  if (c.count != r->points.count)
    return is_sound(r, lam_arena_printf(
                           r->arena, "%d points; expected %d, as its parameters and degree ask for",
                           r->points.count, c.count));

  c.points = copy_points(r, &c.weights);
  if (!is_sound(r, lam_curve_problem(&c))) return false;

  double low = fmax(r->range.items[0], c.knots[c.degree]),
         high = fmin(r->range.items[1], c.knots[c.count]);
  if (low < high) c = lam_curve_part(r->arena, &c, low, high);
  const char *name = r->group ? r->group : lam_arena_printf(r->arena, "line %d", r->line);
  if (r->curves) lam_curve_append(r->arena, r->curves, name, -1, c);
  return true;
}

/* end: whatever was begun is complete. */
static bool end_element(reader *r) {
  element_kind element = r->element;
  r->element = NO_ELEMENT;
  return element == SURFACE ? end_surface(r) : element == CURVE ? end_curve(r) : true;
}

/* ---- the file ---- */

/* Statements by name. Other ones (faces, normals, materials) are passed over. */
static const struct {
  const char *name;
  bool (*read)(reader *r);
} statements[] = {{"v", read_vertex},      {"cstype", read_type}, {"deg", read_degree},
                  {"surf", begin_surface}, {"curv", begin_curve}, {"parm", read_parameters},
                  {"trim", note_trim},     {"hole", note_trim},   {"end", end_element},
                  {"g", read_group},       {"o", read_group}};

/* Reads the whole file; stops at the first message, and then returns false. */
static bool read_all(reader *r) {
  do {
    lam_word word;
    if (!next(r, &word)) continue;
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
      if (lam_word_is(word, statements[i].name) && !statements[i].read(r)) return false;
  } while (lam_scan_line(&r->scan));

  if (r->element == NO_ELEMENT) return true;
  r->scan.location.line = r->line;
  return fail(r, "this element is cut off: end expected");
}

/* Curves are read, too, and may be wrong, but are not kept. */
bool lam_obj_read_surfaces(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                           lam_errors *errors, lam_spline_list *surfaces) {
  reader r = {.arena = arena,
              .scan = lam_obj_scan(arena, bytes, count, location, errors),
              .surfaces = surfaces};
  *surfaces = (lam_spline_list){0};
  if (!read_all(&r)) return false;
  r.scan.location.line = 0;
  return surfaces->count > 0 || fail(&r, "has no free-form surface (surf); expected at least one");
}

/* The same with surfaces. */
bool lam_obj_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                         lam_errors *errors, lam_curve_list *curves) {
  reader r = {.arena = arena,
              .scan = lam_obj_scan(arena, bytes, count, location, errors),
              .curves = curves};
  *curves = (lam_curve_list){0};
  if (!read_all(&r)) return false;
  r.scan.location.line = 0;
  return curves->count > 0 || fail(&r, "has no free-form curve (curv); expected at least one");
}
