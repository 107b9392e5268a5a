/* The constraints `closeness` and `handle`: vertices near a given position. Listed in
 * constraints.c; net/optimize.c adds the first as a guide, and holds the handles of a design by
 * lam_closeness_add. */
#include "con/constraint.h"

/* A vertex at a given position: r = v - p  (3 rows, length), dr/dv = I. Linear. Thesis 3.7. */
static void at_position(int n, const double *x, const double *p, double *r, double *J) {
  for (int c = 0; c < 3; c++) r[c] = x[c] - p[c];
  if (!J) return;
  for (int i = 0; i < 3 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) J[c * n + c] = 1;
}

/* The block of both constraints. */
void lam_closeness_add(lam_scope *scope, const char *name, lam_role role, double weight, int count,
                       const int *vertices, const lam_vec3 *targets) {
  double *params = LAM_NEW(scope->problem->arena, double, 3 * count);
  for (int i = 0; i < count; i++) {
    params[3 * i] = targets[i].x;
    params[3 * i + 1] = targets[i].y;
    params[3 * i + 2] = targets[i].z;
  }

  lam_block block = {.name = name, .kernel = at_position, .rows = 3, .linear = true, .arity = 1};
  block.role = role;
  block.weight = weight;
  block.count = count;
  block.nodes = vertices;
  block.param_count = 3;
  block.params = params;
  lam_problem_add(scope->problem, block);
}

/* Every vertex where it is now; as fairness, so that it fades. */
static void add_closeness(lam_scope *scope, const void *params, double weight,
                          lam_location location) {
  (void)params, (void)location;
  lam_arena *arena = scope->problem->arena;
  int n = scope->net->mesh.vertex_count, *vertices = LAM_NEW(arena, int, n);
  lam_vec3 *targets = LAM_NEW(arena, lam_vec3, n);
  for (int v = 0; v < n; v++) vertices[v] = v;
  lam_problem_positions(scope->problem, targets);
  lam_closeness_add(scope, "closeness", LAM_FAIRNESS, weight, n, vertices, targets);
}

/* One vertex at the given position in meters, which becomes solver units. */
static void add_handle(lam_scope *scope, const void *params, double weight, lam_location location) {
  const lam_handle_params *handle = params;
  int given = handle->vertex.count ? *(const int *)handle->vertex.items : -1;
  if (given < 0 || given >= scope->net->mesh.vertex_count) {
    lam_error_add(scope->errors, location, "vertex", "vertex %d, but the net has vertices 0 to %d",
                  given, scope->net->mesh.vertex_count - 1);
    return;
  }

  int *vertex = LAM_NEW(scope->problem->arena, int, 1);
  *vertex = given;
  lam_vec3 to = lam_v3(handle->to[0], handle->to[1], handle->to[2]);
  lam_vec3 target = lam_scale(lam_sub(to, scope->origin), 1 / scope->unit);
  lam_closeness_add(scope, "handle", LAM_HARD, weight, 1, vertex, &target);
}

static const lam_key handle_keys[] = {
    LAM_INTEGER_KEY(lam_handle_params, "vertex", vertex, "0", 0, 0, "Index of the vertex, from 0."),
    LAM_LENGTH_KEY(lam_handle_params, "to", to, "[0, 0, 0]", 0, 0, "Where the vertex has to be."),
    {0}};

const lam_constraint_kind lam_con_closeness = {
    {"closeness", "Closeness to the start",
     "Holds every vertex near its place at the start. Its weight fades with the fairness: it "
     "guides the first steps and is gone in the result.",
     "v - v_start -> small", "thesis 3.7", NULL, 0},
    add_closeness};

const lam_constraint_kind lam_con_handle = {{"handle", "Handle",
                                             "A vertex that has to be at a given place. Handles at "
                                             "the corners of an open grid belong to no "
                                             "vertex star: take vertices one row further in.",
                                             "v = target", "thesis 3.7", handle_keys,
                                             sizeof(lam_handle_params)},
                                            add_handle};
