/* Two pictures side by side, as text or JSON, and whether they are the same. Called by
 * verb_diff.c. */
#include "cli/diff.h"
#include "cli/solid_facts.h"
#include "cli/verb_run.h"

#include <inttypes.h>
#include <stdio.h>

static const double default_tolerance_percent = 0.02;

/* tolerance: percent. Pictures of different sizes have nothing more to compare. */
static void print_text(const lam_picture_comparison *c, double tolerance, bool same) {
  for (int i = 0; i < 2; i++) {
    int width = c->width[i], height = c->height[i];
    printf("%c                  %d x %d pixels, hash %016" PRIx64 "\n", 'A' + i, width, height,
           c->hash[i]);
  }
  if (!c->same_size) {
    puts("different: size");
    return;
  }

  printf("differing pixels   %.4g %% (by more than %d of 255), limit %.4g %%\n", 100 * c->share,
         LAM_PIXEL_STEP, tolerance);
  printf("largest difference %d of 255\n", c->largest);
  if (c->largest) printf("PSNR               %.2f dB\n", c->psnr);
  puts(same ? "the same" : "different: pixels");
}

/* tolerance: percent. Hashes are texts: JSON numbers do not hold 64 bits. Returns the exit
 * status. */
static int print_json(const lam_picture_comparison *c, double tolerance, bool same) {
  json_t *object = json_object(), *hashes = json_array(), *sizes = json_array();
  for (int i = 0; i < 2; i++) {
    json_array_append_new(hashes, json_sprintf("%016" PRIx64, c->hash[i]));
    json_array_append_new(sizes, json_pack("[i,i]", c->width[i], c->height[i]));
  }

  json_object_set_new(object, "same", json_boolean(same));
  json_object_set_new(object, "hash", hashes);
  json_object_set_new(object, "size", sizes);
  json_object_set_new(object, "tolerance_percent", json_real(tolerance));

  /* The ratio is infinite for equal pictures, which JSON has no number for. */
  if (c->same_size) {
    json_object_set_new(object, "differing_percent", json_real(100 * c->share));
    json_object_set_new(object, "max", json_integer(c->largest));
    json_object_set_new(object, "psnr", c->largest ? json_real(c->psnr) : json_null());
  }
  return lam_json_print(object, same ? 0 : 1, 12);
}

/* 0: the same; 1: different; otherwise the status of files that cannot be read. */
int lam_diff_pictures(lam_session *session, const lam_diff_request *request) {
  lam_picture_comparison comparison;
  lam_status status = lam_compare_pictures(session, request->paths[0], request->paths[1],
                                           request->mask, &comparison);
  if (status != LAM_OK) return lam_verb_status(session, status);

  double tolerance = request->tolerance < 0 ? default_tolerance_percent : request->tolerance;
  bool same = comparison.same_size && 100 * comparison.share <= tolerance;
  if (request->json) return print_json(&comparison, tolerance, same);
  print_text(&comparison, tolerance, same);
  return same ? 0 : 1;
}
