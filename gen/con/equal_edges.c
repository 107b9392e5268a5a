/* The constraint `equal-edges`: vertices at equal distances along lines. Listed in constraints.c;
 * net/kinds/geodesic_parallel_net.c and strip_widths.c add it. */
#include "con/edge_sums.h"

static const char *const choices[] = {"all", "middle", NULL};

/* Lines of the family with the most vertices; the middle one of these. -1: there is no line. */
static int middle_line(const lam_net *net, int family) {
  int most = 0, count = 0;
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->family != family || line->count < most) continue;
    count = line->count > most ? 1 : count + 1;
    most = line->count;
  }

  int wanted = count / 2;
  for (int l = 0; l < net->polyline_count; l++)
    if (net->polylines[l].family == family && net->polylines[l].count == most && wanted-- == 0)
      return l;
  return -1;
}

/* Equal edges along a polyline (discrete arc length, thesis 3.3.3):
 *   r = |v_(k+1) - v_k| - |v_(k+2) - v_(k+1)|   (length; Jacobian in edge_sums.c)
 * On a closed line one equation less than edges says it for all. */
static void push_line(const lam_polyline *line, lam_edge_list *list) {
  int n = line->count, pairs = n < 3 ? 0 : line->closed ? n - 1 : n - 2;
  for (int k = 0; k < pairs; k++) {
    const int *v = line->vertices;
    lam_edge_list_push(list, (int[4]){v[k], v[k + 1], v[k + 1], v[(k + 2) % n]});
  }
}

/* All lines of the family, or its middle one. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_equal_edges_params *given = params;
  const lam_net *net = scope->net;
  lam_edge_list list = lam_edge_list_new(scope->problem->arena, 2, net->edge_count);
  bool one = given->lines == LAM_LINES_MIDDLE;
  int middle = one ? middle_line(net, given->family) : -1;
  for (int l = 0; l < net->polyline_count; l++)
    if (net->polylines[l].family == given->family && (!one || l == middle))
      push_line(&net->polylines[l], &list);

  static const double difference[2] = {1, -1};
  lam_edge_sum_add(scope, "equal-edges", weight, &list, difference);
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(lam_equal_edges_params, "family", family, "0", 0, 1,
                    "Family of the lines: 0, along u, or 1, along v."),
    LAM_CHOICE_KEY(lam_equal_edges_params, "lines", lines, "all", choices,
                   "all lines of the family, or only the middle one of its longest lines."),
    {0}};

const lam_constraint_kind lam_con_equal_edges = {
    {"equal-edges", "Equal edges along lines",
     "The edges of a line are of one length, which the solver finds: vertices stand at equal "
     "distances along it.",
     "|v(k+1) - v(k)| = |v(k+2) - v(k+1)|", "thesis 3.3.3", keys, sizeof(lam_equal_edges_params)},
    add};
