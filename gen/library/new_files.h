/* Copies of shipped files to start from: nothing that is there is overwritten. Begun, added to,
 * read, allowed and written, in this order, by designs.c. */
#ifndef LAM_LIBRARY_NEW_FILES_H
#define LAM_LIBRARY_NEW_FILES_H

#include "core/error.h"

#include <stdbool.h>

/* One file to be copied. */
typedef struct lam_new_file {
  const char *source, *target; /* paths, from and to */
  char *bytes;                 /* count bytes, read from source; NULL before */
  size_t count;
  bool there; /* the target has the same bytes already, and is not written */
} lam_new_file;

enum { LAM_MOST_NEW_FILES = 32 };

/* Begins zeroed but for source. All texts are owned by the arena of the calls. */
typedef struct lam_new_files {
  const char *source; /* folder that names are taken from, without a slash at its end */
  const char *folder; /* that they are copied to: ends with a slash, or is empty */
  int count;
  lam_new_file files[LAM_MOST_NEW_FILES];
} lam_new_files;

/* Begins with the file called name in files->source; target: its new path, NULL: its own name in
 * the current folder. Files that are added go beside it. */
void lam_new_files_begin(lam_arena *arena, lam_new_files *files, const char *name,
                         const char *target);
/* Adds a file by its name, once; beyond LAM_MOST_NEW_FILES it is left out. */
void lam_new_files_add(lam_arena *arena, lam_new_files *files, const char *name);
/* Reads the source of a file into arena. False with a message. */
bool lam_new_file_read(lam_arena *arena, lam_new_file *file, lam_errors *errors);
/* Whether the target of a file that was read is free; same: or has the same bytes, which
 * file->there tells. A message otherwise. */
bool lam_new_file_allowed(lam_arena *arena, lam_new_file *file, bool same, lam_errors *errors);
/* Writes those that are not there; *written: their paths, NULL-terminated, in arena. LAM_IO, with a
 * message: one cannot be written. */
lam_status lam_new_files_write(lam_arena *arena, const lam_new_files *files, lam_errors *errors,
                               const char *const **written);

#endif
