/* Reference pages, generated from registry rows and key tables. */
#ifndef LAM_LIBRARY_REFERENCE_PAGE_H
#define LAM_LIBRARY_REFERENCE_PAGE_H

#include "core/text.h"
#include "library/reference/sections.h"

/* Appends the page of one entry, wrapped at 80 columns. */
void lam_page_entry(lam_text *text, const lam_section *section, const lam_listed *entry);
/* Appends a table of keys with types, units, defaults, ranges, choices and docs; nested tables
 * follow their key, indented. */
void lam_page_keys(lam_text *text, const lam_key *keys, int indent);

#endif
