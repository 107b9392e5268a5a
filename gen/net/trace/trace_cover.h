/* Cells of traced nets in the plane of (u, v): which lie on others, and how much of the surface
 * they cover. For the files trace_*.c of this folder only. */
#ifndef LAM_NET_TRACE_TRACE_COVER_H
#define LAM_NET_TRACE_TRACE_COVER_H

#include "net/trace/trace.h"

/* Vertices of a traced net in (u, v), row-major. Lines that close stand at both ends. */
typedef struct lam_cells {
  int rows, columns;
  lam_vec2 *at;
} lam_cells;

/* A fine pattern of points over the rectangle of a field, each of which belongs to one cell. */
typedef struct lam_pattern lam_pattern;
/* A pattern of side x side points that belong to nobody; owned by arena. */
lam_pattern *lam_pattern_new(lam_arena *arena, const lam_line_field *field, int side);
/* Gives the points inside a quadrilateral of (u, v) to it. False, and nothing is given, when one
 * of them belongs to another one already. */
bool lam_pattern_lay(lam_pattern *pattern, const lam_vec2 corner[4]);

/* The share, 0 to 1, of the area of the surface over the rectangle of the field that the cells lie
 * over; to about a percent. arena: of scratch, released at the end. */
double lam_cells_coverage(lam_arena *arena, const lam_line_field *field, const lam_cells *cells);

#endif
