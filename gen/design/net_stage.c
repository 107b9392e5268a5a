/* The stage that makes the net: the initial mesh, its changes (diagonals, coarser, finer), and the
 * solver. Called by pipeline_run.c. */
#include "core/memory.h"
#include "design/stages.h"
#include "mesh/coarsen.h"
#include "mesh/diagonalize.h"
#include "mesh/surface_normals.h"
#include "net/optimize.h"
#include "net/trace/trace.h"

#include <math.h>
#include <string.h>

enum { surface_grid = 32 }; /* cells of the mesh that stands for a surface without a net */

/* ---- the initial mesh ---- */

/* The mesh that was read for net.from; false, with a message, when the caller read none. key:
 * net.from.file or net.from.design, whose value is name. */
static bool read_mesh(lam_build *build, const char *key, const char *name, lam_mesh *mesh) {
  if (build->inputs->net) {
    *mesh = *build->inputs->net;
    lam_build_local_mesh(build, mesh);
    return true;
  }
  lam_error_add(build->errors, build->design->net.location, key, "%s was not read by this caller",
                name);
  return false;
}

/* The design asks for a net through a point or with a spacing (net.from), which only traced lines
 * have, and the surface has the lines in closed form. */
static bool refuse_trace_keys(lam_build *build, const lam_net_source *from, lam_chart chart) {
  lam_error_add(build->errors, build->design->net.location,
                from->at_given ? "net.from.at" : "net.from.spacing",
                "given, but %s has a formula for its %s lines; expected trace: yes beside it, or "
                "u and v of the surface instead",
                build->surface.kind->head.name, lam_chart_names[chart]);
  return false;
}

/* The mesh of the lines on the surface that net.from names, or that the net's kind starts from: by
 * formula where the surface has one, traced otherwise and where the design says so. */
static bool mesh_of_lines(lam_build *build, const lam_net_kind *kind, const lam_net_common *common,
                          lam_mesh *mesh) {
  const lam_net_source *from = &common->from;
  const lam_placement_keys *placing = build->design->surface.common;
  lam_location location = build->design->surface.location;
  lam_chart chart = from->lines ? (lam_chart)(from->lines - 1) : kind->chart;

  double ranges[2][2];
  bool closed[2];
  bool formula =
      chart < LAM_CHART_COUNT &&
      build->surface.kind->domain(build->surface.data, chart, ranges[0], ranges[1], closed);
  if (formula && !from->trace) {
    if (from->at_given || from->spacing != 0) return refuse_trace_keys(build, from, chart);
    return lam_net_start(build->arena, &build->surface, chart, common->grid, common->hole, placing,
                         location, build->errors, mesh, &build->placement);
  }

  lam_trace_options options = {from->at_given ? from->at : NULL, from->spacing, from->base};
  return lam_net_start_traced(build->arena, &build->surface, chart, common->grid, common->hole,
                              &options, placing, build->design->net.location, build->errors, mesh,
                              &build->placement);
}

/* The mesh that the net's kind makes by itself. A surface beside it is a mistake, which is told
 * together with those of the start. */
static bool mesh_of_kind(lam_build *build, const lam_net_kind *kind, const lam_net_common *common,
                         lam_mesh *mesh) {
  const lam_design *design = build->design;
  if (design->surface.head)
    lam_error_add(build->errors, design->surface.location, "surface",
                  "given, but %s makes its own start; expected none", kind->head.name);
  return kind->start(build->arena, design->net.params, common->grid, design->net.location,
                     build->errors, mesh) &&
         !design->surface.head;
}

/* A plain grid on the parameter lines, for a surface without a net. */
static bool mesh_of_surface(lam_build *build, lam_mesh *mesh) {
  static const int grid[2] = {surface_grid, surface_grid};
  const lam_row *row = &build->design->surface;
  return lam_net_start(build->arena, &build->surface, LAM_CHART_NATURAL, grid, 0, row->common,
                       row->location, build->errors, mesh, &build->placement);
}

/* Where the net starts: what is read goes before what the kind makes, and that before the surface.
 * kind and common are NULL for a design without a net. */
static bool initial_mesh(lam_build *build, const lam_net_kind *kind, const lam_net_common *common,
                         lam_mesh *mesh) {
  const lam_design *design = build->design;
  if (common && common->from.file)
    return read_mesh(build, "net.from.file", common->from.file, mesh);
  if (common && common->from.design)
    return read_mesh(build, "net.from.design", common->from.design, mesh);
  if (kind && kind->start) return mesh_of_kind(build, kind, common, mesh);

  if (!design->surface.head) {
    lam_error_add(build->errors, design->net.location, "surface",
                  "not given; expected a surface, or net.from: {file: ...}");
    return false;
  }
  if (!(common ? mesh_of_lines(build, kind, common, mesh) : mesh_of_surface(build, mesh)))
    return false;
  lam_build_origin_of_surface(build);
  return true;
}

/* ---- what it takes ---- */

/* Bytes that building and solving a net of n vertices takes: the factor of a net has entries as n
 * log n. Measured on asymptotic nets: 9.6 kB a vertex of 100 x 100, 11.8 of 200 x 200, 11.6 of
 * 400 x 400. */
static double bytes_for(double n) { return n * (2000 + 600 * log2(fmax(n, 2))); }

/* Says before the work begins when it takes more memory than there is, and what would fit: by a
 * grid when the net is made of one (else NULL). */
static bool fits_memory(lam_build *build, double vertices, const int grid[2],
                        lam_location location) {
  double most = lam_memory_most(), share = 1;
  if (bytes_for(vertices) <= most) return true;
  while (bytes_for(share * vertices) > most) share *= 0.98;

  const char *fitting =
      grid ? lam_arena_printf(build->arena, "a grid of [%.0f, %.0f] would fit",
                              floor(sqrt(share) * grid[0]), floor(sqrt(share) * grid[1]))
           : lam_arena_printf(build->arena, "%.0f vertices would fit", floor(share * vertices));
  lam_error_add(build->errors, location, grid ? "net.grid" : "net",
                "%.0f vertices take about %.1f GB, and there are %.1f GB of memory; %s", vertices,
                bytes_for(vertices) / 1e9, most / 1e9, fitting);
  return false;
}

/* The same for the grid that a net is asked for, before a surface is sampled. */
static bool grid_fits_memory(lam_build *build, const lam_net_common *common,
                             lam_location location) {
  double cells = (double)common->grid[0] * common->grid[1];
  return fits_memory(build, cells, common->grid, location);
}

/* The same for what subdividing makes of the net: four faces of each, and about as many
 * vertices. */
static bool subdivision_fits_memory(lam_build *build, int times, lam_location location) {
  double faces = ldexp(build->net->mesh.face_count, 2 * times);
  return !times || fits_memory(build, faces, NULL, location);
}

/* ---- changes ---- */

/* Makes the mesh the net of the build. */
static bool build_net(lam_build *build, const lam_mesh *mesh, lam_location location) {
  return lam_net_build(build->arena, mesh, location, build->errors, build->net);
}

/* A change of the net was not possible; why: in words of mesh/. */
static bool refuse(lam_build *build, lam_location location, const char *key, const char *why) {
  lam_error_add(build->errors, location, key, "the net cannot be changed so: %s", why);
  return false;
}

/* Makes the net of the mesh, then changes it as the design says: diagonals, then every other line
 * left out, then subdivided. Each change needs the connectivity of the one before, which is built
 * anew. common: NULL for no changes. */
static bool refine(lam_build *build, lam_mesh *mesh, const lam_net_common *common,
                   lam_location location) {
  if (!build_net(build, mesh, location)) return false;
  if (!common) return true;

  if (common->diagonalize) {
    const char *why = lam_net_diagonalize(build->arena, build->net, mesh);
    if (why) return refuse(build, location, "net.diagonalize", why);
    if (!build_net(build, mesh, location)) return false;
  }

  for (int i = 0; i < common->coarsen; i++) {
    lam_coarse coarse;
    const char *why = lam_net_coarsen(build->arena, build->net, &coarse);
    if (why) return refuse(build, location, "net.coarsen", why);
    *mesh = coarse.mesh;
    if (!build_net(build, mesh, location)) return false;
  }

  if (!subdivision_fits_memory(build, common->subdivide, location)) return false;
  for (int i = 0; i < common->subdivide; i++) {
    *mesh = lam_net_four_point(build->arena, build->net);
    if (!build_net(build, mesh, location)) return false;
  }
  return true;
}

/* ---- the solver ---- */

/* What traced lines have reached, and a word where it is less than was asked for. A design that
 * asks for the coverage itself has it already. */
static void report_coverage(lam_build *build, const int grid[2], lam_stage *stage) {
  const lam_placement *placed = &build->placement;
  if (!placed->cells[0]) return;

  build->measuring.coverage = placed->coverage;
  lam_measure measure = lam_measure_summary(&lam_measure_coverage, &placed->coverage, 1);
  int m = 0;
  while (m < stage->measure_count && strcmp(stage->measures[m].name, measure.name) != 0) m++;
  if (m < stage->measure_count)
    stage->measures[m] = measure;
  else
    lam_stage_measure_add(build->arena, stage, measure);

  bool fewer = placed->cells[0] < grid[0] || placed->cells[1] < grid[1];
  if (fewer)
    lam_stage_note(build->arena, stage,
                   "%d x %d cells were traced of the %d x %d asked for: the lines reach no farther",
                   placed->cells[0], placed->cells[1], grid[0], grid[1]);
  if (placed->coverage < lam_enough_coverage)
    lam_stage_note(build->arena, stage,
                   "the net covers %.0f %% of the surface: its lines end, or come together, where "
                   "those of other parts begin. Another point (net.from.at) or smaller u and v "
                   "may cover more; net.from: {lines: natural} starts from all of it",
                   100 * placed->coverage);
}

/* The solver's verdict and what was measured, in the report. */
static void report_net(const lam_build *build, const lam_net_kind *kind,
                       const lam_net_result *result, lam_stage *stage) {
  const lam_mesh *mesh = &build->net->mesh;
  stage->name = lam_arena_printf(build->arena, "net: %s", kind->head.name);
  stage->converged = result->converged;
  stage->reason = result->reason;
  stage->iterations = result->solution.iterations;
  stage->residual = result->solution.residual;
  stage->measure_count = result->measure_count;
  stage->measures = result->measures;

  lam_stage_note(build->arena, stage, "%d vertices, %d faces, %d unknowns, %d equations",
                 mesh->vertex_count, mesh->face_count, result->solution.unknowns,
                 result->solution.residuals);
  lam_stage_note(build->arena, stage, "largest move from the start: %.3g mean edges",
                 result->drift);

  /* What is not always so. */
  lam_build_note_origin(build, stage);
  for (int i = 0; i < build->inputs->net_note_count; i++)
    lam_stage_note(build->arena, stage, "%s", build->inputs->net_notes[i]);
  if (result->levels)
    lam_stage_note(build->arena, stage, "%d coarser nets solved first", result->levels);
  if (result->skipped)
    lam_stage_note(build->arena, stage, "%ld irregular vertices left out", result->skipped);
  if (result->reference_weight > 0 && result->converged)
    lam_stage_note(build->arena, stage, "the reference was followed with a weight of %.3g",
                   result->reference_weight);
  if (result->hint) lam_stage_note(build->arena, stage, "%s", result->hint);
  if (!result->converged && result->solution.worst)
    lam_stage_note(build->arena, stage, "largest residual: %s", result->solution.worst);
}

/* Moves the net until the constraints of its kind hold. Not converging is no error: the report says
 * so. */
static bool solve_net(lam_build *build, const lam_net_kind *kind, const lam_net_common *common) {
  const lam_design *design = build->design;
  lam_stage *stage = lam_build_stage(build, "net");
  lam_net_job job = {.kind = kind,
                     .params = design->net.params,
                     .common = common,
                     .origin = build->model->origin,
                     .location = design->net.location,
                     .progress = build->progress};
  if (common->reference_given) job.reference = lam_build_local_reference(build);

  lam_net_result result;
  if (!lam_net_optimize(build->arena, &job, build->net, build->errors, &result)) return false;

  report_net(build, kind, &result, stage);
  build->measuring = result.measuring;
  report_coverage(build, common->grid, stage);
  build->model->frame_count = result.frame_count;
  build->model->frames = result.frames;
  lam_build_stage_end(build, stage);
  return true;
}

/* The frames of the animation stand where the result does: lift (meters) higher than they were. */
static void lift_frames(lam_build *build, double lift) {
  lam_vec3 **lifted = LAM_NEW(build->arena, lam_vec3 *, build->model->frame_count);
  for (int k = 0; k < build->model->frame_count; k++) {
    lifted[k] = LAM_NEW(build->arena, lam_vec3, build->net->mesh.vertex_count);
    for (int v = 0; v < build->net->mesh.vertex_count; v++)
      lifted[k][v] = lam_add(build->model->frames[k][v], lam_v3(0, 0, lift));
  }
  build->model->frames = (const lam_vec3 *const *)lifted;
}

/* Sets the solved net on the ground again where the surface stood on it (`ground`): the solver
 * moves what is free. A net that is held by handles, by its boundary or by a reference stays. */
static void set_on_ground(lam_build *build, const lam_net_common *common) {
  const lam_row *surface = &build->design->surface;
  const lam_placement_keys *placing = surface->head ? surface->common : NULL;
  bool held =
      common->handles.count > 0 || common->boundary != LAM_BOUNDARY_FREE || common->reference_given;
  if (!placing || !placing->ground || held) return;

  double lift = lam_mesh_ground(&build->net->mesh);
  build->placement.lift += lift;
  lift_frames(build, lift);
}

/* ---- the stage ---- */

/* Hands the finished net to the model; its normals are needed by parts. */
static void keep_net(lam_build *build) {
  lam_net *net = build->net;
  build->normals = LAM_NEW(build->arena, lam_vec3, net->mesh.vertex_count);
  lam_surface_normals(build->arena, net, net->mesh.vertices, build->normals);

  build->model->net = &net->mesh;
  build->model->polyline_count = net->polyline_count;
  build->model->polylines = net->polylines;
}

/* net is set even where making it fails: the build ends then. */
bool lam_build_start(lam_build *build) {
  const lam_design *design = build->design;
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;
  const lam_net_common *common = kind ? design->net.common : NULL;
  if (!kind && !design->surface.head) return true;

  lam_mesh mesh;
  lam_location location = kind ? design->net.location : design->surface.location;
  build->net = LAM_NEW(build->arena, lam_net, 1);
  if (kind && !lam_net_method_check(kind, common, location, build->errors)) return false;
  if (kind && !common->from.file && !grid_fits_memory(build, common, location)) return false;
  if (!initial_mesh(build, kind, common, &mesh)) return false;
  build->sampled = mesh.vertex_count;
  return refine(build, &mesh, common, location) &&
         (!kind || fits_memory(build, build->net->mesh.vertex_count, NULL, location));
}

/* A design without a net gets the plain mesh of its surface, which is not solved. */
bool lam_build_net(lam_build *build) {
  const lam_design *design = build->design;
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;
  const lam_net_common *common = kind ? design->net.common : NULL;
  if (!kind && !design->surface.head) return true; /* nothing but sheets or a picture */

  if (!lam_build_start(build)) return false;
  if (kind) {
    if (common->noise > 0) {
      double mean = lam_net_mean_edge(build->net, build->net->mesh.vertices);
      lam_mesh_perturb(&build->net->mesh, common->noise * mean, common->seed);
    }
    if (!solve_net(build, kind, common)) return false;
    set_on_ground(build, common);
  }

  keep_net(build);
  return true;
}
