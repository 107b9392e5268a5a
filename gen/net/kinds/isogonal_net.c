/* Isogonal nets: one crossing angle at every vertex. A row of lam_nets (net/kinds/nets.c);
 * net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "core/numbers.h"
#include "net/guide.h"
#include "net/net_kind.h"

/* The angle between the tangents that the key `tangents` names. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  lam_con_angle.add(scope, given, 1, location);
}

/* The same with unit edges, or the tangents of the circles, as further unknowns. */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  (void)location;
  const lam_angle_params *p = given;
  if (p->tangents == LAM_TANGENTS_CIRCLE)
    lam_thesis_circle_angle(scope, p->angle);
  else
    lam_thesis_angle(scope, p->angle, p->border);
}

/* Radians. */
static double target_angle(const void *given) { return ((const lam_angle_params *)given)->angle; }

static const char *const tangents[] = {"bisector", "circle", NULL};

static const lam_key keys[] = {
    LAM_ANGLE_KEY(lam_angle_params, "angle", angle, "90 deg", 5 * LAM_PI / 180, 175 * LAM_PI / 180,
                  "The crossing angle at every vertex. 90 deg: an orthogonal net."),
    LAM_FLAG_KEY(lam_angle_params, "border", border, "yes",
                 "Reentrant corners of the border, which have four edges, keep the angle."),
    LAM_CHOICE_KEY(lam_angle_params, "tangents", tangents, "bisector", tangents,
                   "Between what the angle is. bisector: the lines halfway between the two edges "
                   "of a polyline; circle: the tangents of the circles through three of its "
                   "vertices, which is better where edges are unequal."),
    {0}};

static const char *const measures[] = {"angle_deviation",
                                       "circle_angle_deviation",
                                       "crossing_angle",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_isogonal = {
    .head = {"isogonal", "Isogonal net",
             "The two families of polylines cross at one angle everywhere; at 90 degrees the net "
             "is orthogonal. Every surface carries such nets: one family may be chosen freely, "
             "the other follows.",
             "T1.T2 = cos(angle) at every regular star, T1 = unit(e1 - e3), T2 = unit(e2 - e4)",
             "thesis 3.1, def. 5 (its eq. 3.1, called orthogonal there, is the condition of a "
             "geodesic net)",
             keys, sizeof(lam_angle_params)},
    .use = "One node for the whole shell: the same connector, slot and clamp at every crossing. "
           "Orthogonal nets have nearly rectangular panels and are the usual start for other nets.",
    .trouble =
        "One equation per vertex leaves much freedom. The guide shears the net with little change "
        "of its edges; with fairness of positions instead (solver: fair) the net sinks towards a "
        "plane, which is reported as flattened. Angles below 30 degrees give long, narrow quads "
        "that fold easily. A fixed boundary that crosses at another angle moves the difference "
        "into the first row, where edges shrink.",
    .chart = LAM_CHART_NATURAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = {LAM_FAIR_DISPLACEMENT, 0, 1},
    .constrain = constrain,
    .constrain_thesis = constrain_thesis,
    .measures = measures,
    .proof = "angle_deviation",
    .target_angle = target_angle};
