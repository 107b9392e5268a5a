/* Color scales, computed in a color space where equal steps look equal. Called by formats/plot and
 * surf/flatten. */
#include "core/ramp.h"
#include "core/numbers.h"

#include <math.h>
#include <stdbool.h>

/* From Oklab, where distances are perceived differences, to linear sRGB: lightness in [0, 1], and
 * chroma at a hue angle (radians). Two linear maps with a cube between them. Ottosson, A perceptual
 * color space for image processing (2020). The result may lie outside of [0, 1]. */
static lam_rgb from_oklab(double lightness, double chroma, double hue) {
  double a = chroma * cos(hue), b = chroma * sin(hue);
  double l = lightness + .3963377774 * a + .2158037573 * b,
         m = lightness - .1055613458 * a - .0638541728 * b,
         s = lightness - .0894841775 * a - 1.2914855480 * b;

  l = l * l * l, m = m * m * m, s = s * s * s;
  return (lam_rgb){4.0767416621 * l - 3.3077115913 * m + .2309699292 * s,
                   -1.2684380046 * l + 2.6097574011 * m - .3413193965 * s,
                   -.0041960863 * l - .7034186147 * m + 1.7076147010 * s};
}

static bool in_gamut(lam_rgb c) {
  return fmin(fmin(c.r, c.g), c.b) >= 0 && fmax(fmax(c.r, c.g), c.b) <= 1;
}

/* The color of this lightness and hue with the given chroma, or the largest that a screen can show
 * (found by bisection; gray can always be shown). */
static lam_rgb color_of(double lightness, double chroma, double degrees) {
  double hue = degrees * LAM_PI / 180, low = 0, high = chroma;
  if (in_gamut(from_oklab(lightness, chroma, hue))) return from_oklab(lightness, chroma, hue);

  for (int i = 0; i < 40; i++) {
    double middle = (low + high) / 2;
    if (in_gamut(from_oklab(lightness, middle, hue)))
      low = middle;
    else
      high = middle;
  }
  return from_oklab(lightness, low, hue);
}

lam_rgb lam_ramp_sequential(double t) {
  return color_of(.28 + .64 * t, .11 + .05 * t, 300 - 195 * t);
}

lam_rgb lam_ramp_diverging(double t) {
  double s = 2 * fabs(t - .5);
  return color_of(.95 - .47 * s, .17 * s, t < .5 ? 255 : 30);
}

int lam_srgb(double linear) {
  double c = fmin(fmax(linear, 0), 1);
  c = c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
  return (int)lround(255 * c);
}
