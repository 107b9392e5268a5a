/* The time that passes, for time limits (core/process.c) and the seconds of a report
 * (design/stage_clock.c). */
#ifndef LAM_CORE_CLOCK_H
#define LAM_CORE_CLOCK_H

#include <time.h>

/* Seconds since a moment in the past that stays the same while the machine runs: only differences
 * mean something. Setting the date does not change them. */
static inline double lam_clock_seconds(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
