/* Rules for make: what a build was made from. Called by models.c. */
#ifndef LAM_LIBRARY_WRITE_MAKE_RULE_H
#define LAM_LIBRARY_WRITE_MAKE_RULE_H

#include "library/session_state.h"
#include "library/write/write_files.h"

/* Writes a rule to path: folder/report.json depends on the design, the files that it named and the
 * templates. origin may be NULL: then on the templates alone. What fails is a message of the
 * session. */
void lam_make_rule_write(lam_session *session, const char *path, const char *folder,
                         const lam_origin *origin, const lam_paths *templates);

#endif
