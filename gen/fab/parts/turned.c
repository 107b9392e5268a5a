#include "fab/parts/turned.h"
#include "core/numbers.h"

#include "fab/flat/path.h"

#include <string.h>

enum { bands = 16 }; /* of a ball, from pole to pole */

/* Turns a section (radius, height), counterclockwise with the radius to the right and the height
 * up, about the z axis. closed: the last point is joined to the first; otherwise both lie on the
 * axis. Points of the surface are corners of the solid, which therefore lies inside. */
static lam_trimesh turned(lam_arena *arena, const lam_vec2 *section, int count, bool closed) {
  int inner = closed ? count : count - 2, poles = closed ? 0 : 2, first = closed ? 0 : 1;
  lam_trimesh mesh = {inner * lam_turned_corners + poles,
                      LAM_NEW(arena, lam_vec3, inner * lam_turned_corners + poles), 0, NULL};
  mesh.triangles = (int(*)[3])lam_arena_alloc(arena, (size_t)(2 * lam_turned_corners * count),
                                              sizeof *mesh.triangles);
  for (int r = 0; r < inner; r++)
    for (int k = 0; k < lam_turned_corners; k++) {
      double angle = 2 * LAM_PI * k / lam_turned_corners;
      lam_vec2 p = section[first + r];
      mesh.vertices[r * lam_turned_corners + k] = lam_v3(p.x * cos(angle), p.x * sin(angle), p.y);
    }
  for (int r = 0; r < (closed ? inner : inner - 1); r++)
    for (int k = 0; k < lam_turned_corners; k++) {
      int next = (k + 1) % lam_turned_corners, up = (r + 1) % inner * lam_turned_corners,
          at = r * lam_turned_corners;
      memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){at + k, at + next, up + next},
             sizeof(int[3]));
      memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){at + k, up + next, up + k},
             sizeof(int[3]));
    }
  if (closed) return mesh;
  int low = inner * lam_turned_corners, high = low + 1, top = (inner - 1) * lam_turned_corners;
  mesh.vertices[low] = lam_v3(0, 0, section[0].y);
  mesh.vertices[high] = lam_v3(0, 0, section[count - 1].y);
  for (int k = 0; k < lam_turned_corners; k++) {
    int next = (k + 1) % lam_turned_corners;
    memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){low, next, k}, sizeof(int[3]));
    memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){high, top + k, top + next},
           sizeof(int[3]));
  }
  return mesh;
}

lam_trimesh lam_ring(lam_arena *arena, double inner, double outer, double thickness) {
  const double half = thickness / 2;
  const lam_vec2 section[4] = {{inner, -half}, {outer, -half}, {outer, half}, {inner, half}};
  return turned(arena, section, 4, true);
}

lam_trimesh lam_ball(lam_arena *arena, double radius) {
  lam_vec2 section[bands + 1];
  for (int i = 0; i <= bands; i++)
    section[i] = lam_v2(radius * sin(LAM_PI * i / bands), -radius * cos(LAM_PI * i / bands));
  return turned(arena, section, bands + 1, false);
}
