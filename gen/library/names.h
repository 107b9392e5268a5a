/* Names that a person gives and that must be among others. Called by designs.c,
 * reference/reference.c and bench/bench.c. */
#ifndef LAM_LIBRARY_NAMES_H
#define LAM_LIBRARY_NAMES_H

#include "core/error.h"

#include <stdbool.h>

/* Whether given is one of names (NULL-terminated). Otherwise adds "WHAT given (did you mean
 * NAME?)", or "WHAT given; HINT" when none is near; hint may be NULL. */
bool lam_name_known(lam_errors *errors, const char *const *names, const char *given,
                    const char *what, const char *hint);

#endif
