/* How fast the library is: the sections of `lamella bench` one after the other. Called through
 * lamella/bench.h by cli/verb_bench.c. */
#include "bench/bench.h"
#include "library/names.h"
#include "library/session_state.h"
#include "solve/factor/front.h"
#include <lamella/bench.h>

/* Tables as they come, or results for one array. One kind of net alone has no other sections than
 * those of nets. False with errors. */
static bool run_sections(lam_bench *bench) {
  if (!bench->json)
    fprintf(bench->out, "linear algebra: %s\n", lam_front_kernels_choose()->name);

  if (!bench->only) {
    if (!lam_bench_factor(bench) || !lam_bench_surfaces(bench) || !lam_bench_quads(bench))
      return false;
    lam_bench_developable(bench);
  }
  return lam_bench_thesis(bench) && lam_bench_sizes(bench);
}

/* Whether there is a kind of net with this name; a message otherwise. */
static bool is_net(lam_session *session, const char *name) {
  const char **names = LAM_NEW(session->arena, const char *, lam_nets.count + 1);
  for (int i = 0; i < lam_nets.count; i++) names[i] = lam_nets.rows[i]->name;
  return lam_name_known(&session->errors, names, name, "there is no net called",
                        "lamella list nets shows them");
}

static void release(void *handle) { json_decref(handle); }

/* The array of results is released with the session's memory, whatever happens before. */
static lam_status run(lam_session *session, const lam_bench_options *options, FILE *out) {
  enum { usual = 41000 };
  lam_bench bench = {.arena = session->arena,
                     .errors = &session->errors,
                     .folder = options->folder,
                     .only = options->net,
                     .most = options->most ? options->most : usual,
                     .json = options->json ? json_array() : NULL,
                     .out = out};
  if (bench.json) lam_arena_defer(session->arena, release, bench.json);
  if (bench.only && !is_net(session, bench.only)) return LAM_OK;

  if (run_sections(&bench) && bench.json) {
    json_dumpf(bench.json, out, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    fputc('\n', out);
  }
  return LAM_OK;
}

/* Declared in include/lamella/bench.h. */
lam_status lam_bench_run(lam_session *session, const lam_bench_options *options, FILE *out) {
  LAM_ENTER(session);
  return lam_session_leave(session, run(session, options, out));
}
