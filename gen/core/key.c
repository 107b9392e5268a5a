/* Registries: finding a row, and adding the rows of a program. Called by design/fill.c, which reads
 * designs; rows are looked up by name in cli and bench too. */
#include "core/key.h"

#include <string.h>

const lam_row_head *lam_registry_find(const lam_registry *registry, const char *name) {
  for (int i = 0; i < registry->count; i++)
    if (strcmp(registry->rows[i]->name, name) == 0) return registry->rows[i];
  return NULL;
}

/* The registry's own rows come first, so that an added row cannot take the name of one of them. */
const lam_registry *lam_registry_with(lam_arena *arena, const lam_registry *registry,
                                      const lam_added_rows *added) {
  if (!added || added->registry != registry || !added->count) return registry;

  const lam_row_head **rows = LAM_NEW(arena, const lam_row_head *, registry->count + added->count);
  memcpy(rows, registry->rows, sizeof *rows * (size_t)registry->count);
  memcpy(rows + registry->count, added->rows, sizeof *rows * (size_t)added->count);

  lam_registry *larger = LAM_NEW(arena, lam_registry, 1);
  *larger = (lam_registry){registry->name, registry->noun, rows, registry->count + added->count};
  return larger;
}
