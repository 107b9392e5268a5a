/* Three-dimensional vectors, by value: what all computations with positions and directions are
 * written in. Used in every folder. Components are in meters unless a caller says otherwise. */
#ifndef LAM_CORE_VEC3_H
#define LAM_CORE_VEC3_H

#include <lamella/types.h>
#include <math.h>

/* The vector (x, y, z). */
static inline lam_vec3 lam_v3(double x, double y, double z) { return (lam_vec3){x, y, z}; }

/* a + b */
static inline lam_vec3 lam_add(lam_vec3 a, lam_vec3 b) {
  return lam_v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

/* a - b */
static inline lam_vec3 lam_sub(lam_vec3 a, lam_vec3 b) {
  return lam_v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

/* s a */
static inline lam_vec3 lam_scale(lam_vec3 a, double s) { return lam_v3(a.x * s, a.y * s, a.z * s); }

/* a + s b */
static inline lam_vec3 lam_along(lam_vec3 a, double s, lam_vec3 b) {
  return lam_add(a, lam_scale(b, s));
}

/* The scalar product a . b */
static inline double lam_dot(lam_vec3 a, lam_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/* The vector product a x b */
static inline lam_vec3 lam_cross(lam_vec3 a, lam_vec3 b) {
  return lam_v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* |a| */
static inline double lam_length(lam_vec3 a) { return sqrt(lam_dot(a, a)); }

/* |a - b| */
static inline double lam_distance(lam_vec3 a, lam_vec3 b) { return lam_length(lam_sub(a, b)); }

/* The unit vector along a; the zero vector stays zero. */
static inline lam_vec3 lam_unit(lam_vec3 a) {
  double length = lam_length(a);
  return length > 0 ? lam_scale(a, 1 / length) : a;
}

/* The point a + t (b - a) on the line through a (t = 0) and b (t = 1). */
static inline lam_vec3 lam_mix(lam_vec3 a, lam_vec3 b, double t) {
  return lam_along(a, t, lam_sub(b, a));
}

/* The angle between a and b in [0, pi], accurate near 0 and pi too. */
static inline double lam_angle(lam_vec3 a, lam_vec3 b) {
  return atan2(lam_length(lam_cross(a, b)), lam_dot(a, b));
}

#endif
