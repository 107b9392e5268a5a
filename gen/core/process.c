/* Outside programs: found in PATH, started with their output on a pipe, ended when their time is
 * up, or with the process. Called by library/. */
#include "core/process.h"
#include "core/clock.h"
#include "core/leftover.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static const lam_location nowhere;

/* ---- finding the program ---- */

/* A plain file that this user may execute. */
static bool is_program(const char *path) {
  struct stat facts;
  return stat(path, &facts) == 0 && S_ISREG(facts.st_mode) && access(path, X_OK) == 0;
}

/* Searched as the shell does: a program with a slash is a path, any other one is looked up in each
 * folder of PATH in turn. */
bool lam_process_exists(const char *program) {
  if (strchr(program, '/')) return is_program(program);

  const char *path = getenv("PATH");
  while (path && *program) {
    /* An empty entry of PATH stands for the current folder. */
    size_t length = strcspn(path, ":");
    char candidate[PATH_MAX];
    int written =
        snprintf(candidate, sizeof candidate, "%.*s/%s", (int)length, length ? path : ".", program);
    if (length == 0) written = snprintf(candidate, sizeof candidate, "./%s", program);

    if (written > 0 && (size_t)written < sizeof candidate && is_program(candidate)) return true;
    path = path[length] ? path + length + 1 : NULL;
  }
  return false;
}

/* Says that the program is not installed, and in which package it is when the caller knows. Returns
 * the status, which is that of the errors too. */
static lam_status report_missing(const lam_process *process, lam_errors *errors) {
  const char *program = process->arguments[0];
  if (process->package) {
    lam_error_add(errors, nowhere, NULL, "%s is not installed (Debian package %s)", program,
                  process->package);
  } else {
    lam_error_add(errors, nowhere, NULL, "%s is not installed", program);
  }
  return errors->status = LAM_MISSING_PROGRAM;
}

/* ---- environment ---- */

/* Whether a and b, both "NAME=value", are of the same variable. */
static bool same_name(const char *a, const char *b) {
  size_t length = strcspn(a, "=");
  return strncmp(a, b, length) == 0 && b[length] == '=';
}

/* The environment of this process with the additions, which replace variables of the same name.
 * NULL-terminated, in arena; own variables are kept by pointer. additions may be NULL. */
static char **merge_environment(lam_arena *arena, const char *const *additions) {
  size_t own = 0, more = 0, count = 0;
  while (environ[own]) own++;
  while (additions && additions[more]) more++;

  char **merged = LAM_NEW(arena, char *, own + more + 1);
  for (size_t i = 0; i < own; i++) {
    bool replaced = false;
    for (size_t k = 0; k < more; k++) replaced |= same_name(additions[k], environ[i]);
    if (!replaced) merged[count++] = environ[i];
  }

  for (size_t k = 0; k < more; k++) merged[count++] = lam_arena_copy(arena, additions[k]);
  return merged;
}

/* ---- running ---- */

/* A program that runs: what has to be closed and ended when control jumps away. */
typedef struct running {
  pid_t pid;    /* 0: none any more */
  int pipe_end; /* -1: closed */
  int leftover; /* its place in core/leftover.h */
} running;

/* Closes the pipe, and ends the whole process group when its leader was not waited for. Called with
 * the arena's memory when it runs out on the way; a second call does nothing. */
static void end_running(void *handle) {
  running *r = handle;
  if (r->pipe_end >= 0) close(r->pipe_end);
  r->pipe_end = -1;
  if (r->pid <= 0) return;

  kill(-r->pid, SIGKILL);
  while (waitpid(r->pid, NULL, 0) < 0 && errno == EINTR) continue;
  lam_leftover_forget(r->leftover);
  r->pid = 0;
}

/* Makes descriptor `from` the standard one `to`. Returns false with errno. */
static bool redirect(int from, int to) { return from >= 0 && dup2(from, to) == to; }

/* What the child does before it is the program; returns only when something fails, with errno. It
 * leads a process group of its own, so that a timeout ends what it started too, and it dies with
 * the thread that started it: nobody else would read what it says. The memory is still the
 * parent's: nothing here may change it. */
static void become_program(const lam_process *process, char **environment, int pipe_end,
                           pid_t parent, const sigset_t *mask) {
  if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return;
  if (getppid() != parent) _exit(127); /* it died before this could be asked for */

  int output = pipe_end;
  if (process->output_path)
    output = open(process->output_path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (!redirect(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO)) return;
  if (!redirect(output, STDOUT_FILENO) || !redirect(pipe_end, STDERR_FILENO)) return;

  /* Behind the output file, whose path is relative to the folder of this process. */
  if (process->directory && chdir(process->directory) != 0) return;

  /* Handlers of the parent must not run here. */
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  signal(SIGHUP, SIG_DFL);
  sigprocmask(SIG_SETMASK, mask, NULL);
  execvpe(process->arguments[0], (char *const *)process->arguments, environment);
}

/* Starts the program with its stdout and stderr on pipe_end (stdout in the output file when there
 * is one). Returns 0 with *pid, or an error number. vfork: no copy of a large process is made, and
 * handlers of other libraries for fork are not run; the child sets `error` in the shared memory. */
static int start(const lam_process *process, char **environment, int pipe_end, pid_t *pid) {
  sigset_t all, mask;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &mask);

  volatile int error = 0;
  pid_t parent = getpid(), child = vfork();
  if (child == 0) {
    become_program(process, environment, pipe_end, parent, &mask);
    error = errno;
    _exit(127);
  }
  if (child < 0) error = errno;
  pthread_sigmask(SIG_SETMASK, &mask, NULL);

  if (child > 0 && error) waitpid(child, NULL, 0);
  *pid = child;
  return error;
}

/* How long to wait for the pipe: milliseconds, rounded up so that the deadline is past afterwards;
 * -1 without a deadline (0); 0 when it is past. */
static int milliseconds_until(double deadline) {
  if (deadline <= 0) return -1;
  double left = deadline - lam_clock_seconds();
  if (left <= 0) return 0;
  return left > 1e6 ? 1000000000 : (int)(left * 1000) + 1;
}

/* Collects what comes through the pipe until its end. False when the time is up. */
static bool collect(const lam_process *process, int pipe_end, double deadline) {
  char bytes[4096];
  for (;;) {
    int wait_ms = milliseconds_until(deadline);
    if (wait_ms == 0) return false;

    struct pollfd ready = {.fd = pipe_end, .events = POLLIN};
    int found = poll(&ready, 1, wait_ms);
    if (found < 0 && errno != EINTR) return true;
    if (found <= 0) continue;

    ssize_t count = read(pipe_end, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    if (process->output) lam_text_bytes(process->output, bytes, (size_t)count);
    if (process->hear) process->hear(process->context, bytes, (size_t)count);
  }
}

/* Waits for the end of pid, and looks for it every 5 ms when there is a deadline (seconds, as
 * lam_clock_seconds; 0: none). False when the time is up: a program may close its output long
 * before it ends. */
static bool wait_for(pid_t pid, double deadline, int *status) {
  for (;;) {
    pid_t ended = waitpid(pid, status, deadline > 0 ? WNOHANG : 0);
    if (ended == pid || (ended < 0 && errno != EINTR)) return true;
    if (ended == 0) {
      if (lam_clock_seconds() >= deadline) return false;
      nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
    }
  }
}

/* Says why the program cannot be started. */
static lam_status fail_to_start(lam_errors *errors, const char *program, int reason) {
  lam_error_add(errors, nowhere, NULL, "%s: cannot be started: %s", program, strerror(reason));
  return errors->status = LAM_IO;
}

/* Whether the folder to start in is there; a message otherwise. */
static bool check_directory(const lam_process *process, lam_errors *errors) {
  struct stat facts;
  if (!process->directory) return true;
  if (stat(process->directory, &facts) == 0 && S_ISDIR(facts.st_mode)) return true;

  lam_error_add(errors, nowhere, NULL, "%s: no such folder to run %s in", process->directory,
                process->arguments[0]);
  errors->status = LAM_IO;
  return false;
}

/* Reads the output and waits for the end of a program that was started. An exhausted arena ends it
 * (end_running). */
static lam_status attend(const lam_process *process, running *r, int *exit_code,
                         lam_errors *errors) {
  double deadline = process->timeout > 0 ? lam_clock_seconds() + process->timeout : 0;
  int status = 0;
  if (!collect(process, r->pipe_end, deadline) || !wait_for(r->pid, deadline, &status)) {
    end_running(r);
    lam_error_add(errors, nowhere, NULL, "%s: stopped after %g s", process->arguments[0],
                  process->timeout);
    return errors->status = LAM_FAILED;
  }

  lam_leftover_forget(r->leftover);
  r->pid = 0;
  end_running(r);
  if (exit_code) *exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return LAM_OK;
}

/* The output is read until the pipe ends, and only then is the end of the program waited for: a
 * program that writes more than a pipe holds would never end otherwise. */
lam_status lam_process_run(const lam_process *process, int *exit_code, lam_errors *errors) {
  const char *program = process->arguments[0];
  if (!lam_process_exists(program)) return report_missing(process, errors);
  if (!check_directory(process, errors)) return LAM_IO;

  /* Memory first: running out of it jumps, and the arena closes what is open then. */
  char **environment = merge_environment(errors->arena, process->environment);
  running *r = LAM_NEW(errors->arena, running, 1);
  *r = (running){.pipe_end = -1, .leftover = -1};
  lam_arena_defer(errors->arena, end_running, r);

  /* Other programs that are started meanwhile do not inherit the pipe, and cannot hold it open. */
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return fail_to_start(errors, program, errno);
  r->pipe_end = ends[0];

  /* The program alone keeps the writing end: the pipe ends with it. */
  pid_t pid;
  int error = start(process, environment, ends[1], &pid);
  close(ends[1]);
  if (error) {
    end_running(r);
    return fail_to_start(errors, program, error);
  }

  r->pid = pid;
  r->leftover = lam_leftover_program(pid);
  return attend(process, r, exit_code, errors);
}
