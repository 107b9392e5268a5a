/* Arrays that grow in an arena: the one place where capacity is counted. Called by core/stage.c,
 * fab and net. */
#ifndef LAM_CORE_GROW_H
#define LAM_CORE_GROW_H

#include "core/arena.h"

/* Room for one more item: the array itself while count < *capacity, otherwise a copy twice as large
 * (16 items at first). Pointers into the old array stay readable until the arena is released, but
 * are no longer part of it.
 *
 *   items     array of count items of the given size, owned by arena; NULL when count is 0
 *   capacity  in and out: how many items fit
 *   size      bytes of one item
 *
 * Never NULL. Items beyond count are zero in a new array. */
void *lam_grow(lam_arena *arena, void *items, int count, int *capacity, size_t size);

/* Appends a value to an array of the same type: LAM_APPEND(arena, list->items, list->count,
 * list->capacity, value). The arguments are evaluated more than once. */
#define LAM_APPEND(arena, items, count, capacity, value)                                           \
  ((items) = lam_grow((arena), (items), (count), &(capacity), sizeof *(items)),                    \
   (items)[(count)++] = (value))

#endif
