/* The reader `ply` (listed in formats/list/formats.c): meshes and scans in the Stanford polygon
 * format, as text or binary. A header names elements (vertex, face, ...), their numbers and their
 * properties, which are numbers or lists of numbers of given types; their values follow in the same
 * order. Read are x, y and z of vertices and vertex_indices (or vertex_index) of faces; all else is
 * passed over. Called through the list of formats by gen/library/read_files.c. */
#include "core/grow.h"
#include "formats/format.h"
#include "formats/mesh/polygons.h"
#include "formats/scan.h"

#include <limits.h>
#include <string.h>

/* ---- types of values ---- */

typedef struct value_type {
  const char *name, *other; /* as in the first files, and as in later ones */
  int size;                 /* bytes */
  bool is_float, is_signed;
} value_type;

static const value_type types[] = {
    {"char", "int8", 1, false, true},    {"uchar", "uint8", 1, false, false},
    {"short", "int16", 2, false, true},  {"ushort", "uint16", 2, false, false},
    {"int", "int32", 4, false, true},    {"uint", "uint32", 4, false, false},
    {"float", "float32", 4, true, true}, {"double", "float64", 8, true, true},
};

/* The type of that name, or NULL. */
static const value_type *type_named(lam_word word) {
  for (size_t i = 0; i < sizeof types / sizeof *types; i++)
    if (lam_word_is(word, types[i].name) || lam_word_is(word, types[i].other)) return &types[i];
  return NULL;
}

/* ---- what the header says ---- */

typedef enum role { X, Y, Z, CORNERS, PASSED_OVER } role;

typedef struct property {
  const value_type *type;   /* of the value, or of the items of a list */
  const value_type *counts; /* of the number of items; NULL: no list */
  role role;
} property;

typedef struct element {
  bool is_vertex, is_face;
  int count; /* how many there are */
  int property_count, property_capacity;
  property *properties;
} element;

typedef enum encoding { TEXT, LITTLE_END_FIRST, BIG_END_FIRST } encoding;

typedef struct reader {
  lam_scan scan; /* in a binary file its location is meaningful in the header alone */
  encoding encoding;
  int element_count, element_capacity;
  element *elements;
  lam_polygons polygons; /* what was read so far */
} reader;

static bool fail(reader *r, const char *text) {
  lam_error_add(r->scan.errors, r->scan.location, NULL, "%s", text);
  return false;
}

/* Something else was given than expected, or nothing (an empty word). */
static bool fail_word(reader *r, lam_word word, const char *expected) {
  lam_error_add(r->scan.errors, r->scan.location, NULL, "\"%.*s\" given, %s expected",
                lam_word_shown(word), word.text, expected);
  return false;
}

/* The next word of the line; an empty one at its end. */
static lam_word word_of(reader *r) {
  lam_word word;
  return lam_scan_word(&r->scan, &word) ? word : (lam_word){"", 0};
}

/* ---- the header ---- */

/* format NAME VERSION */
static bool read_encoding(reader *r) {
  static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  lam_word word = word_of(r);
  for (int i = 0; i < 3; i++)
    if (lam_word_is(word, names[i])) {
      r->encoding = (encoding)i;
      return true;
    }
  return fail_word(r, word, "ascii, binary_little_endian or binary_big_endian");
}

/* element NAME COUNT */
static bool read_element(reader *r) {
  lam_word name = word_of(r);
  element e = {.is_vertex = lam_word_is(name, "vertex"), .is_face = lam_word_is(name, "face")};
  if (!lam_scan_count(&r->scan, word_of(r), "number of elements", &e.count)) return false;
  LAM_APPEND(r->scan.errors->arena, r->elements, r->element_count, r->element_capacity, e);
  return true;
}

/* What a property of an element is read as. */
static role role_of(const element *e, const property *p, lam_word name) {
  static const char *const coordinates[] = {"x", "y", "z"};
  for (int k = 0; k < 3; k++)
    if (e->is_vertex && !p->counts && lam_word_is(name, coordinates[k])) return (role)k;
  bool corners = lam_word_is(name, "vertex_indices") || lam_word_is(name, "vertex_index");
  return e->is_face && p->counts && corners ? CORNERS : PASSED_OVER;
}

/* property TYPE NAME, or property list TYPE TYPE NAME: belongs to the last element. */
static bool read_property(reader *r) {
  static const char expected[] = "a type such as float, int or uchar";
  property p = {0};
  lam_word word = word_of(r);
  if (!r->element_count) return fail(r, "a property given before any element");

  if (lam_word_is(word, "list")) {
    word = word_of(r);
    p.counts = type_named(word);
    if (!p.counts || p.counts->is_float) return fail_word(r, word, "a type of whole numbers");
    word = word_of(r);
  }
  p.type = type_named(word);
  if (!p.type) return fail_word(r, word, expected);

  element *e = &r->elements[r->element_count - 1];
  p.role = role_of(e, &p, word_of(r));
  LAM_APPEND(r->scan.errors->arena, e->properties, e->property_count, e->property_capacity, p);
  return true;
}

/* One line of the header; *ended: it was the last. */
static bool read_header_line(reader *r, bool *ended) {
  lam_word word = word_of(r);
  *ended = lam_word_is(word, "end_header");
  if (*ended || !word.length || lam_word_is(word, "comment") || lam_word_is(word, "obj_info"))
    return true;
  if (lam_word_is(word, "format")) return read_encoding(r);
  if (lam_word_is(word, "element")) return read_element(r);
  if (lam_word_is(word, "property")) return read_property(r);
  return fail_word(r, word, "format, comment, element, property or end_header");
}

/* Goes behind the line of end_header. In a binary file the first value may look like half a line
 * end: the header's own line ends tell how long this one is. */
static void pass_end(reader *r, const char *first_line) {
  while (r->scan.at < r->scan.end && !lam_line_end(r->scan.at, r->scan.end)) r->scan.at++;
  int length = lam_line_end(first_line, r->scan.end), here = lam_line_end(r->scan.at, r->scan.end);
  r->scan.at += here < length ? here : length;
  r->scan.location.line++;
}

/* Up to the first value. */
static bool read_header(reader *r) {
  if (!lam_word_is(word_of(r), "ply"))
    return fail(r, "is not a PLY file: it does not begin with ply");
  const char *first_line = r->scan.at;
  while (first_line < r->scan.end && !lam_line_end(first_line, r->scan.end)) first_line++;

  for (bool ended = false; !ended;) {
    if (!lam_scan_line(&r->scan)) return fail(r, "the file ends where end_header is expected");
    if (!read_header_line(r, &ended)) return false;
  }
  pass_end(r, first_line);
  return true;
}

/* ---- values ---- */

/* The bits of a value as a number. */
static double number_of(const value_type *type, uint64_t bits) {
  if (type->size == 8) {
    double value;
    memcpy(&value, &bits, 8);
    return value;
  }
  if (type->is_float) {
    uint32_t low = (uint32_t)bits;
    float value;
    memcpy(&value, &low, 4);
    return (double)value;
  }
  double range = (double)((uint64_t)1 << (8 * type->size));
  double value = (double)bits;
  return type->is_signed && value >= range / 2 ? value - range : value;
}

/* A value of a binary file. */
static bool read_binary(reader *r, const value_type *type, double *value) {
  const unsigned char *b = (const unsigned char *)r->scan.at;
  uint64_t bits = 0;
  if (r->scan.end - r->scan.at < type->size) {
    r->scan.location.line = 0;
    return fail(r, "is cut off: values are missing at its end");
  }

  for (int i = 0; i < type->size; i++)
    bits |= (uint64_t)b[i] << 8 * (r->encoding == BIG_END_FIRST ? type->size - 1 - i : i);
  *value = number_of(type, bits);
  r->scan.at += type->size;
  return true;
}

static bool read_value(reader *r, const value_type *type, double *value) {
  lam_word word;
  if (r->encoding != TEXT) return read_binary(r, type, value);
  return lam_scan_next(&r->scan, "a value", &word) &&
         lam_scan_number(&r->scan, word, "value", value);
}

/* A message about a value of a binary file has no line. */
static bool fail_value(reader *r, const char *text) {
  if (r->encoding != TEXT) r->scan.location.line = 0;
  return fail(r, text);
}

/* ---- elements ---- */

/* The items of a list; those of corners become a face. */
static bool read_list(reader *r, const property *p) {
  double count, item;
  int start = r->polygons.corners.count;
  if (!read_value(r, p->counts, &count)) return false;
  if (!(count >= 0 && count == floor(count)))
    return fail_value(r, "a list of a number of items that is none");

  for (double k = 0; k < count; k++) {
    if (!read_value(r, p->type, &item)) return false;
    if (p->role != CORNERS) continue;
    if (!(item >= 0 && item <= INT_MAX && item == floor(item)))
      return fail_value(r, "face: a corner that is no vertex number (from 0)");
    lam_polygons_corner(&r->polygons, (int)item);
  }

  lam_location location = r->scan.location;
  if (r->encoding != TEXT) location.line = 0;
  if (p->role == CORNERS) lam_polygons_face(&r->polygons, start, location, r->scan.errors);
  return !lam_scan_gave_up(&r->scan);
}

/* One element with all its properties. A vertex without a coordinate has 0 there. */
static bool read_one(reader *r, const element *e) {
  double x[PASSED_OVER + 1] = {0};
  for (int i = 0; i < e->property_count; i++) {
    const property *p = &e->properties[i];
    if (p->counts ? !read_list(r, p) : !read_value(r, p->type, &x[p->role])) return false;
  }
  if (!e->is_vertex) return true;

  if (!(isfinite(x[X]) && isfinite(x[Y]) && isfinite(x[Z])))
    return fail_value(r, "a vertex has a coordinate that is not a finite number");
  lam_polygons_vertex(&r->polygons, lam_v3(x[X], x[Y], x[Z]));
  return true;
}

/* Elements in the order of the header. An element without properties has no values. */
static bool read_elements(reader *r) {
  for (int i = 0; i < r->element_count; i++)
    for (int k = 0; r->elements[i].property_count && k < r->elements[i].count; k++)
      if (!read_one(r, &r->elements[i])) return false;
  return !lam_scan_failed(&r->scan);
}

/* ---- the whole ---- */

/* Reads the file, and checks its faces unless only points are wanted. False with messages. */
static bool read_all(reader *r, bool points) {
  if (!read_header(r) || !read_elements(r)) return false;
  if (points) return r->polygons.vertex_count > 0 || fail_value(r, "has no vertices");
  return lam_polygons_check(&r->polygons, 0, r->scan.location, r->scan.errors);
}

/* For the format's row: faces of three or four corners. */
static bool read_mesh(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                      lam_errors *errors, lam_mesh *mesh) {
  reader r = {.scan = lam_scan_begin(arena, bytes, size, location, errors),
              .polygons = {.arena = arena, .most_corners = 4}};
  if (!read_all(&r, false)) return false;
  *mesh = lam_polygons_mesh(&r.polygons);
  return true;
}

/* For the format's row: triangles. */
static bool read_triangles(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  reader r = {.scan = lam_scan_begin(arena, bytes, size, location, errors),
              .polygons = {.arena = arena, .most_corners = INT_MAX}};
  if (!read_all(&r, false)) return false;
  *mesh = lam_polygons_triangles(&r.polygons);
  return true;
}

/* For the format's row: vertices, whether there are faces or not. */
static bool read_points(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                        lam_errors *errors, int *count, const lam_vec3 **points) {
  reader r = {.scan = lam_scan_begin(arena, bytes, size, location, errors),
              .polygons = {.arena = arena, .most_corners = INT_MAX}};
  if (!read_all(&r, true)) return false;
  *count = r.polygons.vertex_count;
  *points = r.polygons.vertices;
  return true;
}

const lam_format lam_format_ply = {
    .name = "ply",
    .doc = "Meshes and scanned points in the Stanford polygon format, text or binary, in meters.",
    .ending = "ply",
    .unit = 1,
    .read_mesh = read_mesh,
    .read_triangles = read_triangles,
    .read_points = read_points,
};
