/* A net without constraints of its own, for lists of constraints. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

/* Adds nothing: the list `constraints` of the design is added by net/optimize.c for every kind. */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  (void)scope, (void)params, (void)location;
}

static const char *const measures[] = {"star_planarity", "face_planarity", "crossing_angle",
                                       "edge_length",    "shortest_edge",  "foldovers",
                                       "overlaps",       "flatness",       NULL};

const lam_net_kind lam_net_free = {
    .head = {"free", "Net of listed constraints",
             "Has no constraint of its own: it is what its `constraints` list says, and the "
             "parameter lines of the surface when the list is empty.",
             NULL, NULL, NULL, 0},
    .use = "Trying out what a combination of constraints does, and nets that have no name of their "
           "own.",
    .trouble = "Constraints that contradict each other: the report says stalled, and names the "
               "block with the largest residual.",
    .chart = LAM_CHART_NATURAL,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures};
