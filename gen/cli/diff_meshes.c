/* Two meshes side by side, as a table or JSON, and whether they are the same. Called by
 * verb_diff.c. */
#include "cli/diff.h"
#include "cli/solid_facts.h"
#include "cli/verb_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Relative limit for volume and area; limit for distances in millimeters. */
static const double relative_limit = 1e-4, default_tolerance_mm = 0.05;

/* ---- rows ---- */

/* A row of the table: the two values, how far they are apart, and how far they may be. */
typedef struct row {
  const char *name, *unit;
  double scale; /* to the unit that is shown */
  double a, b, difference, limit;
  bool is_flag;     /* the values are 0 or 1 */
  bool is_distance; /* there is a difference alone: the values are 0 */
} row;

enum { row_count = 8 };

static double distance(lam_vec3 a, lam_vec3 b) {
  double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return sqrt(x * x + y * y + z * z);
}

/* The difference over the larger of the two sizes; 0 for two zeros. */
static double relative(double a, double b) {
  double size = fmax(fabs(a), fabs(b));
  return size > 0 ? fabs(a - b) / size : 0;
}

/* Counts must agree. */
static row counted(const char *name, int a, int b) {
  return (row){name, "", 1, a, b, abs(a - b), 0, false, false};
}

/* Volume and area may differ by a share of their size. */
static row measured(const char *name, const char *unit, double a, double b) {
  return (row){name, unit, 1, a, b, relative(a, b), relative_limit, false, false};
}

/* A distance between the meshes, shown in millimeters; tolerance in meters. */
static row sampled(const char *name, double distance, double tolerance) {
  return (row){name, "mm", 1000, 0, 0, distance, tolerance, false, true};
}

/* All rows in the order in which they are shown. Volumes are meaningful without boundary edges
 * alone; both are 0 otherwise. tolerance: meters. */
static void make_rows(const lam_mesh_comparison *c, double tolerance, row rows[row_count]) {
  const lam_solid_facts *a = &c->facts[0], *b = &c->facts[1];
  rows[0] = (row){"closed", "", 1, a->closed, b->closed, a->closed != b->closed, 0, true, false};
  rows[1] = counted("components", a->components, b->components);
  rows[2] = counted("Euler number", a->euler, b->euler);
  rows[3] = measured("volume", "m^3", a->volume, b->volume);
  rows[4] = measured("area", "m^2", a->area, b->area);

  /* Shown are the diagonals of the boxes; compared are their corners. */
  double diagonals[2] = {distance(a->min, a->max), distance(b->min, b->max)};
  double corners = fmax(distance(a->min, b->min), distance(a->max, b->max));
  rows[5] = (row){"bounding box", "mm",      1000,  diagonals[0], diagonals[1],
                  corners,        tolerance, false, false};

  rows[6] = sampled("from A to B", c->a_to_b, tolerance);
  rows[7] = sampled("from B to A", c->b_to_a, tolerance);
}

/* Whether the row is beyond its limit; true for differences that are not a number. */
static bool differs(const row *r) { return !(r->difference <= r->limit); }

static bool any_differs(const row *rows) {
  for (int i = 0; i < row_count; i++)
    if (differs(&rows[i])) return true;
  return false;
}

/* ---- text ---- */

/* One value in a column of 20. */
static void print_value(const row *r, double value) {
  char text[64];
  if (r->is_distance)
    text[0] = 0;
  else if (r->is_flag)
    snprintf(text, sizeof text, "%s", value > 0 ? "yes" : "no");
  else
    snprintf(text, sizeof text, "%.9g%s%s", value * r->scale, *r->unit ? " " : "", r->unit);
  printf(" %-20s", text);
}

/* Relative differences have no unit; distances are shown in millimeters. */
static void print_row(const row *r) {
  printf("%-14s", r->name);
  print_value(r, r->a);
  print_value(r, r->b);
  const char *unit = r->scale > 1 ? r->unit : "";
  printf(" %-14.4g %.4g%s%s%s\n", r->difference * r->scale, r->limit * r->scale, *unit ? " " : "",
         unit, differs(r) ? "  <-- differs" : "");
}

/* The table, and at the end the names of the rows that differ. */
static void print_text(const lam_mesh_comparison *c, const row *rows) {
  printf("%-14s %-20s %-20s %-14s %s\n", "", "A", "B", "difference", "limit");
  for (int i = 0; i < row_count; i++) print_row(&rows[i]);
  printf("sampled every %.3g mm\n", c->spacing * 1000);

  int shown = 0;
  for (int i = 0; i < row_count; i++)
    if (differs(&rows[i])) printf("%s%s", shown++ ? ", " : "different: ", rows[i].name);
  puts(shown ? "" : "the same");
}

/* ---- JSON ---- */

/* In SI units; facts of both meshes under "a" and "b". Returns the exit status. */
static int print_json(const lam_mesh_comparison *c, double tolerance, const row *rows) {
  json_t *object = json_object(), *names = json_array();
  for (int i = 0; i < row_count; i++)
    if (differs(&rows[i])) json_array_append_new(names, json_string(rows[i].name));

  json_object_set_new(object, "same", json_boolean(json_array_size(names) == 0));
  json_object_set_new(object, "different", names);
  json_object_set_new(object, "tolerance", json_real(tolerance));
  json_object_set_new(object, "spacing", json_real(c->spacing));
  json_object_set_new(object, "a_to_b", json_real(c->a_to_b));
  json_object_set_new(object, "b_to_a", json_real(c->b_to_a));
  json_object_set_new(object, "a", lam_facts_json(&c->facts[0]));
  json_object_set_new(object, "b", lam_facts_json(&c->facts[1]));
  return lam_json_print(object, any_differs(rows) ? 1 : 0, 12);
}

/* 0: the same; 1: different; otherwise the status of files that cannot be read. */
int lam_diff_meshes(lam_session *session, const lam_diff_request *request) {
  lam_mesh_comparison comparison;
  lam_status status =
      lam_compare_meshes(session, request->paths[0], request->paths[1], &comparison);
  if (status != LAM_OK) return lam_verb_status(session, status);

  double tolerance = (request->tolerance < 0 ? default_tolerance_mm : request->tolerance) / 1000;
  row rows[row_count];
  make_rows(&comparison, tolerance, rows);

  if (request->json) return print_json(&comparison, tolerance, rows);
  print_text(&comparison, rows);
  return any_differs(rows) ? 1 : 0;
}
