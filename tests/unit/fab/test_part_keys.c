/* The keys of all kinds of parts, as the manual gives them: defaults, limits (meters and
 * radians) and choices. That values beyond a limit are refused is tested with the keys
 * (tests/unit/design/test_keys.c). */
#include "core/error.h"
#include "design/design.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

static const char materials[] = "(materials)";

typedef struct key_row {
  const char *name, *initial;
  double least, most;
  const char *choices; /* NULL: it is no choice */
} key_row;

static const key_row table[] = {
    {"lamella.families", "[0, 1]", 0, 1, NULL},
    {"lamella.height", "100 mm", 0.001, 10, NULL},
    {"lamella.thickness", "1.5 mm", 1e-5, 1, NULL},
    {"lamella.pair", "0", 0, 10, NULL},
    {"lamella.every", "1", 1, 1000, NULL},
    {"lamella.extend", "50 mm", 0, 10, NULL},
    {"lamella.joint.kind", "half-lap", 0, 0, "half-lap none"},
    {"lamella.joint.clearance", "0.25 mm", 1e-5, 0.01, NULL},
    {"lamella.joint.scissor", "0", 0, 1.5707963267948966, NULL},
    {"lamella.material", "steel", 0, 0, materials},
    {"lamella.boundary", "yes", 0, 0, NULL},
    {"node-connector.bolt", "M8", 0, 0, "M6 M8 M10 M12"},
    {"node-connector.washer", "4 mm", 0.0001, 0.1, NULL},
    {"node-connector.gap", "1 mm", 1e-5, 0.1, NULL},
    {"node-connector.arm", "28 mm", 0.001, 1, NULL},
    {"node-connector.material", "steel", 0, 0, materials},
    {"panels.thickness", "10 mm", 1e-5, 1, NULL},
    {"panels.gap", "10 mm", 0, 1, NULL},
    {"panels.offset", "0", -10, 10, NULL},
    {"panels.side", "outward", 0, 0, "outward centered inward"},
    {"panels.faces", "all", 0, 0, "all checker bands-0 bands-1"},
    {"panels.flat", "0.001", 0, 0.1, NULL},
    {"panels.material", "aluminum", 0, 0, materials},
    {"panels.second", "aluminum", 0, 0, materials},
    {"bars.diameter", "60 mm", 0.0001, 2, NULL},
    {"bars.profile", "round", 0, 0, "round square"},
    {"bars.families", "[0, 1]", 0, 1, NULL},
    {"bars.edges", "all", 0, 0, "all inner boundary"},
    {"bars.rim", "0", 0, 2, NULL},
    {"bars.wall", "0", 0, 1, NULL},
    {"bars.gap", "0.2 mm", 0, 0.1, NULL},
    {"bars.offset", "0", -10, 10, NULL},
    {"bars.material", "steel", 0, 0, materials},
    {"bars.second", "steel", 0, 0, materials},
    {"support.height", "100 mm", 0.0001, 10, NULL},
    {"support.offset", "0", -10, 10, NULL},
    {"support.thickness", "8 mm", 1e-5, 1, NULL},
    {"support.gap", "2 mm", 0, 0.1, NULL},
    {"support.along", "auto", 0, 0, "auto normals axes"},
    {"support.edges", "all", 0, 0, "all inner"},
    {"support.flat", "0.001", 0, 0.1, NULL},
    {"support.material", "steel", 0, 0, materials},
    {"circles.circles", "incircles", 0, 0, "incircles circumcircles none"},
    {"circles.spheres", "no", 0, 0, NULL},
    {"circles.drawn", "no", 0, 0, NULL},
    {"circles.width", "20 mm", 1e-5, 10, NULL},
    {"circles.thickness", "10 mm", 1e-5, 1, NULL},
    {"circles.gap", "2 mm", 0, 1, NULL},
    {"circles.material", "plywood", 0, 0, materials},
    {"gauss-image.radius", "1 m", 0.001, 10000, NULL},
    {"gauss-image.at", "[0, 0, 0]", -1e6, 1e6, NULL},
    {"gauss-image.ball", "no", 0, 0, NULL},
    {"gauss-image.material", "card", 0, 0, materials},
    {"flat-pattern.thickness", "2 mm", 1e-5, 0.1, NULL},
    {"flat-pattern.marks", "3", 0, 1000, NULL},
    {"flat-pattern.strain", "0", 0, 1, NULL},
    {"flat-pattern.material", "aluminum", 0, 0, materials},
    {"skin.from", "net", 0, 0, "net surface"},
    {"skin.every", "1", 1, 1000, NULL},
    {"skin.thickness", "10 mm", 1e-5, 2, NULL},
    {"skin.offset", "0", -10, 10, NULL},
    {"skin.subdivisions", "6", 1, 200, NULL},
    {"skin.pieces", "whole", 0, 0, "whole cells"},
    {"skin.material", "concrete", 0, 0, materials},
    {"frames.count", "7", 1, 1000, NULL},
    {"frames.size", "200 mm", 0.0001, 10, NULL},
    {"frames.gap", "10 mm", 0, 10, NULL},
    {"frames.thickness", "5 mm", 1e-5, 1, NULL},
    {"frames.material", "brass", 0, 0, materials},
};
enum { rows = sizeof table / sizeof *table };

/* The choices of a key in turn, with spaces between them. */
static const char *choices_of(lam_arena *arena, const lam_key *key) {
  const char *all = "";
  if (!key->choices) return NULL;
  if (key->choices == lam_material_names) return materials;
  for (int i = 0; key->choices[i]; i++)
    all = lam_arena_printf(arena, "%s%s%s", all, i ? " " : "", key->choices[i]);
  return all;
}

static int compare(lam_arena *arena, const char *row, const lam_key *keys, int at) {
  for (const lam_key *key = keys; key->name; key++) {
    const char *name = lam_arena_printf(arena, "%s.%s", row, key->name);
    if (key->keys) {
      at = compare(arena, name, key->keys, at);
      continue;
    }
    if (at == rows) fail_msg("%s is not in the table", name);
    const key_row *expected = &table[at++];
    assert_string_equal(name, expected->name);
    assert_string_equal(key->initial, expected->initial);
    assert_near_named(key->min, expected->least, 0, name);
    assert_near_named(key->max, expected->most, 0, name);
    const char *choices = choices_of(arena, key);
    assert_int_equal(choices != NULL, expected->choices != NULL);
    if (choices) assert_string_equal(choices, expected->choices);
  }
  return at;
}

static void keys_are_those_of_the_manual(void **state) {
  int at = 0;
  for (int i = 0; i < lam_part_kinds.count; i++)
    at = compare(*state, lam_part_kinds.rows[i]->name, lam_part_kinds.rows[i]->keys, at);
  assert_int_equal(at, rows);
}

/* ---- how far a row is ---- */

typedef struct told {
  int count;
  double last;
} told;

/* Fractions rise from 0 and stay below 1, stage by stage. */
static void listen(void *context, const char *stage, double fraction, const char *detail) {
  told *t = context;
  if (!(fraction >= 0 && fraction < 1)) fail_msg("%s, %s: %g", stage, detail, fraction);
  if (fraction == 0) t->last = 0;
  assert_true(fraction >= t->last);
  t->last = fraction;
  t->count++;
}

static lam_vec3 plane(double u, double v) { return lam_v3(u, v, 0); }

/* Rows of many parts tell of each: panels on 4 x 4 faces, bars and beams on 40 edges, ten
 * lamellas. */
static void rows_tell_how_far_they_are(void **state) {
  static const char *const kinds[] = {"panels", "bars", "support", "lamella"};
  static const int parts[] = {16, 40, 40, 10};
  for (int k = 0; k < 4; k++) {
    told heard = {0, 0};
    const lam_progress progress = {listen, &heard};
    lam_mesh mesh = fixture_grid(*state, 5, 5, plane);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    shop.progress = &progress;
    const lam_part_kind *row = (const lam_part_kind *)lam_registry_find(&lam_part_kinds, kinds[k]);
    void *params = lam_arena_alloc(*state, 1, row->head.params_size);
    assert_true(lam_keys_parse(*state, row->head.keys, "{}", 2, NULL, shop.errors, params));
    row->make(&shop, params, (lam_location){"test", 1, 1});
    assert_int_equal(shop.part_count, parts[k]);
    assert_true(heard.count >= parts[k]);
    lam_workshop_clash(&shop);
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {TEST(keys_are_those_of_the_manual),
                                     TEST(rows_tell_how_far_they_are)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
