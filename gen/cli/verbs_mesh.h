/* Verbs about meshes and pictures. argv[0] is the verb; the result is the program's exit code. */
#ifndef LAM_CLI_VERBS_MESH_H
#define LAM_CLI_VERBS_MESH_H

/* 0: a valid solid; 1: open, not oriented or self-intersecting; 2: bad input. */
int lam_verb_inspect(int argc, char **argv);
/* 0: the same within the tolerance; 1: different; 2: bad input. */
int lam_verb_diff(int argc, char **argv);

#endif
