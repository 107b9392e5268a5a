/* Outside programs: exit status, output, environment, folder, timeout, and the message when one is
 * missing. The programs are those that POSIX requires (sh, printf, pwd, sleep, cat). */
#include "core/process.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

typedef struct bench {
  lam_arena *arena;
  lam_errors errors;
  lam_text output;
} bench;

static int set_up(void **state) {
  bench *b = calloc(1, sizeof *b);
  b->arena = lam_arena_new();
  b->errors.arena = b->output.arena = b->arena;
  *state = b;
  return 0;
}

static int tear_down(void **state) {
  bench *b = *state;
  lam_arena_free(b->arena);
  free(b);
  return 0;
}

/* Runs sh -c script: a shell because the test asks for one, not the library. */
static lam_status run_script(bench *b, const char *script, lam_process process, int *code) {
  const char *arguments[] = {"sh", "-c", script, NULL};
  process.arguments = arguments;
  process.output = &b->output;
  return lam_process_run(&process, code, &b->errors);
}

static void exit_status_is_returned(void **state) {
  bench *b = *state;
  int code = -1;
  assert_int_equal(run_script(b, "exit 7", (lam_process){0}, &code), LAM_OK);
  assert_int_equal(code, 7);
  assert_int_equal(run_script(b, "kill -9 $$", (lam_process){0}, &code), LAM_OK);
  assert_int_equal(code, 128 + 9);
  assert_int_equal(b->errors.count, 0);
}

static void arguments_are_never_seen_by_a_shell(void **state) {
  bench *b = *state;
  const char *arguments[] = {"printf", "%s|", "a b", "$(id)", "*", "';\"", "", NULL};
  const lam_process process = {.arguments = arguments, .output = &b->output};
  int code = -1;
  assert_int_equal(lam_process_run(&process, &code, &b->errors), LAM_OK);
  assert_int_equal(code, 0);
  assert_string_equal(b->output.data, "a b|$(id)|*|';\"||");
}

/* 300,000 bytes are more than a pipe holds (65,536): nothing is lost and nobody waits forever. */
static void long_output_is_collected(void **state) {
  bench *b = *state;
  int code = -1;
  assert_int_equal(
      run_script(b,
                 "i=0; while [ $i -lt 30000 ]; do echo 123456789; i=$((i+1)); done; echo end >&2",
                 (lam_process){0}, &code),
      LAM_OK);
  assert_int_equal(code, 0);
  assert_int_equal(b->output.length, 300000 + 4);
  assert_string_equal(b->output.data + 300000, "end\n");
}

static void environment_is_added_and_replaced(void **state) {
  bench *b = *state;
  setenv("LAM_TEST_OLD", "old", 1);
  setenv("LAM_TEST_KEPT", "kept", 1);
  const char *additions[] = {"LAM_TEST_OLD=new", "LAM_TEST_MORE=a b", NULL};
  int code = -1;
  assert_int_equal(run_script(b, "echo \"$LAM_TEST_OLD/$LAM_TEST_MORE/$LAM_TEST_KEPT\"",
                              (lam_process){.environment = additions}, &code),
                   LAM_OK);
  assert_string_equal(b->output.data, "new/a b/kept\n");
  assert_string_equal(getenv("LAM_TEST_OLD"), "old");
}

static void folder_and_output_file_are_used(void **state) {
  bench *b = *state;
  char dir[] = "/tmp/lam_process_XXXXXX";
  assert_non_null(mkdtemp(dir));
  const char *path = lam_arena_printf(b->arena, "%s/out", dir);
  int code = -1;
  lam_process process = {.directory = dir, .output_path = path};
  assert_int_equal(run_script(b, "pwd -P; echo aside >&2", process, &code), LAM_OK);
  char line[200] = "";
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  assert_non_null(fgets(line, sizeof line, file));
  fclose(file);
  line[strcspn(line, "\n")] = 0;
  assert_string_equal(line, realpath(dir, lam_arena_alloc(b->arena, 4096, 1)));
  assert_string_equal(b->output.data, "aside\n");
  process.directory = lam_arena_printf(b->arena, "%s/none", dir);
  assert_int_equal(run_script(b, "true", process, &code), LAM_IO);
  assert_non_null(strstr(b->errors.last->text, "no such folder"));
  unlink(path);
  rmdir(dir);
}

static void input_is_empty(void **state) {
  bench *b = *state;
  const char *arguments[] = {"cat", NULL};
  int code = -1;
  assert_int_equal(
      lam_process_run(&(lam_process){.arguments = arguments, .timeout = 20}, &code, &b->errors),
      LAM_OK);
  assert_int_equal(code, 0);
}

/* The children of the program hold its pipe: they have to end as well. */
static void timeout_ends_the_program_and_its_children(void **state) {
  bench *b = *state;
  struct timespec from, to;
  clock_gettime(CLOCK_MONOTONIC, &from);
  assert_int_equal(run_script(b, "sleep 50 & sleep 50", (lam_process){.timeout = 0.2}, NULL),
                   LAM_FAILED);
  clock_gettime(CLOCK_MONOTONIC, &to);
  assert_true(to.tv_sec - from.tv_sec < 20);
  assert_string_equal(b->errors.last->text, "sh: stopped after 0.2 s");
  /* closing the output is not ending */
  assert_int_equal(run_script(b, "exec >&- 2>&-; sleep 50", (lam_process){.timeout = 0.2}, NULL),
                   LAM_FAILED);
}

/* Descriptors that this process has open. */
static int open_descriptors(void) {
  int count = 0;
  for (int i = 0; i < 256; i++) count += fcntl(i, F_GETFD) >= 0;
  return count;
}

/* Runs a program that says much and goes on for ever, until memory for what it says runs out. The
 * arena of the output is the one that is released. */
static void say_too_much(lam_arena *arena) {
  jmp_buf point;
  lam_errors errors = {.arena = arena};
  lam_text output = {.arena = arena};
  const char *arguments[] = {"sh", "-c", "yes | head -c 3000000; exec sleep 100", NULL};
  const lam_process process = {.arguments = arguments, .output = &output};
  if (!LAM_ARENA_TRY(arena, point)) return;
  lam_alloc_fail_after(2);
  lam_process_run(&process, NULL, &errors);
  fail_msg("memory did not run out");
}

/* A jump neither leaves the program running nor its pipe open. waitpid finds no child any more. */
static void memory_that_runs_out_ends_the_program(void **state) {
  (void)state;
  int before = open_descriptors();
  lam_arena *arena = lam_arena_new();
  say_too_much(arena);
  lam_alloc_fail_after(-1);
  lam_arena_free(arena);
  assert_int_equal(open_descriptors(), before);
  assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
}

static void missing_program_names_its_package(void **state) {
  bench *b = *state;
  const char *arguments[] = {"no-such-program-here", NULL};
  lam_process process = {.arguments = arguments, .package = "nowhere-pkg"};
  assert_int_equal(lam_process_run(&process, NULL, &b->errors), LAM_MISSING_PROGRAM);
  assert_int_equal(b->errors.count, 1);
  assert_string_equal(b->errors.last->text,
                      "no-such-program-here is not installed (Debian package nowhere-pkg)");
  assert_false(lam_process_exists("no-such-program-here"));
  assert_false(lam_process_exists("/etc"));
  assert_false(lam_process_exists("/etc/passwd"));
  assert_false(lam_process_exists(""));
  assert_true(lam_process_exists("sh"));
}

int main(void) {
#define CASE(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)
  const struct CMUnitTest tests[] = {
      CASE(exit_status_is_returned),
      CASE(arguments_are_never_seen_by_a_shell),
      CASE(long_output_is_collected),
      CASE(environment_is_added_and_replaced),
      CASE(folder_and_output_file_are_used),
      CASE(input_is_empty),
      CASE(timeout_ends_the_program_and_its_children),
      CASE(memory_that_runs_out_ends_the_program),
      CASE(missing_program_names_its_package),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
