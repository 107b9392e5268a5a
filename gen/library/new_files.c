/* Reading, comparing and writing files that must not exist yet. Called by designs.c. */
#include "library/new_files.h"
#include "core/file.h"
#include "design/tree.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const lam_location nowhere;

/* ---- the list ---- */

/* A file of the source folder that is to be copied to target. */
static lam_new_file new_file(lam_arena *arena, const lam_new_files *files, const char *name,
                             const char *target) {
  return (lam_new_file){.source = lam_arena_printf(arena, "%s/%s", files->source, name),
                        .target = target};
}

/* The folder of the first target is that of all others. */
void lam_new_files_begin(lam_arena *arena, lam_new_files *files, const char *name,
                         const char *target) {
  if (!target) target = name;

  const char *slash = strrchr(target, '/');
  int folder = slash ? (int)(slash - target) + 1 : 0;
  files->folder = lam_arena_printf(arena, "%.*s", folder, target);

  files->files[0] = new_file(arena, files, name, target);
  files->count = 1;
}

/* Names are compared by where they go. */
void lam_new_files_add(lam_arena *arena, lam_new_files *files, const char *name) {
  const char *target = lam_arena_printf(arena, "%s%s", files->folder, name);
  for (int i = 0; i < files->count; i++)
    if (strcmp(files->files[i].target, target) == 0) return;
  if (files->count == LAM_MOST_NEW_FILES) return;
  files->files[files->count++] = new_file(arena, files, name, target);
}

/* ---- reading and comparing ---- */

/* The limit of designs holds for the files that they name too. */
bool lam_new_file_read(lam_arena *arena, lam_new_file *file, lam_errors *errors) {
  return lam_file_read(arena, file->source, (size_t)LAM_DESIGN_MAX_BYTES, errors, &file->bytes,
                       &file->count) == LAM_OK;
}

/* A target that cannot be read counts as different. */
bool lam_new_file_allowed(lam_arena *arena, lam_new_file *file, bool same, lam_errors *errors) {
  if (access(file->target, F_OK) != 0) return true;
  if (!same) {
    lam_error_add(errors, nowhere, NULL, "%s exists; choose another name with -o FILE",
                  file->target);
    return false;
  }

  lam_errors unread = {.arena = arena}; /* messages that nobody reads */
  char *bytes;
  size_t count;
  file->there = lam_file_read(arena, file->target, (size_t)LAM_DESIGN_MAX_BYTES, &unread, &bytes,
                              &count) == LAM_OK &&
                count == file->count && memcmp(bytes, file->bytes, count) == 0;
  if (!file->there)
    lam_error_add(errors, nowhere, NULL,
                  "%s exists and differs from the one that the design needs; expected another "
                  "folder",
                  file->target);
  return file->there;
}

/* ---- writing ---- */

/* The target cannot be written, for this error number. */
static bool fail_to_write(const lam_new_file *file, int reason, lam_errors *errors) {
  errors->status = LAM_IO;
  lam_error_add(errors, nowhere, NULL, "%s: %s", file->target, strerror(reason));
  return false;
}

/* Writes a file that must not exist, not even since it was looked for (O_EXCL). Removes what it
 * wrote when it fails. */
static bool write_new(const lam_new_file *file, lam_errors *errors) {
  int descriptor = open(file->target, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return fail_to_write(file, errno, errors);

  bool good = true;
  for (size_t done = 0; done < file->count && good;) {
    ssize_t written = write(descriptor, file->bytes + done, file->count - done);
    good = written > 0 || (written < 0 && errno == EINTR);
    if (written > 0) done += (size_t)written;
  }

  int problem = errno;
  if (close(descriptor) == 0 && good) return true;
  unlink(file->target);
  return fail_to_write(file, problem, errors);
}

/* Ends at the first file that cannot be written; those before it stay. */
lam_status lam_new_files_write(lam_arena *arena, const lam_new_files *files, lam_errors *errors,
                               const char *const **written) {
  const char **paths = LAM_NEW(arena, const char *, files->count + 1);
  int count = 0;
  *written = paths;

  for (int i = 0; i < files->count; i++) {
    if (files->files[i].there) continue;
    if (!write_new(&files->files[i], errors)) return LAM_IO;
    paths[count++] = files->files[i].target;
  }
  return LAM_OK;
}
