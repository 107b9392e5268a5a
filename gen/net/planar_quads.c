#include "net/kind.h"

static void constrain(lam_scope *scope, const void *params, lam_place place) {
  (void)params;
  lam_con_planar_face.add(scope, NULL, 1, place);
}

static const char *const measures[] = {"face_planarity", "edge_length", "shortest_edge", "foldovers", "flatness", NULL};

const lam_net_kind lam_net_planar_quads = {
    {"planar-quads", "Planar quad net",
     "Every face is flat and can be cut from glass or sheet. The net discretizes a conjugate net of the surface, so it "
     "should start "
     "from one: principal lines are the safe choice. Far from conjugate, faces turn to slivers; the shortest edge "
     "tells.",
     "distance of the diagonals / their mean length = 0 in every face", "thesis 3.1", NULL, 0},
    LAM_CHART_PRINCIPAL,
    {.fairness = .3, .hold = 0, .decay = .5, .floor = 2e-3, .tolerance = 1e-10, .max_iterations = 60},
    {LAM_FAIR_DISPLACEMENT, 0, 1},
    constrain,
    measures,
    NULL};
