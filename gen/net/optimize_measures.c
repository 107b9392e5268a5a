/* What a solved net is measured by, and with what. Called by lam_net_optimize (net/optimize.c). */
#include "net/optimize.h"

#include <math.h>
#include <string.h>

/* Whether name is among count names. */
static bool is_listed(const char *const *names, int count, const char *name) {
  for (int i = 0; i < count; i++)
    if (strcmp(names[i], name) == 0) return true;
  return false;
}

/* The kind's own measures, those of a reference, and those that the design asks for, each once;
 * NULL-terminated, in the arena. Unknown names in the design are left out. */
static const char *const *measure_names(lam_arena *arena, const lam_net_job *job) {
  static const char *const of_reference[2] = {"distance_to_reference", "distance_from_reference"};
  const lam_list *more = &job->common->measures;
  const char *const *own = job->kind->measures;
  int count = 0;
  while (own[count]) count++;
  const char **names = LAM_NEW(arena, const char *, count + more->count + 3);
  for (int i = 0; i < count; i++) names[i] = own[i];

  for (int i = 0; job->reference && i < 2; i++)
    if (!is_listed(names, count, of_reference[i])) names[count++] = of_reference[i];

  for (int i = 0; i < more->count; i++) {
    const char *name = ((const char *const *)more->items)[i];
    if (lam_measure_find(name) && !is_listed(names, count, name)) names[count++] = name;
  }
  return names;
}

/* Measures what stands in net->mesh.vertices; the kind's target angle replaces the right angle. */
void lam_net_measure_result(lam_arena *arena, const lam_net_job *job, const lam_net *net,
                            const lam_vec3 *start, lam_net_result *result) {
  lam_measuring *in = &result->measuring;
  *in = lam_measuring_of(arena, net, net->mesh.vertices);
  in->start = start;
  double target = job->kind->target_angle ? job->kind->target_angle(job->params) : in->target_angle;
  if (!isnan(target)) in->target_angle = target;

  /* The solver's own tree is in solver units; this one is in meters. */
  lam_status searched = LAM_OK;
  lam_tree *tree = job->reference ? lam_tree_new(job->reference, &searched) : NULL;
  if (searched == LAM_NO_MEMORY) lam_arena_exhausted(arena);
  if (tree) {
    lam_arena_defer(arena, lam_tree_free, tree);
    in->reference = tree;
    in->reference_mesh = job->reference;
  }

  result->measures = lam_net_measure(in, measure_names(arena, job), &result->measure_count);
}
