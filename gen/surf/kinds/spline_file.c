/* The surface kind "file": spline surfaces out of files of other programs, which whoever reads
 * files puts in before (surf/spline/surface_inputs.h). Registered in surfaces.c. */
#include "core/stage.h"
#include "curve/bspline/basis.h"
#include "surf/spline/spline_surface.h"

/* The surface, and what of the file was not read. */
typedef struct file_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  const char *note;
} file_data;

/* A file may hold anything: degrees and knots are checked here. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_surface_source *source = params;
  const lam_spline_surface *s = source->surface;
  int before = errors->count;
  if (!s) {
    lam_error_add(errors, location, "file", "%s cannot be read: this caller loads no files",
                  source->file);
    return NULL;
  }

  for (int d = 0; d < 2; d++) {
    if (s->degree[d] > LAM_BASIS_MAX_DEGREE) {
      lam_error_add(errors, location, "file", "the surface has degree %d; expected at most %d",
                    s->degree[d], LAM_BASIS_MAX_DEGREE);
      continue;
    }

    int knots = s->count[d] + s->degree[d] + 1;
    const char *problem = lam_knots_problem(s->degree[d], s->count[d], knots, s->knots[d]);
    if (problem)
      lam_error_add(errors, location, "file", "the knots of the surface in %c %s", d ? 'v' : 'u',
                    problem);
  }

  if (errors->count > before) return NULL;
  file_data *data = LAM_NEW(arena, file_data, 1);
  *data = (file_data){lam_nurbs_make(arena, s), source->note};
  return data;
}

/* Degrees and sizes, and the note of whoever read the file. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const file_data *d = data;
  const lam_spline_surface *s = lam_held_nurbs_spline(data);
  lam_stage_note(arena, stage, "degree %d x %d, %d x %d control points%s", s->degree[0],
                 s->degree[1], s->count[0], s->count[1], s->weights ? ", rational" : "");
  if (d->note) lam_stage_note(arena, stage, "%s", d->note);
}

static const lam_key keys[] = {
    LAM_TEXT_KEY(lam_surface_source, "file", file, "surface.json",
                 "A .step, .stp, .igs, .iges, .json or .obj file, beside the design."),
    LAM_INTEGER_KEY(
        lam_surface_source, "face", face, "1", 1, 1000000,
        "Which of the file's B-spline surfaces, counted from 1 in their order in the file."),
    {0}};

const lam_surface_kind lam_surface_file = {
    .head =
        {.name = "file",
         .title = "Surface from a file",
         .doc = "A B-spline or NURBS surface that another program saved, as STEP, as IGES, as "
                "free-form OBJ (in meters) or as surface.json of an earlier run. The whole surface "
                "is taken: where a face is trimmed to a part of it, the trimming is not read, and "
                "neither is the placement of components in an assembly; the report says so where "
                "that is the case. Planes, cylinders and other surfaces that are no splines have "
                "to be converted to NURBS before they are saved.",
         .equation = "x(u,v) = sum_ij N_i(u) N_j(v) w_ij P_ij / sum_ij N_i(u) N_j(v) w_ij",
         .source = "ISO 10303-42; IGES 5.3, 4.23",
         .keys = keys,
         .params_size = sizeof(lam_surface_source)},
    .reads_file = true,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
