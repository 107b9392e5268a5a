/* Finding the templates folder and the shipped designs in it. Called by session.c, designs.c and
 * reference/sections.c. */
#include "library/templates.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- the folder ---- */

static bool is_folder(const char *path) {
  struct stat status;
  return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* The folder that this code lies in: that of the shared library, or of the program that it is
 * linked into. The loader knows a program only by the name that it was called with, so that the
 * system is asked for its path. NULL: it cannot be told. */
static const char *code_folder(lam_arena *arena) {
  Dl_info info;
  char path[PATH_MAX];
  bool is_library = dladdr((void *)lam_template_dir, &info) && info.dli_fname &&
                    strcmp(info.dli_fname, program_invocation_name) != 0;
  if (!realpath(is_library ? info.dli_fname : "/proc/self/exe", path)) {
    if (errno == ENOMEM) lam_arena_exhausted(arena);
    return NULL;
  }

  char *slash = strrchr(path, '/');
  if (!slash) return NULL;
  *slash = 0;
  return lam_arena_copy(arena, path);
}

/* Where a program or library lies in a build folder (two depths) and when it is installed (bin/,
 * lib/ and lib/ARCHITECTURE/). The environment goes first, even when it is wrong. */
const char *lam_template_dir(lam_arena *arena) {
  static const char *const beside[] = {"../templates", "../../templates",
                                       "../share/lamella/templates",
                                       "../../share/lamella/templates", NULL};
  const char *chosen = getenv("LAMELLA_TEMPLATES");
  if (chosen && *chosen) return is_folder(chosen) ? lam_arena_copy(arena, chosen) : NULL;

  const char *folder = code_folder(arena);
  for (int i = 0; folder && beside[i]; i++) {
    const char *path = lam_arena_printf(arena, "%s/%s", folder, beside[i]);
    if (is_folder(lam_arena_printf(arena, "%s/designs", path))) return path;
  }
  return NULL;
}

/* ---- shipped designs ---- */

static int by_name(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* The length of a file's name without ".yaml"; 0 when it ends otherwise or is hidden. */
static size_t stem_length(const char *name) {
  size_t length = strlen(name);
  return length > 5 && name[0] != '.' && strcmp(name + length - 5, ".yaml") == 0 ? length - 5 : 0;
}

static void close_folder(void *handle) { closedir(handle); }

/* The order of a folder is arbitrary: names are sorted. */
const char *const *lam_template_designs(lam_arena *arena, const char *folder) {
  enum { most = 1000 };
  const char **names = LAM_NEW(arena, const char *, most + 1);
  DIR *directory = folder ? opendir(lam_arena_printf(arena, "%s/designs", folder)) : NULL;
  if (!directory && folder && errno == ENOMEM) lam_arena_exhausted(arena);
  if (!directory) return names;

  /* Closed with the arena: an allocation below may jump. */
  lam_arena_defer(arena, close_folder, directory);
  int count = 0;
  for (struct dirent *entry = readdir(directory); entry && count < most;
       entry = readdir(directory)) {
    size_t length = stem_length(entry->d_name);
    if (length > 0) names[count++] = lam_arena_printf(arena, "%.*s", (int)length, entry->d_name);
  }

  qsort(names, (size_t)count, sizeof *names, by_name);
  return names;
}

const char *lam_template_design_path(lam_arena *arena, const char *folder, const char *name) {
  return lam_arena_printf(arena, "%s/designs/%s.yaml", folder ? folder : ".", name);
}
