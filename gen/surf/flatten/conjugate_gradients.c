/* Conjugate gradients (Polak and Ribiere, restarted where the direction would not lead down) on E =
 * sum (l - L)^2 with gradient 2 (l - L) e on the ends of every edge. Along a direction E is
 * minimized by Newton's method in one variable, E' = 2 sum (l - L) l',  E'' = 2 sum l'^2 + (l - L)
 * l'',  l'' = (|d|^2 - l'^2)/l, with l'' left out where it would make E'' negative. */
#include "surf/flatten/flatten_parts.h"
#include <string.h>

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

static void slopes(const lam_flat_mesh *mesh, const lam_vec2 *x, const lam_vec2 *way, double *first,
                   double *second) {
  *first = *second = 0;
  for (int e = 0; e < mesh->edge_count; e++) {
    int a = mesh->edges[e][0], b = mesh->edges[e][1];
    double dx = x[b].x - x[a].x, dy = x[b].y - x[a].y, wx = way[b].x - way[a].x,
           wy = way[b].y - way[a].y;
    double l = hypot(dx, dy), d = l > 0 ? (dx * wx + dy * wy) / l : 0, error = l - mesh->lengths[e];
    *first += 2 * error * d;
    *second += 2 * (d * d + fmax(0, error) * (l > 0 ? (wx * wx + wy * wy - d * d) / l : 0));
  }
}

static double dot(int n, const lam_vec2 *a, const lam_vec2 *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i].x * b[i].x + a[i].y * b[i].y;
  return sum;
}

lam_flattening lam_flatten_conjugate(lam_arena *arena, const lam_flat_mesh *mesh,
                                     int max_iterations) {
  int n = mesh->vertex_count;
  lam_vec2 *x = LAM_NEW(arena, lam_vec2, n), *trial = LAM_NEW(arena, lam_vec2, n),
           *g = LAM_NEW(arena, lam_vec2, n), *last = LAM_NEW(arena, lam_vec2, n),
           *way = LAM_NEW(arena, lam_vec2, n);
  memcpy(x, mesh->start, (size_t)n * sizeof *x);
  lam_flattening result = {.points = x};
  double E = energy(mesh, x, g), beta = 0;
  for (int idle = 0; result.iterations < max_iterations && !result.converged; result.iterations++) {
    for (int i = 0; i < n; i++)
      way[i] = (lam_vec2){beta * way[i].x - g[i].x, beta * way[i].y - g[i].y};
    double down = dot(n, g, way), first, second, share;
    if (!(down < 0)) {
      for (int i = 0; i < n; i++) way[i] = (lam_vec2){-g[i].x, -g[i].y};
      down = -dot(n, g, g);
    }
    slopes(mesh, x, way, &first, &second);
    share = second > 0 ? -first / second : 0;
    double next = INFINITY;
    for (int k = 0; k < 40; k++, share /= 2) {
      for (int i = 0; i < n; i++)
        trial[i] = (lam_vec2){x[i].x + share * way[i].x, x[i].y + share * way[i].y};
      if ((next = energy(mesh, trial, NULL)) <= E) break;
    }
    if (!(next <= E)) break;
    idle = E - next <= 1e-11 * E ? idle + 1 : 0;
    result.converged = idle >= 10;
    memcpy(x, trial, (size_t)n * sizeof *x);
    memcpy(last, g, (size_t)n * sizeof *last);
    E = energy(mesh, x, g);
    double before = dot(n, last, last);
    beta = before > 0 ? fmax(0, (dot(n, g, g) - dot(n, g, last)) / before) : 0;
    if (beta == 0) memset(way, 0, (size_t)n * sizeof *way);
  }
  lam_flat_measure(mesh, &result);
  return result;
}
