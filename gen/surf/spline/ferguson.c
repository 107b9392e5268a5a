/* Bicubic patches from Ferguson's form to Bezier's and back. Part of the surface kernel; called
 * by the unit tests. Cubics in u give points and derivatives by v of the rows; cubics in v turn
 * these into Bezier points. */
#include "surf/spline/ferguson.h"
#include "curve/hermite.h"

/* Rows j = 0, 1 first: x(u, j) and x_v(u, j) as Bezier points in u. Then column i by column
 * i. */
void lam_ferguson_to_bezier(const lam_ferguson *p, lam_vec3 b[16]) {
  lam_vec3 points[2][4], slopes[2][4];
  for (int j = 0; j < 2; j++) {
    lam_hermite_to_bezier(&(lam_hermite){{p->x[0][j], p->x[1][j]}, {p->u[0][j], p->u[1][j]}},
                          points[j]);
    lam_hermite_to_bezier(&(lam_hermite){{p->v[0][j], p->v[1][j]}, {p->uv[0][j], p->uv[1][j]}},
                          slopes[j]);
  }

  for (int i = 0; i < 4; i++)
    lam_hermite_to_bezier(
        &(lam_hermite){{points[0][i], points[1][i]}, {slopes[0][i], slopes[1][i]}}, b + 4 * i);
}

/* The way back: Hermite forms of the four Bezier rows in v, whose ends and end derivatives are
 * Bezier points in u. */
lam_ferguson lam_ferguson_from_bezier(const lam_vec3 b[16]) {
  lam_ferguson patch;
  lam_hermite rows[4];
  for (int i = 0; i < 4; i++) rows[i] = lam_hermite_from_bezier(b + 4 * i);

  for (int j = 0; j < 2; j++) {
    lam_hermite x = lam_hermite_from_bezier(
        (lam_vec3[]){rows[0].p[j], rows[1].p[j], rows[2].p[j], rows[3].p[j]});
    lam_hermite v = lam_hermite_from_bezier(
        (lam_vec3[]){rows[0].d[j], rows[1].d[j], rows[2].d[j], rows[3].d[j]});
    for (int i = 0; i < 2; i++) {
      patch.x[i][j] = x.p[i];
      patch.u[i][j] = x.d[i];
      patch.v[i][j] = v.p[i];
      patch.uv[i][j] = v.d[i];
    }
  }
  return patch;
}
