/* Words, lines and numbers of text, for the readers of OBJ, OFF, PLY, STL and points
 * (formats/mesh), IGES (formats/iges) and STEP (formats/step). */
#include "formats/scan.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { longest_number = 63, longest_shown = 40 };

int lam_utf8_mark(const char *bytes, size_t count) {
  return count >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

static void free_locale(void *handle) { freelocale((locale_t)handle); }

/* A locale of its own, because a user's may have decimal commas; it is closed with the arena. */
lam_scan lam_scan_begin(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                        lam_errors *errors) {
  lam_scan scan = {.at = bytes + lam_utf8_mark(bytes, count),
                   .end = bytes + count,
                   .location = location,
                   .errors = errors};
  scan.location.line = 1;
  scan.location.column = 0;
  scan.errors_before = errors->count;
  scan.plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  if (!scan.plain) lam_arena_exhausted(arena);
  lam_arena_defer(arena, free_locale, scan.plain);
  return scan;
}

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

int lam_line_end(const char *at, const char *end) {
  if (at == end || (*at != '\n' && *at != '\r')) return 0;
  return *at == '\r' && at + 1 < end && at[1] == '\n' ? 2 : 1;
}

/* The bytes of a backslash and the line end behind it, which join two lines; 0: there are none. At
 * the end of the text the backslash stands alone. */
static int join_at(const lam_scan *scan, const char *at) {
  if (!scan->joins || at == scan->end || *at != '\\') return 0;
  if (at + 1 == scan->end) return 1;
  int end = lam_line_end(at + 1, scan->end);
  return end ? 1 + end : 0;
}

/* Passes over blanks and joints of lines. */
static void pass_blanks(lam_scan *scan) {
  int join = 0;
  while (scan->at < scan->end && (is_blank(*scan->at) || (join = join_at(scan, scan->at)))) {
    scan->at += join ? join : 1;
    scan->location.line += join > 1;
    join = 0;
  }
}

/* Blanks do not include the end of the line: a word never reaches into the next one. */
bool lam_scan_word(lam_scan *scan, lam_word *word) {
  pass_blanks(scan);
  if (scan->at == scan->end || lam_line_end(scan->at, scan->end) || *scan->at == '#') return false;

  word->text = scan->at;
  while (scan->at < scan->end && !lam_line_end(scan->at, scan->end) && *scan->at != '#' &&
         !is_blank(*scan->at) && !join_at(scan, scan->at))
    scan->at++;
  word->length = (int)(scan->at - word->text);
  return true;
}

/* The line number stays when the text ends, so that a message about what is missing names the
 * last line. */
bool lam_scan_line(lam_scan *scan) {
  bool comment = false;
  int length = 0;
  while (scan->at < scan->end && !(length = lam_line_end(scan->at, scan->end))) {
    comment |= *scan->at == '#';
    int join = comment ? 0 : join_at(scan, scan->at);
    scan->at += join ? join : 1;
    scan->location.line += join > 1;
  }

  scan->at += length;
  if (scan->at == scan->end) return false;
  scan->location.line++;
  return true;
}

bool lam_word_is(lam_word word, const char *text) {
  return strlen(text) == (size_t)word.length &&
         strncasecmp(word.text, text, (size_t)word.length) == 0;
}

int lam_word_shown(lam_word word) {
  return word.length < longest_shown ? word.length : longest_shown;
}

/* Longer words than any number are refused before they are copied. */
bool lam_scan_number(lam_scan *scan, lam_word word, const char *what, double *number) {
  /* strtod alone would take "inf", "nan" and hexadecimal numbers, and needs a terminated text. */
  char text[longest_number + 1], *end = text;
  if (word.length <= longest_number) {
    memcpy(text, word.text, (size_t)word.length);
    text[word.length] = 0;
    if (strspn(text, "+-.0123456789eE") == (size_t)word.length) {
      *number = strtod_l(text, &end, scan->plain);
      if (end == text + word.length && isfinite(*number)) return true;
    }
  }

  lam_error_add(scan->errors, scan->location, NULL, "%s: \"%.*s\" is not a number", what,
                lam_word_shown(word), word.text);
  return false;
}

/* Digits alone: no sign, no point. */
bool lam_scan_count(lam_scan *scan, lam_word word, const char *what, int *number) {
  long long value = 0;
  bool good = word.length > 0;
  for (int i = 0; i < word.length && good; i++) {
    good = word.text[i] >= '0' && word.text[i] <= '9';
    value = 10 * value + (word.text[i] - '0');
    good = good && value <= INT_MAX;
  }

  if (good)
    *number = (int)value;
  else
    lam_error_add(scan->errors, scan->location, NULL, "%s: \"%.*s\" is not a number from 0 to %d",
                  what, lam_word_shown(word), word.text, INT_MAX);
  return good;
}

bool lam_scan_next(lam_scan *scan, const char *what, lam_word *word) {
  while (!lam_scan_word(scan, word))
    if (!lam_scan_line(scan)) {
      lam_error_add(scan->errors, scan->location, NULL, "the file ends where %s is expected", what);
      return false;
    }
  return true;
}

/* Says how many of the three numbers were given. */
bool lam_scan_point(lam_scan *scan, const char *what, lam_vec3 *point) {
  double xyz[3];
  for (int k = 0; k < 3; k++) {
    lam_word word;
    if (!lam_scan_word(scan, &word)) {
      lam_error_add(scan->errors, scan->location, NULL, "%s: %d numbers given, 3 expected", what,
                    k);
      return false;
    }
    if (!lam_scan_number(scan, word, what, &xyz[k])) return false;
  }

  *point = lam_v3(xyz[0], xyz[1], xyz[2]);
  return true;
}

bool lam_scan_gave_up(const lam_scan *scan) {
  return scan->errors->count - scan->errors_before >= LAM_MOST_MESSAGES;
}
bool lam_scan_failed(const lam_scan *scan) { return scan->errors->count > scan->errors_before; }
