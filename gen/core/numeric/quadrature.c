/* Gauss' rules. Called by curve (lengths, fairness, Gram matrices) and by surf. */
#include "core/numeric/quadrature.h"
#include "core/numbers.h"
#include <math.h>

/* Newton's method on the Legendre polynomial P_n from the guess cos(pi (k + 3/4) / (n + 1/2));
 * the weight on [-1,1] is 2 / ((1 - x^2) P_n'(x)^2) (Abramowitz & Stegun 25.4.29). Nodes come out
 * descending on [-1,1] and are mapped to [0,1], ascending. */
void lam_gauss_rule(int count, double *nodes, double *weights) {
  for (int k = 0; k < count; k++) {
    double x = cos(LAM_PI * (k + 0.75) / (count + 0.5)), slope = 1;

    for (int step = 0; step < 8; step++) {
      /* The recursion of the Legendre polynomials: at = P_n(x), before = P_n-1(x). */
      double before = 0, at = 1;
      for (int j = 1; j <= count; j++) {
        double next = ((2 * j - 1) * x * at - (j - 1) * before) / j;
        before = at;
        at = next;
      }

      slope = count * (x * at - before) / (x * x - 1);
      x -= at / slope;
    }

    nodes[count - 1 - k] = (1 + x) / 2;
    weights[count - 1 - k] = 1 / ((1 - x * x) * slope * slope);
  }
}
