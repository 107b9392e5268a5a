/* Lines traced on any smooth surface: parameter, principal, asymptotic and diagonal lines and
 * geodesics, integrated from the surface's jets; and the initial nets that they make where a
 * surface has no chart in closed form. Used by net/trace/start.c, and by design/net_stage.c
 * for the options. */
#ifndef LAM_NET_TRACE_TRACE_H
#define LAM_NET_TRACE_TRACE_H

#include "core/model.h"
#include "surf/placement.h"
#include "surf/surface.h"

/* ---- one line ---- */

/* What a line follows, by its chart:
 *   NATURAL             branch 0 and 1 are x_u and x_v
 *   PRINCIPAL           the directions of k1 and of k2
 *   ASYMPTOTIC          the two of normal curvature 0
 *   DIAGONAL            the two of normal curvature H
 *   GEODESIC_PARALLEL   geodesics; beside them runs the width j of a strip of geodesics,
 *   GEODESIC_POLAR      j'' + K j = 0
 *
 * The first four are fields of directions, two at every point. Along a line the branch and the
 * sense of travel do not change. */
typedef struct lam_line_field {
  const lam_surface *surface;
  lam_chart chart;
  int branch;
  double low[2], high[2]; /* lines end at the border of this rectangle of (u, v) */
  double size;            /* of the surface over it, meters */
  double tolerance;       /* of the error per step, as a part of the size */
} lam_line_field;

typedef enum lam_line_end {
  LAM_END_LENGTH,   /* as long as asked for */
  LAM_END_BORDER,   /* at the border of the rectangle */
  LAM_END_SINGULAR, /* where the directions end: an umbilic, a curve K = 0, a singular point of the
                       surface */
  LAM_END_CLOSED,   /* back at its beginning */
  LAM_END_FOCAL     /* neighboring geodesics have come together to a tenth of their distance */
} lam_line_end;

/* A point of a line at arc length s: (u, v), (du/ds, dv/ds), and on geodesics j, dj/ds. */
typedef struct lam_line_point {
  double s, y[6];
} lam_line_point;

typedef struct lam_line {
  const lam_line_field *field;
  int count;
  lam_line_point *points; /* s increases, from -back to forward */
  lam_line_end end[2];    /* why it ends at the first and at the last point */
} lam_line;

/* The field of a chart (branch 0) over the surface's natural domain, cut down to the ranges that
 * placing gives. A direction that closes is cut open half a period from `at`. The error per step is
 * below 1e-11 of the surface's size. */
lam_line_field lam_line_field_make(const lam_surface *surface, lam_chart chart,
                                   const lam_placement_keys *placing, const double at[2]);
/* The two unit directions (du, dv) of a field at (u, v); false where there are none. Geodesics:
 * x_u and its normal. */
bool lam_line_directions(const lam_line_field *field, double u, double v, lam_vec2 d[2]);
/* The line through (u, v) towards d (of any length, not 0), up to `back` behind the point and
 * `forward` before it. j: start of the strip's width and its derivative (geodesics; NULL: 1 and
 * 0). field is kept by pointer. */
lam_line lam_line_trace(lam_arena *arena, const lam_line_field *field, double u, double v,
                        lam_vec2 d, double back, double forward, const double j[2]);
/* The point of a line at arc length s, integrated from the nearest one before it. s is clamped
 * to the line. */
lam_line_point lam_line_at(const lam_line *line, double s);
/* Arc lengths of the first point (<= 0) and of the last one (>= 0). */
double lam_line_first(const lam_line *line);
double lam_line_last(const lam_line *line);

/* ---- initial nets ---- */

typedef struct lam_trace_options {
  const double *at; /* (u, v) that the base lines go through, or the pole; NULL: the middle */
  double spacing; /* arc length between neighboring lines on the base lines; 0: as far as the lines
                     reach */
  int base;       /* GEODESIC_PARALLEL: 0: geodesics start on the line u = at[0], 1: on v = at[1] */
} lam_trace_options;

/* What became of a traced net. */
typedef struct lam_traced {
  double coverage; /* share, 0 to 1, of the area of the surface over its ranges of u and v */
  double at[2];    /* (u, v) that the base lines go through */
  int cells[2];    /* along the families; fewer than the grid where no more fit */
} lam_traced;

/* Coverage that needs no word. */
static const double lam_enough_coverage = .8;

/* A net of traced lines: a base line of each family runs through `at`, the lines of the other
 * family through points at equal distances on it, and vertices are where lines of the two
 * families cross. It is the largest rectangle of such lines that all cross: with spacing 0 it has
 * grid[0] x grid[1] cells, else at most so many around `at`. Families run as x_u and x_v do. Lines
 * end where they would be laid over others. A net with neither `at` nor spacing that leaves much of
 * the surface bare is traced from another point than the middle when more is reached from there.
 *   GEODESIC_PARALLEL   family 0 are geodesics at right angles to a parameter line, family 1 joins
 *                       points at equal distance from it
 *   GEODESIC_POLAR      family 0 are geodesics from the pole, family 1 the circles around it;
 *                       max(1, hole) rings are left out around the pole
 *
 * A net whose first and last lines are the same is closed there. The mesh lies on the surface
 * before it is placed; owned by arena. traced: out. False, with errors, where there are no such
 * lines. */
bool lam_trace_net(lam_arena *arena, const lam_surface *surface, lam_chart chart, const int grid[2],
                   int hole, const lam_trace_options *options, const lam_placement_keys *placing,
                   lam_location location, lam_errors *errors, lam_mesh *mesh, lam_traced *traced);

#endif
