/* How a long computation tells what it is doing. The callback may be NULL. */
#ifndef LAM_CORE_PROGRESS_H
#define LAM_CORE_PROGRESS_H

#include <lamella/types.h>

static inline void lam_progress_tell(const lam_progress *progress, const char *stage,
                                     double fraction, const char *detail) {
  if (progress && progress->tell) progress->tell(progress->context, stage, fraction, detail);
}

#endif
