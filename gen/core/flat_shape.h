/* Center and area of paths in the plane. Called by fab, and by formats/sheets. */
#ifndef LAM_CORE_FLAT_SHAPE_H
#define LAM_CORE_FLAT_SHAPE_H

#include "core/model.h"

/* The mean of the points; path->count > 0. */
static inline lam_vec2 lam_path_center(const lam_path *path) {
  lam_vec2 sum = {0, 0};
  for (int i = 0; i < path->count; i++) {
    sum.x += path->points[i].x;
    sum.y += path->points[i].y;
  }
  return (lam_vec2){sum.x / path->count, sum.y / path->count};
}

/* The area enclosed, positive when counterclockwise: half the sum of a x b over the sides a -> b,
 * the last one back to the first point. */
static inline double lam_path_area(const lam_path *path) {
  double twice = 0;
  for (int i = 0, j = path->count - 1; i < path->count; j = i++) {
    lam_vec2 a = path->points[j], b = path->points[i];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

#endif
