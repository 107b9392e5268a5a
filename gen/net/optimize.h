/* From an initial mesh to a solved net, by the rules of its kind. Called by design/net_stage.c
 * for a design's net and by bench/bench_run.c. */
#ifndef LAM_NET_OPTIMIZE_H
#define LAM_NET_OPTIMIZE_H

#include "net/net_kind.h"

/* What is asked for; read only. The reference has to live as long as the result. */
typedef struct lam_net_job {
  const lam_net_kind *kind;
  const void *params;           /* of kind->head.keys; NULL when it has none */
  const lam_net_common *common; /* the keys that every net accepts */
  const lam_trimesh *reference; /* meters; NULL: none */
  lam_vec3 origin; /* of the net and the reference, in the coordinates of places that keys name,
                      meters */
  lam_location location;        /* of the net in the design, for messages */
  const lam_progress *progress; /* NULL: nobody listens */
} lam_net_job;

typedef struct lam_net_result {
  lam_solution solution;  /* its iterations are those of all levels and steps together */
  int levels;             /* coarser nets that were solved first */
  const char *degenerate; /* NULL: none */
  const char *unproven;   /* why nothing was solved: no constraint applies, or the measure that
                             proves the kind is undefined everywhere; NULL: something was */
  bool converged;         /* solved, proven and not degenerate */
  const char *reason;     /* of the verdict: degenerate, unproven, or the solver's reason */
  const char *hint;       /* which key may help, as a sentence; NULL: none, or it converged */
  long skipped;           /* irregular vertices that constraints on regular stars left out */
  int measure_count;
  lam_measure *measures;
  int frame_count;               /* of `animate`: at most so many, from the start to the solution */
  const lam_vec3 *const *frames; /* positions of all vertices, meters */
  lam_measuring measuring;       /* what they were measured with; reference_mesh is the caller's */
  double reference_weight;       /* that was used in the end; 0: no reference */
  double drift;                  /* largest displacement from the start, in mean edges */
} lam_net_result;

/* Moves the vertices of a net until the constraints of its kind hold (guided
 * projection, thesis 3.7).
 *
 *   job     kind of net, its keys, reference, handles; read only
 *   net     in: where it starts (meters); out: where it ends; connectivity stays
 *   errors  what is wrong with the input: a handle on a vertex that is not there, ...
 *   result  verdict, iterations, drift, frames, measures; owned by arena
 *
 * Returns false when the input is wrong; net has not moved then. Not converging is a result,
 * not an error.
 * Precondition: lam_net_method_check. */
bool lam_net_optimize(lam_arena *arena, const lam_net_job *job, lam_net *net, lam_errors *errors,
                      lam_net_result *result);

/* Measures a solved net (meters) by its kind's measures, those of the reference and those that the
 * design asks for, and keeps what they were measured with in result->measuring. start: positions
 * before the solver, vertex_count, meters; kept by pointer. Called by lam_net_optimize. */
void lam_net_measure_result(lam_arena *arena, const lam_net_job *job, const lam_net *net,
                            const lam_vec3 *start, lam_net_result *result);

#endif
