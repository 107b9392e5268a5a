/* Messages about input, and guesses at the name that was meant. Called in every folder that reads
 * input. */
#include "core/error.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* ---- messages ---- */

/* Appends to the list: messages are shown in the order in which they were found. */
static void append(lam_errors *errors, lam_error *error) {
  if (errors->last)
    errors->last->next = error;
  else
    errors->first = error;
  errors->last = error;
  errors->count++;
}

/* Counts a message that is one too many, and says so once. */
static void leave_out(lam_errors *errors) {
  if (errors->count++ > LAM_MOST_MESSAGES) return; /* said already */
  lam_error *last = LAM_NEW(errors->arena, lam_error, 1);
  last->text = "more messages are left out";
  errors->last->next = last;
  errors->last = last;
}

/* Formats the message and appends it with copies of all its texts. */
void lam_error_add(lam_errors *errors, lam_location location, const char *key, const char *format,
                   ...) {
  if (errors->count >= LAM_MOST_MESSAGES) {
    leave_out(errors);
    return;
  }

  /* A first pass measures the text, a second one writes it. */
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  char *text = lam_arena_alloc(errors->arena, (size_t)(length < 0 ? 0 : length) + 1, 1);
  vsnprintf(text, (size_t)length + 1, format, again);
  va_end(again);

  /* A message quotes what it was given, and must stay one line all the same. */
  for (char *c = text; *c; c++)
    if ((unsigned char)*c < ' ') *c = ' ';

  /* The caller's texts may be gone when the message is shown. */
  lam_error *error = LAM_NEW(errors->arena, lam_error, 1);
  location.file = lam_arena_copy(errors->arena, location.file);
  *error =
      (lam_error){.location = location, .key = lam_arena_copy(errors->arena, key), .text = text};
  append(errors, error);
}

lam_status lam_errors_status(const lam_errors *errors) {
  if (!errors->count) return LAM_OK;
  return errors->status != LAM_OK ? errors->status : LAM_BAD_INPUT;
}

/* A key in another place of the design, such as net.grid, is no key of the path: it begins with a
 * stage's name, and stays. */
static bool is_path(const char *key) {
  static const char *const stages[] = {"parts", "net", "surface", "sheets", "render", "plots"};
  for (size_t i = 0; i < sizeof stages / sizeof *stages; i++) {
    size_t length = strlen(stages[i]);
    if (strncmp(key, stages[i], length) == 0 && (!key[length] || strchr(".[", key[length])))
      return true;
  }
  return false;
}

void lam_errors_prefix(lam_errors *errors, const lam_error *last, const char *path) {
  for (lam_error *e = last ? last->next : errors->first; e; e = e->next)
    if (!e->key)
      e->key = lam_arena_copy(errors->arena, path);
    else if (!is_path(e->key))
      e->key = lam_arena_printf(errors->arena, "%s.%s", path, e->key);
}

lam_error *lam_errors_take(lam_errors *errors, lam_error *last) {
  lam_error *taken = last ? last->next : errors->first;
  errors->count = 0; /* also of those that were left out */
  for (const lam_error *e = last ? errors->first : NULL; e; e = e->next) {
    errors->count++;
    if (e == last) break;
  }
  if (last)
    last->next = NULL;
  else
    errors->first = NULL;
  errors->last = last;
  return taken;
}

/* Declared in include/lamella/error.h. */
const char *lam_status_text(lam_status status) {
  static const char *const texts[] = {
      [LAM_OK] = "done",
      [LAM_BAD_INPUT] = "bad input",
      [LAM_IO] = "a file cannot be read or written",
      [LAM_NO_MEMORY] = "out of memory",
      [LAM_MISSING_PROGRAM] = "a program is not installed",
      [LAM_FAILED] = "an outside library or program failed",
  };

  bool known = (unsigned)status < sizeof texts / sizeof *texts;
  return known ? texts[status] : "unknown status";
}

/* ---- guesses ---- */

enum { longest_name = 40 }; /* longer texts are never close to a name */

static bool same_letter(const char *a, const char *b) { return strncasecmp(a, b, 1) == 0; }

static int smaller(int a, int b) { return a < b ? a : b; }

/* The number of edits (a letter put in, left out or replaced, two neighbors swapped) that turn a
 * into b, case ignored: the Damerau-Levenshtein distance in its restricted form, where no part is
 * edited twice. longest_name when one of the texts is longer than that. */
static int edit_distance(const char *a, const char *b) {
  size_t n = strlen(a), m = strlen(b);
  if (n > longest_name || m > longest_name) return longest_name;

  /* row[j]: distance between the first i letters of a and the first j of b; above and before are
   * the rows of i - 1 and i - 2. */
  int rows[3][longest_name + 1];
  for (size_t j = 0; j <= m; j++) rows[0][j] = (int)j;
  int *before = rows[2], *above = rows[0], *row = rows[1];

  for (size_t i = 1; i <= n; i++) {
    row[0] = (int)i;
    for (size_t j = 1; j <= m; j++) {
      int best = above[j - 1] + !same_letter(a + i - 1, b + j - 1);
      best = smaller(best, above[j] + 1);
      best = smaller(best, row[j - 1] + 1);
      bool swapped =
          i > 1 && j > 1 && same_letter(a + i - 1, b + j - 2) && same_letter(a + i - 2, b + j - 1);
      if (swapped) best = smaller(best, before[j - 2] + 1);
      row[j] = best;
    }

    int *spare = before;
    before = above;
    above = row;
    row = spare;
  }
  return above[m];
}

/* The name with the smallest edit distance, the first of them when several have the same. A name
 * may be farther away the longer it is: a third of its length, rounded up. */
const char *lam_did_you_mean(const char *given, const char *const *names) {
  const char *nearest = NULL;
  int least = longest_name;
  for (; *names; names++) {
    int distance = edit_distance(given, *names);

    /* The beginning of a long name is many edits away from it, and yet a good guess. */
    size_t length = strlen(*names), typed = strlen(given);
    if (typed >= 3 && typed < length && strncasecmp(given, *names, typed) == 0) distance = 1;

    if (distance < least && distance <= (int)(length + 2) / 3) {
      least = distance;
      nearest = *names;
    }
  }
  return nearest;
}
