/* The point of a spline surface nearest to a given point: Bezier patches are halved as long as
 * their boxes are near enough, then Newton's method. Called by spline_near.c and
 * surf/area/nearest.c, which have a start; the search without one is part of the surface
 * kernel, called by the unit tests. */
#include "surf/spline/closest_on_surface.h"
#include "surf/spline/spline_edit.h"

/* Halvings of a patch at most, in turn along u and v; halvings from which on Newton's method is
 * tried; its steps. */
enum { DEEPEST = 10, FIRST = 4, STEPS = 40 };

/* A search for the point nearest to target; best: so far. */
typedef struct lam_search {
  lam_arena *arena;
  const lam_spline_surface *surface; /* the Bezier patch that is searched */
  lam_vec3 target;
  lam_closest_on_surface best;
} lam_search;

/* A part of the patch that is searched: homogeneous points, and its part of the domain. */
typedef struct lam_cell {
  double *net; /* (degree[0] + 1) x (degree[1] + 1) x 4 */
  double low[2], high[2];
} lam_cell;

/* The point at (u,v) and its distance. */
static lam_closest_on_surface at(const lam_spline_surface *s, lam_vec3 target, double u, double v) {
  lam_vec3 x;
  lam_spline_surface_derivatives(s, u, v, 0, &x);
  return (lam_closest_on_surface){u, v, lam_distance(x, target), x};
}

/* A rectangle of parameters. */
typedef struct lam_box {
  double low[2], high[2];
} lam_box;

/* The whole domain of a surface. */
static lam_box domain_of(const lam_spline_surface *s) {
  lam_box box;
  for (int d = 0; d < 2; d++) {
    box.low[d] = s->knots[d][s->degree[d]];
    box.high[d] = s->knots[d][s->count[d]];
  }
  return box;
}

/* Newton's step. With d = x - target, the gradient of |d|^2 / 2 is (d.x_u, d.x_v) and its
 * matrix x_i.x_j + d.x_ij. Where that is not positive definite, x_i.x_j alone. A parameter on
 * the edge of the domain whose gradient points outward is held. At a singular point the step is
 * a thousandth of the domain. */
static void newton(const lam_spline_surface *s, const lam_box *box, lam_vec3 target,
                   const double t[2], double move[2]) {
  lam_jet jet = lam_spline_surface_jet(s, t[0], t[1]);
  lam_vec3 d = lam_sub(jet.x, target);
  double g[2] = {lam_dot(d, jet.u), lam_dot(d, jet.v)};
  double first[3] = {lam_dot(jet.u, jet.u), lam_dot(jet.u, jet.v), lam_dot(jet.v, jet.v)};
  double h[3] = {first[0] + lam_dot(d, jet.uu), first[1] + lam_dot(d, jet.uv),
                 first[2] + lam_dot(d, jet.vv)};

  if (!(h[0] > 0 && h[0] * h[2] - h[1] * h[1] > 1e-12 * first[0] * first[2]))

    for (int i = 0; i < 3; i++) h[i] = first[i];
  for (int i = 0; i < 2; i++)
    if ((t[i] <= box->low[i] && g[i] > 0) || (t[i] >= box->high[i] && g[i] < 0)) g[i] = h[1] = 0;

  double det = h[0] * h[2] - h[1] * h[1];
  move[0] = -(h[2] * g[0] - h[1] * g[1]) / det;
  move[1] = -(h[0] * g[1] - h[1] * g[0]) / det;

  for (int i = 0; i < 2 && !(det > 0); i++)
    move[i] = 1e-3 * (box->high[i] - box->low[i]) * (g[i] > 0 ? -1 : g[i] < 0 ? 1 : 0);
}

/* Goes along `move` from t, by half the way again and again until the distance falls; false: it
 * never does. Where rounding hides that it falls, a full step is taken all the same, `hidden` more
 * times: the parameters are then as exact as the distance. */
static bool go(const lam_spline_surface *s, const lam_box *box, lam_vec3 target,
               const double move[2], double t[2], lam_closest_on_surface *best, int *hidden) {
  for (double share = 1; share > 1e-4; share /= 2) {
    double p[2];
    for (int d = 0; d < 2; d++)
      p[d] = fmin(box->high[d], fmax(box->low[d], t[d] + share * move[d]));
    lam_closest_on_surface trial = at(s, target, p[0], p[1]);

    bool better = trial.distance < best->distance;
    if (!better && share == 1 && *hidden > 0 && trial.distance <= best->distance * (1 + 1e-15)) {
      better = true;
      (*hidden)--;
    }
    if (!better) continue;

    *best = trial;
    t[0] = p[0];
    t[1] = p[1];
    return true;
  }
  return false;
}

/* Newton's method from the point of the domain that is nearest to `from`. */
lam_closest_on_surface lam_spline_surface_closest_from(const lam_spline_surface *s, lam_vec3 target,
                                                       lam_vec2 from) {
  lam_box box = domain_of(s);
  double t[2] = {from.x, from.y};
  for (int d = 0; d < 2; d++) t[d] = fmin(box.high[d], fmax(box.low[d], t[d]));
  lam_closest_on_surface best = at(s, target, t[0], t[1]);

  int hidden = 2;
  for (int step = 0; step < STEPS; step++) {
    double move[2];
    newton(s, &box, target, t, move);
    if (!go(s, &box, target, move, t, &best, &hidden)) break;
  }
  return best;
}

/* Keeps a point that is nearer than the best one. */
static void offer(lam_search *s, lam_closest_on_surface found) {
  if (found.distance < s->best.distance) s->best = found;
}

/* The distance to the box of the points of a cell: no point of the cell is nearer, as its
 * weights are positive. */
static double box_distance(const lam_search *s, const lam_cell *cell) {
  int total = (s->surface->degree[0] + 1) * (s->surface->degree[1] + 1);
  double p[3] = {s->target.x, s->target.y, s->target.z}, sum = 0;
  for (int c = 0; c < 3; c++) {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < total; i++) {
      low = fmin(low, cell->net[4 * i + c] / cell->net[4 * i + 3]);
      high = fmax(high, cell->net[4 * i + c] / cell->net[4 * i + 3]);
    }

    double out = fmax(0, fmax(low - p[c], p[c] - high));
    sum += out * out;
  }
  return sqrt(sum);
}

/* De Casteljau's algorithm at the middle of direction d, for every row across. */
static void halve(lam_search *s, const lam_cell *cell, int d, lam_cell half[2]) {
  int m = s->surface->degree[0] + 1, n = s->surface->degree[1] + 1, size = 4 * m * n;
  int along = d ? n : m, across = d ? m : n, step = d ? 4 : 4 * n, jump = d ? 4 * n : 4;
  for (int k = 0; k < 2; k++) {
    half[k] = *cell;
    half[k].net = LAM_NEW(s->arena, double, size);
  }

  double middle = cell->low[d] + (cell->high[d] - cell->low[d]) / 2;
  half[0].high[d] = half[1].low[d] = middle;

  for (int i = 0; i < size; i++) half[1].net[i] = cell->net[i];

  /* The right half is reduced in place; what falls off at its low end is the left half. */
  for (int row = 0; row < across; row++)
    for (int c = 0; c < 4; c++) {
      double *left = half[0].net + row * jump + c, *right = half[1].net + row * jump + c;
      for (int r = 0; r < along; r++) {
        left[r * step] = right[0];
        for (int i = 0; i + 1 < along - r; i++)
          right[i * step] = (right[i * step] + right[(i + 1) * step]) / 2;
      }
    }
}

/* Branch and bound: a cell whose box is farther than the best point is left out. The nearer
 * half goes first, so that the bound falls early. */
static void search(lam_search *s, const lam_cell *cell, int depth) {
  if (box_distance(s, cell) >= s->best.distance) return;

  if (depth >= FIRST) {
    lam_vec2 middle = {(cell->low[0] + cell->high[0]) / 2, (cell->low[1] + cell->high[1]) / 2};
    offer(s, lam_spline_surface_closest_from(s->surface, s->target, middle));
  }

  if (depth == DEEPEST) return;
  lam_arena_mark mark = lam_arena_mark_get(s->arena);
  lam_cell half[2];
  halve(s, cell, depth % 2, half);

  int nearer = box_distance(s, &half[1]) < box_distance(s, &half[0]);
  search(s, &half[nearer], depth + 1);
  search(s, &half[!nearer], depth + 1);
  lam_arena_release(s->arena, mark);
}

/* A whole Bezier patch as a cell. */
static lam_cell whole_cell(lam_arena *arena, const lam_spline_surface *p) {
  lam_cell cell = {LAM_NEW(arena, double, 4 * p->count[0] * p->count[1]), {0}, {0}};
  for (int d = 0; d < 2; d++) {
    cell.low[d] = p->knots[d][0];
    cell.high[d] = p->knots[d][p->count[d]];
  }

  for (int i = 0; i < p->count[0] * p->count[1]; i++) {
    double w = p->weights ? p->weights[i] : 1;
    const double x[] = {w * p->points[i].x, w * p->points[i].y, w * p->points[i].z, w};
    for (int c = 0; c < 4; c++) cell.net[4 * i + c] = x[c];
  }
  return cell;
}

/* Branch and bound over the Bezier patches. */
lam_closest_on_surface lam_spline_surface_closest(lam_arena *arena,
                                                  const lam_spline_surface *surface,
                                                  lam_vec3 point) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_search s = {arena, surface, point, {.distance = INFINITY}};
  int count[2];
  const lam_spline_surface *patches = lam_spline_surface_patches(arena, surface, count);

  /* The corners of all patches first: they lie on the surface and bound the distance early. */
  for (int k = 0; k < count[0] * count[1]; k++) {
    const lam_spline_surface *p = &patches[k];
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++)
        offer(&s, at(surface, point, p->knots[0][i ? p->count[0] : 0],
                     p->knots[1][j ? p->count[1] : 0]));
  }

  for (int k = 0; k < count[0] * count[1]; k++) {
    s.surface = &patches[k];
    lam_cell cell = whole_cell(arena, &patches[k]);
    search(&s, &cell, 0);
  }
  lam_arena_release(arena, mark);
  return s.best;
}
