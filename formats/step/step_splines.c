/* B-spline curves and surfaces out of the entities of a STEP file (ISO 10303-42, 4.4.36 and on),
 * and what all files of the reader need: messages, references, points. Called by step_curves.c
 * and step_read.c. */
#include "formats/step/step_reader.h"

#include <string.h>

enum { largest_degree = 1000 };

/* The line is that of the entity, not of the value. */
bool lam_step_fail(lam_step_reader *r, const char *text) {
  r->scan.location.line = r->entity->line;
  lam_error_add(r->scan.errors, r->scan.location, NULL, "%s #%ld: %s", r->what, r->entity->number,
                text);
  return false;
}

bool lam_step_has_items(const lam_step_value *value, int count) {
  return value && value->count >= count;
}

const lam_step_entity *lam_step_referred(const lam_step_reader *r, const lam_step_value *record,
                                         int i) {
  const lam_step_value *reference = lam_step_typed(record, i, LAM_STEP_REFERENCE);
  return reference ? lam_step_find(&r->tree, reference->entity) : NULL;
}

/* ---- points ---- */

/* The list stands behind a name, which some programs leave out. */
int lam_step_coordinates(const lam_step_entity *entity, const char *keyword, double xyz[3]) {
  const lam_step_value *record = lam_step_record(entity, keyword);
  const lam_step_value *list =
      lam_step_typed(record, record && record->count > 1 ? 1 : 0, LAM_STEP_LIST);

  int count = 0;
  for (; count < 3; count++) {
    const lam_step_value *number = lam_step_typed(list, count, LAM_STEP_NUMBER);
    if (!number) break;
    xyz[count] = number->number;
  }
  return count;
}

/* Curves of two coordinates belong to the parameters of surfaces, and are refused here. */
bool lam_step_cartesian(lam_step_reader *r, const lam_step_entity *entity, lam_vec3 *point) {
  double xyz[3];
  if (lam_step_coordinates(entity, "CARTESIAN_POINT", xyz) < 3)
    return lam_step_fail(r, "a control point is not a CARTESIAN_POINT of three numbers");
  *point = lam_v3(xyz[0] * r->unit, xyz[1] * r->unit, xyz[2] * r->unit);
  return true;
}

/* Reads a list of references into points, which have room for it. False with a message. */
static bool read_points(lam_step_reader *r, const lam_step_value *list, lam_vec3 *points) {
  for (const lam_step_value *item = list->first; item; item = item->next) {
    const lam_step_entity *entity =
        item->type == LAM_STEP_REFERENCE ? lam_step_find(&r->tree, item->entity) : NULL;
    if (!lam_step_cartesian(r, entity, points++)) return false;
  }
  return true;
}

/* Reads a list of numbers into weights, which have room for it. False with a message. */
static bool read_weights(lam_step_reader *r, const lam_step_value *list, double *weights) {
  for (const lam_step_value *item = list->first; item; item = item->next) {
    if (item->type != LAM_STEP_NUMBER) return lam_step_fail(r, "a weight is not a number");
    *weights++ = item->number;
  }
  return true;
}

/* Whether this is a list of rows that have the same number of items each; count: rows, items in
 * each. */
static bool is_table(const lam_step_value *table, int count[2]) {
  if (!table || table->type != LAM_STEP_LIST || !table->first) return false;
  count[0] = table->count;
  count[1] = table->first->count;
  for (const lam_step_value *row = table->first; row; row = row->next)
    if (row->type != LAM_STEP_LIST || row->count != count[1]) return false;
  return count[1] > 0;
}

/* ---- degrees and knots ---- */

/* Item i as a degree. False with a message. */
static bool read_degree(lam_step_reader *r, const lam_step_value *list, int i, int *degree) {
  const lam_step_value *value = lam_step_typed(list, i, LAM_STEP_NUMBER);
  *degree = value && value->number >= 1 && value->number <= largest_degree ? (int)value->number : 0;
  return (*degree && *degree == value->number) ||
         lam_step_fail(r, "its degree is not a whole number from 1 on");
}

/* Knots are listed once, with how often they stand; together they are count + degree + 1. NULL
 * with a message. */
static const double *read_knots(lam_step_reader *r, const lam_step_value *times,
                                const lam_step_value *values, int degree, int count) {
  int total = count + degree + 1, filled = 0;
  const char *wrong = "its multiplicities do not fit its points";
  if (!times || !values || times->count != values->count)
    return lam_step_fail(r, "expected as many knots as multiplicities"), NULL;

  double *knots = LAM_NEW(r->arena, double, total);
  const lam_step_value *value = values->first;
  for (const lam_step_value *t = times->first; t; t = t->next, value = value->next) {
    if (t->type != LAM_STEP_NUMBER || value->type != LAM_STEP_NUMBER)
      return lam_step_fail(r, "a knot is not a number"), NULL;
    if (!(t->number >= 1 && t->number <= total - filled)) return lam_step_fail(r, wrong), NULL;
    for (int k = (int)t->number; k > 0; k--) knots[filled++] = value->number;
  }
  return filled < total ? (lam_step_fail(r, wrong), NULL) : knots;
}

/* How the knots of a spline are given: by its degree and number of points, or one by one. In the
 * order of the keywords of lam_step_spline_surface_record. */
typedef enum knot_form {
  KNOTS_BEZIER,
  KNOTS_QUASI_UNIFORM,
  KNOTS_UNIFORM,
  KNOTS_GIVEN,
  KNOTS_FORM_COUNT
} knot_form;

/* Knot i when knots follow from the degree: whole numbers. Uniform: one each. Quasi-uniform: the
 * first and the last one degree + 1 times. Bezier: each as often as the degree, the first and the
 * last once more. */
static double knot_of(knot_form form, int degree, int count, int i) {
  int inside = i - degree, last = form == KNOTS_BEZIER ? (count - 1) / degree : count - degree;
  if (form == KNOTS_UNIFORM) return inside;
  if (form == KNOTS_BEZIER) inside = i == 0 ? 0 : (i - 1) / degree;
  return inside < 0 ? 0 : inside > last ? last : inside;
}

/* All knots by knot_of. NULL with a message when the number of points does not fit. */
static const double *make_knots(lam_step_reader *r, knot_form form, int degree, int count) {
  if (count <= degree || (form == KNOTS_BEZIER && (count - 1) % degree != 0))
    return lam_step_fail(r, "its number of points does not fit its degree"), NULL;
  double *knots = LAM_NEW(r->arena, double, count + degree + 1);
  for (int i = 0; i < count + degree + 1; i++) knots[i] = knot_of(form, degree, count, i);
  return knots;
}

/* The record whose keyword is one of names, and which of them (form); NULL: none. */
static const lam_step_value *find_record(const lam_step_entity *entity, const char *const *names,
                                         int *form) {
  for (*form = 0; *form < KNOTS_FORM_COUNT; ++*form) {
    const lam_step_value *record = lam_step_record(entity, names[*form]);
    if (record) return record;
  }
  return NULL;
}

/* ---- surfaces ---- */

const lam_step_value *lam_step_spline_surface_record(const lam_step_entity *entity, int *form) {
  static const char *const names[] = {"BEZIER_SURFACE", "QUASI_UNIFORM_SURFACE", "UNIFORM_SURFACE",
                                      "B_SPLINE_SURFACE_WITH_KNOTS"};
  return find_record(entity, names, form);
}

/* The control points, rows of u with v running fastest. False with a message. */
static bool read_table(lam_step_reader *r, const lam_step_value *table, lam_spline_surface *s) {
  if (!is_table(table, s->count))
    return lam_step_fail(r, "its control points are not rows of equal length");
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, (size_t)s->count[0] * (size_t)s->count[1]),
           *at = points;
  for (const lam_step_value *row = table->first; row; row = row->next, at += s->count[1])
    if (!read_points(r, row, at)) return false;
  s->points = points;
  return true;
}

/* The weights, in the order of the control points. False with a message. */
static bool read_weight_table(lam_step_reader *r, const lam_step_value *table,
                              lam_spline_surface *s) {
  int count[2];
  if (!is_table(table, count) || count[0] != s->count[0] || count[1] != s->count[1])
    return lam_step_fail(r, "expected as many weights as control points");
  double *weights = LAM_NEW(r->arena, double, (size_t)count[0] * (size_t)count[1]), *at = weights;
  for (const lam_step_value *row = table->first; row; row = row->next, at += count[1])
    if (!read_weights(r, row, at)) return false;
  s->weights = weights;
  return true;
}

/* The knots of both directions, from item `first` of their record. False with a message. */
static bool read_surface_knots(lam_step_reader *r, const lam_step_value *with_knots, int first,
                               int form, lam_spline_surface *s) {
  for (int d = 0; d < 2; d++) {
    s->knots[d] = form == KNOTS_GIVEN
                      ? read_knots(r, lam_step_typed(with_knots, first + d, LAM_STEP_LIST),
                                   lam_step_typed(with_knots, first + 2 + d, LAM_STEP_LIST),
                                   s->degree[d], s->count[d])
                      : make_knots(r, (knot_form)form, s->degree[d], s->count[d]);
    if (!s->knots[d]) return false;
  }
  return true;
}

/* The part of a surface without knots begins at item `shape` of its record, the knots at item
 * `first` of theirs: a simple instance has a name before, and both in one record. */
bool lam_step_spline_surface(lam_step_reader *r, const lam_step_value *with_knots, int form,
                             lam_spline_surface *s) {
  const lam_step_value *spline = lam_step_record(r->entity, "B_SPLINE_SURFACE");
  const lam_step_value *rational = lam_step_record(r->entity, "RATIONAL_B_SPLINE_SURFACE");
  int shape = spline ? 0 : 1, first = spline ? 0 : 8;
  if (!spline) spline = with_knots;
  if (!lam_step_has_items(spline, shape + 7) ||
      (form == KNOTS_GIVEN && !lam_step_has_items(with_knots, first + 5)))
    return lam_step_fail(r, "values are missing");

  for (int d = 0; d < 2; d++)
    if (!read_degree(r, spline, shape + d, &s->degree[d])) return false;
  if (!read_table(r, lam_step_item(spline, shape + 2), s)) return false;
  if (!read_surface_knots(r, with_knots, first, form, s)) return false;
  if (rational && !read_weight_table(r, lam_step_item(rational, 0), s)) return false;

  const char *problem = lam_spline_problem(s);
  return problem ? lam_step_fail(r, lam_arena_printf(r->arena, "it has %s", problem)) : true;
}

/* ---- curves ---- */

const lam_step_value *lam_step_spline_curve_record(const lam_step_entity *entity, int *form) {
  static const char *const names[] = {"BEZIER_CURVE", "QUASI_UNIFORM_CURVE", "UNIFORM_CURVE",
                                      "B_SPLINE_CURVE_WITH_KNOTS"};
  return find_record(entity, names, form);
}

/* The control points of a curve: an item of the record of its own, or of the one with knots, behind
 * a name. */
static const lam_step_value *points_of(const lam_step_entity *entity) {
  int form;
  const lam_step_value *spline = lam_step_record(entity, "B_SPLINE_CURVE");
  return spline ? lam_step_typed(spline, 1, LAM_STEP_LIST)
                : lam_step_typed(lam_step_spline_curve_record(entity, &form), 2, LAM_STEP_LIST);
}

/* Told from the first point. */
bool lam_step_is_plane_curve(const lam_step_reader *r, const lam_step_entity *entity) {
  double xyz[3];
  return lam_step_coordinates(lam_step_referred(r, points_of(entity), 0), "CARTESIAN_POINT", xyz) ==
         2;
}

/* The weights of a curve, as many as it has points. False with a message. */
static bool read_curve_weights(lam_step_reader *r, const lam_step_value *given,
                               lam_spline_curve *c) {
  if (!given || given->count != c->count)
    return lam_step_fail(r, "expected as many weights as control points");
  double *weights = LAM_NEW(r->arena, double, c->count);
  if (!read_weights(r, given, weights)) return false;
  c->weights = weights;
  return true;
}

/* As a surface: degree and points, knots, weights; a simple instance has a name before. */
bool lam_step_spline_curve(lam_step_reader *r, const lam_step_value *with_knots, int form,
                           lam_spline_curve *c) {
  const lam_step_value *spline = lam_step_record(r->entity, "B_SPLINE_CURVE"),
                       *list = points_of(r->entity);
  const lam_step_value *rational = lam_step_record(r->entity, "RATIONAL_B_SPLINE_CURVE");
  int shape = spline ? 0 : 1, first = spline ? 0 : 6;
  if (!spline) spline = with_knots;
  if (!list || !list->count || (form == KNOTS_GIVEN && !lam_step_has_items(with_knots, first + 2)))
    return lam_step_fail(r, "values are missing");

  if (!read_degree(r, spline, shape, &c->degree)) return false;
  c->count = list->count;
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, c->count);
  if (!read_points(r, list, points)) return false;
  c->points = points;

  c->knots = form == KNOTS_GIVEN ? read_knots(r, lam_step_typed(with_knots, first, LAM_STEP_LIST),
                                              lam_step_typed(with_knots, first + 1, LAM_STEP_LIST),
                                              c->degree, c->count)
                                 : make_knots(r, (knot_form)form, c->degree, c->count);
  if (!c->knots) return false;
  if (rational && !read_curve_weights(r, lam_step_typed(rational, 0, LAM_STEP_LIST), c))
    return false;

  const char *problem = lam_curve_problem(c);
  return problem ? lam_step_fail(r, lam_arena_printf(r->arena, "it has %s", problem)) : true;
}
