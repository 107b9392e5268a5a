/* A local origin for what lies far away, such as survey coordinates: files of 32-bit numbers (STL,
 * glTF) and tolerances near rounding need small coordinates. Called by design/local_origin.c. */
#ifndef LAM_CORE_ORIGIN_H
#define LAM_CORE_ORIGIN_H

#include "core/vec3.h"

/* Where the local origin of points is put, meters: (0, 0, 0) unless they lie further away than 100
 * times their own extent, or than 1 km and their own extent. It is round: a multiple of a power of
 * ten that is no smaller than their extent. */
lam_vec3 lam_local_origin(const lam_vec3 *points, int count);

/* Whether it is anywhere but in (0, 0, 0). */
static inline bool lam_is_moved(lam_vec3 origin) {
  return origin.x != 0 || origin.y != 0 || origin.z != 0;
}

#endif
