/* Colors for values: evenly spaced to the eye, in print and without color too. */
#ifndef LAM_CORE_RAMP_H
#define LAM_CORE_RAMP_H

typedef struct lam_rgb {
  double r, g, b; /* linear light, 0 to 1 */
} lam_rgb;

/* The t-th color of a scale, t in [0, 1]: dark violet to pale yellow, lightness linear in t; or
 * blue over white to red.
 */
lam_rgb lam_ramp_sequential(double t);
lam_rgb lam_ramp_diverging(double t);
/* 0 to 255, by the transfer function of sRGB. */
int lam_srgb(double linear);

#endif
