/* From a model to files in a folder. */
#ifndef LAM_LIBRARY_WRITE_WRITE_FILES_H
#define LAM_LIBRARY_WRITE_WRITE_FILES_H

#include "core/error.h"
#include "core/model.h"
#include "core/progress.h"

#include <stdbool.h>

/* Paths, each once. */
typedef struct lam_paths {
  int count, capacity;
  const char **items;
} lam_paths;

typedef struct lam_output {
  const char *folder;    /* made when it is missing */
  const char *only;      /* formats to write, separated by commas; NULL: all */
  const char *skip;      /* formats not to write; NULL: none */
  const char *templates; /* folder of the templates */
  const lam_progress *progress;
  lam_paths files;          /* out: that were made; they start with the folder */
  lam_paths used_templates; /* out: that they were made from */
} lam_output;

/* Whether every name in a comma-separated list is a format; an unknown one is added to errors under
 * the name of the option. list may be NULL. */
bool lam_output_check(const char *option, const char *list, lam_errors *errors);
/* Writes everything that the model gives. What needs a program that is missing is skipped with one
 * line in notes; errors are those of the disk. */
lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            lam_errors *notes, lam_errors *errors);

#endif
