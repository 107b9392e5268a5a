/* The boundary of least energy with given end tangents and curvatures (thesis 2.3.1 and 2.5.1).
 * Called by make_quad.c.
 *
 * At a corner the curves p (along u) and q (along v) have the edges E_p, E_q away from it, m =
 * E_p x E_q. The third point of a curve, seen from the end, is corner + a E + c X, with X the
 * edge of the other curve. With the first three knot distances u1, u2, u3 from the end (all 1
 * for Bezier curves) and degree n,
 *
 *   k = (n-1)/n (u1/u2) |c| |m| / |E|^3   gives c, whose sign is the side
 *   tau_p =  (n-2)/n (u1/u3) m.F_p / (c_p |m|^2)
 *   tau_q = -(n-2)/n (u1/u3) m.F_q / (c_q |m|^2),   F the fourth point less the corner
 *
 * Two asymptotic curves cross with opposite torsion (Beltrami-Enneper), which is
 *
 *   kappa_p m.F_p / c_p = kappa_q m.F_q / c_q,   kappa = (n-2)/n u1/u3
 *
 * linear in the slides a and in the free points. Corners that touch a straight side have no such
 * condition: a straight line has no osculating plane. The quadratic energy sum of integrals
 * |r''|^2 is minimized under these conditions. */
#include "core/numeric/dense.h"
#include "surf/asymptotic/quad_parts.h"
#include "surf/spline/thin_plate.h"

/* Two slides per curve, and the coordinates of the points that are neither of the first nor of
 * the last three. */
enum { MAX_UNKNOWNS = 4 * (2 + 3 * (LAM_QUAD_MAX_POINTS - 6)) };

/* What is solved for: unknown k moves one point of one curve along a direction. */
typedef struct lam_unknown {
  int curve, point;
  lam_vec3 along;
} lam_unknown;

typedef struct lam_system {
  int count;
  lam_unknown unknown[MAX_UNKNOWNS];
} lam_system;

/* u1, u2 or u3 (number 1, 2, 3) of a curve from one of its ends. */
static double knot_distance(const lam_quad_curve *c, int end, int number) {
  return end ? 1 - c->knots[c->count - number] : c->knots[c->degree + number];
}

/* Puts the third points where c wants them with slide 0 and the free points at the origin, and
 * lists the unknowns. */
static void list_unknowns(const lam_quad_corners *corners, lam_quad_boundary *b,
                          lam_system *system) {
  system->count = 0;
  for (int i = 0; i < 4; i++) {
    lam_quad_curve *c = &b->curve[i];
    for (int e = 0; e < 2; e++) {
      lam_quad_end o = lam_quad_other[i][e];
      lam_vec3 edge = lam_quad_edge(c, e), cross = lam_quad_edge(&b->curve[o.curve], o.end);
      double length = lam_length(edge), m = lam_length(lam_cross(edge, cross)), n = c->degree;

      /* c from the curvature, by the equation at the top. */
      b->cross[i][e] = corners->side[i][e] * n / (n - 1) * knot_distance(c, e, 2) /
                       knot_distance(c, e, 1) * corners->curvature[i][e] * length * length *
                       length / m;
      if (c->straight) b->cross[i][e] = 0;

      int point = e ? c->count - 3 : 2;
      c->points[point] = lam_along(c->points[e ? c->count - 1 : 0], b->cross[i][e], cross);
      system->unknown[system->count++] = (lam_unknown){i, point, edge};
    }

    for (int j = 3; j < c->count - 3; j++) {
      c->points[j] = lam_v3(0, 0, 0);
      for (int k = 0; k < 3; k++)
        system->unknown[system->count++] = (lam_unknown){i, j, lam_v3(k == 0, k == 1, k == 2)};
    }
  }
}

/* Adds factor times m.F of the curve at an end, one side of the torsion condition of a corner,
 * to the equation row.x = right. */
static void add_torsion(const lam_quad_boundary *b, const lam_system *system, lam_quad_end end,
                        double factor, lam_vec3 m, double *row, double *right) {
  const lam_quad_curve *c = &b->curve[end.curve];
  int fourth = end.end ? c->count - 4 : 3;
  lam_vec3 corner = c->points[end.end ? c->count - 1 : 0];
  *right -= factor * lam_dot(m, lam_sub(c->points[fourth], corner));

  for (int k = 0; k < system->count; k++)
    if (system->unknown[k].curve == end.curve && system->unknown[k].point == fourth)
      row[k] += factor * lam_dot(m, system->unknown[k].along);
}

/* The torsion conditions of the corners, scaled to about 1: rows (4 x unknowns at most) and
 * right sides. Returns their number. */
static int list_conditions(const lam_quad_boundary *b, const lam_system *system, double *rows,
                           double *right) {
  int count = 0;
  for (int corner = 0; corner < 4; corner++) {
    lam_quad_end end[2] = {lam_quad_meeting[corner][0], lam_quad_meeting[corner][1]};
    const lam_quad_curve *c[2] = {&b->curve[end[0].curve], &b->curve[end[1].curve]};
    if (c[0]->straight || c[1]->straight) continue;

    lam_vec3 edge[2] = {lam_quad_edge(c[0], end[0].end), lam_quad_edge(c[1], end[1].end)},
             m = lam_cross(edge[0], edge[1]);
    double factor[2], scale = 0;
    for (int k = 0; k < 2; k++) {
      factor[k] = knot_distance(c[k], end[k].end, 1) / knot_distance(c[k], end[k].end, 3) /
                  b->cross[end[k].curve][end[k].end];
      scale += fabs(factor[k]) * lam_length(m) * lam_length(edge[k]);
    }

    double *row = rows + count * system->count;
    add_torsion(b, system, end[0], factor[0] / scale, m, row, right + count);
    add_torsion(b, system, end[1], -factor[1] / scale, m, row, right + count);
    count++;
  }
  return count;
}

/* The energy as 1/2 x^T h x + g^T x + constant in the unknowns. */
static void list_energy(lam_arena *arena, const lam_quad_boundary *b, const lam_system *system,
                        double *h, double *g) {
  for (int i = 0; i < 4; i++) {
    const lam_quad_curve *c = &b->curve[i];
    const double *gram = lam_spline_gram(arena, c->degree, c->count, c->knots, 2);
    for (int k = 0; k < system->count; k++) {
      const lam_unknown *u = &system->unknown[k];
      if (u->curve != i) continue;
      for (int j = 0; j < c->count; j++)
        g[k] += gram[u->point * c->count + j] * lam_dot(u->along, c->points[j]);

      for (int l = 0; l < system->count; l++) {
        const lam_unknown *w = &system->unknown[l];
        if (w->curve == i)
          h[k * system->count + l] =
              gram[u->point * c->count + w->point] * lam_dot(u->along, w->along);
      }
    }
  }
}

/* Sets up and solves the quadratic problem, and moves the points by the unknowns. */
bool lam_quad_boundary_least(lam_arena *arena, const lam_quad_corners *corners,
                             lam_location location, lam_errors *errors,
                             lam_quad_boundary *boundary) {
  lam_system *system = LAM_NEW(arena, lam_system, 1);
  list_unknowns(corners, boundary, system);

  int n = system->count;
  double *h = LAM_NEW(arena, double, n *n), *g = LAM_NEW(arena, double, n),
         *x = LAM_NEW(arena, double, n);
  double *rows = LAM_NEW(arena, double, 4 * n), right[4] = {0};

  list_energy(arena, boundary, system, h, g);
  int conditions = list_conditions(boundary, system, rows, right);
  if (lam_least_energy(arena, n, h, g, conditions, rows, right, 1e-9, x) != LAM_LEAST_FOUND) {
    lam_error_add(
        errors, location, "tangents",
        "no boundary has opposite torsion of the two curves at every corner: the last edges of the "
        "curves that leave a corner are parallel to its tangent plane; expected tangents out of "
        "that plane");
    return false;
  }

  for (int k = 0; k < n; k++) {
    lam_vec3 *point = &boundary->curve[system->unknown[k].curve].points[system->unknown[k].point];
    *point = lam_along(*point, x[k], system->unknown[k].along);
  }
  return true;
}
