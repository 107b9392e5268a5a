/* The normal equations of points in the plane: thin functions over solve/assemble.h and
 * solve/factor.h. Called by flatten_solve.c and flatten_mesh.c. */
#include "surf/flatten/flatten_parts.h"
#include <string.h>

/* All roles count alike. */
static const lam_weights all = {1, 1, 1};

/* No mesh vertices of three unknowns: nodes of two only. */
lam_problem *lam_flat_problem(lam_arena *arena, int count, const lam_vec2 *points) {
  lam_problem *problem = lam_problem_new(arena, 0, NULL);
  for (int v = 0; v < count; v++)
    lam_problem_node(problem, 2, (const double[2]){points[v].x, points[v].y});
  return problem;
}

/* The inverse of lam_flat_problem. */
void lam_flat_positions(const lam_problem *problem, lam_vec2 *points) {
  for (int v = 0; v < problem->node_count; v++)
    points[v] = (lam_vec2){problem->x[2 * v], problem->x[2 * v + 1]};
}

/* The pattern and its order are found once. */
lam_flat_system lam_flat_system_make(lam_arena *arena, lam_problem *problem) {
  lam_flat_system s = {.problem = problem, .system = lam_system_new(arena, problem)};
  s.size = lam_system_size(s.system);
  if (!s.size) return s;

  const int *columns = lam_system_columns(s.system);
  s.factor = lam_factor_analyze(arena, s.size, columns, lam_system_rows(s.system),
                                lam_system_order(s.system));
  s.values = LAM_NEW(arena, double, columns[s.size]);
  s.gradient = LAM_NEW(arena, double, s.size);
  s.step = LAM_NEW(arena, double, s.size);
  s.kept = LAM_NEW(arena, double, problem->offset[problem->node_count]);
  return s;
}

/* The energy of solve/ is half the sum of squares. */
double lam_flat_system_assemble(lam_flat_system *s) {
  return 2 * lam_system_assemble(s->system, s->problem->x, all, s->values, s->gradient).energy;
}

double lam_flat_system_sum(const lam_flat_system *s) {
  return 2 * lam_system_residual(s->system, s->problem->x, all).energy;
}

/* The damping is taken off the values again, so that they stay those of H. */
bool lam_flat_system_step(lam_flat_system *s, double damping) {
  lam_system_damp(s->system, damping, s->values);
  bool definite = lam_factor_refactor(s->factor, s->values);
  lam_system_damp(s->system, -damping, s->values);
  if (definite) lam_flat_system_again(s);
  return definite;
}

/* Back substitution alone. */
void lam_flat_system_again(lam_flat_system *s) {
  lam_factor_solve(s->factor, s->gradient, s->step);
  for (int i = 0; i < s->size; i++) s->step[i] = -s->step[i];
}

/* Only unknowns that are not fixed have an entry of the step. */
void lam_flat_system_move(lam_flat_system *s, double share) {
  const lam_problem *p = s->problem;
  const int *unknown = lam_system_unknowns(s->system);
  memcpy(s->kept, p->x, (size_t)p->offset[p->node_count] * sizeof *s->kept);
  for (int i = 0; i < s->size; i++) p->x[unknown[i]] += share * s->step[i];
}
