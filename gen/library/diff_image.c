#include "cli/mesh_input.h"
#include "cli/verb_diff.h"
#include "core/image.h"

#include <inttypes.h>
#include <stdio.h>

static const double default_tolerance_percent = 0.02;

typedef struct comparison {
  const lam_image *images;
  uint64_t hash[2];
  bool same_size, same;
  lam_image_difference difference; /* when same_size */
  double tolerance;                /* percent */
} comparison;

static void print_text(const comparison *c) {
  for (int i = 0; i < 2; i++)
    printf("%c                  %d x %d pixels, hash %016" PRIx64 "\n", "AB"[i],
           c -> images[i].width, c->images[i].height, c->hash[i]);
  if (!c->same_size) {
    puts("different: size");
    return;
  }
  printf("differing pixels   %.4g %% (by more than %d of 255), limit %.4g %%\n",
         100 * c->difference.share, lam_image_step, c->tolerance);
  printf("largest difference %d of 255\n", c->difference.max);
  if (c->difference.max) printf("PSNR               %.2f dB\n", c->difference.psnr);
  puts(c->same ? "the same" : "different: pixels");
}

static void print_json(const comparison *c) {
  json_t *object = json_object(), *hashes = json_array(), *sizes = json_array();
  for (int i = 0; i < 2; i++) {
    json_array_append_new(hashes, json_sprintf("%016" PRIx64, c->hash[i]));
    json_array_append_new(sizes, json_pack("[i,i]", c->images[i].width, c->images[i].height));
  }
  json_object_set_new(object, "same", json_boolean(c->same));
  json_object_set_new(object, "hash", hashes);
  json_object_set_new(object, "size", sizes);
  json_object_set_new(object, "tolerance_percent", json_real(c->tolerance));
  if (c->same_size) {
    json_object_set_new(object, "differing_percent", json_real(100 * c->difference.share));
    json_object_set_new(object, "max", json_integer(c->difference.max));
    json_object_set_new(object, "psnr",
                        c->difference.max ? json_real(c->difference.psnr) : json_null());
  }
  lam_json_print(object);
}

int lam_diff_images(lam_arena *arena, const lam_diff_request *request, lam_errors *errors) {
  lam_image images[2], mask = {0};
  bool read = true;
  for (int i = 0; i < 2; i++)
    read = lam_image_read(arena, request->paths[i], errors, &images[i]) == LAM_OK && read;
  if (!read) return 2;
  comparison c = {.images = images};
  c.tolerance = request->tolerance < 0 ? default_tolerance_percent : request->tolerance;
  for (int i = 0; i < 2; i++) c.hash[i] = lam_image_hash(&images[i]);
  c.same_size = images[0].width == images[1].width && images[0].height == images[1].height;
  if (c.same_size) {
    if (request->mask) mask = lam_image_new(arena, images[0].width, images[0].height);
    c.difference = lam_image_compare(&images[0], &images[1], request->mask ? &mask : NULL);
    c.same = 100 * c.difference.share <= c.tolerance;
    if (request->mask && lam_image_write(request->mask, &mask, errors) != LAM_OK) return 2;
  }
  if (request->json)
    print_json(&c);
  else
    print_text(&c);
  return c.same ? 0 : 1;
}
