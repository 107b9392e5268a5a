/* The two comparisons behind `lamella diff`. */
#ifndef LAM_CLI_VERB_DIFF_H
#define LAM_CLI_VERB_DIFF_H

#include "core/error.h"
#include <stdbool.h>

typedef struct lam_diff_request {
  const char *paths[2];
  double tolerance; /* negative: the default of the kind of file */
  const char *mask; /* NULL: none */
  bool json;
} lam_diff_request;

/* Both print their result on stdout and return the exit code; 2 when they added to errors. */
int lam_diff_meshes(lam_arena *arena, const lam_diff_request *request, lam_errors *errors);
int lam_diff_images(lam_arena *arena, const lam_diff_request *request, lam_errors *errors);

#endif
