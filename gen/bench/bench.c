/* lamella bench: how fast the solver is. Times are the least of several runs, or ratios measured in
 * one run. */
#include "bench/bench.h"
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: lamella bench [--json] [--net KIND] [--most VERTICES] [FOLDER]\n"
    "  --json           an array of results instead of tables\n"
    "  --net KIND       this kind of net alone\n"
    "  --most VERTICES  no nets that are larger (default: 41000)\n"
    "  FOLDER           has bench_wavy_69x70.obj and bench_torus_69x70.obj (default: "
    "tests/cases/nets)";

static bool read_options(lam_bench *bench, int argc, char **argv, bool *json) {
  for (int i = 1; i < argc; i++) {
    const char *value = i + 1 < argc ? argv[i + 1] : NULL;
    char *end;
    if (strcmp(argv[i], "--json") == 0) {
      *json = true;
    } else if (strcmp(argv[i], "--net") == 0 && value) {
      if (!lam_registry_find(&lam_nets, value)) {
        lam_complain_plain(2, "bench: there is no net called %s; lamella list nets shows them",
                           value);
        return false;
      }
      bench->only = argv[++i];
    } else if (strcmp(argv[i], "--most") == 0 && value) {
      bench->most = (int)strtol(argv[++i], &end, 10);
      if (*end || bench->most < 1) {
        lam_complain_plain(2, "bench: --most %s; expected a number of vertices", value);
        return false;
      }
    } else if (argv[i][0] != '-' && i == argc - 1) {
      bench->folder = argv[i];
    } else {
      lam_complain_plain(2, "bench: %s is not expected here\n%s", argv[i], usage);
      return false;
    }
  }
  return true;
}

static int bench(lam_arena *arena, int argc, char **argv) {
  lam_errors errors = {.arena = arena};
  lam_bench b = {.arena = arena, .errors = &errors, .folder = "tests/cases/nets", .most = 41000};
  bool json = false;
  if (argc == 2 && strcmp(argv[1], "--help") == 0) return puts(usage) < 0;
  if (!read_options(&b, argc, argv, &json)) return 2;
  if (json)
    b.json = json_array();
  else
    printf("dense kernels: %s%s%s\n", lam_blas_kernel(), lam_blas_advice() ? "; " : "",
           lam_blas_advice() ? lam_blas_advice() : "");
  bool done = b.only || (lam_bench_factor(&b) && lam_bench_surfaces(&b) && lam_bench_quads(&b));
  if (done && !b.only) lam_bench_developable(&b);
  done = done && lam_bench_thesis(&b) && lam_bench_sizes(&b);
  if (json && done) {
    json_dumpf(b.json, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    puts("");
  }
  json_decref(b.json);
  return done ? 0 : lam_complain(&errors);
}

int lam_verb_bench(int argc, char **argv) { return lam_verb_run(bench, argc, argv); }
