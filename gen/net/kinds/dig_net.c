/* Isogonal geodesic nets, which lie on developable surfaces. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "core/numbers.h"
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  double angle; /* radians */
  bool boundary_length;
} params;

/* Both families are geodesics and cross at the angle asked for. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_opposite_angles.add(scope, NULL, 1, location);
  lam_con_angle.add(scope, &(lam_angle_params){.angle = p->angle}, 1, location);
  if (p->boundary_length) lam_con_boundary_length.add(scope, NULL, 1, location);
}

/* Radians. */
static double target_angle(const void *given) { return ((const params *)given)->angle; }

static const lam_key keys[] = {
    LAM_ANGLE_KEY(params, "angle", angle, "60 deg", 5 * LAM_PI / 180, 175 * LAM_PI / 180,
                  "Angle between the two families."),
    LAM_FLAG_KEY(params, "boundary-length", boundary_length, "no",
                 "Every side of the boundary keeps its length. Opposite sides of such a net are "
                 "equally long: a start whose sides differ cannot keep them."),
    {0}};

static const char *const measures[] = {"opposite_angle",
                                       "angle_deviation",
                                       "gauss_image_area",
                                       "gauss_image_area_signed",
                                       "crossing_angle",
                                       "straightness_u",
                                       "straightness_v",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_dig = {
    .head = {"dig", "Isogonal geodesic net (developable)",
             "Both families are geodesics and cross at the same angle everywhere: like an "
             "orthogonal geodesic net, but with rhombic cells. Only developable surfaces "
             "carry such a net.",
             "<e1,e2> = <e3,e4>, <e2,e3> = <e4,e1>, T1.T2 = cos(angle)", "thesis 3.4.2", keys,
             sizeof(params)},
    .use = "As the orthogonal geodesic net, with a choice of pattern: lattices of diamonds on bent "
           "sheets.",
    .trouble = "Away from 90 degrees the same grid is less exactly developable (up to fifteen "
               "times at 45 degrees); that is the grid, not the net: it falls to a quarter with "
               "every halving. Solve coarse to fine (levels). Start from a grid that is already "
               "sheared when you have one.",
    .chart = LAM_CHART_NATURAL,
    .levels = 2,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "opposite_angle",
    .target_angle = target_angle};
