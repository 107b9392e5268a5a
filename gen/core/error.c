#include "core/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

void lam_error_add(lam_errors *errors, lam_location location, const char *key, const char *format,
                   ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  char *text = lam_arena_alloc(errors->arena, (size_t)(length < 0 ? 0 : length) + 1, 1);
  vsnprintf(text, (size_t)length + 1, format, again);
  va_end(again);
  for (char *c = text; *c; c++)
    if ((unsigned char)*c < ' ') *c = ' ';
  lam_error *error = LAM_NEW(errors->arena, lam_error, 1);
  location.file = lam_arena_copy(errors->arena, location.file);
  *error =
      (lam_error){.location = location, .key = lam_arena_copy(errors->arena, key), .text = text};
  if (errors->last)
    errors->last->next = error;
  else
    errors->first = error;
  errors->last = error;
  errors->count++;
}

lam_status lam_errors_status(const lam_errors *errors) {
  if (!errors->count) return LAM_OK;
  return errors->status != LAM_OK ? errors->status : LAM_BAD_INPUT;
}

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

/* Damerau-Levenshtein distance (adjacent swaps count once), case ignored; texts beyond the limit
 * are never close. */
enum { longest_name = 40 };

static int edit_distance(const char *a, const char *b) {
  size_t n = strlen(a), m = strlen(b);
  if (n > longest_name || m > longest_name) return longest_name;
  int rows[3][longest_name + 1];
  for (size_t j = 0; j <= m; j++) rows[0][j] = (int)j;
  int *before = rows[2], *above = rows[0], *row = rows[1];
  for (size_t i = 1; i <= n; i++) {
    row[0] = (int)i;
    for (size_t j = 1; j <= m; j++) {
      int differs = strncasecmp(a + i - 1, b + j - 1, 1) != 0;
      int best = above[j - 1] + differs;
      if (above[j] + 1 < best) best = above[j] + 1;
      if (row[j - 1] + 1 < best) best = row[j - 1] + 1;
      if (i > 1 && j > 1 && strncasecmp(a + i - 1, b + j - 2, 1) == 0 &&
          strncasecmp(a + i - 2, b + j - 1, 1) == 0 && before[j - 2] + 1 < best)
        best = before[j - 2] + 1;
      row[j] = best;
    }
    int *spare = before;
    before = above;
    above = row;
    row = spare;
  }
  return above[m];
}

const char *lam_did_you_mean(const char *given, const char *const *names) {
  const char *nearest = NULL;
  int least = longest_name;
  for (; *names; names++) {
    int distance = edit_distance(given, *names);
    size_t length = strlen(*names), typed = strlen(given);
    if (typed >= 3 && typed < length && strncasecmp(given, *names, typed) == 0) distance = 1;
    if (distance < least && distance <= (int)(length + 2) / 3) {
      least = distance;
      nearest = *names;
    }
  }
  return nearest;
}
