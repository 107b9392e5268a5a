/* Parsed values back as text, for `lamella check`. Called by describe_design.c. */
#ifndef LAM_LIBRARY_REFERENCE_VALUE_TEXT_H
#define LAM_LIBRARY_REFERENCE_VALUE_TEXT_H

#include "core/key.h"
#include "core/text.h"

/* Appends "height 100 mm, pair 25 mm, joint {kind half-lap, ...}": the values of params, by their
 * table. Texts, rows and lists that are empty, and values that the design left to the program, are
 * skipped; of a list the first eight items are shown. keys may be NULL: nothing is appended. */
void lam_value_text(lam_text *text, const lam_key *keys, const void *params);

#endif
