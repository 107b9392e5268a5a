/* Colors for values: evenly spaced to the eye, in print and without color too. Called by
 * formats/plot (color maps) and surf/flatten (the distortion of a print). */
#ifndef LAM_CORE_RAMP_H
#define LAM_CORE_RAMP_H

typedef struct lam_rgb {
  double r, g, b; /* linear light, 0 to 1 */
} lam_rgb;

/* The color of t in [0, 1] on a scale for values from low to high: dark violet to pale yellow,
 * lightness linear in t. */
lam_rgb lam_ramp_sequential(double t);
/* The color of t in [0, 1] on a scale for values on both sides of a middle (t = 0.5): blue over
 * white to red, lightness linear in the distance from the middle. */
lam_rgb lam_ramp_diverging(double t);

/* A channel in linear light as a number from 0 to 255, by the transfer function of sRGB (IEC
 * 61966-2-1). Below 0 and above 1 it is clamped. */
int lam_srgb(double linear);

#endif
