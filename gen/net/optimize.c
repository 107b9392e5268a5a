/* The optimization of a net: from a kind's constraints, a start, handles and a reference to
 * final positions and a verdict. Called by design/net_stage.c and bench/bench_run.c, and by
 * itself for coarser nets. The solver is solve/guided.c; what each kind demands stands in its
 * own file under net/kinds. */
#include "net/optimize.h"
#include "net/handles.h"
#include "net/measures/measure.h"
#include "net/multilevel.h"
#include "net/snapshots.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Weights of the reference where the design gives none: which one is tried first; the least and the
 * most; by how much it falls and grows. */
static const double first_weight = 1e-3, least_weight = 1e-6, most_weight = .1;
static const double weight_falls = .1, weight_grows = 3.1622776601683795;

/* One net on its way from its start to its solution. Positions per vertex are in solver units
 * (the mean edge of the start is 1) unless meters are said. */
typedef struct optimization {
  lam_arena *arena;
  const lam_net_job *job;
  const lam_net_common *keys; /* of the job */
  lam_net *net;               /* its vertices are those of the start, meters, until the end */
  lam_errors *errors;

  double unit;                    /* meters per solver unit */
  lam_vec3 *start_in_meters;      /* where it starts */
  lam_vec3 *start;                /* the same in solver units */
  lam_vec3 *x;                    /* where it is now */
  lam_trimesh reference;          /* of the job; empty: none */
  const lam_tree *reference_tree; /* NULL: none */

  lam_list handles;        /* of lam_handle, resolved to a vertex and a goal in meters each */
  int handle_steps;        /* solves until the handles have come all their way */
  int steps;               /* the same, and one more when any handle lets go in the end */
  double reference_weight; /* in this step; 0: there is none */
  double share;            /* in this step: part of their way that the handles have gone */
  bool let_go;             /* in this step: handles with release: yes no longer hold */
  int demanded;            /* in this step: equations of hard constraints */

  int levels;            /* coarser nets that were solved before */
  lam_snapshots *frames; /* NULL: none are kept */
  bool frame_per_step;   /* of the handles; else per iteration of the solver */
} optimization;

/* ---- preparation ---- */

/* The reference in solver units and its search tree, where the job has one. */
static void prepare_reference(optimization *o) {
  const lam_trimesh *given = o->job->reference;
  if (!given) return;

  o->reference = *given;
  o->reference.vertices = LAM_NEW(o->arena, lam_vec3, given->vertex_count);
  for (int v = 0; v < given->vertex_count; v++)
    o->reference.vertices[v] = lam_scale(given->vertices[v], 1 / o->unit);

  lam_status status;
  lam_tree *tree = lam_tree_new(&o->reference, &status);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(o->arena);
  if (!tree)
    lam_error_add(o->errors, o->job->location, "net.reference",
                  "the mesh cannot be searched; it has no valid triangle");
  else
    lam_arena_defer(o->arena, lam_tree_free, tree);
  o->reference_tree = tree;
}

/* Copies of the start's positions: what the solver moves, and what it is compared with. */
static void prepare_positions(optimization *o) {
  const lam_mesh *mesh = &o->net->mesh;
  int n = mesh->vertex_count;
  o->start_in_meters = LAM_NEW(o->arena, lam_vec3, n);
  o->start = LAM_NEW(o->arena, lam_vec3, n);
  o->x = LAM_NEW(o->arena, lam_vec3, n);
  memcpy(o->start_in_meters, mesh->vertices, sizeof *mesh->vertices * (size_t)n);
  for (int v = 0; v < n; v++) o->start[v] = o->x[v] = lam_scale(mesh->vertices[v], 1 / o->unit);
}

/* Fills what all steps need. False, with errors: the input is wrong. */
static bool prepare(optimization *o) {
  int errors_before = o->errors->count;
  o->unit = lam_net_mean_edge(o->net, o->net->mesh.vertices);
  if (!(o->unit > 0) || !isfinite(o->unit)) {
    lam_error_add(o->errors, o->job->location, "net",
                  "the initial mesh has no extent; expected edges longer than 0");
    return false;
  }

  prepare_reference(o);
  o->reference_weight = o->keys->reference.weight_given ? o->keys->reference.weight : first_weight;
  lam_net_common keys = *o->keys;
  keys.handles = lam_handles_moved(o->arena, keys.handles, o->job->origin);
  o->handles = lam_handles_resolve(o->arena, &keys, o->net, o->net->mesh.vertices, o->job->location,
                                   o->errors);
  if (o->errors->count > errors_before) return false;

  prepare_positions(o);
  return true;
}

/* ---- where the solver begins ---- */

/* Coarser nets to be solved first. A handle in the list of constraints names a vertex of this net
 * by its number, which means nothing on a coarser one: none then. */
static int wanted_levels(const optimization *o) {
  const lam_list *constraints = &o->keys->constraints;
  for (int i = 0; i < constraints->count; i++)
    if (((const lam_row *)constraints->items)[i].head == &lam_con_handle.head) return 0;
  return o->keys->levels_given ? o->keys->levels : o->job->kind->levels;
}

/* Handles on the coarse net: each moves the vertex next to it by its own displacement. Left out
 * are those whose coarse vertex is held, or has a handle already. */
static lam_list coarse_handles(const optimization *o, const lam_level *coarse) {
  lam_handle *out = LAM_NEW(o->arena, lam_handle, o->handles.count);
  int count = 0;
  for (int h = 0; h < o->handles.count; h++) {
    lam_handle handle = ((const lam_handle *)o->handles.items)[h];
    int v = handle.vertex[0], near = coarse->nearest[v];
    bool taken = o->keys->boundary == LAM_BOUNDARY_FIXED && coarse->net.boundary[near];
    for (int k = 0; k < count; k++) taken |= out[k].vertex[0] == near;
    if (taken) continue;

    lam_vec3 away = lam_sub(coarse->net.mesh.vertices[near], o->net->mesh.vertices[v]);
    handle.vertex[0] = near;
    handle.vertex[1] = -1;
    handle.to[0] += away.x, handle.to[1] += away.y, handle.to[2] += away.z;
    out[count++] = handle;
  }
  return (lam_list){count, out};
}

/* Puts the refined positions of the solved coarse net into x; a fixed boundary stays. */
static void take_refined(optimization *o, const lam_level *coarse) {
  int n = o->net->mesh.vertex_count;
  lam_vec3 *refined = LAM_NEW(o->arena, lam_vec3, n);
  lam_level_refine(o->arena, coarse, refined);
  for (int v = 0; v < n; v++) {
    bool held = o->keys->boundary == LAM_BOUNDARY_FIXED && o->net->boundary[v];
    o->x[v] = held ? o->start[v] : lam_scale(refined[v], 1 / o->unit);
  }
}

/* Solves a coarser net, where one is wanted and can be made, and puts its refined solution into
 * x. result: that of the coarse net then. False: the input is wrong. */
static bool begin_on_coarse_net(optimization *o, lam_net_result *result) {
  /* faces of the coarse net, by the design's own choice of levels and by the kind's */
  enum { fewest_if_given = 4, fewest = 64 };
  int levels = wanted_levels(o);
  lam_level coarse;
  if (levels < 1 ||
      !lam_level_make(o->arena, o->net, o->keys->levels_given ? fewest_if_given : fewest, &coarse))
    return true;

  /* The same job with one level less and its own handles; frames show the fine net only. */
  lam_net_common keys = *o->keys;
  keys.handles = coarse_handles(o, &coarse);
  keys.levels = levels - 1;
  keys.animate = 0;
  lam_net_kind kind = *o->job->kind;
  kind.levels = levels - 1;
  lam_net_job job = *o->job;
  job.origin = lam_v3(0, 0, 0); /* the handles are about it already */
  job.common = &keys;
  job.kind = &kind;
  if (!lam_net_optimize(o->arena, &job, &coarse.net, o->errors, result)) return false;

  take_refined(o, &coarse);
  o->levels = ++result->levels;
  return true;
}

/* Where the solver begins when the start is noisy: near the start, with fair polylines. A
 * held boundary stays. */
static void smooth_noisy_start(optimization *o) {
  static const double closeness = .3; /* to the start, against fairness 1 */
  lam_problem *problem = lam_problem_new(o->arena, o->net->mesh.vertex_count, o->start);
  lam_scope scope = {.problem = problem, .net = o->net, .unit = o->unit, .errors = o->errors};
  for (int v = 0; v < problem->vertex_count; v++)
    problem->fixed[v] = o->net->boundary[v] && o->keys->boundary != LAM_BOUNDARY_FREE;

  lam_con_fairness.add(&scope, &(lam_fairness_params){LAM_FAIR_POSITION}, 1, o->job->location);
  lam_guided_smooth(problem, closeness);
  lam_problem_positions(problem, o->x);
}

/* Decides how many solves there are, and when frames are kept. After a coarser net the handles
 * are where they have to be but for the refinement: no steps are needed. */
static void plan_steps(optimization *o) {
  bool any_released = false;
  o->handle_steps = 1;
  for (int h = 0; h < o->handles.count; h++) {
    const lam_handle *handle = (const lam_handle *)o->handles.items + h;
    any_released |= handle->release;
    if (o->levels == 0 && handle->steps > o->handle_steps) o->handle_steps = handle->steps;
  }
  o->steps = o->handle_steps + any_released;

  if (o->keys->animate <= 0) return;
  o->frames = LAM_NEW(o->arena, lam_snapshots, 1);
  *o->frames = lam_snapshots_new(o->arena, o->keys->animate, o->net->mesh.vertex_count, o->unit);
  o->frame_per_step = o->handle_steps > 1;
  lam_snapshots_add(o->frames, o->start);
}

/* ---- one solve ---- */

/* What the key `boundary` asks for. */
static void hold_boundary(const optimization *o, lam_scope *scope) {
  lam_problem *problem = scope->problem;
  switch ((lam_boundary)o->keys->boundary) {
  case LAM_BOUNDARY_FREE:
    break;
  case LAM_BOUNDARY_FIXED:
    for (int v = 0; v < problem->vertex_count; v++) problem->fixed[v] |= o->net->boundary[v];
    break;
  case LAM_BOUNDARY_GLIDE:
    lam_con_glide.add(scope, NULL, 1, o->job->location);
    break;
  }
}

/* Handles pull their vertices to the point that they have reached in this step. */
static void add_handles(const optimization *o, lam_scope *scope) {
  lam_vec3 *targets = LAM_NEW(o->arena, lam_vec3, o->handles.count);
  int *vertices = LAM_NEW(o->arena, int, o->handles.count), count = 0;
  for (int h = 0; h < o->handles.count; h++) {
    const lam_handle *handle = (const lam_handle *)o->handles.items + h;
    if (o->let_go && handle->release) continue;

    int v = handle->vertex[0];
    lam_vec3 to = lam_scale(lam_v3(handle->to[0], handle->to[1], handle->to[2]), 1 / o->unit);
    vertices[count] = v;
    targets[count++] = lam_mix(o->start[v], to, o->share);
  }
  lam_closeness_add(scope, "handle", LAM_HARD, 1, count, vertices, targets);
}

/* Everything that stays to the end: hard constraints, and the reference as a soft one. What a
 * constraint keeps (a length, the boundary curve) is that of the start: these are added while the
 * problem stands there. Then it moves to x, where the solve begins. */
static void add_constraints(const optimization *o, lam_scope *scope) {
  const lam_net_job *job = o->job;
  lam_problem *problem = scope->problem;
  bool thesis = o->keys->solver.method == LAM_METHOD_THESIS;
  assert(!thesis || job->kind->constrain_thesis);
  if (!thesis) job->kind->constrain(scope, job->params, job->location);
  for (int i = 0; i < o->keys->constraints.count; i++) {
    const lam_row *row = (const lam_row *)o->keys->constraints.items + i;
    ((const lam_constraint_kind *)row->head)->add(scope, row->params, 1, row->location);
  }
  hold_boundary(o, scope);

  memcpy(problem->x, o->x, sizeof *o->x * (size_t)problem->vertex_count);
  if (thesis) job->kind->constrain_thesis(scope, job->params, job->location);
  add_handles(o, scope);
  if (job->reference) lam_con_proximity.add(scope, NULL, o->reference_weight, job->location);
}

/* The kind's schedule with the keys of the design. When handles let go the net begins where the
 * step before has led it: no fairness then. */
static lam_schedule schedule_of(const optimization *o) {
  /* Table 3.2 of the thesis: fairness of positions, .01 -> 0 or none, and nothing
   * else that guides. */
  static const double thesis_fairness = .01;
  const lam_solver_keys *keys = &o->keys->solver;
  lam_schedule schedule = o->job->kind->schedule;
  if (keys->method == LAM_METHOD_THESIS)
    schedule.fairness = fmin(schedule.fairness, thesis_fairness);
  if (keys->fairness_given) schedule.fairness = keys->fairness;
  if (keys->tolerance_given) schedule.tolerance = keys->tolerance;
  schedule.max_iterations = keys->iterations;
  if (o->let_go) schedule.fairness = 0;
  return schedule;
}

/* What guides the kind. A mesh from a file is a shape that somebody has made: some kinds keep
 * nearer to it than to samples of a surface. */
static lam_guide guide_of(const optimization *o) {
  const lam_net_kind *kind = o->job->kind;
  lam_guide guide = kind->guide;
  if (o->keys->from.file) guide.closeness = fmax(guide.closeness, kind->file_closeness);
  return guide;
}

/* Fairness and what fades with it, from where this solve begins. */
static void add_guide(const optimization *o, lam_scope *scope) {
  const lam_solver_keys *keys = &o->keys->solver;
  lam_guide guide = guide_of(o);
  if (keys->method == LAM_METHOD_THESIS) guide = (lam_guide){LAM_FAIR_POSITION, 0, 0};
  if (keys->fair_given) guide.fair = (lam_fair)keys->fair;
  if (keys->closeness_given) guide.closeness = keys->closeness;
  if (keys->stiffness_given) guide.stiffness = keys->stiffness;

  /* A fine net that starts from a solved coarse one needs less: closeness to it would
   * keep its creases. */
  guide.closeness *= pow(.5, o->levels);

  lam_con_fairness.add(scope, &(lam_fairness_params){guide.fair}, 1, o->job->location);
  if (guide.closeness > 0) lam_con_closeness.add(scope, NULL, guide.closeness, o->job->location);
  if (guide.stiffness > 0)
    lam_edge_length_add(scope, "stiffness", LAM_FAIRNESS, guide.stiffness,
                        (lam_edge_length_params){0});
}

/* Equations of the hard constraints. */
static int hard_equations(const lam_problem *problem) {
  int equations = 0;
  for (int b = 0; b < problem->block_count; b++)
    if (problem->blocks[b].role == LAM_HARD)
      equations += problem->blocks[b].count * problem->blocks[b].rows;
  return equations;
}

/* More equations than unknowns may have no solution: the residual then stays above a floor,
 * whatever the solver does. Adds this to the reason. */
static void explain(const optimization *o, lam_solution *solution) {
  if (o->demanded > solution->unknowns)
    solution->reason =
        lam_arena_printf(o->arena, "%s (over-determined: %d equations for %d unknowns)",
                         solution->reason, o->demanded, solution->unknowns);
}

/* Runs the solver of the key `method` and puts its positions into x. Frames per iteration are
 * taken from what the solver tells of its progress. */
static lam_solution run_solver(optimization *o, lam_problem *problem,
                               const lam_schedule *schedule) {
  const lam_progress *progress = o->job->progress;
  lam_progress watching;
  if (o->frames) {
    o->frames->problem = o->frame_per_step ? NULL : problem;
    o->frames->next = o->job->progress;
    watching = lam_snapshots_progress(o->frames);
    progress = &watching;
  }

  const lam_solver_keys *keys = &o->keys->solver;
  bool thesis = keys->method == LAM_METHOD_THESIS;
  lam_solution solution = thesis
                              ? lam_gauss_newton_solve(problem, schedule, keys->epsilon, progress)
                              : lam_guided_solve(problem, schedule, progress);
  if (!solution.converged && !thesis) explain(o, &solution);
  lam_problem_positions(problem, o->x);
  return solution;
}

/* One solve, from x to x, with the handles where they are in this step. Its iterations are added to
 * those in result. Nothing is solved when there are errors; false when this step added them. */
static bool solve_step(optimization *o, lam_net_result *result) {
  int errors_before = o->errors->count, iterations_before = result->solution.iterations;
  lam_problem *problem = lam_problem_new(o->arena, o->net->mesh.vertex_count, o->start);
  lam_scope scope = {.problem = problem,
                     .net = o->net,
                     .unit = o->unit,
                     .origin = o->job->origin,
                     .reference = o->reference_tree,
                     .reference_mesh = &o->reference,
                     .errors = o->errors};
  add_constraints(o, &scope);
  o->demanded = hard_equations(problem);

  result->solution = (lam_solution){.reason = "not solved"};
  if (o->errors->count == 0) {
    lam_schedule schedule = schedule_of(o);
    if (schedule.fairness > 0) add_guide(o, &scope);
    result->solution = run_solver(o, problem, &schedule);
    result->skipped = scope.skipped;
  }
  result->solution.iterations += iterations_before;
  return o->errors->count == errors_before;
}

/* ---- the end ---- */

/* Why there was nothing to solve; NULL when there was: the measure that proves the kind has values,
 * and where the design lists constraints, there are equations. */
static const char *nothing_solved(const optimization *o, const lam_net_result *result) {
  const char *proof = o->job->kind->proof;
  for (int i = 0; proof && i < result->measure_count; i++)
    if (strcmp(result->measures[i].name, proof) == 0 && result->measures[i].count == 0)
      return lam_arena_printf(
          o->arena, "nothing to solve: %s, which proves the net, is undefined everywhere", proof);

  if (o->keys->constraints.count > 0 && o->demanded == 0)
    return "nothing to solve: the constraints apply nowhere";
  return NULL;
}

/* The solver's word is not enough: positions that meet the constraints may be folded, flat or
 * collapsed, and constraints that apply nowhere are always met. */
static void judge(const optimization *o, lam_net_result *result) {
  result->degenerate = lam_net_degenerate(o->arena, o->net, o->start, o->x);
  result->unproven = nothing_solved(o, result);
  result->converged = result->solution.converged && !result->degenerate && !result->unproven;
  result->reason = result->degenerate ? result->degenerate
                   : result->unproven ? result->unproven
                                      : result->solution.reason;
  result->reference_weight = o->job->reference ? o->reference_weight : 0;

  result->drift = 0;
  for (int v = 0; v < o->net->mesh.vertex_count; v++)
    result->drift = fmax(result->drift, lam_distance(o->x[v], o->start[v]));
}

/* All steps, from where x is, and the verdict. Handles go their way in equal steps; in one step
 * more, those with release: yes let go. False: the input is wrong. */
static bool solve_steps(optimization *o, lam_net_result *result) {
  plan_steps(o);
  for (int step = 1; step <= o->steps; step++) {
    o->let_go = step > o->handle_steps;
    o->share = o->let_go ? 1 : (double)step / o->handle_steps;
    if (!solve_step(o, result)) return false;
    if (o->frames && o->frame_per_step) lam_snapshots_add(o->frames, o->x);
  }
  judge(o, result);
  return true;
}

/* Solves again with larger and larger weights of the reference, each from where the one before has
 * ended, and keeps the last result that is sound. False: the input is wrong. */
static bool raise_weight(optimization *o, lam_net_result *result) {
  size_t bytes = sizeof *o->x * (size_t)o->net->mesh.vertex_count;
  lam_vec3 *kept = LAM_NEW(o->arena, lam_vec3, o->net->mesh.vertex_count);
  while (o->reference_weight < .99 * most_weight) {
    lam_net_result before = *result;
    memcpy(kept, o->x, bytes);
    o->reference_weight = fmin(o->reference_weight * weight_grows, most_weight);
    if (!solve_step(o, result)) return false;
    judge(o, result);
    if (result->converged) continue;

    int iterations = result->solution.iterations;
    *result = before;
    result->solution.iterations = iterations;
    memcpy(o->x, kept, bytes);
    break;
  }
  return true;
}

/* Finds how closely the net can follow the reference: a weight that is too large makes vertices
 * slide along it until faces fold. Where the first weight is too large already, smaller ones begin
 * anew. False: the input is wrong. */
static bool solve_with_best_weight(optimization *o, lam_net_result *result) {
  size_t bytes = sizeof *o->x * (size_t)o->net->mesh.vertex_count;
  lam_vec3 *begin = LAM_NEW(o->arena, lam_vec3, o->net->mesh.vertex_count);
  memcpy(begin, o->x, bytes);
  if (!solve_steps(o, result)) return false;
  if (result->converged) return raise_weight(o, result);

  while (!result->converged && o->reference_weight > 1.01 * least_weight) {
    o->reference_weight *= weight_falls;
    memcpy(o->x, begin, bytes);
    if (!solve_steps(o, result)) return false;
  }
  return !result->converged || raise_weight(o, result);
}

/* The key that may help a net that has not converged, in the order of what it is about: too close a
 * reference, too far from the start, or too little guidance. NULL: none is known. */
static const char *hint_of(const optimization *o, const lam_net_result *result) {
  const lam_solver_keys *keys = &o->keys->solver;
  double fairness = schedule_of(o).fairness;
  if (o->job->reference && o->keys->reference.weight_given)
    return lam_arena_printf(o->arena,
                            "net.reference.weight: a smaller one than %g lets the net keep its "
                            "shape",
                            o->reference_weight);

  if (fairness == 0 && !keys->fairness_given)
    return "net.solver.fairness: 0.1 smooths the first steps, and may help";
  if (result->degenerate && keys->closeness < 1)
    return "net.solver.closeness: 1 keeps the net nearer to its start, and may help";
  if (!result->degenerate && result->solution.iterations >= keys->iterations)
    return "net.solver.iterations: more of them may help";
  return NULL;
}

/* Moves the net to where the solver has brought it, and hands over the frames. */
static void deliver(const optimization *o, lam_net_result *result) {
  for (int v = 0; v < o->net->mesh.vertex_count; v++)
    o->net->mesh.vertices[v] = lam_scale(o->x[v], o->unit);
  if (o->frames)
    result->frames = lam_snapshots_finish(o->arena, o->frames, o->x, &result->frame_count);
}

/* Moves the vertices of a net until the constraints of its kind hold (guided projection, thesis
 * 3.7). False when the input is wrong. Not converging is a result, not an error. */
bool lam_net_optimize(lam_arena *arena, const lam_net_job *job, lam_net *net, lam_errors *errors,
                      lam_net_result *result) {
  *result = (lam_net_result){0};
  optimization o = {.arena = arena, .job = job, .keys = job->common, .net = net, .errors = errors};
  if (!prepare(&o)) return false;

  /* A coarser net is solved first: its refined positions are a better place to begin
   * than the start. */
  if (!begin_on_coarse_net(&o, result)) return false;
  if (o.levels == 0 && o.keys->solver.smooth) smooth_noisy_start(&o);

  bool chooses_weight = job->reference && !o.keys->reference.weight_given;
  if (!(chooses_weight ? solve_with_best_weight(&o, result) : solve_steps(&o, result)))
    return false;
  if (lam_tree_ran_out(o.reference_tree)) lam_arena_exhausted(arena);

  deliver(&o, result);
  lam_net_measure_result(arena, job, net, o.start_in_meters, result);
  judge(&o, result);
  if (!result->converged && !result->unproven) result->hint = hint_of(&o, result);
  return true;
}
