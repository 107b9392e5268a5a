/* What tests of files of curves and surfaces share: numbers, surfaces, files that other programs
 * might have written. */
#ifndef LAM_TESTS_FILES_FIXTURE_H
#define LAM_TESTS_FILES_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "formats/format.h"
#include "tests/unit/asserts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const lam_format lam_format_surface, lam_format_step, lam_format_iges,
    lam_format_surface_obj, lam_format_obj;

static inline int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static inline int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

/* ---- surfaces ---- */

/* Numbers of many digits, of all sizes, from a fixed sequence. */
static inline double next_number(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 9007199254740992.0;
}

static inline lam_spline_surface some_surface(lam_arena *arena, int p, int q, int n, int m,
                                              bool rational, bool clamped) {
  lam_spline_surface s = {.name = "surface", .degree = {p, q}, .count = {n, m}};
  uint64_t state = (uint64_t)(1000 * p + 100 * q + 10 * n + m);
  for (int d = 0; d < 2; d++) {
    int total = s.count[d] + s.degree[d] + 1;
    double *knots = LAM_NEW(arena, double, total), t = -0.3;
    for (int i = 0; i < total; i++) {
      bool inside = i > s.degree[d] && i <= s.count[d];
      if (!clamped || inside)
        t += i == s.degree[d] + 2 ? 0 : next_number(&state); /* one inner knot stands twice */
      knots[i] = t;
    }
    s.knots[d] = knots;
  }
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, n * m);
  double *weights = LAM_NEW(arena, double, n *m);
  for (int i = 0; i < n * m; i++) {
    double x = next_number(&state), y = next_number(&state), z = next_number(&state);
    points[i] = lam_v3(12 * x - 3, 1e-5 * y, 4e4 * z);
    weights[i] = 0.2 + next_number(&state);
  }
  s.points = points;
  s.weights = rational ? weights : NULL;
  return s;
}

static inline lam_model model_of(const lam_spline_surface *surfaces, int count) {
  return (lam_model){.name = "it-s",
                     .title = "Peter's \\ t\u00e9nt",
                     .version = "0",
                     .surface_count = count,
                     .surfaces = surfaces};
}

static inline lam_text written(lam_arena *arena, const lam_format *format, const lam_model *model) {
  lam_text text = {.arena = arena};
  assert_int_equal(format->count(model), 1);
  assert_int_equal(format->write(model, 0, &text), LAM_OK);
  return text;
}

static inline bool try_read(lam_arena *arena, const lam_format *format, const char *bytes,
                            size_t size, lam_spline_list *list, const char **message) {
  lam_errors errors = {.arena = arena};
  bool good = format->read_surfaces(arena, bytes, size, (lam_location){.file = "x"}, &errors, list);
  assert_int_equal(errors.count, good ? 0 : 1); /* one message */
  *message =
      good ? NULL
           : lam_arena_printf(arena, "%d: %s", errors.first->location.line, errors.first->text);
  return good;
}

static inline lam_spline_list read_back(lam_arena *arena, const lam_format *format, lam_text text) {
  lam_spline_list list;
  const char *message;
  if (!try_read(arena, format, text.data, text.length, &list, &message))
    fail_msg("%s: %s", format->name, message);
  return list;
}

/* ---- what other programs write ---- */

/* The text with the first `old` replaced. */
static inline char *replaced(lam_arena *arena, const char *text, const char *old, const char *by) {
  const char *at = strstr(text, old);
  assert_non_null(at);
  return lam_arena_printf(arena, "%.*s%s%s", (int)(at - text), text, by, at + strlen(old));
}

/* A line of an IGES file, filled up to its section and number. */
static inline void add_line(lam_text *text, const char *data, char section, int number) {
  lam_text_printf(text, "%-72s%c%7d\r\n", data, section, number);
}

typedef struct bad_case {
  const char *old, *by,
      *message; /* what is replaced in a good file, by what, and what is said then */
} bad_case;

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

#endif
