/* The two comparisons behind `lamella diff`. Called by verb_diff.c. */
#ifndef LAM_CLI_DIFF_H
#define LAM_CLI_DIFF_H

#include <lamella/solid.h>

/* What was asked for. */
typedef struct lam_diff_request {
  const char *paths[2];
  double tolerance; /* meshes: millimeters; pictures: percent; negative: the default of the kind */
  const char *mask; /* of pictures: where to write the differing pixels; NULL: nowhere */
  bool json;
} lam_diff_request;

/* Both print their result on stdout and return the exit status: 0 the same, 1 different, 2 wrong
 * input (1 when a library failed or memory ran out), with the messages printed. */
int lam_diff_meshes(lam_session *session, const lam_diff_request *request);
int lam_diff_pictures(lam_session *session, const lam_diff_request *request);

#endif
