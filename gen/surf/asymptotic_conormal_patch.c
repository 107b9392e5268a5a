/* A patch over four asymptotic curves with their conormals nu: the tangents across an edge are T = sum z_k nu x e_k
 * with z of degree 4 and e_k the axes, so that both patches along it share their tangent planes. z = q nu gives
 * nothing: q, of degree 1, is kept at 0. The other coefficients and the inner points of the control net are those of
 * the least thin-plate energy (thesis, eq. 2.8), subject to T at the ends of every curve and equal T' where curves
 * meet. */
#include "core/dense.h"
#include "curve/collocation.h"
#include "surf/asymptotic_conormal.h"

enum {
  CROSS = LAM_CONORMAL_SURFACE - LAM_CONORMAL_DEGREE,
  GAUGE = CROSS - LAM_CONORMAL_DEGREE + 1,
  EACH = 3 * (CROSS + 1),
  COUNT = 4 * EACH,
  ROWS = 36 + 4 * GAUGE
};

/* Bernstein polynomials of a degree with first derivatives. */
static void bernstein(int degree, double t, double *value, double *slope) {
  value[0] = 1;
  for (int n = 1; n <= degree; n++) {
    if (n == degree)
      for (int i = 0; i <= n; i++) slope[i] = n * ((i ? value[i - 1] : 0) - (i < n ? value[i] : 0));
    value[n] = 0;
    for (int i = n; i >= 0; i--) value[i] = (1 - t) * value[i] + (i ? t * value[i - 1] : 0);
  }
}

static double choose(int n, int k) { return k ? choose(n - 1, k - 1) * n / k : 1; }

/* What coefficient k of z adds to T and T' of its curve at t. */
static void shape_eval(const lam_conormal_edge *edges, int k, double t, lam_vec3 *value, lam_vec3 *slope) {
  const lam_vec3 *c = edges[k / EACH].conormals, axis = {k % 3 == 0, k % 3 == 1, k % 3 == 2};
  int index = k % EACH / 3;
  double own[2][CROSS + 1], of_field[2][LAM_CONORMAL_POINTS];
  bernstein(CROSS, t, own[0], own[1]);
  bernstein(LAM_CONORMAL_DEGREE, t, of_field[0], of_field[1]);
  lam_vec3 field = {0, 0, 0}, change = {0, 0, 0};
  for (int i = 0; i < LAM_CONORMAL_POINTS; i++) {
    field = lam_along(field, of_field[0][i], c[i]);
    change = lam_along(change, of_field[1][i], c[i]);
  }
  field = lam_cross(field, axis);
  *value = lam_scale(field, own[0][index]);
  *slope = lam_along(lam_scale(lam_cross(change, axis), own[0][index]), own[1][index], field);
}

/* T at the ends of every curve, equal T' where curves meet, no part along nu in z: rows z = right. */
static void list_conditions(const lam_quad_boundary *b, const lam_conormal_edge *edges, double *rows, double *right) {
  for (int corner = 0; corner < 4; corner++) {
    lam_vec3 jet[2][4];
    double size = 0;
    for (int k = 0; k < 2; k++) {
      lam_quad_end end = lam_quad_meeting[corner][k];
      lam_quad_curve_eval(&b->curve[end.curve], end.end, jet[k]);
      size = fmax(size, lam_length(jet[k][1]));
    }
    for (int side = 0; side < 2; side++) {
      lam_quad_end end = lam_quad_meeting[corner][side];
      for (int k = end.curve * EACH; k < (end.curve + 1) * EACH; k++) {
        lam_vec3 value, slope;
        shape_eval(edges, k, end.end, &value, &slope);
        for (int c = 0; c < 3; c++) {
          rows[(9 * corner + 3 * side + c) * COUNT + k] = (&value.x)[c] / size;
          rows[(9 * corner + 6 + c) * COUNT + k] = (side ? -1 : 1) * (&slope.x)[c] / size;
        }
      }
      for (int c = 0; c < 3; c++) right[9 * corner + 3 * side + c] = (&jet[1 - side][1].x)[c] / size;
    }
  }
  for (int i = 0; i < 4; i++) { /* q nu, with q in Bernstein form */
    const lam_vec3 *nu = edges[i].conormals;
    double size = lam_length(nu[0]);
    for (int q = 0; q < GAUGE; q++)
      for (int j = 0; j < LAM_CONORMAL_POINTS; j++)
        for (int c = 0; c < 3; c++)
          rows[(36 + GAUGE * i + q) * COUNT + i * EACH + 3 * (j + q) + c] =
              choose(GAUGE - 1, q) * choose(LAM_CONORMAL_DEGREE, j) / choose(CROSS, j + q) * (&nu[j].x)[c] / size;
  }
}

/* T stays on one side of its curve, or the surface folds over: r' x T keeps near its own direction from place to place.
 */
static bool folds(const lam_quad_boundary *b, const lam_conormal_edge *edges, int curve, const double *z) {
  enum { PLACES = 32 };
  lam_vec3 last = {0, 0, 0};
  for (int g = 0; g <= PLACES; g++) {
    lam_vec3 jet[4], tangent = {0, 0, 0}, value, slope;
    double t = (double)g / PLACES;
    for (int k = curve * EACH; k < (curve + 1) * EACH; k++) {
      shape_eval(edges, k, t, &value, &slope);
      tangent = lam_along(tangent, z[k], value);
    }
    lam_quad_curve_eval(&b->curve[curve], t, jet);
    lam_vec3 normal = lam_cross(jet[1], tangent);
    if (g && !(lam_dot(normal, last) > 0)) return true;
    last = normal;
  }
  return false;
}

bool lam_conormal_patch_make(lam_arena *arena, const lam_conormal_edge edges[4], lam_place place, lam_errors *errors,
                             lam_asymptotic_patch *patch) {
  static const lam_quad_recipe recipe = {.degree = LAM_CONORMAL_CURVE, .surface = LAM_CONORMAL_SURFACE};
  const lam_quad_boundary *b = &patch->boundary;
  lam_quad_spaces spaces;
  lam_thin_plate plate;
  lam_quad_spaces_make(arena, b, &recipe, &spaces);
  if (!lam_quad_plate(arena, &spaces, &plate)) return false;
  int total = plate.count[0] * plate.count[1];
  lam_vec3 *net = lam_quad_rings(arena, &spaces), *part[COUNT];
  lam_quad_net_fill(arena, &plate, net);
  const lam_vec3 *pull = lam_quad_net_gradient(arena, &plate, net);
  double *h = LAM_NEW(arena, double, COUNT *COUNT), g[COUNT] = {0}, z[COUNT];
  for (int k = 0; k < COUNT; k++) {
    const lam_collocation *space = &spaces.space[k / EACH % 2];
    lam_vec3 *values = LAM_NEW(arena, lam_vec3, space->count), slope;
    for (int j = 0; j < space->count; j++) shape_eval(edges, k, space->places[j], &values[j], &slope);
    lam_collocation_solve(arena, space, 3, &values[0].x);
    part[k] = LAM_NEW(arena, lam_vec3, total);
    lam_quad_ring_add(&spaces, k / EACH, values, part[k]);
    lam_quad_net_fill(arena, &plate, part[k]);
    const lam_vec3 *gradient = lam_quad_net_gradient(arena, &plate, part[k]);
    g[k] = lam_quad_net_product(total, part[k], pull);
    for (int l = 0; l <= k; l++) h[k * COUNT + l] = h[l * COUNT + k] = lam_quad_net_product(total, part[l], gradient);
  }
  double *rows = LAM_NEW(arena, double, ROWS *COUNT), right[ROWS] = {0};
  list_conditions(b, edges, rows, right);
  if (lam_least_energy(arena, COUNT, h, g, ROWS, rows, right, 1e-9, z) != LAM_LEAST_FOUND) {
    lam_error_add(errors, place, "kind", "no tangents of least energy across the edges of a cell");
    return false;
  }
  for (int k = 0; k < COUNT; k++)
    for (int i = 0; i < total; i++) net[i] = lam_along(net[i], z[k], part[k][i]);
  patch->energy = lam_quad_net_product(total, net, lam_quad_net_gradient(arena, &plate, net));
  lam_quad_patch_finish(&spaces, net, &patch->surface);
  for (int i = 0; i < 4; i++)
    if (folds(b, edges, i, z)) {
      lam_error_add(errors, place, "kind", "the surface of least energy folds over along an edge of a cell");
      return false;
    }
  return true;
}
