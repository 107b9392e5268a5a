/* Voss nets: geodesic nets with flat faces. A row of lam_nets (net/kinds/nets.c);
 * net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  bool boundary_length;
} params;

/* The conditions of a geodesic net, and flat faces. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_opposite_angles.add(scope, NULL, 1, location);
  lam_con_planar_face.add(scope, NULL, 1, location);
  if (p->boundary_length) lam_con_boundary_length.add(scope, NULL, 1, location);
}

static const lam_key keys[] = {LAM_FLAG_KEY(params, "boundary-length", boundary_length, "no",
                                            "Every side of the boundary keeps its length."),
                               {0}};

static const char *const measures[] = {"opposite_angle",
                                       "face_planarity",
                                       "geodesic_error_u",
                                       "geodesic_error_v",
                                       "gauss_image_area",
                                       "gauss_image_area_signed",
                                       "crossing_angle",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_voss = {
    .head = {"voss", "Voss net",
             "A geodesic net with flat faces: opposite angles are equal at every vertex and every "
             "face is planar. Such a net of rigid panels with hinges along its edges can be folded "
             "as a mechanism with one degree of freedom.",
             "<e1,e2> = <e3,e4>, <e2,e3> = <e4,e1>; faces planar", "thesis 3.4", keys,
             sizeof(params)},
    .use = "Foldable structures of flat panels, and cladding of flat panels on strips that unroll "
           "straight.",
    .trouble = "Voss nets are rare: expect the surface to change by edges, not by millimeters. "
               "Conjugate starts move least. The plane is one too; flattened is reported.",
    .chart = LAM_CHART_NATURAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "opposite_angle"};
