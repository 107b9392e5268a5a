/* Small STEP files around a few entities, and the curves that are read of them. */
#ifndef LAM_TESTS_STEP_FIXTURE_H
#define LAM_TESTS_STEP_FIXTURE_H

#include "files_fixture.h"

#define METRE "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"

/* A file of these entities whose unit of length is entity #90; more: further entities. */
static inline const char *file_of(lam_arena *arena, const char *unit, const char *more) {
  return lam_arena_printf(arena,
                          "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#80=(GLOBAL_UNIT_ASSIGNED_"
                          "CONTEXT((#90))REPRESENTATION_CONTEXT('',''));\n#90=%s;\n"
                          "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n"
                          "#3=CARTESIAN_POINT('',(4.,0.,0.));\n#4=CARTESIAN_POINT('',(4.,4.,0.));\n"
                          "%s\nENDSEC;\nEND-ISO-10303-21;\n",
                          unit, more);
}

/* Reads the curves; NULL, or the message. */
static inline const char *read_curves(lam_arena *arena, const char *text, lam_curve_list *list) {
  lam_errors errors = {.arena = arena};
  if (lam_format_step.read_curves(arena, text, strlen(text), (lam_location){.file = "x"}, &errors,
                                  list))
    return NULL;
  assert_int_equal(errors.count, 1);
  return errors.first->text;
}

/* The only curve of these entities, in meters. */
static inline lam_spline_curve curve_of(lam_arena *arena, const char *entities) {
  lam_curve_list list;
  const char *message = read_curves(arena, file_of(arena, METRE, entities), &list);
  if (message) fail_msg("%s: %s", entities, message);
  if (list.count != 1) fail_msg("%s: %d curves", entities, list.count);
  return list.items[0].spline;
}

/* Fails when the control points are others than these. */
static inline void assert_points(const lam_spline_curve *c, int count, const lam_vec3 *points,
                                 const char *what) {
  if (c->count != count) fail_msg("%s: %d points, expected %d", what, c->count, count);
  for (int i = 0; i < count; i++)
    if (!(lam_distance(c->points[i], points[i]) <= 1e-14))
      fail_msg("%s, point %d: (%.17g, %.17g, %.17g), expected (%g, %g, %g)", what, i,
               c->points[i].x, c->points[i].y, c->points[i].z, points[i].x, points[i].y,
               points[i].z);
}

#endif
