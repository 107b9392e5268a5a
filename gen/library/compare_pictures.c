/* Comparing two PNG pictures. Called through lamella/solid.h, by cli/diff_pictures.c. */
#include "core/file.h"
#include "core/image.h"
#include "library/session_state.h"
#include <lamella/solid.h>

_Static_assert((int)LAM_PIXEL_STEP == (int)lam_image_step,
               "the face tells the step of core/image.h");

/* mask_path: NULL, or where the differing pixels are drawn. Pictures of different sizes have their
 * sizes and hashes alone. */
static lam_status compare(lam_session *session, const char *const paths[2], const char *mask_path,
                          lam_picture_comparison *c) {
  lam_image images[2], mask = {0};
  for (int i = 0; i < 2; i++)
    if (mask_path && lam_path_same(paths[i], mask_path))
      lam_error_add(&session->errors, (lam_location){0}, "--mask",
                    "given %s, which is compared; expected another file for the mask", mask_path);
  if (session->errors.count) return LAM_OK;

  bool read = true; /* both are read, so that all messages appear at once */
  for (int i = 0; i < 2; i++)
    read = lam_image_read(session->arena, paths[i], &session->errors, &images[i]) == LAM_OK && read;
  if (!read) return LAM_OK;

  for (int i = 0; i < 2; i++) {
    c->width[i] = images[i].width;
    c->height[i] = images[i].height;
    c->hash[i] = lam_image_hash(&images[i]);
  }
  c->same_size = c->width[0] == c->width[1] && c->height[0] == c->height[1];
  if (!c->same_size) return LAM_OK;

  if (mask_path) mask = lam_image_new(session->arena, c->width[0], c->height[0]);
  lam_image_difference difference =
      lam_image_compare(&images[0], &images[1], mask_path ? &mask : NULL);
  c->share = difference.share;
  c->largest = difference.max;
  c->psnr = difference.psnr;

  return mask_path ? lam_image_write(mask_path, &mask, &session->errors) : LAM_OK;
}

/* Declared in include/lamella/solid.h. */
lam_status lam_compare_pictures(lam_session *session, const char *a, const char *b,
                                const char *mask, lam_picture_comparison *comparison) {
  *comparison = (lam_picture_comparison){0};
  LAM_ENTER(session);
  return lam_session_leave(session,
                           compare(session, (const char *const[]){a, b}, mask, comparison));
}
