/* The list of files of the last build: read, searched, and written anew. Called by models.c and
 * write_files.c. */
#include "library/write/manifest.h"
#include "core/text.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static const char list_name[] = ".lamella-files";
enum { hash_digits = 16 };

static int by_name(const void *a, const void *b) {
  return strcmp(((const lam_listed_file *)a)->name, ((const lam_listed_file *)b)->name);
}

void lam_manifest_sort(lam_manifest *manifest) {
  lam_listed_file *files = manifest->files;
  if (!manifest->count) return;
  qsort(files, (size_t)manifest->count, sizeof *files, by_name);

  int kept = 1;
  for (int i = 1; i < manifest->count; i++) {
    bool repeated = strcmp(files[i].name, files[kept - 1].name) == 0;
    if (repeated) files[kept - 1].has_hash = false;
    if (!repeated) files[kept++] = files[i];
  }
  manifest->count = kept;
}

uint64_t lam_manifest_hash(const void *bytes, size_t count) {
  const unsigned char *at = bytes;
  uint64_t hash = 14695981039346656037u;
  for (size_t i = 0; i < count; i++) hash = (hash ^ at[i]) * 1099511628211u;
  return hash;
}

/* ---- reading ---- */

/* A line of the list, "NAME HASH" or "NAME", whose end is marked by a zero; the name is cut off. */
static lam_listed_file read_line(char *line) {
  lam_listed_file file = {.name = line};
  char *blank = strrchr(line, ' ');
  if (blank && strspn(blank + 1, "0123456789abcdef") == hash_digits && !blank[1 + hash_digits]) {
    file.has_hash = true;
    file.hash = strtoull(blank + 1, NULL, 16);
    *blank = 0;
  }
  return file;
}

/* Whether a name stays inside the folder: others are not listed, whoever wrote them. */
static bool is_inside(const char *name) {
  if (name[0] == 0 || name[0] == '/') return false;
  for (const char *at = name; at; at = strchr(at, '/') ? strchr(at, '/') + 1 : NULL)
    if (strncmp(at, "..", 2) == 0 && (at[2] == 0 || at[2] == '/')) return false;
  return true;
}

lam_manifest lam_manifest_read(lam_arena *arena, const lam_folder *folder) {
  lam_manifest manifest = {0};
  size_t count;
  char *bytes = lam_folder_read(arena, folder, list_name, &count);
  if (!bytes || strlen(bytes) != count) return manifest;

  int lines = 0;
  for (const char *at = bytes; *at; at++) lines += *at == '\n';
  manifest.files = LAM_NEW(arena, lam_listed_file, lines);

  for (char *line = bytes, *end; (end = strchr(line, '\n')); line = end + 1) {
    *end = 0;
    if (!manifest.design)
      manifest.design = line;
    else if (is_inside(line))
      manifest.files[manifest.count++] = read_line(line);
  }
  lam_manifest_sort(&manifest);
  return manifest;
}

const lam_listed_file *lam_manifest_find(const lam_manifest *manifest, const char *name) {
  const lam_listed_file key = {.name = name};
  if (!manifest->count) return NULL;
  return bsearch(&key, manifest->files, (size_t)manifest->count, sizeof key, by_name);
}

/* ---- writing ---- */

lam_status lam_manifest_write(const lam_folder *folder, lam_manifest *manifest,
                              lam_errors *errors) {
  lam_text text = {.arena = errors->arena};
  lam_manifest_sort(manifest);
  lam_text_printf(&text, "%s\n", manifest->design);
  for (int i = 0; i < manifest->count; i++) {
    const lam_listed_file *file = &manifest->files[i];
    lam_text_add(&text, file->name);
    if (file->has_hash) lam_text_printf(&text, " %016" PRIx64, file->hash);
    lam_text_add(&text, "\n");
  }
  return lam_folder_write(folder, list_name, text.data, text.length, errors);
}

/* ---- changes ---- */

/* The bytes are given back at once: they may be many. */
bool lam_manifest_changed(lam_arena *arena, const lam_folder *folder, const lam_manifest *old,
                          const char *name) {
  const lam_listed_file *listed = lam_manifest_find(old, name);
  if (!listed || !listed->has_hash) return false;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  size_t count;
  const char *bytes = lam_folder_read(arena, folder, name, &count);
  bool changed = bytes && lam_manifest_hash(bytes, count) != listed->hash;
  lam_arena_release(arena, mark);
  return changed;
}
