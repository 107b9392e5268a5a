/* Outside programs: started here and nowhere else, with an argument vector and never through a
 * shell. Called by library/, which has pictures rendered and maps turned into PNG. */
#ifndef LAM_CORE_PROCESS_H
#define LAM_CORE_PROCESS_H

#include "core/error.h"
#include "core/text.h"

/* What to run; only arguments is required. Read only, and needed only during the call. */
typedef struct lam_process {
  const char *const *arguments;   /* NULL-terminated; [0] is the program: looked up in PATH when it
                                   * has no slash */
  const char *package;            /* Debian package that has the program, for the message; NULL: no
                                   * advice */
  const char *directory;          /* to start in; NULL: the current one */
  const char *const *environment; /* NULL-terminated additions "NAME=value"; NULL: none */
  const char *output_path;        /* file for stdout; NULL: collected in output */
  lam_text *output;               /* gets stdout (without output_path) and stderr, as they come;
                                   * NULL: dropped */
  void (*hear)(void *context, const char *bytes, size_t count); /* called with what output gets,
                                   * while the program runs; NULL: nobody listens */
  void *context;                  /* handed to hear */
  double timeout;                 /* seconds, after which the program is killed; 0: none */
} lam_process;

/* Runs the program to its end with an empty stdin.
 *
 *   LAM_OK               it ran: *exit_code is its exit status, or 128 + signal when a signal
 *                        ended it
 *   LAM_MISSING_PROGRAM  it is not installed: one message that names the package
 *   LAM_IO               the directory or the output file cannot be used, or there is no process
 *                        or pipe left: one message
 *   LAM_FAILED           it did not end within the timeout: one message
 *
 * The program does not outlive the process: it dies with the thread that called, whatever ends that
 * (on Linux), and with lam_leftovers_end. exit_code may be NULL. Keeps no pointer. One process at a
 * time per lam_text; otherwise safe in threads. */
lam_status lam_process_run(const lam_process *process, int *exit_code, lam_errors *errors);

/* Whether the program is found in PATH (or, with a slash, is an executable file). Called by
 * lam_process_run, and by tests alone. */
bool lam_process_exists(const char *program);

#endif
