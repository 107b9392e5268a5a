/* How fast the library is on this machine. */
#ifndef LAMELLA_BENCH_H
#define LAMELLA_BENCH_H

#include <lamella/session.h>
#include <stdio.h>

LAM_BEGIN_DECLS

/* What to measure. Zeroed, with a folder, it is everything, as tables. Texts are only read. */
typedef struct lam_bench_options {
  bool json;          /* one array of results at the end instead of tables */
  const char *net;    /* this kind of net alone; NULL: everything */
  int most;           /* no nets with more vertices; 0: 41,000 */
  const char *folder; /* has bench_wavy_69x70.obj and bench_torus_69x70.obj; not NULL */
} lam_bench_options;

/* Runs the benchmark, for minutes, and writes tables to out as it goes, or JSON at its end. Times
 * are processor times of this thread: the least of several runs, or ratios measured in one run. A
 * net that does not converge is a result. out stays open.
 *
 *   LAM_BAD_INPUT  there is no net called options->net, or a mesh of the folder is none
 *   LAM_IO         a mesh of the folder cannot be read
 *   LAM_NO_MEMORY
 *
 * Tables that were complete before an error stay written; JSON is not written then. */
LAM_API lam_status lam_bench_run(lam_session *session, const lam_bench_options *options, FILE *out);

LAM_END_DECLS

#endif
