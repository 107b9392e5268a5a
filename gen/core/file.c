#include "core/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The reason is read before anything else can change it. */
static lam_status fail(lam_errors *errors, const char *path, const char *what, int reason) {
  char text[128];
  lam_error_add(errors, (lam_location){.file = path}, NULL, "%s: %s", what,
                strerror_r(reason, text, sizeof text));
  return errors->status = LAM_IO;
}

/* Reads to the end; the file may be a pipe, whose size is not known before. */
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

lam_status lam_file_read(lam_arena *arena, const char *path, size_t limit, lam_errors *errors,
                         char **bytes, size_t *count) {
  *bytes = NULL;
  *count = 0;
  FILE **file = LAM_NEW(arena, FILE *, 1);
  lam_arena_defer(arena, close_file, file);
  *file = fopen(path, "rb");
  if (!*file) return fail(errors, path, "cannot be opened", errno);
  struct stat info;
  bool plain = !fstat(fileno(*file), &info) && S_ISREG(info.st_mode) && info.st_size > 0;
  size_t size = plain ? (size_t)info.st_size : 0;
  if (size > limit) size = limit;
  lam_status status = read_all(arena, fileno(*file), path, limit, size, errors, bytes, count);
  close_file(file);
  return status;
}

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

static int write_and_close(int file, const void *bytes, size_t count) {
  int reason = write_all(file, bytes, count);
  if (close(file) && !reason) reason = errno;
  return reason;
}

lam_status lam_file_write_atomic(const char *path, const void *bytes, size_t count,
                                 lam_errors *errors) {
  struct stat info;
  if (!stat(path, &info) && !S_ISREG(info.st_mode)) {
    int file = open(path, O_WRONLY | O_CLOEXEC);
    int reason = file < 0 ? errno : write_and_close(file, bytes, count);
    return reason ? fail(errors, path, "cannot be written", reason) : LAM_OK;
  }
  char *temporary = lam_arena_printf(errors->arena, "%s.%ld.part", path, (long)gettid());
  unlink(temporary); /* left by a thread of the same number that was killed */
  int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return fail(errors, path, "cannot be written", errno);
  int reason = write_and_close(file, bytes, count);
  if (!reason && rename(temporary, path)) reason = errno;
  if (!reason) return LAM_OK;
  unlink(temporary);
  return fail(errors, path, "cannot be written", reason);
}

lam_status lam_path_make_dirs(const char *path, lam_errors *errors) {
  char *partial = lam_arena_copy(errors->arena, path);
  for (char *end = partial; *end;) {
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
