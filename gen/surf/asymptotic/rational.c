/* Rational quartic boundaries (thesis 2.4.1). Called by make_quad.c.
 *
 * The middle point of curve i is X_i + s_i D_i, as for quartics, with the coordinate c along the
 * other curve's edge at an end. The weights next to the ends follow from the curvature there,
 *
 *   w_near = g sqrt(w_2),   g^2 = 3/4 w_corner |c| |m| / (k |E|^3)
 *
 * and then the torsion is, with h = m.(far tangent point - corner),
 *
 *   |tau| = exp(A) / w_2,   A = log(1/2 w_corner g_far / g |h| / (|c| |m|^2))
 *
 * Opposite torsions at the corner of curves p and q: A_p - log w_2p = A_q - log w_2q. These are
 * four equations for the logarithms of the w_2, of rank three; the closure condition
 *
 *   (A1(0) - A2(0)) - (A1(1) - A4(0)) - (A3(0) - A2(1)) + (A3(1) - A4(1)) = 0
 *
 * determines |c(1)| / |c(0)| on r4, hence s_4. Left are s_1, s_2, s_3 and w_2 of r1, for least
 * bending energy. */
#include "core/numeric/minimize.h"
#include "surf/asymptotic/quad_parts.h"

/* The boundary and what stays the same while its middle points and weights are sought; [i][e]:
 * curve i, end e. */
typedef struct lam_rational {
  const lam_quad_corners *corners;
  lam_quad_boundary *boundary;
  lam_quad_rule rule;
  lam_vec3 point[4], along[4];              /* X and D */
  double cross[4][2][2];                    /* c = cross[0] + s cross[1] */
  double height[4][2], m[4][2], edge[4][2]; /* h, |m|, |E| */
  double range[4][2];                       /* of s, where both ends bend to the right side */
} lam_rational;

/* c at end e of curve i. */
static double cross_at(const lam_rational *r, int i, int e, double s) {
  return r->cross[i][e][0] + s * r->cross[i][e][1];
}

/* Whether curve i bends to its sides, at both ends, with this s. */
static bool bends_right(const lam_rational *r, int i, double s) {
  const int *side = r->corners->side[i];
  return side[0] * cross_at(r, i, 0, s) > 0 && side[1] * cross_at(r, i, 1, s) > 0;
}

/* g and A at both ends of a curve. */
static void end_logs(const lam_rational *r, int i, double s, double g[2], double a[2]) {
  for (int e = 0; e < 2; e++) {
    double w = r->corners->weight[lam_quad_corner_of[i][e]];
    g[e] = sqrt(0.75 * w * fabs(cross_at(r, i, e, s)) * r->m[i][e] /
                (r->corners->curvature[i][e] * pow(r->edge[i][e], 3)));
  }

  for (int e = 0; e < 2; e++) {
    double w = r->corners->weight[lam_quad_corner_of[i][e]];
    a[e] = log(0.5 * w * g[1 - e] / g[e] * fabs(r->height[i][e]) /
               (fabs(cross_at(r, i, e, s)) * r->m[i][e] * r->m[i][e]));
  }
}

/* s_4 by the closure condition from A of the other three curves: A4(0) - A4(1) is
 * 2 log(c(1) / c(0)) and a constant, which any s tells. */
static double closing_parameter(const lam_rational *r, double a[3][2]) {
  double wanted = -((a[0][0] - a[1][0]) - a[0][1] - (a[2][0] - a[1][1]) + a[2][1]);
  double probe = (r->range[3][0] + r->range[3][1]) / 2, g[2], a4[2];
  end_logs(r, 3, probe, g, a4);
  double ratio =
      cross_at(r, 3, 1, probe) / cross_at(r, 3, 0, probe) * exp((wanted - (a4[0] - a4[1])) / 2);
  return (ratio * r->cross[3][0][0] - r->cross[3][1][0]) /
         (r->cross[3][1][1] - ratio * r->cross[3][0][1]);
}

/* Sets points and weights of the boundary from x: s_1, s_2, s_3, log w_2 of r1. False: a curve
 * bends to the wrong side. */
static bool set_boundary(lam_rational *r, const double x[4]) {
  double s[4] = {x[0], x[1], x[2]}, g[4][2], a[4][2], o[4];
  for (int i = 0; i < 3; i++) {
    if (!bends_right(r, i, s[i])) return false;
    end_logs(r, i, s[i], g[i], a[i]);
  }

  s[3] = closing_parameter(r, a);
  if (!bends_right(r, 3, s[3])) return false;
  end_logs(r, 3, s[3], g[3], a[3]);

  /* log w_2 of the others, from corner to corner. */
  o[0] = x[3];
  o[1] = o[0] - (a[0][0] - a[1][0]);
  o[3] = o[0] - (a[0][1] - a[3][0]);
  o[2] = o[1] + (a[2][0] - a[1][1]);

  for (int i = 0; i < 4; i++) {
    lam_quad_curve *c = &r->boundary->curve[i];
    c->points[2] = lam_along(r->point[i], s[i], r->along[i]);
    c->weights[2] = exp(o[i]);
    for (int e = 0; e < 2; e++) {
      c->weights[e ? 4 : 0] = r->corners->weight[lam_quad_corner_of[i][e]];
      c->weights[e ? 3 : 1] = g[i][e] * sqrt(c->weights[2]);
    }
  }
  return true;
}

/* The bending energy at x, INFINITY where a curve bends to the wrong side. */
static double energy_at(void *data, const double *x) {
  lam_rational *r = data;
  double sum = 0;
  if (!set_boundary(r, x)) return INFINITY;
  for (int i = 0; i < 4; i++) sum += lam_quad_curve_bending(&r->boundary->curve[i], &r->rule);
  return sum;
}

/* The line of the middle point of curve i, c, h, m and E at its ends, and the range of s. False,
 * with an error: the end planes are parallel. */
static bool prepare_curve(lam_rational *r, int i, lam_location location, lam_errors *errors) {
  lam_quad_boundary *b = r->boundary;
  if (!lam_quad_middle_line(b, i, &r->point[i], &r->along[i])) {
    lam_error_add(errors, location, "tangents",
                  "the tangent planes at the ends of r%d are parallel, so that a rational "
                  "quartic has no middle point; expected two planes that intersect, or form bi-7",
                  i + 1);
    return false;
  }

  r->range[i][0] = -4;
  r->range[i][1] = 4;
  for (int e = 0; e < 2; e++) {
    lam_quad_end o = lam_quad_other[i][e];
    lam_vec3 edge = lam_quad_edge(&b->curve[i], e);
    lam_quad_middle_cross(b, i, e, r->point[i], r->along[i], r->cross[i][e]);
    r->height[i][e] = lam_quad_far_height(b, i, e);
    r->edge[i][e] = lam_length(edge);
    r->m[i][e] = lam_length(lam_cross(edge, lam_quad_edge(&b->curve[o.curve], o.end)));

    /* c changes its sign where it is 0: the range ends or begins there. */
    double zero = -r->cross[i][e][0] / r->cross[i][e][1];
    bool above = r->corners->side[i][e] * r->cross[i][e][1] > 0;
    r->range[i][!above] = above ? fmax(r->range[i][0], zero) : fmin(r->range[i][1], zero);
  }
  return true;
}

/* Adds an error at the first corner whose torsions have one sign, whatever the weights are. */
static void check_torsions(const lam_rational *r, lam_location location, lam_errors *errors) {
  for (int corner = 0; corner < 4; corner++) {
    lam_quad_end p = lam_quad_meeting[corner][0], q = lam_quad_meeting[corner][1];
    double product = r->height[p.curve][p.end] * r->height[q.curve][q.end];
    if (!(r->corners->side[p.curve][p.end] * r->corners->side[q.curve][q.end] * product > 0)) {
      lam_error_add(errors, location, "sides",
                    "r%d and r%d have torsion of one sign at corner %d with these sides and "
                    "tangents, for any positive weights; expected opposite torsions, by other "
                    "sides or by form bi-7",
                    p.curve + 1, q.curve + 1, corner + 1);
      return;
    }
  }
}

/* Everything that stays the same; false, with an error, when there is no right side or no right
 * torsion. */
static bool prepare(lam_rational *r, lam_location location, lam_errors *errors) {
  int before = errors->count;
  for (int i = 0; i < 4; i++)
    if (!prepare_curve(r, i, location, errors)) return false;

  check_torsions(r, location, errors);
  for (int i = 0; i < 4 && errors->count == before; i++)
    if (!(r->range[i][0] < r->range[i][1]))
      lam_error_add(errors, location, "sides",
                    "a rational quartic r%d cannot bend to side %+d at both ends with these "
                    "tangents; expected another side or form bi-7",
                    i + 1, r->corners->side[i][0]);
  return errors->count == before;
}

/* Tries a grid of starts; sets best to the one of least energy, which is returned. */
static double find_start(lam_rational *r, double best[4]) {
  enum { STARTS = 4 };
  const double *weight = r->corners->weight;
  double least = INFINITY;
  for (int start = 0; start < STARTS * STARTS * STARTS; start++) {
    double x[4];
    int at[3] = {start % STARTS, start / STARTS % STARTS, start / STARTS / STARTS};
    for (int i = 0; i < 3; i++)
      x[i] = r->range[i][0] + (at[i] + 0.5) / STARTS * (r->range[i][1] - r->range[i][0]);

    for (int k = -1; k <= 1; k++) {
      x[3] = 0.5 * k + log(weight[0] * weight[1]) / 2;
      double energy = energy_at(r, x);
      if (energy < least) {
        least = energy;
        for (int i = 0; i < 4; i++) best[i] = x[i];
      }
    }
  }
  return least;
}

/* Least bending energy over the four variables that are left. */
bool lam_quad_boundary_rational(lam_arena *arena, const lam_quad_corners *corners,
                                lam_location location, lam_errors *errors,
                                lam_quad_boundary *boundary) {
  lam_rational r = {.corners = corners, .boundary = boundary};
  if (!prepare(&r, location, errors)) return false;
  for (int i = 0; i < 4; i++) boundary->curve[i].weights = LAM_NEW(arena, double, 5);
  r.rule = lam_quad_rule_make(&boundary->curve[0]);

  double best[4] = {0};
  if (!isfinite(find_start(&r, best))) {
    lam_error_add(errors, location, "tangents",
                  "no rational quartic boundary was found that bends to the given sides with "
                  "opposite torsions at the corners; expected other tangents, or form bi-7");
    return false;
  }

  lam_minimize(4, energy_at, &r, 60, best);
  set_boundary(&r, best);
  return true;
}
