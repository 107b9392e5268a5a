/* The line of progress: stage, bar and detail. Called by verb_build.c. */
#include "cli/terminal.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { bar_width = 20, refresh_ms = 80 };
static const double soon = 3; /* seconds of a stage, after which the time left is said */

/* The time left of a stage, judged by what is done: ", about 40 s left"; empty while nothing can be
 * said. */
static void say_time_left(char *text, size_t size, double spent, double fraction) {
  text[0] = 0;
  if (fraction <= 0 || spent < soon) return;
  double left = spent * (1 - fraction) / fraction;
  if (left < 90)
    snprintf(text, size, ", about %.0f s left", left);
  else
    snprintf(text, size, ", about %.0f min left", left / 60);
}

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
  bool same = strcmp(stage, t->stage) == 0;
  if (same && time - t->told < refresh_ms * 1e-3) return;
  if (!same) {
    snprintf(t->stage, sizeof t->stage, "%s", stage);
    t->began = time;
  }
  t->told = time;

  char bar[bar_width + 1];
  for (int i = 0; i < bar_width; i++)
    bar[i] = fraction >= 0 && i < fraction * bar_width ? '#' : '.';
  bar[bar_width] = 0;
  char left[40];
  say_time_left(left, sizeof left, time - t->began, fraction);
  fprintf(stderr, "\r\033[K%-16s [%s] %s%s", stage, bar, detail ? detail : "", left);
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
