/* Four boundary curves as designs give them, in numbers or in a file: the keys `curves`,
 * `unit`, `file` and `pick` of every kind of surface over four sides (surf/kinds/coons.c,
 * surf/area/least_area.c, surf/developable/developable.c). */
#ifndef LAM_SURF_SPLINE_SIDES_KEYS_H
#define LAM_SURF_SPLINE_SIDES_KEYS_H

#include "core/error.h"
#include "core/key.h"
#include "surf/spline/point_keys.h"
#include "surf/spline/sides.h"
#include "surf/surface_kind.h"

/* One of the maps in `curves`: lists of numbers as in the design. */
typedef struct lam_side_keys {
  lam_list points, weights, knots, across;
  int degree;
} lam_side_keys;

/* A member of the parameters of a kind; filled by LAM_SIDES_KEYS. The design names the file,
 * and who reads files puts its curves in (surf/spline/surface_inputs.h) before it is made. */
typedef struct lam_sides_keys {
  lam_list curves;   /* of lam_side_keys */
  bool curves_given; /* by the design, not by default */
  int unit;          /* index in lam_point_units */
  const char *file;  /* NULL: none */
  lam_list pick;     /* of int: which of the file's curves, from 1; empty: the file has four */
  int read_count;
  /* The curves of the file, sound but for knots that repeat too often; NULL: it is not read. */
  const lam_named_curve *read;
} lam_sides_keys;

/* The tables of one curve: with points, weights, knots and degree; the second with `across`
 * too. */
extern const lam_key lam_side_table[], lam_side_across_table[];

/* Rows for the key table of a kind: params.member is a lam_sides_keys, table one of the two
 * above, text the default. */
#define LAM_SIDES_KEYS(params, member, table, text)                                                \
  LAM_MAPS_KEY(params, "curves", member.curves, text, table, lam_side_keys,                        \
               "The four boundary curves, each in either direction, listed around the boundary: "  \
               "v=0, u=0, v=1, u=1, or as v=0, v=1, u=0, u=1. They must meet at their ends.",      \
               LAM_GIVEN(params, member.curves_given)),                                            \
      LAM_CHOICE_KEY(params, "unit", member.unit, "m", lam_point_units,                            \
                     "Unit of the numbers in points and vectors."),                                \
      LAM_SIDES_FILE_KEYS(params, member)

/* The last two of these rows. */
#define LAM_SIDES_FILE_KEYS(params, member)                                                        \
  LAM_TEXT_KEY(params, "file", member.file, "~",                                                   \
               "In place of curves: a .step, .stp, .igs, .iges, .json or .obj file beside the "    \
               "design with four curves (splines, lines or arcs) that meet end to end, in any "    \
               "order and direction. The first is v=0."),                                          \
      LAM_INTEGER_KEY(params, "pick", member.pick, "[]", 1, 1000000,                               \
                      "Which four of the file's curves, counted from 1 in their order in the "     \
                      "file; none: it has four.")

/* What a kind can take. */
typedef struct lam_sides_limits {
  int degree;      /* the highest of a curve, at most LAM_BASIS_MAX_DEGREE */
  bool no_weights; /* polynomial curves only */
} lam_sides_limits;

/* The sides that the keys give, in meters, joined (lam_sides_join) and owned by the arena;
 * false with messages. location: of the surface in the design. */
bool lam_sides_read(lam_arena *arena, const lam_sides_keys *keys, lam_sides_limits limits,
                    lam_location location, lam_errors *errors, lam_sides *sides);

#endif
