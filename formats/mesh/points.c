/* The reader `points` (listed in formats/list/formats.c): surveys and scans as text files, one
 * point in a line: x, y and z, separated by spaces, tabs, semicolons or commas. What follows them
 * (colors, intensity) is not read, nor are empty lines, comments after # and a first line that is
 * no point (names of columns, a number of points). Called through the list of formats by
 * gen/library/read_files.c. */
#include "formats/format.h"
#include "formats/scan.h"
#include <string.h>

enum { WORDS = 3 };

/* Whether a comma stands inside a word. Commas between digits separate numbers only when nothing
 * else does: "1.5,2,3". In "1,5 2 3" they are decimal commas. */
static bool has_inner_comma(lam_word word) {
  for (int i = 1; i + 1 < word.length; i++)
    if (word.text[i] == ',') return true;
  return false;
}

/* The first three words of the current line, parted by blanks and commas. Returns their number;
 * -1: decimal commas. */
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

/* Whether a word has only letters that numbers have; it need not be a number. */
static bool is_number(lam_word word) {
  for (int i = 0; i < word.length; i++)
    if (!strchr("+-.0123456789eE", word.text[i])) return false;
  return word.length > 0;
}

/* Whether the first line that is not empty may be skipped: a single word, or one that is no
 * number. */
static bool is_heading(const lam_word *words, int count) {
  return count == 1 || (count > 0 && !is_number(words[0]));
}

/* The current line as a point. first: it is the first that is not empty. Returns 1 when there is
 * a point, 0 for a line to pass over or with a message, -1 with a message that will hold for all
 * lines. */
static int read_point(lam_scan *scan, bool *first, lam_vec3 *point) {
  lam_word words[WORDS];
  int given = split(scan, words);
  double x[WORDS] = {0};
  if (given == 0) return 0;

  bool heading = *first && is_heading(words, given);
  *first = false;
  if (heading) return 0;

  if (given < 0) {
    lam_error_add(scan->errors, scan->location, NULL,
                  "numbers with a comma given; expected a decimal point");
    return -1;
  }
  if (given < WORDS) {
    lam_error_add(scan->errors, scan->location, NULL, "%d number%s given; expected x, y and z",
                  given, given == 1 ? "" : "s");
    return 0;
  }

  for (int i = 0; i < WORDS; i++)
    if (!lam_scan_number(scan, words[i], "coordinate", &x[i])) return 0;
  *point = lam_v3(x[0], x[1], x[2]);
  return 1;
}

/* Semicolons become blanks in a copy of the text; there are at most as many points as lines. */
static bool read_points(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                        lam_errors *errors, int *point_count, const lam_vec3 **points) {
  char *text = LAM_NEW(arena, char, count + 1);
  int lines = 1;
  for (size_t i = 0; i < count; i++) {
    text[i] = bytes[i] == ';' ? ' ' : bytes[i];
    lines += bytes[i] == '\n' || bytes[i] == '\r';
  }
  lam_vec3 *list = LAM_NEW(arena, lam_vec3, lines);
  lam_scan scan = lam_scan_begin(arena, text, count, location, errors);

  int found = 0;
  bool first = true;
  int given;
  do {
    given = read_point(&scan, &first, &list[found]);
    found += given > 0;
  } while (given >= 0 && !lam_scan_gave_up(&scan) && lam_scan_line(&scan));

  if (found == 0 && !lam_scan_failed(&scan))
    lam_error_add(errors, location, NULL, "the file has no points");
  *point_count = found;
  *points = list;
  return !lam_scan_failed(&scan) && found > 0;
}

const lam_format lam_format_points = {
    .name = "points",
    .doc = "Points of a survey or scan, one in a line (x y z)",
    .ending = "xyz pts csv txt asc",
    .read_points = read_points,
};
