/* What the tests of surfaces share: surfaces made from design texts, a fixed sequence of random
 * numbers, differences.
 */
#ifndef LAM_TESTS_SURFACE_FIXTURE_H
#define LAM_TESTS_SURFACE_FIXTURE_H

#include "core/arena.h"
#include "design/design.h"
#include "surf/surface.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

enum { POINTS = 40 }; /* random points per surface and chart */

typedef struct lam_fixture {
  lam_arena *arena;
  lam_errors errors;
  uint64_t random;
} lam_fixture;

static inline int set_up(void **state) {
  static lam_fixture f;
  f = (lam_fixture){.arena = lam_arena_new(), .random = 2024};
  f.errors.arena = f.arena;
  *state = &f;
  return 0;
}

static inline int tear_down(void **state) {
  lam_arena_free(((lam_fixture *)*state)->arena);
  return 0;
}

/* A fixed sequence of numbers, spread evenly over a range without its ends. */
static inline double next_in(lam_fixture *f, const double range[2]) {
  f->random = f->random * 6364136223846793005u + 1442695040888963407u;
  double t = (double)(f->random >> 11) / 9007199254740992.0;
  return range[0] + (range[1] - range[0]) * (0.03 + 0.94 * t);
}

/* The surface of this name with the keys of a design text ("" for the defaults); kind NULL when it
 * is refused. */
static inline lam_surface make(lam_fixture *f, const char *name, const char *text) {
  const lam_row_head *head = lam_registry_find(&lam_surfaces, name);
  assert_non_null(head);
  lam_row row = {.head = head, .params = lam_arena_alloc(f->arena, 1, head->params_size + 1)};
  if (!*text) text = "{}";
  if (head->keys &&
      !lam_keys_parse(f->arena, head->keys, text, strlen(text), NULL, &f->errors, row.params))
    return (lam_surface){0};
  if (((const lam_surface_kind *)head)->reads_file) { /* stands for any that was read */
    lam_surface read = make(f, "bspline", "");
    ((lam_surface_source *)row.params)->surface = read.kind->spline(read.data);
  }
  return lam_surface_make(f->arena, &row, &f->errors);
}

/* The same, with the errors shown. */
static inline lam_surface made(lam_fixture *f, const char *name, const char *text) {
  lam_surface surface = make(f, name, text);
  for (const lam_error *e = f->errors.first; e; e = e->next)
    print_error("%s: %s: %s\n", name, e->key, e->text);
  assert_non_null(surface.kind);
  return surface;
}

static inline void assert_near_at(double value, double expected, double tolerance, const char *name,
                                  const char *what, double p, double q) {
  if (fabs(value - expected) <= tolerance) return;
  fail_msg("%s, %s at (%.6f, %.6f): %.12g, expected %.12g +- %.1e", name, what, p, q, value,
           expected, tolerance);
}

static inline void assert_near3(lam_vec3 value, lam_vec3 expected, double tolerance,
                                const char *name, const char *what, double p, double q) {
  assert_near_at(lam_distance(value, expected), 0, tolerance * (1 + lam_length(expected)), name,
                 what, p, q);
}

/* Central differences, extrapolated to an error of order h^6. */
static const double weights[] = {1.5, -0.6, 0.1};

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

#endif
