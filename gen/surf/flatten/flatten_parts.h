/* Points of the plane as a least-squares problem of solve/: nodes of two unknowns. For the
 * files of surf/flatten only. */
#ifndef LAM_SURF_FLATTEN_FLATTEN_PARTS_H
#define LAM_SURF_FLATTEN_FLATTEN_PARTS_H

#include "solve/assemble.h"
#include "solve/factor.h"
#include "surf/flatten/flatten.h"

/* A problem whose nodes are points of the plane (copied). Owned by the arena. */
lam_problem *lam_flat_problem(lam_arena *arena, int count, const lam_vec2 *points);

/* The points of such a problem: one per node. */
void lam_flat_positions(const lam_problem *problem, lam_vec2 *points);

/* The normal equations of a problem, with their factors. */
typedef struct lam_flat_system {
  lam_problem *problem;
  lam_system *system;
  lam_factor *factor;
  int size;
  double *values, *gradient, *step, *kept; /* kept: the unknowns before the last move */
} lam_flat_system;

/* All blocks must have been added. size is 0 when nothing can move. */
lam_flat_system lam_flat_system_make(lam_arena *arena, lam_problem *problem);

/* Fills the normal equations at the unknowns; returns the sum of squares. */
double lam_flat_system_assemble(lam_flat_system *s);

/* Solves (H + damping I) step = -gradient; false when the matrix is not positive definite. */
bool lam_flat_system_step(lam_flat_system *s, double damping);

/* Solves H step = -gradient with the factors of the last step. */
void lam_flat_system_again(lam_flat_system *s);

/* Moves the unknowns by share times the step, keeping the old ones. */
void lam_flat_system_move(lam_flat_system *s, double share);

/* The sum of squares at the unknowns. */
double lam_flat_system_sum(const lam_flat_system *s);

/* The angle in the plane of every triangle's first side, from unfolding one triangle after the
 * other. angles: triangle_count, radians; they count whole turns, too. */
void lam_flat_unfold(lam_arena *arena, const lam_flat_mesh *mesh, double *angles);

/* Fills energy, strains and flips from result->points. */
void lam_flat_measure(const lam_flat_mesh *mesh, lam_flattening *result);

#endif
