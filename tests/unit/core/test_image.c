/* Reading, writing and comparing pictures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/file.h"
#include "core/image.h"
#include "mesh_fixture.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct fixture {
  lam_arena *arena;
  lam_errors errors;
  char folder[32];
  char *path;
} fixture;

static int set_up(void **state) {
  fixture *f = calloc(1, sizeof *f);
  f->arena = lam_arena_new();
  f->errors.arena = f->arena;
  strcpy(f->folder, "/tmp/lamella-test-XXXXXX");
  if (!mkdtemp(f->folder)) return 1;
  f->path = lam_arena_printf(f->arena, "%s/a.png", f->folder);
  *state = f;
  return 0;
}

static int tear_down(void **state) {
  fixture *f = *state;
  unlink(f->path);
  rmdir(f->folder);
  lam_arena_free(f->arena);
  free(f);
  return 0;
}

/* A gradient of 20 x 10 pixels. */
static lam_image gradient(lam_arena *arena) {
  lam_image image = lam_image_new(arena, 20, 10);
  for (int i = 0; i < 600; i++) image.pixels[i] = (uint8_t)(i * 7);
  return image;
}

static void png_keeps_pixels(void **state) {
  fixture *f = *state;
  lam_image image = gradient(f->arena), read;
  assert_int_equal(lam_image_write(f->path, &image, &f->errors), LAM_OK);
  assert_int_equal(lam_image_read(f->arena, f->path, &f->errors, &read), LAM_OK);
  assert_int_equal(read.width, 20);
  assert_int_equal(read.height, 10);
  assert_memory_equal(read.pixels, image.pixels, 600);
  assert_true(lam_image_hash(&read) == lam_image_hash(&image));
}

static void the_same_pixels_give_the_same_bytes(void **state) {
  fixture *f = *state;
  lam_image image = gradient(f->arena);
  char *bytes[2];
  size_t count[2];
  for (int i = 0; i < 2; i++) {
    assert_int_equal(lam_image_write(f->path, &image, &f->errors), LAM_OK);
    assert_int_equal(lam_file_read(f->arena, f->path, 1 << 20, &f->errors, &bytes[i], &count[i]),
                     LAM_OK);
  }
  assert_int_equal(count[0], count[1]);
  assert_memory_equal(bytes[0], bytes[1], count[0]);
}

/* FNV-1a of 01 00 00 00 01 00 00 00 00 00 00 (a black pixel), computed with a separate program of
 * three lines. */
static void the_hash_is_the_documented_one(void **state) {
  fixture *f = *state;
  lam_image black = lam_image_new(f->arena, 1, 1), wide = lam_image_new(f->arena, 2, 1);
  assert_true(lam_image_hash(&black) == 0x5d1ee66e34429d67ULL);
  lam_image tall = {1, 2, wide.pixels};
  assert_true(lam_image_hash(&wide) != lam_image_hash(&tall)); /* the shape counts */
}

/* Of 200 pixels one differs by 10 in one channel and one by 4 in one, which is allowed: share
 * 1/200, mean squared difference (100 + 16) / 600. */
static void differences_are_measured(void **state) {
  fixture *f = *state;
  lam_image a = gradient(f->arena), b = gradient(f->arena), mask = lam_image_new(f->arena, 20, 10);
  lam_image_difference d = lam_image_compare(&a, &b, NULL);
  assert_true(d.share == 0 && d.max == 0 && isinf(d.psnr));
  a.pixels[30] = 100;
  b.pixels[30] = 110;
  a.pixels[61] = 100;
  b.pixels[61] = 96;
  d = lam_image_compare(&a, &b, &mask);
  assert_near(d.share, 1. / 200, 1e-15);
  assert_int_equal(d.max, 10);
  assert_near(d.psnr, 10 * log10(255. * 255 * 600 / 116), 1e-12);
  const uint8_t red[3] = {255, 0, 0};
  assert_memory_equal(mask.pixels + 30, red, 3);
  assert_true(mask.pixels[60] >= 192); /* pale */
}

static void bad_pictures_are_refused(void **state) {
  fixture *f = *state;
  lam_image image = gradient(f->arena);
  assert_int_equal(lam_image_read(f->arena, f->path, &f->errors, &image), LAM_IO);
  assert_int_equal(lam_file_write_atomic(f->path, "no picture", 10, &f->errors), LAM_OK);
  assert_int_equal(lam_image_read(f->arena, f->path, &f->errors, &image), LAM_BAD_INPUT);
  assert_memory_equal(f->errors.last->text, "is not a readable PNG picture", 29);
  assert_int_equal(lam_image_write(f->path, &image, &f->errors), LAM_OK);
  char *bytes;
  size_t count;
  assert_int_equal(lam_file_read(f->arena, f->path, 1 << 20, &f->errors, &bytes, &count), LAM_OK);
  assert_int_equal(lam_file_write_atomic(f->path, bytes, count / 2, &f->errors),
                   LAM_OK); /* cut off */
  assert_int_equal(lam_image_read(f->arena, f->path, &f->errors, &image), LAM_BAD_INPUT);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(png_keeps_pixels),
      TEST(the_same_pixels_give_the_same_bytes),
      TEST(the_hash_is_the_documented_one),
      TEST(differences_are_measured),
      TEST(bad_pictures_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
