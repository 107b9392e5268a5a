/* Skins over a grid of vertices with given tangents, curvatures and torsions. Called by
 * skin_fit.c for its edges and by the tests; the program fills nets of any connectivity from
 * conormals (skin_patches.c).
 *
 * Edges of a skin: at an end let T be the unit tangent, nu the unit vector in the tangent plane
 * perpendicular to it, on the side of the other tangent, and n = T x nu. Curvature and torsion
 * at the end are
 *
 *   r''.n = 0,  r''.nu = k |r'|^2,  r'''.n = tau k |r'|^3,
 *   tau = det(r', r'', r''') / |r' x r''|^2
 *
 * With r' = 7 E, r'' = 42 (P2 - 2 P1 + P0), r''' = 210 (P3 - 3 P2 + 3 P1 - P0) and P0, P1, P2 in
 * the tangent plane, these fix P2 but for its part along T, and P3 but for its part in the
 * plane: six unknowns for both ends, from the least integral of |r'''|^2. Nothing divides by k. */
#include "surf/asymptotic/asymptotic_skin.h"
#include "core/numeric/dense.h"
#include "surf/asymptotic/quad_parts.h"

enum { DEGREE = LAM_SKIN_DEGREE, POINTS = LAM_SKIN_POINTS, UNKNOWNS = 6 };

/* Sets the four points of the edge at one end, the unknowns being 0, and lists the three
 * unknowns there: which point moves along which vector. End 1 is seen backwards: points 7, 6, 5,
 * 4, with the signs of odd derivatives turned. */
static void set_end(const lam_skin_vertex *vertex, int family, int end, lam_vec3 *points,
                    int *moved, lam_vec3 *along) {
  lam_vec3 tangent = vertex->tangent[family], other = vertex->tangent[1 - family],
           t = lam_unit(tangent);
  lam_vec3 nu = lam_unit(lam_along(other, -lam_dot(other, t), t)), n = lam_cross(t, nu);
  double speed = lam_length(tangent), k = vertex->curvature[family], sign = end ? -1 : 1;
  double torsion = family ? -vertex->torsion : vertex->torsion;
  int step = end ? -1 : 1, at = end ? DEGREE : 0;

  points[at] = vertex->point;
  points[at + step] = lam_along(vertex->point, sign / DEGREE, tangent);
  points[at + 2 * step] = lam_along(points[at], k * speed * speed / 42, nu);
  points[at + 3 * step] =
      lam_along(points[at], sign * torsion * k * speed * speed * speed / 210, n);

  const lam_vec3 axis[3] = {t, t, nu};
  for (int j = 0; j < 3; j++) {
    moved[j] = at + (j ? 3 : 2) * step;
    along[j] = lam_scale(axis[j], speed);
  }
}

/* The six unknowns of both ends from a quadratic energy with the matrix h and the gradient g. */
void lam_skin_edge(lam_arena *arena, const double *gram, const lam_skin_vertex *from,
                   const lam_skin_vertex *to, int family, lam_vec3 points[LAM_SKIN_POINTS]) {
  lam_vec3 along[UNKNOWNS];
  int moved[UNKNOWNS];
  double h[UNKNOWNS * UNKNOWNS], g[UNKNOWNS] = {0}, x[UNKNOWNS];
  set_end(from, family, 0, points, moved, along);
  set_end(to, family, 1, points, moved + 3, along + 3);

  for (int a = 0; a < UNKNOWNS; a++) {
    for (int j = 0; j < POINTS; j++)
      g[a] += gram[moved[a] * POINTS + j] * lam_dot(along[a], points[j]);
    for (int b = 0; b < UNKNOWNS; b++)
      h[a * UNKNOWNS + b] = gram[moved[a] * POINTS + moved[b]] * lam_dot(along[a], along[b]);
  }

  lam_least_energy(arena, UNKNOWNS, h, g, 0, NULL, NULL, 0, x);
  for (int a = 0; a < UNKNOWNS; a++) points[moved[a]] = lam_along(points[moved[a]], x[a], along[a]);
}

/* Whether the two tangents of every vertex span a plane; otherwise false with an error. */
static bool check_tangents(const int count[2], const lam_skin_vertex *vertices,
                           lam_location location, lam_errors *errors) {
  for (int k = 0; k < count[0] * count[1]; k++) {
    const lam_vec3 *t = vertices[k].tangent;
    if (!(lam_length(lam_cross(t[0], t[1])) > 1e-6 * lam_length(t[0]) * lam_length(t[1]))) {
      lam_error_add(errors, location, "tangents",
                    "the tangents at vertex %d, %d are parallel; expected two directions",
                    k / count[1], k % count[1]);
      return false;
    }
  }
  return true;
}

/* All edges first, each once, and then the patches between them, with tangents across of least
 * energy. */
bool lam_asymptotic_skin_make(lam_arena *arena, const int count[2], const lam_skin_vertex *vertices,
                              lam_location location, lam_errors *errors,
                              lam_asymptotic_patch *patches) {
  static const lam_quad_recipe recipe = {.degree = DEGREE, .surface = DEGREE + 2, .free = true};
  int total = count[0] * count[1], order;
  const double *knots = lam_knots_repeat(arena, DEGREE, 0, NULL, 1, &order);
  const double *gram = lam_spline_gram(arena, DEGREE, POINTS, knots, 3);
  lam_vec3 **edges[2] = {LAM_NEW(arena, lam_vec3 *, total), LAM_NEW(arena, lam_vec3 *, total)};
  if (!check_tangents(count, vertices, location, errors)) return false;

  for (int k = 0; k < total; k++)
    for (int d = 0; d < 2; d++) {
      int next = d ? k + 1 : k + count[1];
      if (d ? k % count[1] + 1 == count[1] : k / count[1] + 1 == count[0]) continue;
      edges[d][k] = LAM_NEW(arena, lam_vec3, POINTS);
      lam_skin_edge(arena, gram, &vertices[k], &vertices[next], d, edges[d][k]);
    }

  for (int i = 0; i + 1 < count[0]; i++)
    for (int j = 0; j + 1 < count[1]; j++) {
      lam_asymptotic_patch *patch = &patches[i * (count[1] - 1) + j];
      int k = i * count[1] + j;
      lam_vec3 *points[4] = {edges[0][k], edges[1][k], edges[0][k + 1], edges[1][k + count[1]]};
      patch->boundary = (lam_quad_boundary){.energy = 0};
      for (int c = 0; c < 4; c++)
        patch->boundary.curve[c] = (lam_quad_curve){DEGREE, POINTS, knots, points[c], NULL, false};
      lam_quad_boundary_measure(&patch->boundary);
      if (!lam_quad_patch_free(arena, &patch->boundary, &recipe, location, errors, patch))
        return false;
    }
  return true;
}
