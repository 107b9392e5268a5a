/* Rational surfaces over a rational asymptotic boundary (thesis 2.4.2 and 2.4.3). Called by
 * make_quad.c.
 *
 * In homogeneous coordinates the surface is A / W. Along v = 0, W_v = p h W with p the degree
 * and h the cubic whose ends make the weights of the second ring agree in the corners (h' = 0
 * there makes their mixed derivatives agree), and A_v = W T + p h A, both of degree p. The same
 * at the other edges. Inner weights are 1; inner points minimize the thin-plate energy, by a
 * Gauss rule. */
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/asymptotic/quad_parts.h"
#include "surf/spline/spline_surface.h"

/* Nodes of the Gauss rule in each direction. */
enum { NODES = 40 };

typedef double lam_homogeneous[4];                      /* w x, w y, w z, w */
typedef double lam_seconds[3];                          /* derivatives uu, uv, vv */
typedef double lam_basis_row[3 * LAM_BASIS_MAX_VALUES]; /* values, first and second derivatives */

/* W of a boundary curve and its derivative at t. */
static void weight_at(const lam_quad_curve *c, double t, double *w, double *dw) {
  double values[2 * LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(c->degree, c->count, c->knots, t), width = c->degree + 1;
  lam_basis_eval(c->degree, c->knots, span, t, 1, values);
  *w = *dw = 0;
  for (int j = 0; j < width; j++) {
    *w += values[j] * c->weights[span - c->degree + j];
    *dw += values[width + j] * c->weights[span - c->degree + j];
  }
}

/* The derivative (A_v, W_v) across curve i in the space of the surface, by its values at the nodes
 * of the space. slope: coefficients, as many as the space has. */
static void slopes_across(lam_arena *arena, const lam_quad_boundary *b,
                          const lam_quad_tangents *tangents, const lam_collocation *space, int i,
                          double (*slope)[4]) {
  double end[2];
  for (int e = 0; e < 2; e++) {
    double w, dw;
    lam_quad_end o = lam_quad_other[i][e];
    weight_at(&b->curve[o.curve], o.end, &w, &dw);
    end[e] = dw / w;
  }

  for (int k = 0; k < space->count; k++) {
    double t = space->nodes[k], w, dw;
    double h = end[0] * (1 - t) * (1 - t) * (1 + 2 * t) + end[1] * t * t * (3 - 2 * t); /* p h */
    lam_vec3 jet[4], across = lam_quad_tangents_eval(tangents, i, t);
    lam_quad_curve_eval(&b->curve[i], t, jet);
    weight_at(&b->curve[i], t, &w, &dw);
    for (int c = 0; c < 3; c++) {
      slope[k][c] = w * ((&across.x)[c] + h * (&jet[0].x)[c]);
    }
    slope[k][3] = h * w;
  }
  lam_collocation_solve(arena, space, 4, &slope[0][0]);
}

/* Sets both rings of the net in homogeneous coordinates. */
static void homogeneous_rings(lam_arena *arena, const lam_quad_boundary *b,
                              const lam_quad_tangents *tangents, const lam_quad_spaces *spaces,
                              double (*net)[4]) {
  for (int i = 0; i < 4; i++) {
    const lam_collocation *space = &spaces->space[i % 2];
    int count = space->count, degree = space->degree, skip = i % 2 ? 2 : 1;
    double(*ring)[4] = LAM_NEW(arena, lam_homogeneous, count),
    (*slope)[4] = LAM_NEW(arena, lam_homogeneous, count);
    slopes_across(arena, b, tangents, space, i, slope);

    for (int k = 0; k < b->curve[i].count; k++) {
      double w = b->curve[i].weights[k];
      lam_vec3 p = b->curve[i].points[k];
      ring[k][0] = w * p.x, ring[k][1] = w * p.y, ring[k][2] = w * p.z, ring[k][3] = w;
    }
    lam_bezier_elevate(b->curve[i].degree, degree, 4, &ring[0][0]);

    for (int k = 0; k < count; k++)
      for (int c = 0; c < 4; c++) {
        net[lam_quad_ring_index(spaces, i, 0, k)][c] = ring[k][c];
        if (k >= skip && k < count - skip)
          net[lam_quad_ring_index(spaces, i, 1, k)][c] =
              ring[k][c] + (i < 2 ? 1.0 : -1.0) / degree * slope[k][c];
      }
  }
}

/* Second derivatives (uu, uv, vv) of N_i(u) N_j(v) / W from those of N_i, N_j (0 to 2, a stride
 * apart) and W's jet (w, u, v, uu, uv, vv). */
static void rational_function(const double *n, const double *m, int stride, const double w[6],
                              double out[3]) {
  double x = n[0] * m[0] / w[0];
  double xu = (n[stride] * m[0] - w[1] * x) / w[0], xv = (n[0] * m[stride] - w[2] * x) / w[0];
  out[0] = (n[2 * stride] * m[0] - 2 * w[1] * xu - w[3] * x) / w[0];
  out[1] = (n[stride] * m[stride] - w[1] * xv - w[2] * xu - w[4] * x) / w[0];
  out[2] = (n[0] * m[2 * stride] - 2 * w[2] * xv - w[5] * x) / w[0];
}

/* W's jet (w, u, v, uu, uv, vv) at a node with the basis functions n in u and m in v. */
static void weight_jet(const lam_spline_surface *s, const double *n, const double *m, double w[6]) {
  int width = s->degree[0] + 1;
  for (int i = 0; i < width; i++)
    for (int j = 0; j < width; j++) {
      double weight = s->weights[i * width + j];
      w[0] += weight * n[i] * m[j];
      w[1] += weight * n[width + i] * m[j];
      w[2] += weight * n[i] * m[width + j];
      w[3] += weight * n[2 * width + i] * m[j];
      w[4] += weight * n[width + i] * m[width + j];
      w[5] += weight * n[i] * m[2 * width + j];
    }
}

/* Adds a node of the Gauss rule, of weight `factor`, to the equations of the inner points. jet: of
 * the surface without them; functions: room for the second derivatives of the inner functions. */
static void add_node(const lam_spline_surface *s, const lam_jet *jet, const double *n,
                     const double *m, double factor, double *matrix, double *right,
                     double (*functions)[3]) {
  int width = s->degree[0] + 1, inner = width - 4, total = inner * inner;
  double w[6] = {0};
  weight_jet(s, n, m, w);

  for (int a = 0; a < total; a++) {
    double *f = functions[a];
    rational_function(n + 2 + a / inner, m + 2 + a % inner, width, w, f);

    for (int c = 0; c < 3; c++)
      right[c * total + a] -=
          factor * (f[0] * (&jet->uu.x)[c] + 2 * f[1] * (&jet->uv.x)[c] + f[2] * (&jet->vv.x)[c]);
    double f0 = factor * f[0], f1 = 2 * factor * f[1], f2 = factor * f[2],
           *row = matrix + a * total;
    for (int b = 0; b <= a; b++)
      row[b] += f0 * functions[b][0] + f1 * functions[b][1] + f2 * functions[b][2];
  }
}

/* Sets the inner points to those of least energy, for a Bezier surface whose inner weights are 1
 * and whose inner points are 0; false: the energy has no unique minimum. */
static bool fill(lam_arena *arena, const lam_spline_surface *s, lam_vec3 *points) {
  int width = s->degree[0] + 1, inner = width - 4, total = inner * inner;
  double *matrix = LAM_NEW(arena, double, total *total), *right = LAM_NEW(arena, double, 3 * total);
  double(*functions)[3] = LAM_NEW(arena, lam_seconds, total), nodes[NODES], weights[NODES];
  double(*basis)[3 * LAM_BASIS_MAX_VALUES] = LAM_NEW(arena, lam_basis_row, NODES);

  const lam_nurbs *nurbs = lam_nurbs_make(arena, s);
  lam_gauss_rule(NODES, nodes, weights);
  for (int g = 0; g < NODES; g++)
    lam_basis_eval(s->degree[0], s->knots[0], s->degree[0], nodes[g], 2, basis[g]);

  for (int g = 0; g < NODES * NODES; g++) {
    int a = g / NODES, b = g % NODES;
    lam_jet jet;
    lam_nurbs_eval(nurbs, nodes[a], nodes[b], &jet);
    add_node(s, &jet, basis[a], basis[b], weights[a] * weights[b], matrix, right, functions);
  }

  if (!lam_cholesky_factor(total, matrix)) return false;
  for (int c = 0; c < 3; c++) {
    lam_cholesky_solve(total, matrix, right + c * total);
    for (int a = 0; a < total; a++)
      (&points[(2 + a / inner) * width + 2 + a % inner].x)[c] = right[c * total + a];
  }
  return true;
}

/* Both rings, then the inner points. */
bool lam_quad_patch_rational(lam_arena *arena, const lam_quad_boundary *boundary,
                             const lam_quad_recipe *recipe, lam_location location,
                             lam_errors *errors, lam_asymptotic_patch *patch) {
  lam_quad_spaces spaces;
  lam_quad_tangents *tangents = LAM_NEW(arena, lam_quad_tangents, 1);
  lam_quad_spaces_make(arena, boundary, recipe, &spaces);
  lam_quad_tangents_make(arena, boundary, tangents);

  int width = spaces.space[0].count, total = width * width;
  double(*net)[4] = LAM_NEW(arena, lam_homogeneous, total),
  *weights = LAM_NEW(arena, double, total);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, total);
  homogeneous_rings(arena, boundary, tangents, &spaces, net);

  for (int k = 0; k < total; k++) {
    int i = k / width, j = k % width;
    bool inner = i > 1 && j > 1 && i < width - 2 && j < width - 2;
    weights[k] = inner ? 1 : net[k][3];
    if (!inner) points[k] = lam_scale(lam_v3(net[k][0], net[k][1], net[k][2]), 1 / weights[k]);

    if (!(weights[k] > 0)) {
      lam_error_add(errors, location, "weights",
                    "a weight next to the boundary becomes %g; expected corner weights and "
                    "curvatures that are less uneven",
                    weights[k]);
      return false;
    }
  }

  lam_quad_patch_finish(&spaces, points, &patch->surface);
  patch->surface.weights = weights;
  if (!fill(arena, &patch->surface, points)) return false;
  patch->energy = lam_thin_plate_energy(arena, &patch->surface, NODES);
  return true;
}
