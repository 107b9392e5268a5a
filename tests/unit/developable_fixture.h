/* What the tests of nearly developable surfaces share: the boundaries of tests/cases/developable.
 */
#ifndef LAM_TESTS_DEVELOPABLE_FIXTURE_H
#define LAM_TESTS_DEVELOPABLE_FIXTURE_H

#include "core/arena.h"
#include "curve/bspline/basis.h"
#include "surf/developable/developable.h"
#include "surf/spline/coons_patch.h"
#include <jansson.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

typedef struct dev_fixture {
  lam_arena *arena;
  json_t *file, *cases;
} dev_fixture;

static inline int dev_set_up(void **state) {
  static dev_fixture f;
  json_error_t error;
  f = (dev_fixture){.arena = lam_arena_new(),
                    .file = json_load_file("tests/cases/developable/boundaries.json", 0, &error)};
  f.cases = json_object_get(f.file, "cases");
  *state = &f;
  return f.arena && f.cases ? 0 : -1;
}

static inline int dev_tear_down(void **state) {
  dev_fixture *f = *state;
  json_decref(f->file);
  lam_arena_free(f->arena);
  return 0;
}

#define DEV_TEST(function) cmocka_unit_test_setup_teardown(function, dev_set_up, dev_tear_down)

static inline const char *dev_name(const json_t *c) {
  return json_string_value(json_object_get(c, "name"));
}
static inline double dev_number(const json_t *c, const char *key) {
  json_t *value = json_object_get(c, key);
  if (!json_is_number(value)) fail_msg("%s has no number %s", dev_name(c), key);
  return json_number_value(value);
}

/* The case whose name begins with "D3", say. */
static inline json_t *dev_case(dev_fixture *f, const char *start) {
  size_t i;
  json_t *c;
  json_array_foreach(f->cases, i, c) if (!strncmp(dev_name(c), start, strlen(start))) return c;
  fail_msg("no case %s", start);
  return NULL;
}

static inline const lam_vec3 *dev_curve(lam_arena *arena, const json_t *points, int *count) {
  *count = (int)json_array_size(points);
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, *count);
  for (int k = 0; k < *count; k++) {
    json_t *p = json_array_get(points, (size_t)k);
    x[k] = lam_v3(json_number_value(json_array_get(p, 0)), json_number_value(json_array_get(p, 1)),
                  json_number_value(json_array_get(p, 2)));
  }
  return x;
}

/* The Coons patch over the boundary of a case. */
static inline lam_spline_surface dev_coons(lam_arena *arena, const json_t *c) {
  static const char *const names[LAM_SIDES] = {"r1", "r2", "r3", "r4"};
  lam_sides sides = {0};
  for (int i = 0; i < LAM_SIDES; i++) {
    lam_spline_curve *side = &sides.side[i];
    side->points = dev_curve(arena, json_object_get(c, names[i]), &side->count);
    side->degree = side->count - 1;
    double *knots = LAM_NEW(arena, double, 2 * side->count);
    lam_knots_clamped(side->degree, side->count, knots);
    side->knots = knots;
  }
  return lam_coons_surface(arena, &sides, LAM_COONS_BILINEAR);
}

/* The surface of least ||K||_2 over the boundary of a case. */
static inline lam_spline_surface dev_solved(lam_arena *arena, const json_t *c) {
  lam_spline_surface s = dev_coons(arena, c);
  lam_developable_result r =
      lam_developable_solve(arena, &s, (lam_developable_options){.power = 2});
  if (!r.converged) fail_msg("%s: %s", dev_name(c), r.reason);
  return s;
}

/* Fails, with the case and both numbers, when value is off by more than the share. */
static inline void dev_close(const char *name, const char *what, double value, double expected,
                             double share) {
  if (!(fabs(value - expected) <= share * fabs(expected)))
    fail_msg("%s: %s is %.12g, expected %.12g (off by %.2g)", name, what, value, expected,
             value / expected - 1);
}

/* Fails, naming the place, when value is further than tolerance from expected. */
#define dev_near(value, expected, tolerance)                                                       \
  dev_near_at(value, expected, tolerance, __FILE__, __LINE__)
static inline void dev_near_at(double value, double expected, double tolerance, const char *file,
                               int line) {
  if (!(fabs(value - expected) <= tolerance))
    fail_msg("%s:%d: %.12g, expected %.12g within %.2g", file, line, value, expected, tolerance);
}

#endif
