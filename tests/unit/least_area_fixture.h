/* Boundaries from tests/cases/least-area. */
#ifndef LAM_TESTS_LEAST_AREA_FIXTURE_H
#define LAM_TESTS_LEAST_AREA_FIXTURE_H

#include "surf/area/least_area.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <jansson.h>
#include <string.h>

typedef struct area_fixture {
  lam_arena *arena;
  json_t *file;
} area_fixture;

static inline int area_set_up(void **state) {
  static area_fixture f;
  f.arena = lam_arena_new();
  json_error_t error;
  f.file = json_load_file("tests/cases/least-area/boundaries.json", 0, &error);
  *state = &f;
  return f.arena && f.file ? 0 : -1;
}

static inline int area_tear_down(void **state) {
  area_fixture *f = *state;
  json_decref(f->file);
  lam_arena_free(f->arena);
  return 0;
}

#define AREA_TEST(function) cmocka_unit_test_setup_teardown(function, area_set_up, area_tear_down)

static inline const json_t *area_case(const area_fixture *f, const char *name) {
  const json_t *c;
  size_t i;
  json_array_foreach(json_object_get(f->file, "cases"), i, c) {
    if (!strcmp(json_string_value(json_object_get(c, "name")), name)) return c;
  }
  fail_msg("no case %s", name);
  return NULL;
}

static inline double area_expected(const area_fixture *f, const char *name, const char *what) {
  const json_t *value = json_object_get(area_case(f, name), what);
  if (!json_is_number(value)) fail_msg("%s has no %s", name, what);
  return json_number_value(value);
}

/* The boundary of a case; inner points at the origin, with weight 1. */
static inline lam_spline_surface area_boundary(const area_fixture *f, const char *name) {
  const json_t *c = area_case(f, name), *net = json_object_get(c, "net"),
               *knots = json_object_get(c, "knots");
  lam_spline_surface s = {.degree = {3, 3}, .count = {(int)json_array_size(net), 0}};
  s.count[1] = (int)json_array_size(json_array_get(net, 0));
  for (int d = 0; d < 2; d++) {
    double *t = LAM_NEW(f->arena, double, s.count[d] + 4);
    for (int i = 0; i < s.count[d] + 4; i++)
      t[i] = json_number_value(json_array_get(json_array_get(knots, (size_t)d), (size_t)i));
    s.knots[d] = t;
  }
  lam_vec3 *points = LAM_NEW(f->arena, lam_vec3, s.count[0] * s.count[1]);
  double *weights = LAM_NEW(f->arena, double, s.count[0] * s.count[1]);
  for (int k = 0; k < s.count[0] * s.count[1]; k++) {
    const json_t *p =
        json_array_get(json_array_get(net, (size_t)(k / s.count[1])), (size_t)(k % s.count[1]));
    weights[k] = 1;
    if (!json_is_array(p)) continue;
    for (size_t i = 0; i < 3; i++) (&points[k].x)[i] = json_number_value(json_array_get(p, i));
    weights[k] = json_number_value(json_array_get(p, 3));
  }
  s.points = points;
  s.weights = weights;
  return s;
}

static inline void assert_relative(double value, double expected, double tolerance,
                                   const char *name, const char *what) {
  if (fabs(value / expected - 1) <= tolerance) return;
  fail_msg("%s, %s: %.12g, expected %.12g (off by %.2e, allowed %.1e)", name, what, value, expected,
           value / expected - 1, tolerance);
}

#endif
