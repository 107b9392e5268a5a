/* The memory of one run: blocks of bytes, handed out one behind the other and freed together. Used
 * in every folder. */
#include "core/arena.h"

#include <assert.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { block_size = 1 << 18, alignment = 16 }; /* bytes */

/* What is taken from the system at once; a list from the last one to the first. */
typedef struct block {
  struct block *previous;
  size_t size, used; /* of bytes */
  _Alignas(alignment) unsigned char bytes[];
} block;

/* What is deferred; a list from the last one to the first. */
typedef struct closer {
  struct closer *previous;
  void (*close)(void *handle);
  void *handle;
} closer;

struct lam_arena {
  block *last;
  closer *closers;
  jmp_buf *recovery; /* in a frame that is still there; NULL: none */
};

/* ---- memory from the system ---- */

static _Thread_local long fail_after = -1, allocations;

/* Allocations are those from the system: blocks and arenas, not what is handed out of them. */
long lam_alloc_fail_after(long n) {
  long made = allocations;
  allocations = 0;
  fail_after = n;
  return made;
}

/* NULL when memory runs out, or when a test wants it to. */
static void *take(size_t size) {
  allocations++;
  if (fail_after >= 0 && fail_after-- == 0) return NULL;
  return malloc(size);
}

/* ---- an arena ---- */

lam_arena *lam_arena_new(void) {
  lam_arena *arena = take(sizeof *arena);
  if (arena) memset(arena, 0, sizeof *arena);
  return arena;
}

/* Closes what was deferred after `last` (NULL: all), in reverse order. Each closer leaves the list
 * before it is called. */
static void close_until(lam_arena *arena, const closer *last) {
  while (arena->closers && arena->closers != last) {
    closer *c = arena->closers;
    arena->closers = c->previous;
    if (c->handle) c->close(c->handle);
  }
}

/* Handles first: what they close may lie in the blocks. */
void lam_arena_free(lam_arena *arena) {
  if (!arena) return;
  close_until(arena, NULL);

  for (block *b = arena->last; b;) {
    block *previous = b->previous;
    free(b);
    b = previous;
  }
  free(arena);
}

/* ---- running out of memory ---- */

jmp_buf *lam_arena_recover(lam_arena *arena, jmp_buf *point) {
  jmp_buf *before = arena->recovery;
  arena->recovery = point;
  return before;
}

void lam_arena_exhausted(lam_arena *arena) {
  if (arena->recovery) longjmp(*arena->recovery, 1);
  assert(!"memory ran out, and the caller has no recovery point");
  abort(); /* nowhere to go on: a mistake of the caller, which the face never makes */
}

/* ---- allocations ---- */

/* count * size zeroed bytes; NULL when memory runs out, or when the product does not fit. */
static void *try_alloc(lam_arena *arena, size_t count, size_t size) {
  if (size && count > (SIZE_MAX - sizeof(block) - alignment) / size) return NULL;
  size_t wanted = (count * size + alignment - 1) / alignment * alignment;

  /* A new block when the last one is full; what is large gets one of its own size. */
  block *b = arena->last;
  if (!b || b->size - b->used < wanted) {
    size_t capacity = wanted > block_size / 4 ? wanted : block_size;
    b = take(sizeof *b + capacity);
    if (!b) return NULL;
    *b = (block){.previous = arena->last, .size = capacity};
    arena->last = b;
  }

  /* Cleared here and not with the block: bytes are used again after a release. */
  void *bytes = b->bytes + b->used;
  b->used += wanted;
  return memset(bytes, 0, wanted);
}

void *lam_arena_alloc(lam_arena *arena, size_t count, size_t size) {
  void *bytes = try_alloc(arena, count, size);
  if (!bytes) lam_arena_exhausted(arena);
  return bytes;
}

char *lam_arena_copy(lam_arena *arena, const char *text) {
  if (!text) return NULL;
  size_t length = strlen(text) + 1;
  return memcpy(lam_arena_alloc(arena, length, 1), text, length);
}

/* A first pass measures the text, a second one writes it. */
char *lam_arena_printf(lam_arena *arena, const char *format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  assert(length >= 0);

  char *text = lam_arena_alloc(arena, (size_t)length + 1, 1);
  vsnprintf(text, (size_t)length + 1, format, again);
  va_end(again);
  return text;
}

/* A closer lies in the arena that it belongs to. */
void lam_arena_defer(lam_arena *arena, void (*close)(void *handle), void *handle) {
  closer *c = try_alloc(arena, 1, sizeof *c);
  if (!c) { /* nobody else will close it */
    if (handle) close(handle);
    lam_arena_exhausted(arena);
  }

  *c = (closer){arena->closers, close, handle};
  arena->closers = c;
}

/* ---- marks ---- */

lam_arena_mark lam_arena_mark_get(const lam_arena *arena) {
  return (lam_arena_mark){arena->last, arena->last ? arena->last->used : 0, arena->closers};
}

/* Handles first, then the blocks that were begun after the mark; its own block is cut back. A mark
 * of an empty arena (block NULL) frees all blocks. */
void lam_arena_release(lam_arena *arena, lam_arena_mark mark) {
  close_until(arena, mark.closer);

  while (arena->last && arena->last != mark.block) {
    block *previous = arena->last->previous;
    free(arena->last);
    arena->last = previous;
  }
  if (arena->last) arena->last->used = mark.used;
}
