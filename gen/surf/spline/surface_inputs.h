/* Files that surfaces stand in: which one a parsed surface names, and putting in what was read of
 * it. The pipeline does both; whoever reads files stands above it. */
#ifndef LAM_SURF_SPLINE_SURFACE_INPUTS_H
#define LAM_SURF_SPLINE_SURFACE_INPUTS_H

#include "surf/surface.h"

/* What a surface reads of its file. */
typedef enum lam_surface_needs {
  LAM_NEEDS_NOTHING,
  LAM_NEEDS_SURFACE, /* one spline surface */
  LAM_NEEDS_CURVES,  /* its boundary */
  LAM_NEEDS_POINTS   /* what it passes through or near */
} lam_surface_needs;

typedef struct lam_surface_file {
  lam_surface_needs needs;
  const char *path; /* as in the design; NULL when nothing is needed */
  int face;         /* LAM_NEEDS_SURFACE: which one, from 1 */
} lam_surface_file;

/* The file that a parsed surface names. row->head is not NULL. */
lam_surface_file lam_surface_file_of(const lam_row *row);

/* What was read: only what is needed is looked at. */
typedef struct lam_surface_inputs {
  const lam_spline_surface *surface; /* its numbers need not be sound; NULL: not read */
  const char *note;                  /* what of the file is not read; NULL: nothing */
  int curve_count;
  const lam_named_curve *curves; /* NULL: not read */
  int point_count;
  const lam_vec3 *points; /* as they are written there; NULL: not read */
} lam_surface_inputs;

/* The row with what was read put in: its parameters are a copy in arena, the row stays as it is.
 * Without a file, the row itself. */
lam_row lam_surface_row_with(lam_arena *arena, const lam_row *row,
                             const lam_surface_inputs *inputs);

#endif
