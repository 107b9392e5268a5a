/* Pictures: reading and writing PNG, comparing pixels. Called by library/ (comparing pictures) and
 * by formats/gltf and formats/pov (pictures printed on surfaces). */
#ifndef LAM_CORE_IMAGE_H
#define LAM_CORE_IMAGE_H

#include "core/error.h"
#include <stdbool.h>
#include <stdint.h>

/* 8-bit sRGB, rows from the top, width * height * 3 bytes. */
typedef struct lam_image {
  int width, height;
  uint8_t *pixels; /* owned by the arena it was made in */
} lam_image;

/* A black image. width, height >= 1. */
lam_image lam_image_new(lam_arena *arena, int width, int height);

/* Reads a PNG file of any kind; what is transparent is laid on white. The pixels are owned by
 * arena; *image is untouched on failure. LAM_IO: the file cannot be read. LAM_BAD_INPUT: it is no
 * PNG, or too large (a side of more than 32768 pixels, or 1 GiB). The message names the file. */
lam_status lam_image_read(lam_arena *arena, const char *path, lam_errors *errors, lam_image *image);
/* Writes an RGB8 PNG file: the same pixels give the same bytes (with the same libpng). LAM_IO: the
 * file cannot be written. LAM_FAILED: libpng failed. The message names the file. */
lam_status lam_image_write(const char *path, const lam_image *image, lam_errors *errors);
/* The bytes of that file, in the arena. false: libpng failed. */
bool lam_image_encode(lam_arena *arena, const lam_image *image, uint8_t **bytes, size_t *count);

/* FNV-1a, 64 bits (offset basis cbf29ce484222325, prime 100000001b3), over width and height (each
 * as 4 bytes, little end first) and the pixels: equal for files that decode to the same picture. */
uint64_t lam_image_hash(const lam_image *image);

typedef struct lam_image_difference {
  double share; /* of the pixels with a channel that differs by more than lam_image_step, 0 to 1 */
  int max;      /* largest difference of a channel, 0 to 255 */
  double psnr;  /* 10 log10(255^2 / mean squared difference), dB; infinite when equal */
} lam_image_difference;

/* Channels that differ by no more than this count as the same. */
enum { lam_image_step = 4 };

/* Compares images of the same size. mask: NULL, or an image of that size, which becomes a pale copy
 * of a in which pixels that differ by more than lam_image_step are red. */
lam_image_difference lam_image_compare(const lam_image *a, const lam_image *b, lam_image *mask);

#endif
