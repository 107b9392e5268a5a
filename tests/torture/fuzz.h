/* Random changes of files, for the drivers fuzz_mesh.c and fuzz_surface.c. */
#ifndef TESTS_TORTURE_FUZZ_H
#define TESTS_TORTURE_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t fuzz_next(uint64_t *state) { /* xorshift64* (S. Vigna) */
  *state ^= *state >> 12;
  *state ^= *state << 25;
  *state ^= *state >> 27;
  return *state * 0x2545f4914f6cdd1dULL;
}

/* Swaps, overwrites and repeats a few bytes, puts likely ones in; numbers change into other numbers
 * most often. Returns the new size, at most capacity. */
static inline size_t fuzz_mutate(uint64_t *state, const char *likely, uint8_t *bytes, size_t size,
                                 size_t capacity) {
  for (uint64_t n = 1 + fuzz_next(state) % 6; n && size; n--) {
    size_t at = fuzz_next(state) % size, to = fuzz_next(state) % size,
           length = fuzz_next(state) % 24;
    switch (fuzz_next(state) % 6) {
    case 0:
      bytes[at] = (uint8_t)fuzz_next(state);
      break;
    case 1:
      bytes[at] = bytes[to];
      break;
    case 2:
      size = fuzz_next(state) % 8 ? size : at;
      break;
    case 3:
      if (size + length > capacity || to + length > size) break;
      memmove(bytes + to + length, bytes + to, size - to);
      size += length;
      break;
    case 4: /* a digit */
      while (at < size && (bytes[at] < '0' || bytes[at] > '9')) at++;
      if (at < size) bytes[at] = (uint8_t)('0' + fuzz_next(state) % 10);
      break;
    default:
      bytes[at] = (uint8_t)likely[fuzz_next(state) % strlen(likely)];
    }
  }
  return size;
}

#endif
