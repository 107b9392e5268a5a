/* Chebyshev nets: all edges are equally long, or opposite edges of every face are. A row of
 * lam_nets (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  double length; /* meters; 0: the mean edge of the start */
  bool generalized;
} params;

/* One length for all edges, or with `generalized` one for every row of opposite edges. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  if (p->generalized && p->length > 0)
    lam_error_add(scope->errors, location, "net.length",
                  "given together with generalized: yes, whose edges have many lengths; expected "
                  "one of the two");
  else if (p->generalized)
    lam_con_opposite_edges.add(scope, NULL, 1, location);
  else
    lam_edge_length_add(
        scope, "edge-length", LAM_HARD, 1,
        (lam_edge_length_params){.length = p->length > 0 ? p->length : scope->unit});
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(params, "length", length, "0", 0, 1e6,
                   "Length of every edge. 0: the mean edge of the start."),
    LAM_FLAG_KEY(params, "generalized", generalized, "no",
                 "Only opposite edges of every quad are equal: the spacing may change from one "
                 "polyline to the next."),
    {0}};

static const char *const measures[] = {"edge_variation",
                                       "opposite_edge_difference",
                                       "edge_length",
                                       "crossing_angle",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_chebyshev = {
    .head = {"chebyshev", "Chebyshev net",
             "All edges are equally long, as in cloth or a wire mesh: what is square when "
             "flat becomes a rhombus, whose angle may be any. Every surface has such nets, at "
             "least piece by piece.",
             "(|v1 - v0|^2 / L^2 - 1) / 2 = 0 at every edge; generalized: opposite edges are equal",
             "thesis 3.1, def. 3", keys, sizeof(params)},
    .use = "Elastic gridshells: a flat grid of continuous laths, bolted at equal spacing so that "
           "it can shear, is pushed up into the shape and braced. Also cable nets, woven "
           "composites and wire cloth. Bars and cladding rods all have one length.",
    .trouble = "Where the surface bends strongly both ways the meshes shear until they close: a "
               "half sphere is about as much as one net covers. Look at crossing_angle, and cut "
               "the net or turn its families where it nears 0 or 180 degrees. Equal lengths say "
               "nothing about the shape between: with a free boundary the net drifts from its "
               "start, so give a reference, handles or a fixed boundary where the place matters - "
               "a fixed boundary whose edges differ, however, contradicts equal lengths and is "
               "reported as stalled.",
    .chart = LAM_CHART_NATURAL,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "opposite_edge_difference"};
