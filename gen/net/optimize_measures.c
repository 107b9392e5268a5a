#include "net/optimize.h"

#include <math.h>
#include <string.h>

static bool listed(const char *const *names, int count, const char *name) {
  for (int i = 0; i < count; i++)
    if (strcmp(names[i], name) == 0) return true;
  return false;
}

/* The kind's own measures, those of a reference, and those that the design asks for; each once. */
static const char *const *measure_names(lam_arena *arena, const lam_net_job *job) {
  static const char *const of_reference[2] = {"distance_to_reference", "distance_from_reference"};
  const lam_list *more = &job->common->measures;
  const char *const *own = job->kind->measures;
  int count = 0;
  while (own[count]) count++;
  const char **names = LAM_NEW(arena, const char *, count + more->count + 3);
  for (int i = 0; i < count; i++) names[i] = own[i];
  for (int i = 0; job->reference && i < 2; i++)
    if (!listed(names, count, of_reference[i])) names[count++] = of_reference[i];
  for (int i = 0; i < more->count; i++) {
    const char *name = ((const char *const *)more->items)[i];
    if (lam_measure_find(name) && !listed(names, count, name)) names[count++] = name;
  }
  return names;
}

void lam_net_measure_result(lam_arena *arena, const lam_net_job *job, const lam_net *net,
                            const lam_vec3 *start, lam_net_result *result) {
  lam_measuring *in = &result->measuring;
  *in = lam_measuring_of(arena, net, net->mesh.vertices);
  in->start = start;
  double target = job->kind->target_angle ? job->kind->target_angle(job->params) : in->target_angle;
  if (!isnan(target)) in->target_angle = target;
  lam_tree *tree =
      job->reference ? lam_tree_new(job->reference) : NULL; /* the solver's own is not in meters */
  if (tree) {
    lam_arena_defer(arena, lam_tree_free, tree);
    in->reference = tree;
    in->reference_mesh = job->reference;
  }
  result->measures = lam_net_measure(in, measure_names(arena, job), &result->measure_count);
}
