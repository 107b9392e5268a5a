/* What the sections of `lamella bench` share: cases to be solved, what came of them, and a clock.
 * Used by the files of this folder alone. */
#ifndef LAM_BENCH_BENCH_H
#define LAM_BENCH_BENCH_H

#include "net/optimize.h"
#include "solve/assemble.h"
#include "solve/factor.h"

#include <jansson.h>
#include <stdio.h>

/* A run of the benchmark. */
typedef struct lam_bench {
  lam_arena *arena;
  lam_errors *errors;
  const char *folder; /* of the meshes */
  const char *only;   /* a kind of net, or NULL: all */
  int most;           /* vertices */
  json_t *json;       /* the array that results go to, or NULL: tables are written */
  FILE *out;          /* for tables */
} lam_bench;

/* ---- starts (bench_starts.c) ---- */

/* A start from which a kind of net is known to converge: the mesh of a surface with some noise. */
typedef struct lam_bench_start {
  const char *kind;    /* of the net registry */
  const char *keys;    /* of the net, as in a design: "orthogonal: yes", or "" */
  const char *surface; /* as in a design */
  double noise;        /* mean edges */
  double aspect;       /* vertices along the first family over those along the second */
  const char *measure; /* that proves the net */
} lam_bench_start;
extern const lam_bench_start lam_bench_starts[]; /* lam_bench_start_count of them, one per kind */
extern const int lam_bench_start_count;

/* ---- solving a case (bench_run.c) ---- */

/* What is solved. */
typedef struct lam_bench_case {
  const char *kind, *keys; /* as in lam_bench_start */
  const char *solver;      /* as in a design */
  const char *surface;     /* NULL: the mesh */
  const char *mesh;        /* name in the folder; NULL: the surface */
  int grid[2];             /* cells on the surface */
  double noise;            /* mean edges */
  const char *measure;     /* NULL: none */
  int repeats;             /* the least time of so many runs counts */
} lam_bench_case;

/* What came of it. Times in seconds. */
typedef struct lam_bench_result {
  int vertices, unknowns;
  int iterations, factorizations; /* rejected steps are factorized too */
  bool converged;
  char reason[100]; /* why the solver ended */
  double residual;
  double analysis;                /* once */
  double assembly, factor, solve; /* per factorization */
  double step;                    /* all three: a step that is taken or rejected */
  double total;                   /* of the fastest run */
  double memory;                  /* largest resident set, bytes; NAN: unknown */
  double flops, entries;          /* of a factorization, of the factor */
  double shortest_edge;           /* over the mean edge */
  double measure;                 /* its largest value; NAN without one */
} lam_bench_result;

/* The net of a case before it is solved, and the job to solve it with; both live in bench->arena.
 * False with errors. */
bool lam_bench_net(lam_bench *bench, const lam_bench_case *what, lam_net_job *job, lam_net *net);
/* Solves a case. Not converging is a result. False with errors. */
bool lam_bench_run_case(lam_bench *bench, const lam_bench_case *what, lam_bench_result *result);
/* An object of the array of results, times in milliseconds; the caller owns it. */
json_t *lam_bench_json(const char *section, const lam_bench_case *what,
                       const lam_bench_result *result);
/* The normal equations of a net, analyzed and ready to be assembled again and again. */
typedef struct lam_bench_equations {
  const lam_problem *problem;
  lam_system *system;
  lam_factor *factor;
  double *values;          /* of the matrix */
  double *gradient, *step; /* one number per column */
} lam_bench_equations;
/* Those of the hard constraints of an asymptotic net with right angles on an Enneper surface, the
 * one of bench_thesis.c, about so many cells by so many. They live in bench->arena. False with
 * errors. */
bool lam_bench_asymptotic(lam_bench *bench, int cells, lam_bench_equations *equations,
                          int *vertices);
/* Assembles and damps the matrix, as the solver does in one step. */
void lam_bench_assemble(const lam_bench_equations *equations);

/* Seconds that this thread has computed: other programs do not count. */
double lam_bench_clock(void);

/* ---- sections ----
 * Each writes a table, or adds to the array of results. False with errors. */

/* Every net of the table of starts, growing. */
bool lam_bench_sizes(lam_bench *bench);
/* The solver of lamella and that of the thesis side by side. */
bool lam_bench_thesis(lam_bench *bench);
/* Nearly developable surfaces: Newton's method against the two algorithms of Li & Deng. It cannot
 * fail. */
void lam_bench_developable(lam_bench *bench);
/* An iteration against its factorization; meshes that are hard to planarize. */
bool lam_bench_factor(lam_bench *bench);
/* Surfaces of least area: several methods from one start. */
bool lam_bench_surfaces(lam_bench *bench);
/* Asymptotic patches: three forms of control nets. */
bool lam_bench_quads(lam_bench *bench);

#endif
