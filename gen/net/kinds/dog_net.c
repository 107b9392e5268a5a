/* Orthogonal geodesic nets, which lie on developable surfaces. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  bool border;
  bool boundary_length;
} params;

/* Four equal angles at every regular vertex. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_equal_angles.add(scope, &(lam_star_params){.border = p->border}, 1, location);
  if (p->boundary_length) lam_con_boundary_length.add(scope, NULL, 1, location);
}

static const lam_key keys[] = {
    LAM_FLAG_KEY(params, "border", border, "no",
                 "Lines meet the border at equal angles to both sides: a calmer border, and fewer "
                 "shapes to choose from."),
    LAM_FLAG_KEY(params, "boundary-length", boundary_length, "no",
                 "Every side of the boundary keeps its length. Opposite sides of such a net are "
                 "equally long: a start whose sides differ cannot keep them."),
    {0}};

static const char *const measures[] = {"angle_spread",
                                       "opposite_angle",
                                       "gauss_image_area",
                                       "gauss_image_area_signed",
                                       "orthogonality",
                                       "straightness_u",
                                       "straightness_v",
                                       "edge_variation_u",
                                       "edge_variation_v",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_dog = {
    .head = {"dog", "Orthogonal geodesic net (developable)",
             "At every vertex the four angles are equal. Both families are geodesics that cross at "
             "right angles, and only developable surfaces carry such a net: it bends like paper, "
             "and its lines need not follow the rulings.",
             "<e1,e2> = <e2,e3> = <e3,e4> = <e4,e1>",
             "thesis 3.4.1; Rabinovich, Hoffmann & Sorkine-Hornung 2018", keys, sizeof(params)},
    .use = "Shapes of sheet metal, plywood, paper or felt that are laid out flat and bent: a patch "
           "of any surface turns into the developable surface near it. The strips of both families "
           "unroll straight.",
    .trouble =
        "The result is developable up to the grid: halving the edge quarters what is left of the "
        "Gauss image, so refine rather than push. A single fine grid on a strongly curved start "
        "zigzags or folds; coarse grids are solved first (levels). Curvature of both signs in one "
        "patch folds most easily: more levels, or smaller patches. Fairness without closeness "
        "flattens. Handles belong on inner vertices.",
    .chart = LAM_CHART_NATURAL,
    .levels = 2,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "angle_spread"};
