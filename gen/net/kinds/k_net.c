/* K-nets: asymptotic nets of equal edges, on surfaces of constant negative Gaussian curvature. A
 * row of lam_nets (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  double length; /* meters; 0: the mean edge of the start */
  bool border;
} params;

/* Planar stars and one length for all edges. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_planar_star.add(scope, &(lam_star_params){.border = p->border}, 1, location);
  lam_edge_length_add(scope, "edge-length", LAM_HARD, 1,
                      (lam_edge_length_params){.length = p->length > 0 ? p->length : scope->unit});
}

/* The same with normals as further unknowns; edge lengths need none, as their squares are
 * quadratic in the vertices. */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  (void)location;
  const params *p = given;
  lam_thesis_planar_stars(scope, p->border);
  lam_edge_length_add(scope, "edge-length", LAM_HARD, 1,
                      (lam_edge_length_params){.length = p->length > 0 ? p->length : scope->unit});
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(params, "length", length, "0", 0, 1e6,
                   "Length of every edge. 0: the mean edge of the start."),
    LAM_FLAG_KEY(params, "border", border, "yes",
                 "Vertices of the border take part: their edges are coplanar."),
    {0}};

static const char *const measures[] = {
    "star_planarity", "edge_variation", "gauss_curvature", "edge_length", "crossing_angle",
    "shortest_edge",  "foldovers",      "overlaps",        "flatness",    NULL};

const lam_net_kind lam_net_k_net = {
    .head = {"k-net", "K-net",
             "An asymptotic net all of whose edges are equally long: it lies on a surface of "
             "constant negative Gaussian curvature. Its polylines have constant torsion of either "
             "sign, and K = - torsion^2.",
             "N.e1 = N.e2 = 0 at every star; |v1 - v0| = L at every edge",
             "thesis 3.3 and 3.1, def. 3", keys, sizeof(params)},
    .use = "Asymptotic gridshells of equal bars: strips normal to the surface unroll straight, "
           "with holes at one spacing, so every lamella is the same piece but for its ends; the "
           "grid can be folded flat. All twist at one rate.",
    .trouble = "Exists only where K < 0, and the equations are more than the unknowns: they agree "
               "(a quad of equal sides twists evenly), but handles and fixed boundaries soon "
               "contradict them, which is reported as stalled. Two polylines of one family each "
               "may be held; the rest follows from them. Far along, angles run to 0 or 180 "
               "degrees, where the surface has an edge of cusps: stop the net before.",
    .chart = LAM_CHART_ASYMPTOTIC,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .constrain_thesis = constrain_thesis,
    .measures = measures,
    .proof = "star_planarity"};
