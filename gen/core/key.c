#include "core/key.h"

#include <string.h>

const lam_row_head *lam_registry_find(const lam_registry *registry, const char *name) {
  for (int i = 0; i < registry->count; i++)
    if (strcmp(registry->rows[i]->name, name) == 0) return registry->rows[i];
  return NULL;
}
