/* Arrays that grow in an arena. Called through LAM_APPEND by core/stage.c, fab and net. */
#include "core/grow.h"

#include <string.h>

/* Capacity doubles, so that n appended items cost O(n) copies. */
void *lam_grow(lam_arena *arena, void *items, int count, int *capacity, size_t size) {
  if (count < *capacity) return items;

  *capacity = *capacity ? 2 * *capacity : 16;
  void *larger = lam_arena_alloc(arena, (size_t)*capacity, size);
  if (count) memcpy(larger, items, size * (size_t)count);
  return larger;
}
