/* Nets of constant normal curvature: every star lies on a sphere of one radius. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "core/numbers.h"
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  double radius; /* meters, signed as in lam_spherical_star_params; 0: found by the solver */
  bool isogonal;
  double angle;
  bool angle_given;
  bool border;
} params;

/* An angle says nothing where `isogonal: no` lets the angles free. */
static void check(lam_scope *scope, const params *p, lam_location location) {
  if (!p->isogonal && p->angle_given)
    lam_error_add(scope->errors, location, "net.angle",
                  "given together with isogonal: no; expected one of the two");
}

/* Spheres of one radius through all stars, and one angle between the tangents of the circles
 * through three vertices of either polyline. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  lam_spherical_star_params spheres = {p->radius, LAM_SPHERES_COMMON, p->border};
  lam_con_spherical_star.add(scope, &spheres, 1, location);
  check(scope, p, location);
  if (!p->isogonal) return;

  /* Both constraints leave out the same irregular vertices: they count once. */
  long skipped = scope->skipped;
  lam_angle_params angle = {p->angle, p->border, LAM_TANGENTS_CIRCLE};
  lam_con_angle.add(scope, &angle, 1, location);
  scope->skipped = skipped;
}

/* Largest radius with centers as unknowns, in mean edges: the coordinates of a center that is
 * very far away have no digits left for the sphere. */
static const double farthest = 1e4;

/* The same with centers and tangents as further unknowns (thesis 3.2.3). */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  check(scope, p, location);
  if (fabs(p->radius) > farthest * scope->unit)
    lam_error_add(scope->errors, location, "net.radius",
                  "%g m; with solver: thesis expected at most %g m, ten thousand mean edges",
                  p->radius, farthest * scope->unit);
  else
    lam_thesis_equal_spheres(scope, p->radius / scope->unit, p->isogonal ? p->angle : NAN);
}

/* Radians; NAN: the crossing angle is free. */
static double target_angle(const void *given) {
  const params *p = given;
  return p->isogonal ? p->angle : NAN;
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(params, "radius", radius, "0", -1e12, 1e12,
                   "Radius of every sphere, 1 / mean curvature; negative when the centers lie "
                   "behind the surface, seen from the tip of its normal (a tube or dome with "
                   "normals outwards). 0: one radius for all is found."),
    LAM_FLAG_KEY(params, "isogonal", isogonal, "yes",
                 "One crossing angle everywhere. no: angles are free; a net of constant normal "
                 "curvature on a surface whose mean curvature varies."),
    LAM_ANGLE_KEY(params, "angle", angle, "90 deg", 5 * LAM_PI / 180, 175 * LAM_PI / 180,
                  "That crossing angle. Only 90 deg makes the mean curvature constant.",
                  LAM_GIVEN(params, angle_given)),
    LAM_FLAG_KEY(params, "border", border, "no",
                 "Vertices of the border take part: they lie on a sphere of that radius with their "
                 "three neighbors, so that strips keep it to their ends, and reentrant corners, "
                 "which have four edges, keep the angle. Not for tubes, or starts with much noise: "
                 "solve these without it first. With solver: thesis the border is free."),
    {0}};

static const char *const measures[] = {"star_curvature",
                                       "curvature_spread",
                                       "star_sphericity",
                                       "mean_curvature",
                                       "circle_angle_deviation",
                                       "crossing_angle",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_cmc = {
    .head = {"cmc", "Net of constant normal curvature (CMC net)",
             "Every vertex lies with its four neighbors on a sphere of one radius r, and the "
             "families cross at right angles: a discrete surface of constant mean curvature 1/r, "
             "as soap films under pressure have, covered by the diagonals of its isothermic "
             "curvature lines. As r grows without limit the net becomes an orthogonal asymptotic "
             "net on a minimal surface.",
             "2 N.E1 / |E1|^2 = 2 N.E2 / |E2|^2 = 1/r, t1.t2 = cos(angle), t: tangents of circles "
             "through three vertices",
             "thesis 3.2, th. 3 and 5, cor. 1, def. 10", keys, sizeof(params)},
    .use = "Gridshells of repeated parts: strips normal to the surface unroll to arcs of the one "
           "radius r, so they are cut from sheet, or bent to one template, whatever their place; "
           "all nodes are right-angled and alike. Inflated roofs and membranes under even pressure "
           "have this shape.",
    .trouble = "Start near a surface of constant mean curvature, from the diagonals of an "
               "isothermic (square) curvature net: unduloid, nodoid and catenoid give one. The "
               "radius grows with the design: to get another one, leave it out, read "
               "star_curvature (1 / radius, with its sign) and change size by as much; a radius a "
               "quarter off, or of the wrong sign, squeezes edges until the net collapses or "
               "stalls. Closed rings and fixed boundaries prescribe much: leave the radius out or "
               "free the boundary then. Drag boundaries, not rings inside, which become jagged.",
    .chart = LAM_CHART_DIAGONAL,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .constrain_thesis = constrain_thesis,
    .measures = measures,
    .proof = "star_curvature",
    .target_angle = target_angle};
