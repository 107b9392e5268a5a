/* Whole files: read into the arena, written so that nobody sees half of them. Called by library,
 * cli and core/image.c. */
#include "core/file.h"
#include "core/leftover.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Adds "PATH: what: the system's words for reason" and returns LAM_IO. reason is an argument, so
 * that errno is read before anything else can change it. */
static lam_status fail(lam_errors *errors, const char *path, const char *what, int reason) {
  char text[128];
  lam_error_add(errors, (lam_location){.file = path}, NULL, "%s: %s", what,
                strerror_r(reason, text, sizeof text));
  return errors->status = LAM_IO;
}

/* ---- reading ---- */

/* Reads to the end; the file may be a pipe, whose size is not known before. guess: the expected
 * size; one byte more than that is asked for, so that a right guess finds the end without another
 * buffer. */
static lam_status read_all(lam_arena *arena, int file, const char *path, size_t limit, size_t guess,
                           lam_errors *errors, char **bytes, size_t *count) {
  size_t capacity = guess + 1, length = 0;
  char *data = lam_arena_alloc(arena, capacity + 1, 1);
  for (;;) {
    ssize_t got = read(file, data + length, capacity - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail(errors, path, "cannot be read", errno);
    if (got == 0) break;

    length += (size_t)got;
    if (length > limit) {
      lam_error_add(errors, (lam_location){.file = path}, NULL, "is larger than %zu bytes", limit);
      return LAM_BAD_INPUT;
    }
    if (length < capacity) continue;

    /* Full: on in a buffer of twice the size. One byte beyond the capacity is for the zero. */
    char *larger = lam_arena_alloc(arena, 2 * capacity + 1, 1);
    memcpy(larger, data, length);
    data = larger;
    capacity *= 2;
  }

  data[length] = 0;
  *bytes = data;
  *count = length;
  return LAM_OK;
}

/* The arena closes the file when reading ends with a jump. */
static void close_file(void *handle) {
  FILE **file = handle;
  if (*file) fclose(*file);
  *file = NULL;
}

/* The size of a plain file says how large the buffer has to be. */
lam_status lam_file_read(lam_arena *arena, const char *path, size_t limit, lam_errors *errors,
                         char **bytes, size_t *count) {
  *bytes = NULL;
  *count = 0;
  FILE **file = LAM_NEW(arena, FILE *, 1);
  lam_arena_defer(arena, close_file, file);
  *file = fopen(path, "rb");
  if (!*file && errno == ENOMEM) lam_arena_exhausted(arena);
  if (!*file) return fail(errors, path, "cannot be opened", errno);

  /* A file that is too large needs no room for all of it to be found out. */
  struct stat info;
  bool plain = !fstat(fileno(*file), &info) && S_ISREG(info.st_mode) && info.st_size > 0;
  size_t size = plain ? (size_t)info.st_size : 0;
  if (size > limit) size = limit;

  lam_status status = read_all(arena, fileno(*file), path, limit, size, errors, bytes, count);
  close_file(file);
  return status;
}

/* ---- writing ---- */

/* Writes count bytes, in as many calls as it takes. Returns 0, or the error number. */
static int write_all(int file, const char *bytes, size_t count) {
  while (count) {
    ssize_t done = write(file, bytes, count);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return errno;
    bytes += done;
    count -= (size_t)done;
  }
  return 0;
}

/* Writes and closes; what was written may be lost as late as that. Returns 0, or the first error
 * number. */
static int write_and_close(int file, const void *bytes, size_t count) {
  int reason = write_all(file, bytes, count);
  if (close(file) && !reason) reason = errno;
  return reason;
}

/* A temporary file in the same folder, and so on the same disk, can be renamed in one step. */
lam_status lam_file_write_atomic(const char *path, const void *bytes, size_t count,
                                 lam_errors *errors) {
  /* A device or a pipe cannot be replaced by a file of its name. */
  struct stat info;
  if (!stat(path, &info) && !S_ISREG(info.st_mode)) {
    int file = open(path, O_WRONLY | O_CLOEXEC);
    int reason = file < 0 ? errno : write_and_close(file, bytes, count);
    return reason ? fail(errors, path, "cannot be written", reason) : LAM_OK;
  }

  /* The thread's number keeps two writers of the same file apart. */
  char *temporary = lam_arena_printf(errors->arena, "%s.%ld.part", path, (long)gettid());
  unlink(temporary); /* left by a thread of the same number that was killed */
  int leftover = lam_leftover_file(AT_FDCWD, temporary);
  int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);

  int reason = file < 0 ? errno : write_and_close(file, bytes, count);
  if (!reason && rename(temporary, path)) reason = errno;
  if (reason && file >= 0) unlink(temporary);
  lam_leftover_forget(leftover);
  if (!reason) return LAM_OK;
  return fail(errors, path, "cannot be written", reason);
}

/* ---- paths ---- */

bool lam_path_same(const char *a, const char *b) {
  struct stat one, other;
  return stat(a, &one) == 0 && stat(b, &other) == 0 && one.st_dev == other.st_dev &&
         one.st_ino == other.st_ino;
}

/* From the top of the path down, one folder at a time. */
lam_status lam_path_make_dirs(const char *path, lam_errors *errors) {
  char *partial = lam_arena_copy(errors->arena, path);
  for (char *end = partial; *end;) {
    /* partial is cut off behind the next name for a while. */
    end += strspn(end, "/");
    end += strcspn(end, "/");
    char separator = *end;
    *end = 0;

    struct stat info;
    if (mkdir(partial, 0777) && (errno != EEXIST || stat(partial, &info)))
      return fail(errors, partial, "the folder cannot be made", errno);
    if (!stat(partial, &info) && !S_ISDIR(info.st_mode))
      return fail(errors, partial, "is not a folder", ENOTDIR);

    *end = separator;
  }
  return LAM_OK;
}
