/* An output folder by its descriptor: names are walked part by part with openat and O_NOFOLLOW, and
 * flock keeps builds apart, as it goes with the process whatever ends that. Called by models.c,
 * write_files.c, manifest.c and render.c. */
#include "library/write/folder.h"
#include "core/clock.h"
#include "core/file.h"
#include "core/leftover.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char *const temporary[] = {LAM_FOLDER_PART, LAM_FOLDER_PICTURE, LAM_FOLDER_STATE};
enum { temporary_count = sizeof temporary / sizeof *temporary };

/* Adds "PATH: what: the system's words" and returns LAM_IO. */
static lam_status fail(lam_errors *errors, const char *path, const char *what, int reason) {
  char text[128];
  lam_error_add(errors, (lam_location){.file = path}, NULL, "%s: %s", what,
                strerror_r(reason, text, sizeof text));
  return errors->status = LAM_IO;
}

/* ---- opening ---- */

/* Waits until no other build has the folder open. False when the time is up. A file system without
 * locks gives none, and nothing is waited for. */
static bool lock(int descriptor, double wait, const lam_progress *progress) {
  double deadline = lam_clock_seconds() + wait;
  while (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return true;
    if (lam_clock_seconds() >= deadline) return false;
    lam_progress_tell(progress, "waiting", -1, "another build writes into the folder");
    nanosleep(&(struct timespec){.tv_nsec = 50000000}, NULL);
  }
  return true;
}

/* Removes the temporary files, and enters them to be removed when the process ends (or takes them
 * out again). */
static void remove_temporary(lam_folder *folder, bool enter) {
  for (int i = 0; i < temporary_count; i++) {
    unlinkat(folder->descriptor, temporary[i], 0);
    if (!enter) lam_leftover_forget(folder->leftovers[i]);
    folder->leftovers[i] = enter ? lam_leftover_file(folder->descriptor, temporary[i]) : -1;
  }
}

static void close_folder(void *handle) {
  lam_folder *folder = handle;
  if (folder->descriptor < 0) return;
  if (folder->leftovers[0] >= 0) remove_temporary(folder, false);
  close(folder->descriptor);
  folder->descriptor = -1;
}

void lam_folder_close(lam_folder *folder) { close_folder(folder); }

lam_folder *lam_folder_open(lam_arena *arena, const char *path, double wait,
                            const lam_progress *progress, lam_errors *errors) {
  /* The arena closes it when a jump ends the call. */
  lam_folder *folder = LAM_NEW(arena, lam_folder, 1);
  *folder = (lam_folder){path, -1, {-1, -1, -1}};
  lam_arena_defer(arena, close_folder, folder);

  if (lam_path_make_dirs(path, errors) != LAM_OK) return NULL;
  folder->descriptor = open(*path ? path : "/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder->descriptor < 0) {
    fail(errors, path, "the folder cannot be opened", errno);
    return NULL;
  }

  if (!lock(folder->descriptor, wait, progress)) {
    lam_error_add(errors, (lam_location){.file = path}, NULL,
                  "another build writes into the folder; waited %g s for its end", wait);
    errors->status = LAM_IO;
    return NULL;
  }
  remove_temporary(folder, true);
  return folder;
}

/* ---- names ---- */

/* Goes from an open folder into one in it, whose name is the first `length` bytes; closes the one
 * before. Returns the new descriptor, or -1 with errno. */
static int enter(int at, const char *name, size_t length, bool make) {
  char part[256];
  int next = -1;
  errno = EINVAL;
  if (length > 0 && length < sizeof part && strncmp(name, "..", length) != 0) {
    memcpy(part, name, length);
    part[length] = 0;
    if (!make || mkdirat(at, part, 0777) == 0 || errno == EEXIST)
      next = openat(at, part, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  }

  int reason = errno;
  close(at);
  errno = reason;
  return next;
}

/* Opens the folder that a name lies in, and makes what is missing on the way when asked to. *base:
 * the last part of the name. Returns a descriptor to be closed, or -1 with errno. */
static int open_parent(const lam_folder *folder, const char *name, bool make, const char **base) {
  int at = openat(folder->descriptor, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  for (const char *slash; at >= 0 && (slash = strchr(name, '/')); name = slash + 1)
    at = enter(at, name, (size_t)(slash - name), make);

  *base = name;
  bool names_file = *name && strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
  if (at < 0 || names_file) return at;
  close(at);
  errno = EINVAL;
  return -1;
}

/* ---- files ---- */

/* Writes all bytes to the temporary file. Returns 0, or the error number. */
static int write_part(const lam_folder *folder, const char *bytes, size_t count) {
  unlinkat(folder->descriptor, LAM_FOLDER_PART, 0);
  int file =
      openat(folder->descriptor, LAM_FOLDER_PART, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return errno;

  int reason = 0;
  while (count && !reason) {
    ssize_t done = write(file, bytes, count);
    if (done < 0 && errno != EINTR) reason = errno;
    if (done > 0) {
      bytes += done;
      count -= (size_t)done;
    }
  }

  /* What was written may be lost as late as at the end. */
  if (close(file) != 0 && !reason) reason = errno;
  return reason;
}

lam_status lam_folder_write(const lam_folder *folder, const char *name, const void *bytes,
                            size_t count, lam_errors *errors) {
  const char *base;
  int parent = open_parent(folder, name, true, &base);
  int reason = parent < 0 ? errno : write_part(folder, bytes, count);
  if (!reason && renameat(folder->descriptor, LAM_FOLDER_PART, parent, base) != 0) reason = errno;
  if (parent >= 0) close(parent);
  if (!reason) return LAM_OK;

  unlinkat(folder->descriptor, LAM_FOLDER_PART, 0);
  return fail(errors, lam_arena_printf(errors->arena, "%s/%s", folder->path, name),
              "cannot be written", reason);
}

/* A descriptor of the file, to be closed; -1: it is not there, or not a plain file. */
static int open_plain(const lam_folder *folder, const char *name, struct stat *info) {
  const char *base;
  int parent = open_parent(folder, name, false, &base);
  if (parent < 0) return -1;

  int file = openat(parent, base, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  close(parent);
  if (file >= 0 && fstat(file, info) == 0 && S_ISREG(info->st_mode)) return file;
  if (file >= 0) close(file);
  return -1;
}

/* Memory before the descriptor is opened: running out of it jumps. */
char *lam_folder_read(lam_arena *arena, const lam_folder *folder, const char *name, size_t *count) {
  enum { most = 1 << 30 };
  struct stat info;
  int file = open_plain(folder, name, &info);
  if (file < 0) return NULL;
  close(file);
  if (info.st_size > most) return NULL;

  size_t room = (size_t)info.st_size, length = 0;
  char *bytes = lam_arena_alloc(arena, room + 1, 1);
  file = open_plain(folder, name, &info);
  while (file >= 0 && length < room) {
    ssize_t got = read(file, bytes + length, room - length);
    if (got == 0 || (got < 0 && errno != EINTR)) break;
    if (got > 0) length += (size_t)got;
  }
  if (file >= 0) close(file);

  *count = length;
  return file >= 0 && length == room ? bytes : NULL;
}

int lam_folder_rename(const lam_folder *folder, const char *name, const char *base) {
  const char *old;
  int parent = open_parent(folder, name, false, &old);
  if (parent < 0) return errno;
  int reason = renameat(parent, old, parent, base) == 0 ? 0 : errno;
  close(parent);
  return reason;
}

bool lam_folder_remove(const lam_folder *folder, const char *name) {
  const char *base;
  int parent = open_parent(folder, name, false, &base);
  if (parent < 0) return false;
  bool removed = unlinkat(parent, base, 0) == 0;
  close(parent);
  return removed;
}

bool lam_folder_has(const lam_folder *folder, const char *name) {
  struct stat info;
  const char *base;
  int parent = open_parent(folder, name, false, &base);
  if (parent < 0) return false;
  bool has = fstatat(parent, base, &info, AT_SYMLINK_NOFOLLOW) == 0;
  close(parent);
  return has;
}
