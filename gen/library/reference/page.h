/* Reference pages, generated from registry rows and key tables. Called by reference.c. */
#ifndef LAM_LIBRARY_REFERENCE_PAGE_H
#define LAM_LIBRARY_REFERENCE_PAGE_H

#include "core/text.h"
#include "library/reference/sections.h"

/* Appends the page of one entry of a section, wrapped at LAM_PAGE_WIDTH columns. */
void lam_page_entry(lam_text *text, const lam_section *section, const lam_listed *entry);
/* Appends a table of keys (ended by one without a name) with types, units, defaults, ranges,
 * choices and docs, all of it indented by so many columns; nested tables follow their key, indented
 * more. */
void lam_page_keys(lam_text *text, const lam_key *keys, int indent);

#endif
