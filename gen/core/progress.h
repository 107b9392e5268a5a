/* How a long computation tells what it is doing. The callback may be NULL. */
#ifndef LAM_CORE_PROGRESS_H
#define LAM_CORE_PROGRESS_H

typedef struct lam_progress {
  /* stage: a few words; fraction: 0 to 1, negative when unknown; detail: for instance "iteration 3,
   * residual 1e-5". */
  void (*tell)(void *context, const char *stage, double fraction, const char *detail);
  void *context;
} lam_progress;

static inline void lam_progress_tell(const lam_progress *progress, const char *stage,
                                     double fraction, const char *detail) {
  if (progress && progress->tell) progress->tell(progress->context, stage, fraction, detail);
}

#endif
