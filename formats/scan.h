/* Words, lines and numbers of a text file that is being read. Used by the readers of OBJ, OFF,
 * PLY, STL and points (formats/mesh), IGES (formats/iges) and STEP (formats/step). */
#ifndef LAM_FORMATS_SCAN_H
#define LAM_FORMATS_SCAN_H

#include "core/error.h"
#include "core/vec3.h"
#include <locale.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct lam_word {
  const char *text; /* in the bytes that are read; not terminated */
  int length;
} lam_word;

typedef struct lam_scan {
  const char *at, *end;
  lam_location location; /* its line is the current one, from 1 */
  lam_errors *errors;
  int errors_before; /* messages that were there when reading began */
  locale_t plain;    /* numbers with a decimal point; closed with the arena */
  bool joins; /* a backslash at the end of a line joins the next one to it, but not in comments;
                 set behind lam_scan_begin by readers of languages that have this (OBJ) */
} lam_scan;

/* The bytes of the line end that text begins with: LF, CR LF, or CR alone; 0: there is none. */
int lam_line_end(const char *at, const char *end);

/* The bytes of the byte order mark of UTF-8 that a text begins with, 3 or 0. */
int lam_utf8_mark(const char *bytes, size_t count);

/* Starts reading count bytes, which must stay as long as the scan and its words are used; they need
 * not be terminated. A byte order mark of UTF-8 is passed over. Messages go to errors, with
 * location's file and the current line. */
lam_scan lam_scan_begin(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                        lam_errors *errors);
/* The next word of the current line; false at its end. Words are parted by blanks; a # starts a
 * comment, which ends with the line. */
bool lam_scan_word(lam_scan *scan, lam_word *word);
/* Goes to the next line; false at the end of the text. */
bool lam_scan_line(lam_scan *scan);
/* Whether the word is this text, upper or lower case. */
bool lam_word_is(lam_word word, const char *text);
/* How many letters of the word a message shows: all, but at most 40. For "%.*s". */
int lam_word_shown(lam_word word);
/* The word as a finite decimal number; otherwise false, with a message that begins with `what`. */
bool lam_scan_number(lam_scan *scan, lam_word word, const char *what, double *number);
/* The word as a whole number, from 0 to the largest int; otherwise false, with a message as
 * above. */
bool lam_scan_count(lam_scan *scan, lam_word word, const char *what, int *number);
/* The next word, wherever lines end; false at the end of the text, with a message that `what` is
 * missing. */
bool lam_scan_next(lam_scan *scan, const char *what, lam_word *word);
/* Three numbers from the current line, as they stand; otherwise false, with a message that begins
 * with `what`, and the point is left as it was. */
bool lam_scan_point(lam_scan *scan, const char *what, lam_vec3 *point);
/* Whether so many messages (20) were added that reading on would help nobody. */
bool lam_scan_gave_up(const lam_scan *scan);
/* Whether a message was added since lam_scan_begin. */
bool lam_scan_failed(const lam_scan *scan);

#endif
