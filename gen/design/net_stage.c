/* The stage that makes the net. */
#include "core/solid/triangles.h"
#include "design/stages.h"
#include "mesh/coarsen.h"
#include "mesh/diagonalize.h"
#include "net/optimize.h"
#include "net/trace/trace.h"

#include <math.h>
#include <string.h>

enum { surface_grid = 32 }; /* cells of the mesh that stands for a surface without a net */

/* ---- the initial net ---- */

/* The mesh that was read for net.from. */
static bool read_mesh(lam_build *p, const char *key, const char *name, lam_mesh *mesh) {
  if (p->inputs->net) {
    *mesh = *p->inputs->net;
    return true;
  }
  lam_error_add(p->errors, p->design->net.location, key, "%s was not read by this caller", name);
  return false;
}

/* The lines of the surface that the net asks for, by formula or traced. */
static bool start_net(lam_build *p, const lam_net_kind *kind, const lam_net_common *common,
                      lam_mesh *mesh) {
  const lam_net_source *from = &common->from;
  const lam_placement_keys *placing = p->design->surface.common;
  lam_location location = p->design->surface.location;
  lam_chart chart = from->lines ? (lam_chart)(from->lines - 1) : kind->chart;
  double ranges[2][2];
  bool closed[2],
      formula = chart < LAM_CHART_COUNT &&
                p->surface.kind->domain(p->surface.data, chart, ranges[0], ranges[1], closed);
  if (formula && !from->trace) {
    if (!from->at_given && from->spacing == 0)
      return lam_net_start(p->arena, &p->surface, chart, common->grid, common->hole, placing,
                           location, p->errors, mesh, &p->placement);
    lam_error_add(p->errors, p->design->net.location,
                  from->at_given ? "net.from.at" : "net.from.spacing",
                  "given, but %s has a formula for its %s lines; expected trace: yes beside it, or "
                  "u and v of the "
                  "surface instead",
                  p->surface.kind->head.name, lam_chart_names[chart]);
    return false;
  }
  lam_trace_options options = {from->at_given ? from->at : NULL, from->spacing, from->base};
  return lam_net_start_traced(p->arena, &p->surface, chart, common->grid, common->hole, &options,
                              placing, p->design->net.location, p->errors, mesh, &p->placement);
}

static bool initial_mesh(lam_build *p, const lam_net_kind *kind, const lam_net_common *common,
                         lam_mesh *mesh) {
  const lam_design *design = p->design;
  if (common && common->from.file) return read_mesh(p, "net.from.file", common->from.file, mesh);
  if (common && common->from.design)
    return read_mesh(p, "net.from.design", common->from.design, mesh);
  if (kind && kind->start) {
    if (design->surface.head)
      lam_error_add(p->errors, design->surface.location, "surface",
                    "given, but %s makes its own start; expected none", kind->head.name);
    return kind->start(p->arena, design->net.params, common->grid, design->net.location, p->errors,
                       mesh) &&
           !design->surface.head;
  }
  if (!design->surface.head) {
    lam_error_add(p->errors, design->net.location, "surface",
                  "not given; expected a surface, or net.from: {file: ...}");
    return false;
  }
  const lam_placement_keys *placing = design->surface.common;
  static const int coarse[2] = {surface_grid, surface_grid};
  if (common) return start_net(p, kind, common, mesh);
  return lam_net_start(p->arena, &p->surface, LAM_CHART_NATURAL, coarse, 0, placing,
                       design->surface.location, p->errors, mesh, &p->placement);
}

static bool build_net(lam_build *p, const lam_mesh *mesh, lam_location location) {
  return lam_net_build(p->arena, mesh, location, p->errors, p->net);
}

static bool refuse(lam_build *p, lam_location location, const char *key, const char *why) {
  lam_error_add(p->errors, location, key, "the net cannot be changed so: %s", why);
  return false;
}

/* Diagonals, then every other line left out, then subdivided. */
static bool refine(lam_build *p, lam_mesh *mesh, const lam_net_common *common,
                   lam_location location) {
  if (!build_net(p, mesh, location)) return false;
  if (!common) return true;
  if (common->diagonalize) {
    const char *why = lam_net_diagonalize(p->arena, p->net, mesh);
    if (why) return refuse(p, location, "net.diagonalize", why);
    if (!build_net(p, mesh, location)) return false;
  }
  for (int i = 0; i < common->coarsen; i++) {
    lam_coarse coarse;
    const char *why = lam_net_coarsen(p->arena, p->net, &coarse);
    if (why) return refuse(p, location, "net.coarsen", why);
    *mesh = coarse.mesh;
    if (!build_net(p, mesh, location)) return false;
  }
  for (int i = 0; i < common->subdivide; i++) {
    *mesh = lam_net_four_point(p->arena, p->net);
    if (!build_net(p, mesh, location)) return false;
  }
  return true;
}

static bool solve_net(lam_build *p, const lam_net_kind *kind, const lam_net_common *common) {
  const lam_design *design = p->design;
  lam_stage *stage = lam_build_stage(p, "net");
  lam_net_job job = {kind, design->net.params, common, NULL, design->net.location, p->progress};
  if (common->reference_given) job.reference = p->inputs->reference;
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
  lam_stage_note(p->arena, stage, "%d vertices, %d faces, %d unknowns, %d equations",
                 p->net->mesh.vertex_count, p->net->mesh.face_count, result.solution.unknowns,
                 result.solution.residuals);
  lam_stage_note(p->arena, stage, "largest move from the start: %.3g mean edges", result.drift);
  if (result.levels) lam_stage_note(p->arena, stage, "%d coarser nets solved first", result.levels);
  p->model->frame_count = result.frame_count;
  p->model->frames = result.frames;
  if (result.skipped)
    lam_stage_note(p->arena, stage, "%ld irregular vertices left out", result.skipped);
  if (!result.converged && result.solution.worst)
    lam_stage_note(p->arena, stage, "largest residual: %s", result.solution.worst);
  lam_build_stage_end(p, stage);
  return true;
}

/* The frames stand where the result does. */
static void lift_frames(lam_build *p, double lift) {
  lam_vec3 **lifted = LAM_NEW(p->arena, lam_vec3 *, p->model->frame_count);
  for (int k = 0; k < p->model->frame_count; k++) {
    lifted[k] = LAM_NEW(p->arena, lam_vec3, p->net->mesh.vertex_count);
    for (int v = 0; v < p->net->mesh.vertex_count; v++)
      lifted[k][v] = lam_add(p->model->frames[k][v], lam_v3(0, 0, lift));
  }
  p->model->frames = (const lam_vec3 *const *)lifted;
}

bool lam_build_net(lam_build *p) {
  const lam_design *design = p->design;
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;
  const lam_net_common *common = kind ? design->net.common : NULL;
  if (!kind && !design->surface.head) return true; /* nothing but sheets or a picture */
  lam_mesh mesh;
  lam_location location = kind ? design->net.location : design->surface.location;
  p->net = LAM_NEW(p->arena, lam_net, 1);
  bool made = initial_mesh(p, kind, common, &mesh);
  if (made) p->sampled = mesh.vertex_count;
  if (!made || !refine(p, &mesh, common, location)) return false;
  if (kind) {
    if (common->noise > 0)
      lam_mesh_perturb(&p->net->mesh,
                       common->noise * lam_net_mean_edge(p->net, p->net->mesh.vertices),
                       common->seed);
    if (!solve_net(p, kind, common)) return false;
    const lam_placement_keys *placing = design->surface.head ? design->surface.common : NULL;
    bool held = common->handles.count > 0 || common->boundary != LAM_BOUNDARY_FREE ||
                common->reference_given;
    if (placing && placing->ground && !held) {
      double lift = lam_mesh_ground(&p->net->mesh);
      p->placement.lift += lift;
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
