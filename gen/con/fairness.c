/* The constraint `fairness`: smooth polylines. Listed in constraints.c; net/optimize.c adds it to
 * every net as a guide that fades. */
#include "con/constraint.h"

/* Second difference along a polyline (thesis 3.7):
 *   r = (v_(k-1) - 2 v_k + v_(k+1)) - p   (3 rows, length), Jacobian I, -2 I, I. Linear.
 * p = 0 makes the net itself fair; p = the second difference at the start makes its displacement
 * fair, which keeps the waves of the start. */
static void second_difference(int n, const double *x, const double *p, double *r, double *J) {
  for (int c = 0; c < 3; c++) r[c] = x[c] - 2 * x[3 + c] + x[6 + c] - p[c];
  if (!J) return;
  for (int i = 0; i < 3 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c * n + c] = 1;
    J[c * n + 3 + c] = -2;
    J[c * n + 6 + c] = 1;
  }
}

/* Nodes of all consecutive triples of the polylines; nodes may be NULL. Returns their number. */
static int triples(const lam_net *net, int *nodes) {
  int count = 0;
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    int n = line->count, inner = line->closed ? n : n - 2;
    for (int k = 0; k < inner; k++, count++)
      for (int i = 0; nodes && i < 3; i++) nodes[3 * count + i] = line->vertices[(k + i) % n];
  }
  return count;
}

/* The second differences of the triples at x, 3 numbers each. */
static void differences_at(const double *x, int count, const int *nodes, double *out) {
  for (int i = 0; i < count; i++)
    for (int c = 0; c < 3; c++)
      out[3 * i + c] =
          x[3 * nodes[3 * i] + c] - 2 * x[3 * nodes[3 * i + 1] + c] + x[3 * nodes[3 * i + 2] + c];
}

/* Without params: of positions. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_fairness_params *given = params;
  lam_arena *arena = scope->problem->arena;
  int count = triples(scope->net, NULL), *nodes = LAM_NEW(arena, int, 3 * count);
  double *targets = LAM_NEW(arena, double, 3 * count);
  triples(scope->net, nodes);
  if (given && given->of == LAM_FAIR_DISPLACEMENT)
    differences_at(scope->problem->x, count, nodes, targets);

  lam_block block = {.name = "fairness", .kernel = second_difference, .rows = 3, .linear = true};
  block.role = LAM_FAIRNESS;
  block.weight = weight;
  block.count = count;
  block.arity = 3;
  block.nodes = nodes;
  block.param_count = 3;
  block.params = targets;
  lam_problem_add(scope->problem, block);
}

const char *const lam_fairness_choices[] = {"positions", "displacements", NULL};

static const lam_key keys[] = {
    LAM_CHOICE_KEY(lam_fairness_params, "of", of, "positions", lam_fairness_choices,
                   "positions: the net itself becomes smooth; displacements: its change against "
                   "the start does, so that waves of the start survive."),
    {0}};

const lam_constraint_kind lam_con_fairness = {
    {"fairness", "Fair polylines",
     "Keeps polylines smooth while the net finds its shape; its weight fades out, so that it does "
     "not bend the result. Strong fairness without closeness, handles or fixed vertices pulls "
     "every net towards a plane.",
     "v(k-1) - 2 v(k) + v(k+1) -> small", "thesis 3.7", keys, sizeof(lam_fairness_params)},
    add};
