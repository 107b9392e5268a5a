/* The Gram matrix of a spline space, the quadratic form of fairing. Called by
 * curve/curve_fairing.c, by surf/spline and by surf/asymptotic. */
#include "curve/bspline/gram.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"

/* Gauss' rule with degree + 1 nodes per piece is exact: the integrands have degree 2 p at most. */
double *lam_spline_gram(lam_arena *arena, int degree, int count, const double *knots, int order) {
  double *gram = LAM_NEW(arena, double, count *count);
  double nodes[LAM_BASIS_MAX_VALUES], weights[LAM_BASIS_MAX_VALUES];
  lam_gauss_rule(degree + 1, nodes, weights);

  for (int span = degree; span < count; span++) {
    double width = knots[span + 1] - knots[span];
    for (int g = 0; width > 0 && g <= degree; g++) {
      double values[4 * LAM_BASIS_MAX_VALUES];
      lam_basis_eval(degree, knots, span, knots[span] + width * nodes[g], order, values);
      const double *row = values + order * (degree + 1);

      for (int i = 0; i <= degree; i++)
        for (int j = 0; j <= degree; j++)
          gram[(span - degree + i) * count + span - degree + j] +=
              width * weights[g] * row[i] * row[j];
    }
  }

  return gram;
}
