#include "formats/mesh/points.h"
#include "formats/scan.h"
#include <string.h>

enum { WORDS = 3 };

/* Commas between digits separate numbers only when nothing else does: "1.5,2,3". In "1,5 2 3" they
 * are decimal commas.
 */
static bool has_inner_comma(lam_word word) {
  for (int i = 1; i + 1 < word.length; i++)
    if (word.text[i] == ',') return true;
  return false;
}

/* The first three words of the current line. Returns their number; -1: decimal commas. */
static int split(lam_scan *scan, lam_word words[WORDS]) {
  lam_word word;
  int count = 0, pieces = 0, with_comma = 0;
  while (lam_scan_word(scan, &word)) {
    pieces++;
    with_comma += has_inner_comma(word);
    for (int from = 0; from < word.length && count < WORDS;) {
      int to = from;
      while (to < word.length && word.text[to] != ',') to++;
      if (to > from) words[count++] = (lam_word){word.text + from, to - from};
      from = to + 1;
    }
  }
  return with_comma && pieces > 1 ? -1 : count;
}

static bool is_number(lam_word word) {
  for (int i = 0; i < word.length; i++)
    if (!strchr("+-.0123456789eE", word.text[i])) return false;
  return word.length > 0;
}

/* Whether a line that is the first may be skipped. */
static bool is_heading(const lam_word *words, int count) {
  return count == 1 || (count > 0 && !is_number(words[0]));
}

bool lam_points_parse(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors, int *point_count, const lam_vec3 **points) {
  char *text = LAM_NEW(arena, char, count + 1);
  int lines = 1;
  for (size_t i = 0; i < count; i++) {
    text[i] = bytes[i] == ';' ? ' ' : bytes[i];
    lines += bytes[i] == '\n';
  }
  lam_vec3 *list = LAM_NEW(arena, lam_vec3, lines);
  lam_scan scan = lam_scan_begin(arena, text, count, location, errors);
  int found = 0;
  bool first = true;
  do {
    lam_word words[WORDS];
    int given = split(&scan, words);
    double x[WORDS] = {0};
    if (given == 0) continue;
    if (first && is_heading(words, given)) given = 0;
    first = false;
    if (given == 0) continue;
    if (given < 0) {
      lam_error_add(errors, scan.location, NULL,
                    "numbers with a comma given; expected a decimal point");
      break; /* all lines will be so */
    }
    if (given < WORDS)
      lam_error_add(errors, scan.location, NULL, "%d number%s given; expected x, y and z", given,
                    given == 1 ? "" : "s");
    for (int i = 0; i < WORDS && given == WORDS; i++)
      if (!lam_scan_number(&scan, words[i], "coordinate", &x[i])) given = 0;
    if (given == WORDS) list[found++] = lam_v3(x[0], x[1], x[2]);
  } while (!lam_scan_gave_up(&scan) && lam_scan_line(&scan));
  if (found == 0 && !lam_scan_failed(&scan))
    lam_error_add(errors, location, NULL, "the file has no points");
  *point_count = found;
  *points = list;
  return !lam_scan_failed(&scan) && found > 0;
}
