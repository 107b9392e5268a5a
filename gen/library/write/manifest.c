/* The list of files of the last build: read, compared with what was made now, and written anew.
 * Called by models.c. */
#include "library/write/manifest.h"
#include "core/file.h"
#include "core/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const size_t most_bytes = (size_t)1 << 24; /* of a list */

static int by_name(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Whether a path stays inside the folder: a list that somebody has changed must not remove files
 * elsewhere. */
static bool is_inside(const char *name) {
  if (name[0] == 0 || name[0] == '/') return false;
  for (const char *at = name; at; at = strchr(at, '/') ? strchr(at, '/') + 1 : NULL)
    if (strncmp(at, "..", 2) == 0 && (at[2] == 0 || at[2] == '/')) return false;
  return true;
}

/* The lines of the list that is there, behind the first one with the design's name; NULL when there
 * is no list, or one of another design. A list that cannot be read is none. */
static char *read_list(lam_arena *arena, const char *path, const char *design) {
  lam_errors unread = {.arena = arena};
  char *bytes;
  size_t count, length = strlen(design);
  if (access(path, F_OK) != 0) return NULL;
  if (lam_file_read(arena, path, most_bytes, &unread, &bytes, &count) != LAM_OK) return NULL;

  if (strlen(bytes) != count || strncmp(bytes, design, length) != 0 || bytes[length] != '\n')
    return NULL;
  return bytes + length + 1;
}

static int line_count(const char *lines) {
  int count = 0;
  for (const char *at = lines; at && *at; at++) count += *at == '\n';
  return count;
}

/* The design's name, then the names of the files, a line each, sorted: the same bytes every
 * time. */
static void write_list(lam_arena *arena, const char *path, const char *design, int count,
                       const char **names, lam_errors *errors) {
  qsort(names, (size_t)count, sizeof *names, by_name);
  lam_text text = {.arena = arena};
  lam_text_printf(&text, "%s\n", design);
  for (int i = 0; i < count; i++) lam_text_printf(&text, "%s\n", names[i]);
  lam_file_write_atomic(path, text.data, text.length, errors);
}

/* The names of made files are searched before old ones are appended behind them. */
int lam_manifest_update(lam_arena *arena, const char *folder, const char *design, int count,
                        const char *const *made, bool partial, lam_errors *errors) {
  const char *path = lam_arena_printf(arena, "%s/.lamella-files", folder);
  char *old = read_list(arena, path, design);

  /* What was made now, without the folder, sorted to be searched. */
  const char **names = LAM_NEW(arena, const char *, count + line_count(old) + 1);
  for (int i = 0; i < count; i++) names[i] = made[i] + strlen(folder) + 1;
  qsort(names, (size_t)count, sizeof *names, by_name);

  /* What was made before and not now goes, or stays in the list. */
  int kept = count, removed = 0;
  for (char *name = old, *end; name && (end = strchr(name, '\n')); name = end + 1) {
    *end = 0;
    if (bsearch(&name, names, (size_t)count, sizeof *names, by_name) || !is_inside(name)) continue;
    if (partial)
      names[kept++] = name;
    else
      removed += unlink(lam_arena_printf(arena, "%s/%s", folder, name)) == 0;
  }

  write_list(arena, path, design, kept, names, errors);
  return removed;
}
