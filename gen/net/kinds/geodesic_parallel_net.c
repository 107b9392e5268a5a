/* Geodesic parallel coordinates: a family of geodesics and lines across at right angles. A row of
 * lam_nets (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "net/net_kind.h"

typedef enum developable { DEVELOPABLE_NO, DEVELOPABLE_ONE_LINE, DEVELOPABLE_THESIS } developable;
typedef enum widths { WIDTHS_FREE, WIDTHS_EQUAL, WIDTHS_PROPORTIONAL, WIDTHS_CONSTANT } widths;
static const char *const developables[] = {"no", "one-line", "thesis", NULL};
static const char *const width_choices[] = {"free", "equal", "proportional", "constant", NULL};

typedef struct params {
  int geodesics; /* the family of the geodesics, 0 or 1 */
  bool border;
  int developable; /* developable */
  int widths;      /* widths */
  bool isometric;
} params;

/* Geodesics and right angles at every star; the keys add conditions on the strips
 * between two geodesics. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_con_geodesic_parallel.add(scope, &(lam_geodesic_params){p->geodesics, p->border}, 1,
                                location);

  /* Jacobi's equation with K = 0: strip widths change linearly along evenly divided geodesics. */
  if (p->developable != DEVELOPABLE_NO) {
    int lines = p->developable == DEVELOPABLE_THESIS ? LAM_LINES_ALL : LAM_LINES_MIDDLE;
    lam_con_jacobi.add(scope, &(lam_family_params){p->geodesics}, 1, location);
    lam_con_equal_edges.add(scope, &(lam_equal_edges_params){p->geodesics, lines}, 1, location);
  }

  if (p->widths != WIDTHS_FREE)
    lam_con_strip_widths.add(scope, &(lam_strip_params){p->geodesics, p->widths - WIDTHS_EQUAL}, 1,
                             location);
  if (p->isometric)
    lam_con_edge_length.add(scope, &(lam_edge_length_params){0, false}, 1, location);
}

/* The condition on the stars alone with unit edges as further unknowns (thesis 3.7.2). */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  if (p->developable != DEVELOPABLE_NO || p->widths != WIDTHS_FREE || p->isometric)
    lam_error_add(scope->errors, location, "net.solver",
                  "thesis together with developable, widths or isometric; expected lamella, or "
                  "none of these keys");

  lam_thesis_geodesic_parallel(scope, p->geodesics, p->border);
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(params, "geodesics", geodesics, "0", 0, 1,
                    "Family whose lines are geodesics: 0, along u, or 1, along v."),
    LAM_FLAG_KEY(params, "border", border, "yes",
                 "Geodesics meet the border where they end at right angles too; without it the "
                 "lines across zigzag."),
    LAM_CHOICE_KEY(params, "developable", developable, "no", developables,
                   "Strips whose width changes linearly: nearly developable. one-line: one "
                   "geodesic is divided evenly, the others follow; thesis: all are, which is one "
                   "equation too many per line, so that a small residual stays."),
    LAM_CHOICE_KEY(params, "widths", widths, "free", width_choices,
                   "Widths of the strips between geodesics. equal: the same at every line across, "
                   "isometric to a surface of revolution, strips are copies; proportional: the "
                   "same up to a factor; constant: along each strip."),
    LAM_FLAG_KEY(
        params, "isometric", isometric, "no",
        "All edges keep their length at the start: bending without stretching. Over-determined: a "
        "residual of about 1e-4 of an edge stays, and strain tells how much the net stretched."),
    {0}};

static const char *const measures[] = {"straightness_u",
                                       "straightness_v",
                                       "geodesic_error_u",
                                       "geodesic_error_v",
                                       "orthogonality",
                                       "edge_variation_u",
                                       "edge_variation_v",
                                       "spacing_u",
                                       "spacing_v",
                                       "edge_strain",
                                       "shear_strain",
                                       "gauss_image_area",
                                       "gauss_image_area_signed",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_geodesic_parallel = {
    .head =
        {"geodesic-parallel", "Geodesic parallel coordinates",
         "One family are geodesics, the other crosses them at right angles, at constant distances: "
         "every surface has such nets, and the geodesics through one line across are free to "
         "choose. Bent strips of wood or steel that lie flat on the surface follow geodesics; "
         "straight planks clad it along them. Keys make the net nearly developable, isometric to a "
         "surface of revolution, or bend it without stretching.",
         "<e1, e2 - e4> = <e3, e2 - e4> = 0", "thesis 3.3", keys, sizeof(params)},
    .use = "Timber gridshells and cladding of planks: strips along geodesics unroll straight, "
           "whatever the surface. With equal widths all strips are copies of one pattern; "
           "developable nets can be made of felt, leather, paper or sheet metal. Give `reference` "
           "to lay the net on a given surface, solver: {fairness: 0.01} with it.",
    .trouble = "On a reference nothing says where the net stays: fairness slides it, so pin "
               "vertices by handles when it matters, and expect lines to crowd where K > 0 focuses "
               "geodesics - end the net before they meet. Handles on corners do nothing; take [1, "
               "1]. With isometric: yes or developable: thesis the report says stalled and "
               "over-determined: judge edge_strain, not the residual. Handles that only stretching "
               "can reach show as strains of a percent and more.",
    .chart = LAM_CHART_NATURAL,
    .schedule = {.fairness = 0,
                 .hold = 3,
                 .decay = .464,
                 .floor = 9e-5,
                 .tolerance = 1e-12,
                 .max_iterations = 100},
    .guide = {LAM_FAIR_POSITION, 0, 0},
    .constrain = constrain,
    .constrain_thesis = constrain_thesis,
    .measures = measures,
    .proof = "orthogonality"};
