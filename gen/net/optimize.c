#include "net/optimize.h"
#include "net/handles.h"
#include "net/measures/measure.h"
#include "net/multilevel.h"
#include "net/snapshots.h"

#include <math.h>
#include <string.h>

typedef struct attempt {
  lam_arena *arena;
  const lam_net_job *job;
  lam_net *net;
  lam_errors *errors;
  double unit;
  const lam_tree *tree;
  lam_trimesh reference; /* in solver units */
  int *handle_vertices;
  int levels;            /* coarser nets that were solved before */
  bool let_go;           /* handles with release: yes no longer hold */
  lam_snapshots *frames; /* NULL: none are kept */
  bool frame_per_step;   /* of the handles; else per iteration */
} attempt;

static void prepare_reference(attempt *a) {
  if (!a->job->reference) return;
  a->reference = *a->job->reference;
  a->reference.vertices = LAM_NEW(a->arena, lam_vec3, a->reference.vertex_count);
  for (int v = 0; v < a->reference.vertex_count; v++)
    a->reference.vertices[v] = lam_scale(a->job->reference->vertices[v], 1 / a->unit);
  lam_tree *tree = lam_tree_new(&a->reference);
  if (!tree)
    lam_error_add(a->errors, a->job->location, "net.reference",
                  "the mesh cannot be searched; it has no valid triangle");
  else
    lam_arena_defer(a->arena, lam_tree_free, tree);
  a->tree = tree;
}

static void fix_boundary(const attempt *a, lam_problem *problem, lam_scope *scope) {
  switch ((lam_boundary)a->job->common->boundary) {
  case LAM_BOUNDARY_FREE:
    break;
  case LAM_BOUNDARY_FIXED:
    for (int v = 0; v < problem->vertex_count; v++) problem->fixed[v] |= a->net->boundary[v];
    break;
  case LAM_BOUNDARY_GLIDE:
    lam_con_glide.add(scope, NULL, 1, a->job->location);
    break;
  }
}

static void add_handles(const attempt *a, lam_scope *scope, const lam_vec3 *start, double share) {
  const lam_list *handles = &a->job->common->handles;
  lam_vec3 *targets = LAM_NEW(a->arena, lam_vec3, handles->count);
  int *vertices = LAM_NEW(a->arena, int, handles->count), count = 0;
  for (int h = 0; h < handles->count; h++) {
    const lam_handle *handle = (const lam_handle *)handles->items + h;
    if (a->let_go && handle->release) continue;
    lam_vec3 to = lam_scale(lam_v3(handle->to[0], handle->to[1], handle->to[2]), 1 / a->unit);
    vertices[count] = a->handle_vertices[h];
    targets[count++] = lam_mix(start[a->handle_vertices[h]], to, share);
  }
  lam_closeness_add(scope, "handle", LAM_HARD, 1, count, vertices, targets);
}

/* Fairness and what fades with it. */
static void add_guide(const attempt *a, lam_scope *scope) {
  const lam_solver_keys *keys = &a->job->common->solver;
  lam_guide guide = a->job->kind->guide;
  if (keys->method == LAM_METHOD_THESIS) guide = (lam_guide){LAM_FAIR_POSITION, 0, 0};
  if (keys->fair_given) guide.fair = (lam_fair)keys->fair;
  if (keys->closeness_given) guide.closeness = keys->closeness;
  if (keys->stiffness_given) guide.stiffness = keys->stiffness;
  /* a fine net that starts from a solved coarse one needs less: closeness to it would keep its
   * creases */
  guide.closeness *= pow(.5, a->levels);
  lam_con_fairness.add(scope, &(lam_fairness_params){guide.fair}, 1, a->job->location);
  if (guide.closeness > 0) lam_con_closeness.add(scope, NULL, guide.closeness, a->job->location);
  if (guide.stiffness > 0)
    lam_edge_length_add(scope, "stiffness", LAM_FAIRNESS, guide.stiffness,
                        (lam_edge_length_params){0});
}

/* Where the solver begins when the start is noisy: near the start, with fair polylines. A held
 * boundary stays. */
static void smooth(const attempt *a, const lam_vec3 *start, lam_vec3 *positions) {
  lam_problem *problem = lam_problem_new(a->arena, a->net->mesh.vertex_count, start);
  lam_scope scope = {.problem = problem, .net = a->net, .unit = a->unit, .errors = a->errors};
  for (int v = 0; v < problem->vertex_count; v++)
    problem->fixed[v] = a->net->boundary[v] && a->job->common->boundary != LAM_BOUNDARY_FREE;
  lam_con_fairness.add(&scope, &(lam_fairness_params){LAM_FAIR_POSITION}, 1, a->job->location);
  lam_guided_smooth(problem, .3);
  lam_problem_positions(problem, positions);
}

/* More equations than unknowns may have no solution: the residual then stays above a floor,
 * whatever the solver does.
 */
static void explain(lam_arena *arena, const lam_problem *problem, lam_solution *solution) {
  int equations = 0;
  for (int b = 0; b < problem->block_count; b++)
    if (problem->blocks[b].role == LAM_HARD)
      equations += problem->blocks[b].count * problem->blocks[b].rows;
  if (equations > solution->unknowns)
    solution->reason = lam_arena_printf(arena, "%s (over-determined: %d equations for %d unknowns)",
                                        solution->reason, equations, solution->unknowns);
}

/* The net's own constraints where the vertices are now, in the form of the thesis. */
static void constrain_by_thesis(const attempt *a, lam_scope *scope) {
  const lam_net_job *job = a->job;
  if (job->kind->constrain_thesis) {
    job->kind->constrain_thesis(scope, job->params, job->location);
    return;
  }
  const char *names = "";
  for (int i = 0; i < lam_nets.count; i++)
    if (((const lam_net_kind *)lam_nets.rows[i])->constrain_thesis)
      names =
          lam_arena_printf(a->arena, "%s%s%s", names, *names ? ", " : "", lam_nets.rows[i]->name);
  lam_error_add(
      a->errors, job->location, "net.solver",
      "thesis, but %s has no form with auxiliary unknowns; expected lamella, or one of the nets %s",
      job->kind->head.name, names);
}

/* Table 3.2 of the thesis: fairness of positions, .01 -> 0 or none, and nothing else that guides.
 */
static const double thesis_fairness = .01;

/* One solve from positions (in solver units), with handles moved by the given share of their way.
 * What a constraint keeps (a length, the boundary curve) is that of the start; what guides is the
 * place where this solve begins. */
static lam_solution solve(attempt *a, lam_vec3 *positions, const lam_vec3 *start, double share,
                          long *skipped) {
  const lam_net_job *job = a->job;
  const lam_net_common *common = job->common;
  lam_problem *problem = lam_problem_new(a->arena, a->net->mesh.vertex_count, start);
  lam_scope scope = {problem, a->net, a->unit, a->tree, &a->reference, a->errors, 0};
  bool thesis = common->solver.method == LAM_METHOD_THESIS;
  if (!thesis) job->kind->constrain(&scope, job->params, job->location);
  for (int i = 0; i < common->constraints.count; i++) {
    const lam_row *row = (const lam_row *)common->constraints.items + i;
    ((const lam_constraint_kind *)row->head)->add(&scope, row->params, 1, row->location);
  }
  fix_boundary(a, problem, &scope);
  memcpy(problem->x, positions, sizeof *positions * (size_t)problem->vertex_count);
  if (thesis)
    constrain_by_thesis(a, &scope); /* auxiliary unknowns start from the vertices' places */
  add_handles(a, &scope, start, share);
  if (job->reference) lam_con_proximity.add(&scope, NULL, common->reference.weight, job->location);
  lam_schedule schedule = job->kind->schedule;
  if (thesis) schedule.fairness = fmin(schedule.fairness, thesis_fairness);
  if (common->solver.fairness_given) schedule.fairness = common->solver.fairness;
  if (common->solver.tolerance_given) schedule.tolerance = common->solver.tolerance;
  schedule.max_iterations = common->solver.iterations;
  lam_solution none = {.reason = "not solved"};
  if (a->errors->count) return none;
  if (a->let_go) schedule.fairness = 0;
  if (schedule.fairness > 0) add_guide(a, &scope);
  lam_progress watching = {0};
  if (a->frames) {
    a->frames->problem = a->frame_per_step ? NULL : problem;
    a->frames->next = job->progress;
    watching = lam_snapshots_progress(a->frames);
  }
  const lam_progress *progress = a->frames ? &watching : job->progress;
  lam_solution solution =
      thesis ? lam_gauss_newton_solve(problem, &schedule, common->solver.epsilon, progress)
             : lam_guided_solve(problem, &schedule, progress);
  if (!solution.converged && !thesis) explain(a->arena, problem, &solution);
  lam_problem_positions(problem, positions);
  *skipped = scope.skipped;
  return solution;
}

static bool any_released(const lam_list *handles) {
  bool any = false;
  for (int h = 0; h < handles->count; h++) any |= ((const lam_handle *)handles->items)[h].release;
  return any;
}

/* Handles on the coarse net: each moves the vertex next to it by its own displacement. */
static lam_list coarse_handles(const attempt *a, const lam_level *coarse) {
  const lam_list *handles = &a->job->common->handles;
  lam_handle *out = LAM_NEW(a->arena, lam_handle, handles->count);
  int count = 0;
  for (int h = 0; h < handles->count; h++) {
    lam_handle handle = ((const lam_handle *)handles->items)[h];
    int v = a->handle_vertices[h], near = coarse->nearest[v];
    bool taken = a->job->common->boundary == LAM_BOUNDARY_FIXED && coarse->net.boundary[near];
    for (int k = 0; k < count; k++) taken |= out[k].vertex[0] == near;
    if (taken) continue;
    lam_vec3 away = lam_sub(coarse->net.mesh.vertices[near], a->net->mesh.vertices[v]);
    handle.vertex[0] = near;
    handle.vertex[1] = -1;
    handle.to[0] += away.x, handle.to[1] += away.y, handle.to[2] += away.z;
    out[count++] = handle;
  }
  return (lam_list){count, out};
}

/* Solves a coarser net first, when there is one, and puts its refined solution into x (solver
 * units). */
static bool begin_coarse(attempt *a, const lam_vec3 *start, lam_vec3 *x, lam_net_result *result) {
  const lam_net_common *common = a->job->common;
  int levels = common->levels_given ? common->levels : a->job->kind->levels;
  for (int i = 0; i < common->constraints.count;
       i++) /* a constraint on a vertex by its number is for this net alone */
    if (((const lam_row *)common->constraints.items)[i].head == &lam_con_handle.head) levels = 0;
  lam_level coarse;
  if (levels < 1 || !lam_level_make(a->arena, a->net, common->levels_given ? 4 : 64, &coarse))
    return true;
  lam_net_common keys = *common;
  lam_net_job job = *a->job;
  keys.handles = coarse_handles(a, &coarse);
  keys.levels = levels - 1;
  keys.animate = 0;
  keys.levels_given = common->levels_given;
  job.common = &keys;
  lam_net_kind kind = *job.kind;
  kind.levels = levels - 1;
  job.kind = &kind;
  if (!lam_net_optimize(a->arena, &job, &coarse.net, a->errors, result)) return false;
  lam_vec3 *refined = LAM_NEW(a->arena, lam_vec3, a->net->mesh.vertex_count);
  lam_level_refine(a->arena, &coarse, refined);
  for (int v = 0; v < a->net->mesh.vertex_count; v++) {
    bool held = common->boundary == LAM_BOUNDARY_FIXED && a->net->boundary[v];
    x[v] = held ? start[v] : lam_scale(refined[v], 1 / a->unit);
  }
  result->levels++;
  return true;
}

bool lam_net_optimize(lam_arena *arena, const lam_net_job *job, lam_net *net, lam_errors *errors,
                      lam_net_result *result) {
  int n = net->mesh.vertex_count, steps = 1, before = errors->count;
  *result = (lam_net_result){0};
  attempt a = {.arena = arena, .job = job, .net = net, .errors = errors};
  a.unit = lam_net_mean_edge(net, net->mesh.vertices);
  if (!(a.unit > 0) || !isfinite(a.unit)) {
    lam_error_add(errors, job->location, "net",
                  "the initial mesh has no extent; expected edges longer than 0");
    return false;
  }
  prepare_reference(&a);
  lam_net_common common = *job->common;
  lam_net_job resolved = *job;
  common.handles =
      lam_handles_resolve(arena, job->common, net, net->mesh.vertices, job->location, errors);
  resolved.common = &common;
  a.job = &resolved;
  const lam_list *handles = &common.handles;
  a.handle_vertices = LAM_NEW(arena, int, handles->count);
  for (int h = 0; h < handles->count; h++) {
    const lam_handle *handle = (const lam_handle *)handles->items + h;
    a.handle_vertices[h] = handle->vertex[0];
    if (handle->steps > steps) steps = handle->steps;
  }
  if (errors->count > before) return false;
  lam_vec3 *start = LAM_NEW(arena, lam_vec3, n), *x = LAM_NEW(arena, lam_vec3, n),
           *begin = LAM_NEW(arena, lam_vec3, n);
  memcpy(begin, net->mesh.vertices, sizeof *begin * (size_t)n);
  for (int v = 0; v < n; v++) start[v] = x[v] = lam_scale(net->mesh.vertices[v], 1 / a.unit);
  if (!begin_coarse(&a, start, x, result)) return false;
  a.levels = result->levels;
  if (a.levels > 0)
    steps = 1;
  else if (job->common->solver.smooth)
    smooth(&a, start, x);
  lam_snapshots frames;
  if (job->common->animate > 0) {
    frames = lam_snapshots_new(arena, job->common->animate, n, a.unit);
    a.frames = &frames;
    a.frame_per_step = steps > 1;
    lam_snapshots_add(&frames, start);
  }
  int iterations = result->solution.iterations;
  for (int step = 1; step <= steps + any_released(handles); step++) {
    a.let_go = step > steps;
    result->solution = solve(&a, x, start, fmin(1, (double)step / steps), &result->skipped);
    iterations += result->solution.iterations;
    if (errors->count > before) return false;
    if (a.frames && a.frame_per_step) lam_snapshots_add(a.frames, x);
  }
  result->solution.iterations = iterations;
  result->degenerate = lam_net_degenerate(arena, net, start, x);
  result->converged = result->solution.converged && !result->degenerate;
  result->reason = result->degenerate ? result->degenerate : result->solution.reason;
  result->drift = 0;
  for (int v = 0; v < n; v++) {
    result->drift = fmax(result->drift, lam_distance(x[v], start[v]));
    net->mesh.vertices[v] = lam_scale(x[v], a.unit);
  }
  if (a.frames) result->frames = lam_snapshots_finish(arena, &frames, x, &result->frame_count);
  lam_net_measure_result(arena, job, net, begin, result);
  return true;
}
