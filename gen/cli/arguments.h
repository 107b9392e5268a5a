/* The arguments of a verb: options from a table, and files, in any order. Every verb_*.c reads them
 * so. */
#ifndef LAM_CLI_ARGUMENTS_H
#define LAM_CLI_ARGUMENTS_H

#include <stdbool.h>

/* An option takes one value (value), many (values, each time one more), or none (flag). Values are
 * written as "--name VALUE" or "--name=VALUE". */
typedef struct lam_option {
  const char *name;    /* with its dashes; a table ends with a row without a name */
  const char **value;  /* is set to the value: the last one, when it is given several times */
  const char **values; /* gets the values; has room for as many as there are arguments */
  int *count;          /* of values, counted up; not NULL beside values */
  bool *flag;          /* is set to true */
} lam_option;

/* What a verb takes. */
typedef struct lam_arguments {
  const char *usage;         /* for --help, and after complaints */
  const lam_option *options; /* NULL: none */
  int least, most;           /* number of files */
  const char *noun;          /* what a file is: "a design file" */
} lam_arguments;

/* Reads argv (argv[0] is the verb).
 *
 *   files  out: up to most of them, in order; beyond *count it stays as it was. Texts are argv's
 *   count  out: number of files
 *
 * Returns -1 to go on; otherwise the exit status: 0 after --help was printed, 1 when that failed,
 * 2 after a complaint on stderr. */
int lam_arguments_read(const lam_arguments *arguments, int argc, char **argv, const char **files,
                       int *count);

#endif
