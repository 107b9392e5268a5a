/* Unknown names get the nearest known one as a suggestion. Called by designs.c,
 * reference/reference.c and bench/bench.c. */
#include "library/names.h"

#include <string.h>

/* The hint is for a name that is not near to any. */
bool lam_name_known(lam_errors *errors, const char *const *names, const char *given,
                    const char *what, const char *hint) {
  for (int i = 0; names[i]; i++)
    if (strcmp(names[i], given) == 0) return true;

  const char *guess = lam_did_you_mean(given, names);
  if (guess)
    lam_error_add(errors, (lam_location){0}, NULL, "%s %s (did you mean %s?)", what, given, guess);
  else
    lam_error_add(errors, (lam_location){0}, NULL, "%s %s%s%s", what, given, hint ? "; " : "",
                  hint ? hint : "");
  return false;
}
