/* Wavefront OBJ in meters (listed in formats/list/formats.c). Written: net.obj with the net's faces
 * and its polylines, and parts.obj with all parts as groups. Read: vertices and faces; texture
 * coordinates, normals, lines, groups and materials are passed over. Free-form geometry is read
 * by surface_obj_read.c. */
#include "formats/mesh/obj.h"
#include "core/grow.h"
#include "core/solid/triangles.h"
#include "formats/format.h"
#include "formats/scan.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- writing ---- */

static bool has_net(const lam_model *model) { return model->net && model->net->face_count; }
static int count(const lam_model *model) { return has_net(model) + (model->part_count > 0); }

static void path(const lam_model *model, int i, lam_text *out) {
  lam_text_add(out, i == 0 && has_net(model) ? "net.obj" : "parts.obj");
}

/* A space and a number with 12 significant digits, at most 20 of them decimals. */
static void write_number(lam_text *out, double value) {
  int decimals = value == 0 ? 0 : 11 - (int)floor(log10(fabs(value)));
  lam_text_add(out, " ");
  lam_text_number(out, value, decimals < 0 ? 0 : decimals > 20 ? 20 : decimals);
}

/* A line v x y z per point. */
static void write_vertices(lam_text *out, const lam_vec3 *points, int n) {
  for (int i = 0; i < n; i++) {
    lam_text_add(out, "v");
    write_number(out, points[i].x);
    write_number(out, points[i].y);
    write_number(out, points[i].z);
    lam_text_add(out, "\n");
  }
}

/* An element (f, l) of at most n vertices, without the end of its line; a negative index ends it.
 * Indices count from 1 in the file, and the element's from `first`. */
static void write_element(lam_text *out, const char *letter, const int *vertices, int n,
                          int first) {
  lam_text_add(out, letter);
  for (int k = 0; k < n && vertices[k] >= 0; k++)
    lam_text_printf(out, " %d", first + vertices[k] + 1);
}

/* A group for the faces, then one per family of polylines that has any. A closed polyline repeats
 * its first vertex. */
void lam_obj_net(const lam_model *model, const lam_vec3 *vertices, lam_text *out) {
  static const struct {
    int family;
    const char *group;
  } groups[] = {{0, "family_0"}, {1, "family_1"}, {-1, "boundary"}};

  write_vertices(out, vertices, model->net->vertex_count);
  lam_text_add(out, "g net\n");
  for (int i = 0; i < model->net->face_count; i++) {
    write_element(out, "f", model->net->faces[i], 4, 0);
    lam_text_add(out, "\n");
  }

  for (size_t g = 0; g < sizeof groups / sizeof *groups; g++) {
    bool named = false;
    for (int i = 0; i < model->polyline_count; i++) {
      const lam_polyline *line = &model->polylines[i];
      if (line->family != groups[g].family) continue;
      if (!named) lam_text_printf(out, "g %s\n", groups[g].group);
      named = true;
      write_element(out, "l", line->vertices, line->count, 0);
      if (line->closed) write_element(out, "", line->vertices, 1, 0);
      lam_text_add(out, "\n");
    }
  }
}

/* A solid whose vertices are numbered from `first`. Returns the number of the first vertex behind
 * it. */
static int write_solid(lam_text *out, const lam_trimesh *solid, int first) {
  write_vertices(out, solid->vertices, solid->vertex_count);
  for (int i = 0; i < solid->triangle_count; i++) {
    write_element(out, "f", solid->triangles[i], 3, first);
    lam_text_add(out, "\n");
  }
  return first + solid->vertex_count;
}

/* A group per part; the instances of a part are written out, one after another. */
static void write_parts(const lam_model *model, lam_text *out) {
  int first = 0;
  for (int i = 0; i < model->part_count; i++) {
    const lam_part *part = &model->parts[i];
    lam_text_printf(out, "g %s\n", part->name);
    if (!part->instance_count) first = write_solid(out, &part->solid, first);
    for (int j = 0; j < part->instance_count; j++) {
      lam_trimesh placed = lam_trimesh_placed(out->arena, &part->solid, &part->instances[j]);
      first = write_solid(out, &placed, first);
    }
  }
}

/* File 0 is the net, when there is one; the other one has the parts. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  bool net = i == 0 && has_net(model);
  lam_text_printf(out, "# %s: %s, meters\n", model->name, net ? "net" : "parts");
  if (net)
    lam_obj_net(model, model->net->vertices, out);
  else
    write_parts(model, out);
  return LAM_OK;
}

/* ---- reading ---- */

/* A growing list of numbers. */
typedef struct int_list {
  int count, capacity;
  int *items;
} int_list;

/* What was read so far. */
typedef struct reader {
  lam_scan scan;
  lam_arena *arena;
  int vertex_count, vertex_capacity;
  lam_vec3 *vertices;
  int_list corners;       /* of all faces, counted from 0 */
  int_list starts, lines; /* per face: its first corner, where it stands */
  int most_corners;
} reader;

static void append(lam_arena *arena, int_list *list, int item) {
  LAM_APPEND(arena, list->items, list->count, list->capacity, item);
}

/* v x y z, which may be followed by a weight or a color. A wrong vertex keeps its number, so that
 * the faces below stay right. */
static void read_vertex(reader *r) {
  lam_vec3 p = {0};
  lam_scan_point(&r->scan, "vertex", &p);
  LAM_APPEND(r->arena, r->vertices, r->vertex_count, r->vertex_capacity, p);
}

/* A corner v, v/vt, v//vn or v/vt/vn: its first number, from 1 or negative; 0 when the word is
 * none of these. */
static int parse_corner(lam_word word) {
  char text[64], *at = text, *end;
  if (word.length >= (int)sizeof text) return 0;
  memcpy(text, word.text, (size_t)word.length);
  text[word.length] = 0;

  if (strspn(text, "-0123456789/") != (size_t)word.length) return 0;
  long first = strtol(at, &end, 10);
  if (end == at || first > INT_MAX || first < -INT_MAX) return 0;

  for (int field = 1; *end; field++) {
    if (*end != '/' || field == 3) return 0;
    at = end + 1;
    strtol(at, &end, 10);
  }
  return (int)first;
}

/* A corner of a face, as the number of a vertex from 0; a negative one counts back from the last
 * vertex that stands above. False with a message. Numbers that are too large are found at the
 * end. */
static bool read_corner(reader *r, lam_word word, int *vertex) {
  int corner = parse_corner(word);
  if (corner == 0) {
    lam_error_add(r->scan.errors, r->scan.location, NULL,
                  "face: \"%.*s\" given, a vertex number such as 12 or 12/3/4 (from 1, or "
                  "negative) expected",
                  lam_word_shown(word), word.text);
    return false;
  }
  if (corner < -r->vertex_count) {
    lam_error_add(r->scan.errors, r->scan.location, NULL,
                  "face: vertex %d given, but only %d vertices stand above it", corner,
                  r->vertex_count);
    return false;
  }

  *vertex = corner < 0 ? r->vertex_count + corner : corner - 1;
  return true;
}

/* f and its corners. A wrong face adds a message and no face; reading goes on. */
static void read_face(reader *r) {
  lam_word word;
  int start = r->corners.count;
  while (lam_scan_word(&r->scan, &word)) {
    int vertex;
    if (!read_corner(r, word, &vertex)) return;
    append(r->arena, &r->corners, vertex);
  }

  int corners = r->corners.count - start;
  if (corners < 3 || corners > r->most_corners) {
    const char *expected = r->most_corners == 4 ? "3 or 4" : "3 or more";
    lam_error_add(r->scan.errors, r->scan.location, NULL, "face: %d corners given, %s expected",
                  corners, expected);
    return;
  }
  append(r->arena, &r->starts, start);
  append(r->arena, &r->lines, r->scan.location.line);
}

static void pass_over(reader *r) { (void)r; }

/* Statements by name; those of other content are known, but passed over. */
static const struct {
  const char *name;
  void (*read)(reader *r);
} statements[] = {
    {"v", read_vertex}, {"f", read_face}, {"vt", pass_over},     {"vn", pass_over},
    {"vp", pass_over},  {"l", pass_over}, {"p", pass_over},      {"g", pass_over},
    {"o", pass_over},   {"s", pass_over}, {"usemtl", pass_over}, {"mtllib", pass_over},
};

/* Reads a line, in whatever case its statement is written; empty lines are no statement. */
static void read_statement(reader *r) {
  lam_word word;
  if (!lam_scan_word(&r->scan, &word)) return;
  for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
    if (lam_word_is(word, statements[i].name)) {
      statements[i].read(r);
      return;
    }

  lam_error_add(r->scan.errors, r->scan.location, NULL,
                "\"%.*s\" given, a statement such as v or f expected", lam_word_shown(word),
                word.text);
}

/* Vertices may stand below the faces that use them, so numbers that are too large are found at
 * the end. One message per face, with the line of the face. */
static void check_indices(reader *r) {
  for (int i = 0; i < r->starts.count && !lam_scan_gave_up(&r->scan); i++) {
    int end = i + 1 < r->starts.count ? r->starts.items[i + 1] : r->corners.count;
    for (int k = r->starts.items[i]; k < end; k++) {
      if (r->corners.items[k] < r->vertex_count) continue;
      r->scan.location.line = r->lines.items[i];
      lam_error_add(r->scan.errors, r->scan.location, NULL,
                    "face: vertex %d given, but the file has %d", r->corners.items[k] + 1,
                    r->vertex_count);
      break;
    }
  }
}

/* Reads the whole file. Messages are collected until there are too many; false when there are
 * any. starts gets the end of the last face as one more entry. */
static bool read_all(reader *r) {
  do read_statement(r);
  while (!lam_scan_gave_up(&r->scan) && lam_scan_line(&r->scan));

  if (lam_scan_failed(&r->scan)) return false;
  check_indices(r);

  r->scan.location.line = 0;
  if (!r->starts.count) lam_error_add(r->scan.errors, r->scan.location, NULL, "has no faces");
  append(r->arena, &r->starts, r->corners.count);
  return !lam_scan_failed(&r->scan);
}

/* For the format's row: a quad mesh of faces of three or four corners. */
static bool read_mesh(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                      lam_errors *errors, lam_mesh *mesh) {
  reader r = {.scan = lam_scan_begin(arena, bytes, size, location, errors),
              .arena = arena,
              .most_corners = 4};
  if (!read_all(&r)) return false;

  *mesh = (lam_mesh){
      .vertex_count = r.vertex_count, .vertices = r.vertices, .face_count = r.starts.count - 1};
  mesh->faces = lam_arena_alloc(arena, (size_t)mesh->face_count, sizeof *mesh->faces);
  for (int i = 0; i < mesh->face_count; i++) {
    const int *c = r.corners.items + r.starts.items[i];
    int corners = r.starts.items[i + 1] - r.starts.items[i];
    for (int k = 0; k < 4; k++) mesh->faces[i][k] = k < corners ? c[k] : -1;
  }
  return true;
}

/* For the format's row: triangles. A polygon is cut into the fan of triangles at its first
 * corner. */
static bool read_triangles(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  reader r = {.scan = lam_scan_begin(arena, bytes, size, location, errors),
              .arena = arena,
              .most_corners = INT_MAX};
  if (!read_all(&r)) return false;

  int faces = r.starts.count - 1;
  *mesh = (lam_trimesh){.vertex_count = r.vertex_count, .vertices = r.vertices};
  mesh->triangles =
      lam_arena_alloc(arena, (size_t)(r.corners.count - 2 * faces), sizeof *mesh->triangles);

  for (int i = 0; i < faces; i++)
    for (int k = r.starts.items[i] + 2; k < r.starts.items[i + 1]; k++) {
      int *t = mesh->triangles[mesh->triangle_count++];
      t[0] = r.corners.items[r.starts.items[i]];
      t[1] = r.corners.items[k - 1];
      t[2] = r.corners.items[k];
    }
  return true;
}

const lam_format lam_format_obj = {
    .name = "obj",
    .doc = "The net with its faces and polylines, and the parts as groups, in meters; meshes are "
           "read from it, and free-form surfaces and curves.",
    .ending = "obj",
    .count = count,
    .path = path,
    .write = write,
    .read_mesh = read_mesh,
    .read_triangles = read_triangles,
    .read_surfaces = lam_obj_read_surfaces,
    .read_curves = lam_obj_read_curves,
};
