/* Running text for the terminal. */
#ifndef LAM_LIBRARY_REFERENCE_WRAP_H
#define LAM_LIBRARY_REFERENCE_WRAP_H

#include "core/text.h"

enum { LAM_PAGE_WIDTH = 80 };

/* Appends words, wrapped at LAM_PAGE_WIDTH columns and ended by a newline. The line that text ends
 * with goes on at column; later lines are indented. */
void lam_wrap(lam_text *text, const char *words, int column, int indent);
/* The columns that UTF-8 text takes. */
int lam_columns(const char *words);
/* Appends spaces; nothing when count is not positive. */
void lam_spaces(lam_text *text, int count);

#endif
