/* The verbs of the program, each in its verb_*.c; called by main.c. Each takes its arguments
 * (argv[0] is the verb) and returns the exit status: 0 done, 1 something failed or differs, 2 wrong
 * input or wrong use. */
#ifndef LAM_CLI_VERBS_H
#define LAM_CLI_VERBS_H

int lam_verb_build(int argc, char **argv);
int lam_verb_check(int argc, char **argv);
int lam_verb_list(int argc, char **argv);
int lam_verb_show(int argc, char **argv);
int lam_verb_new(int argc, char **argv);
int lam_verb_measure(int argc, char **argv);
int lam_verb_bench(int argc, char **argv);
int lam_verb_diff(int argc, char **argv);
int lam_verb_inspect(int argc, char **argv);

#endif
