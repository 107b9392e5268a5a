/* STL in millimeters (listed in formats/list/formats.c). Written binary: an 80-byte header, the
 * number of triangles, and per triangle its normal, its corners (12 float32) and two zero bytes,
 * all little end first. Read binary or as text. */
#include "core/solid/triangles.h"
#include "formats/format.h"
#include "formats/scan.h"

#include <stdio.h>
#include <string.h>

enum { header_size = 84, record_size = 50 }; /* bytes; the header with the number of triangles */

/* ---- writing ---- */

static int count(const lam_model *model) { return model->part_count ? model->part_count + 1 : 0; }

/* A file per part, then one of the whole model. */
static void path(const lam_model *model, int i, lam_text *out) {
  if (i == model->part_count)
    lam_text_add(out, "assembly.stl");
  else
    lam_text_printf(out, "parts/%s.stl", model->parts[i].name);
}

/* The header must not begin with "solid", which stands for text. */
static void write_header(lam_text *out, const char *model, const char *part, size_t triangles) {
  char header[81] = {0};
  snprintf(header, sizeof header, "lamella: %s%s%s, mm", model, part ? ", " : "", part ? part : "");
  lam_text_bytes(out, header, 80);
  lam_text_u32(out, (uint32_t)triangles);
}

static void write_vector(lam_text *out, lam_vec3 p) {
  lam_text_f32(out, (float)p.x);
  lam_text_f32(out, (float)p.y);
  lam_text_f32(out, (float)p.z);
}

/* The records of a mesh: meters become millimeters; the normal is (0, 0, 0) without area. */
static void write_triangles(lam_text *out, const lam_trimesh *mesh) {
  for (int i = 0; i < mesh->triangle_count; i++) {
    lam_vec3 p[3];
    for (int k = 0; k < 3; k++) p[k] = mesh->vertices[mesh->triangles[i][k]];
    write_vector(out, lam_unit(lam_cross(lam_sub(p[1], p[0]), lam_sub(p[2], p[0]))));
    for (int k = 0; k < 3; k++) write_vector(out, lam_scale(p[k], 1000));
    lam_text_u16(out, 0);
  }
}

/* How many triangles a part has, all its instances together. */
static size_t triangles_of(const lam_part *part) {
  return (size_t)part->solid.triangle_count *
         (size_t)(part->instance_count ? part->instance_count : 1);
}

/* A part where its instances stand. Each is a copy of the solid, whose memory is given back as
 * long as the text did not move behind the mark. */
static void write_instances(lam_text *out, const lam_part *part) {
  if (!part->instance_count) write_triangles(out, &part->solid);
  for (int i = 0; i < part->instance_count; i++) {
    lam_arena_mark mark = lam_arena_mark_get(out->arena);

    lam_trimesh placed = lam_trimesh_placed(out->arena, &part->solid, &part->instances[i]);

    size_t capacity = out->capacity;
    write_triangles(out, &placed);
    if (out->capacity == capacity) lam_arena_release(out->arena, mark);
  }
}

/* A part alone stands where its solid is, once; the whole model has all instances. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  if (i < model->part_count) {
    write_header(out, model->name, model->parts[i].name,
                 triangles_of(&(lam_part){.solid = model->parts[i].solid}));
    write_triangles(out, &model->parts[i].solid);
    return LAM_OK;
  }

  size_t triangles = 0;
  for (int j = 0; j < model->part_count; j++) triangles += triangles_of(&model->parts[j]);
  write_header(out, model->name, NULL, triangles);
  for (int j = 0; j < model->part_count; j++) write_instances(out, &model->parts[j]);
  return LAM_OK;
}

/* ---- reading ---- */

static uint32_t read_u32(const char *bytes) {
  const unsigned char *b = (const unsigned char *)bytes;
  return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* Three corners per triangle, in order of appearance. */
typedef struct corner_list {
  lam_arena *arena;
  size_t count, capacity;
  lam_vec3 *points;
} corner_list;

/* Corners are read in millimeters and kept in meters. */
static void append(corner_list *list, lam_vec3 mm) {
  if (list->count == list->capacity) {
    list->capacity = list->capacity ? 2 * list->capacity : 3 * 256;
    lam_vec3 *larger = LAM_NEW(list->arena, lam_vec3, list->capacity);
    if (list->count) memcpy(larger, list->points, list->count * sizeof *larger);
    list->points = larger;
  }
  list->points[list->count++] = lam_scale(mm, 1e-3);
}

/* The records of a binary file, of which the caller has checked that they are there. Normals are
 * not read. Stops with a message at the first number that is not finite. */
static void read_binary(const char *bytes, uint32_t triangles, lam_location location,
                        lam_errors *errors, corner_list *corners) {
  for (uint32_t i = 0; i < triangles; i++) {
    float xyz[9];
    for (int k = 0; k < 9; k++) {
      uint32_t bits = read_u32(bytes + header_size + record_size * (size_t)i + 12 + 4 * k);
      memcpy(&xyz[k], &bits, 4);
      if (isfinite(xyz[k])) continue;
      lam_error_add(errors, location, NULL,
                    "triangle %u has a coordinate that is not a finite number", i + 1);
      return;
    }

    for (int k = 0; k < 9; k += 3) append(corners, lam_v3(xyz[k], xyz[k + 1], xyz[k + 2]));
  }
}

/* Takes the words of `expected` (NULL-terminated), in order, wherever lines end. False with a
 * message. */
static bool expect(lam_scan *scan, const char *const *expected) {
  for (; *expected; expected++) {
    lam_word word;
    while (!lam_scan_word(scan, &word))
      if (!lam_scan_line(scan)) {
        lam_error_add(scan->errors, scan->location, NULL, "the file ends where \"%s\" is expected",
                      *expected);
        return false;
      }

    if (lam_word_is(word, *expected)) continue;
    lam_error_add(scan->errors, scan->location, NULL, "\"%.*s\" given, \"%s\" expected",
                  lam_word_shown(word), word.text, *expected);
    return false;
  }
  return true;
}

/* The rest of a triangle after "facet". The normal is not used, and may be nan, which some
 * programs write for triangles without area; its three words must be there. False with a
 * message. */
static bool read_facet(lam_scan *scan, corner_list *corners) {
  static const char *const normal[] = {"normal", NULL}, *const loop[] = {"outer", "loop", NULL},
                           *const vertex[] = {"vertex", NULL},
                           *const ends[] = {"endloop", "endfacet", NULL};
  lam_vec3 p;
  lam_word word;
  if (!expect(scan, normal)) return false;
  for (int k = 0; k < 3; k++)
    if (!lam_scan_word(scan, &word)) {
      lam_error_add(scan->errors, scan->location, NULL, "normal: %d numbers given, 3 expected", k);
      return false;
    }

  if (!expect(scan, loop)) return false;
  for (int k = 0; k < 3; k++) {
    if (!expect(scan, vertex) || !lam_scan_point(scan, "vertex", &p)) return false;
    append(corners, p);
  }
  return expect(scan, ends);
}

/* A text file. Several solids may follow one another; what stands behind "solid" and "endsolid"
 * is a name. Stops at the first message. */
static void read_text(lam_scan scan, corner_list *corners) {
  lam_word word;
  do {
    if (!lam_scan_word(&scan, &word)) continue;
    if (lam_word_is(word, "solid") || lam_word_is(word, "endsolid")) continue;

    while (lam_word_is(word, "facet")) {
      if (!read_facet(&scan, corners)) return;
      if (!lam_scan_word(&scan, &word)) word = (lam_word){"", 0};
    }

    if (word.length == 0 || lam_word_is(word, "endsolid")) continue;
    lam_error_add(scan.errors, scan.location, NULL,
                  "\"%.*s\" given, \"facet\" or \"endsolid\" expected", lam_word_shown(word),
                  word.text);
    return;
  } while (lam_scan_line(&scan));
}

/* Reads the corners of all triangles. A file is binary when its size is that of its number of
 * triangles, whatever its header begins with; otherwise it is text when it begins with "solid".
 * False with a message. */
static bool read_corners(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                         lam_errors *errors, corner_list *corners) {
  int before = errors->count;
  size_t mark = (size_t)lam_utf8_mark(bytes, size);
  uint32_t triangles = size >= header_size ? read_u32(bytes + header_size - 4) : 0;
  size_t expected = header_size + record_size * (size_t)triangles;

  if (size >= header_size && size == expected) {
    read_binary(bytes, triangles, location, errors, corners);
  } else if (size >= mark + 5 && strncasecmp(bytes + mark, "solid", 5) == 0) {
    read_text(lam_scan_begin(arena, bytes, size, location, errors), corners);
  } else if (size >= header_size) {
    lam_error_add(errors, location, NULL,
                  "a binary STL file of %u triangles has %zu bytes; this one has %zu", triangles,
                  expected, size);
  } else {
    lam_error_add(errors, location, NULL,
                  "is not an STL file: it neither begins with \"solid\" nor has a header");
  }
  return errors->count == before;
}

/* For the format's row. Corners at the same coordinates become one vertex. */
static bool read_triangles(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  corner_list corners = {.arena = arena};
  if (!read_corners(arena, bytes, size, location, errors, &corners)) return false;

  lam_trimesh loose = {.vertex_count = (int)corners.count, .vertices = corners.points};
  loose.triangle_count = loose.vertex_count / 3;
  loose.triangles = lam_arena_alloc(arena, (size_t)loose.triangle_count, sizeof *loose.triangles);
  for (int i = 0; i < loose.vertex_count; i++) loose.triangles[i / 3][i % 3] = i;

  *mesh = lam_trimesh_weld(arena, &loose, 0);
  if (!mesh->triangle_count) lam_error_add(errors, location, NULL, "has no triangles");
  return mesh->triangle_count > 0;
}

const lam_format lam_format_stl = {
    .name = "stl",
    .doc = "Triangles of every part, and of the whole model with all instances, in millimeters; "
           "read binary or as text.",
    .ending = "stl",
    .unit = 1e-3,
    .count = count,
    .path = path,
    .write = write,
    .read_triangles = read_triangles,
};
