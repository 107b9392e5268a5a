/* Nets of flat faces. A row of lam_nets (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "net/net_kind.h"

/* The diagonals of every face meet. */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  (void)params;
  lam_con_planar_face.add(scope, NULL, 1, location);
}

/* The same with a normal as a further unknown in every face. */
static void constrain_thesis(lam_scope *scope, const void *params, lam_location location) {
  (void)params, (void)location;
  lam_thesis_planar_faces(scope);
}

static const char *const measures[] = {
    "face_planarity", "edge_length", "shortest_edge", "foldovers", "overlaps", "flatness", NULL};

const lam_net_kind lam_net_planar_quads = {
    .head = {"planar-quads", "Planar quad net",
             "Every face is flat. The net discretizes a conjugate net of the surface.",
             "distance of the diagonals / their mean length = 0 in every face", "thesis 3.1", NULL,
             0},
    .use = "Cladding of flat panels: every face can be cut from glass or sheet.",
    .trouble = "Start from a conjugate net: principal lines are the safe choice. Far from "
               "conjugate, faces turn to slivers; the shortest edge tells.",
    .chart = LAM_CHART_PRINCIPAL,
    .schedule = {.fairness = .3,
                 .hold = 0,
                 .decay = .5,
                 .floor = 2e-3,
                 .tolerance = 1e-10,
                 .max_iterations = 60},
    .guide = {LAM_FAIR_DISPLACEMENT, 0, 1},
    .file_closeness = .3,
    .constrain = constrain,
    .measures = measures,
    .proof = "face_planarity",
    .constrain_thesis = constrain_thesis};
