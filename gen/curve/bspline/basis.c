/* Evaluation of B-splines (Cox-de Boor recursion; Piegl & Tiller, The NURBS Book, ch. 2), and
 * knot vectors: even ones, and what may be wrong with one. Called by all of curve, by the spline
 * surfaces of surf, and by net/handles.c. */
#include "curve/bspline/basis.h"
#include <math.h>
#include <stddef.h>

/* The ends first: the empty pieces that repeated knots make there are skipped. Inside, bisection
 * (A2.1). */
int lam_basis_span(int degree, int count, const double *knots, double t) {
  int low = degree, high = count;

  if (t >= knots[count]) {
    int span = count - 1;
    while (span > degree && knots[span] >= knots[span + 1]) span--;
    return span;
  }
  if (t <= knots[degree]) {
    int span = degree;
    while (span < count - 1 && knots[span] >= knots[span + 1]) span++;
    return span;
  }

  while (high - low > 1) { /* knots[low] <= t < knots[high] */
    int middle = low + (high - low) / 2;
    if (t < knots[middle])
      high = middle;
    else
      low = middle;
  }
  return low;
}

/* The triangular table of the Cox-de Boor recursion: table[j][r] for r <= j holds function r of
 * degree j, and table[r][j] for r < j the knot difference that divides it (Piegl & Tiller, The
 * NURBS Book, A2.3). */
typedef double lam_basis_table[LAM_BASIS_MAX_VALUES][LAM_BASIS_MAX_VALUES];

/* Fills the table for the piece `span` at t. */
static void fill_table(int degree, const double *knots, int span, double t, lam_basis_table upper) {
  double left[LAM_BASIS_MAX_VALUES], right[LAM_BASIS_MAX_VALUES];
  upper[0][0] = 1;

  for (int j = 1; j <= degree; j++) {
    double saved = 0;
    left[j] = t - knots[span + 1 - j];
    right[j] = knots[span + j] - t;

    for (int r = 0; r < j; r++) {
      upper[j][r] = right[r + 1] + left[j - r]; /* a knot difference > 0: the piece is not empty */
      double part = upper[r][j - 1] / upper[j][r];
      upper[r][j] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    upper[j][j] = saved;
  }
}

/* Derivatives 1 .. order of the function with index r in its piece, before the factor p!/(p-k)!,
 * into values[k * (degree + 1) + r]. rows[now] holds the coefficients a_k,j by which the k-th
 * derivative combines functions of degree p - k (A2.3, eq. 2.10). */
static void derive(int degree, int r, int order, lam_basis_table table, double *values) {
  double rows[2][LAM_BASIS_MAX_VALUES] = {{1}};
  int now = 0;
  for (int k = 1; k <= order; k++) {
    double *a = rows[now], *b = rows[1 - now], sum = 0;
    int rk = r - k, pk = degree - k;

    /* The first coefficient, the inner ones and the last: each where the function it belongs to
     * exists. */
    if (r >= k) {
      b[0] = a[0] / table[pk + 1][rk];
      sum = b[0] * table[rk][pk];
    }
    int first = rk >= -1 ? 1 : -rk, last = r - 1 <= pk ? k - 1 : degree - r;
    for (int j = first; j <= last; j++) {
      b[j] = (a[j] - a[j - 1]) / table[pk + 1][rk + j];
      sum += b[j] * table[rk + j][pk];
    }
    if (r <= pk) {
      b[k] = -a[k - 1] / table[pk + 1][r];
      sum += b[k] * table[r][pk];
    }

    values[k * (degree + 1) + r] = sum;
    now = 1 - now;
  }
}

/* Values from the table, derivatives by the recursion, then the factors p, p(p-1), ... of
 * eq. 2.10. */
void lam_basis_eval(int degree, const double *knots, int span, double t, int order,
                    double *values) {
  lam_basis_table table;
  int width = degree + 1, highest = order < degree ? order : degree;
  fill_table(degree, knots, span, t, table);
  for (int j = 0; j < width; j++) values[j] = table[j][degree];
  for (int r = 0; highest > 0 && r < width; r++) derive(degree, r, highest, table, values);

  double factor = degree;
  for (int k = 1; k <= highest; k++) {
    for (int j = 0; j < width; j++) values[k * width + j] *= factor;
    factor *= degree - k;
  }

  for (int i = (highest + 1) * width; i < (order + 1) * width; i++) values[i] = 0;
}

/* Knots 0 and 1 at the ends, j / pieces between them. */
void lam_knots_clamped(int degree, int count, double *knots) {
  int pieces = count - degree;
  for (int i = 0; i < count + degree + 1; i++) {
    int step = i - degree;
    knots[i] = step <= 0 ? 0 : step >= pieces ? 1 : (double)step / pieces;
  }
}

/* Simple faults first, so that the later tests can rely on ordered, finite knots of the right
 * number. */
const char *lam_knots_problem(int degree, int count, int knot_count, const double *knots) {
  if (knot_count != count + degree + 1)
    return "must be as many as points in this direction + degree + 1";

  for (int i = 0; i < knot_count; i++) {
    if (!isfinite(knots[i])) return "must be finite";
    if (i > 0 && knots[i] < knots[i - 1]) return "must not decrease";
  }
  if (!(knots[degree] < knots[count])) return "leave an empty domain";

  int most = degree > 1 ? degree : 1; /* for an inner knot */
  for (int i = 1, repeats = 1; i < knot_count; i++) {
    repeats = knots[i] > knots[i - 1] ? 1 : repeats + 1;
    if (repeats > most && knots[i] > knots[degree] && knots[i] < knots[count])
      return "must not repeat an inner knot more often than the degree";
    if (repeats > degree + 1) return "must not repeat a knot more than degree + 1 times";
  }

  return NULL;
}
