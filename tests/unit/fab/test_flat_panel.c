/* A panel of a facade, from the shipped design to its flat pattern. */
#include "core/error.h"
#include "core/numbers.h"
#include "design/design.h"
#include "surf/spline/spline_surface.h"
#include "tests/unit/design_fixture.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char path[] = "templates/designs/cladding-panel.yaml";

static int compare(const void *a, const void *b) {
  double p = *(const double *)a, q = *(const double *)b;
  return (p > q) - (p < q);
}

/* Lengths of the four sides of the spline, each as 4000 chords, ascending. */
static void measure_surface(lam_arena *arena, const lam_spline_surface *s, double side[4]) {
  enum { chords = 4000 };
  const lam_nurbs *nurbs = lam_nurbs_make(arena, s);
  for (int k = 0; k < 4; k++) {
    int d = k / 2;
    double low[2], high[2];
    for (int i = 0; i < 2; i++)
      low[i] = s->knots[i][s->degree[i]], high[i] = s->knots[i][s->count[i]];
    lam_vec3 last = {0};
    side[k] = 0;
    for (int i = 0; i <= chords; i++) {
      double t[2];
      lam_jet jet;
      t[d] = low[d] + (high[d] - low[d]) * i / chords;
      t[1 - d] = k % 2 ? high[1 - d] : low[1 - d];
      lam_nurbs_eval(nurbs, t[0], t[1], &jet);
      if (i) side[k] += lam_distance(last, jet.x);
      last = jet.x;
    }
  }
  qsort(side, 4, sizeof *side, compare);
}

/* The outline turns by more than half a right angle at its four corners. */
static void measure_pattern(const lam_path *outline, double side[4]) {
  int n = outline->count, first = -1, corners = 0;
  const lam_vec2 *x = outline->points;
  for (int pass = 0; pass < 2; pass++)
    for (int k = 0; k < n; k++) {
      int i = pass ? (first + k) % n : k;
      lam_vec2 a = x[(i + n - 1) % n], b = x[i], c = x[(i + 1) % n];
      double turn = atan2((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x),
                          (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y));
      bool corner = fabs(turn) > LAM_PI / 4;
      if (!pass) {
        if (corner && first < 0) first = i;
        continue;
      }
      if (corner && corners < 4) side[corners] = 0;
      corners += corner;
      if (corners > 4) fail_msg("the outline has more than four corners");
      side[corners - 1] += hypot(c.x - b.x, c.y - b.y);
    }
  assert_int_equal(corners, 4);
  qsort(side, 4, sizeof *side, compare);
}

/* The frame is 2.4 m long; the sheet strains by 1.3e-4 at one place, by 1.5e-5 in the mean: what is
 * cut is what the frame asks for, to a tenth of a millimeter. */
static void the_pattern_is_true_to_size(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_model model;
  double sides[4], cut[4];
  model = design_built(arena, path, 0, NULL);
  assert_int_equal(model.surface_count, 1);
  assert_int_equal(model.part_count, 1);
  measure_surface(arena, &model.surfaces[0], sides);
  measure_pattern(&model.parts[0].flat->paths[0], cut);
  for (int k = 0; k < 4; k++)
    if (fabs(sides[k] - cut[k]) > 1e-4)
      fail_msg("a side of %.6f m is cut as %.6f m", sides[k], cut[k]);
  lam_arena_free(arena);
}

/* The area of the sheet is that of the surface: strains of both signs cancel to first order where
 * they are small. */
static void the_pattern_has_the_area_of_the_surface(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_model model;
  model = design_built(arena, path, 0, NULL);
  enum { places = 400 };
  const lam_spline_surface *s = &model.surfaces[0];
  const lam_nurbs *nurbs = lam_nurbs_make(arena, s);
  double low[2], length[2], area = 0, cut = 0;
  for (int d = 0; d < 2; d++)
    low[d] = s->knots[d][s->degree[d]], length[d] = s->knots[d][s->count[d]] - low[d];
  for (int k = 0; k < places * places;
       k++) { /* midpoint rule: its error falls with the square, here below 1e-6 */
    lam_jet jet;
    lam_nurbs_eval(nurbs, low[0] + length[0] * (k / places + .5) / places,
                   low[1] + length[1] * (k % places + .5) / places, &jet);
    area += lam_length(lam_cross(jet.u, jet.v)) * length[0] * length[1] / (places * places);
  }
  const lam_path *outline = &model.parts[0].flat->paths[0];
  for (int i = 0; i < outline->count; i++) {
    lam_vec2 a = outline->points[i], b = outline->points[(i + 1) % outline->count];
    cut += (a.x * b.y - a.y * b.x) / 2;
  }
  if (fabs(fabs(cut) / area - 1) > 5e-5)
    fail_msg("%.7f m2 of surface are cut as %.7f m2", area, fabs(cut));
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(the_pattern_is_true_to_size),
                                     cmocka_unit_test(the_pattern_has_the_area_of_the_surface)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
