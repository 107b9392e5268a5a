/* What inspect and diff share: reading a mesh, messages, a mesh's facts as JSON. */
#ifndef LAM_CLI_MESH_INPUT_H
#define LAM_CLI_MESH_INPUT_H

#include "core/solid/solid.h"
#include <jansson.h>

/* Prints every message as `lamella VERB: FILE:LINE: text` on stderr. */
void lam_verb_errors(const char *verb, const lam_errors *errors);
/* Prints one message of the same form, without a file, and returns exit code 2. */
int lam_verb_error(const char *verb, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The message about the option that getopt_long just refused (opterr must be 0, and values of long
 * options above 255). Returns exit code 2. */
int lam_verb_option_error(char **argv, int result);

/* Reads an STL or OBJ file as triangles, welds and measures it. On failure adds to errors and
 * returns false. */
bool lam_mesh_input(lam_arena *arena, const char *path, bool self_intersections, lam_errors *errors,
                    lam_trimesh *mesh, lam_solid_facts *facts);
/* In SI units. A new reference. */
json_t *lam_facts_json(const lam_solid_facts *facts);
/* Prints the object on stdout and releases it. */
void lam_json_print(json_t *object);

#endif
