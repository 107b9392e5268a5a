/* surface.json (listed in formats/list/formats.c): the control nets of the model's spline
 * surfaces and the control points of its curves, in meters. Numbers read back exactly. Read, too:
 * units m, cm and mm. */
#include "formats/format.h"
#include "formats/scan.h"
#include "formats/spline/curves.h"

#include <errno.h>
#include <jansson.h>
#include <string.h>

/* ---- writing ---- */

static int count(const lam_model *model) {
  return model->surface_count > 0 || model->curve_count > 0;
}

static void path(const lam_model *model, int i, lam_text *out) {
  (void)model, (void)i;
  lam_text_add(out, "surface.json");
}

/* A list of n numbers, in one line. */
static void add_numbers(lam_text *out, const double *numbers, int n) {
  lam_text_add(out, "[");
  for (int i = 0; i < n; i++) {
    if (i) lam_text_add(out, ", ");
    lam_text_real(out, numbers[i]);
  }
  lam_text_add(out, "]");
}

static void add_knots(lam_text *out, const char *name, const double *knots, int n) {
  lam_text_printf(out, "      \"%s\": ", name);
  add_numbers(out, knots, n);
  lam_text_add(out, ",\n");
}

/* The points, one in a line, and the weights when there are any: the last keys of an entry. */
static void add_points(lam_text *out, const lam_vec3 *points, const double *weights, int n) {
  lam_text_add(out, "      \"points\": [");
  for (int i = 0; i < n; i++) {
    lam_text_add(out, i ? ",\n        " : "\n        ");
    add_numbers(out, (double[3]){points[i].x, points[i].y, points[i].z}, 3);
  }
  lam_text_add(out, "]");
  if (weights) {
    lam_text_add(out, ",\n      \"weights\": ");
    add_numbers(out, weights, n);
  }
  lam_text_add(out, "\n    }");
}

static void add_name(lam_text *out, const char *name) {
  lam_text_add(out, "    {\n      \"name\": ");
  lam_text_quoted(out, name);
}

/* An entry of the list of surfaces. */
static void add_surface(lam_text *out, const lam_spline_surface *s) {
  static const char *const names[] = {"knots_u", "knots_v"};
  add_name(out, s->name);
  lam_text_printf(out, ",\n      \"degree\": [%d, %d],\n      \"count\": [%d, %d],\n", s->degree[0],
                  s->degree[1], s->count[0], s->count[1]);
  for (int d = 0; d < 2; d++) add_knots(out, names[d], s->knots[d], s->count[d] + s->degree[d] + 1);
  add_points(out, s->points, s->weights, s->count[0] * s->count[1]);
}

/* An entry of the list of curves. */
static void add_curve(lam_text *out, const lam_named_curve *named) {
  const lam_spline_curve *c = &named->spline;
  add_name(out, named->name);
  lam_text_printf(out, ",\n      \"family\": %d,\n      \"degree\": %d,\n      \"count\": %d,\n",
                  named->family, c->degree, c->count);
  add_knots(out, "knots", c->knots, c->count + c->degree + 1);
  add_points(out, c->points, c->weights, c->count);
}

/* A map with the unit, the order of points, and two lists, either of which may be empty. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_add(
      out,
      "{\n  \"unit\": \"m\",\n  \"order_of_points\": \"v runs fastest\",\n  \"surfaces\": [\n");
  for (int s = 0; s < model->surface_count; s++) {
    add_surface(out, &model->surfaces[s]);
    lam_text_add(out, s + 1 < model->surface_count ? ",\n" : "\n");
  }

  lam_text_add(out, "  ],\n  \"curves\": [\n");
  for (int c = 0; c < model->curve_count; c++) {
    add_curve(out, &model->curves[c]);
    lam_text_add(out, c + 1 < model->curve_count ? ",\n" : "\n");
  }
  lam_text_add(out, "  ]\n}\n");
  return LAM_OK;
}

/* ---- reading ---- */

/* What is being read, for messages. */
typedef struct reader {
  lam_arena *arena;
  lam_location location;
  lam_errors *errors;
  double unit;      /* in meters */
  const char *list; /* "surfaces" or "curves", */
  int item;         /* and which of them, from 0 */
} reader;

/* A message about a key of the item being read; false. */
static bool fail(const reader *r, const char *what, const char *expected) {
  lam_error_add(r->errors, r->location, NULL, "%s[%d].%s: expected %s", r->list, r->item, what,
                expected);
  return false;
}

/* The numbers of a list; count: how many there must be, -1: any number but none. NULL when it is
 * no such list. Owned by the arena. */
static const double *read_numbers(const reader *r, const json_t *list, int count) {
  int given = (int)json_array_size(list);
  if (given == 0 || (count >= 0 && given != count)) return NULL;
  double *numbers = LAM_NEW(r->arena, double, given);
  for (int i = 0; i < given; i++) {
    const json_t *item = json_array_get(list, (size_t)i);
    if (!json_is_number(item)) return NULL;
    numbers[i] = json_number_value(item);
  }
  return numbers;
}

/* Two whole numbers from least to a million; false when the list is not that. */
static bool read_pair(const json_t *list, int least, int pair[2]) {
  for (int d = 0; d < 2; d++) {
    json_int_t value = json_integer_value(json_array_get(list, (size_t)d));
    if (value < least || value > 1000000) return false;
    pair[d] = (int)value;
  }
  return json_array_size(list) == 2;
}

/* `total` points of three numbers, in meters, and, where they are given, as many weights
 * (otherwise NULL). False with a message. */
static bool read_points(const reader *r, const json_t *object, size_t total,
                        const lam_vec3 **points, const double **weights) {
  const json_t *list = json_object_get(object, "points"),
               *given = json_object_get(object, "weights");
  if (json_array_size(list) != total) return fail(r, "points", "as many points as count says");
  lam_vec3 *net = LAM_NEW(r->arena, lam_vec3, total);
  for (size_t i = 0; i < total; i++) {
    const double *p = read_numbers(r, json_array_get(list, i), 3);
    if (!p) return fail(r, "points", "three numbers for each");
    net[i] = lam_v3(r->unit * p[0], r->unit * p[1], r->unit * p[2]);
  }

  *points = net;
  *weights = given ? read_numbers(r, given, (int)total) : NULL;
  return !given || *weights || fail(r, "weights", "a number for each point");
}

/* True when there is no problem; otherwise a message about the item being read. */
static bool is_sound(const reader *r, const char *problem) {
  if (problem)
    lam_error_add(r->errors, r->location, NULL, "%s[%d] has %s", r->list, r->item, problem);
  return !problem;
}

/* An entry of the list of surfaces. False with a message. */
static bool read_surface(const reader *r, const json_t *object, lam_spline_surface *s) {
  static const char *const knots[] = {"knots_u", "knots_v"};
  if (!read_pair(json_object_get(object, "degree"), 1, s->degree))
    return fail(r, "degree", "two whole numbers from 1 on");
  if (!read_pair(json_object_get(object, "count"), 2, s->count))
    return fail(r, "count", "two whole numbers from 2 on");

  size_t total = (size_t)s->count[0] * (size_t)s->count[1];
  if (!read_points(r, object, total, &s->points, &s->weights)) return false;
  for (int d = 0; d < 2; d++)
    if (!(s->knots[d] =
              read_numbers(r, json_object_get(object, knots[d]), s->count[d] + s->degree[d] + 1)))
      return fail(r, knots[d], "count + degree + 1 numbers");
  return is_sound(r, lam_spline_problem(s));
}

/* The family of an entry: 0, 1, or -1 for anything else. */
static int read_family(const json_t *family) {
  json_int_t value = json_is_integer(family) ? json_integer_value(family) : -1;
  return value >= 0 && value < 2 ? (int)value : -1;
}

/* An entry of the list of curves; its knots are clamped. False with a message. The name is
 * "curves[i]" when none is given. */
static bool read_curve(const reader *r, const json_t *object, lam_named_curve *c) {
  lam_spline_curve *s = &c->spline;
  const json_t *name = json_object_get(object, "name");
  json_int_t degree = json_integer_value(json_object_get(object, "degree"));
  json_int_t count = json_integer_value(json_object_get(object, "count")), most = 1000000;
  if (degree < 1 || degree > most) return fail(r, "degree", "a whole number from 1 on");
  if (count < 2 || count > most) return fail(r, "count", "a whole number from 2 on");
  s->degree = (int)degree;
  s->count = (int)count;

  if (!read_points(r, object, (size_t)count, &s->points, &s->weights)) return false;
  s->knots = read_numbers(r, json_object_get(object, "knots"), s->count + s->degree + 1);
  if (!s->knots) return fail(r, "knots", "count + degree + 1 numbers");
  if (!is_sound(r, lam_curve_problem(s))) return false;

  *s = lam_curve_part(r->arena, s, s->knots[s->degree], s->knots[s->count]);
  c->family = read_family(json_object_get(object, "family"));
  c->name = json_is_string(name) ? lam_arena_copy(r->arena, json_string_value(name))
                                 : lam_arena_printf(r->arena, "curves[%d]", r->item);
  return true;
}

/* m, cm or mm; false with a message. */
static bool read_unit(reader *r, const json_t *unit) {
  static const struct {
    const char *name;
    double size;
  } units[] = {{"m", 1}, {"cm", 0.01}, {"mm", 0.001}};
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if (json_is_string(unit) && strcmp(json_string_value(unit), units[i].name) == 0)
      r->unit = units[i].size;
  if (r->unit == 0) lam_error_add(r->errors, r->location, NULL, "unit: expected m, cm or mm");
  return r->unit > 0;
}

static void release(void *root) { json_decref(root); }

/* The list that r->list names, with the unit of the file in r->unit; NULL with a message. The
 * tree is closed with the arena. */
static const json_t *open_list(reader *r, const char *bytes, size_t size) {
  json_error_t error;
  size_t mark = (size_t)lam_utf8_mark(bytes, size);
  errno = 0; /* jansson takes for a mistake of the file what it has no memory for */
  json_t *root = json_loadb(bytes + mark, size - mark, 0, &error);
  if (!root) {
    if (errno == ENOMEM) lam_arena_exhausted(r->arena);
    lam_location location = r->location;
    location.line = error.line > 0 ? error.line : 0;
    lam_text text = {.arena = r->arena}; /* in one line */
    lam_text_quoted(&text, error.text);
    lam_error_add(r->errors, location, NULL, "is not valid JSON: %s", text.data);
    return NULL;
  }

  lam_arena_defer(r->arena, release, root);
  const json_t *list = json_object_get(root, r->list);
  if (!json_array_size(list)) {
    lam_error_add(r->errors, r->location, NULL, "has no %s; expected a map with unit and %s",
                  r->list, r->list);
    return NULL;
  }

  return read_unit(r, json_object_get(root, "unit")) ? list : NULL;
}

/* For the format's row: all surfaces, each named by its place in the list in messages. */
static bool read_surfaces(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                          lam_errors *errors, lam_spline_list *surfaces) {
  reader r = {.arena = arena, .location = location, .errors = errors, .list = "surfaces"};
  *surfaces = (lam_spline_list){0};
  const json_t *list = open_list(&r, bytes, size);
  for (; r.item < (int)json_array_size(list); r.item++) {
    lam_spline_surface s = {0};
    if (!read_surface(&r, json_array_get(list, (size_t)r.item), &s)) return false;
    lam_spline_append(arena, surfaces, &s, NULL);
  }
  return list != NULL;
}

/* For the format's row: all curves. */
static bool read_curves(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                        lam_errors *errors, lam_curve_list *curves) {
  reader r = {.arena = arena, .location = location, .errors = errors, .list = "curves"};
  *curves = (lam_curve_list){0};
  const json_t *list = open_list(&r, bytes, size);
  for (; r.item < (int)json_array_size(list); r.item++) {
    lam_named_curve c = {0};
    if (!read_curve(&r, json_array_get(list, (size_t)r.item), &c)) return false;
    lam_curve_append(arena, curves, c.name, c.family, c.spline);
  }
  return list != NULL;
}

const lam_format lam_format_surface = {
    .name = "surface",
    .doc = "The smooth surfaces, and the axes of lamellas or the lines of the net as curves "
           "(degrees, knots, points, weights), as JSON, in meters.",
    .ending = "json",
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
    .read_surfaces = read_surfaces,
    .read_curves = read_curves,
};
