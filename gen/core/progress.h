/* How a long computation tells what it is doing. Called by net, fab, design, library and cli. */
#ifndef LAM_CORE_PROGRESS_H
#define LAM_CORE_PROGRESS_H

#include <lamella/types.h>

/* Tells whoever watches: stage, fraction and detail as in lam_progress (lamella/types.h). Nothing
 * when progress, or its function, is NULL. */
static inline void lam_progress_tell(const lam_progress *progress, const char *stage,
                                     double fraction, const char *detail) {
  if (progress && progress->tell) progress->tell(progress->context, stage, fraction, detail);
}

#endif
