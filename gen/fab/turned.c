/* Solids around the z axis as bands of quads between lines around it. Called by the rows circles
 * and gauss-image (fab/parts) and node-connector (fab/lamella). */
#include "fab/turned.h"
#include "core/numbers.h"
#include "fab/mesh_fill.h"

#include <math.h>

enum { bands = 16 }; /* of a ball, from pole to pole */

/* Vertices: line by line, n each, then the two poles. */
lam_trimesh lam_turned_solid(lam_arena *arena, const double *angle, int n,
                             const lam_turned_line *lines, int count, const double *poles) {
  int caps = poles ? 2 : 0, band_count = poles ? count - 1 : count;
  lam_trimesh mesh = lam_trimesh_empty(arena, n * count + caps, 2 * n * band_count + caps * n);
  for (int r = 0; r < count; r++)
    for (int k = 0; k < n; k++)
      mesh.vertices[r * n + k] = lam_v3(lines[r].radius[k] * cos(angle[k]),
                                        lines[r].radius[k] * sin(angle[k]), lines[r].z);

  for (int r = 0; r < band_count; r++)
    for (int k = 0; k < n; k++) {
      int next = (k + 1) % n, up = (r + 1) % count;
      lam_trimesh_quad(&mesh, r * n + k, r * n + next, up * n + next, up * n + k);
    }
  if (!poles) return mesh;

  int low = n * count, high = low + 1, top = (count - 1) * n;
  mesh.vertices[low] = lam_v3(0, 0, poles[0]);
  mesh.vertices[high] = lam_v3(0, 0, poles[1]);
  for (int k = 0; k < n; k++) {
    int next = (k + 1) % n;
    lam_trimesh_triangle(&mesh, low, next, k);
    lam_trimesh_triangle(&mesh, high, top + k, top + next);
  }
  return mesh;
}

/* The directions of the corners of a circle. */
static void circle_angles(double angle[lam_turned_corners]) {
  for (int k = 0; k < lam_turned_corners; k++) angle[k] = 2 * LAM_PI * k / lam_turned_corners;
}

/* The radii of a circle. */
static void set_radius(double radius[lam_turned_corners], double value) {
  for (int k = 0; k < lam_turned_corners; k++) radius[k] = value;
}

/* The section is a rectangle. */
lam_trimesh lam_ring(lam_arena *arena, double inner, double outer, double thickness) {
  double angle[lam_turned_corners], near[lam_turned_corners], far[lam_turned_corners];
  const double half = thickness / 2;
  circle_angles(angle);
  set_radius(near, inner);
  set_radius(far, outer);
  const lam_turned_line lines[4] = {{-half, near}, {-half, far}, {half, far}, {half, near}};
  return lam_turned_solid(arena, angle, lam_turned_corners, lines, 4, NULL);
}

/* The section is half a regular polygon, from the lower pole to the upper one. */
lam_trimesh lam_ball(lam_arena *arena, double radius) {
  double angle[lam_turned_corners], around[bands - 1][lam_turned_corners];
  lam_turned_line lines[bands - 1];
  circle_angles(angle);
  for (int i = 1; i < bands; i++) {
    set_radius(around[i - 1], radius * sin(LAM_PI * i / bands));
    lines[i - 1] = (lam_turned_line){-radius * cos(LAM_PI * i / bands), around[i - 1]};
  }
  const double poles[2] = {-radius, radius};
  return lam_turned_solid(arena, angle, lam_turned_corners, lines, bands - 1, poles);
}
