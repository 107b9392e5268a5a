/* How fast the library is on this machine. */
#ifndef LAMELLA_BENCH_H
#define LAMELLA_BENCH_H

#include <lamella/session.h>
#include <stdio.h>

LAM_BEGIN_DECLS

typedef struct lam_bench_options {
  bool json;          /* an array of results instead of tables */
  const char *net;    /* this kind of net alone; NULL: everything */
  int most;           /* no nets with more vertices; 0: 41,000 */
  const char *folder; /* has bench_wavy_69x70.obj and bench_torus_69x70.obj */
} lam_bench_options;

/* Runs the benchmark, for minutes, and writes tables or JSON as it goes. Times are the least of
 * several runs, or ratios measured in one run. LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY. */
LAM_API lam_status lam_bench_run(lam_session *session, const lam_bench_options *options, FILE *out);

LAM_END_DECLS

#endif
