/* Facts of solids as JSON: what inspect and diff print. */
#ifndef LAM_CLI_SOLID_FACTS_H
#define LAM_CLI_SOLID_FACTS_H

#include <jansson.h>
#include <lamella/solid.h>

/* In SI units. A new reference. */
json_t *lam_facts_json(const lam_solid_facts *facts);
/* Prints the object on stdout and releases it. */
void lam_json_print(json_t *object);

#endif
