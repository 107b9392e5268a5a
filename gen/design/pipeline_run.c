/* From a design to a model: surface, net, color maps, parts, sheets, report. */
#include "core/solid/triangles.h"
#include "design/pipeline.h"
#include "fab/flat/sheet.h"
#include "fab/lamella/lamella_checks.h"
#include "fab/workshop.h"
#include "surf/flatten/texture.h"
#include "surf/spline/sides_keys.h"

#include <math.h>
#include <string.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

lam_stage *lam_pipeline_stage(lam_pipeline *p, const char *name) {
  lam_progress_tell(p->progress, name, 0, "");
  p->since = now();
  lam_stage *stage = &p->stages[p->stage_count++];
  *stage = lam_stage_begin(name);
  return stage;
}

void lam_pipeline_stage_end(const lam_pipeline *p, lam_stage *stage) {
  stage->seconds = now() - p->since;
}

/* ---- the surface ---- */

static bool make_surface(lam_pipeline *p) {
  const lam_row *row = &p->design->surface;
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  int before = p->errors->count;
  if (!kind) return true;
  if (kind->reads_file && p->loader && p->loader->surface) {
    lam_surface_source *source = row->params;
    lam_spline_surface *surface = LAM_NEW(p->arena, lam_spline_surface, 1);
    if (!p->loader->surface(p->loader->context, p->arena, source->file, source->face, row->location,
                            p->errors, surface, &source->note))
      return false;
    source->surface = surface;
  }
  lam_sides_keys *sides = kind->sides ? kind->sides(row->params) : NULL;
  if (sides && sides->file && p->loader && p->loader->curves &&
      !p->loader->curves(p->loader->context, p->arena, sides->file, row->location, p->errors,
                         &sides->read_count, &sides->read))
    return false;
  lam_point_file *cloud = kind->points ? kind->points(row->params) : NULL;
  if (cloud && cloud->file && p->loader && p->loader->points &&
      !p->loader->points(p->loader->context, p->arena, cloud->file, row->location, p->errors,
                         &cloud->count, &cloud->points))
    return false;
  p->surface = lam_surface_make(p->arena, row, p->errors);
  return p->errors->count == before;
}

static void report_surface(lam_pipeline *p) {
  const lam_surface_kind *kind = p->surface.kind;
  if (!kind || !kind->report) return;
  lam_stage *stage =
      lam_pipeline_stage(p, lam_arena_printf(p->arena, "surface: %s", kind->head.name));
  kind->report(p->arena, p->surface.data, stage);
}

/* The surface for parts and writers, where the net is. */
static void keep_spline(lam_pipeline *p, lam_workshop *workshop) {
  const lam_surface_kind *kind = p->surface.kind;
  const lam_spline_surface *from = kind && kind->spline ? kind->spline(p->surface.data) : NULL;
  if (!from || !p->net) return;
  lam_spline_surface to = *from;
  int count = to.count[0] * to.count[1];
  lam_vec3 *points = LAM_NEW(p->arena, lam_vec3, count);
  for (int i = 0; i < count; i++) points[i] = lam_placement_apply(&p->placed, from->points[i]);
  to.points = points;
  to.name = "surface";
  lam_workshop_surface(workshop, to);
}

/* The lines of the net as curves, where no part has given axes. They are named as lamellas would
 * be. */
static void keep_lines(const lam_pipeline *p, lam_workshop *workshop) {
  int numbers[2] = {0};
  if (!p->net || !p->design->net.head || workshop->curve_count) return;
  for (int i = 0; i < p->net->polyline_count; i++) {
    const lam_polyline *line = &p->net->polylines[i];
    lam_workshop_curve(
        workshop, lam_arena_printf(p->arena, "%c%02d", 'A' + line->family, ++numbers[line->family]),
        line);
  }
}

/* ---- prints ---- */

static bool make_print(lam_pipeline *p, const lam_workshop *workshop) {
  const lam_texture_keys *keys = &p->design->texture;
  if (!p->design->has_texture) return true;
  if (!workshop->surface_count) {
    lam_error_add(p->errors, (lam_location){.file = p->design->path}, "texture",
                  "there is no spline surface to print on; expected a surface such as developable, "
                  "bezier or nurbs");
    return false;
  }
  lam_stage *stage = lam_pipeline_stage(p, "texture");
  lam_print *print = lam_print_make(p->arena, workshop->surfaces, (lam_motif)keys->motif,
                                    (lam_print_layout)keys->layout, keys->cells);
  for (int i = 0; i < print->count; i++) {
    const lam_printed *sheet = &print->sheets[i];
    if (strchr(sheet->name, '-')) continue; /* the same print, laid flat */
    lam_stage_measure(p->arena, stage, lam_arena_printf(p->arena, "distortion_%s", sheet->name), "",
                      sheet->max_stretch, sheet->mean_stretch, sheet->mesh.triangle_count);
  }
  p->model->print = print;
  lam_pipeline_stage_end(p, stage);
  return true;
}

/* ---- color maps ---- */

/* Lets measures see the surface when the vertices are where they were sampled, to a billionth of
 * the net's size. */
static void relate_to_surface(lam_pipeline *p) {
  const lam_vec2 *at = p->placed.parameters;
  const lam_mesh *mesh = &p->net->mesh;
  if (!at || p->sampled != mesh->vertex_count) return;
  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_jet jet;
    lam_surface_eval(&p->surface, at[v].x, at[v].y, &jet);
    if (!(lam_distance(lam_placement_apply(&p->placed, jet.x), mesh->vertices[v]) <=
          1e-9 * lam_distance(low, high)))
      return;
  }
  p->measuring.surface = &p->surface;
  p->measuring.parameters = at;
  p->measuring.surface_scale = p->placed.scale;
}

static bool make_maps(lam_pipeline *p) {
  const lam_list *plots = &p->design->plots;
  int before = p->errors->count;
  lam_location location = {.file = p->design->path};
  lam_measures_check(plots, true, location, "plots", p->errors);
  if (plots->count && !p->net)
    lam_error_add(p->errors, location, "plots",
                  "there is no net to plot; expected a surface or a net");
  if (p->errors->count > before) return false;
  if (!p->measuring.net && plots->count)
    p->measuring = lam_measuring_of(p->arena, p->net, p->net->mesh.vertices);
  if (plots->count) relate_to_surface(p);
  p->model->map_count = plots->count;
  if (plots->count) p->model->maps = lam_net_maps(&p->measuring, plots);
  return true;
}

/* ---- where it stands ---- */

/* Supports: boundary vertices that no neighbor is lower than, within a fiftieth of the height above
 * the lowest. */
static void find_supports(lam_pipeline *p) {
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

/* ---- parts and sheets ---- */

static bool make_parts(lam_pipeline *p, lam_workshop *workshop) {
  const lam_list *parts = &p->design->parts;
  int before = p->errors->count;
  if (parts->count && !p->net) {
    lam_error_add(p->errors, ((const lam_row *)parts->items)->location, "parts",
                  "there is no net to make parts from");
    return false;
  }
  for (int i = 0; i < parts->count; i++) {
    const lam_row *row = (const lam_row *)parts->items + i;
    const lam_part_kind *kind = (const lam_part_kind *)row->head;
    lam_progress_tell(p->progress, kind->head.name, (double)i / parts->count, "");
    kind->make(workshop, row->params, row->location);
    if (p->errors->count > before) return false;
  }
  if (parts->count) lam_workshop_clash(workshop);
  return p->errors->count == before;
}

static bool make_sheets(lam_pipeline *p, const lam_workshop *workshop) {
  const lam_sheet_keys *keys = &p->design->sheets;
  bool any = false;
  for (int i = 0; i < workshop->part_count; i++) any |= workshop->parts[i].flat != NULL;
  if (!any) return true;
  int before = p->errors->count;
  lam_stage *stage = lam_pipeline_stage(p, "sheets");
  lam_sheet_options options = {
      {keys->stock[0], keys->stock[1]}, keys->kerf, keys->margin, keys->spacing};
  lam_sheets sheets = lam_sheets_make(p->arena, workshop->parts, workshop->part_count, options,
                                      (lam_location){.file = p->design->path}, p->errors);
  if (p->errors->count > before) return false;
  p->model->sheet_count = sheets.count;
  p->model->sheets = sheets.sheets;
  double used = 0, least = 1;
  for (int i = 0; i < sheets.count; i++) {
    used += sheets.sheets[i].used / sheets.count;
    least = fmin(least, sheets.sheets[i].used);
  }
  lam_stage_measure(p->arena, stage, "sheet_count", "", sheets.count, sheets.count, sheets.count);
  lam_stage_measure(p->arena, stage, "sheet_used", "", 1 - least, used, sheets.count);
  lam_pipeline_stage_end(p, stage);
  return true;
}

static void collect_report(lam_pipeline *p, const lam_workshop *workshop) {
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

bool lam_design_build(lam_arena *arena, const lam_design *design, const lam_loader *loader,
                      const lam_progress *progress, lam_errors *errors, lam_model *model) {
  *model = (lam_model){.name = design->name,
                       .title = design->title,
                       .source = design->source,
                       .version = LAM_VERSION};
  lam_pipeline p = {.arena = arena,
                    .design = design,
                    .loader = loader,
                    .progress = progress,
                    .errors = errors,
                    .model = model};
  if (!make_surface(&p)) return false;
  report_surface(&p);
  if (!lam_pipeline_net(&p) || !make_maps(&p)) return false;
  lam_workshop *workshop = LAM_NEW(arena, lam_workshop, 1);
  *workshop = (lam_workshop){
      .arena = arena, .errors = errors, .progress = progress, .net = p.net, .normals = p.normals};
  keep_spline(&p, workshop);
  if (!make_print(&p, workshop) || !make_parts(&p, workshop)) return false;
  keep_lines(&p, workshop);
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
  if (!make_sheets(&p, workshop)) return false;
  if (p.net) find_supports(&p);
  if (design->has_render || workshop->part_count || p.net)
    model->picture =
        (lam_picture){design->render.setting, design->render.view, design->render.size[0],
                      design->render.size[1], design->render.quality};
  collect_report(&p, workshop);
  return true;
}
