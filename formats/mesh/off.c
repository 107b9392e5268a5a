/* The reader `off` (listed in formats/list/formats.c): meshes in the Object File Format of
 * Geomview, as text. Behind the word OFF stand the numbers of vertices, faces and edges, then a
 * line for each vertex (x y z) and for each face (the number of its corners and the corners, from
 * 0). Colors, normals and texture coordinates, which COFF, NOFF and STOFF have, follow in these
 * lines and are not read. Called through the list of formats by gen/library/read_files.c. */
#include "formats/format.h"
#include "formats/mesh/polygons.h"
#include "formats/scan.h"

#include <limits.h>
#include <string.h>

typedef struct reader {
  lam_scan scan;
  lam_polygons polygons; /* what was read so far */
} reader;

static bool fail(reader *r, const char *text) {
  lam_error_add(r->scan.errors, r->scan.location, NULL, "%s", text);
  return false;
}

/* The word that the file begins with: OFF, or OFF with letters before it that say what more its
 * lines have. Some programs write the first number right behind it, which is left as *rest. */
static bool read_heading(reader *r, lam_word *rest) {
  static const char text_expected[] = "is not an OFF file: it does not begin with OFF";
  lam_word word;
  if (!lam_scan_next(&r->scan, "OFF", &word)) return false;

  int letters = 0;
  while (letters < word.length && strchr("STCNn4", word.text[letters])) letters++;
  bool is_off = word.length >= letters + 3 && memcmp(word.text + letters, "OFF", 3) == 0;
  if (!is_off) return fail(r, text_expected);
  if (memchr(word.text, '4', (size_t)letters) || memchr(word.text, 'n', (size_t)letters))
    return fail(r, "vertices with other than three coordinates (4OFF, nOFF); expected OFF");

  *rest = (lam_word){word.text + letters + 3, word.length - letters - 3};
  return true;
}

/* The numbers of vertices, faces and edges, of which the last may be missing. */
static bool read_counts(reader *r, lam_word first, int *vertices, int *faces) {
  lam_word word = first;
  if (!word.length && !lam_scan_next(&r->scan, "the number of vertices", &word)) return false;
  if (lam_word_is(word, "BINARY")) return fail(r, "a binary OFF file; expected one of text");
  return lam_scan_count(&r->scan, word, "number of vertices", vertices) &&
         lam_scan_next(&r->scan, "the number of faces", &word) &&
         lam_scan_count(&r->scan, word, "number of faces", faces);
}

/* Goes to the next line that has words; what is left of this one is passed over. False at the end,
 * with a message that `what` is missing. */
static bool next_line(reader *r, const char *what) {
  lam_scan at;
  lam_word word;
  do {
    if (!lam_scan_line(&r->scan)) {
      lam_error_add(r->scan.errors, r->scan.location, NULL, "the file ends where %s is expected",
                    what);
      return false;
    }
    at = r->scan;
  } while (!lam_scan_word(&at, &word));
  return true;
}

static bool read_vertices(reader *r, int count) {
  for (int i = 0; i < count; i++) {
    lam_vec3 p;
    if (!next_line(r, "a vertex") || !lam_scan_point(&r->scan, "vertex", &p)) return false;
    lam_polygons_vertex(&r->polygons, p);
  }
  return true;
}

/* A line with the number of corners and the corners. */
static bool read_face(reader *r) {
  lam_word word;
  int corners, corner, start = r->polygons.corners.count;
  if (!next_line(r, "a face") || !lam_scan_word(&r->scan, &word) ||
      !lam_scan_count(&r->scan, word, "number of corners", &corners))
    return false;

  for (int k = 0; k < corners; k++) {
    if (!lam_scan_word(&r->scan, &word)) {
      lam_error_add(r->scan.errors, r->scan.location, NULL, "face: %d corners given, %d expected",
                    k, corners);
      return false;
    }
    if (!lam_scan_count(&r->scan, word, "face", &corner)) return false;
    lam_polygons_corner(&r->polygons, corner);
  }
  lam_polygons_face(&r->polygons, start, r->scan.location, r->scan.errors);
  return !lam_scan_gave_up(&r->scan);
}

/* Reads the vertices, and the faces unless only points are wanted. False with messages. */
static bool read_all(reader *r, bool points) {
  lam_word rest = {0};
  int vertices, faces;
  if (!read_heading(r, &rest) || !read_counts(r, rest, &vertices, &faces) ||
      !read_vertices(r, vertices))
    return false;
  if (points) return vertices > 0 || fail(r, "has no vertices");

  for (int i = 0; i < faces; i++)
    if (!read_face(r)) return false;
  return !lam_scan_failed(&r->scan) &&
         lam_polygons_check(&r->polygons, 0, r->scan.location, r->scan.errors);
}

/* For the format's row: faces of three or four corners. */
static bool read_mesh(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                      lam_errors *errors, lam_mesh *mesh) {
  reader r = {lam_scan_begin(arena, bytes, size, location, errors),
              {.arena = arena, .most_corners = 4}};
  if (!read_all(&r, false)) return false;
  *mesh = lam_polygons_mesh(&r.polygons);
  return true;
}

/* For the format's row: triangles. */
static bool read_triangles(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  reader r = {lam_scan_begin(arena, bytes, size, location, errors),
              {.arena = arena, .most_corners = INT_MAX}};
  if (!read_all(&r, false)) return false;
  *mesh = lam_polygons_triangles(&r.polygons);
  return true;
}

/* For the format's row: vertices, whether there are faces or not. */
static bool read_points(lam_arena *arena, const char *bytes, size_t size, lam_location location,
                        lam_errors *errors, int *count, const lam_vec3 **points) {
  reader r = {lam_scan_begin(arena, bytes, size, location, errors), {.arena = arena}};
  if (!read_all(&r, true)) return false;
  *count = r.polygons.vertex_count;
  *points = r.polygons.vertices;
  return true;
}

const lam_format lam_format_off = {
    .name = "off",
    .doc = "Meshes in Geomview's Object File Format, as text, in meters.",
    .ending = "off",
    .unit = 1,
    .read_mesh = read_mesh,
    .read_triangles = read_triangles,
    .read_points = read_points,
};
