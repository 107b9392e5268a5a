/* Words for keys and values: messages (of design/) and reference pages (of library/) use the
 * same. */
#ifndef LAM_DESIGN_DESCRIBE_H
#define LAM_DESIGN_DESCRIBE_H

#include "core/key.h"
#include "core/text.h"
#include "design/tree.h"

/* A unit of the design language. A value in this unit is value / divide * multiply in stored units:
 * dividing keeps decimal numbers exact (25 mm is the double nearest to 0.025). */
typedef struct lam_unit_name {
  const char *name;
  lam_key_unit unit;
  double divide, multiply;
} lam_unit_name;
extern const lam_unit_name lam_unit_names[]; /* ends with a row whose name is NULL */

/* ---- values ---- */

/* Appends a stored value (meters, radians, or a plain number) in a unit that reads well, with up to
 * six significant digits: 0.1 m becomes "100 mm". 0 has no unit. */
void lam_describe_quantity(lam_text *text, double value, lam_key_unit unit);
/* Appends what a node of a document holds, shortened to 60 bytes: "100 mm", "a list of 3 values",
 * "nothing". Texts that were quoted in the file stand in quotes. */
void lam_describe_node(lam_text *text, const lam_node *node);

/* ---- keys ---- */

/* Appends the range of a NUMBER or INTEGER key, such as "from 1 mm to 1 m" or "at least 2", nothing
 * when there is no limit. unit: in which to write the limits, or NULL for one that reads well. */
void lam_describe_range(lam_text *text, const lam_key *key, const lam_unit_name *unit);
/* Appends what the key takes: "a length in m, cm, mm or um from 1 mm to 1 m", "a list of 2 whole
 * numbers". */
void lam_describe_key(lam_text *text, const lam_key *key);
/* Appends what one item of the key takes, whatever its count: "a whole number". */
void lam_describe_item(lam_text *text, const lam_key *key);

/* ---- names ---- */

/* Appends names with commas between them. names: NULL-terminated. */
void lam_describe_names(lam_text *text, const char *const *names);
/* Appends " (did you mean X?)" when a name is near to what was given; nothing otherwise. names:
 * NULL-terminated. */
void lam_describe_guess(lam_text *text, const char *given, const char *const *names);

/* The names of two key tables, with first (NULL: none) before them. NULL-terminated, owned by
 * arena; the names themselves are those of the tables. keys and more may be NULL. */
const char *const *lam_key_names(lam_arena *arena, const char *first, const lam_key *keys,
                                 const lam_key *more);
/* The names of a registry's rows, in the same form. */
const char *const *lam_registry_names(lam_arena *arena, const lam_registry *registry);

#endif
