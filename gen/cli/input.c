#include "cli/input.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static void close_file(void *handle) { fclose(handle); }

/* Reads to the end; files whose size is not known beforehand (pipes) are read too. */
static bool read_all(lam_arena *arena, FILE *file, char **bytes, size_t *count) {
  size_t capacity = 1 << 16, length = 0;
  char *data = lam_arena_alloc(arena, capacity, 1);
  for (;;) {
    length += fread(data + length, 1, capacity - 1 - length, file);
    if (length < capacity - 1) break;
    char *larger = lam_arena_alloc(arena, capacity * 2, 1);
    memcpy(larger, data, length);
    data = larger;
    capacity *= 2;
  }
  data[length] = 0;
  *bytes = data;
  *count = length;
  return !ferror(file);
}

bool lam_input_read(lam_arena *arena, const char *path, lam_place place, const char *key, lam_errors *errors,
                    char **bytes, size_t *count) {
  FILE *file = fopen(path, "rb");
  if (file) {
    lam_arena_defer(arena, close_file, file);
    if (read_all(arena, file, bytes, count)) return true;
  }
  lam_error_add(errors, place, key, "%s: %s", path, strerror(errno));
  return false;
}
