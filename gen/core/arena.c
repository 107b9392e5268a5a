#include "core/arena.h"

#include <assert.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { block_size = 1 << 18, alignment = 16 };

typedef struct block {
  struct block *previous;
  size_t size, used;
  _Alignas(alignment) unsigned char bytes[];
} block;

typedef struct closer {
  struct closer *previous;
  void (*close)(void *handle);
  void *handle;
} closer;

struct lam_arena {
  block *last;
  closer *closers;
  jmp_buf *recovery; /* in a frame that is still there; NULL: none */
  jmp_buf own;
};

static _Thread_local long fail_after = -1, allocations;

long lam_alloc_fail_after(long n) {
  long made = allocations;
  allocations = 0;
  fail_after = n;
  return made;
}

static void *take(size_t size) {
  allocations++;
  if (fail_after >= 0 && fail_after-- == 0) return NULL;
  return malloc(size);
}

lam_arena *lam_arena_new(void) {
  lam_arena *arena = take(sizeof *arena);
  if (arena) memset(arena, 0, sizeof *arena);
  return arena;
}

static void close_until(lam_arena *arena, const closer *last) {
  while (arena->closers && arena->closers != last) {
    closer *c = arena->closers;
    arena->closers = c->previous;
    if (c->handle) c->close(c->handle);
  }
}

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

jmp_buf *lam_arena_recover(lam_arena *arena, jmp_buf *point) {
  jmp_buf *before = arena->recovery;
  arena->recovery = point;
  return before;
}

jmp_buf *lam_arena_recovery(lam_arena *arena) { return arena->recovery = &arena->own; }

bool lam_arena_run(lam_arena *arena, void (*body)(void *context), void *context) {
  jmp_buf point, *before = lam_arena_recover(arena, &point);
  volatile bool done = false;
  if (setjmp(point) == 0) {
    body(context);
    done = true;
  }
  lam_arena_recover(arena, before);
  return done;
}

void lam_arena_exhausted(lam_arena *arena) {
  if (arena->recovery) longjmp(*arena->recovery, 1);
  assert(!"memory ran out, and the caller has no recovery point");
  abort(); /* nowhere to go on: a mistake of the caller, which the face never makes */
}

/* NULL when memory runs out. */
static void *try_alloc(lam_arena *arena, size_t count, size_t size) {
  if (size && count > (SIZE_MAX - sizeof(block) - alignment) / size) return NULL;
  size_t wanted = (count * size + alignment - 1) / alignment * alignment;
  block *b = arena->last;
  if (!b || b->size - b->used < wanted) {
    size_t capacity = wanted > block_size / 4 ? wanted : block_size;
    b = take(sizeof *b + capacity);
    if (!b) return NULL;
    *b = (block){.previous = arena->last, .size = capacity};
    arena->last = b;
  }
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

void lam_arena_defer(lam_arena *arena, void (*close)(void *handle), void *handle) {
  closer *c = try_alloc(arena, 1, sizeof *c);
  if (!c) { /* nobody else will close it */
    if (handle) close(handle);
    lam_arena_exhausted(arena);
  }
  *c = (closer){arena->closers, close, handle};
  arena->closers = c;
}

lam_arena_mark lam_arena_mark_get(const lam_arena *arena) {
  return (lam_arena_mark){arena->last, arena->last ? arena->last->used : 0, arena->closers};
}

void lam_arena_release(lam_arena *arena, lam_arena_mark mark) {
  close_until(arena, mark.closer);
  while (arena->last && arena->last != mark.block) {
    block *previous = arena->last->previous;
    free(arena->last);
    arena->last = previous;
  }
  if (arena->last) arena->last->used = mark.used;
}
