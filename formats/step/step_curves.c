/* Curves of edges and wireframes out of the entities of a STEP file (ISO 10303-42): B-splines,
 * straight lines, arcs of circles and ellipses. Called by step_read.c. */
#include "core/numbers.h"
#include "formats/step/step_reader.h"

#include <string.h>

enum { deepest_curve = 8 };

/* Where a curve that is to be cut begins and ends: points, or parameters of the curve, or
 * neither. forward: it runs from the first end to the second in its own direction. */
typedef struct bounds {
  bool has_points, has_parameters, forward;
  lam_vec3 points[2];
  double parameters[2];
} bounds;

/* A position with unit axes x, y of a plane, at right angles. */
typedef struct plane {
  lam_vec3 origin, x, y;
} plane;

/* Item i of a record as a unit direction; false, without a message, when it is none or zero. */
static bool read_direction(const lam_step_reader *r, const lam_step_value *record, int i,
                           lam_vec3 *direction) {
  double xyz[3];
  if (lam_step_coordinates(lam_step_referred(r, record, i), "DIRECTION", xyz) < 3) return false;

  *direction = lam_unit(lam_v3(xyz[0], xyz[1], xyz[2]));
  return lam_length(*direction) > 0;
}

/* The plane of an AXIS2_PLACEMENT_3D. The third axis is made at right angles to z; axes that are
 * left out are z and x, or y where z is near x. False with a message. */
static bool read_plane(lam_step_reader *r, const lam_step_entity *entity, plane *p) {
  const lam_step_value *record = lam_step_record(entity, "AXIS2_PLACEMENT_3D");
  if (!record) return lam_step_fail(r, "its position is not an AXIS2_PLACEMENT_3D");
  if (!lam_step_cartesian(r, lam_step_referred(r, record, 1), &p->origin)) return false;

  lam_vec3 z = lam_v3(0, 0, 1), x = lam_v3(1, 0, 0);
  read_direction(r, record, 2, &z);
  if (!read_direction(r, record, 3, &x) && fabs(z.x) > 0.9) x = lam_v3(0, 1, 0);

  p->x = lam_unit(lam_along(x, -lam_dot(x, z), z));
  p->y = lam_cross(z, p->x);
  return lam_length(p->x) > 0 || lam_step_fail(r, "the axes of its position are parallel");
}

/* The parameter t, in (-pi, pi], of a point on center + a cos t x + b sin t y. */
static double angle_of(const plane *p, const double radii[2], lam_vec3 x) {
  lam_vec3 d = lam_sub(x, p->origin);
  return atan2(lam_dot(d, p->y) / radii[1], lam_dot(d, p->x) / radii[0]);
}

/* CIRCLE('', position, radius) or ELLIPSE('', position, radius along x, radius along y). An arc
 * that runs backward is the one from its end to its start; without ends it is a full turn. False
 * with a message. */
static bool read_arc(lam_step_reader *r, const lam_step_value *arc, const bounds *b,
                     lam_spline_curve *curve) {
  plane p;
  double radii[2];
  for (int i = 0; i < 2; i++) {
    const lam_step_value *radius = lam_step_typed(arc, arc->count > 3 ? 2 + i : 2, LAM_STEP_NUMBER);
    if (!radius || !(radius->number > 0))
      return lam_step_fail(r, "its radius is not a positive number");
    radii[i] = radius->number * r->unit;
  }

  if (!read_plane(r, lam_step_referred(r, arc, 1), &p)) return false;

  double t[2] = {0, 2 * LAM_PI};
  for (int i = 0; i < 2; i++) {
    if (b->has_points) t[i] = angle_of(&p, radii, b->points[i]);
    if (!b->has_points && b->has_parameters)
      t[i] = remainder(b->parameters[i] * r->angle, 2 * LAM_PI);
  }

  double from = t[b->forward ? 0 : 1], to = t[b->forward ? 1 : 0];
  if (to - from <= 1e-12) to += 2 * LAM_PI;
  *curve = lam_curve_arc(r->arena, p.origin, lam_scale(p.x, radii[0]), lam_scale(p.y, radii[1]),
                         from, to);
  return true;
}

/* LINE('', point, VECTOR('', direction, magnitude)): straight between its ends, or between
 * parameters t of point + t magnitude direction. False with a message. */
static bool read_line(lam_step_reader *r, const lam_step_value *line, const bounds *b,
                      lam_spline_curve *curve) {
  lam_vec3 ends[2] = {b->points[0], b->points[1]};
  if (!b->has_points) {
    lam_vec3 origin, direction;
    const lam_step_value *vector = lam_step_record(lam_step_referred(r, line, 2), "VECTOR");
    const lam_step_value *length = lam_step_typed(vector, 2, LAM_STEP_NUMBER);
    if (!b->has_parameters) return lam_step_fail(r, "a straight line without ends");
    if (!length || !read_direction(r, vector, 1, &direction))
      return lam_step_fail(r, "its direction is not a VECTOR");
    if (!lam_step_cartesian(r, lam_step_referred(r, line, 1), &origin)) return false;
    for (int i = 0; i < 2; i++)
      ends[i] = lam_along(origin, b->parameters[i] * length->number * r->unit, direction);
  }

  *curve = lam_curve_line(r->arena, ends[0], ends[1]);
  return true;
}

/* POLYLINE('', points): straight pieces, as a spline of degree 1 whose knots are whole numbers.
 * It is not cut. False with a message. */
static bool read_polyline(lam_step_reader *r, const lam_step_value *polyline,
                          lam_spline_curve *curve) {
  const lam_step_value *list = lam_step_typed(polyline, 1, LAM_STEP_LIST);
  int n = list ? list->count : 0;
  if (n < 2) return lam_step_fail(r, "a polyline of fewer than two points");

  double *knots = LAM_NEW(r->arena, double, n + 2);
  lam_vec3 *points = LAM_NEW(r->arena, lam_vec3, n);
  for (int i = 0; i < n; i++)
    if (!lam_step_cartesian(r, lam_step_referred(r, list, i), &points[i])) return false;

  for (int i = 0; i < n + 2; i++) knots[i] = i == 0 ? 0 : i > n ? n - 1 : i - 1;
  *curve = (lam_spline_curve){1, n, knots, points, NULL};
  return true;
}

/* A B-spline, cut to the part between its ends, or between the points nearest to them. False with
 * a message. */
static bool read_spline(lam_step_reader *r, const lam_step_entity *entity, const bounds *b,
                        lam_spline_curve *curve) {
  int form;
  const lam_step_value *record = lam_step_spline_curve_record(entity, &form);
  r->entity = entity;
  if (!lam_step_spline_curve(r, record, form, curve)) return false;

  double low = curve->knots[curve->degree], high = curve->knots[curve->count];
  if (b->has_parameters) {
    double from = fmax(low, fmin(b->parameters[0], b->parameters[1]));
    double to = fmin(high, fmax(b->parameters[0], b->parameters[1]));
    if (from < to) low = from, high = to;
  } else if (b->has_points) {
    *curve = lam_curve_between(r->arena, curve, b->points[0], b->points[1]);
    return true;
  }
  *curve = lam_curve_part(r->arena, curve, low, high);
  return true;
}

/* ---- what cuts them ---- */

/* The points of EDGE_CURVE('', VERTEX_POINT, VERTEX_POINT, curve, sense). False with a message. */
static bool read_vertices(lam_step_reader *r, const lam_step_value *edge, bounds *b) {
  for (int i = 0; i < 2; i++) {
    const lam_step_value *vertex =
        lam_step_record(lam_step_referred(r, edge, 1 + i), "VERTEX_POINT");
    if (!vertex) return lam_step_fail(r, "it does not end at VERTEX_POINTs");
    if (!lam_step_cartesian(r, lam_step_referred(r, vertex, 1), &b->points[i])) return false;
  }

  const lam_step_value *sense = lam_step_item(edge, 4);
  b->has_points = true;
  b->forward = !sense || sense->type != LAM_STEP_TEXT || !lam_word_is(sense->word, ".F.");
  return true;
}

/* The ends of TRIMMED_CURVE('', curve, ends, ends, sense, ...). Each of the two lists has a
 * point, a parameter, or both; only what both have is taken. False with a message. */
static bool read_trims(lam_step_reader *r, const lam_step_value *trimmed, bounds *b) {
  int points = 0, parameters = 0;
  for (int i = 0; i < 2; i++) {
    const lam_step_value *list = lam_step_typed(trimmed, 2 + i, LAM_STEP_LIST);
    for (const lam_step_value *item = list ? list->first : NULL; item; item = item->next) {
      const lam_step_value *number = lam_step_typed(item, 0, LAM_STEP_NUMBER);
      if (item->type == LAM_STEP_RECORD && lam_word_is(item->word, "PARAMETER_VALUE") && number) {
        b->parameters[i] = number->number;
        parameters |= 1 << i;
      } else if (item->type == LAM_STEP_REFERENCE) {
        if (!lam_step_cartesian(r, lam_step_find(&r->tree, item->entity), &b->points[i]))
          return false;
        points |= 1 << i;
      }
    }
  }

  b->has_points = points == 3;
  b->has_parameters = parameters == 3;
  if (!b->has_points && !b->has_parameters)
    return lam_step_fail(r, "it is not trimmed at two ends");

  const lam_step_value *sense = lam_step_item(trimmed, 4);
  b->forward = !sense || sense->type != LAM_STEP_TEXT || !lam_word_is(sense->word, ".F.");
  return true;
}

/* The keyword of an entity, for messages; at most 40 letters. */
static const char *keyword_of(const lam_step_reader *r, const lam_step_entity *entity) {
  if (!entity || !entity->records) return "nothing";
  lam_word keyword = entity->records->word;
  return lam_arena_printf(r->arena, "%.*s", lam_word_shown(keyword), keyword.text);
}

/* A curve between the ends that b has so far: goes on to the curve that an edge, a trimmed curve
 * or a curve on a surface lies on, until one that can be read. The ends of an edge come before
 * those of a trimmed curve in it. other: the keyword of a kind that is not read; curve then stays
 * as it is. False with a message. */
static bool read_cut(lam_step_reader *r, const lam_step_entity *entity, bounds *b, int depth,
                     lam_spline_curve *curve, const char **other) {
  static const char *const around[] = {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"};
  int form;
  const lam_step_value *record;
  if (depth == deepest_curve) return lam_step_fail(r, "curves within curves without end");

  for (int i = 0; i < 3; i++)
    if ((record = lam_step_record(entity, around[i])))
      return read_cut(r, lam_step_referred(r, record, 1), b, depth + 1, curve, other);
  if ((record = lam_step_record(entity, "EDGE_CURVE")))
    return read_vertices(r, record, b) &&
           read_cut(r, lam_step_referred(r, record, 3), b, depth + 1, curve, other);
  if ((record = lam_step_record(entity, "TRIMMED_CURVE"))) {
    if (!b->has_points && !read_trims(r, record, b)) return false;
    return read_cut(r, lam_step_referred(r, record, 1), b, depth + 1, curve, other);
  }

  if ((record = lam_step_record(entity, "LINE"))) return read_line(r, record, b, curve);
  if ((record = lam_step_record(entity, "CIRCLE"))) return read_arc(r, record, b, curve);
  if ((record = lam_step_record(entity, "ELLIPSE"))) return read_arc(r, record, b, curve);
  if ((record = lam_step_record(entity, "POLYLINE"))) return read_polyline(r, record, curve);
  if (lam_step_spline_curve_record(entity, &form)) return read_spline(r, entity, b, curve);
  *other = keyword_of(r, entity);
  return true;
}

/* Without ends the whole curve is read. */
bool lam_step_curve_of(lam_step_reader *r, const lam_step_entity *entity, lam_spline_curve *curve,
                       const char **other) {
  bounds b = {.forward = true};
  r->entity = entity;
  r->what = "curve";
  *curve = (lam_spline_curve){0};

  if (!read_cut(r, entity, &b, 0, curve, other)) return false;
  const char *problem = curve->count ? lam_curve_problem(curve) : NULL;
  return problem ? lam_step_fail(r, lam_arena_printf(r->arena, "it has %s", problem)) : true;
}
