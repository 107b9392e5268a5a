/* Vertex data of a skin from its points alone, for lam_asymptotic_skin_make. Called by the tests
 * alone; the program fills nets from conormals (skin_patches.c).
 *
 * Unknown at every vertex: two tangents, two curvatures, the torsion. The third derivative of an
 * edge is a polynomial of degree 4, so that a Gauss rule of 5 nodes turns the integral of
 * |r'''|^2 into a sum of 15 squares, each a function of the 18 unknowns of two vertices; their
 * derivatives are differences. The normal equations connect neighboring vertices only: with the
 * vertices of a row numbered in sequence they are a band. */
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/collocation.h"
#include "surf/asymptotic/asymptotic_skin.h"
#include "surf/spline/thin_plate.h"
#include <string.h>

/* Unknowns of a vertex; nodes and squares of an edge; steps, at most. */
enum { EACH = 9, RULE = 5, SQUARES = 3 * RULE, STEPS = 200 };

typedef struct lam_fit {
  lam_arena *arena;
  const int *count;    /* vertices in u and v */
  const double *gram;  /* 8 x 8, for lam_skin_edge */
  const double *third; /* RULE x 8: the third derivatives of the basis functions at the nodes, times
                          root weights */
  double size;         /* mean edge length, m: curvatures and torsions are unknown as multiples of
                          1 / size */
} lam_fit;

/* Adds to unknown number k of a vertex; `by` is in lengths of the net. */
static void move(lam_skin_vertex *v, int k, double by, double size) {
  if (k < 6)
    (&v->tangent[k / 3].x)[k % 3] += by * size;
  else if (k < 8)
    v->curvature[k - 6] += by / size;
  else
    v->torsion += by / size;
}

/* The 15 numbers whose squares sum up to the integral of |r'''|^2 over an edge along u (family
 * 0) or v. */
static void edge_squares(const lam_fit *f, const lam_skin_vertex *from, const lam_skin_vertex *to,
                         int family, double *squares) {
  lam_vec3 points[LAM_SKIN_POINTS];
  lam_skin_edge(f->arena, f->gram, from, to, family, points);

  for (int g = 0; g < RULE; g++) {
    lam_vec3 sum = lam_v3(0, 0, 0);
    for (int j = 0; j < LAM_SKIN_POINTS; j++)
      sum = lam_along(sum, f->third[g * LAM_SKIN_POINTS + j], points[j]);
    for (int c = 0; c < 3; c++) squares[3 * g + c] = (&sum.x)[c];
  }
}

/* The neighbor of vertex k along a family, or -1. */
static int next_of(const int count[2], int k, int family) {
  if (family) return k % count[1] + 1 < count[1] ? k + 1 : -1;
  return k / count[1] + 1 < count[0] ? k + count[1] : -1;
}

/* The derivatives of the squares of the edge between vertices k and next by their 18 unknowns, from
 * central differences. */
static void edge_jacobian(const lam_fit *f, const lam_skin_vertex *vertices, int k, int next,
                          int family, double jacobian[2 * EACH][SQUARES]) {
  const double h = 1e-5;
  for (int i = 0; i < 2 * EACH; i++) {
    double side[2][SQUARES];
    for (int s = 0; s < 2; s++) {
      lam_skin_vertex end[2] = {vertices[k], vertices[next]};
      move(&end[i / EACH], i % EACH, s ? h : -h, f->size);
      edge_squares(f, &end[0], &end[1], family, side[s]);
    }
    for (int g = 0; g < SQUARES; g++) jacobian[i][g] = (side[1][g] - side[0][g]) / (2 * h);
  }
}

/* Adds J^T J and -J^T r of the edge between vertices k and next; at: r. */
static void add_edge(int k, int next, double jacobian[2 * EACH][SQUARES], const double *at,
                     double *band, int width, double *right) {
  for (int i = 0; i < 2 * EACH; i++) {
    int row = EACH * (i < EACH ? k : next) + i % EACH;
    for (int g = 0; g < SQUARES; g++) right[row] -= jacobian[i][g] * at[g];

    for (int j = 0; j < 2 * EACH; j++) {
      int column = EACH * (j < EACH ? k : next) + j % EACH;
      if (column > row) continue;
      double *entry = &band[(size_t)row * width + column - row + width - 1];
      for (int g = 0; g < SQUARES; g++) *entry += jacobian[i][g] * jacobian[j][g];
    }
  }
}

/* The sum of all squares; with a band matrix (n rows of `width` entries up to the diagonal) also
 * J^T J and -J^T r. */
static double assemble(const lam_fit *f, const lam_skin_vertex *vertices, double *band, int width,
                       double *right) {
  double sum = 0;
  for (int k = 0; k < f->count[0] * f->count[1]; k++)
    for (int family = 0; family < 2; family++) {
      int next = next_of(f->count, k, family);
      if (next < 0) continue;

      double at[SQUARES], jacobian[2 * EACH][SQUARES];
      edge_squares(f, &vertices[k], &vertices[next], family, at);
      for (int g = 0; g < SQUARES; g++) sum += at[g] * at[g];
      if (!band) continue;

      edge_jacobian(f, vertices, k, next, family, jacobian);
      add_edge(k, next, jacobian, at, band, width, right);
    }
  return sum;
}

/* Solves the band system with `damping` times its diagonal added, in place of x, by Cholesky's
 * factorization in place of the band; false when it is not positive definite. */
static bool solve_band(int n, int width, double damping, double *band, double *x) {
  for (int i = 0; i < n; i++) {
    double *row = band + (size_t)i * width + width - 1 - i; /* row[j] is entry (i, j) */
    int first = i - width + 1 > 0 ? i - width + 1 : 0;
    row[i] += damping * row[i];

    double whole = row[i];
    for (int j = first; j <= i; j++) {
      const double *other = band + (size_t)j * width + width - 1 - j;
      for (int k = first; k < j; k++) row[j] -= row[k] * other[k];
      if (j < i) row[j] /= other[j];
    }

    if (!(row[i] > 1e-15 * whole)) return false;
    row[i] = sqrt(row[i]);
    for (int k = first; k < i; k++) x[i] -= row[k] * x[k];
    x[i] /= row[i];
  }

  for (int i = n - 1; i >= 0; i--) {
    const double *row = band + (size_t)i * width + width - 1 - i;
    x[i] /= row[i];
    for (int k = i - width + 1 > 0 ? i - width + 1 : 0; k < i; k++) x[k] -= row[k] * x[i];
  }
  return true;
}

/* The first derivative of the points at vertex k along a family, and the second one, from the
 * parabola through three neighbors; from the straight line through two where there are no more. */
static lam_vec3 difference(const int count[2], const lam_skin_vertex *v, int k, int family,
                           lam_vec3 *second) {
  int step = family ? 1 : count[1], at = family ? k % count[1] : k / count[1],
      last = count[family] - 1;
  *second = lam_v3(0, 0, 0);
  if (last == 1) return lam_sub(v[k + step * (1 - at)].point, v[k - step * at].point);

  /* At the border the parabola is that of the vertex beside it. */
  int shift = at == 0 ? 1 : at == last ? -1 : 0, middle = k + shift * step;
  lam_vec3 a = v[middle - step].point, b = v[middle].point, c = v[middle + step].point;
  *second = lam_along(lam_add(a, c), -2, b);
  return lam_along(lam_scale(lam_sub(c, a), 0.5), -shift, *second);
}

/* Tangents and curvatures from differences of points, torsions from those of normals. */
static void start_from_differences(const int count[2], lam_skin_vertex *v) {
  for (int k = 0; k < count[0] * count[1]; k++) {
    lam_vec3 second[2];
    for (int d = 0; d < 2; d++) v[k].tangent[d] = difference(count, v, k, d, &second[d]);
    for (int d = 0; d < 2; d++) {
      lam_vec3 t = v[k].tangent[d], other = v[k].tangent[1 - d];
      lam_vec3 nu = lam_unit(lam_along(other, -lam_dot(other, t) / lam_dot(t, t), t));
      v[k].curvature[d] = lam_dot(second[d], nu) / lam_dot(t, t);
    }
  }

  /* Along a u-curve N' = -tau |r'| nu, by the normals of neighbors. */
  for (int k = 0; k < count[0] * count[1]; k++) {
    int at = k / count[1], low = at ? k - count[1] : k, high = at + 1 < count[0] ? k + count[1] : k;
    lam_vec3 t = v[k].tangent[0], other = v[k].tangent[1];
    lam_vec3 nu = lam_unit(lam_along(other, -lam_dot(other, t) / lam_dot(t, t), t));

    lam_vec3 change = lam_sub(lam_unit(lam_cross(v[high].tangent[0], v[high].tangent[1])),
                              lam_unit(lam_cross(v[low].tangent[0], v[low].tangent[1])));
    double length = lam_length(t) * (high - low) / count[1];
    v[k].torsion = length > 0 ? -lam_dot(change, nu) / length : 0;
  }
}

/* The table `third` of lam_fit. */
static const double *third_derivatives(lam_arena *arena, const double *knots) {
  double nodes[RULE], weights[RULE], *third = LAM_NEW(arena, double, RULE *LAM_SKIN_POINTS);
  lam_gauss_rule(RULE, nodes, weights);
  for (int g = 0; g < RULE; g++) {
    double values[4 * LAM_BASIS_MAX_VALUES];
    lam_basis_eval(LAM_SKIN_DEGREE, knots, LAM_SKIN_DEGREE, nodes[g], 3, values);
    for (int j = 0; j < LAM_SKIN_POINTS; j++)
      third[g * LAM_SKIN_POINTS + j] = sqrt(weights[g]) * values[3 * LAM_SKIN_POINTS + j];
  }
  return third;
}

/* The mean length of the edges, m. */
static double mean_edge(const int count[2], const lam_skin_vertex *vertices) {
  double sum = 0;
  int edges = 0;
  for (int k = 0; k < count[0] * count[1]; k++)
    for (int family = 0; family < 2; family++) {
      int next = next_of(count, k, family);
      if (next < 0) continue;
      sum += lam_distance(vertices[k].point, vertices[next].point);
      edges++;
    }
  return sum / edges;
}

/* What stays the same in all steps: the two tables of edges, and the mean edge. */
static lam_fit prepare(lam_arena *arena, const int count[2], const lam_skin_vertex *vertices) {
  int order;
  const double *knots = lam_knots_repeat(arena, LAM_SKIN_DEGREE, 0, NULL, 1, &order);
  return (lam_fit){.arena = arena,
                   .count = count,
                   .gram = lam_spline_gram(arena, LAM_SKIN_DEGREE, LAM_SKIN_POINTS, knots, 3),
                   .third = third_derivatives(arena, knots),
                   .size = mean_edge(count, vertices)};
}

/* Levenberg-Marquardt; the damping rises tenfold until the sum falls, and falls tenfold after. */
double lam_asymptotic_skin_fit(lam_arena *arena, const int count[2], lam_skin_vertex *vertices,
                               lam_location location, lam_errors *errors, double *start) {
  lam_fit f = prepare(arena, count, vertices);
  int total = count[0] * count[1], n = EACH * total, width = EACH * (count[1] + 1);
  double *band = LAM_NEW(arena, double, (size_t)n *width),
         *factor = LAM_NEW(arena, double, (size_t)n *width);
  double *right = LAM_NEW(arena, double, n), *x = LAM_NEW(arena, double, n), damping = 1e-6;
  lam_skin_vertex *tried = LAM_NEW(arena, lam_skin_vertex, total);
  start_from_differences(count, vertices);
  double sum = *start = assemble(&f, vertices, NULL, 0, NULL);

  for (int step = 0; step < STEPS && isfinite(sum); step++) {
    memset(band, 0, (size_t)n * width * sizeof *band);
    memset(right, 0, (size_t)n * sizeof *right);
    assemble(&f, vertices, band, width, right);

    double reached = INFINITY;
    for (int attempt = 0; attempt < 20 && !(reached <= sum); attempt++) {
      memcpy(factor, band, (size_t)n * width * sizeof *band);
      memcpy(x, right, (size_t)n * sizeof *x);
      if (attempt) damping *= 10;
      if (!solve_band(n, width, damping, factor, x)) continue;
      memcpy(tried, vertices, (size_t)total * sizeof *tried);
      for (int i = 0; i < n; i++) move(&tried[i / EACH], i % EACH, x[i], f.size);
      reached = assemble(&f, tried, NULL, 0, NULL);
    }
    if (!(reached <= sum)) return sum;

    memcpy(vertices, tried, (size_t)total * sizeof *tried);
    double gain = sum - reached;
    sum = reached;
    damping = fmax(damping / 10, 1e-12);
    if (gain <= 1e-13 * sum) return sum;
  }

  if (!isfinite(sum)) {
    lam_error_add(errors, location, "vertices",
                  "the neighbors of a vertex lie on one line; expected a net of faces");
    return NAN;
  }
  return sum;
}
