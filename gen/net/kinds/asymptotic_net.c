/* Asymptotic nets: every vertex lies in a plane with its neighbors. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "core/numbers.h"
#include "net/guide.h"
#include "net/net_kind.h"

#include <math.h>

typedef struct params {
  bool orthogonal;
  double angle;
  bool angle_given;
  bool border;
} params;

static const double right_angle = LAM_PI / 2; /* radians */

/* `angle` and `orthogonal: yes` are two ways to say the same; both only if they agree. */
static void check(lam_scope *scope, const params *p, lam_location location) {
  if (p->orthogonal && p->angle_given && fabs(p->angle - right_angle) > 1e-12)
    lam_error_add(scope->errors, location, "net.angle",
                  "%g deg together with orthogonal: yes; expected one of the two",
                  p->angle * 90 / right_angle);
}

/* Planar stars, and where an angle is asked for, that angle between the tangents
 * of both polylines. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_star_params star = {.border = p->border};
  check(scope, p, location);
  lam_con_planar_star.add(scope, &star, 1, location);
  if (p->orthogonal)
    lam_con_orthogonal.add(scope, &star, 1, location);
  else if (p->angle_given)
    lam_con_angle.add(scope, &(lam_angle_params){.angle = p->angle, .border = p->border}, 1,
                      location);
}

/* The same with a normal as a further unknown at every star (thesis 3.6.2), and eq. 3.2
 * for the angle. */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  check(scope, p, location);
  lam_thesis_planar_stars(scope, p->border);
  if (p->orthogonal || p->angle_given)
    lam_thesis_angle(scope, p->orthogonal ? right_angle : p->angle, p->border);
}

/* Radians; NAN: the crossing angle is free. */
static double target_angle(const void *given) {
  const params *p = given;
  return p->orthogonal ? right_angle : p->angle_given ? p->angle : NAN;
}

static const lam_key keys[] = {
    LAM_FLAG_KEY(params, "orthogonal", orthogonal, "no",
                 "Right angles at every vertex: a discrete minimal surface."),
    LAM_ANGLE_KEY(
        params, "angle", angle, "90 deg", 5 * LAM_PI / 180, 175 * LAM_PI / 180,
        "The same crossing angle at every vertex: a constant ratio of the principal curvatures.",
        LAM_GIVEN(params, angle_given)),
    LAM_FLAG_KEY(params, "border", border, "yes",
                 "Vertices of the border take part: their edges are coplanar, and reentrant "
                 "corners, which have four edges, keep the angle."),
    {0}};

static const char *const measures[] = {"star_planarity", "angle_deviation", "crossing_angle",
                                       "edge_length",    "shortest_edge",   "foldovers",
                                       "overlaps",       "flatness",        NULL};

const lam_net_kind lam_net_asymptotic = {
    .head = {"asymptotic", "Asymptotic net",
             "The polylines follow the asymptotic curves of a saddle-shaped surface: every vertex "
             "lies in one plane with its four neighbors. With right angles the surface is minimal; "
             "with another constant angle the ratio of its principal curvatures is constant.",
             "N.e1 = N.e2 = 0 at every star; T1.T2 = cos(angle)", "thesis 3.3 and 3.2.4", keys,
             sizeof(params)},
    .use = "The asymptotic gridshell: strips normal to the net have no normal curvature, so "
           "they unroll straight and can be cut from straight stock. With a constant angle all "
           "nodes are alike.",
    .trouble = "Exists only where K < 0: a dome can only flatten, which is reported as degenerate.",
    .chart = LAM_CHART_ASYMPTOTIC,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "star_planarity",
    .target_angle = target_angle,
    .constrain_thesis = constrain_thesis};
