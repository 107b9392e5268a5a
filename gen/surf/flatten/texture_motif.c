/* Pictures that show distortion: a bold letter B on squared paper, a checkerboard, a color
 * scale. Every pixel of the first two is the mean of 4 x 4 samples. Called by texture.c. */
#include "core/ramp.h"
#include "surf/flatten/texture.h"

const char *const lam_motif_names[] = {"letter", "checker", "distortion", NULL};

/* Samples of a pixel per direction; squares of the paper along a side of the picture. */
enum { SAMPLES = 4, FIELDS = 16 };

/* A bowl of the letter, between the heights low and high: straight from the stem and then half
 * a ring, as far as reach. */
static bool in_bowl(double x, double y, double low, double high, double reach) {
  double half = (high - low) / 2, straight = reach - half, middle = low + half;
  double dx = fmax(0, x - straight), dy = y - middle, r = hypot(dx, dy);

  static const double stroke = 0.17;
  bool outside = x < 0 || r > half,
       hollow = x > 0.2 && fabs(dy) < half - stroke && r < half - stroke;
  return !outside && !hollow;
}

/* The letter's height is 1, its lower left corner the origin: a stem and two bowls. */
static bool in_letter(double x, double y) {
  if (x < 0 || y < 0 || y > 1) return false;
  return x < 0.2 || in_bowl(x, y, 0, 0.575, 0.68) || in_bowl(x, y, 0.425, 1, 0.62);
}

/* The color at (x, y), counted from the middle of the square; letter: the height of the
 * letter. */
static const double *color_at(lam_motif motif, double x, double y, double letter) {
  static const double paper[3] = {.93, .92, .88}, line[3] = {.62, .70, .76},
                      ink[3] = {.05, .10, .30}, red[3] = {.55, .08, .05};

  double fx = x * FIELDS, fy = y * FIELDS;
  if (motif == LAM_MOTIF_CHECKER) return ((long)floor(fx) + (long)floor(fy)) & 1 ? red : paper;
  if (in_letter(x / letter + 0.34, y / letter + 0.5)) return ink;
  return fabs(fx - round(fx)) < 0.035 || fabs(fy - round(fy)) < 0.035 ? line : paper;
}

/* From left to right the colors of values. */
static unsigned char *draw_ramp(lam_arena *arena, int size) {
  unsigned char *pixels = LAM_NEW(arena, unsigned char, 3 * (size_t)size * (size_t)size);
  for (int column = 0; column < size; column++) {
    lam_rgb color = lam_ramp_sequential(column / (size - 1.));
    for (int row = 0; row < size; row++) {
      unsigned char *pixel = pixels + 3 * ((size_t)row * (size_t)size + (size_t)column);
      pixel[0] = (unsigned char)lam_srgb(color.r);
      pixel[1] = (unsigned char)lam_srgb(color.g);
      pixel[2] = (unsigned char)lam_srgb(color.b);
    }
  }
  return pixels;
}

/* y points up in the picture, rows run down. */
unsigned char *lam_motif_draw(lam_arena *arena, lam_motif motif, double width, double height,
                              int size) {
  if (motif == LAM_MOTIF_DISTORTION) return draw_ramp(arena, size);

  unsigned char *pixels = LAM_NEW(arena, unsigned char, 3 * (size_t)size * (size_t)size);
  for (int row = 0; row < size; row++)
    for (int column = 0; column < size; column++) {
      double sum[3] = {0};
      for (int s = 0; s < SAMPLES * SAMPLES; s++) {
        double x = (column + (s % SAMPLES + 0.5) / SAMPLES) / size - 0.5;
        double y = 0.5 - (row + (s / SAMPLES + 0.5) / SAMPLES) / size;
        const double *color = color_at(motif, x, y, 0.9 * fmin(width, height));

        for (int c = 0; c < 3; c++) sum[c] += color[c] / (SAMPLES * SAMPLES);
      }
      for (int c = 0; c < 3; c++)
        pixels[3 * ((size_t)row * size + column) + c] = (unsigned char)lam_srgb(sum[c]);
    }
  return pixels;
}
