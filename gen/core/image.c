#include "core/image.h"

#include "core/file.h"
#include <math.h>
#include <png.h>
#include <string.h>

enum { largest_side = 32768, largest_file = 1 << 30 };

lam_image lam_image_new(lam_arena *arena, int width, int height) {
  return (lam_image){width, height, LAM_NEW(arena, uint8_t, (size_t)width * (size_t)height * 3)};
}

static lam_status fail(lam_errors *errors, const char *path, const char *what) {
  lam_error_add(errors, (lam_location){.file = path}, NULL, "%s", what);
  return LAM_BAD_INPUT;
}

static void free_png(void *handle) {
  png_image *png = handle;
  png_image_free(png);
}

lam_status lam_image_read(lam_arena *arena, const char *path, lam_errors *errors,
                          lam_image *image) {
  char *bytes;
  size_t count;
  lam_status status = lam_file_read(arena, path, largest_file, errors, &bytes, &count);
  if (status != LAM_OK) return status;
  png_image *png =
      LAM_NEW(arena, png_image, 1); /* freed with the arena: an allocation below may jump */
  png->version = PNG_IMAGE_VERSION;
  lam_arena_defer(arena, free_png, png);
  if (!png_image_begin_read_from_memory(png, bytes, count)) {
    lam_error_add(errors, (lam_location){.file = path}, NULL, "is not a readable PNG picture: %s",
                  png->message);
    return LAM_BAD_INPUT;
  }
  if (png->width > largest_side || png->height > largest_side)
    return fail(errors, path, "the picture is too large");
  png->format = PNG_FORMAT_RGB;
  lam_image read = lam_image_new(arena, (int)png->width, (int)png->height);
  const png_color white = {255, 255, 255};
  if (!png_image_finish_read(png, &white, read.pixels, 0, NULL)) {
    lam_error_add(errors, (lam_location){.file = path}, NULL, "is not a readable PNG picture: %s",
                  png->message);
    return LAM_BAD_INPUT;
  }
  *image = read;
  return LAM_OK;
}

bool lam_image_encode(lam_arena *arena, const lam_image *image, uint8_t **bytes, size_t *count) {
  png_image png = {.version = PNG_IMAGE_VERSION,
                   .width = (png_uint_32)image->width,
                   .height = (png_uint_32)image->height,
                   .format = PNG_FORMAT_RGB};
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  *bytes = LAM_NEW(arena, uint8_t, size);
  bool done = png_image_write_to_memory(&png, *bytes, &size, 0, image->pixels, 0, NULL);
  *count = size;
  return done;
}

lam_status lam_image_write(const char *path, const lam_image *image, lam_errors *errors) {
  uint8_t *bytes;
  size_t size;
  if (!lam_image_encode(errors->arena, image, &bytes, &size)) {
    lam_error_add(errors, (lam_location){.file = path}, NULL, "cannot be written: libpng failed");
    return LAM_FAILED;
  }
  return lam_file_write_atomic(path, bytes, size, errors);
}

static uint64_t hash_bytes(uint64_t hash, const uint8_t *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) hash = (hash ^ bytes[i]) * 0x100000001b3ULL;
  return hash;
}

uint64_t lam_image_hash(const lam_image *image) {
  uint8_t sizes[8];
  for (int i = 0; i < 4; i++) {
    sizes[i] = (uint8_t)((unsigned)image->width >> (8 * i));
    sizes[4 + i] = (uint8_t)((unsigned)image->height >> (8 * i));
  }
  uint64_t hash = hash_bytes(0xcbf29ce484222325ULL, sizes, sizeof sizes);
  return hash_bytes(hash, image->pixels, (size_t)image->width * (size_t)image->height * 3);
}

static void paint(uint8_t *to, const uint8_t *from, int differs) {
  static const uint8_t red[3] = {255, 0, 0};
  int gray = (from[0] + 2 * from[1] + from[2]) / 4;
  for (int k = 0; k < 3; k++) to[k] = differs ? red[k] : (uint8_t)(192 + gray / 4);
}

lam_image_difference lam_image_compare(const lam_image *a, const lam_image *b, lam_image *mask) {
  size_t count = (size_t)a->width * (size_t)a->height, differing = 0;
  uint64_t squares = 0;
  int max = 0;
  for (size_t i = 0; i < count; i++) {
    int largest = 0;
    for (size_t k = 3 * i; k < 3 * i + 3; k++) {
      int d =
          a->pixels[k] < b->pixels[k] ? b->pixels[k] - a->pixels[k] : a->pixels[k] - b->pixels[k];
      squares += (uint64_t)(d * d);
      if (d > largest) largest = d;
    }
    if (largest > max) max = largest;
    differing += largest > lam_image_step;
    if (mask) paint(mask->pixels + 3 * i, a->pixels + 3 * i, largest > lam_image_step);
  }
  double mean = (double)squares / (3 * (double)count);
  return (lam_image_difference){(double)differing / (double)count, max,
                                squares ? 10 * log10(255.0 * 255.0 / mean) : INFINITY};
}
