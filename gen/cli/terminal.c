/* The line of progress: stage, bar and detail. Called by verb_build.c. */
#include "cli/terminal.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum { bar_width = 20, refresh_ms = 80 };

/* Seconds since some moment in the past: only differences mean something. */
static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Writes the line over: a new stage at once, the same one at most every refresh_ms. stage NULL: the
 * line is cleared. */
static void tell(void *context, const char *stage, double fraction, const char *detail) {
  lam_terminal *t = context;
  if (!stage) {
    fputs("\r\033[K", stderr);
    return;
  }

  double time = now();
  if (stage == t->stage && time - t->told < refresh_ms * 1e-3) return;
  t->stage = stage;
  t->told = time;

  char bar[bar_width + 1];
  for (int i = 0; i < bar_width; i++)
    bar[i] = fraction >= 0 && i < fraction * bar_width ? '#' : '.';
  bar[bar_width] = 0;
  fprintf(stderr, "\r\033[K%-16s [%s] %s", stage, bar, detail ? detail : "");
}

/* A progress without a function tells nobody. */
lam_progress lam_terminal_progress(lam_terminal *terminal, bool quiet) {
  *terminal = (lam_terminal){0};
  if (quiet || !isatty(STDERR_FILENO)) return (lam_progress){0};
  return (lam_progress){tell, terminal};
}

void lam_terminal_clear(const lam_progress *progress) {
  if (progress->tell) progress->tell(progress->context, NULL, 1, "");
}
