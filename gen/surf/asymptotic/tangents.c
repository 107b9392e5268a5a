/* Tangents across an asymptotic boundary (thesis 2.3.2, 2.4.2, 2.5.2). Called by patch.c and
 * rational_patch.c.
 *
 * In the osculating plane of curve i, T = x r' + y V, V = (r' x r'') x r', x = W X, y = W^4 Y, X
 * a spline of which only the first two and the last two coefficients are not 0, Y linear, W the
 * weight function of a rational curve and 1 otherwise. The ends of T are the derivatives of the
 * crossing curves. Where curves p and q meet, T_p' = T_q' (the mixed derivative of the surface):
 * two equations for X_p' and X_q' in the tangent plane; the third one, along the normal, is the
 * condition of opposite torsion.
 *
 * For a straight curve T is the cubic with the right ends and derivatives. Where a curve meets a
 * straight one, X' = 0 and the straight one takes T' of the curve; where two straight ones meet,
 * T' is that of the bilinear patch. */
#include "curve/bspline/basis.h"
#include "surf/asymptotic/quad_parts.h"

/* A curve at one parameter. */
typedef struct lam_osculating {
  lam_vec3 jet[4], v, dv; /* r and derivatives; V and V' */
  double w, dw;           /* W and W' */
} lam_osculating;

/* The frame of a curve at t, and its weight function. */
static lam_osculating osculating(const lam_quad_curve *curve, double t) {
  lam_osculating o = {.w = 1};
  lam_quad_curve_eval(curve, t, o.jet);
  lam_vec3 bend = lam_cross(o.jet[1], o.jet[2]);
  o.v = lam_cross(bend, o.jet[1]);
  o.dv = lam_add(lam_cross(lam_cross(o.jet[1], o.jet[3]), o.jet[1]), lam_cross(bend, o.jet[2]));
  if (!curve->weights) return o;

  double values[2 * LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(curve->degree, curve->count, curve->knots, t),
      width = curve->degree + 1;
  lam_basis_eval(curve->degree, curve->knots, span, t, 1, values);
  o.w = o.dw = 0;
  for (int j = 0; j < width; j++) {
    o.w += values[j] * curve->weights[span - curve->degree + j];
    o.dw += values[width + j] * curve->weights[span - curve->degree + j];
  }
  return o;
}

/* The derivative of the crossing curve at end e of curve i, which is T there. */
static lam_vec3 end_value(const lam_quad_boundary *b, int i, int e) {
  lam_quad_end other = lam_quad_other[i][e];
  lam_vec3 jet[4];
  lam_quad_curve_eval(&b->curve[other.curve], other.end, jet);
  return jet[1];
}

/* T' at an end of a curve, less the part W X' r', which is not known yet. */
static lam_vec3 twist_rest(const lam_quad_tangents *t, lam_quad_end end) {
  lam_osculating o = osculating(&t->boundary->curve[end.curve], end.end);
  double x = t->x[end.curve][end.end ? t->x_count - 1 : 0], y = t->y[end.curve][end.end];
  double dy = t->y[end.curve][1] - t->y[end.curve][0], w3 = o.w * o.w * o.w;

  lam_vec3 sum = lam_scale(o.jet[1], o.dw * x);
  sum = lam_along(sum, o.w * x, o.jet[2]);
  sum = lam_along(sum, w3 * (o.w * dy + 4 * o.dw * y), o.v);
  return lam_along(sum, w3 * o.w * y, o.dv);
}

/* Sets the second coefficient of X from an end, by W X' = slope there. */
static void set_slope(lam_quad_tangents *t, lam_quad_end end, double slope) {
  double *x = t->x[end.curve], w = 1;
  const double *weights = t->boundary->curve[end.curve].weights, *knots = t->x_knots[end.curve];
  int last = t->x_count - 1;
  if (weights) w = weights[end.end ? t->boundary->curve[end.curve].count - 1 : 0];

  if (end.end)
    x[last - 1] = x[last] - slope / w * (1 - knots[last]) / t->x_degree;
  else
    x[1] = x[0] + slope / w * knots[t->x_degree + 1] / t->x_degree;
}

/* Makes T' equal of the two curves that meet at a corner. */
static void meet(lam_quad_tangents *t, int corner) {
  lam_quad_end end[2] = {lam_quad_meeting[corner][0], lam_quad_meeting[corner][1]};
  const lam_quad_curve *c[2] = {&t->boundary->curve[end[0].curve],
                                &t->boundary->curve[end[1].curve]};
  lam_vec3 rest[2], jet[2][4], twist;
  for (int k = 0; k < 2; k++) {
    lam_quad_curve_eval(c[k], end[k].end, jet[k]);
    rest[k] = twist_rest(t, end[k]);
  }

  if (c[0]->straight && c[1]->straight) {
    const lam_quad_curve *low = &t->boundary->curve[0], *high = &t->boundary->curve[2];
    twist = lam_sub(lam_sub(high->points[high->count - 1], high->points[0]),
                    lam_sub(low->points[low->count - 1], low->points[0]));
  } else if (c[0]->straight || c[1]->straight) {
    int bent = c[0]->straight;
    set_slope(t, end[bent], 0);
    twist = rest[bent];
  } else {
    lam_vec3 n = lam_cross(jet[0][1], jet[1][1]), difference = lam_sub(rest[1], rest[0]);
    set_slope(t, end[0], lam_dot(lam_cross(difference, jet[1][1]), n) / lam_dot(n, n));
    set_slope(t, end[1], -lam_dot(lam_cross(jet[0][1], difference), n) / lam_dot(n, n));
    return;
  }

  for (int k = 0; k < 2; k++)
    if (c[k]->straight) t->hermite[end[k].curve][2 * end[k].end + 1] = twist;
}

/* The ends of T first, from the crossing curves, then T' corner by corner. */
void lam_quad_tangents_make(lam_arena *arena, const lam_quad_boundary *boundary,
                            lam_quad_tangents *tangents) {
  *tangents =
      (lam_quad_tangents){.boundary = boundary, .x_degree = 2 * boundary->curve[0].degree - 3};
  if (boundary->curve[0].weights) tangents->x_degree += 2;

  for (int i = 0; i < 4; i++) {
    const lam_quad_curve *c = &boundary->curve[i];
    tangents->x_knots[i] = lam_knots_repeat(arena, tangents->x_degree, c->count - c->degree - 1,
                                            c->knots + c->degree + 1, 1, &tangents->x_count);

    for (int e = 0; e < 2; e++) {
      lam_osculating o = osculating(c, e);
      lam_vec3 value = end_value(boundary, i, e);
      if (c->straight) {
        tangents->hermite[i][2 * e] = value;
      } else {
        tangents->x[i][e ? tangents->x_count - 1 : 0] =
            lam_dot(value, o.jet[1]) / lam_dot(o.jet[1], o.jet[1]) / o.w;
        tangents->y[i][e] = lam_dot(value, o.v) / lam_dot(o.v, o.v) / pow(o.w, 4);
      }
    }
  }

  for (int corner = 0; corner < 4; corner++) meet(tangents, corner);
}

/* The cubic Hermite polynomial of a straight curve, or x r' + y V. */
lam_vec3 lam_quad_tangents_eval(const lam_quad_tangents *tangents, int curve, double t) {
  const lam_quad_curve *c = &tangents->boundary->curve[curve];
  if (c->straight) {
    const lam_vec3 *h = tangents->hermite[curve];
    double s = 1 - t;
    lam_vec3 sum = lam_scale(h[0], s * s * (1 + 2 * t));
    sum = lam_along(sum, s * s * t, h[1]);
    sum = lam_along(sum, t * t * (1 + 2 * s), h[2]);
    return lam_along(sum, -t * t * s, h[3]);
  }

  double values[LAM_BASIS_MAX_VALUES], x = 0;
  const double *knots = tangents->x_knots[curve];
  int span = lam_basis_span(tangents->x_degree, tangents->x_count, knots, t);
  lam_basis_eval(tangents->x_degree, knots, span, t, 0, values);
  for (int j = 0; j <= tangents->x_degree; j++)
    x += values[j] * tangents->x[curve][span - tangents->x_degree + j];

  double y = (1 - t) * tangents->y[curve][0] + t * tangents->y[curve][1];
  lam_osculating o = osculating(c, t);
  return lam_along(lam_scale(o.jet[1], o.w * x), pow(o.w, 4) * y, o.v);
}
