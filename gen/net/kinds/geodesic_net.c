/* Geodesic nets: opposite angles are equal at every vertex. A row of lam_nets (net/kinds/nets.c);
 * net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  bool boundary_length;
} params;

/* Opposite angles of every regular star are equal, so that both polylines are geodesics. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_opposite_angles.add(scope, NULL, 1, location);
  if (p->boundary_length) lam_con_boundary_length.add(scope, NULL, 1, location);
}

static const lam_key keys[] = {LAM_FLAG_KEY(params, "boundary-length", boundary_length, "no",
                                            "Every side of the boundary keeps its length."),
                               {0}};

static const char *const measures[] = {"opposite_angle",
                                       "geodesic_error_u",
                                       "geodesic_error_v",
                                       "straightness_u",
                                       "straightness_v",
                                       "gauss_image_area",
                                       "gauss_image_area_signed",
                                       "crossing_angle",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_geodesic = {
    .head = {"geodesic", "Geodesic net",
             "The lines of both families are geodesics: opposite angles are equal at every vertex. "
             "Few surfaces carry such a net with quads of similar size (where K > 0 geodesics "
             "meet, where K < 0 they part), so the surface changes to one that does.",
             "<e1,e2> = <e3,e4>, <e2,e3> = <e4,e1>", "thesis 3.4, eq. 3.10 completed", keys,
             sizeof(params)},
    .use = "Gridshells of flat-lying strips in both directions: every strip unrolls "
           "straight, and bends only across its weak side. With planar faces as well it is a "
           "Voss net (kind: voss).",
    .trouble = "Nothing keeps the size of the net but its start; use boundary-length, handles or "
               "boundary: fixed. Fairness without closeness pulls it flat, which is reported.",
    .chart = LAM_CHART_NATURAL,
    .levels = 2,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "opposite_angle"};
