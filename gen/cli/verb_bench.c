/* lamella bench: how fast the library is on this machine. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/bench.h>

#include <stdio.h>
#include <stdlib.h>

static const char usage[] =
    "usage: lamella bench [--json] [--net KIND] [--most VERTICES] [FOLDER]\n"
    "  --json           an array of results instead of tables\n"
    "  --net KIND       this kind of net alone\n"
    "  --most VERTICES  no nets that are larger (default: 41000)\n"
    "  FOLDER           has bench_wavy_69x70.obj and bench_torus_69x70.obj (default: "
    "tests/cases/nets)";

/* Reads the request and runs it; an unknown kind of net is a wrong use, told like one. */
static int bench(lam_session *session, int argc, char **argv) {
  const char *most = NULL;
  lam_bench_options options = {.folder = "tests/cases/nets"};
  const lam_option table[] = {{"--json", .flag = &options.json},
                              {"--net", .value = &options.net},
                              {"--most", .value = &most},
                              {.name = NULL}};
  lam_arguments arguments = {usage, table, 0, 1, "a folder"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &options.folder, &count);
  if (status >= 0) return status;

  char *end = NULL;
  if (most) options.most = (int)strtol(most, &end, 10);
  if (most && (*end || options.most < 1))
    return lam_complain_plain(2, "bench: --most %s; expected a number of vertices", most);

  lam_status done = lam_bench_run(session, &options, stdout);
  if (done == LAM_BAD_INPUT) return lam_complain_verb(2, "bench", session, NULL);
  return lam_verb_status(session, done);
}

int lam_verb_bench(int argc, char **argv) { return lam_verb_run(bench, argc, argv); }
