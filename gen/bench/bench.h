/* What the parts of `lamella bench` share. */
#ifndef LAM_BENCH_BENCH_H
#define LAM_BENCH_BENCH_H

#include "net/optimize.h"

#include <jansson.h>
#include <stdio.h>

/* A start from which a kind of net is known to converge: the mesh of a surface with some noise. */
typedef struct lam_bench_start {
  const char *kind;    /* of the net registry */
  const char *keys;    /* of the net, as in a design: "orthogonal: yes", or "" */
  const char *surface; /* as in a design */
  double noise;        /* mean edges */
  double aspect;       /* vertices along the first family over those along the second */
  const char *measure; /* that proves the net */
} lam_bench_start;
extern const lam_bench_start lam_bench_starts[];
extern const int lam_bench_start_count;

typedef struct lam_bench {
  lam_arena *arena;
  lam_errors *errors;
  const char *folder; /* of the meshes */
  const char *only;   /* a kind of net, or NULL: all */
  int most;           /* vertices */
  json_t *json;       /* the array that results go to, or NULL: tables are written */
  FILE *out;          /* for tables */
} lam_bench;

/* What is solved. */
typedef struct lam_bench_case {
  const char *kind, *keys;
  const char *solver;  /* as in a design */
  const char *surface; /* NULL: the mesh */
  const char *mesh;    /* name in the folder */
  int grid[2];         /* cells */
  double noise;
  const char *measure; /* NULL: none */
  int repeats;         /* the least time of so many runs counts */
} lam_bench_case;

typedef struct lam_bench_result {
  int vertices, unknowns;
  int iterations, factorizations; /* rejected steps are factorized too */
  bool converged;
  char reason[100];
  double residual;
  double analysis, assembly, factor, solve; /* seconds: once; per factorization */
  double step;           /* seconds of all three: a step that is taken or rejected */
  double total;          /* seconds of the fastest run */
  double memory;         /* largest resident set, bytes; NAN: unknown */
  double flops, entries; /* of a factorization */
  double shortest_edge, measure;
} lam_bench_result;

/* The net of a case before it is solved. False with errors. */
bool lam_bench_net(lam_bench *bench, const lam_bench_case *what, lam_net_job *job, lam_net *net);
/* Solves a case. False with errors. */
bool lam_bench_run_case(lam_bench *bench, const lam_bench_case *what, lam_bench_result *result);
json_t *lam_bench_json(const char *section, const lam_bench_case *what,
                       const lam_bench_result *result);
/* Seconds that this thread has computed. */
double lam_bench_clock(void);

/* The sections. False with errors. */
bool lam_bench_sizes(lam_bench *bench);  /* every net of the table, growing */
bool lam_bench_thesis(lam_bench *bench); /* the two methods side by side */
void lam_bench_developable(
    lam_bench *bench); /* Newton's method against the two algorithms of Li & Deng */
bool lam_bench_factor(
    lam_bench *bench); /* an iteration against CHOLMOD on the same matrix; hard meshes */
bool lam_bench_surfaces(lam_bench *bench); /* least area: three methods from one start */
bool lam_bench_quads(lam_bench *bench);    /* asymptotic patches */

#endif
