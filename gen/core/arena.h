/* The memory of one run. Allocations are zeroed and never NULL: when memory runs out, control jumps
 * to the run's recovery point (lam_arena_run). What needs closing (a factorization, a tree behind a
 * shim) is deferred to the arena and closed with it, in reverse order. An arena belongs to one
 * thread.
 *
 * C++ code never allocates from an arena: a jump must not cross its frames. */
#ifndef LAM_CORE_ARENA_H
#define LAM_CORE_ARENA_H

#include <setjmp.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct lam_arena lam_arena;

/* NULL when there is no memory for the arena itself. */
lam_arena *lam_arena_new(void);
/* Closes everything deferred and frees all memory. NULL is allowed. */
void lam_arena_free(lam_arena *arena);

/* count * size zeroed bytes, aligned for any type. count * size may be 0. */
void *lam_arena_alloc(lam_arena *arena, size_t count, size_t size);
/* A zero-terminated copy. text may be NULL, which gives NULL. */
char *lam_arena_copy(lam_arena *arena, const char *text);
/* A formatted, zero-terminated string. */
char *lam_arena_printf(lam_arena *arena, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* Calls close(handle) when the arena is released past this point or freed. */
void lam_arena_defer(lam_arena *arena, void (*close)(void *handle), void *handle);

#define LAM_NEW(arena, type, count)                                                                \
  ((type *)lam_arena_alloc((arena), (size_t)(count), sizeof(type)))

/* A position to go back to: everything allocated and deferred after the mark is released. Marks
 * nest. */
typedef struct lam_arena_mark {
  void *block;
  size_t used;
  void *closer;
} lam_arena_mark;
lam_arena_mark lam_arena_mark_get(const lam_arena *arena);
void lam_arena_release(lam_arena *arena, lam_arena_mark mark);

/* Runs body(context) with a recovery point of its own: false when memory ran out inside, and
 * whatever body allocated until then stays with the arena. The point is gone afterwards, and that of
 * an outer run is back. */
bool lam_arena_run(lam_arena *arena, void (*body)(void *context), void *context);
/* The bare mechanism, for callers that cannot hand over a function: makes point (set by setjmp in a
 * frame that is still there) the recovery point, NULL: none; returns the one before. */
jmp_buf *lam_arena_recover(lam_arena *arena, jmp_buf *point);
#define LAM_ARENA_TRY(arena) (setjmp(*lam_arena_recovery(arena)) == 0)
jmp_buf *lam_arena_recovery(lam_arena *arena);
/* Jumps to the recovery point: for callers whose own library reports that memory ran out. */
void lam_arena_exhausted(lam_arena *arena) __attribute__((noreturn));

/* Test hook of the calling thread: the n-th allocation from now fails (n = 0: the next one); a negative n never fails.
 * Returns the number of allocations made since the last call. */
long lam_alloc_fail_after(long n);

#endif
