/* Circular nets: flat faces with circumcircles. A row of lam_nets (net/kinds/nets.c);
 * net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

/* Four points on a circle: they lie in a plane, and both pairs of opposite angles of the face
 * have the same sum (thesis 3.5.1, theorem 10). */
static void constrain(lam_scope *scope, const void *params, lam_location location) {
  (void)params;
  lam_con_planar_face.add(scope, NULL, 1, location);
  lam_con_circular.add(scope, NULL, 1, location);
}

static const char *const measures[] = {"face_planarity", "circularity", "edge_length",
                                       "shortest_edge",  "foldovers",   "overlaps",
                                       "flatness",       NULL};

const lam_net_kind lam_net_circular = {
    .head = {"circular", "Circular net",
             "Every face is flat and its four corners lie on a circle: a discrete net of curvature "
             "lines. A vertex normal, mirrored from vertex to vertex by the planes that bisect the "
             "edges, gives the same normals on any way; the vertices moved along them by one "
             "distance form another circular net with parallel edges and faces.",
             "planar faces; b1 + b3 = b2 + b4 for the angles of every face",
             "thesis 3.5.1, theorem 10", NULL, 0},
    .use = "Flat panels in two layers at a constant distance between the nodes: the struts "
           "between both layers have one length, and beams between neighboring struts are flat, "
           "without torsion in the nodes (part `support`). Circumcircles make a pattern of their "
           "own (part `circles`).",
    .trouble = "Curvature lines are given by the shape: a start across them is pushed towards a "
               "plane or a sphere, or the faces turn to slivers. Start from the principal lines of "
               "a surface. Umbilics (all of a sphere, four points of an ellipsoid) are irregular "
               "vertices, where faces may fold or edges collapse: the report says so, and `solver: "
               "{stiffness: 3}` helps. Fixing the whole boundary, or handles far from the start, "
               "leaves too little freedom: the report says stalled.",
    .chart = LAM_CHART_PRINCIPAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "circularity"};
