/* Pieces of the STEP reader, shared by its files: units (step_units.c), B-splines
 * (step_splines.c) and curves of edges (step_curves.c). Called by step_read.c. */
#ifndef LAM_FORMATS_STEP_STEP_READER_H
#define LAM_FORMATS_STEP_STEP_READER_H

#include "formats/spline/curves.h"
#include "formats/step/step_tree.h"

/* What is being read. arena and scan (lam_scan_begin) are set by the caller, tree by
 * lam_step_tree_read, units by lam_step_units. */
typedef struct lam_step_reader {
  lam_arena *arena;
  lam_scan scan;
  lam_step_tree tree;
  double unit;                   /* of lengths, in meters; 0: not looked for yet */
  double angle;                  /* of plane angles, in radians */
  const char *what;              /* is being read, for messages: "surface" or "curve" */
  const lam_step_entity *entity; /* is being read, for messages */
} lam_step_reader;

/* Adds a message about the entity being read; false. */
bool lam_step_fail(lam_step_reader *r, const char *text);
/* Whether a list or record has at least `count` items; false when value is NULL. */
bool lam_step_has_items(const lam_step_value *value, int count);
/* The entity that item i refers to; NULL: it is no reference, or leads nowhere. */
const lam_step_entity *lam_step_referred(const lam_step_reader *r, const lam_step_value *record,
                                         int i);

/* The units of the geometry, into r->unit and r->angle: what the contexts assign. False with a
 * message when the unit of length is missing, unknown or not the only one; angles are in radians
 * unless the file says otherwise. */
bool lam_step_units(lam_step_reader *r);

/* A CARTESIAN_POINT of three numbers, in meters. False with a message; entity may be NULL. */
bool lam_step_cartesian(lam_step_reader *r, const lam_step_entity *entity, lam_vec3 *point);
/* Up to three numbers of an entity with this keyword (CARTESIAN_POINT or DIRECTION), as they
 * stand. Returns how many there are; 0 when it is no such entity, or NULL. */
int lam_step_coordinates(const lam_step_entity *entity, const char *keyword, double xyz[3]);

/* The record that makes an entity a B-spline surface / curve, and in form how its knots are
 * given, for the functions below; NULL: it is none. */
const lam_step_value *lam_step_spline_surface_record(const lam_step_entity *entity, int *form);
const lam_step_value *lam_step_spline_curve_record(const lam_step_entity *entity, int *form);
/* Read r->entity, in meters, from that record. False with a message. Arrays are owned by the
 * arena. */
bool lam_step_spline_surface(lam_step_reader *r, const lam_step_value *record, int form,
                             lam_spline_surface *s);
bool lam_step_spline_curve(lam_step_reader *r, const lam_step_value *record, int form,
                           lam_spline_curve *c);
/* Whether the control points of a B-spline curve have two coordinates: it lies in the parameters
 * of a surface. False for anything else. */
bool lam_step_is_plane_curve(const lam_step_reader *r, const lam_step_entity *entity);

/* Reads any curve that bounds an edge, in meters; entity is EDGE_CURVE, TRIMMED_CURVE, POLYLINE
 * or a B-spline curve. True with count 0 when it is of a kind that is not read; other then names
 * it. False with a message. */
bool lam_step_curve_of(lam_step_reader *r, const lam_step_entity *entity, lam_spline_curve *curve,
                       const char **other);

#endif
