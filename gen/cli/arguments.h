/* The arguments of a verb: options from a table, then files. Every verb reads them so. */
#ifndef LAM_CLI_ARGUMENTS_H
#define LAM_CLI_ARGUMENTS_H

#include <stdbool.h>

/* An option takes one value (value), many (values, each time one more), or none (flag). Values are
 * written as "--name VALUE" or "--name=VALUE". */
typedef struct lam_option {
  const char *name; /* with its dashes; a table ends with a row without a name */
  const char **value;
  const char **values; /* as many as there are arguments */
  int *count;          /* of values */
  bool *flag;
} lam_option;

/* What a verb takes. */
typedef struct lam_arguments {
  const char *usage;         /* for --help, and after complaints */
  const lam_option *options; /* NULL: none */
  int least, most;           /* files */
  const char *noun;          /* what a file is: "a design file" */
} lam_arguments;

/* Reads argv (argv[0] is the verb); files gets up to most, *count their number. Returns -1 to go on;
 * otherwise the exit status: 0 after --help, 2 after a complaint. */
int lam_arguments_read(const lam_arguments *arguments, int argc, char **argv, const char **files,
                       int *count);

#endif
