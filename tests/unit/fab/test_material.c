/* The table of materials against what is published of them: every mass, every note about the
 * elastic limit and every color in a scene comes from it. */
#include "fab/material.h"
#include "tests/unit/asserts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Published ranges: density, kg/m^3; strength (yield, bending or tensile), MPa; Young's modulus,
 * GPa. density: the nominal value, as in the source. share: of the limit that may be used. look: as
 * sRGB, as on a screen. */
typedef struct published {
  const char *name;
  double density, densities[2], strength[2], modulus[2], share;
  const char *look;
  double metallic, roughness;
} published;

static const published table[] = {
    /* EN 1991-1-1, table A.4: 77 to 78.5 kN/m^3; EN 10025-2; EN 1993-1-1, 3.2.6 */
    {"steel", 7850, {7849, 8002}, {235, 235}, {210, 210}, 1, "adafb3", 1, .45},
    /* EN 10088-1; EN 10088-2: hot and cold rolled */
    {"stainless", 7900, {7900, 7900}, {210, 230}, {200, 200}, 1, "cececd", 1, .3},
    /* EN 10089: Rp0.2; EN 13906-1 */
    {"spring-steel", 7850, {7800, 7850}, {1200, 1200}, {206, 206}, 1, "898b93", 1, .35},
    /* EN 485-2; EN 1999-1-1, 3.2.5; ASM Handbook, volume 2 */
    {"aluminum", 2660, {2650, 2700}, {125, 125}, {70, 71}, 1, "e7e8ea", 1, .4},
    /* EN 1652: R300 has at most 180, R350 about 170; data sheet CuZn37 of KME: 99 to 115 GPa */
    {"brass", 8440, {8440, 8440}, {170, 180}, {99, 115}, 1, "ddbf81", 1, .35},
    /* Handbook of Finnish Plywood; EN 636, classes F40 and E90 */
    {"plywood", 680, {640, 700}, {60, 60}, {9, 9}, 1, "ceb38e", 0, .75},
    /* DIN 68364 (larch), Wood Handbook, table 5-3 (western larch) */
    {"larch", 590, {550, 600}, {90, 93}, {12, 13.8}, .5, "bc8e65", 0, .7},
    /* trade tables of gray board: 615 g/m^2 to 650 g/m^2 a millimeter; no strength is given */
    {"card", 650, {615, 650}, {0, 0}, {0, 0}, 1, "d4d1c8", 0, .95},
    /* ISO 7823-1; data sheets of cast sheet */
    {"acrylic", 1190, {1190, 1190}, {70, 80}, {3, 3.3}, .5, "edf3f6", 0, .1},
    /* data sheets of PP-H sheet (ISO 527, ISO 1183) */
    {"polypropylene", 910, {900, 920}, {30, 33}, {1.3, 1.7}, 1, "f1f1ef", 0, .5},
    /* EN 572-1 */
    {"glass", 2500, {2500, 2500}, {45, 45}, {70, 70}, 1, "e7f1ef", 0, .05},
    /* EN 14411, group BIa; papers on porcelain stoneware */
    {"ceramic", 2300, {2300, 2400}, {35, 50}, {58, 72}, 1, "efedea", 0, .2},
    /* GRCA, sprayed glass-fiber concrete: limit of proportionality */
    {"concrete", 2000, {1900, 2100}, {7, 11}, {10, 20}, 1, "b5b3af", 0, .9},
    {"white-steel", 7850, {7849, 8002}, {235, 235}, {210, 210}, 1, "ececea", 0, .4},
    /* EN 14080, GL24h: characteristic strength, mean modulus and density */
    {"spruce", 420, {420, 420}, {24, 24}, {11.5, 11.5}, 1, "d4b893", 0, .7},
    /* DIN 68364 (oak), Wood Handbook, table 5-3 (oaks), BRE (European oak: 690 kg/m^3) */
    {"oak", 690, {650, 720}, {88, 105}, {10, 13}, .5, "a2815d", 0, .6},
    /* EN 1652, R240: Rp0.2; Copper Development Association */
    {"copper", 8930, {8930, 8940}, {180, 180}, {117, 132}, 1, "dd9e7c", 1, .35},
};
enum { rows = sizeof table / sizeof *table };

/* Names and rows are in the same order, each name once, and the list of names ends with NULL. */
static void names_and_rows_agree(void **state) {
  (void)state;
  assert_int_equal(lam_material_count, rows);
  for (int i = 0; i < rows; i++) {
    assert_string_equal(lam_material_names[i], table[i].name);
    assert_string_equal(lam_materials[i].name, table[i].name);
  }
  assert_null(lam_material_names[rows]);
}

static void densities_are_those_published(void **state) {
  (void)state;
  for (int i = 0; i < rows; i++) {
    const published *p = &table[i];
    double density = lam_materials[i].density;
    assert_near_named(density, p->density, 0, p->name);
    if (density < p->densities[0] || density > p->densities[1])
      fail_msg("%s: %g kg/m^3, published are %g to %g", p->name, density, p->densities[0],
               p->densities[1]);
  }
}

/* The number before a unit in the text of a material. */
static double told(const char *doc, const char *unit) {
  const char *at = strstr(doc, unit);
  if (!at) fail_msg("\"%s\" gives no %s", doc, unit);
  while (at > doc && strchr("0123456789. ", at[-1])) at--;
  return atof(at);
}

static void assert_within(const published *p, const char *what, double value,
                          const double range[2]) {
  if (!(value >= range[0] && value <= range[1]))
    fail_msg("%s: %s %g, published are %g to %g", p->name, what, value, range[0], range[1]);
}

/* The text of a row gives strength and modulus, both as published; the limit is their ratio, to two
 * or three digits (3 %). Card has none: it is said to crease at 1 %. */
static void elastic_limits_are_strength_over_modulus(void **state) {
  (void)state;
  for (int i = 0; i < rows; i++) {
    const published *p = &table[i];
    const lam_material *m = &lam_materials[i];
    double expected = 0.01;
    if (p->strength[0] > 0) {
      double strength = told(m->doc, " MPa"), modulus = told(m->doc, " GPa");
      assert_within(p, "strength in MPa", strength, p->strength);
      assert_within(p, "modulus in GPa", modulus, p->modulus);
      expected = p->share * strength / modulus * 1e-3;
    }
    assert_near_named(m->max_strain / expected, 1, 0.03, p->name);
    assert_true((p->share < 1) == (strstr(m->doc, "half of the limit") != NULL));
  }
}

/* Linear light to sRGB (IEC 61966-2-1), in steps of 1/255. */
static int on_screen(double linear) {
  double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
  return (int)floor(255 * value + 0.5);
}

static void materials_look_as_they_are(void **state) {
  (void)state;
  for (int i = 0; i < rows; i++) {
    const lam_material *m = &lam_materials[i];
    char look[8];
    snprintf(look, sizeof look, "%02x%02x%02x", on_screen(m->color[0]), on_screen(m->color[1]),
             on_screen(m->color[2]));
    assert_string_equal(look, table[i].look);
    assert_near_named(m->metallic, table[i].metallic, 0, m->name);
    assert_near_named(m->roughness, table[i].roughness, 1e-15, m->name);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(names_and_rows_agree),
                                     cmocka_unit_test(densities_are_those_published),
                                     cmocka_unit_test(elastic_limits_are_strength_over_modulus),
                                     cmocka_unit_test(materials_look_as_they_are)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
