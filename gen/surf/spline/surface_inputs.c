/* The three ways in which kinds of surfaces name a file, seen as one: as a surface, through its
 * sides, through its points. Called by design/pipeline_run.c and library/sources.c. */
#include "surf/spline/surface_inputs.h"
#include "surf/spline/sides_keys.h"

#include <string.h>

/* A kind reads a surface, or has sides, or has points, or names no file. */
lam_surface_file lam_surface_file_of(const lam_row *row) {
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  if (kind->reads_file) {
    const lam_surface_source *source = row->params;
    return (lam_surface_file){LAM_NEEDS_SURFACE, source->file, source->face};
  }

  const char *path = kind->sides ? kind->sides(row->params)->file : NULL;
  if (path) return (lam_surface_file){LAM_NEEDS_CURVES, path, 0};

  path = kind->points ? kind->points(row->params)->file : NULL;
  if (path) return (lam_surface_file){LAM_NEEDS_POINTS, path, 0};
  return (lam_surface_file){0};
}

/* Only the copy of the parameters is written to. */
lam_row lam_surface_row_with(lam_arena *arena, const lam_row *row,
                             const lam_surface_inputs *inputs) {
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  lam_surface_file file = lam_surface_file_of(row);
  if (file.needs == LAM_NEEDS_NOTHING) return *row;

  lam_row filled = *row;
  filled.params = lam_arena_alloc(arena, 1, row->head->params_size);
  memcpy(filled.params, row->params, row->head->params_size);

  if (file.needs == LAM_NEEDS_SURFACE) {
    lam_surface_source *source = filled.params;
    source->surface = inputs->surface;
    source->note = inputs->note;
  } else if (file.needs == LAM_NEEDS_CURVES) {
    lam_sides_keys *sides = kind->sides(filled.params);
    sides->read_count = inputs->curve_count;
    sides->read = inputs->curves;
  } else {
    lam_point_file *points = kind->points(filled.params);
    points->count = inputs->point_count;
    points->points = inputs->points;
  }
  return filled;
}
