/* A graph z = f(u,v) with x = u, y = v and a polynomial f of low degree; one line in
 * surfaces.c. */
#include "surf/surface_kind.h"

/* The terms of f: z = sum c_k u^i v^j. */
static const struct {
  int i, j;
} terms[] = {{2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2},
             {0, 3}, {4, 0}, {3, 1}, {2, 2}, {1, 3}, {0, 4}};
enum { TERMS = sizeof terms / sizeof terms[0], DEGREE = 4 };

/* The parameters of a row, and the data. */
typedef struct lam_monge {
  double c[TERMS];
} lam_monge;

/* powers[d][k]: the d-th derivative of t^k. */
static void fill_powers(double t, double powers[3][DEGREE + 1]) {
  powers[0][0] = 1;
  for (int k = 1; k <= DEGREE; k++) powers[0][k] = t * powers[0][k - 1];
  for (int d = 1; d < 3; d++)
    for (int k = 0; k <= DEGREE; k++) powers[d][k] = k > 0 ? k * powers[d - 1][k - 1] : 0;
}

/* Term by term. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_monge *s = data;
  double pu[3][DEGREE + 1], pv[3][DEGREE + 1];
  fill_powers(u, pu);
  fill_powers(v, pv);

  *jet = (lam_jet){.x = {u, v, 0}, .u = {1, 0, 0}, .v = {0, 1, 0}};
  for (int k = 0; k < TERMS; k++) {
    int i = terms[k].i, j = terms[k].j;
    jet->x.z += s->c[k] * pu[0][i] * pv[0][j];
    jet->u.z += s->c[k] * pu[1][i] * pv[0][j];
    jet->v.z += s->c[k] * pu[0][i] * pv[1][j];
    jet->uu.z += s->c[k] * pu[2][i] * pv[0][j];
    jet->uv.z += s->c[k] * pu[1][i] * pv[1][j];
    jet->vv.z += s->c[k] * pu[0][i] * pv[2][j];
  }
}

/* No chart but the natural one. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  return chart == LAM_CHART_NATURAL &&
         lam_domain_give((lam_domain){{-1, 1}, {-1, 1}, {false, false}}, p, q, closed);
}

/* The key of a term. */
#define TERM(text, k, value)                                                                       \
  LAM_NUMBER_KEY(lam_monge, text, c[k], value, 0, 0, "Coefficient of the term " text ".")
static const lam_key keys[] = {TERM("x2", 0, "0"),
                               TERM("xy", 1, "0"),
                               TERM("y2", 2, "0"),
                               TERM("x3", 3, "0"),
                               TERM("x2y", 4, "0"),
                               TERM("xy2", 5, "0"),
                               TERM("y3", 6, "0"),
                               TERM("x4", 7, "0"),
                               TERM("x3y", 8, "0"),
                               TERM("x2y2", 9, "0"),
                               TERM("xy3", 10, "0"),
                               TERM("y4", 11, "0"),
                               {0}};

const lam_surface_kind lam_surface_monge = {
    .head = {.name = "monge",
             .title = "Monge patch",
             .doc = "A height field given by a polynomial of degree 2 to 4: x2 is the coefficient "
                    "of x^2, x2y that of x^2 y, and so on. The quickest way to a dome (x2 and y2 "
                    "of one sign), a saddle (opposite signs) or a monkey saddle (x3: 1, xy2: -3). "
                    "Terms not named are zero: with none the patch is flat. Steep sides stretch "
                    "the meshes of a net laid over it.",
             .equation = "z = sum c_ij x^i y^j, 2 <= i + j <= 4",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 3-3",
             .keys = keys,
             .params_size = sizeof(lam_monge)},
    .eval = eval,
    .domain = domain};
