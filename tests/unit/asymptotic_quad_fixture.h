/* What the tests of asymptotic quadrilaterals share: cases from tests/cases/asymptotic-quads, and
 * evaluation of spline surfaces by de Boor's algorithm on control points and their differences,
 * which the program does not use. */
#ifndef LAM_TESTS_ASYMPTOTIC_QUAD_FIXTURE_H
#define LAM_TESTS_ASYMPTOTIC_QUAD_FIXTURE_H

#include "surf/asymptotic/asymptotic_quad.h"
#include "tests/unit/net_fixture.h"
#include <jansson.h>

typedef struct quad_fixture {
  lam_arena *arena;
  lam_errors errors;
  json_t *file;
} quad_fixture;

static inline int quad_set_up(void **state) {
  static quad_fixture f;
  f = (quad_fixture){.arena = lam_arena_new()};
  f.errors.arena = f.arena;
  *state = &f;
  return f.arena ? 0 : -1;
}

static inline int quad_tear_down(void **state) {
  quad_fixture *f = *state;
  if (f->file) json_decref(f->file);
  lam_arena_free(f->arena);
  return 0;
}

#define QUAD_TEST(function) cmocka_unit_test_setup_teardown(function, quad_set_up, quad_tear_down)

/* The cases of a file. */
static inline json_t *quad_cases(quad_fixture *f, const char *name) {
  json_error_t error;
  f->file = json_load_file(lam_arena_printf(f->arena, "tests/cases/asymptotic-quads/%s", name), 0,
                           &error);
  if (!f->file) fail_msg("%s: %s, line %d", name, error.text, error.line);
  return json_object_get(f->file, "cases");
}

static inline double quad_number(const json_t *list, size_t i) {
  const json_t *value = json_array_get(list, i);
  if (!json_is_number(value)) fail_msg("entry %zu is no number", i);
  return json_number_value(value);
}

static inline lam_vec3 quad_vector(const json_t *list) {
  return lam_v3(quad_number(list, 0), quad_number(list, 1), quad_number(list, 2));
}

static inline lam_quad_form quad_form(const json_t *name) {
  for (int k = 0; k < LAM_QUAD_FORM_COUNT; k++)
    if (!strcmp(lam_quad_form_names[k], json_string_value(name))) return (lam_quad_form)k;
  fail_msg("no form %s", json_string_value(name));
  return LAM_QUAD_FORM_COUNT;
}

static const int quad_ends[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};

/* Corner data of a case. Tangents from the second control points of a boundary of this degree: r' =
 * n / u (P1 - P0), u the first inner knot or 1. */
static inline lam_quad_corners quad_corners(const json_t *c, const json_t *tangent_points,
                                            int degree) {
  lam_quad_corners q = {.weight = {1, 1, 1, 1}};
  json_t *knots = json_object_get(c, "knots"), *curvature = json_object_get(c, "curvature");
  for (int k = 0; k < 4; k++) {
    q.corner[k] = quad_vector(json_array_get(json_object_get(c, "corners"), k));
    if (json_object_get(c, "weight")) q.weight[k] = quad_number(json_object_get(c, "weight"), k);
  }
  for (int d = 0; knots && d < 2; d++)
    for (int k = 0; k < 2; k++) q.knots[d][k] = quad_number(json_array_get(knots, d), k);
  for (int i = 0; i < 4; i++)
    for (int e = 0; e < 2; e++) {
      json_t *points = json_array_get(tangent_points, i);
      double width = knots ? (e ? 1 - q.knots[i % 2][1] : q.knots[i % 2][0]) : 1;
      lam_vec3 edge = lam_sub(quad_vector(json_array_get(points, e)), q.corner[quad_ends[i][e]]);
      q.tangent[i][e] = lam_scale(edge, (e ? -1 : 1) * degree / width);
      q.side[i][e] = (int)quad_number(json_array_get(json_object_get(c, "side"), i), e);
      if (curvature) q.curvature[i][e] = quad_number(json_array_get(curvature, i), e);
    }
  return q;
}

/* De Boor's algorithm: count homogeneous points of 4 numbers, at t. The points are overwritten. */
static inline void quad_de_boor(int degree, int count, const double *knots, double t,
                                double (*points)[4], double result[4]) {
  int span = degree;
  while (span < count - 1 && t >= knots[span + 1]) span++;
  for (int r = 1; r <= degree; r++)
    for (int j = span; j > span - degree + r - 1; j--) {
      double a = (t - knots[j]) / (knots[j + degree - r + 1] - knots[j]);
      for (int c = 0; c < 4; c++) points[j][c] = (1 - a) * points[j - 1][c] + a * points[j][c];
    }
  memcpy(result, points[span], 4 * sizeof(double));
}

/* The derivative of this order of a curve: differences of the points, then de Boor. */
static inline void quad_derivative(int degree, int count, const double *knots, int order, double t,
                                   double (*points)[4], double result[4]) {
  for (int k = 0; k < order; k++) {
    for (int i = 0; i < count - 1; i++) {
      double width = knots[i + degree + 1] - knots[i + 1];
      for (int c = 0; c < 4; c++)
        points[i][c] = width > 0 ? degree * (points[i + 1][c] - points[i][c]) / width : 0;
    }
    degree--;
    count--;
    knots++;
  }
  quad_de_boor(degree, count, knots, t, points, result);
}

enum { QUAD_MAX = 64 };

/* x and its derivatives at (u,v): jet[a][b] for a + b <= 2. */
static inline void quad_jet(const lam_spline_surface *s, double u, double v, lam_vec3 jet[3][3]) {
  double h[3][3][4];
  for (int a = 0; a < 3; a++)
    for (int b = 0; a + b < 3; b++) {
      double rows[QUAD_MAX][4], row[QUAD_MAX][4];
      for (int i = 0; i < s->count[0]; i++) {
        for (int j = 0; j < s->count[1]; j++) {
          int at = i * s->count[1] + j;
          double w = s->weights ? s->weights[at] : 1;
          row[j][0] = w * s->points[at].x;
          row[j][1] = w * s->points[at].y;
          row[j][2] = w * s->points[at].z;
          row[j][3] = w;
        }
        quad_derivative(s->degree[1], s->count[1], s->knots[1], b, v, row, rows[i]);
      }
      quad_derivative(s->degree[0], s->count[0], s->knots[0], a, u, rows, h[a][b]);
    }
#define H(a, b) lam_v3(h[a][b][0], h[a][b][1], h[a][b][2])
#define W(a, b) h[a][b][3]
  double w = 1 / W(0, 0);
  lam_vec3 x = jet[0][0] = lam_scale(H(0, 0), w);
  lam_vec3 xu = jet[1][0] = lam_scale(lam_along(H(1, 0), -W(1, 0), x), w);
  lam_vec3 xv = jet[0][1] = lam_scale(lam_along(H(0, 1), -W(0, 1), x), w);
  jet[2][0] = lam_scale(lam_along(lam_along(H(2, 0), -2 * W(1, 0), xu), -W(2, 0), x), w);
  jet[0][2] = lam_scale(lam_along(lam_along(H(0, 2), -2 * W(0, 1), xv), -W(0, 2), x), w);
  jet[1][1] = lam_scale(
      lam_along(lam_along(lam_along(H(1, 1), -W(1, 0), xv), -W(0, 1), xu), -W(1, 1), x), w);
#undef H
#undef W
}

/* The boundary is asymptotic: |k_n| / k and the sine between normal and binormal at 101 parameters
 * of each curve; for a straight curve, that it is straight: distance from its chord. */
static inline void quad_assert_asymptotic(const char *id, const lam_spline_surface *s,
                                          const lam_quad_corners *q, double tolerance) {
  for (int i = 0; i < 4; i++)
    for (int g = 1; g <= 101; g++) {
      double t = g / 102.0 + 1e-4 * (g == 34 || g == 51 || g == 68); /* off simple knots */
      lam_vec3 jet[3][3];
      quad_jet(s, i % 2 ? i / 2 : t, i % 2 ? t : i / 2, jet);
      lam_vec3 normal = lam_unit(lam_cross(jet[1][0], jet[0][1])),
               d = i % 2 ? jet[0][1] : jet[1][0];
      lam_vec3 dd = i % 2 ? jet[0][2] : jet[2][0], bend = lam_cross(d, dd);
      double kn = fabs(lam_dot(normal, dd)) / lam_dot(d, d),
             k = lam_length(bend) / pow(lam_length(d), 3);
      if (q->side[i][0] == 0) {
        lam_vec3 chord = lam_sub(q->corner[quad_ends[i][1]], q->corner[quad_ends[i][0]]);
        lam_vec3 at = lam_sub(jet[0][0], q->corner[quad_ends[i][0]]);
        double off = lam_length(lam_cross(chord, at)) / lam_dot(chord, chord);
        if (!(off <= tolerance))
          fail_msg("%s: r%d is %g of its length off the chord at %g", id, i + 1, off, t);
        continue;
      }
      double sine = lam_length(lam_cross(normal, lam_unit(bend)));
      if (!(kn / k <= tolerance))
        fail_msg("%s: |k_n|/k of r%d at %g is %g, at most %g", id, i + 1, t, kn / k, tolerance);
      if (!(sine <= tolerance)) fail_msg("%s: sine(N, b) of r%d at %g is %g", id, i + 1, t, sine);
    }
}

/* Torsions of the two curves at every corner add up to 0 (in units of the size of the patch). */
static inline void quad_assert_torsions(const char *id, const lam_quad_boundary *b,
                                        const lam_quad_corners *q) {
  static const int meeting[4][4] = {{0, 0, 1, 0}, {0, 1, 3, 0}, {2, 0, 1, 1}, {2, 1, 3, 1}};
  double size = lam_distance(q->corner[0], q->corner[3]);
  for (int c = 0; c < 4; c++) {
    const int *m = meeting[c];
    if (q->side[m[0]][0] == 0 || q->side[m[2]][0] == 0) continue;
    double sum = b->torsion[m[0]][m[1]] + b->torsion[m[2]][m[3]];
    if (!(fabs(sum) * size <= 1e-10))
      fail_msg("%s: torsions at corner %d add up to %g", id, c, sum);
  }
}

static inline void quad_assert_close(const char *id, const char *what, double value,
                                     double expected, double relative) {
  if (!(fabs(value - expected) <= relative * fmax(fabs(expected), 1e-3)))
    fail_msg("%s: %s is %.12g, expected %.12g within %g", id, what, value, expected, relative);
}

/* A table [curve][end] of expected values, when the case has it. */
static inline void quad_assert_table(const char *id, const json_t *expected, const char *key,
                                     double values[4][2], double relative) {
  const json_t *table = json_object_get(expected, key);
  for (int i = 0; table && i < 4; i++)
    for (int e = 0; e < 2; e++)
      quad_assert_close(id, key, values[i][e], quad_number(json_array_get(table, i), e), relative);
}

/* Points of the surface, within a fraction of its size. */
static inline void quad_assert_points(const char *id, const json_t *expected,
                                      const lam_spline_surface *s, double relative) {
  const json_t *params = json_object_get(expected, "params"),
               *points = json_object_get(expected, "points");
  double size = lam_distance(s->points[0], s->points[s->count[0] * s->count[1] - 1]);
  for (size_t a = 0; a < json_array_size(params); a++)
    for (size_t b = 0; b < json_array_size(params); b++) {
      lam_vec3 jet[3][3], want = quad_vector(json_array_get(json_array_get(points, a), b));
      quad_jet(s, quad_number(params, a), quad_number(params, b), jet);
      double distance = lam_distance(jet[0][0], want) / size;
      if (!(distance <= relative))
        fail_msg("%s: point %zu, %zu is %g of the size away", id, a, b, distance);
    }
}

/* Makes the surface of one expectation and checks what all have in common. */
static inline lam_asymptotic_patch quad_check(quad_fixture *f, const json_t *c,
                                              const json_t *expected, int degree, double relative,
                                              double points) {
  const char *name = json_string_value(json_object_get(c, "id"));
  const char *id = lam_arena_printf(f->arena, "%s %s", name,
                                    json_string_value(json_object_get(expected, "form")));
  const json_t *own =
      json_object_get(expected, "tangent_points"); /* rounded otherwise than those of the case */
  lam_quad_corners q = quad_corners(c, own ? own : json_object_get(c, "tangent_points"), degree);
  lam_asymptotic_patch patch;
  bool made = lam_asymptotic_patch_make(f->arena, &q, quad_form(json_object_get(expected, "form")),
                                        (lam_location){0}, &f->errors, &patch);
  if (!made) fail_msg("%s: %s", id, f->errors.first ? f->errors.first->text : "no message");
  quad_assert_asymptotic(id, &patch.surface, &q, 1e-10);
  quad_assert_torsions(id, &patch.boundary, &q);
  quad_assert_table(id, expected, "slide", patch.boundary.slide, relative);
  quad_assert_table(id, expected, "cross", patch.boundary.cross, relative);
  if (json_object_get(c, "curvature"))
    quad_assert_table(id, c, "curvature", patch.boundary.curvature, 1e-9);
  else
    quad_assert_table(id, expected, "curvature", patch.boundary.curvature, relative);
  const json_t *bending = json_object_get(expected, "boundary_energy"),
               *plate = json_object_get(expected, "thin_plate");
  if (bending)
    quad_assert_close(id, "boundary energy", patch.boundary.energy, json_number_value(bending),
                      relative);
  quad_assert_close(id, "thin-plate energy", patch.energy, json_number_value(plate), relative);
  quad_assert_close(id, "energy by another rule",
                    lam_thin_plate_energy(f->arena, &patch.surface, 20), patch.energy, 1e-9);
  quad_assert_points(id, expected, &patch.surface, points);
  return patch;
}

#endif
