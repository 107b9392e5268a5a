/* Words, lines and numbers of a text file that is being read. */
#ifndef LAM_FORMATS_MESH_SCAN_H
#define LAM_FORMATS_MESH_SCAN_H

#include "core/error.h"
#include "core/vec3.h"
#include <locale.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct lam_word {
  const char *text; /* not terminated */
  int length;
} lam_word;

typedef struct lam_scan {
  const char *at, *end;
  lam_location location; /* its line is the current one, from 1 */
  lam_errors *errors;
  int errors_before; /* that were there when reading began */
  locale_t plain;    /* numbers with a decimal point; closed with the arena */
} lam_scan;

/* Starts reading bytes, which must stay. */
lam_scan lam_scan_begin(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                        lam_errors *errors);
/* The next word of the current line; false at its end. A # starts a comment, which ends with the
 * line. */
bool lam_scan_word(lam_scan *scan, lam_word *word);
/* Goes to the next line; false at the end of the text. */
bool lam_scan_line(lam_scan *scan);
bool lam_word_is(lam_word word, const char *text);
/* A finite decimal number, or adds an error that names `what`. */
bool lam_scan_number(lam_scan *scan, lam_word word, const char *what, double *number);
/* Three numbers from the current line, or adds an error. */
bool lam_scan_point(lam_scan *scan, const char *what, lam_vec3 *point);
/* Whether so many errors were added that reading on would help nobody. */
bool lam_scan_gave_up(const lam_scan *scan);
/* Whether an error was added. */
bool lam_scan_failed(const lam_scan *scan);

#endif
