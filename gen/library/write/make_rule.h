/* Rules for make: what a build was made from. Called by models.c. */
#ifndef LAM_LIBRARY_WRITE_MAKE_RULE_H
#define LAM_LIBRARY_WRITE_MAKE_RULE_H

#include "library/session_state.h"
#include "library/write/write_files.h"

/* Adds a message for every path of the rule that make has no way to name: those with ; = | % \ or
 * a control character. Arguments as below. */
void lam_make_rule_check(lam_session *session, const char *path, const char *folder,
                         const lam_origin *origin, const lam_output *output);
/* Writes a rule to path: folder/report.json depends on the design, the files that it named and the
 * templates. origin may be NULL: then on the templates alone. LAM_IO with a message. */
lam_status lam_make_rule_write(lam_session *session, const char *path, const char *folder,
                               const lam_origin *origin, const lam_output *output);

#endif
