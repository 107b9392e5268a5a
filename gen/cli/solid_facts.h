/* Facts of solids as JSON, and printing JSON: for verb_inspect.c, diff_meshes.c and
 * diff_pictures.c. */
#ifndef LAM_CLI_SOLID_FACTS_H
#define LAM_CLI_SOLID_FACTS_H

#include <jansson.h>
#include <lamella/solid.h>

/* All facts in SI units, as an object that the caller owns (json_decref). */
json_t *lam_facts_json(const lam_solid_facts *facts);
/* Prints the object on stdout, indented and with 12 digits, and releases it. */
void lam_json_print(json_t *object);

#endif
