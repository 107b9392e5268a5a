/* Names of parts: letters of rows, numbers behind names, names that stand twice. */
#include "fab/part_names.h"
#include "tests/unit/fab_fixture.h"

static void add(lam_workshop *shop, const char *name) {
  lam_workshop_part(shop, (lam_part){.name = name, .kind = "panels"});
}

/* As columns of a spreadsheet are counted: Z is followed by AA, AZ by BA, ZZ by AAA. */
static void letters_go_on_behind_z(void **state) {
  lam_arena *arena = *state;
  lam_workshop shop = {.arena = arena};
  assert_string_equal(lam_part_letters(&shop, 'P'), "P");

  for (int row = 0; row < 26 * 27 + 1; row++)
    add(&shop, lam_arena_printf(arena, "%s%02d", lam_part_letters(&shop, 'A'), row));
  static const struct {
    int row;
    const char *name;
  } expected[] = {{0, "A00"},   {25, "Z25"},    {26, "AA26"},   {51, "AZ51"},
                  {52, "BA52"}, {701, "ZZ701"}, {702, "AAA702"}};
  for (size_t i = 0; i < sizeof expected / sizeof *expected; i++)
    assert_string_equal(shop.parts[expected[i].row].name, expected[i].name);
  assert_null(lam_part_name_twice(&shop));
}

/* Whatever kind of part has them; names that only begin so are no names of rows. */
static void letters_of_other_kinds_are_passed_over(void **state) {
  lam_workshop shop = {.arena = *state};
  add(&shop, "S1");
  add(&shop, "Tube");
  add(&shop, "UA1");
  add(&shop, "V:1");
  assert_string_equal(lam_part_letters(&shop, 'S'), "T");
  add(&shop, "T9");
  assert_string_equal(lam_part_letters(&shop, 'S'), "U");
  add(&shop, "U0");
  assert_string_equal(lam_part_letters(&shop, 'S'), "V");
}

static void a_name_is_given_once(void **state) {
  lam_workshop shop = {.arena = *state};
  for (int i = 0; i < 3; i++) add(&shop, lam_part_name(&shop, "bolt-M8"));
  assert_string_equal(shop.parts[0].name, "bolt-M8");
  assert_string_equal(shop.parts[1].name, "bolt-M8-2");
  assert_string_equal(shop.parts[2].name, "bolt-M8-3");
  assert_null(lam_part_name_twice(&shop));

  add(&shop, "a");
  add(&shop, "bolt-M8-3");
  assert_string_equal(lam_part_name_twice(&shop), "bolt-M8-3");
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(letters_go_on_behind_z),
      TEST(letters_of_other_kinds_are_passed_over),
      TEST(a_name_is_given_once),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
