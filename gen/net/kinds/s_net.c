/* Principal symmetric nets: every star lies on a sphere of its own. A row of lam_nets
 * (net/kinds/nets.c); net/optimize.c calls it. */
#include "con/thesis/thesis.h"
#include "core/numbers.h"
#include "net/guide.h"
#include "net/net_kind.h"

typedef struct params {
  bool planar;
  double angle;
  bool angle_given;
} params;

/* A sphere or plane through every regular star; planar faces and one crossing angle on request. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  const params *p = given;
  static const lam_spherical_star_params own = {.spheres = LAM_SPHERES_OWN};
  lam_con_spherical_star.add(scope, &own, 1, location);

  /* All constraints leave out the same irregular vertices: they count once. */
  long skipped = scope->skipped;
  if (p->planar) lam_con_planar_face.add(scope, NULL, 1, location);
  if (p->angle_given)
    lam_con_angle.add(scope,
                      &(lam_angle_params){.angle = p->angle, .tangents = LAM_TANGENTS_CIRCLE}, 1,
                      location);
  scope->skipped = skipped;
}

/* The same with the coefficients of the spheres as further unknowns (thesis eq. 3.3). */
static void constrain_thesis(lam_scope *scope, const void *given, lam_location location) {
  (void)location;
  const params *p = given;
  lam_thesis_spherical_stars(scope);

  long skipped = scope->skipped;
  if (p->planar) lam_thesis_planar_faces(scope);
  if (p->angle_given) lam_thesis_circle_angle(scope, p->angle);
  scope->skipped = skipped; /* the same vertices */
}

/* Radians; NAN: the crossing angle is free. */
static double target_angle(const void *given) {
  const params *p = given;
  return p->angle_given ? p->angle : NAN;
}

static const lam_key keys[] = {
    LAM_FLAG_KEY(params, "planar", planar, "no",
                 "Faces are planar too. Possible where K > 0 (domes)."),
    LAM_ANGLE_KEY(
        params, "angle", angle, "90 deg", 5 * LAM_PI / 180, 175 * LAM_PI / 180,
        "The same crossing angle at every vertex. With planar: yes the ratio of the principal "
        "curvatures is then tan^2(angle / 2) everywhere. Left out: angles are free.",
        LAM_GIVEN(params, angle_given)),
    {0}};

static const char *const measures[] = {"star_sphericity",
                                       "principal_deviation",
                                       "star_curvature",
                                       "curvature_ratio",
                                       "circle_angle_deviation",
                                       "crossing_angle",
                                       "face_planarity",
                                       "edge_length",
                                       "shortest_edge",
                                       "foldovers",
                                       "overlaps",
                                       "flatness",
                                       NULL};

const lam_net_kind lam_net_s_net = {
    .head = {"s-net", "Principal symmetric net (S-net)",
             "Every vertex lies on one sphere with its four neighbors. Both polylines then have "
             "the same normal curvature at every vertex, and the principal directions of the "
             "surface halve the angles between them. Where the sphere is a plane the net is "
             "asymptotic: both kinds of vertices may stand in one net.",
             "2 N.E1 / |E1|^2 = 2 N.E2 / |E2|^2 at every star, N normal to both circles through "
             "three vertices",
             "thesis 3.2, def. 8, th. 4", keys, sizeof(params)},
    .use = "Spiral nets of towers and domes that show the surface's own directions as diagonals, "
           "as in Taut's glass pavilion and the Swiss Re tower. At a node both bars bend alike, so "
           "one curved connector serves both. planar: yes gives flat panels; planar: yes with an "
           "angle gives a surface whose panels repeat along lines.",
    .trouble = "The start must not follow the principal curvature lines: turn it by about 45 "
               "degrees against them (the diagonals of a principal net). Near umbilics (a sphere's "
               "top) any direction will do, and the net may swirl. planar: yes on a saddle has no "
               "solution but a plane or collapsed edges; with an angle as well the shape itself "
               "changes, by an edge length or so. Look at flatness, shortest_edge and the drift. "
               "More closeness (solver) keeps more of the start's height and leaves ripples; less "
               "smooths both away.",
    .chart = LAM_CHART_DIAGONAL,
    .schedule = LAM_GUIDED_SCHEDULE,
    .guide = {LAM_FAIR_POSITION, .15, 0},
    .constrain = constrain,
    .constrain_thesis = constrain_thesis,
    .measures = measures,
    .proof = "star_sphericity",
    .target_angle = target_angle};
