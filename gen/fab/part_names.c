/* The one place where names of parts are given out. Called by fab/parts, fab/lamella and
 * design/parts_stage.c. */
#include "fab/part_names.h"

#include <stdlib.h>
#include <string.h>

/* Whether a name is these letters and a number. */
static bool is_of_row(const char *name, const char *letters) {
  size_t length = strlen(letters);
  const char digit = strncmp(name, letters, length) == 0 ? name[length] : 0;
  return digit >= '0' && digit <= '9';
}

/* The letters after Z are AA, after AZ BA: numbers in a system whose digits are A to Z and which
 * has no zero. n counts from 0, for A. */
static const char *letters_of(lam_arena *arena, int n) {
  char text[8];
  int at = (int)sizeof text - 1;
  text[at] = 0;
  for (; n >= 0; n = n / 26 - 1) text[--at] = (char)('A' + n % 26);
  return lam_arena_copy(arena, &text[at]);
}

const char *lam_part_letters(const lam_workshop *w, char first) {
  for (int n = first - 'A';; n++) {
    const char *letters = letters_of(w->arena, n);
    bool taken = false;
    for (int i = 0; i < w->part_count && !taken; i++) taken = is_of_row(w->parts[i].name, letters);
    if (!taken) return letters;
  }
}

static bool has_name(const lam_workshop *w, const char *name) {
  for (int i = 0; i < w->part_count; i++)
    if (strcmp(w->parts[i].name, name) == 0) return true;
  return false;
}

const char *lam_part_name(const lam_workshop *w, const char *wanted) {
  const char *name = wanted;
  for (int number = 2; has_name(w, name); number++)
    name = lam_arena_printf(w->arena, "%s-%d", wanted, number);
  return name;
}

static int compare(const void *a, const void *b) {
  return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Sorted, equal names are neighbors. */
const char *lam_part_name_twice(const lam_workshop *w) {
  if (!w->part_count) return NULL;
  lam_arena_mark mark = lam_arena_mark_get(w->arena);
  const char **names = LAM_NEW(w->arena, const char *, w->part_count), *twice = NULL;
  for (int i = 0; i < w->part_count; i++) names[i] = w->parts[i].name;
  qsort(names, (size_t)w->part_count, sizeof *names, compare);

  for (int i = 1; i < w->part_count && !twice; i++)
    if (strcmp(names[i - 1], names[i]) == 0) twice = names[i];
  lam_arena_release(w->arena, mark);
  return twice;
}
