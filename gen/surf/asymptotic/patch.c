/* Control nets over an asymptotic boundary: two outer rings from the curves and the tangents
 * across them, inner points of least thin-plate energy (thesis 2.3.3 and 2.5.3). Called by
 * make_quad.c, fair_patch.c and rational_patch.c. With h the width of the knot span at the edge
 * and p the degree, Q(i,1) = Q(i,0) + h/p T1(i), and likewise at the other three edges. */
#include "surf/asymptotic/quad_parts.h"
#include "surf/spline/thin_plate.h"

/* Bezier curves are raised in degree; splines are interpolated at the nodes of the space, which
 * is exact; rational curves are left out. */
void lam_quad_spaces_make(lam_arena *arena, const lam_quad_boundary *boundary,
                          const lam_quad_recipe *recipe, lam_quad_spaces *spaces) {
  for (int d = 0; d < 2; d++) {
    const lam_quad_curve *c = &boundary->curve[d];
    int count;
    const double *knots = lam_knots_repeat(arena, recipe->surface, c->count - c->degree - 1,
                                           c->knots + c->degree + 1, recipe->multiplicity, &count);
    spaces->space[d] = lam_collocation_make(arena, recipe->surface, count, knots);
  }

  for (int i = 0; i < 4; i++) {
    const lam_collocation *space = &spaces->space[i % 2];
    lam_vec3 *points = spaces->curve[i] = LAM_NEW(arena, lam_vec3, space->count);
    const lam_quad_curve *c = &boundary->curve[i];

    if (c->weights) continue;
    if (c->count == c->degree + 1) {
      for (int k = 0; k < c->count; k++) points[k] = c->points[k];
      lam_bezier_elevate(c->degree, space->degree, 3, &points[0].x);
      continue;
    }

    for (int k = 0; k < space->count; k++) {
      lam_vec3 jet[4];
      lam_quad_curve_eval(c, space->nodes[k], jet);
      points[k] = jet[0];
    }
    lam_collocation_solve(arena, space, 3, &points[0].x);
  }
}

/* `across` is the row or column of the ring at the curve. */
int lam_quad_ring_index(const lam_quad_spaces *spaces, int curve, int ring, int k) {
  int m = spaces->space[0].count, n = spaces->space[1].count;
  int across[4] = {ring, ring, n - 1 - ring, m - 1 - ring};
  return curve % 2 ? across[curve] * n + k : k * n + across[curve];
}

/* The factor h/p of the tangents across a curve, negative along r3 and r4. */
static double ring_step(const lam_quad_spaces *spaces, int curve) {
  const lam_collocation *across = &spaces->space[1 - curve % 2];
  double low = across->knots[across->degree + 1], high = 1 - across->knots[across->count - 1];
  return (curve < 2 ? low : -high) / across->degree;
}

/* Curves along u set the ring but for its first and last point, those along v but for two points
 * at each end. */
void lam_quad_ring_add(const lam_quad_spaces *spaces, int curve, const lam_vec3 *tangents,
                       lam_vec3 *net) {
  int count = spaces->space[curve % 2].count, skip = curve % 2 ? 2 : 1;
  for (int k = skip; k < count - skip; k++) {
    lam_vec3 *point = &net[lam_quad_ring_index(spaces, curve, 1, k)];
    *point = lam_along(*point, ring_step(spaces, curve), tangents[k]);
  }
}

/* The points of the second ring are those of the first beside them. */
lam_vec3 *lam_quad_rings(lam_arena *arena, const lam_quad_spaces *spaces) {
  lam_vec3 *net = LAM_NEW(arena, lam_vec3, spaces->space[0].count * spaces->space[1].count);
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < spaces->space[i % 2].count; k++)
      for (int ring = 0; ring < 2; ring++)
        if (ring == 0 || (k > i % 2 && k < spaces->space[i % 2].count - 1 - i % 2))
          net[lam_quad_ring_index(spaces, i, ring, k)] = spaces->curve[i][k];
  return net;
}

/* Coordinate by coordinate. */
void lam_quad_net_fill(lam_arena *arena, const lam_thin_plate *plate, lam_vec3 *net) {
  int total = plate->count[0] * plate->count[1];
  double *part = LAM_NEW(arena, double, total);
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < total; i++) part[i] = (&net[i].x)[c];
    lam_thin_plate_fill(arena, plate, part);
    for (int i = 0; i < total; i++) (&net[i].x)[c] = part[i];
  }
}

/* Coordinate by coordinate. */
lam_vec3 *lam_quad_net_gradient(lam_arena *arena, const lam_thin_plate *plate,
                                const lam_vec3 *net) {
  int total = plate->count[0] * plate->count[1];
  double *part = LAM_NEW(arena, double, total), *product = LAM_NEW(arena, double, total);
  lam_vec3 *gradient = LAM_NEW(arena, lam_vec3, total);
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < total; i++) part[i] = (&net[i].x)[c];
    lam_thin_plate_apply(arena, plate, part, product);
    for (int i = 0; i < total; i++) (&gradient[i].x)[c] = product[i];
  }
  return gradient;
}

double lam_quad_net_product(int total, const lam_vec3 *a, const lam_vec3 *b) {
  double sum = 0;
  for (int i = 0; i < total; i++) sum += lam_dot(a[i], b[i]);
  return sum;
}

/* Points are taken over, not copied. */
void lam_quad_patch_finish(const lam_quad_spaces *spaces, const lam_vec3 *net,
                           lam_spline_surface *surface) {
  *surface = (lam_spline_surface){.points = net};
  for (int d = 0; d < 2; d++) {
    surface->degree[d] = spaces->space[d].degree;
    surface->count[d] = spaces->space[d].count;
    surface->knots[d] = spaces->space[d].knots;
  }
}

/* Degrees, counts and knots of the spaces. */
bool lam_quad_plate(lam_arena *arena, const lam_quad_spaces *spaces, lam_thin_plate *plate) {
  const lam_collocation *s = spaces->space;
  return lam_thin_plate_make(arena, (int[2]){s[0].degree, s[1].degree},
                             (int[2]){s[0].count, s[1].count},
                             (const double *const[2]){s[0].knots, s[1].knots}, plate);
}

/* The tangents are splines of the surface's space, so that interpolation at its nodes is exact. */
bool lam_quad_patch_fixed(lam_arena *arena, const lam_quad_boundary *boundary,
                          const lam_quad_recipe *recipe, lam_asymptotic_patch *patch) {
  lam_quad_spaces spaces;
  lam_quad_tangents *tangents = LAM_NEW(arena, lam_quad_tangents, 1);
  lam_thin_plate plate;
  lam_quad_spaces_make(arena, boundary, recipe, &spaces);
  lam_quad_tangents_make(arena, boundary, tangents);

  lam_vec3 *net = lam_quad_rings(arena, &spaces);
  for (int i = 0; i < 4; i++) {
    const lam_collocation *space = &spaces.space[i % 2];
    lam_vec3 *values = LAM_NEW(arena, lam_vec3, space->count);
    for (int k = 0; k < space->count; k++)
      values[k] = lam_quad_tangents_eval(tangents, i, space->nodes[k]);
    lam_collocation_solve(arena, space, 3, &values[0].x);
    lam_quad_ring_add(&spaces, i, values, net);
  }

  if (!lam_quad_plate(arena, &spaces, &plate)) return false;
  lam_quad_net_fill(arena, &plate, net);
  patch->energy = lam_quad_net_product(plate.count[0] * plate.count[1], net,
                                       lam_quad_net_gradient(arena, &plate, net));
  lam_quad_patch_finish(&spaces, net, &patch->surface);
  return true;
}
