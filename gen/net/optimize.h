/* From an initial mesh to a solved net, by the rules of its kind. */
#ifndef LAM_NET_OPTIMIZE_H
#define LAM_NET_OPTIMIZE_H

#include "net/net_kind.h"

typedef struct lam_net_job {
  const lam_net_kind *kind;
  const void *params;
  const lam_net_common *common;
  const lam_trimesh *reference; /* meters; NULL: none */
  lam_location location;
  const lam_progress *progress;
} lam_net_job;

typedef struct lam_net_result {
  lam_solution solution;  /* its iterations are those of all levels and steps together */
  int levels;             /* coarser nets that were solved first */
  const char *degenerate; /* NULL: none */
  bool converged;         /* solved and not degenerate */
  const char *reason;
  long skipped; /* irregular vertices that constraints on regular stars left out */
  int measure_count;
  lam_measure *measures;
  int frame_count;               /* of `animate`: at most so many, from the start to the solution */
  const lam_vec3 *const *frames; /* positions of all vertices, meters */
  lam_measuring measuring;       /* what they were measured with; reference_mesh is the caller's */
  double drift;                  /* largest displacement from the start, in mean edges */
} lam_net_result;

/* Solves for net->mesh.vertices in place. Errors (a handle on a vertex that is not there, ...) go
 * to errors; false then. */
bool lam_net_optimize(lam_arena *arena, const lam_net_job *job, lam_net *net, lam_errors *errors,
                      lam_net_result *result);

/* Measures a solved net (meters) by its kind's measures, those of the reference and those that the
 * design asks for, and keeps what they were measured with. start: positions before the solver. */
void lam_net_measure_result(lam_arena *arena, const lam_net_job *job, const lam_net *net,
                            const lam_vec3 *start, lam_net_result *result);

#endif
