/* The memory of one run. Allocations are zeroed and never NULL: when memory runs out, control jumps
 * to the run's recovery point (LAM_ARENA_TRY). What needs closing (a factorization, a tree behind a
 * shim) is deferred to the arena and closed with it, in reverse order. An arena belongs to one
 * thread. Used in every folder.
 *
 * C++ code never allocates from an arena: a jump must not cross its frames. */
#ifndef LAM_CORE_ARENA_H
#define LAM_CORE_ARENA_H

#include <setjmp.h>
#include <stddef.h>

typedef struct lam_arena lam_arena;

/* ---- an arena ---- */

/* An empty arena without a recovery point, to be freed by lam_arena_free. NULL when there is no
 * memory for the arena itself. */
lam_arena *lam_arena_new(void);
/* Closes everything deferred and frees all memory. NULL is allowed. */
void lam_arena_free(lam_arena *arena);

/* ---- allocations: never NULL, owned by the arena ---- */

/* count * size zeroed bytes, aligned for any type. count * size may be 0. */
void *lam_arena_alloc(lam_arena *arena, size_t count, size_t size);
/* A zero-terminated copy. text may be NULL, which gives NULL. */
char *lam_arena_copy(lam_arena *arena, const char *text);
/* A string formatted as by printf, zero-terminated. */
char *lam_arena_printf(lam_arena *arena, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* Calls close(handle) when the arena is released past this point or freed; at once when memory runs
 * out, before control jumps. A handle that is NULL is not closed. */
void lam_arena_defer(lam_arena *arena, void (*close)(void *handle), void *handle);

/* count zeroed items of a type. */
#define LAM_NEW(arena, type, count)                                                                \
  ((type *)lam_arena_alloc((arena), (size_t)(count), sizeof(type)))

/* ---- marks ---- */

/* A position to go back to. Marks nest: one that was taken later is released first, or with the
 * earlier one. */
typedef struct lam_arena_mark {
  void *block;
  size_t used;
  void *closer;
} lam_arena_mark;

/* The position as it is now. */
lam_arena_mark lam_arena_mark_get(const lam_arena *arena);
/* Closes and frees everything deferred and allocated after the mark. */
void lam_arena_release(lam_arena *arena, lam_arena_mark mark);

/* ---- running out of memory ---- */

/* Makes point, set by setjmp in a frame that is still there, the place where control goes when
 * memory runs out; NULL: none. Returns the one before. */
jmp_buf *lam_arena_recover(lam_arena *arena, jmp_buf *point);
/* True now, and false when memory has run out afterwards. point is a jmp_buf of the frame that this
 * stands in, which must not be left while the arena is used:
 *   jmp_buf point;
 *   if (!LAM_ARENA_TRY(arena, point)) ... out of memory ... */
#define LAM_ARENA_TRY(arena, point) (lam_arena_recover((arena), &(point)), setjmp(point) == 0)
/* Jumps to the recovery point: for callers whose own library reports that memory ran out. The
 * program ends when there is none, which is a mistake of the caller. */
void lam_arena_exhausted(lam_arena *arena) __attribute__((noreturn));

/* For tests: the n-th allocation of the calling thread from now on fails (n = 0: the next one);
 * none does with a negative n. Returns the number of allocations made since the last call. */
long lam_alloc_fail_after(long n);

#endif
