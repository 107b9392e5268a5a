/* The smooth curve through the places of a sheet: tangents and curvatures, arc length, developed
 * heading. Called by lamella_grid.c. */
#include "fab/lamella/lamella_curve.h"
#include "core/numbers.h"
#include "core/numeric/quadrature.h"

#include <string.h>

/* Rounds of parameters and lengths; places of the quadrature; places on either side of one that
 * its tangent is taken from, and the turn between two edges above which only one is. */
enum { rounds = 6, gauss = 8, reach = 2 };
static const double kink = 40 * LAM_DEGREE;

/* ---- tangents and curvatures ---- */

/* The product of at - t[j] over all j but i, a and b. */
static double product_without(int n, const double *t, double at, int i, int a, int b) {
  double product = 1;
  for (int j = 0; j < n; j++)
    if (j != i && j != a && j != b) product *= at - t[j];
  return product;
}

/* The weights by which values at the parameters t[0 .. n - 1] give the first and the second
 * derivative at `at` of the polynomial through them. They are the derivatives of
 *   l_i(t) = prod_(j != i) (t - t_j) / (t_i - t_j):
 * sums of the products with one, and with two, of the factors left out. */
static void derivative_weights(int n, const double *t, double at, double *first, double *second) {
  for (int i = 0; i < n; i++) {
    double below = 1;
    first[i] = second[i] = 0;
    for (int a = 0; a < n; a++) {
      if (a == i) continue;
      below *= t[i] - t[a];
      first[i] += product_without(n, t, at, i, a, a);
      for (int b = 0; b < n; b++)
        if (b != i && b != a) second[i] += product_without(n, t, at, i, a, b);
    }
    first[i] /= below;
    second[i] /= below;
  }
}

/* 2 side + 1 places about place i, from low to high. Near an end the window is moved; it is cut
 * only where there are no more places. */
static void window(const lam_strip_curve *c, int i, int side, int *low, int *high) {
  *low = i - side < 0 ? 0 : i - side;
  *high = *low + 2 * side;
  if (*high < c->count) return;
  *high = c->count - 1;
  *low = *high - 2 * side < 0 ? 0 : *high - 2 * side;
}

/* Whether the line of places turns sharply within the window. */
static bool has_kink(const lam_strip_curve *c, int low, int high) {
  for (int k = low + 1; k < high; k++)
    if (lam_angle(lam_sub(c->x[k], c->x[k - 1]), lam_sub(c->x[k + 1], c->x[k])) > kink) return true;
  return false;
}

/* Tangent, curvature vector and turn of m at every place for the arc lengths as they are now. A
 * curve by arc length has unit derivatives, with its second ones square to them: what is left of
 * that is the error of the polynomials, and is taken away. */
static void differentiate(lam_strip_curve *c) {
  for (int i = 0; i < c->count; i++) {
    int low, high;
    double first[2 * reach + 1], second[2 * reach + 1];
    window(c, i, reach, &low, &high);
    if (has_kink(c, low, high)) window(c, i, 1, &low, &high);
    derivative_weights(high - low + 1, c->s + low, c->s[i], first, second);

    lam_vec3 d = {0, 0, 0}, dd = {0, 0, 0};
    c->turn[i] = d;
    for (int k = low; k <= high; k++) {
      lam_vec3 from = lam_sub(c->x[k], c->x[i]);
      d = lam_along(d, first[k - low], from);
      dd = lam_along(dd, second[k - low], from);
      c->turn[i] = lam_along(c->turn[i], first[k - low], c->m[k]);
    }
    c->tangent[i] = lam_unit(d);
    c->bend[i] = lam_along(dd, -lam_dot(dd, c->tangent[i]), c->tangent[i]);
  }
}

/* ---- pieces ---- */

/* Position and derivative by arc length (as far as the piece keeps to it) at the part t in [0, 1]
 * of the piece after place i: the polynomial of degree five with the ends' positions, tangents and
 * curvature vectors. */
static void piece_at(const lam_strip_curve *c, int i, double t, lam_vec3 *x, lam_vec3 *dx) {
  double L = c->s[i + 1] - c->s[i], u = 1 - t;
  double t2 = t * t, t3 = t2 * t, u2 = u * u, u3 = u2 * u;
  const double value[6] = {u3 * (1 + 3 * t + 6 * t2), t * u3 * (1 + 3 * t),  t2 * u3 / 2,
                           t3 * (1 + 3 * u + 6 * u2), -u * t3 * (1 + 3 * u), u2 * t3 / 2};
  const double slope[6] = {-30 * t2 * u2, u2 * (1 + 2 * t - 15 * t2), t * u2 * (2 - 5 * t) / 2,
                           30 * t2 * u2,  t2 * (1 + 2 * u - 15 * u2), -u * t2 * (2 - 5 * u) / 2};
  const lam_vec3 ends[6] = {
      c->x[i],     lam_scale(c->tangent[i], L),     lam_scale(c->bend[i], L * L),
      c->x[i + 1], lam_scale(c->tangent[i + 1], L), lam_scale(c->bend[i + 1], L * L)};

  *x = *dx = lam_v3(0, 0, 0);
  for (int k = 0; k < 6; k++) {
    /* relative to the first end, for places may be far from the origin */
    *x = lam_along(*x, value[k], k % 3 ? ends[k] : lam_sub(ends[k], c->x[i]));
    *dx = lam_along(*dx, slope[k] / L, k % 3 ? ends[k] : lam_sub(ends[k], c->x[i]));
  }
  *x = lam_add(*x, c->x[i]);
}

/* The length of the piece after place i, by Gauss' rule. */
static double piece_length(const lam_strip_curve *c, int i, const double *node,
                           const double *weight) {
  double sum = 0;
  for (int k = 0; k < gauss; k++) {
    lam_vec3 x, dx;
    piece_at(c, i, node[k], &x, &dx);
    sum += weight[k] * lam_length(dx);
  }
  return sum * (c->s[i + 1] - c->s[i]);
}

/* Begins with the lengths of the chords. Every round takes the parameters nearer to the arc
 * length, by two orders of the spacing, and the lengths with them. */
static void measure(lam_arena *arena, lam_strip_curve *c) {
  double node[gauss], weight[gauss], *length = LAM_NEW(arena, double, c->count);
  lam_gauss_rule(gauss, node, weight);
  c->s[0] = 0;
  for (int i = 1; i < c->count; i++) c->s[i] = c->s[i - 1] + lam_distance(c->x[i - 1], c->x[i]);

  for (int round = 0; round < rounds; round++) {
    differentiate(c);
    for (int i = 0; i + 1 < c->count; i++) length[i] = piece_length(c, i, node, weight);
    for (int i = 1; i < c->count; i++) c->s[i] = c->s[i - 1] + length[i - 1];
  }
  differentiate(c);
}

/* ---- the developed curve ---- */

/* The curvature of the sphere that touches the net at place i and passes through place k. */
static double sphere(const lam_strip_curve *c, int i, int k) {
  lam_vec3 e = lam_sub(c->x[k], c->x[i]);
  return 2 * lam_dot(c->m[i], e) / lam_dot(e, e);
}

/* The sphere through a neighbor at distance h ahead has k + h c, one behind k - h c, to first
 * order: c, from the third derivative, tells of change and of twist. Inside, the mean of both is
 * weighted so that c cancels; at an end c is that of the place next to it. Headings are the
 * integral. */
static void develop(lam_strip_curve *c) {
  int n = c->count;
  for (int i = 1; i + 1 < n; i++) {
    double back = c->s[i] - c->s[i - 1], on = c->s[i + 1] - c->s[i];
    c->flat[i] = (on * sphere(c, i, i - 1) + back * sphere(c, i, i + 1)) / (back + on);
  }

  for (int end = 0; end < 2 && n > 1; end++) {
    int i = end ? n - 1 : 0, step = end ? -1 : 1, next = i + step;
    c->flat[i] = sphere(c, i, next);
    if (n < 3) continue;
    double change = sphere(c, next, next + step) - sphere(c, next, i);
    double near = fabs(c->s[next] - c->s[i]), all = fabs(c->s[next + step] - c->s[i]);
    c->flat[i] -= near * change / all;
  }

  for (int i = 1; i < n; i++)
    c->heading[i] = c->heading[i - 1] + (c->flat[i - 1] + c->flat[i]) / 2 * (c->s[i] - c->s[i - 1]);
}

/* Lengths first: all else goes by them. */
lam_strip_curve lam_strip_curve_make(lam_arena *arena, int count, const lam_vec3 *x,
                                     const lam_vec3 *m) {
  lam_strip_curve c = {count,
                       LAM_NEW(arena, lam_vec3, count),
                       LAM_NEW(arena, lam_vec3, count),
                       LAM_NEW(arena, double, count),
                       LAM_NEW(arena, lam_vec3, count),
                       LAM_NEW(arena, lam_vec3, count),
                       LAM_NEW(arena, lam_vec3, count),
                       LAM_NEW(arena, double, count),
                       LAM_NEW(arena, double, count)};
  memcpy(c.x, x, (size_t)count * sizeof *x);
  memcpy(c.m, m, (size_t)count * sizeof *m);

  measure(arena, &c);
  develop(&c);
  return c;
}

/* ---- between places ---- */

/* The piece that holds s: the last one that begins before it. */
static int piece_of(const lam_strip_curve *c, double s) {
  int low = 0, high = c->count - 1;
  while (high - low > 1) {
    int half = (low + high) / 2;
    if (c->s[half] <= s)
      low = half;
    else
      high = half;
  }
  return low;
}

/* m between the ends of a piece: the cubic with their derivatives. */
static lam_vec3 height_at(const lam_strip_curve *c, int i, double t) {
  double L = c->s[i + 1] - c->s[i], u = 1 - t;
  lam_vec3 m = lam_scale(c->m[i], u * u * (1 + 2 * t));
  m = lam_along(m, t * t * (1 + 2 * u), c->m[i + 1]);
  m = lam_along(m, t * u * u * L, c->turn[i]);
  m = lam_along(m, -u * t * t * L, c->turn[i + 1]);
  return lam_unit(m);
}

/* The piece's own parameter is its arc length to fifth order, which places a station, but does not
 * measure anything. */
lam_station lam_strip_curve_station(const lam_strip_curve *c, double s) {
  lam_station q = {.s = s, .partner = -1, .crossing = -1, .vertex = -1};
  int i = piece_of(c, s);
  double L = c->s[i + 1] - c->s[i], along = s - c->s[i], t = along / L;
  lam_vec3 tangent;
  piece_at(c, i, t, &q.x, &tangent);

  q.m = height_at(c, i, t);
  q.t = lam_unit(lam_along(tangent, -lam_dot(tangent, q.m), q.m));
  double slope = (c->flat[i + 1] - c->flat[i]) / L;
  q.heading = c->heading[i] + along * (c->flat[i] + along * slope / 2);
  return q;
}

/* An edge at distance h on the outside of an arc of curvature k has the radius 1/k + h, and chords
 * over the angle k d the sag (1/k + h) (k d)^2 / 8. */
int lam_strip_curve_steps(const lam_strip_curve *c, double a, double b, double height, double sag) {
  int i = piece_of(c, (a + b) / 2);
  double k = 0;
  for (int end = i; end <= i + 1; end++)
    k = fmax(k, fmax(lam_length(c->bend[end]), fabs(c->flat[end])));

  double step = sqrt(8 * sag / fmax(k * (1 + k * height / 2), 1e-300));
  double steps = ceil((b - a) / step);
  return steps < 1 ? 1 : steps > 1000 ? 1000 : (int)steps;
}
