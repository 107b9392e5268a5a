/* From a model to files in a folder: first the plan of all names, then the files. Called by
 * models.c and inputs_kept.c. */
#ifndef LAM_LIBRARY_WRITE_WRITE_FILES_H
#define LAM_LIBRARY_WRITE_WRITE_FILES_H

#include "core/model.h"
#include "core/progress.h"
#include "formats/format.h"
#include "library/write/manifest.h"

#include <stdbool.h>

/* A file to be written. */
typedef struct lam_output_file {
  const char *name;          /* relative to the folder */
  const lam_format *format;  /* that makes it */
  int index;                 /* among those of the format */
  const char *template_path; /* what it is a copy of; NULL: the format writes it */
  bool written;              /* out */
  uint64_t hash;             /* out: of its bytes */
} lam_output_file;

/* What is to be written, and what was. */
typedef struct lam_output {
  const char *only;             /* formats to write, separated by commas; NULL: all */
  const char *skip;             /* formats not to write; NULL: none */
  const char *templates;        /* folder of the templates */
  const lam_progress *progress; /* told of every format; NULL: nobody */
  int count, capacity;          /* filled by lam_output_plan: in the order of the formats */
  lam_output_file *files;
  int left_out; /* out: files that could not be made, for which there is a note each */
} lam_output;

/* Whether every name in a comma-separated list is a format; an unknown one is added to errors under
 * the name of the option, such as "--only". list may be NULL. */
bool lam_output_check(const char *option, const char *list, lam_errors *errors);
/* Fills the list of files with everything that the model gives and that only and skip allow, with
 * the formats that those need, and with the templates beside them. */
void lam_output_plan(lam_arena *arena, const lam_model *model, lam_output *output);
/* Writes all files of the plan (last: those whose format comes last, otherwise all others). What
 * somebody has changed since it was listed in `old` is kept under another name, with a note. A
 * picture that cannot be rendered is a note too, and left out. Ends at the first failure with a
 * message in errors: LAM_IO (the disk), LAM_FAILED (the library behind a format), LAM_BAD_INPUT (a
 * template that is too large). */
lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            const lam_folder *folder, const lam_manifest *old, bool last,
                            lam_errors *notes, lam_errors *errors);

#endif
