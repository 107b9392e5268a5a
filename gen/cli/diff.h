/* The two comparisons behind `lamella diff`. */
#ifndef LAM_CLI_DIFF_H
#define LAM_CLI_DIFF_H

#include <lamella/solid.h>

typedef struct lam_diff_request {
  const char *paths[2];
  double tolerance; /* negative: the default of the kind of file */
  const char *mask; /* NULL: none */
  bool json;
} lam_diff_request;

/* Both print their result on stdout and return the exit status. */
int lam_diff_meshes(lam_session *session, const lam_diff_request *request);
int lam_diff_pictures(lam_session *session, const lam_diff_request *request);

#endif
