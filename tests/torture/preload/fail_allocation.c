/* A preloaded allocator in which one allocation of the process fails, whichever library asks for
 * it:
 *
 * LD_PRELOAD=fail_allocation.so FAIL_ALLOCATION=17 lamella build ...   the 17th fails
 * LD_PRELOAD=fail_allocation.so ALLOCATION_PLACES=FILE lamella ...     none fails; FILE lists them
 *
 * FILE gets the numbers of those allocations that are the first from their place (the calls that
 * led there), and their number at last: what comes from one place fails in one way. Built and used
 * by tests/torture/allocations.py alone. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <unwind.h>

/* The allocator behind this one, as glibc calls it. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

enum { deepest = 14, places = 1 << 18 };

static _Atomic long allocations;
static long failing; /* 0: none */
static bool listing, ready;
static uint64_t seen[places]; /* hashes of the places, by hash */
static char list[1 << 22];    /* what is written at the end */
static size_t length;
static _Thread_local bool inside;

typedef struct walk {
  uint64_t hash;
  int depth;
} walk;

static _Unwind_Reason_Code add_frame(struct _Unwind_Context *context, void *data) {
  walk *w = data;
  w->hash = (w->hash ^ (uint64_t)_Unwind_GetIP(context)) * 0x9e3779b97f4a7c15u;
  w->hash ^= w->hash >> 29;
  return ++w->depth < deepest ? _URC_NO_REASON : _URC_END_OF_STACK;
}

/* Notes allocation n when it is the first from its place. */
static void note_place(long n) {
  walk w = {1, 0};
  _Unwind_Backtrace(add_frame, &w);
  size_t i = w.hash % places;
  while (seen[i] && seen[i] != w.hash) i = (i + 1) % places;
  if (seen[i] || length + 32 > sizeof list) return;

  seen[i] = w.hash;
  length += (size_t)snprintf(list + length, 32, "%ld\n", n);
}

/* The environment is read at the first allocation, which comes before any constructor. */
static void begin(void) {
  ready = true;
  const char *text = getenv("FAIL_ALLOCATION");
  failing = text ? atol(text) : 0;
  listing = getenv("ALLOCATION_PLACES") != NULL;
}

/* Counts an allocation. Whether it fails. */
static bool fails(void) {
  if (!ready) begin();
  if (inside) return false;
  long n = ++allocations;
  if (listing) {
    inside = true;
    note_place(n);
    inside = false;
  }
  if (n != failing) return false;
  errno = ENOMEM;
  return true;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
void *memalign(size_t alignment, size_t size) {
  return fails() ? NULL : __libc_memalign(alignment, size);
}
void *aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void **result, size_t alignment, size_t size) {
  *result = memalign(alignment, size);
  return *result ? 0 : ENOMEM;
}

static const char *path; /* of the list; NULL: none */

/* Programs that are started have all their memory. */
static void __attribute__((constructor)) keep_for_itself(void) {
  path = getenv("ALLOCATION_PLACES");
  unsetenv("ALLOCATION_PLACES");
  unsetenv("FAIL_ALLOCATION");
  unsetenv("LD_PRELOAD");
}

static void __attribute__((destructor)) write_list(void) {
  int file = path ? open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
  if (file < 0) return;
  length += (size_t)snprintf(list + length, 32, "%ld\n", (long)allocations);
  if (write(file, list, length) < 0) _exit(99);
  close(file);
}
