/* Copies of shipped files to start from: nothing that is there is overwritten. */
#ifndef LAM_LIBRARY_NEW_FILES_H
#define LAM_LIBRARY_NEW_FILES_H

#include "core/error.h"

#include <stdbool.h>

/* One file to be copied. */
typedef struct lam_new_file {
  const char *source, *target; /* paths */
  char *bytes;                 /* read from source */
  size_t count;
  bool there; /* the target has the same bytes already */
} lam_new_file;

enum { LAM_MOST_NEW_FILES = 32 };

typedef struct lam_new_files {
  const char *source, *folder; /* that names are taken from and copied to; folder ends with a slash
                                  or is empty */
  int count;
  lam_new_file files[LAM_MOST_NEW_FILES];
} lam_new_files;

/* Begins with one file of files->source; target: where to, NULL: its own name. The others go beside
 * it. */
void lam_new_files_begin(lam_arena *arena, lam_new_files *files, const char *name,
                         const char *target);
/* Adds a file by its name, once; beyond LAM_MOST_NEW_FILES it is left out. */
void lam_new_files_add(lam_arena *arena, lam_new_files *files, const char *name);
/* Reads one. False with a message. */
bool lam_new_file_read(lam_arena *arena, lam_new_file *file, lam_errors *errors);
/* Whether its target is free; same: or has the same bytes. A message otherwise. */
bool lam_new_file_allowed(lam_arena *arena, lam_new_file *file, bool same, lam_errors *errors);
/* Writes those that are not there; *written: their paths, NULL-terminated. */
lam_status lam_new_files_write(lam_arena *arena, const lam_new_files *files, lam_errors *errors,
                               const char *const **written);

#endif
