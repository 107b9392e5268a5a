/* Facts of solids as JSON, and printing JSON: for verb_inspect.c,
 * verb_measure.c, diff_meshes.c and diff_pictures.c. */
#ifndef LAM_CLI_SOLID_FACTS_H
#define LAM_CLI_SOLID_FACTS_H

#include <jansson.h>
#include <lamella/solid.h>

/* All facts in SI units, as an object that the caller owns (json_decref). */
json_t *lam_facts_json(const lam_solid_facts *facts);
/* Called by main.c before any JSON is made, so that lam_json_print knows of every lack of memory.
 * */
void lam_json_begin(void);
/* Prints the object on stdout, indented, and releases it. Returns status, or 1 after a complaint
 * when memory ran out on the way. */
int lam_json_print(json_t *object, int status, int digits);

#endif
