/* Isogonal molding nets: a profile carried along a polyline on the ground. A row of lam_nets
 * (net/kinds/nets.c); it makes its own start, called by design/net_stage.c, which meets its
 * constraints before net/optimize.c begins. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "curve/cubic_spline.h"
#include "net/guide.h"
#include "net/net_kind.h"

#include <math.h>

/* Lists of double. The trajectory is the polyline on the ground; of n edges, which are the net's
 * cells along family 0. Its turn angles are positive to the left. */
typedef struct params {
  lam_list turn;    /* radians: total turn of each section */
  lam_list edges;   /* meters: lengths along the trajectory */
  lam_list profile; /* meters: distance from the trajectory and height of each point */
} params;

/* Half of the turning angle per vertex in the section of edge i of n, radians: every
 * section spreads its turn evenly over its edges. Precondition: n is a multiple of the
 * number of sections. */
static double half_turn(const params *p, int n, int i) {
  const double *turn = p->turn.items;
  int per_section = n / p->turn.count;
  return turn[i / per_section] / per_section / 2;
}

/* Half of the turning angle at vertex i, 0 <= i <= n: between two sections the mean of both. */
static double vertex_turn(const params *p, int n, int i) {
  double before = half_turn(p, n, i > 0 ? i - 1 : 0), after = half_turn(p, n, i < n ? i : n - 1);
  return (before + after) / 2;
}

/* Length of edge i of n in meters: the listed lengths belong to evenly spread edges from the
 * first to the last, and edges between them are interpolated linearly. */
static double edge_length(const params *p, int n, int i) {
  const double *edges = p->edges.items;
  if (p->edges.count == 1 || n == 1) return edges[0];
  double at = (double)i * (p->edges.count - 1) / (n - 1);
  int k = (int)fmin(floor(at), p->edges.count - 2);
  return edges[k] + (at - k) * (edges[k + 1] - edges[k]);
}

/* m + 1 points (distance, height) of the profile in the arena. As many listed points are taken as
 * they are; otherwise a cubic spline through them, by chord length, is divided evenly. */
static double *profile_points(lam_arena *arena, const params *p, int m) {
  int count = p->profile.count / 2;
  double *points = LAM_NEW(arena, double, 2 * (m + 1));
  const double *given = p->profile.items;

  /* With steps of 1 the division meets the listed points exactly. */
  double *t = LAM_NEW(arena, double, count);
  for (int i = 1; i < count; i++)
    t[i] = t[i - 1] + (m + 1 == count ? 1
                                      : hypot(given[2 * i] - given[2 * i - 2],
                                              given[2 * i + 1] - given[2 * i - 1]));

  lam_spline spline = lam_spline_make(arena, count, 2, t, given);
  for (int j = 0; j <= m; j++) {
    double dx[2], ddx[2];
    lam_spline_eval(&spline, t[count - 1] * j / m, points + 2 * j, dx, ddx);
  }
  return points;
}

/* ---- what cannot be built ---- */

/* Sections have equal numbers of cells, and the vertex planes must not be parallel to their
 * edges: half turns stay below 45 degrees. Returns false when half_turn must not be called. */
static bool check_turn(const params *p, int n, lam_location location, lam_errors *errors) {
  if (p->turn.count == 0 || n % p->turn.count != 0) {
    lam_error_add(errors, location, "net.turn",
                  "%d sections for %d cells along the trajectory; expected a divisor of %d",
                  p->turn.count, n, n);
    return false;
  }

  for (int i = 0; i < n; i += n / p->turn.count)
    if (!(fabs(half_turn(p, n, i)) < LAM_PI / 4))
      lam_error_add(errors, location, "net.turn",
                    "%g deg at every vertex; expected less than 90 deg (more cells)",
                    2 * half_turn(p, n, i) * 180 / LAM_PI);
  return true;
}

/* At least one length, all of them positive. */
static void check_edges(const params *p, lam_location location, lam_errors *errors) {
  const double *edges = p->edges.items;
  if (p->edges.count == 0)
    lam_error_add(errors, location, "net.edges", "none given; expected at least one length");
  for (int i = 0; i < p->edges.count; i++)
    if (!(edges[i] > 0))
      lam_error_add(errors, location, "net.edges", "length %d is %g m; expected more", i + 1,
                    edges[i]);
}

/* Whole points, at least two, and no two in a row at the same position. */
static void check_profile(const params *p, lam_location location, lam_errors *errors) {
  const double *profile = p->profile.items;
  if (p->profile.count % 2 != 0 || p->profile.count < 4)
    lam_error_add(errors, location, "net.profile",
                  "%d numbers given; expected two for each of at least 2 points", p->profile.count);
  for (int i = 2; i + 1 < p->profile.count; i += 2)
    if (profile[i] == profile[i - 2] && profile[i + 1] == profile[i - 1])
      lam_error_add(errors, location, "net.profile", "points %d and %d are the same", i / 2,
                    i / 2 + 1);
}

/* Adds what is wrong with the keys to errors; false then. */
static bool check(const params *p, const int grid[2], lam_location location, lam_errors *errors) {
  int before = errors->count;
  if (!check_turn(p, grid[0], location, errors)) return false;
  check_edges(p, location, errors);
  check_profile(p, location, errors);
  return errors->count == before;
}

/* Whether all lines along the trajectory run forward. At the distance a to the left of an edge of
 * length l the line between the vertex planes is l - a (tan h + tan h') long, h and h' the half
 * turns at the ends of the edge; it must keep a millionth of l. profile: grid[1] + 1 points. */
static bool check_folds(const params *p, const int grid[2], const double *profile,
                        lam_location location, lam_errors *errors) {
  int n = grid[0];
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= grid[1]; j++) {
      double bend = tan(vertex_turn(p, n, i)) + tan(vertex_turn(p, n, i + 1)),
             length = edge_length(p, n, i);
      if (length - profile[2 * j] * bend > 1e-6 * length) continue;

      lam_error_add(errors, location, "net.profile",
                    "reaches %g m to the %s, but the trajectory's edge %d of %g m turns around a "
                    "center at %g m; expected smaller distances, longer edges or less turn",
                    fabs(profile[2 * j]), bend > 0 ? "left" : "right", i + 1, length,
                    fabs(length / bend));
      return false;
    }
  return true;
}

/* ---- the net ---- */

/* The start (thesis 3.5.4, definition 28): vertex (i, j) is profile point j in vertex plane i.
 *
 * Vertex planes bisect the angle of their edges, and the end planes are mirrored by the planes
 * that bisect the end edges, so that the faces on an edge with the same turn at both ends are
 * isosceles trapezoids. A profile point at the distance a from the trajectory lies a / cos(half
 * turn) away in the vertex plane: all lines along the trajectory are parallel to it. The first
 * vertex plane is square to x. */
static bool start(lam_arena *arena, const void *given, const int grid[2], lam_location location,
                  lam_errors *errors, lam_mesh *mesh) {
  const params *p = given;
  int n = grid[0], m = grid[1];
  if (!check(p, grid, location, errors)) return false;
  const double *profile = profile_points(arena, p, m);
  if (!check_folds(p, grid, profile, location, errors)) return false;

  *mesh = lam_mesh_grid(arena, n + 1, m + 1, false, false);
  /* (x, y): the trajectory's vertex i; direction: of the edge that arrives there */
  double x = 0, y = 0, direction = -vertex_turn(p, n, 0);
  for (int i = 0; i <= n; i++) {
    double half = vertex_turn(p, n, i), normal = direction + half + LAM_PI / 2;
    for (int j = 0; j <= m; j++) {
      double a = profile[2 * j] / cos(half);
      mesh->vertices[i * (m + 1) + j] =
          lam_v3(x + a * cos(normal), y + a * sin(normal), profile[2 * j + 1]);
    }
    if (i == n) break;

    direction += 2 * half;
    x += edge_length(p, n, i) * cos(direction);
    y += edge_length(p, n, i) * sin(direction);
  }
  return true;
}

/* Whether all sections turn by the same angle to the same side: every face is an isosceles
 * trapezoid then, and has a circumcircle. */
static bool turns_evenly(const params *p) {
  const double *turn = p->turn.items;
  for (int i = 1; i < p->turn.count; i++)
    if (fabs(turn[i] - turn[0]) > 1e-12) return false;
  return true;
}

/* What the start fulfills, so that it stays true when handles or further constraints move it. */
static void constrain(lam_scope *scope, const void *given, lam_location location) {
  lam_con_planar_face.add(scope, NULL, 1, location);
  lam_con_conical.add(scope, NULL, 1, location);
  if (turns_evenly(given)) lam_con_circular.add(scope, NULL, 1, location);
}

static const char *const measures[] = {"face_planarity", "conicality", "circularity", "edge_length",
                                       "shortest_edge",  "foldovers",  "overlaps",    NULL};

static const lam_key keys[] = {
    LAM_ANGLE_KEY(params, "turn", turn, "120 deg", -20 * LAM_PI, 20 * LAM_PI,
                  "By how much the trajectory turns to the left in all; a list: in each of so many "
                  "sections with equal numbers of cells."),
    LAM_LENGTH_KEY(params, "edges", edges, "[1 m]", 0, 0,
                   "Length of the trajectory's edges; a list: from the first to the last edge, "
                   "evenly spread and joined by straight lines."),
    LAM_LENGTH_KEY(params, "profile", profile,
                   "[-2 m, 0,  -1.5 m, 1.5 m,  0, 2.4 m,  1.5 m, 1.5 m,  2 m, 0]", 0, 0,
                   "For points of the profile the distance from the trajectory, positive to the "
                   "left, and the height. As many points as the grid asks for are its corners; "
                   "otherwise a smooth curve through them is divided."),
    {0}};

const lam_net_kind lam_net_isogonal_molding = {
    .head = {"isogonal-molding", "Isogonal molding net",
             "A profile of straight edges carried along a polyline on the ground that turns by "
             "the same angle at every vertex. All faces are isosceles trapezoids: the net is "
             "circular and conical at once, has offsets of both kinds, and every line along the "
             "trajectory is parallel to it. Nodes are congruent along the trajectory; across it "
             "they are not, for the profile bends differently at each. Edge lengths along the "
             "trajectory are free.",
             "v_ij = p_i + a_j / cos(turn / 2) m_i + b_j z, m_i bisecting the edges at p_i",
             "thesis 3.5.4, definition 28", keys, sizeof(params)},
    .use = "Halls, roofs over curved platforms, greenhouses: one kind of node per line along the "
           "trajectory, one rib for all frames, flat panels, and flat beams without torsion in the "
           "nodes. Made directly, without a solver.",
    .trouble = "With sections that turn by different angles, or to different sides, the net "
               "stays planar and conical, but where sections meet the faces are no isosceles "
               "trapezoids and have no circumcircle. A profile that reaches the center of the "
               "turn folds and is refused.",
    .chart = LAM_CHART_NATURAL,
    .schedule = LAM_UNGUIDED_SCHEDULE,
    .guide = LAM_GUIDED_GUIDE,
    .constrain = constrain,
    .measures = measures,
    .proof = "face_planarity",
    .start = start};
