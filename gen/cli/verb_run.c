/* The session around a verb, and exit statuses. Called by all verb_*.c, diff_meshes.c and
 * diff_pictures.c. */
#include "cli/verb_run.h"
#include "cli/complain.h"

/* A verb is one session: nothing has to be freed on its way. */
int lam_verb_run(int (*verb)(lam_session *session, int argc, char **argv), int argc, char **argv) {
  lam_session *session;
  if (lam_session_new(&session) != LAM_OK) return lam_complain_plain(1, "out of memory");
  int status = verb(session, argc, argv);
  lam_session_free(session);
  return status;
}

/* Memory that ran out is told in the program's own form. */
int lam_verb_status(const lam_session *session, lam_status status) {
  if (status == LAM_OK) return 0;
  if (status == LAM_NO_MEMORY) return lam_complain_plain(1, "out of memory");
  lam_complain(session);
  return status == LAM_BAD_INPUT || status == LAM_IO ? 2 : 1;
}
