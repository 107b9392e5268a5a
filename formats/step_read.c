/* B-spline surfaces out of the entities of a STEP file (ISO 10303-42, 4.4.36 and on). */
#include "formats/step.h"
#include "formats/step_tree.h"

#include <string.h>

enum { largest_degree = 1000, deepest_unit = 8 };

typedef struct reader {
  lam_arena *arena;
  lam_scan scan;
  lam_step_tree tree;
  double unit; /* of lengths, in meters */
  const lam_step_entity *surface;
} reader;

static bool fail(reader *r, const char *what) {
  r->scan.place.line = r->surface->line;
  lam_error_add(r->scan.errors, r->scan.place, NULL, "surface #%ld: %s", r->surface->number, what);
  return false;
}

static bool is_enough(const lam_step_value *value, int count) { return value && value->count >= count; }

/* ---- units ---- */

/* The size of a unit of length in meters; 0: it is none that is known. */
static double unit_size(const reader *r, const lam_step_entity *entity, int depth) {
  static const struct {
    const char *prefix;
    double size;
  } prefixes[] = {{".NANO.", 1e-9}, {".MICRO.", 1e-6}, {".MILLI.", 1e-3}, {".CENTI.", 1e-2},
                  {".DECI.", 1e-1}, {".DECA.", 1e1},   {".HECTO.", 1e2},  {".KILO.", 1e3}};
  const lam_step_value *si = lam_step_record(entity, "SI_UNIT"), *prefix = lam_step_item(si, 0);
  if (si && prefix) {
    const lam_step_value *name = lam_step_item(si, is_enough(si, 3) ? 2 : 1);
    if (!name || !lam_word_is(name->word, ".METRE.")) return 0;
    if (prefix->type == LAM_STEP_NOTHING) return 1;
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++)
      if (lam_word_is(prefix->word, prefixes[i].prefix)) return prefixes[i].size;
    return 0;
  }
  const lam_step_value *conversion = lam_step_record(entity, "CONVERSION_BASED_UNIT");
  const lam_step_value *measure = lam_step_typed(conversion, 1, LAM_STEP_REFERENCE);
  if (!measure || depth == deepest_unit) return 0;
  const lam_step_entity *with = lam_step_find(&r->tree, measure->entity);
  const lam_step_value *factor = lam_step_record(with, "LENGTH_MEASURE_WITH_UNIT");
  if (!factor) factor = lam_step_record(with, "MEASURE_WITH_UNIT");
  const lam_step_value *number = lam_step_typed(lam_step_item(factor, 0), 0, LAM_STEP_NUMBER);
  const lam_step_value *base = lam_step_typed(factor, 1, LAM_STEP_REFERENCE);
  if (!number || !base) return 0;
  return number->number * unit_size(r, lam_step_find(&r->tree, base->entity), depth + 1);
}

static bool add_unit(reader *r, const lam_step_entity *entity) {
  if (!lam_step_record(entity, "LENGTH_UNIT")) return true;
  double size = unit_size(r, entity, 0);
  r->scan.place.line = entity->line;
  if (!(size > 0 && isfinite(size))) {
    lam_error_add(r->scan.errors, r->scan.place, NULL, "unit #%ld is no known unit of length", entity->number);
    return false;
  }
  if (r->unit > 0 && r->unit != size) {
    lam_error_add(r->scan.errors, r->scan.place, NULL, "two units of length, %g m and %g m; one expected", r->unit,
                  size);
    return false;
  }
  r->unit = size;
  return true;
}

/* The unit of length of the geometry: what the contexts assign. */
static bool find_unit(reader *r) {
  for (int i = 0; i < r->tree.count; i++) {
    const lam_step_value *assigned = lam_step_record(&r->tree.entities[i], "GLOBAL_UNIT_ASSIGNED_CONTEXT");
    const lam_step_value *units = lam_step_item(assigned, 0);
    for (const lam_step_value *unit = units ? units->first : NULL; unit; unit = unit->next) {
      const lam_step_entity *entity = lam_step_find(&r->tree, unit->entity);
      if (entity && !add_unit(r, entity)) return false;
    }
  }
  if (r->unit > 0) return true;
  r->scan.place.line = 0;
  lam_error_add(r->scan.errors, r->scan.place, NULL, "names no unit of length");
  return false;
}

/* ---- surfaces ---- */

static bool read_degree(const lam_step_value *list, int i, int *degree) {
  const lam_step_value *value = lam_step_typed(list, i, LAM_STEP_NUMBER);
  if (!value || !(value->number >= 1 && value->number <= largest_degree)) return false;
  *degree = (int)value->number;
  return *degree == value->number;
}

/* A list of rows that have the same number of items each. */
static bool is_table(const lam_step_value *table, int count[2]) {
  if (!table || table->type != LAM_STEP_LIST || !table->first) return false;
  count[0] = table->count;
  count[1] = table->first->count;
  for (const lam_step_value *row = table->first; row; row = row->next)
    if (row->type != LAM_STEP_LIST || row->count != count[1]) return false;
  return count[1] > 0;
}

static bool read_point(reader *r, const lam_step_value *reference, lam_vec3 *point) {
  const lam_step_entity *entity =
      reference->type == LAM_STEP_REFERENCE ? lam_step_find(&r->tree, reference->entity) : NULL;
  const lam_step_value *record = lam_step_record(entity, "CARTESIAN_POINT");
  const lam_step_value *list = lam_step_typed(record, record && record->count > 1 ? 1 : 0, LAM_STEP_LIST);
  double xyz[3];
  for (int c = 0; c < 3; c++) {
    const lam_step_value *number = lam_step_typed(list, c, LAM_STEP_NUMBER);
    if (!number) return fail(r, "a control point is not a CARTESIAN_POINT of three numbers");
    xyz[c] = number->number * r->unit;
  }
  *point = lam_v3(xyz[0], xyz[1], xyz[2]);
  return true;
}

static bool read_points(reader *r, const lam_step_value *table, lam_spline_surface *s) {
  if (!is_table(table, s->count)) return fail(r, "its control points are not rows of equal length");
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, (size_t)s->count[0] * (size_t)s->count[1]), *at = points;
  for (const lam_step_value *row = table->first; row; row = row->next)
    for (const lam_step_value *item = row->first; item; item = item->next)
      if (!read_point(r, item, at++)) return false;
  s->points = points;
  return true;
}

static bool read_weights(reader *r, const lam_step_value *table, lam_spline_surface *s) {
  int count[2];
  if (!is_table(table, count) || count[0] != s->count[0] || count[1] != s->count[1])
    return fail(r, "expected as many weights as control points");
  double *weights = LAM_NEW(r->arena, double, (size_t)count[0] * (size_t)count[1]), *at = weights;
  for (const lam_step_value *row = table->first; row; row = row->next)
    for (const lam_step_value *item = row->first; item; item = item->next) {
      if (item->type != LAM_STEP_NUMBER) return fail(r, "a weight is not a number");
      *at++ = item->number;
    }
  s->weights = weights;
  return true;
}

/* Knots are listed once, with how often they stand. */
static bool read_knots(reader *r, const lam_step_value *times, const lam_step_value *values, int d,
                       lam_spline_surface *s) {
  int total = s->count[d] + s->degree[d] + 1, filled = 0;
  if (!times || !values || times->count != values->count) return fail(r, "expected as many knots as multiplicities");
  double *knots = LAM_NEW(r->arena, double, total);
  const lam_step_value *value = values->first;
  for (const lam_step_value *t = times->first; t; t = t->next, value = value->next) {
    if (t->type != LAM_STEP_NUMBER || value->type != LAM_STEP_NUMBER) return fail(r, "a knot is not a number");
    if (!(t->number >= 1 && t->number <= total - filled)) return fail(r, "its multiplicities do not fit its points");
    for (int k = (int)t->number; k > 0; k--) knots[filled++] = value->number;
  }
  if (filled < total) return fail(r, "its multiplicities do not fit its points");
  s->knots[d] = knots;
  return true;
}

/* Surfaces whose knots follow from their degree and number of points. */
typedef enum knot_form { KNOTS_BEZIER, KNOTS_QUASI_UNIFORM, KNOTS_UNIFORM, KNOTS_GIVEN } knot_form;
static const char *const knot_forms[] = {"BEZIER_SURFACE", "QUASI_UNIFORM_SURFACE", "UNIFORM_SURFACE",
                                         "B_SPLINE_SURFACE_WITH_KNOTS"};
enum { knot_form_count = 4 };

/* Knot i: whole numbers; on a Bezier surface each as often as the degree, and at the ends of a quasi-uniform one too,
 * and once more at both ends. */
static double knot_of(knot_form form, int degree, int count, int i) {
  int inside = i - degree, last = form == KNOTS_BEZIER ? (count - 1) / degree : count - degree;
  if (form == KNOTS_UNIFORM) return inside;
  if (form == KNOTS_BEZIER) inside = i == 0 ? 0 : (i - 1) / degree;
  return inside < 0 ? 0 : inside > last ? last : inside;
}

static bool make_knots(reader *r, knot_form form, int d, lam_spline_surface *s) {
  int degree = s->degree[d], count = s->count[d];
  if (count <= degree || (form == KNOTS_BEZIER && (count - 1) % degree != 0))
    return fail(r, "its number of points does not fit its degree");
  double *knots = LAM_NEW(r->arena, double, count + degree + 1);
  for (int i = 0; i < count + degree + 1; i++) knots[i] = knot_of(form, degree, count, i);
  s->knots[d] = knots;
  return true;
}

/* The part of a surface without knots begins at item `shape` of its record, the knots at item `first` of theirs: a
 * simple instance has a name before, and both in one record. */
static bool read_surface(reader *r, const lam_step_value *with_knots, knot_form form, lam_spline_surface *s) {
  const lam_step_value *spline = lam_step_record(r->surface, "B_SPLINE_SURFACE");
  const lam_step_value *rational = lam_step_record(r->surface, "RATIONAL_B_SPLINE_SURFACE");
  int shape = spline ? 0 : 1, first = spline ? 0 : 8;
  if (!spline) spline = with_knots;
  if (!is_enough(spline, shape + 7) || (form == KNOTS_GIVEN && !is_enough(with_knots, first + 5)))
    return fail(r, "values are missing");
  for (int d = 0; d < 2; d++)
    if (!read_degree(spline, shape + d, &s->degree[d])) return fail(r, "its degree is not a whole number from 1 on");
  if (!read_points(r, lam_step_item(spline, shape + 2), s)) return false;
  for (int d = 0; d < 2; d++)
    if (form == KNOTS_GIVEN ? !read_knots(r, lam_step_typed(with_knots, first + d, LAM_STEP_LIST),
                                          lam_step_typed(with_knots, first + 2 + d, LAM_STEP_LIST), d, s)
                            : !make_knots(r, form, d, s))
      return false;
  if (rational && !read_weights(r, lam_step_item(rational, 0), s)) return false;
  const char *problem = lam_spline_problem(s);
  return problem ? fail(r, lam_arena_printf(r->arena, "it has %s", problem)) : true;
}

/* What the file has instead. */
static void complain_of_none(reader *r) {
  static const char *const others[] = {"PLANE",
                                       "CYLINDRICAL_SURFACE",
                                       "CONICAL_SURFACE",
                                       "SPHERICAL_SURFACE",
                                       "TOROIDAL_SURFACE",
                                       "SURFACE_OF_REVOLUTION",
                                       "SURFACE_OF_LINEAR_EXTRUSION",
                                       "OFFSET_SURFACE"};
  r->scan.place.line = 0;
  for (int i = 0; i < r->tree.count; i++)
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
      if (lam_step_record(&r->tree.entities[i], others[k])) {
        lam_error_add(r->scan.errors, r->scan.place, NULL,
                      "has no B-spline surface, but %s; expected surfaces saved as NURBS", others[k]);
        return;
      }
  lam_error_add(r->scan.errors, r->scan.place, NULL, "has no surface; expected at least one B-spline surface");
}

/* Reads the entity when it is a surface; false only with a message. */
static bool read_entity(reader *r, const lam_step_entity *entity, lam_spline_list *surfaces) {
  for (int form = 0; form < knot_form_count; form++) {
    const lam_step_value *record = lam_step_record(entity, knot_forms[form]);
    lam_spline_surface s = {0};
    if (!record) continue;
    if (r->unit == 0 && !find_unit(r)) return false;
    r->surface = entity;
    if (!read_surface(r, record, (knot_form)form, &s)) return false;
    lam_spline_append(r->arena, surfaces, &s);
    return true;
  }
  return true;
}

bool lam_step_read(lam_arena *arena, const char *bytes, size_t count, lam_place place, lam_errors *errors,
                   lam_spline_list *surfaces) {
  reader r = {.arena = arena, .scan = lam_scan_begin(arena, bytes, count, place, errors)};
  *surfaces = (lam_spline_list){0};
  if (!lam_step_tree_read(arena, &r.scan, &r.tree)) return false;
  for (int i = 0; i < r.tree.count; i++)
    if (!read_entity(&r, &r.tree.entities[i], surfaces)) return false;
  if (!surfaces->count) complain_of_none(&r);
  return surfaces->count > 0;
}
