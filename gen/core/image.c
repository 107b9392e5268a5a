/* Pictures: PNG through libpng, hashes and differences of pixels. Called by library/, formats/gltf
 * and formats/pov. */
#include "core/image.h"

#include "core/file.h"
#include <math.h>
#include <png.h>
#include <string.h>

enum { most_pixels = 100000000, largest_file = 1 << 30 }; /* 300 MB; bytes */

lam_image lam_image_new(lam_arena *arena, int width, int height) {
  return (lam_image){width, height, LAM_NEW(arena, uint8_t, (size_t)width * (size_t)height * 3)};
}

/* ---- PNG ---- */

/* libpng's words stand in png->message; memory that runs out is not the picture's fault. */
static lam_status fail_to_read(lam_errors *errors, const char *path, const png_image *png) {
  if (strstr(png->message, "memory")) lam_arena_exhausted(errors->arena);
  lam_error_add(errors, (lam_location){.file = path}, NULL, "is not a readable PNG picture: %s",
                png->message);
  return LAM_BAD_INPUT;
}

/* For the arena, which closes what is left open when memory runs out. */
static void free_png(void *handle) {
  png_image *png = handle;
  png_image_free(png);
}

/* Two steps of libpng: the head of the file with the size, then the pixels. */
lam_status lam_image_read(lam_arena *arena, const char *path, lam_errors *errors,
                          lam_image *image) {
  char *bytes;
  size_t count;
  lam_status status = lam_file_read(arena, path, largest_file, errors, &bytes, &count);
  if (status != LAM_OK) return status;

  /* Freed with the arena: an allocation below may jump. */
  png_image *png = LAM_NEW(arena, png_image, 1);
  png->version = PNG_IMAGE_VERSION;
  lam_arena_defer(arena, free_png, png);

  if (!png_image_begin_read_from_memory(png, bytes, count)) return fail_to_read(errors, path, png);
  if ((double)png->width * png->height > most_pixels) {
    lam_error_add(errors, (lam_location){.file = path}, NULL,
                  "the picture has %u x %u pixels; expected at most 100 million", png->width,
                  png->height);
    return LAM_BAD_INPUT;
  }

  /* Into another picture first: *image stays as it was when the rest of the file is damaged. */
  png->format = PNG_FORMAT_RGB;
  lam_image read = lam_image_new(arena, (int)png->width, (int)png->height);
  const png_color white = {255, 255, 255};
  if (!png_image_finish_read(png, &white, read.pixels, 0, NULL))
    return fail_to_read(errors, path, png);

  *image = read;
  return LAM_OK;
}

/* libpng says beforehand how large the file can become at most. */
bool lam_image_encode(lam_arena *arena, const lam_image *image, uint8_t **bytes, size_t *count) {
  png_image png = {.version = PNG_IMAGE_VERSION,
                   .width = (png_uint_32)image->width,
                   .height = (png_uint_32)image->height,
                   .format = PNG_FORMAT_RGB};

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  *bytes = LAM_NEW(arena, uint8_t, size);
  bool done = png_image_write_to_memory(&png, *bytes, &size, 0, image->pixels, 0, NULL);
  *count = size;
  if (!done && strstr(png.message, "memory")) lam_arena_exhausted(arena);
  return done;
}

/* The bytes of the file are kept until errors' arena is released. */
lam_status lam_image_write(const char *path, const lam_image *image, lam_errors *errors) {
  uint8_t *bytes;
  size_t size;
  if (!lam_image_encode(errors->arena, image, &bytes, &size)) {
    lam_error_add(errors, (lam_location){.file = path}, NULL, "cannot be written: libpng failed");
    return errors->status = LAM_FAILED;
  }
  return lam_file_write_atomic(path, bytes, size, errors);
}

/* ---- hash ---- */

/* FNV-1a goes on from hash over more bytes. */
static uint64_t hash_bytes(uint64_t hash, const uint8_t *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) hash = (hash ^ bytes[i]) * 0x100000001b3ULL;
  return hash;
}

/* The size is hashed too: 2 x 8 and 4 x 4 black pixels are different pictures. */
uint64_t lam_image_hash(const lam_image *image) {
  uint8_t sizes[8];
  for (int i = 0; i < 4; i++) {
    sizes[i] = (uint8_t)((unsigned)image->width >> (8 * i));
    sizes[4 + i] = (uint8_t)((unsigned)image->height >> (8 * i));
  }

  uint64_t hash = hash_bytes(0xcbf29ce484222325ULL, sizes, sizeof sizes);
  return hash_bytes(hash, image->pixels, (size_t)image->width * (size_t)image->height * 3);
}

/* ---- difference ---- */

/* A pixel of the mask: red, or the gray of from in the upper quarter of the range. */
static void paint(uint8_t *to, const uint8_t *from, int differs) {
  static const uint8_t red[3] = {255, 0, 0};
  int gray = (from[0] + 2 * from[1] + from[2]) / 4;
  for (int k = 0; k < 3; k++) to[k] = differs ? red[k] : (uint8_t)(192 + gray / 4);
}

/* The largest difference of a channel of two pixels, 0 to 255; adds the squares of all three to
 * *squares. */
static int pixel_difference(const uint8_t *a, const uint8_t *b, uint64_t *squares) {
  int largest = 0;
  for (int k = 0; k < 3; k++) {
    int d = a[k] < b[k] ? b[k] - a[k] : a[k] - b[k];
    *squares += (uint64_t)(d * d);
    if (d > largest) largest = d;
  }
  return largest;
}

/* One pass over the pixels: share, largest difference and squares together. */
lam_image_difference lam_image_compare(const lam_image *a, const lam_image *b, lam_image *mask) {
  size_t count = (size_t)a->width * (size_t)a->height, differing = 0;
  uint64_t squares = 0;
  int max = 0;
  for (size_t i = 0; i < count; i++) {
    int largest = pixel_difference(a->pixels + 3 * i, b->pixels + 3 * i, &squares);
    if (largest > max) max = largest;
    differing += largest > lam_image_step;
    if (mask) paint(mask->pixels + 3 * i, a->pixels + 3 * i, largest > lam_image_step);
  }

  /* Peak signal to noise over all channels. */
  double mean = (double)squares / (3 * (double)count);
  return (lam_image_difference){(double)differing / (double)count, max,
                                squares ? 10 * log10(255.0 * 255.0 / mean) : INFINITY};
}
