/* Running text for the terminal. Called by the other files of this folder. */
#ifndef LAM_LIBRARY_REFERENCE_WRAP_H
#define LAM_LIBRARY_REFERENCE_WRAP_H

#include "core/text.h"

enum { LAM_PAGE_WIDTH = 80 }; /* columns */

/* Appends words, wrapped at LAM_PAGE_WIDTH columns and ended by a newline; blanks and newlines
 * between them count as one blank.
 *
 *   column  that the line reaches which text ends with: words go on there
 *   indent  columns before later lines */
void lam_wrap(lam_text *text, const char *words, int column, int indent);
/* The columns that UTF-8 text takes, one per character. */
int lam_columns(const char *words);
/* Appends spaces; nothing when count is not positive. */
void lam_spaces(lam_text *text, int count);

#endif
