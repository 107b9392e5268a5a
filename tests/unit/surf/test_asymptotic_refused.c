/* Corner data that no surface can have are refused with a message that says why; what is allowed at
 * the limit works. */
#include "tests/unit/asymptotic_quad_fixture.h"

static void test_refused(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "refused.json"), *c;
  size_t i;
  assert_int_equal(json_array_size(cases), 11);
  json_array_foreach(cases, i, c) {
    static const int degrees[] = {
        [LAM_QUAD_BI11] = 5, [LAM_QUAD_BI13] = 4, [LAM_QUAD_B_SPLINE] = 3};
    const char *id = json_string_value(json_object_get(c, "id")),
               *key = json_string_value(json_object_get(c, "key"));
    const char *message = json_string_value(json_object_get(c, "message"));
    lam_quad_form form = quad_form(json_object_get(c, "form"));
    lam_quad_corners q = quad_corners(c, json_object_get(c, "tangent_points"), degrees[form]);
    lam_errors errors = {.arena = f->arena};
    lam_asymptotic_patch patch;
    bool made = lam_asymptotic_patch_make(f->arena, &q, form, (lam_location){0}, &errors, &patch);
    if (!*message) { /* planar data: the surface is that plane */
      if (!made) fail_msg("%s: refused: %s", id, errors.first->text);
      for (int k = 0; k < patch.surface.count[0] * patch.surface.count[1]; k++)
        assert_near(patch.surface.points[k].z, 0, 1e-12);
      continue;
    }
    if (made) fail_msg("%s: not refused", id);
    assert_true(errors.count > 0);
    if (strcmp(errors.first->key, key) != 0 || !strstr(errors.first->text, message))
      fail_msg("%s: %s: \"%s\", expected %s and \"%s\"", id, errors.first->key, errors.first->text,
               key, message);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
