/* Laying flat by conjugate gradients, as Li & Deng do it. No stage of a design calls it: the
 * unit tests compare lam_flatten with it.
 *
 * Polak and Ribiere's method, restarted where the direction would not lead down, on
 * E = sum (l - L)^2 with the gradient 2 (l - L) e on the ends of every edge. Along a direction E is
 * minimized by Newton's method in one variable,
 *   E' = 2 sum (l - L) l',  E'' = 2 sum l'^2 + (l - L) l'',  l'' = (|d|^2 - l'^2)/l,
 * with l'' left out where it would make E'' negative. */
#include "surf/flatten/flatten_parts.h"
#include <string.h>

/* E at x, and its gradient; NULL: not wanted. An edge of no length has no direction and no
 * gradient. */
static double energy(const lam_flat_mesh *mesh, const lam_vec2 *x, lam_vec2 *gradient) {
  double sum = 0;
  if (gradient) memset(gradient, 0, (size_t)mesh->vertex_count * sizeof *gradient);
  for (int e = 0; e < mesh->edge_count; e++) {
    int a = mesh->edges[e][0], b = mesh->edges[e][1];
    double dx = x[b].x - x[a].x, dy = x[b].y - x[a].y, l = hypot(dx, dy),
           error = l - mesh->lengths[e];

    sum += error * error;
    if (!gradient || l == 0) continue;

    double f = 2 * error / l;
    gradient[b].x += f * dx;
    gradient[b].y += f * dy;
    gradient[a].x -= f * dx;
    gradient[a].y -= f * dy;
  }
  return sum;
}

/* E' and E'' along the direction. */
static void slopes(const lam_flat_mesh *mesh, const lam_vec2 *x, const lam_vec2 *direction,
                   double *first, double *second) {
  *first = *second = 0;
  for (int e = 0; e < mesh->edge_count; e++) {
    int a = mesh->edges[e][0], b = mesh->edges[e][1];
    double dx = x[b].x - x[a].x, dy = x[b].y - x[a].y, wx = direction[b].x - direction[a].x,
           wy = direction[b].y - direction[a].y;
    double l = hypot(dx, dy), d = l > 0 ? (dx * wx + dy * wy) / l : 0, error = l - mesh->lengths[e];
    *first += 2 * error * d;
    *second += 2 * (d * d + fmax(0, error) * (l > 0 ? (wx * wx + wy * wy - d * d) / l : 0));
  }
}

/* The scalar product of n points of the plane. */
static double dot(int n, const lam_vec2 *a, const lam_vec2 *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i].x * b[i].x + a[i].y * b[i].y;
  return sum;
}

/* The state of the minimization; arrays of vertex_count points of the plane. */
typedef struct state {
  const lam_flat_mesh *mesh;
  lam_vec2 *x, *trial;
  lam_vec2 *gradient, *last; /* at x, and at the point before it */
  lam_vec2 *direction;
  double energy, beta; /* at x; how much of the last direction the next one keeps */
} state;

/* The next direction: beta times the last one minus the gradient, or minus the gradient alone
 * where that would not lead down. */
static void turn(state *s) {
  int n = s->mesh->vertex_count;
  lam_vec2 *d = s->direction;
  const lam_vec2 *g = s->gradient;
  for (int i = 0; i < n; i++)
    d[i] = (lam_vec2){s->beta * d[i].x - g[i].x, s->beta * d[i].y - g[i].y};
  if (dot(n, g, d) < 0) return;

  for (int i = 0; i < n; i++) d[i] = (lam_vec2){-g[i].x, -g[i].y};
}

/* Newton's step along the direction, halved until the energy does not rise. Leaves the points
 * in trial and returns their energy, which is larger than that of x only when 40 halvings
 * fail. */
static double search(state *s) {
  const lam_vec2 *x = s->x, *d = s->direction;
  double first, second, next = INFINITY;
  slopes(s->mesh, x, d, &first, &second);
  double share = second > 0 ? -first / second : 0;

  for (int k = 0; k < 40; k++, share /= 2) {
    for (int i = 0; i < s->mesh->vertex_count; i++)
      s->trial[i] = (lam_vec2){x[i].x + share * d[i].x, x[i].y + share * d[i].y};
    if ((next = energy(s->mesh, s->trial, NULL)) <= s->energy) break;
  }
  return next;
}

/* Takes the trial points, and finds gradient and beta there (Polak and Ribiere, never
 * negative). */
static void accept(state *s) {
  int n = s->mesh->vertex_count;
  memcpy(s->x, s->trial, (size_t)n * sizeof *s->x);
  memcpy(s->last, s->gradient, (size_t)n * sizeof *s->last);
  s->energy = energy(s->mesh, s->x, s->gradient);

  double before = dot(n, s->last, s->last);
  s->beta =
      before > 0
          ? fmax(0, (dot(n, s->gradient, s->gradient) - dot(n, s->gradient, s->last)) / before)
          : 0;
  if (s->beta == 0) memset(s->direction, 0, (size_t)n * sizeof *s->direction);
}

/* Converged after ten steps in a row without progress beyond rounding. */
lam_flattening lam_flatten_conjugate(lam_arena *arena, const lam_flat_mesh *mesh,
                                     int max_iterations) {
  int n = mesh->vertex_count;
  state s = {.mesh = mesh,
             .x = LAM_NEW(arena, lam_vec2, n),
             .trial = LAM_NEW(arena, lam_vec2, n),
             .gradient = LAM_NEW(arena, lam_vec2, n),
             .last = LAM_NEW(arena, lam_vec2, n),
             .direction = LAM_NEW(arena, lam_vec2, n)};
  memcpy(s.x, mesh->start, (size_t)n * sizeof *s.x);
  s.energy = energy(mesh, s.x, s.gradient);

  lam_flattening result = {.points = s.x};
  for (int idle = 0; result.iterations < max_iterations && !result.converged; result.iterations++) {
    turn(&s);
    double next = search(&s);
    if (!(next <= s.energy)) break;
    idle = s.energy - next <= 1e-11 * s.energy ? idle + 1 : 0;
    result.converged = idle >= 10;
    accept(&s);
  }

  lam_flat_measure(mesh, &result);
  return result;
}
