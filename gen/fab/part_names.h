/* Names of parts: each is that of one part alone, for files, sheets and tables go by it. Called by
 * fab/parts and fab/lamella for every part, and by design/parts_stage.c. */
#ifndef LAM_FAB_PART_NAMES_H
#define LAM_FAB_PART_NAMES_H

#include "fab/workshop.h"

/* Letters for the names of a row, such as P in P07: `first`, or the next ones up to Z, then AA, AB
 * and so on, that stand before no number in the name of a part. Owned by the workshop's arena. */
const char *lam_part_letters(const lam_workshop *workshop, char first);
/* A name that no part has: wanted itself, or with a number from 2 on behind it, as in bolt-M8-2.
 * Kept by pointer, or owned by the workshop's arena. */
const char *lam_part_name(const lam_workshop *workshop, const char *wanted);
/* The first name that two parts have; NULL: there is none. */
const char *lam_part_name_twice(const lam_workshop *workshop);

#endif
