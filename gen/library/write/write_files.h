/* From a model to files in a folder. Called by models.c. */
#ifndef LAM_LIBRARY_WRITE_WRITE_FILES_H
#define LAM_LIBRARY_WRITE_WRITE_FILES_H

#include "core/error.h"
#include "core/model.h"
#include "core/progress.h"

#include <stdbool.h>

/* Paths, each once. Begins zeroed. */
typedef struct lam_paths {
  int count, capacity;
  const char **items;
} lam_paths;

/* What is to be written, and what was. */
typedef struct lam_output {
  const char *folder;           /* made when it is missing */
  const char *only;             /* formats to write, separated by commas; NULL: all */
  const char *skip;             /* formats not to write; NULL: none */
  const char *templates;        /* folder of the templates */
  const lam_progress *progress; /* told of every format; NULL: nobody */
  lam_paths files;              /* out: that were made; they start with the folder */
  lam_paths used_templates;     /* out: that stand beside them, by their path among the templates */
} lam_output;

/* Whether every name in a comma-separated list is a format; an unknown one is added to errors under
 * the name of the option, such as "--only". list may be NULL. */
bool lam_output_check(const char *option, const char *list, lam_errors *errors);
/* Writes everything that the model gives and that only and skip allow, whose names are known. Paths
 * are owned by arena. A picture that cannot be rendered is a line in notes. Ends at the first
 * failure with a message in errors: LAM_IO (the disk), LAM_FAILED (the library behind a format),
 * LAM_BAD_INPUT (a template that is too large). */
lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            lam_errors *notes, lam_errors *errors);

#endif
