/* Whole files. Every failure is added to errors with the file's name and the system's reason.
 * Called by library and cli alone, and by core/image.c for them: nothing between opens a file. */
#ifndef LAM_CORE_FILE_H
#define LAM_CORE_FILE_H

#include "core/error.h"

#include <stdbool.h>

/* Reads a file (or a pipe) of at most `limit` bytes into the arena. *bytes is followed by a zero
 * that is not counted in *count; NULL and 0 when reading fails. LAM_IO: it cannot be read.
 * LAM_BAD_INPUT: it is larger than the limit. */
lam_status lam_file_read(lam_arena *arena, const char *path, size_t limit, lam_errors *errors,
                         char **bytes, size_t *count);

/* Writes a file so that nobody sees half of it: under a temporary name in the same folder, renamed
 * when complete. An existing file is replaced, and stays as it was when writing fails. What is not
 * a plain file (such as /dev/null) is written to directly. The folder must exist. LAM_IO: it cannot
 * be written. */
lam_status lam_file_write_atomic(const char *path, const void *bytes, size_t count,
                                 lam_errors *errors);

/* Whether both paths lead to the same file or folder that is there, links followed. */
bool lam_path_same(const char *a, const char *b);

/* Makes a folder and the folders above it where they are missing. LAM_IO: one cannot be made, or
 * something else has its name. */
lam_status lam_path_make_dirs(const char *path, lam_errors *errors);

#endif
