/* The table of starts: a line per kind of net, to be added with the kind (CONTRIBUTING.md). Read by
 * bench_sizes.c. */
#include "bench/bench.h"

/* Patches on which the nets below exist at any fineness. */
#define SADDLE "{kind: enneper, u: [-0.8, 0.8], v: [-0.8, 0.8]}"
#define DOME "{kind: monge, x2: -0.3, y2: -0.2, xy: 0.05}"
#define PATCH "{kind: torus, u: [0, 0.6], v: [-0.9, 0.9]}"
#define RING "{kind: torus, u: [0, 2], v: [-1.2, 1.2]}"
#define VASE "{kind: revolution, u: [0, 2.5], v: [0.1, 0.9]}"
#define EGG "{kind: ellipsoid, u: [-0.7, 0.7], v: [-0.7, 0.7]}"
#define BELLOWS "{kind: unduloid, neck: 0.4, u: [-1, 1], v: [-1, 1]}"
#define TRUMPET "{kind: pseudosphere}"

/* Kind, keys, surface, noise, aspect, measure. */
const lam_bench_start lam_bench_starts[] = {
    {"asymptotic", "orthogonal: yes", SADDLE, .05, 1, "star_planarity"},
    {"planar-quads", "", RING, .05, 1, "face_planarity"},
    {"chebyshev", "", DOME, .05, 1, "edge_variation"},
    {"isogonal", "angle: 80 deg", DOME, .05, 1, "angle_deviation"},
    {"s-net", "", DOME, .05, 1, "star_sphericity"},
    {"cmc", "", BELLOWS, .02, 1, "star_sphericity"},
    {"k-net", "", TRUMPET, .02, 1, "star_planarity"},
    {"geodesic-parallel", "geodesics: 1", VASE, .05, 1, "geodesic_error_v"},
    {"geodesic", "", PATCH, .02, 1, "opposite_angle"},
    {"voss", "", PATCH, .02, 1, "face_planarity"},
    {"dog", "", PATCH, 0, 1, "angle_spread"},
    {"dig", "", PATCH, 0, 1, "opposite_angle"},
    {"circular", "", EGG, .05, 1, "circularity"},
    {"conical", "", EGG, .05, 1, "conicality"},
    {"isothermic", "", SADDLE, .02, 1, "cross_ratio"},
    {"s-isothermic", "", SADDLE, .02, 1, "incircle_contact"},
    {"free", "constraints: [{kind: orthogonal}]", DOME, .05, 1, "crossing_angle"},
};
const int lam_bench_start_count = sizeof lam_bench_starts / sizeof *lam_bench_starts;
