/* Isothermic nets: circular, with the cross-ratio -1 in every face. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

/* In a face with a circumcircle, equal products of opposite edges mean the cross-ratio -1. */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  (void)params;
  lam_con_planar_face.add(scope, NULL, 1, location);
  lam_con_circular.add(scope, NULL, 1, location);
  lam_con_isothermic.add(scope, NULL, 1, location);
}

static const char *const measures[] = {"face_planarity", "circularity",   "cross_ratio",
                                       "edge_length",    "shortest_edge", "foldovers",
                                       "overlaps",       "flatness",      NULL};

const lam_net_kind lam_net_isothermic = {
    .head = {"isothermic", "Isothermic net",
             "A circular net whose faces have the cross-ratio -1: curvature lines that divide "
             "the surface into infinitesimal squares. Surfaces of revolution, quadrics, "
             "minimal surfaces and surfaces of constant mean curvature have such nets; most "
             "surfaces do not.",
             "circular; |e1||e3| = |e2||e4| in every face", "thesis 3.5.3, definition 25", NULL, 0},
    .use = "Panels as square as a curved surface allows, all but similar to each other. The start "
           "of S-isothermic nets, and by its diagonals of nets of constant normal curvature.",
    .trouble = "Three equations per face leave the shape hardly any freedom: the net slides "
               "along the surface or leaves it until its cells are square. Give the start cells "
               "of equal sides (`grid` against `u`, `v`), and leave the boundary free. Look at "
               "the largest move: if the net has left the surface, the surface has no such net "
               "near that start.",
    .chart = LAM_CHART_PRINCIPAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "cross_ratio"};
