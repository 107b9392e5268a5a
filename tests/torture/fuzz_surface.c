/* STEP, IGES and surface.json files of any bytes: the readers must not crash, must say what is wrong in one line, and
 * what they do read must be evaluated and written again without harm.
 *
 * As a fuzzer:
 *   clang -g -O1 -std=c11 -D_GNU_SOURCE -fsanitize=fuzzer,address,undefined -Igen -I. tests/torture/fuzz_surface.c \
 *     formats/step*.c formats/iges*.c formats/surface_json.c formats/spline.c formats/scan.c build/liblamella.a \
 *     -ljansson -lstdc++ -lm -o fuzz_surface
 *   ./fuzz_surface -max_len=8192 corpus
 * As a test, with -DLAM_FUZZ_DRIVER: mutates small files in a fixed sequence.
 *   fuzz_surface [ROUNDS [SEED]] */
#include "curve/basis.h"
#include "formats/format.h"
#include "surf/spline_surface.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const lam_format lam_format_step, lam_format_iges, lam_format_surface;
static const lam_format *const formats[] = {&lam_format_step, &lam_format_iges, &lam_format_surface};
enum { format_count = 3 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void fail(const char *what) {
  fprintf(stderr, "fuzz_surface: %s\n", what);
  abort();
}

/* Evaluates a surface at its corners and in the middle. */
static void evaluate(lam_arena *arena, const lam_spline_surface *s) {
  for (int d = 0; d < 2; d++)
    if (s->degree[d] > LAM_BASIS_MAX_DEGREE ||
        lam_knots_problem(s->degree[d], s->count[d], s->count[d] + s->degree[d] + 1, s->knots[d]))
      return; /* refused when the surface is made */
  const lam_nurbs *nurbs = lam_nurbs_make(arena, s);
  double p[2], q[2];
  bool closed[2];
  lam_jet jet;
  lam_nurbs_domain(nurbs, LAM_CHART_NATURAL, p, q, closed);
  for (int k = 0; k < 3; k++) lam_nurbs_eval(nurbs, p[0] + k * (p[1] - p[0]) / 2, q[0] + k * (q[1] - q[0]) / 2, &jet);
}

/* Writes what was read in all formats; what was written must be read. Where numbers overflow on the way to millimeters
 * nothing is promised. */
static void write_again(lam_arena *arena, const lam_spline_surface *s) {
  lam_spline_surface named = *s;
  named.name = "surface";
  for (int i = 0; i < s->count[0] * s->count[1]; i++)
    if (!(lam_length(s->points[i]) < 1e100) || (s->weights && !(s->weights[i] < 1e100 && s->weights[i] > 1e-100)))
      return;
  for (int d = 0; d < 2; d++) {
    double size = s->knots[d][s->count[d]] - s->knots[d][s->degree[d]];
    for (int i = 0; i < s->count[d] + s->degree[d] + 1; i++)
      if (!(fabs(s->knots[d][i]) < 1e6 * size)) return;
    if (lam_knots_problem(s->degree[d], s->count[d], s->count[d] + s->degree[d] + 1, s->knots[d])) return;
  }
  lam_model model = {.name = "fuzz", .version = "0", .surface_count = 1, .surfaces = &named};
  for (int i = 0; i < format_count; i++) {
    lam_text text = {.arena = arena};
    lam_errors errors = {.arena = arena};
    lam_spline_list list;
    if (formats[i]->write(&model, 0, &text) != LAM_OK) fail("not written");
    if (!formats[i]->read_surfaces(arena, text.data, text.length, (lam_place){.file = "again"}, &errors, &list)) {
      fprintf(stderr, "%s: %s\n", formats[i]->name, errors.first->text);
      fail("what was written is not read");
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  for (int i = 0; i < format_count; i++) {
    lam_arena *arena = lam_arena_new();
    if (!arena) return 0;
    char *bytes = lam_arena_alloc(arena, size, 1);
    if (size) memcpy(bytes, data, size);
    lam_errors errors = {.arena = arena};
    lam_spline_list list;
    bool good = formats[i]->read_surfaces(arena, bytes, size, (lam_place){.file = "fuzz"}, &errors, &list);
    if (errors.count != !good) fail("messages and result disagree");
    for (const lam_error *e = errors.first; e; e = e->next)
      if (!e->text[0] || strchr(e->text, '\n') || e->place.line < 0) fail("a message is not one line");
    for (int k = 0; good && k < list.count; k++) {
      if (lam_spline_problem(&list.items[k])) fail("an unfit surface was read");
      evaluate(arena, &list.items[k]);
      write_again(arena, &list.items[k]);
    }
    lam_arena_free(arena);
  }
  return 0;
}

#ifdef LAM_FUZZ_DRIVER
enum { largest = 8192 };

static uint64_t next(uint64_t *state) { /* xorshift64* (S. Vigna) */
  *state ^= *state >> 12;
  *state ^= *state << 25;
  *state ^= *state >> 27;
  return *state * 0x2545f4914f6cdd1dULL;
}

/* A biquadratic by linear rational patch in format i, or (i = 3, 4) as STEP or IGES without weights and with open
 * knots. */
static size_t seed(lam_arena *arena, int i, uint8_t *bytes) {
  static const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 2, 2}, open_u[] = {0, 1, 2, 3, 4, 5},
                      weights[] = {1, 2, 3, 4, 5, 6};
  static const lam_vec3 points[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, .25}};
  lam_spline_surface s = {"roof", {2, 1}, {3, 2}, {i < format_count ? u : open_u, v}, points, NULL};
  if (i < format_count) s.weights = weights;
  lam_model model = {.name = "fuzz", .version = "0", .surface_count = 1, .surfaces = &s};
  lam_text text = {.arena = arena};
  formats[i % format_count]->write(&model, 0, &text);
  if (text.length > largest) fail("the seed is too large");
  memcpy(bytes, text.data, text.length);
  return text.length;
}

/* Swaps, overwrites and repeats a few bytes; numbers change into other numbers most often. */
static size_t mutate(uint64_t *state, uint8_t *bytes, size_t size) {
  static const char likely[] = "00112345679.,-/E#()';$ \nHDPT";
  for (uint64_t n = 1 + next(state) % 4; n && size; n--) {
    size_t at = next(state) % size, to = next(state) % size, length = next(state) % 24;
    switch (next(state) % 6) {
    case 0:
      bytes[at] = (uint8_t)next(state);
      break;
    case 1:
      bytes[at] = bytes[to];
      break;
    case 2:
      size = next(state) % 8 ? size : at;
      break;
    case 3:
      if (size + length > largest || to + length > size) break;
      memmove(bytes + to + length, bytes + to, size - to);
      size += length;
      break;
    case 4: /* a digit */
      while (at < size && (bytes[at] < '0' || bytes[at] > '9')) at++;
      if (at < size) bytes[at] = (uint8_t)('0' + next(state) % 10);
      break;
    default:
      bytes[at] = (uint8_t)likely[next(state) % (sizeof likely - 1)];
    }
  }
  return size;
}

int main(int argc, char **argv) {
  enum { seeds = 5 };
  long rounds = argc > 1 ? atol(argv[1]) : 10000;
  uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
  if (!state) state = 1;
  static uint8_t files[seeds][largest], bytes[largest];
  size_t sizes[seeds];
  lam_arena *arena = lam_arena_new();
  if (!arena) return 1;
  for (int i = 0; i < seeds; i++) sizes[i] = seed(arena, i, files[i]);
  for (long i = 0; i < rounds; i++) {
    size_t size = sizes[i % seeds];
    memcpy(bytes, files[i % seeds], size);
    if (i >= seeds) size = mutate(&state, bytes, size); /* the seeds themselves first */
    LLVMFuzzerTestOneInput(bytes, size);
  }
  lam_arena_free(arena);
  printf("%ld files\n", rounds);
  return 0;
}
#endif
