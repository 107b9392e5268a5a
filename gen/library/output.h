/* From a model to files. */
#ifndef LAM_LIBRARY_OUTPUT_H
#define LAM_LIBRARY_OUTPUT_H

#include "core/error.h"
#include "core/model.h"
#include "core/progress.h"
#include <stdbool.h>

typedef struct lam_output {
  const char *folder;    /* made when it is missing */
  const char *only;      /* formats to write, separated by commas; NULL: all */
  const char *skip;      /* formats not to write; NULL: none */
  const char *templates; /* folder of the templates */
  const lam_progress *progress;
  /* out: paths of the files that were made, and of the templates they were made from */
  int file_count, file_capacity, template_count, template_capacity;
  const char **files, **used_templates;
} lam_output;

/* Whether every name in only is a format; an unknown one is added to errors under the name of the
 * option. */
bool lam_output_check(const char *option, const char *only, lam_errors *errors);
/* Writes everything that the model gives. What needs a program that is missing is skipped with one
 * line in notes; errors are those of the disk. */
lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            lam_errors *notes, lam_errors *errors);

#endif
