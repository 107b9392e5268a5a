#include "con/constraint.h"

int lam_scope_stars(lam_scope *scope, const int **nodes) {
  const lam_net *net = scope->net;
  int *list = LAM_NEW(scope->problem->arena, int, 5 * net->star_count);
  for (int s = 0; s < net->star_count; s++) {
    list[5 * s] = net->stars[s].center;
    for (int k = 0; k < 4; k++) list[5 * s + 1 + k] = net->stars[s].neighbor[k];
  }
  scope->skipped += net->irregular_count;
  *nodes = list;
  return net->star_count;
}
