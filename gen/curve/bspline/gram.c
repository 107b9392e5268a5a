#include "curve/bspline/gram.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"

double *lam_spline_gram(lam_arena *arena, int degree, int count, const double *knots, int order) {
  double *gram = LAM_NEW(arena, double, count *count);
  double places[LAM_BASIS_MAX_VALUES], weights[LAM_BASIS_MAX_VALUES];
  lam_gauss_rule(degree + 1, places, weights);
  for (int span = degree; span < count; span++) {
    double width = knots[span + 1] - knots[span];
    for (int g = 0; width > 0 && g <= degree; g++) {
      double values[4 * LAM_BASIS_MAX_VALUES];
      lam_basis_eval(degree, knots, span, knots[span] + width * places[g], order, values);
      const double *row = values + order * (degree + 1);
      for (int i = 0; i <= degree; i++)
        for (int j = 0; j <= degree; j++)
          gram[(span - degree + i) * count + span - degree + j] +=
              width * weights[g] * row[i] * row[j];
    }
  }
  return gram;
}
