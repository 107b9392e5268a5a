#include "design/build.h"
#include "core/mesh.h"
#include "fab/lamella_checks.h"
#include "fab/sheet.h"
#include "fab/workshop.h"
#include "net/coarsen.h"
#include "net/diagonalize.h"
#include "net/map.h"
#include "net/optimize.h"
#include "net/start.h"
#include "net/trace.h"
#include "surf/place.h"
#include "surf/sides_keys.h"
#include "surf/texture.h"

#include <math.h>
#include <string.h>
#include <time.h>

enum { surface_grid = 32 }; /* cells of the mesh that stands for a surface without a net */

typedef struct pipeline {
  lam_arena *arena;
  const lam_design *design;
  const lam_loader *loader;
  const lam_progress *progress;
  lam_errors *errors;
  lam_model *model;
  lam_surface surface;
  lam_net *net;
  lam_measuring measuring; /* of the net */
  lam_vec3 *normals;
  lam_siting placed; /* of the surface */
  int sampled;       /* vertices of the net as it was sampled */
  int stage_count;
  lam_stage stages[4]; /* surface, net, texture, sheets; parts bring their own */
  double since;
} pipeline;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static lam_stage *begin_stage(pipeline *p, const char *name) {
  lam_progress_tell(p->progress, name, 0, "");
  p->since = now();
  lam_stage *stage = &p->stages[p->stage_count++];
  *stage = (lam_stage){.name = name, .converged = true, .reason = "done", .iterations = -1};
  return stage;
}

static void end_stage(const pipeline *p, lam_stage *stage) { stage->seconds = now() - p->since; }

/* ---- the initial net ---- */

static bool load_mesh(pipeline *p, const lam_net_common *common, lam_mesh *mesh) {
  lam_place place = p->design->net.place;
  if (p->loader && p->loader->mesh)
    return p->loader->mesh(p->loader->context, p->arena, common->from.file, place, p->errors, mesh);
  lam_error_add(p->errors, place, "net.from.file", "%s cannot be read: this caller loads no files", common->from.file);
  return false;
}

static bool load_net(pipeline *p, const lam_net_common *common, lam_mesh *mesh) {
  lam_place place = p->design->net.place;
  if (p->loader && p->loader->net)
    return p->loader->net(p->loader->context, p->arena, common->from.design, place, p->errors, mesh);
  lam_error_add(p->errors, place, "net.from.design", "%s cannot be built: this caller loads no designs",
                common->from.design);
  return false;
}

/* The lines of the surface that the net asks for, by formula or traced. */
static bool start_net(pipeline *p, const lam_net_kind *kind, const lam_net_common *common, lam_mesh *mesh) {
  const lam_net_source *from = &common->from;
  const lam_surface_place *placing = p->design->surface.common;
  lam_place place = p->design->surface.place;
  lam_chart chart = from->lines ? (lam_chart)(from->lines - 1) : kind->chart;
  double ranges[2][2];
  bool closed[2], formula = chart < LAM_CHART_COUNT &&
                            p->surface.kind->domain(p->surface.data, chart, ranges[0], ranges[1], closed);
  if (formula && !from->trace) {
    if (!from->at_given && from->spacing == 0)
      return lam_net_start(p->arena, &p->surface, chart, common->grid, common->hole, placing, place, p->errors, mesh,
                           &p->placed);
    lam_error_add(p->errors, p->design->net.place, from->at_given ? "net.from.at" : "net.from.spacing",
                  "given, but %s has a formula for its %s lines; expected trace: yes beside it, or u and v of the "
                  "surface instead",
                  p->surface.kind->head.name, lam_chart_names[chart]);
    return false;
  }
  lam_trace_options options = {from->at_given ? from->at : NULL, from->spacing, from->base};
  return lam_net_start_traced(p->arena, &p->surface, chart, common->grid, common->hole, &options, placing,
                              p->design->net.place, p->errors, mesh, &p->placed);
}

static bool initial_mesh(pipeline *p, const lam_net_kind *kind, const lam_net_common *common, lam_mesh *mesh) {
  const lam_design *design = p->design;
  if (common && common->from.file) return load_mesh(p, common, mesh);
  if (common && common->from.design) return load_net(p, common, mesh);
  if (kind && kind->start) {
    if (design->surface.head)
      lam_error_add(p->errors, design->surface.place, "surface", "given, but %s makes its own start; expected none",
                    kind->head.name);
    return kind->start(p->arena, design->net.params, common->grid, design->net.place, p->errors, mesh) &&
           !design->surface.head;
  }
  if (!design->surface.head) {
    lam_error_add(p->errors, design->net.place, "surface", "not given; expected a surface, or net.from: {file: ...}");
    return false;
  }
  const lam_surface_place *placing = design->surface.common;
  static const int coarse[2] = {surface_grid, surface_grid};
  if (common) return start_net(p, kind, common, mesh);
  return lam_net_start(p->arena, &p->surface, LAM_CHART_NATURAL, coarse, 0, placing, design->surface.place, p->errors,
                       mesh, &p->placed);
}

static bool build_net(pipeline *p, const lam_mesh *mesh, lam_place place) {
  return lam_net_build(p->arena, mesh, place, p->errors, p->net);
}

static bool refuse(pipeline *p, lam_place place, const char *key, const char *why) {
  lam_error_add(p->errors, place, key, "the net cannot be changed so: %s", why);
  return false;
}

/* Diagonals, then every other line left out, then subdivided. */
static bool refine(pipeline *p, lam_mesh *mesh, const lam_net_common *common, lam_place place) {
  if (!build_net(p, mesh, place)) return false;
  if (!common) return true;
  if (common->diagonalize) {
    const char *why = lam_net_diagonalize(p->arena, p->net, mesh);
    if (why) return refuse(p, place, "net.diagonalize", why);
    if (!build_net(p, mesh, place)) return false;
  }
  for (int i = 0; i < common->coarsen; i++) {
    lam_coarse coarse;
    const char *why = lam_net_coarsen(p->arena, p->net, &coarse);
    if (why) return refuse(p, place, "net.coarsen", why);
    *mesh = coarse.mesh;
    if (!build_net(p, mesh, place)) return false;
  }
  for (int i = 0; i < common->subdivide; i++) {
    *mesh = lam_net_four_point(p->arena, p->net);
    if (!build_net(p, mesh, place)) return false;
  }
  return true;
}

static bool solve_net(pipeline *p, const lam_net_kind *kind, const lam_net_common *common) {
  const lam_design *design = p->design;
  lam_stage *stage = begin_stage(p, "net");
  lam_net_job job = {kind, design->net.params, common, NULL, design->net.place, p->progress};
  if (common->reference_given && common->reference.file) {
    lam_trimesh *reference = LAM_NEW(p->arena, lam_trimesh, 1);
    if (!p->loader || !p->loader->triangles(p->loader->context, p->arena, common->reference.file, design->net.place,
                                            p->errors, reference))
      return false;
    job.reference = reference;
  }
  lam_net_result result;
  if (!lam_net_optimize(p->arena, &job, p->net, p->errors, &result)) return false;
  stage->name = lam_arena_printf(p->arena, "net: %s", kind->head.name);
  stage->converged = result.converged;
  stage->reason = result.reason;
  stage->iterations = result.solution.iterations;
  stage->residual = result.solution.residual;
  stage->measure_count = result.measure_count;
  stage->measures = result.measures;
  p->measuring = result.measuring;
  lam_stage_note(p->arena, stage, "%d vertices, %d faces, %d unknowns, %d equations", p->net->mesh.vertex_count,
                 p->net->mesh.face_count, result.solution.unknowns, result.solution.residuals);
  lam_stage_note(p->arena, stage, "largest move from the start: %.3g mean edges", result.drift);
  if (result.levels) lam_stage_note(p->arena, stage, "%d coarser nets solved first", result.levels);
  p->model->frame_count = result.frame_count;
  p->model->frames = result.frames;
  if (result.skipped) lam_stage_note(p->arena, stage, "%ld irregular vertices left out", result.skipped);
  if (!result.converged && result.solution.worst)
    lam_stage_note(p->arena, stage, "largest residual: %s", result.solution.worst);
  end_stage(p, stage);
  return true;
}

/* The frames stand where the result does. */
static void lift_frames(pipeline *p, double lift) {
  lam_vec3 **lifted = LAM_NEW(p->arena, lam_vec3 *, p->model->frame_count);
  for (int k = 0; k < p->model->frame_count; k++) {
    lifted[k] = LAM_NEW(p->arena, lam_vec3, p->net->mesh.vertex_count);
    for (int v = 0; v < p->net->mesh.vertex_count; v++)
      lifted[k][v] = lam_add(p->model->frames[k][v], lam_v3(0, 0, lift));
  }
  p->model->frames = (const lam_vec3 *const *)lifted;
}

static bool make_net(pipeline *p) {
  const lam_design *design = p->design;
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;
  const lam_net_common *common = kind ? design->net.common : NULL;
  if (!kind && !design->surface.head) return true; /* nothing but sheets or a picture */
  lam_mesh mesh;
  lam_place place = kind ? design->net.place : design->surface.place;
  p->net = LAM_NEW(p->arena, lam_net, 1);
  bool made = initial_mesh(p, kind, common, &mesh);
  if (made) p->sampled = mesh.vertex_count;
  if (!made || !refine(p, &mesh, common, place)) return false;
  if (kind) {
    if (common->noise > 0)
      lam_mesh_perturb(&p->net->mesh, common->noise * lam_net_mean_edge(p->net, p->net->mesh.vertices), common->seed);
    if (!solve_net(p, kind, common)) return false;
    const lam_surface_place *placing = design->surface.head ? design->surface.common : NULL;
    bool held = common->handles.count > 0 || common->boundary != LAM_BOUNDARY_FREE || common->reference_given;
    if (placing && placing->ground && !held) {
      double lift = lam_mesh_ground(&p->net->mesh);
      p->placed.lift += lift;
      lift_frames(p, lift);
    }
  }
  p->normals = LAM_NEW(p->arena, lam_vec3, p->net->mesh.vertex_count);
  lam_net_normals(p->net, p->net->mesh.vertices, p->normals);
  p->model->net = &p->net->mesh;
  p->model->polyline_count = p->net->polyline_count;
  p->model->polylines = p->net->polylines;
  return true;
}

/* ---- the surface ---- */

static bool make_surface(pipeline *p) {
  const lam_row *row = &p->design->surface;
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  int before = p->errors->count;
  if (!kind) return true;
  if (kind->reads_file && p->loader && p->loader->surface) {
    lam_surface_source *source = row->params;
    lam_spline_surface *surface = LAM_NEW(p->arena, lam_spline_surface, 1);
    if (!p->loader->surface(p->loader->context, p->arena, source->file, source->face, row->place, p->errors, surface,
                            &source->note))
      return false;
    source->surface = surface;
  }
  lam_sides_keys *sides = kind->sides ? kind->sides(row->params) : NULL;
  if (sides && sides->file && p->loader && p->loader->curves &&
      !p->loader->curves(p->loader->context, p->arena, sides->file, row->place, p->errors, &sides->read_count,
                         &sides->read))
    return false;
  lam_point_file *cloud = kind->points ? kind->points(row->params) : NULL;
  if (cloud && cloud->file && p->loader && p->loader->points &&
      !p->loader->points(p->loader->context, p->arena, cloud->file, row->place, p->errors, &cloud->count,
                         &cloud->points))
    return false;
  p->surface = lam_surface_make(p->arena, row, p->errors);
  return p->errors->count == before;
}

static void report_surface(pipeline *p) {
  const lam_surface_kind *kind = p->surface.kind;
  if (!kind || !kind->report) return;
  lam_stage *stage = begin_stage(p, lam_arena_printf(p->arena, "surface: %s", kind->head.name));
  kind->report(p->arena, p->surface.data, stage);
}

/* The surface for parts and writers, where the net is. */
static void keep_spline(pipeline *p, lam_workshop *workshop) {
  const lam_surface_kind *kind = p->surface.kind;
  const lam_spline_surface *from = kind && kind->spline ? kind->spline(p->surface.data) : NULL;
  if (!from || !p->net) return;
  lam_spline_surface to = *from;
  int count = to.count[0] * to.count[1];
  lam_vec3 *points = LAM_NEW(p->arena, lam_vec3, count);
  for (int i = 0; i < count; i++) points[i] = lam_siting_apply(&p->placed, from->points[i]);
  to.points = points;
  to.name = "surface";
  lam_workshop_surface(workshop, to);
}

/* The lines of the net as curves, where no part has given axes. They are named as lamellas would be. */
static void keep_lines(const pipeline *p, lam_workshop *workshop) {
  int numbers[2] = {0};
  if (!p->net || !p->design->net.head || workshop->curve_count) return;
  for (int i = 0; i < p->net->polyline_count; i++) {
    const lam_polyline *line = &p->net->polylines[i];
    lam_workshop_curve(workshop, lam_arena_printf(p->arena, "%c%02d", 'A' + line->family, ++numbers[line->family]),
                       line);
  }
}

/* ---- prints ---- */

static bool make_print(pipeline *p, const lam_workshop *workshop) {
  const lam_texture_keys *keys = &p->design->texture;
  if (!p->design->has_texture) return true;
  if (!workshop->surface_count) {
    lam_error_add(p->errors, (lam_place){.file = p->design->path}, "texture",
                  "there is no spline surface to print on; expected a surface such as developable, bezier or nurbs");
    return false;
  }
  lam_stage *stage = begin_stage(p, "texture");
  lam_print *print =
      lam_print_make(p->arena, workshop->surfaces, (lam_motif)keys->motif, (lam_print_layout)keys->layout, keys->cells);
  for (int i = 0; i < print->count; i++) {
    const lam_printed *sheet = &print->sheets[i];
    if (strchr(sheet->name, '-')) continue; /* the same print, laid flat */
    lam_stage_measure(p->arena, stage, lam_arena_printf(p->arena, "distortion_%s", sheet->name), "", sheet->max_stretch,
                      sheet->mean_stretch, sheet->mesh.triangle_count);
  }
  p->model->print = print;
  end_stage(p, stage);
  return true;
}

/* ---- color maps ---- */

/* Lets measures see the surface when the vertices are where they were sampled, to a billionth of the net's size. */
static void relate_to_surface(pipeline *p) {
  const lam_vec2 *at = p->placed.parameters;
  const lam_mesh *mesh = &p->net->mesh;
  if (!at || p->sampled != mesh->vertex_count) return;
  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_jet jet;
    lam_surface_eval(&p->surface, at[v].x, at[v].y, &jet);
    if (!(lam_distance(lam_siting_apply(&p->placed, jet.x), mesh->vertices[v]) <= 1e-9 * lam_distance(low, high)))
      return;
  }
  p->measuring.surface = &p->surface;
  p->measuring.parameters = at;
  p->measuring.surface_scale = p->placed.scale;
}

static bool make_maps(pipeline *p) {
  const lam_list *plots = &p->design->plots;
  int before = p->errors->count;
  lam_place place = {.file = p->design->path};
  lam_measures_check(plots, true, place, "plots", p->errors);
  if (plots->count && !p->net)
    lam_error_add(p->errors, place, "plots", "there is no net to plot; expected a surface or a net");
  if (p->errors->count > before) return false;
  if (!p->measuring.net && plots->count) p->measuring = lam_measuring_of(p->arena, p->net, p->net->mesh.vertices);
  if (plots->count) relate_to_surface(p);
  p->model->map_count = plots->count;
  if (plots->count) p->model->maps = lam_net_maps(&p->measuring, plots);
  return true;
}

/* ---- where it stands ---- */

/* Supports: boundary vertices that no neighbor is lower than, within a fiftieth of the height above the lowest. */
static void find_supports(pipeline *p) {
  const lam_net *net = p->net;
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 low, high;
  lam_points_bounds(x, net->mesh.vertex_count, &low, &high);
  lam_vec3 *supports = LAM_NEW(p->arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    bool lowest = net->boundary[v] && x[v].z <= low.z + .02 * (high.z - low.z);
    for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) lowest &= x[net->ring[i]].z >= x[v].z;
    if (lowest) supports[p->model->support_count++] = x[v];
  }
  p->model->supports = supports;
}

/* ---- parts and sheets ---- */

static bool make_parts(pipeline *p, lam_workshop *workshop) {
  const lam_list *parts = &p->design->parts;
  int before = p->errors->count;
  if (parts->count && !p->net) {
    lam_error_add(p->errors, ((const lam_row *)parts->items)->place, "parts", "there is no net to make parts from");
    return false;
  }
  for (int i = 0; i < parts->count; i++) {
    const lam_row *row = (const lam_row *)parts->items + i;
    const lam_part_kind *kind = (const lam_part_kind *)row->head;
    lam_progress_tell(p->progress, kind->head.name, (double)i / parts->count, "");
    kind->make(workshop, row->params, row->place);
    if (p->errors->count > before) return false;
  }
  if (parts->count) lam_workshop_clash(workshop);
  return p->errors->count == before;
}

static bool make_sheets(pipeline *p, const lam_workshop *workshop) {
  const lam_sheet_keys *keys = &p->design->sheets;
  bool any = false;
  for (int i = 0; i < workshop->part_count; i++) any |= workshop->parts[i].flat != NULL;
  if (!any) return true;
  int before = p->errors->count;
  lam_stage *stage = begin_stage(p, "sheets");
  lam_sheet_options options = {{keys->stock[0], keys->stock[1]}, keys->kerf, keys->margin, keys->spacing};
  lam_sheets sheets = lam_sheets_make(p->arena, workshop->parts, workshop->part_count, options,
                                      (lam_place){.file = p->design->path}, p->errors);
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
  end_stage(p, stage);
  return true;
}

static void collect_report(pipeline *p, const lam_workshop *workshop) {
  lam_report *report = LAM_NEW(p->arena, lam_report, 1);
  report->stages = LAM_NEW(p->arena, lam_stage, p->stage_count + workshop->stage_count);
  int own = 0;
  while (own < p->stage_count && strcmp(p->stages[own].name, "sheets") != 0)
    report->stages[report->stage_count++] = p->stages[own++];
  for (int i = 0; i < workshop->stage_count; i++) report->stages[report->stage_count++] = workshop->stages[i];
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
  *model = (lam_model){.name = design->name, .title = design->title, .source = design->source, .version = LAM_VERSION};
  pipeline p = {
      .arena = arena, .design = design, .loader = loader, .progress = progress, .errors = errors, .model = model};
  if (!make_surface(&p)) return false;
  report_surface(&p);
  if (!make_net(&p) || !make_maps(&p)) return false;
  lam_workshop *workshop = LAM_NEW(arena, lam_workshop, 1);
  *workshop =
      (lam_workshop){.arena = arena, .errors = errors, .progress = progress, .net = p.net, .normals = p.normals};
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
    model->picture = (lam_picture){design->render.setting, design->render.view, design->render.size[0],
                                   design->render.size[1], design->render.quality};
  collect_report(&p, workshop);
  return true;
}
