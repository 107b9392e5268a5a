/* What a build is made from is never overwritten or removed by what it makes. Called by
 * models.c. */
#ifndef LAM_LIBRARY_WRITE_INPUTS_KEPT_H
#define LAM_LIBRARY_WRITE_INPUTS_KEPT_H

#include "library/session_state.h"
#include "library/write/write_files.h"

/* Adds a message for every file of the plan, and for the make rule, whose path is that of an input
 * (the design, a file that it names, a template) or of a link to one, and for every folder below
 * the output folder that is a link.
 *
 *   origin  may be NULL: the templates alone are inputs
 *   deps    path of the make rule; NULL: none */
void lam_inputs_check(lam_session *session, const lam_origin *origin, const lam_output *output,
                      const char *folder, const char *deps);
/* Whether a path is that of an input, or of a link to one. */
bool lam_inputs_have(const lam_origin *origin, const lam_output *output, const char *path);

#endif
