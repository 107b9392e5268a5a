/* Wavefront OBJ in meters (listed in formats/list/formats.c). Written: net.obj with the net's faces
 * and its polylines, and parts.obj with all parts as groups. Read: vertices and faces; texture
 * coordinates, normals, lines, groups and materials are passed over. Free-form geometry is read
 * by surface_obj_read.c. */
#include "formats/mesh/obj.h"
#include "core/solid/triangles.h"
#include "formats/format.h"
#include "formats/mesh/polygons.h"

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

typedef struct reader {
  lam_scan scan;
  lam_polygons polygons; /* what was read so far */
} reader;

/* v x y z, which may be followed by a weight or a color. A wrong vertex keeps its number, so that
 * the faces below stay right. */
static void read_vertex(reader *r) {
  lam_vec3 p = {0};
  lam_scan_point(&r->scan, "vertex", &p);
  lam_polygons_vertex(&r->polygons, p);
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
  int corner = parse_corner(word), above = r->polygons.vertex_count;
  if (corner == 0) {
    lam_error_add(r->scan.errors, r->scan.location, NULL,
                  "face: \"%.*s\" given, a vertex number such as 12 or 12/3/4 (from 1, or "
                  "negative) expected",
                  lam_word_shown(word), word.text);
    return false;
  }
  if (corner < -above) {
    lam_error_add(r->scan.errors, r->scan.location, NULL,
                  "face: vertex %d given, but only %d vertices stand above it", corner, above);
    return false;
  }

  *vertex = corner < 0 ? above + corner : corner - 1;
  return true;
}

/* f and its corners. A wrong face adds a message and no face; reading goes on. */
static void read_face(reader *r) {
  lam_word word;
  int start = r->polygons.corners.count;
  while (lam_scan_word(&r->scan, &word)) {
    int vertex;
    if (!read_corner(r, word, &vertex)) return;
    lam_polygons_corner(&r->polygons, vertex);
  }
  lam_polygons_face(&r->polygons, start, r->scan.location, r->scan.errors);
}

/* Statements of other content (specification 3.0, appendix B1): known, but passed over. Those that
 * bring in other files (call, csh) are not among them, because faces may stand there. */
static const char *const passed_over[] = {
    "vt",    "vn",     "vp",         "l",         "p",      "g",    "o",        "s",
    "mg",    "usemtl", "mtllib",     "usemap",    "maplib", "lod",  "bevel",    "c_interp",
    "ctech", "stech",  "shadow_obj", "trace_obj", "cstype", "deg",  "bmat",     "step",
    "curv",  "curv2",  "surf",       "parm",      "trim",   "hole", "scrv",     "sp",
    "con",   "end",    "bsp",        "bzp",       "cdc",    "cdp",  "d_interp", "res",
};

/* Reads a line, in whatever case its statement is written; empty lines are no statement. */
static void read_statement(reader *r) {
  lam_word word;
  if (!lam_scan_word(&r->scan, &word)) return;
  if (lam_word_is(word, "v")) {
    read_vertex(r);
    return;
  }
  if (lam_word_is(word, "f")) {
    read_face(r);
    return;
  }

  for (size_t i = 0; i < sizeof passed_over / sizeof *passed_over; i++)
    if (lam_word_is(word, passed_over[i])) return;
  lam_error_add(r->scan.errors, r->scan.location, NULL,
                "\"%.*s\" given, a statement such as v or f expected", lam_word_shown(word),
                word.text);
}

lam_scan lam_obj_scan(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors) {
  lam_scan scan = lam_scan_begin(arena, bytes, count, location, errors);
  scan.joins = true;
  return scan;
}

/* Reads the whole file. Messages are collected until there are too many; false when there are
 * any. */
static bool read_all(reader *r) {
  do read_statement(r);
  while (!lam_scan_gave_up(&r->scan) && lam_scan_line(&r->scan));
  return !lam_scan_failed(&r->scan) &&
         lam_polygons_check(&r->polygons, 1, r->scan.location, r->scan.errors);
}

/* For the format's row: a quad mesh of faces of three or four corners. */
static bool read_mesh(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                      lam_errors *errors, lam_mesh *mesh) {
  reader r = {lam_obj_scan(arena, bytes, size, location, errors),
              {.arena = arena, .most_corners = 4}};
  if (!read_all(&r)) return false;
  *mesh = lam_polygons_mesh(&r.polygons);
  return true;
}

/* For the format's row: triangles. */
static bool read_triangles(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  reader r = {lam_obj_scan(arena, bytes, size, location, errors),
              {.arena = arena, .most_corners = INT_MAX}};
  if (!read_all(&r)) return false;
  *mesh = lam_polygons_triangles(&r.polygons);
  return true;
}

const lam_format lam_format_obj = {
    .name = "obj",
    .doc = "The net with its faces and polylines, and the parts as groups, in meters; meshes are "
           "read from it, and free-form surfaces and curves.",
    .ending = "obj",
    .unit = 1,
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
    .read_mesh = read_mesh,
    .read_triangles = read_triangles,
    .read_surfaces = lam_obj_read_surfaces,
    .read_curves = lam_obj_read_curves,
};
