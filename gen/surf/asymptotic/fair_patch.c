/* Tangents across the boundary of least thin-plate energy, and the patch with them. Called by
 * make_quad.c and asymptotic_skin.c.
 *
 * r' and r'' span the osculating plane already, so T = x r' + y r'' with low-degree x and y: a
 * surface two degrees above its boundary, instead of six (thesis 2.3.3 multiplies by (r' x r'')
 * x r'). All coefficients of x and y are free but for the ends of T and the mixed derivatives in
 * the corners, which are linear conditions; T of a straight curve is any spline of the surface's
 * space.
 *
 * The surface is linear in the coefficients z and the inner points. Each coefficient alone, with
 * the inner points of least energy for it, is one surface D_k; the energy of D_0 + sum z_k D_k
 * is a quadratic function of z. */
#include "core/numeric/dense.h"
#include "curve/bspline/basis.h"
#include "surf/asymptotic/quad_parts.h"
#include "surf/spline/thin_plate.h"

enum { MAX_FREE = 4 * 3 * LAM_QUAD_MAX_POINTS };

/* A coefficient: T of one curve gets function number `index` of a space times r' (space 0) or r''
 * (1), or times an axis (2). */
typedef struct lam_shape {
  int curve, space, index;
  lam_vec3 axis; /* of a straight curve; otherwise not used */
} lam_shape;

/* The spaces of x, of y, and of T of straight curves, for one direction. */
typedef struct lam_shape_space {
  int degree, count;
  const double *knots;
} lam_shape_space;

typedef struct lam_shapes {
  lam_shape_space space[2][3]; /* of curves along u, along v */
  int count;
  lam_shape list[MAX_FREE];
} lam_shapes;

/* The spaces, and all coefficients of all curves. */
static void list_shapes(lam_arena *arena, const lam_quad_boundary *b, const lam_quad_spaces *spaces,
                        lam_shapes *s) {
  for (int d = 0; d < 2; d++) {
    const lam_quad_curve *c = &b->curve[d];
    int inner = c->count - c->degree - 1, surface = spaces->space[d].degree;

    /* With inner knots x and y are C1, as T has to be. */
    for (int k = 0; k < 2; k++) {
      lam_shape_space *space = &s->space[d][k];
      space->degree = surface - (c->degree - 1 - k);
      space->knots = lam_knots_repeat(arena, space->degree, inner, c->knots + c->degree + 1,
                                      space->degree - 1, &space->count);
    }
    s->space[d][2] = (lam_shape_space){surface, spaces->space[d].count, spaces->space[d].knots};
  }

  s->count = 0;
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 3; k++) {
      bool straight = b->curve[i].straight;
      for (int index = 0; straight && index < s->space[i % 2][2].count; index++)
        s->list[s->count++] = (lam_shape){i, 2, index, lam_v3(k == 0, k == 1, k == 2)};
      for (int index = 0; !straight && k < 2 && index < s->space[i % 2][k].count; index++)
        s->list[s->count++] = (lam_shape){i, k, index, lam_v3(0, 0, 0)};
    }
}

/* What a coefficient of 1 adds to T and T' of its curve at t. */
static void shape_eval(const lam_shapes *s, const lam_quad_boundary *b, const lam_shape *shape,
                       double t, lam_vec3 *value, lam_vec3 *slope) {
  const lam_shape_space *space = &s->space[shape->curve % 2][shape->space];
  double values[2 * LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(space->degree, space->count, space->knots, t),
      j = shape->index - span + space->degree;
  *value = *slope = lam_v3(0, 0, 0);
  if (j < 0 || j > space->degree) return;

  lam_basis_eval(space->degree, space->knots, span, t, 1, values);
  double f = values[j], df = values[space->degree + 1 + j];
  if (shape->space == 2) {
    *value = lam_scale(shape->axis, f);
    *slope = lam_scale(shape->axis, df);
    return;
  }

  lam_vec3 jet[4];
  lam_quad_curve_eval(&b->curve[shape->curve], t, jet);
  *value = lam_scale(jet[1 + shape->space], f);
  *slope = lam_along(lam_scale(jet[1 + shape->space], df), f, jet[2 + shape->space]);
}

/* What coefficient k, of the curve on a side (0: along u, 1: along v) of a corner, adds to the nine
 * conditions of the corner: its column in their rows. */
static void fill_column(const lam_shapes *s, const lam_quad_boundary *b, int k, int corner,
                        int side, double size, double *rows) {
  lam_vec3 value, slope;
  shape_eval(s, b, &s->list[k], lam_quad_meeting[corner][side].end, &value, &slope);
  for (int c = 0; c < 3; c++) {
    rows[(3 * side + c) * s->count + k] = (&value.x)[c] / size;
    rows[(6 + c) * s->count + k] = (side ? -1 : 1) * (&slope.x)[c] / size;
  }
}

/* The conditions rows z = right, in the unit of the largest tangent of a corner: T at both ends
 * of every curve (6 per corner), and equal T' where curves meet (3). Returns their number. */
static int list_conditions(const lam_shapes *s, const lam_quad_boundary *b, double *rows,
                           double *right) {
  int count = 0;
  for (int corner = 0; corner < 4; corner++) {
    double size = 0;
    lam_vec3 jet[2][4];
    for (int k = 0; k < 2; k++) {
      lam_quad_end end = lam_quad_meeting[corner][k];
      lam_quad_curve_eval(&b->curve[end.curve], end.end, jet[k]);
      size = fmax(size, lam_length(jet[k][1]));
    }

    for (int k = 0; k < s->count; k++)
      for (int side = 0; side < 2; side++)
        if (s->list[k].curve == lam_quad_meeting[corner][side].curve)
          fill_column(s, b, k, corner, side, size, rows + count * s->count);

    for (int side = 0; side < 2; side++)
      for (int c = 0; c < 3; c++) right[count + 3 * side + c] = (&jet[1 - side][1].x)[c] / size;
    count += 9;
  }
  return count;
}

/* y of curve i at t: the part of T along r'', by the coefficients z. */
static double bend_at(const lam_shapes *s, const double *z, int i, double t) {
  const lam_shape_space *space = &s->space[i % 2][1];
  double values[LAM_BASIS_MAX_VALUES], y = 0;
  int span = lam_basis_span(space->degree, space->count, space->knots, t);
  lam_basis_eval(space->degree, space->knots, span, t, 0, values);
  for (int k = 0; k < s->count; k++) {
    int j = s->list[k].index - span + space->degree;
    if (s->list[k].curve == i && s->list[k].space == 1 && j >= 0 && j <= space->degree)
      y += z[k] * values[j];
  }
  return y;
}

/* y has one sign, or the surface folds over its boundary; false with an error when it has not. */
static bool check_folds(const lam_shapes *s, const lam_quad_boundary *b, const double *z,
                        lam_location location, lam_errors *errors) {
  enum { SAMPLES = 64 };
  for (int i = 0; i < 4; i++) {
    double low = INFINITY, high = -INFINITY;
    for (int g = 0; !b->curve[i].straight && g <= SAMPLES; g++) {
      double y = bend_at(s, z, i, (double)g / SAMPLES);
      low = fmin(low, y);
      high = fmax(high, y);
    }

    if (!b->curve[i].straight && low * high <= 0) {
      lam_error_add(errors, location, "form",
                    "the surface of least energy folds over along r%d; expected calmer corner "
                    "data, or form bi-11",
                    i + 1);
      return false;
    }
  }
  return true;
}

/* D_k, the net of coefficient k alone: its second ring, and inner points of least energy. */
static lam_vec3 *shape_net(lam_arena *arena, const lam_shapes *s, int k,
                           const lam_quad_boundary *boundary, const lam_quad_spaces *spaces,
                           const lam_thin_plate *plate) {
  const lam_shape *shape = &s->list[k];
  const lam_collocation *space = &spaces->space[shape->curve % 2];
  lam_vec3 *values = LAM_NEW(arena, lam_vec3, space->count), slope;
  for (int j = 0; j < space->count; j++)
    shape_eval(s, boundary, shape, space->nodes[j], &values[j], &slope);
  lam_collocation_solve(arena, space, 3, &values[0].x);

  lam_vec3 *net = LAM_NEW(arena, lam_vec3, plate->count[0] * plate->count[1]);
  lam_quad_ring_add(spaces, shape->curve, values, net);
  lam_quad_net_fill(arena, plate, net);
  return net;
}

/* Sets up the quadratic function of z and its conditions, and adds the best sum of the D_k. */
bool lam_quad_patch_free(lam_arena *arena, const lam_quad_boundary *boundary,
                         const lam_quad_recipe *recipe, lam_location location, lam_errors *errors,
                         lam_asymptotic_patch *patch) {
  lam_quad_spaces spaces;
  lam_thin_plate plate;
  lam_shapes *s = LAM_NEW(arena, lam_shapes, 1);
  lam_quad_spaces_make(arena, boundary, recipe, &spaces);
  if (!lam_quad_plate(arena, &spaces, &plate)) return false;
  list_shapes(arena, boundary, &spaces, s);

  int total = plate.count[0] * plate.count[1], n = s->count;
  lam_vec3 *net = lam_quad_rings(arena, &spaces), **part = LAM_NEW(arena, lam_vec3 *, n);
  lam_quad_net_fill(arena, &plate, net);
  const lam_vec3 *pull = lam_quad_net_gradient(arena, &plate, net);

  double *h = LAM_NEW(arena, double, n *n), *g = LAM_NEW(arena, double, n),
         *z = LAM_NEW(arena, double, n);
  for (int k = 0; k < n; k++) {
    part[k] = shape_net(arena, s, k, boundary, &spaces, &plate);
    const lam_vec3 *gradient = lam_quad_net_gradient(arena, &plate, part[k]);
    g[k] = lam_quad_net_product(total, part[k], pull);
    for (int l = 0; l <= k; l++)
      h[k * n + l] = h[l * n + k] = lam_quad_net_product(total, part[l], gradient);
  }

  double *rows = LAM_NEW(arena, double, 36 * n), right[36] = {0};
  int conditions = list_conditions(s, boundary, rows, right);
  if (lam_least_energy(arena, n, h, g, conditions, rows, right, 1e-9, z) != LAM_LEAST_FOUND) {
    lam_error_add(errors, location, "form",
                  "no tangents of least energy across the boundary; expected form bi-11");
    return false;
  }

  for (int k = 0; k < n; k++)
    for (int i = 0; i < total; i++) net[i] = lam_along(net[i], z[k], part[k][i]);
  patch->energy = lam_quad_net_product(total, net, lam_quad_net_gradient(arena, &plate, net));
  lam_quad_patch_finish(&spaces, net, &patch->surface);
  return check_folds(s, boundary, z, location, errors);
}
