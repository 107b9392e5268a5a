/* From a design to a model: surface, net, color maps, parts, sheets, report. Called by library/. */
#include "core/solid/triangles.h"
#include "design/stages.h"

#include <string.h>

/* ---- where it stands ---- */

/* Supports: boundary vertices that no neighbor is lower than, within a fiftieth of the height above
 * the lowest. */
static void find_supports(lam_build *p) {
  const lam_net *net = p->net;
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 low, high;
  lam_points_bounds(x, net->mesh.vertex_count, &low, &high);
  lam_vec3 *supports = LAM_NEW(p->arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    bool lowest = net->boundary[v] && x[v].z <= low.z + .02 * (high.z - low.z);
    for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++)
      lowest &= x[net->ring[i]].z >= x[v].z;
    if (lowest) supports[p->model->support_count++] = x[v];
  }
  p->model->supports = supports;
}

static void collect_report(lam_build *p, const lam_workshop *workshop) {
  lam_report *report = LAM_NEW(p->arena, lam_report, 1);
  report->stages = LAM_NEW(p->arena, lam_stage, p->stage_count + workshop->stage_count);
  int own = 0;
  while (own < p->stage_count && strcmp(p->stages[own].name, "sheets") != 0)
    report->stages[report->stage_count++] = p->stages[own++];
  for (int i = 0; i < workshop->stage_count; i++)
    report->stages[report->stage_count++] = workshop->stages[i];
  while (own < p->stage_count) report->stages[report->stage_count++] = p->stages[own++];
  p->model->report = report;
}

bool lam_report_converged(const lam_report *report) {
  for (int i = 0; i < report->stage_count; i++)
    if (!report->stages[i].converged) return false;
  return true;
}

bool lam_pipeline_run(lam_arena *arena, const lam_design *design, const lam_inputs *inputs,
                      const lam_progress *progress, lam_errors *errors, lam_model *model) {
  *model = (lam_model){.name = design->name,
                       .title = design->title,
                       .source = design->source,
                       .version = LAM_VERSION};
  lam_build p = {.arena = arena,
                 .design = design,
                 .inputs = inputs,
                 .progress = progress,
                 .errors = errors,
                 .model = model};
  if (!lam_build_surface(&p) || !lam_build_net(&p) || !lam_build_maps(&p)) return false;
  lam_workshop *workshop = LAM_NEW(arena, lam_workshop, 1);
  *workshop = (lam_workshop){
      .arena = arena, .errors = errors, .progress = progress, .net = p.net, .normals = p.normals};
  lam_build_keep_surface(&p, workshop);
  if (!lam_build_print(&p, workshop) || !lam_build_parts(&p, workshop)) return false;
  lam_build_keep_lines(&p, workshop);
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
  if (!lam_build_sheets(&p, workshop)) return false;
  if (p.net) find_supports(&p);
  if (design->has_render || workshop->part_count || p.net)
    model->picture =
        (lam_picture){design->render.setting, design->render.view, design->render.size[0],
                      design->render.size[1], design->render.quality};
  collect_report(&p, workshop);
  return true;
}
