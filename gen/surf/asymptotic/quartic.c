/* Quartic boundaries (end of thesis 2.3.3). Called by make_quad.c; rational.c uses the lines of
 * the middle points.
 *
 * The middle point of a curve lies in the tangent planes of both its ends, on a line X + s D.
 * With c the coordinate of the middle point along the other curve's edge (boundary.c), an affine
 * function of s, and h = m.(third point from the corner, counted the other way: the far tangent
 * point - corner), opposite torsion at the corner of curves p and q is
 *
 *   h_p c_q(s_q) = h_q c_p(s_p)
 *
 * four linear equations for the four s. The curvatures follow. In general the solution is
 * unique. Symmetric data and data of some surfaces leave one parameter free, which is chosen for
 * least energy. Near such data the unique solution is meaningless: it depends on the last digits
 * of the input. */
#include "core/numeric/dense.h"
#include "surf/asymptotic/quad_parts.h"
#include "surf/spline/thin_plate.h"
#include <string.h>

/* The line in which the two end planes intersect, by its point nearest to the middle of the two
 * tangent points. */
bool lam_quad_middle_line(const lam_quad_boundary *b, int i, lam_vec3 *point, lam_vec3 *along) {
  const lam_quad_curve *c = &b->curve[i];
  lam_vec3 normal[2], end[2] = {c->points[0], c->points[4]};
  for (int e = 0; e < 2; e++) {
    lam_quad_end o = lam_quad_other[i][e];
    normal[e] = lam_unit(lam_cross(lam_quad_edge(c, e), lam_quad_edge(&b->curve[o.curve], o.end)));
  }
  lam_vec3 d = lam_cross(normal[0], normal[1]);
  double sine = lam_length(d), size = lam_distance(end[0], end[1]);
  if (!(sine > 1e-6)) return false;

  lam_vec3 middle = lam_mix(c->points[1], c->points[3], 0.5);
  double p = lam_dot(normal[0], lam_sub(end[0], middle)),
         q = lam_dot(normal[1], lam_sub(end[1], middle));
  lam_vec3 step =
      lam_add(lam_scale(lam_cross(normal[1], d), p), lam_scale(lam_cross(d, normal[0]), q));

  *point = lam_along(middle, 1 / (sine * sine), step);
  *along = lam_scale(d, size / sine);
  return true;
}

/* The coordinates of point and direction in the edges at the corner, by their cross products
 * with the edge. */
void lam_quad_middle_cross(const lam_quad_boundary *b, int i, int e, lam_vec3 point, lam_vec3 along,
                           double cross[2]) {
  const lam_quad_curve *c = &b->curve[i];
  lam_quad_end o = lam_quad_other[i][e];
  lam_vec3 edge = lam_quad_edge(c, e),
           m = lam_cross(edge, lam_quad_edge(&b->curve[o.curve], o.end));

  double square = lam_dot(m, m);
  cross[0] = lam_dot(lam_cross(edge, lam_sub(point, c->points[e ? 4 : 0])), m) / square;
  cross[1] = lam_dot(lam_cross(edge, along), m) / square;
}

/* m has the sign of E_p x E_q whichever of the two the curve is. */
double lam_quad_far_height(const lam_quad_boundary *b, int i, int e) {
  const lam_quad_curve *c = &b->curve[i];
  lam_quad_end o = lam_quad_other[i][e];
  lam_vec3 m = lam_cross(lam_quad_edge(c, e), lam_quad_edge(&b->curve[o.curve], o.end));
  return lam_dot(i % 2 ? lam_scale(m, -1) : m, lam_sub(c->points[e ? 1 : 3], c->points[e ? 4 : 0]));
}

/* Adds to s the multiple of the null direction for which the energy, quadratic in it, is least.
 * X + s D of curve i: point[i] + s[i] along[i]. */
static void choose_parameter(lam_arena *arena, const lam_quad_boundary *b, const lam_vec3 *along,
                             const double *null, double *s, const lam_vec3 *point) {
  double slope = 0, bend = 0;
  for (int i = 0; i < 4; i++) {
    const lam_quad_curve *c = &b->curve[i];
    const double *gram = lam_spline_gram(arena, 4, 5, c->knots, 2) + 2 * 5;
    lam_vec3 middle = lam_along(point[i], s[i], along[i]), move = lam_scale(along[i], null[i]);
    for (int j = 0; j < 5; j++) slope += gram[j] * lam_dot(move, j == 2 ? middle : c->points[j]);
    bend += gram[2] * lam_dot(move, move);
  }

  for (int i = 0; i < 4; i++) s[i] -= slope / bend * null[i];
}

/* The least-squares solution of a s = right by its singular values, without the directions
 * beyond the rank. a holds the columns a v_k of length sigma_k. */
static void solve(const double *a, const double *sigma, const double *v, const double *right,
                  int rank, double *s) {
  for (int k = 0; k < rank; k++) {
    double sum = 0;
    for (int i = 0; i < 4; i++) sum += a[4 * i + k] * right[i];
    for (int i = 0; i < 4; i++) s[i] += sum / (sigma[k] * sigma[k]) * v[4 * i + k];
  }
}

/* Whether the curves bend where their sides say, c having the sign of the side; otherwise false
 * with an error. ratio: of the least singular value to the largest. */
static bool check_sides(const lam_quad_corners *corners, double cross[4][2][2], const double *s,
                        double ratio, lam_location location, lam_errors *errors) {
  const char *doubt =
      ratio < 1e-2 ? " (the data nearly leave a parameter free: such a solution means nothing)"
                   : "";
  for (int i = 0; i < 4; i++)
    for (int e = 0; e < 2; e++) {
      double c = cross[i][e][0] + s[i] * cross[i][e][1];
      if (corners->side[i][e] * c > 0) continue;

      lam_error_add(
          errors, location, "sides",
          "the quartic boundary with opposite torsions at the corners bends r%d to the other "
          "side%s; expected other sides or tangents, or form bi-7",
          i + 1, doubt);
      return false;
    }
  return true;
}

/* The lines of the middle points of all curves, and c as a function of s: cross[0] + s cross[1].
 * False, with an error, where the end planes of a curve are parallel. */
static bool find_lines(const lam_quad_boundary *boundary, lam_vec3 point[4], lam_vec3 along[4],
                       double cross[4][2][2], lam_location location, lam_errors *errors) {
  for (int i = 0; i < 4; i++) {
    if (!lam_quad_middle_line(boundary, i, &point[i], &along[i])) {
      lam_error_add(errors, location, "tangents",
                    "the tangent planes at the ends of r%d are parallel; expected two planes that "
                    "intersect, or form bi-7",
                    i + 1);
      return false;
    }

    for (int e = 0; e < 2; e++)
      lam_quad_middle_cross(boundary, i, e, point[i], along[i], cross[i][e]);
  }
  return true;
}

/* The equations a s = right of opposite torsion, one per corner, with rows of length 1. */
static void list_equations(const lam_quad_boundary *boundary, double cross[4][2][2], double a[16],
                           double right[4]) {
  for (int corner = 0; corner < 4; corner++) {
    lam_quad_end p = lam_quad_meeting[corner][0], q = lam_quad_meeting[corner][1];
    double hp = lam_quad_far_height(boundary, p.curve, p.end),
           hq = lam_quad_far_height(boundary, q.curve, q.end);
    const double *cp = cross[p.curve][p.end], *cq = cross[q.curve][q.end];

    double scale = 1 / hypot(hp * cq[1], hq * cp[1]);
    a[4 * corner + q.curve] = hp * cq[1] * scale;
    a[4 * corner + p.curve] = -hq * cp[1] * scale;
    right[corner] = (hq * cp[0] - hp * cq[0]) * scale;
  }
}

/* Whether s solves the equations, which a rank of three does not grant; otherwise false with an
 * error. */
static bool check_equations(const double rows[16], const double right[4], const double s[4],
                            lam_location location, lam_errors *errors) {
  for (int k = 0; k < 4; k++) {
    double sum = right[k];
    for (int i = 0; i < 4; i++) sum -= rows[4 * k + i] * s[i];

    if (fabs(sum) > 1e-6) {
      lam_error_add(errors, location, "tangents",
                    "no quartic boundary has opposite torsions of the two curves at every corner; "
                    "expected other tangents, or form bi-7");
      return false;
    }
  }
  return true;
}

/* Solves the four equations; with a rank of three the parameter that is left is chosen for least
 * energy. */
bool lam_quad_boundary_quartic(lam_arena *arena, const lam_quad_corners *corners,
                               lam_location location, lam_errors *errors,
                               lam_quad_boundary *boundary) {
  lam_vec3 point[4], along[4];
  double cross[4][2][2], a[16] = {0}, rows[16], right[4], sigma[4], v[16], s[4] = {0};
  if (!find_lines(boundary, point, along, cross, location, errors)) return false;
  list_equations(boundary, cross, a, right);

  memcpy(rows, a, sizeof rows);
  lam_singular_values(4, a, sigma, v);
  double ratio = sigma[3] / sigma[0];
  int rank = ratio < 1e-9 ? 3 : 4;
  solve(a, sigma, v, right, rank, s);
  if (rank == 3) {
    if (!check_equations(rows, right, s, location, errors)) return false;
    const double null[4] = {v[3], v[7], v[11], v[15]};
    choose_parameter(arena, boundary, along, null, s, point);
  }

  for (int i = 0; i < 4; i++) boundary->curve[i].points[2] = lam_along(point[i], s[i], along[i]);
  return check_sides(corners, cross, s, ratio, location, errors);
}
