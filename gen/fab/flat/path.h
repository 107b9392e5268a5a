/* Lists of flat paths that grow, and plain operations on paths. Used by every flat pattern:
 * fab/flat, fab/lamella and fab/parts. Lengths in meters. */
#ifndef LAM_FAB_FLAT_PATH_H
#define LAM_FAB_FLAT_PATH_H

#include "core/arena.h"
#include "core/flat_shape.h"

static inline lam_vec2 lam_v2(double x, double y) { return (lam_vec2){x, y}; }

/* A list begins as {.arena = arena}. */
typedef struct lam_paths {
  lam_arena *arena; /* owns what is added */
  int count, capacity;
  lam_path *items;
} lam_paths;

/* Appends a path; points is copied. The returned pointer is valid until the next call. */
lam_path *lam_paths_add(lam_paths *paths, lam_layer layer, bool closed, int count,
                        const lam_vec2 *points);
/* Appends a closed cut inside an outline: a circle, and for programs without circles a regular
 * polygon of 48 corners with the area of the circle. */
void lam_paths_hole(lam_paths *paths, lam_vec2 center, double diameter);
/* Gives a circle (radius > 0) another radius, above 0. points: room for its count of points, which
 * the circle keeps. */
void lam_path_resize(lam_path *circle, lam_vec2 *points, double radius);

/* A rotation by the angle with cosine and sine, then a move. */
typedef struct lam_motion {
  double cosine, sine;
  lam_vec2 move;
} lam_motion;
lam_vec2 lam_motion_apply(const lam_motion *motion, lam_vec2 point);
/* Copies of paths[0..count-1] with their points, moved; owned by arena. */
lam_path *lam_paths_placed(lam_arena *arena, const lam_path *paths, int count,
                           const lam_motion *motion);

/* Bounds of the points of all paths; both zero when there is none. */
void lam_paths_bounds(const lam_path *paths, int count, lam_vec2 *min, lam_vec2 *max);
/* How many pairs of sides of a closed path cross: 0 when it bounds one piece that does not lie on
 * itself. Touching is no crossing. */
long lam_path_crossings(const lam_path *path);
/* The area of the outlines less that of the holes. */
double lam_paths_area(const lam_path *paths, int count);

/* Makes the paths those of a flat pattern, with their bounds. They are not copied. */
void lam_flat_set_paths(lam_flat *flat, const lam_paths *paths);

#endif
