/* Conical nets: flat faces that touch a cone of revolution at every vertex. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

/* Flat faces; at every vertex both pairs of opposite angles have the same sum (thesis
 * 3.5.2, theorem 11). */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  (void)params;
  lam_con_planar_face.add(scope, NULL, 1, location);
  lam_con_conical.add(scope, NULL, 1, location);
}

static const char *const measures[] = {"face_planarity", "conicality", "edge_length",
                                       "shortest_edge",  "foldovers",  "overlaps",
                                       "flatness",       NULL};

const lam_net_kind lam_net_conical = {
    .head = {"conical", "Conical net",
             "Every face is flat and the four faces at every vertex touch a cone of revolution: a "
             "discrete net of curvature lines. Axes of neighboring cones lie in one plane. All "
             "face planes moved by one distance form another conical net with the same axes, and "
             "the face normals form a circular net on the unit sphere.",
             "planar faces; a12 + a34 = a23 + a41 at every vertex",
             "thesis 3.5.2, theorem 11; Liu et al. 2006", NULL, 0},
    .use = "Glass roofs: panels of one thickness meet without steps, beams of one height between "
           "the axes of the cones are flat and run into every node without torsion (part "
           "`support`), and layers at a constant distance have flat panels again.",
    .trouble = "Curvature lines are given by the shape: start from the principal lines of a "
               "surface, not across them. Angles near 180 degrees (flat and nearly developable "
               "places) leave the axis of a cone almost free: look at `conicality`, which is "
               "measured between face planes, not only at the residual. Vertices with more than "
               "four faces are left out and counted in the report. Infeasible handles or a fixed "
               "boundary: the report says stalled.",
    .chart = LAM_CHART_PRINCIPAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "conicality"};
