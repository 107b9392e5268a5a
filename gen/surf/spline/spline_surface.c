/* Tensor-product surfaces: Bezier, B-spline and NURBS share one evaluation, for all kinds of
 * surf that are splines and for the parts of fab that lie on them.
 *   x(u,v) = sum_ij N_i(u) N_j(v) w_ij P_ij / sum_ij N_i(u) N_j(v) w_ij
 * Derivatives follow from A = sum N N w P and W = sum N N w (Piegl & Tiller, The NURBS Book,
 * 4.5):
 *   x_u  = (A_u - W_u x) / W,   x_uu = (A_uu - 2 W_u x_u - W_uu x) / W,
 *   x_uv = (A_uv - W_u x_v - W_v x_u - W_uv x) / W. */
#include "surf/spline/spline_surface.h"
#include "curve/bspline/basis.h"
#include "surf/surface_kind.h"

/* A surface prepared for evaluation. */
struct lam_nurbs {
  lam_spline_surface shape;
  const double *net; /* count[0] x count[1] rows of w x, w y, w z, w */
  bool closed[2];
};

/* A homogeneous point. */
typedef struct lam_point4 {
  double x[4];
} lam_point4;

/* A and W with derivatives: sum[a][b] is the derivative a times by u and b times by v; only
 * a + b <= 2 is filled. */
static void sum_net(const lam_nurbs *s, double u, double v, lam_point4 sum[3][3]) {
  double at[2] = {u, v}, values[2][3 * LAM_BASIS_MAX_VALUES];
  int first[2], width[2];

  for (int d = 0; d < 2; d++) {
    int span = lam_basis_span(s->shape.degree[d], s->shape.count[d], s->shape.knots[d], at[d]);
    lam_basis_eval(s->shape.degree[d], s->shape.knots[d], span, at[d], 2, values[d]);
    first[d] = span - s->shape.degree[d];
    width[d] = s->shape.degree[d] + 1;
  }

  for (int i = 0; i < width[0]; i++) {
    const double *row = s->net + 4 * ((size_t)(first[0] + i) * s->shape.count[1] + first[1]);
    double across[3][4] = {{0}}; /* the row summed over v, with derivatives by v */
    for (int j = 0; j < width[1]; j++)
      for (int b = 0; b < 3; b++)
        for (int c = 0; c < 4; c++) across[b][c] += values[1][b * width[1] + j] * row[4 * j + c];
    for (int a = 0; a < 3; a++)
      for (int b = 0; a + b < 3; b++)
        for (int c = 0; c < 4; c++) sum[a][b].x[c] += values[0][a * width[0] + i] * across[b][c];
  }
}

/* The first three components. */
static lam_vec3 position(const lam_point4 *p) { return lam_v3(p->x[0], p->x[1], p->x[2]); }

/* Each derivative uses those of lower order. */
void lam_nurbs_eval(const void *data, double u, double v, lam_jet *jet) {
  lam_point4 sum[3][3] = {0};
  sum_net(data, u, v, sum);

  double w = 1 / sum[0][0].x[3];
  double wu = sum[1][0].x[3], wv = sum[0][1].x[3], wuu = sum[2][0].x[3], wuv = sum[1][1].x[3],
         wvv = sum[0][2].x[3];

  lam_vec3 x = jet->x = lam_scale(position(&sum[0][0]), w);
  jet->u = lam_scale(lam_along(position(&sum[1][0]), -wu, x), w);
  jet->v = lam_scale(lam_along(position(&sum[0][1]), -wv, x), w);
  jet->uu = lam_scale(lam_along(lam_along(position(&sum[2][0]), -2 * wu, jet->u), -wuu, x), w);
  jet->vv = lam_scale(lam_along(lam_along(position(&sum[0][2]), -2 * wv, jet->v), -wvv, x), w);
  lam_vec3 mixed = lam_along(lam_along(position(&sum[1][1]), -wu, jet->v), -wv, jet->u);
  jet->uv = lam_scale(lam_along(mixed, -wuv, x), w);
}

/* Whether the surface closes up in direction d: its two end curves agree at 2 degree + 1
 * parameters of every knot span, which is more than two different curves of these pieces can
 * share. */
static bool closes_up(const lam_nurbs *s, int d) {
  const double *along = s->shape.knots[1 - d], *across = s->shape.knots[d];
  double low = across[s->shape.degree[d]], high = across[s->shape.count[d]], size = 0, gap = 0,
         reach = 0;
  int samples = 2 * s->shape.degree[1 - d] + 1;
  for (int k = 0; k < s->shape.count[0] * s->shape.count[1]; k++)
    reach = fmax(reach, 2 * lam_distance(s->shape.points[0], s->shape.points[k]));

  for (int k = s->shape.degree[1 - d]; k < s->shape.count[1 - d]; k++)
    for (int i = 0; i < samples; i++) {
      double t = along[k] + (along[k + 1] - along[k]) * i / samples;
      lam_jet a, b, middle;
      lam_nurbs_eval(s, d ? t : low, d ? low : t, &a);
      lam_nurbs_eval(s, d ? t : high, d ? high : t, &b);
      lam_nurbs_eval(s, d ? t : (low + high) / 2, d ? (low + high) / 2 : t, &middle);

      gap = fmax(gap, lam_distance(a.x, b.x));
      size = fmax(size, lam_distance(a.x, middle.x));
      if (gap > 1e-12 * reach) return false; /* size stays below reach */
    }

  /* Small against how far the surface goes away from its end curve in between. */
  return gap <= 1e-12 * size;
}

/* Splines have no chart but their own. */
bool lam_nurbs_domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  const lam_nurbs *s = data;
  lam_domain natural = {
      {s->shape.knots[0][s->shape.degree[0]], s->shape.knots[0][s->shape.count[0]]},
      {s->shape.knots[1][s->shape.degree[1]], s->shape.knots[1][s->shape.count[1]]},
      {s->closed[0], s->closed[1]}};
  return chart == LAM_CHART_NATURAL && lam_domain_give(natural, p, q, closed);
}

const lam_spline_surface *lam_nurbs_spline(const void *nurbs) {
  return &((const lam_nurbs *)nurbs)->shape;
}

/* Homogeneous points once and for all; then whether the surface closes up. */
const lam_nurbs *lam_nurbs_make(lam_arena *arena, const lam_spline_surface *surface) {
  lam_nurbs *s = LAM_NEW(arena, lam_nurbs, 1);
  s->shape = *surface;

  int total = surface->count[0] * surface->count[1];
  double *net = LAM_NEW(arena, double, 4 * total);
  for (int i = 0; i < total; i++) {
    double w = surface->weights ? surface->weights[i] : 1;
    net[4 * i] = w * surface->points[i].x;
    net[4 * i + 1] = w * surface->points[i].y;
    net[4 * i + 2] = w * surface->points[i].z;
    net[4 * i + 3] = w;
  }

  s->net = net;
  for (int d = 0; d < 2; d++) s->closed[d] = closes_up(s, d);
  return s;
}

/* The first member of any data. */
static const lam_nurbs *held(const void *data) { return *(const lam_nurbs *const *)data; }

void lam_held_nurbs_eval(const void *data, double u, double v, lam_jet *jet) {
  lam_nurbs_eval(held(data), u, v, jet);
}

bool lam_held_nurbs_domain(const void *data, lam_chart chart, double p[2], double q[2],
                           bool closed[2]) {
  return lam_nurbs_domain(held(data), chart, p, q, closed);
}

const lam_spline_surface *lam_held_nurbs_spline(const void *data) {
  return lam_nurbs_spline(held(data));
}
