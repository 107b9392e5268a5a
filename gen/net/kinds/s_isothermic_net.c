/* S-isothermic nets: touching spheres at the vertices and touching incircles in the faces. A row
 * of lam_nets (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

/* One constraint holds all equations, for they share the radii as further unknowns. */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  lam_con_s_isothermic.add(scope, params, 1, location);
}

static const char *const measures[] = {
    "face_planarity", "incircle_contact", "edge_length", "shortest_edge",
    "foldovers",      "overlaps",         "flatness",    NULL};

const lam_net_kind lam_net_s_isothermic = {
    .head = {"s-isothermic", "S-isothermic net",
             "Every face is flat and has an incircle, incircles of neighboring faces touch, and so "
             "do the spheres around neighboring vertices, in the same points: a packing of circles "
             "and spheres on the surface. It discretizes isothermic curvature lines. The radii are "
             "unknowns of their own.",
             "|v_i - v_j| = rho_i + rho_j; |v - c|^2 = rho^2 + R^2, c in the plane of the face",
             "thesis 3.5.3, definition 26", NULL, 0},
    .use = "Packings of rings or balls that follow a surface (part `circles`): screens, ceilings, "
           "ornaments. Rings bolted where they touch make a stiff net.",
    .trouble = "Exists near isothermic grids only: start from square cells on the principal "
               "lines of a minimal surface, a surface of constant mean curvature or one of "
               "revolution (Enneper, Scherk, unduloid, catenoid). From an ellipsoid or a free "
               "form, solve an isothermic net first. There is little freedom for handles: the "
               "report says stalled.",
    .chart = LAM_CHART_PRINCIPAL,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "incircle_contact"};
