/* The constraint `strip-widths`: how the widths of strips between geodesics go together. Listed in
 * constraints.c; net/kinds/geodesic_parallel_net.c adds it.
 *
 * w(a, s) is the edge across strip s at station a:
 *   equal         w(a, s) = w(a, s+1)                    one width for all strips at a station
 *   proportional  w(a, s) w(b, s+1) = w(a, s+1) w(b, s)  and a factor for each strip (eq. 3.8)
 *   constant      w(a, s) = w(a+1, s)                    each strip has one width all along */
#include "con/edge_sums.h"
#include "con/kernel.h"

static const char *const choices[] = {"equal", "proportional", "constant", NULL};

/* Proportional widths (thesis eq. 3.8): with the edges E0 = w(a, s), E1 = w(a, s+1), E2 = w(b, s),
 * E3 = w(b, s+1), two nodes each,
 *   r = |E0| |E3| - |E1| |E2|   (length^2)
 *   dr/dE0 = |E3| E0 / |E0|, dr/dE1 = -|E2| E1 / |E1|, dr/dE2 = -|E1| E2 / |E2|,
 *   dr/dE3 = |E0| E3 / |E3| */
static void proportional(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 e[4];
  double length[4];
  for (int k = 0; k < 4; k++) {
    lam_vec3 E = lam_sub(lam_local(x, 2 * k + 1), lam_local(x, 2 * k));
    length[k] = lam_length(E);
    e[k] = lam_scale(E, 1 / length[k]);
  }
  r[0] = length[0] * length[3] - length[1] * length[2];
  if (!J) return;

  const double slope[4] = {length[3], -length[2], -length[1], length[0]};
  for (int c = 0; c < n; c++) J[c] = 0;
  for (int k = 0; k < 4; k++) {
    lam_add_to(J, 2 * k + 1, lam_scale(e[k], slope[k]));
    lam_add_to(J, 2 * k, lam_scale(e[k], -slope[k]));
  }
}

/* An element per geodesic edge between two strips: a and b are its ends, and the other ends of the
 * edges across lie on the neighboring geodesics. */
static void add_proportional(lam_scope *scope, int family, double weight) {
  const lam_net *net = scope->net;
  lam_edge_list list = lam_edge_list_new(scope->problem->arena, 4, net->edge_count);
  for (int e = 0; e < net->edge_count; e++) {
    const lam_edge *edge = &net->edges[e];
    int left[2], right[2], a = edge->vertex[0], b = edge->vertex[1];
    if (edge->family != family || edge->face[1] < 0) continue;
    lam_opposite_edge(net, edge->face[0], edge, left);
    lam_opposite_edge(net, edge->face[1], edge, right);
    lam_edge_list_push(&list, (int[8]){a, left[0], a, right[0], b, left[1], b, right[1]});
  }

  lam_block block = {.name = "strip-widths", .kernel = proportional, .rows = 1, .arity = 8};
  block.weight = weight;
  block.count = list.count;
  block.nodes = list.nodes;
  lam_problem_add(scope->problem, block);
}

/* An element per face: the edges across its strip at both ends. */
static void add_constant(lam_scope *scope, int family, double weight) {
  const lam_net *net = scope->net;
  lam_edge_list list = lam_edge_list_new(scope->problem->arena, 2, net->mesh.face_count);
  bool *done = LAM_NEW(scope->problem->arena, bool, net->mesh.face_count);

  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      const lam_edge *edge = &net->edges[e];
      int f = edge->face[side], other[2];
      if (edge->family != family || f < 0 || done[f]) continue;
      done[f] = true;
      lam_opposite_edge(net, f, edge, other);
      lam_edge_list_push(&list, (int[4]){edge->vertex[0], other[0], edge->vertex[1], other[1]});
    }

  static const double difference[2] = {1, -1};
  lam_edge_sum_add(scope, "strip-widths", weight, &list, difference);
}

/* Equal widths are equal edges along the lines across the strips. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  const lam_strip_params *given = params;
  const lam_equal_edges_params across = {!given->family, LAM_LINES_ALL};

  switch ((lam_widths)given->widths) {
  case LAM_WIDTHS_EQUAL:
    lam_con_equal_edges.add(scope, &across, weight, location);
    break;
  case LAM_WIDTHS_PROPORTIONAL:
    add_proportional(scope, given->family, weight);
    break;
  case LAM_WIDTHS_CONSTANT:
    add_constant(scope, given->family, weight);
    break;
  }
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(lam_strip_params, "geodesics", family, "0", 0, 1,
                    "Family whose lines bound the strips: 0, along u, or 1, along v."),
    LAM_CHOICE_KEY(lam_strip_params, "widths", widths, "equal", choices,
                   "equal: at every line across, all strips have the same width; proportional: up "
                   "to a factor for each strip; constant: each strip has one width all along."),
    {0}};

const lam_constraint_kind lam_con_strip_widths = {
    {"strip-widths", "Widths of strips",
     "Controls the widths of the strips between geodesics. With equal or proportional widths and "
     "geodesic-parallel the net is isometric to a surface of revolution, and equal strips unroll "
     "to copies of one pattern; with constant widths it is nearly developable.",
     "w(a, s) w(b, s+1) = w(a, s+1) w(b, s)", "thesis 3.3.3, eq. 3.8, and 4.4.1", keys,
     sizeof(lam_strip_params)},
    add};
