/* Design files of any bytes: the parser must not crash, must say what is wrong in single lines, and
 * must say the same twice. An input that begins with "--set " has an override in its first line.
 *
 * As a fuzzer:
 *   clang -g -O1 -std=c11 -D_GNU_SOURCE -DLAM_LIBFUZZER -fsanitize=fuzzer,address,undefined -Igen
 * -I. \ tests/torture/fuzz_design.c $(ls gen/design/[a-z]*.c) build/liblamella.a $(LIBRARIES) -o
 * fuzz_design
 *   ./fuzz_design templates/designs tests/cases/bad-designs
 * As a test (without LAM_LIBFUZZER): mutates the shipped and the bad designs in a fixed sequence.
 *   fuzz_design [ROUNDS [SEED]] */
#include "design/design.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void fail(const char *what, const char *text) {
  fprintf(stderr, "fuzz_design: %s: %s\n", what, text);
  abort();
}

/* Reads the design; returns a hash of all messages. */
static uint64_t parse(const char *bytes, size_t count, const char *const *overrides,
                      int override_count) {
  lam_design_text text = {.bytes = bytes,
                          .count = count,
                          .path = "fuzz.yaml",
                          .override_count = override_count,
                          .overrides = overrides};
  lam_arena *arena = lam_arena_new();
  if (!arena) return 0;
  lam_errors errors = {.arena = arena};
  lam_design design;
  bool good = lam_design_parse(arena, &text, &errors, &design);
  uint64_t hash = 14695981039346656037u;
  if (good != (errors.count == 0)) fail("result", "messages and result disagree");
  if (good && (!design.name || !design.title || !design.source))
    fail("design", "a text is missing");
  for (const lam_error *error = errors.first; error; error = error->next) {
    if (!error->text[0] || strchr(error->text, '\n')) fail("not one line", error->text);
    if (error->location.line < 0 || error->location.column < 0) fail("place", error->text);
    for (const char *c = error->text; *c; c++) hash = (hash ^ (unsigned char)*c) * 1099511628211u;
    hash = (hash ^ (uint64_t)error->location.line) * 1099511628211u;
  }
  lam_arena_free(arena);
  return hash;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *bytes = malloc(size + 1);
  if (!bytes) return 0;
  memcpy(bytes, data, size);
  bytes[size] = 0;
  const char *rest = bytes;
  const char *override = NULL;
  if (strncmp(bytes, "--set ", 6) == 0) {
    char *end = strchr(bytes, '\n');
    if (end) *end = 0;
    override = bytes + 6;
    rest = end ? end + 1 : bytes + size;
  }
  size_t count = size - (size_t)(rest - bytes);
  if (parse(rest, count, &override, override != NULL) !=
      parse(rest, count, &override, override != NULL)) {
    fail("differs", "the same input gave other messages");
  }
  free(bytes);
  return 0;
}

#ifndef LAM_LIBFUZZER

#include <glob.h>

enum { longest = 1 << 16, most_seeds = 256 };

typedef struct seed {
  char *bytes;
  size_t count;
} seed;

/* splitmix64: the same sequence on every machine. */
static uint64_t next_random(uint64_t *state) {
  uint64_t z = (*state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

static size_t below(uint64_t *state, size_t limit) {
  return limit > 0 ? (size_t)(next_random(state) % limit) : 0;
}

static int read_seeds(const char *pattern, seed *seeds, int count) {
  glob_t found;
  if (glob(pattern, 0, NULL, &found) != 0) return count;
  for (size_t i = 0; i < found.gl_pathc && count < most_seeds; i++) {
    FILE *file = fopen(found.gl_pathv[i], "rb");
    if (!file) continue;
    seeds[count].bytes = malloc(longest);
    if (!seeds[count].bytes) abort();
    seeds[count].count = fread(seeds[count].bytes, 1, longest, file);
    fclose(file);
    count++;
  }
  globfree(&found);
  return count;
}

/* Puts bytes in place of `removed` bytes at `at`; nothing when the result would be too long. */
static void splice(char *data, size_t *count, size_t at, size_t removed, const char *bytes,
                   size_t inserted) {
  if (*count - removed + inserted > longest) return;
  memmove(data + at + inserted, data + at + removed, *count - at - removed);
  memcpy(data + at, bytes, inserted);
  *count += inserted - removed;
}

static void mutate(uint64_t *state, char *data, size_t *count, const seed *other) {
  static const char *const words[] = {"{",
                                      "}",
                                      "[",
                                      "]",
                                      ": ",
                                      "- ",
                                      "\n",
                                      "\n  ",
                                      "&a ",
                                      "*a",
                                      "!!int ",
                                      "'",
                                      "\"",
                                      "~",
                                      "1e999",
                                      "-1",
                                      "0x10",
                                      "99999999999",
                                      "\t",
                                      "\xff",
                                      "\xef\xbb\xbf",
                                      "--- ",
                                      "? ",
                                      "| \n",
                                      "<<: *a",
                                      "100 mm",
                                      "60 deg",
                                      "yes",
                                      "kind: ",
                                      "surface: ",
                                      "grid: [4, 4]",
                                      "parts: ",
                                      "[[[[[[[[",
                                      "{{{{{{{{",
                                      "\\x00",
                                      "%YAML 1.1\n",
                                      "constraints: ",
                                      "handles: ",
                                      "#",
                                      ","};
  size_t at = below(state, *count + 1), span = below(state, 8) + 1;
  if (span > *count - at) span = *count - at;
  const char *word = words[below(state, sizeof words / sizeof words[0])];
  switch (below(state, 6)) {
  case 0:
    splice(data, count, at, span, "", 0);
    break;
  case 1:
    splice(data, count, at, 0, word, strlen(word));
    break;
  case 2:
    splice(data, count, at, span, word, strlen(word));
    break;
  case 3:
    if (at < *count) data[at] = (char)next_random(state);
    break;
  case 4: { /* a piece of another design */
    size_t from = below(state, other->count + 1), length = below(state, other->count - from + 1);
    splice(data, count, at, 0, other->bytes + from, length);
    break;
  }
  default: { /* a piece of this one again */
    char piece[256];
    size_t length = below(state, *count - at + 1);
    if (length > sizeof piece) length = sizeof piece;
    memcpy(piece, data + at, length);
    splice(data, count, below(state, *count + 1), 0, piece, length);
  }
  }
}

int main(int argc, char **argv) {
  long rounds = argc > 1 ? atol(argv[1]) : 4000;
  uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
  static seed seeds[most_seeds];
  static char data[longest];
  int seed_count = read_seeds("templates/designs/*.yaml", seeds, 0);
  seed_count = read_seeds("tests/cases/bad-designs/*.yaml", seeds, seed_count);
  if (seed_count == 0) fail("no designs", "run in the root of the repository");
  for (long round = 0; round < rounds; round++) {
    const seed *start = &seeds[below(&state, (size_t)seed_count)];
    size_t count = start->count;
    memcpy(data, start->bytes, count);
    if (below(&state, 4) == 0) splice(data, &count, 0, 0, "--set net.grid=[4, 4]\n", 22);
    for (size_t steps = 1 + below(&state, 12); steps > 0; steps--) {
      mutate(&state, data, &count, &seeds[below(&state, (size_t)seed_count)]);
    }
    LLVMFuzzerTestOneInput((const uint8_t *)data, count);
  }
  for (int i = 0; i < seed_count; i++) free(seeds[i].bytes);
  printf("fuzz_design: %ld mutated designs from %d, no crash\n", rounds, seed_count);
  return 0;
}

#endif
