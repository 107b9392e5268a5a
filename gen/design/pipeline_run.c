/* From a design to a model: the stages in their order, then supports, picture and report. Called by
 * library/. */
#include "core/solid/triangles.h"
#include "design/stages.h"

#include <string.h>

/* ---- what follows from the stages ---- */

/* Supports: boundary vertices that no neighbor is lower than, within a fiftieth of the height above
 * the lowest. */
static void find_supports(lam_build *build) {
  const lam_net *net = build->net;
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 low, high;
  lam_points_bounds(x, net->mesh.vertex_count, &low, &high);

  lam_vec3 *supports = LAM_NEW(build->arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    bool lowest = net->boundary[v] && x[v].z <= low.z + .02 * (high.z - low.z);
    for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++)
      lowest &= x[net->ring[i]].z >= x[v].z;
    if (lowest) supports[build->model->support_count++] = x[v];
  }
  build->model->supports = supports;
}

/* What the parts have left in the workshop becomes that of the model; arrays are shared. */
static void keep_workshop(lam_model *model, const lam_workshop *workshop) {
  model->surface_count = workshop->surface_count;
  model->surfaces = workshop->surfaces;
  model->curve_count = workshop->curve_count;
  model->curves = workshop->curves;
  model->part_count = workshop->part_count;
  model->parts = workshop->parts;
  model->record_kind_count = workshop->record_kind_count;
  model->record_kinds = workshop->record_kinds;
  model->crossing_count = workshop->crossing_count;
  model->crossings = workshop->crossings;
}

/* The picture that the design asks for, or the default one when there is anything to see. */
static void keep_picture(lam_build *build) {
  const lam_render_keys *render = &build->design->render;
  if (build->design->has_render || build->model->part_count || build->net)
    build->model->picture = (lam_picture){render->setting, render->view, render->size[0],
                                          render->size[1], render->quality};
}

/* The stages of the build and those of the parts, in the order in which they ran: sheets are made
 * after the parts, all else before them. */
static void collect_report(lam_build *build, const lam_workshop *workshop) {
  lam_report *report = LAM_NEW(build->arena, lam_report, 1);
  report->stages = LAM_NEW(build->arena, lam_stage, build->stage_count + workshop->stage_count);

  int own = 0;
  while (own < build->stage_count && strcmp(build->stages[own].name, "sheets") != 0)
    report->stages[report->stage_count++] = build->stages[own++];
  for (int i = 0; i < workshop->stage_count; i++)
    report->stages[report->stage_count++] = workshop->stages[i];
  while (own < build->stage_count) report->stages[report->stage_count++] = build->stages[own++];

  build->model->report = report;
}

/* ---- the pipeline ---- */

/* The first stage that finds the input wrong ends the build. */
bool lam_pipeline_run(lam_arena *arena, const lam_design *design, const lam_inputs *inputs,
                      const lam_progress *progress, lam_errors *errors, lam_model *model) {
  *model = (lam_model){.name = design->name,
                       .title = design->title,
                       .source = design->source,
                       .version = LAM_VERSION};
  lam_build build = {.arena = arena,
                     .design = design,
                     .inputs = inputs,
                     .progress = progress,
                     .errors = errors,
                     .model = model};

  /* The geometry. */
  if (!lam_build_surface(&build) || !lam_build_net(&build) || !lam_build_maps(&build)) return false;

  /* What is made from it. */
  lam_workshop *workshop = LAM_NEW(arena, lam_workshop, 1);
  *workshop = (lam_workshop){.arena = arena,
                             .errors = errors,
                             .progress = progress,
                             .origin = model->origin,
                             .net = build.net,
                             .normals = build.normals};
  lam_build_keep_surface(&build, workshop);
  if (!lam_build_print(&build, workshop) || !lam_build_parts(&build, workshop)) return false;
  lam_build_keep_lines(&build, workshop);
  keep_workshop(model, workshop);
  if (!lam_build_sheets(&build, workshop)) return false;

  if (build.net) find_supports(&build);
  keep_picture(&build);
  collect_report(&build, workshop);
  return true;
}

/* The model is made only because the stages write into one. */
bool lam_pipeline_check(lam_arena *arena, const lam_design *design, const lam_inputs *inputs,
                        lam_errors *errors) {
  lam_model model = {.name = design->name};
  lam_build build = {
      .arena = arena, .design = design, .inputs = inputs, .errors = errors, .model = &model};
  return lam_build_surface(&build) && lam_build_start(&build);
}
