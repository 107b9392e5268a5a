/* Meshes as other programs write them: joined lines, marks of UTF-8 and other line ends in OBJ,
 * free-form statements beside faces, and the readers of OFF and PLY. The expected numbers stand in
 * the files themselves. */
#include "tests/unit/text_fixture.h"

#include <stdlib.h>

extern const lam_format lam_format_obj, lam_format_off, lam_format_ply, lam_format_stl,
    lam_format_points, lam_format_surface;

/* A file read as a mesh; the message, "LINE: TEXT", or NULL. */
static const char *read(lam_arena *arena, const lam_format *format, const void *bytes, size_t size,
                        lam_mesh *mesh) {
  lam_errors errors = {.arena = arena};
  /* a copy of its own size, so that reading behind its end is found */
  char *copy = malloc(size + (size == 0));
  memcpy(copy, bytes, size);
  bool good = format->read_mesh(arena, copy, size, (lam_location){.file = "x"}, &errors, mesh);
  free(copy);
  assert_true(good == (errors.count == 0));
  return good ? NULL
              : lam_arena_printf(arena, "%d: %s", errors.first->location.line, errors.first->text);
}

static void assert_read(lam_arena *arena, const lam_format *format, const void *bytes, size_t size,
                        lam_mesh *mesh) {
  const char *message = read(arena, format, bytes, size, mesh);
  if (message) fail_msg("%s: %s", format->name, message);
}

/* One quad, (0 0 0) (2 0 0) (2 1 0) (0 1 .5), whose corners are in order. */
static void assert_quad(const lam_mesh *mesh) {
  static const double x[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, .5}};
  assert_int_equal(mesh->vertex_count, 4);
  assert_int_equal(mesh->face_count, 1);
  for (int k = 0; k < 4; k++) {
    assert_int_equal(mesh->faces[0][k], k);
    assert_memory_equal(&mesh->vertices[k], x[k], sizeof x[k]);
  }
}

/* ---- OBJ ---- */

static void obj_dialects_are_read(void **state) {
  static const char *const texts[] = {
      /* joined lines: between words, at the end of a word, in a statement that is passed over, and
       * at the end of the file; a comment ends with its line all the same */
      "v 0 0 \\\n0\nv 2 0\\\n 0\nvn 0 \\\n0 1\n# C:\\\nv 2 1 0 # x \\\nv 0 1 .5\nf 1 2 \\\n3 4\\",
      "v 0 0 \\\r\n0\r\nv 2 0 0\r\nv 2 1 0\r\nv 0 1 .5\r\nf 1 \\\r\n2 3 4\r\n",
      "\xEF\xBB\xBFv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 .5\nf 1 2 3 4\n",
      "v 0 0 0\rv 2 0 0\rv 2 1 0\r# no \\\rv 0 1 .5\rf 1 2 3 4",
      "mg 0\nlod 3\nbevel off\nc_interp off\nd_interp off\nshadow_obj a.obj\ntrace_obj b.obj\n"
      "usemap x\nmaplib y\nctech cparm 1\nstech cparma 1 1\n"
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 .5\nf 1 2 3 4\n"
      "cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 0 0 0 1 1 1 1\ntrim 0 1 1\nend\n",
  };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    lam_mesh mesh;
    assert_read(*state, &lam_format_obj, texts[i], strlen(texts[i]), &mesh);
    assert_quad(&mesh);
  }
}

/* Lines are counted as an editor counts them. */
static void obj_lines_are_counted(void **state) {
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"v 0 0 \\\n0\nv 1 x 0\n", "3: vertex: \"x\" is not a number"},
      {"v 0 0 0\rv 1 x 0\r", "2: vertex: \"x\" is not a number"},
      {"v 0 0 0\r\n\r\nv 1 x 0\r\n", "3: vertex: \"x\" is not a number"},
      {"vn 0 \\\n0 1\nv 1 x 0\n", "3: vertex: \"x\" is not a number"},
      {"call other.obj\n", "1: \"call\" given, a statement such as v or f expected"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_mesh mesh;
    const char *message =
        read(*state, &lam_format_obj, cases[i].text, strlen(cases[i].text), &mesh);
    assert_string_equal(message, cases[i].message);
  }
}

/* The other texts that are read may begin with the mark, too. */
static void marks_of_utf8_are_passed_over(void **state) {
  static const char stl[] = "\xEF\xBB\xBFsolid\nfacet normal 0 0 1 outer loop vertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1 0 endloop endfacet\nendsolid\n",
                    points[] = "\xEF\xBB\xBF"
                               "1 2 3\r4 5 6\r";
  lam_errors errors = {.arena = *state};
  lam_trimesh mesh;
  int count;
  const lam_vec3 *x;
  assert_true(lam_format_stl.read_triangles(*state, stl, sizeof stl - 1, (lam_location){0}, &errors,
                                            &mesh));
  assert_int_equal(mesh.triangle_count, 1);
  assert_true(lam_format_points.read_points(*state, points, sizeof points - 1, (lam_location){0},
                                            &errors, &count, &x));
  assert_int_equal(count, 2);
  ASSERT_EXACT(x[1].z, 6);
}

/* ---- OFF ---- */

static void off_forms_are_read(void **state) {
  static const char *const texts[] = {
      "OFF\n4 1 4\n0 0 0\n2 0 0\n2 1 0\n0 1 .5\n4 0 1 2 3\n",
      "# by hand\nCOFF\n\n4 1\n0 0 0 255 0 0 255\n2 0 0 1 1 1 1\n\n2 1 0 0 0 0 0 # x\n"
      "0 1 .5 1 1 1 1\n4 0 1 2 3 0.5 0.5 0.5\n",
      "OFF4 1 0\r\n0 0 0\r\n2 0 0\r\n2 1 0\r\n0 1 .5\r\n4 0 1 2 3\r\n",
      "STCNOFF 4 1 4\r0 0 0 0 0 1\r2 0 0 0 0 1\r2 1 0 0 0 1\r0 1 .5 0 0 1\r4 0 1 2 3",
  };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    lam_mesh mesh;
    assert_read(*state, &lam_format_off, texts[i], strlen(texts[i]), &mesh);
    assert_quad(&mesh);
  }
}

static void bad_off_is_refused(void **state) {
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "1: the file ends where OFF is expected"},
      {"ply\n", "1: is not an OFF file: it does not begin with OFF"},
      {"4OFF\n1 1 1\n", "1: vertices with other than three coordinates (4OFF, nOFF); expected OFF"},
      {"OFF BINARY\n", "1: a binary OFF file; expected one of text"},
      {"OFF\n-4 1 4\n", "2: number of vertices: \"-4\" is not a number from 0 to 2147483647"},
      {"OFF\n2000000000 1 4\n0 0 0\n", "3: the file ends where a vertex is expected"},
      {"OFF\n1 1 0\n0 0 x\n", "3: vertex: \"x\" is not a number"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "6: face: 2 corners given, 3 expected"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "6: face: vertex 3 given, but the file has 3"},
      {"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "0: has no faces"},
      {"OFF\n5 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n2 2 2\n5 0 1 2 3 4\n",
       "8: face: 5 corners given, 3 or 4 expected"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_mesh mesh;
    const char *message =
        read(*state, &lam_format_off, cases[i].text, strlen(cases[i].text), &mesh);
    assert_string_equal(message, cases[i].message);
  }
}

/* ---- PLY ---- */

#define PLY_HEADER(format, coordinate, corner)                                                     \
  "ply\nformat " format " 1.0\ncomment by hand\nobj_info x\nelement camera 1\n"                    \
  "property list uchar short numbers\nelement vertex 4\nproperty uchar red\n"                      \
  "property " coordinate " x\nproperty " coordinate " y\nproperty " coordinate " z\n"              \
  "element face 1\nproperty list uchar " corner " vertex_indices\nproperty double area\n"          \
  "end_header\n"

static void ply_text_is_read(void **state) {
  static const char text[] = PLY_HEADER(
      "ascii", "float", "int") "2 -7 9\n0 0 0 0\n1 2 0 0\n2 2 1 0\n3 0 1 .5\n4 0 1 2 3 2.1\n";
  lam_mesh mesh;
  assert_read(*state, &lam_format_ply, text, sizeof text - 1, &mesh);
  assert_quad(&mesh);
}

/* Appends the bytes of a number, in the order of this machine or reversed. */
static void add_bytes(lam_text *text, const void *number, size_t size, bool reversed) {
  for (size_t i = 0; i < size; i++)
    lam_text_bytes(text, (const char *)number + (reversed ? size - 1 - i : i), 1);
}

/* The values of PLY_HEADER with coordinates as doubles and corners as short numbers. */
static void add_values(lam_text *text, bool reversed) {
  static const double x[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, .5}}, area = 2.1;
  static const int16_t numbers[2] = {-7, 9};
  add_bytes(text, &(uint8_t){2}, 1, false);
  for (int k = 0; k < 2; k++) add_bytes(text, &numbers[k], 2, reversed);
  for (uint8_t k = 0; k < 4; k++) {
    add_bytes(text, &k, 1, false);
    for (int c = 0; c < 3; c++) add_bytes(text, &x[k][c], 8, reversed);
  }
  add_bytes(text, &(uint8_t){4}, 1, false);
  for (uint16_t k = 0; k < 4; k++) add_bytes(text, &k, 2, reversed);
  add_bytes(text, &area, 8, reversed);
}

static void ply_binary_is_read(void **state) {
  static const uint16_t one = 1;
  bool big_machine = *(const uint8_t *)&one == 0;
  for (int big = 0; big < 2; big++) {
    lam_text text = {.arena = *state};
    lam_text_add(&text, big ? PLY_HEADER("binary_big_endian", "float64", "ushort")
                            : PLY_HEADER("binary_little_endian", "double", "uint16"));
    add_values(&text, big != big_machine);
    lam_mesh mesh;
    assert_read(*state, &lam_format_ply, text.data, text.length, &mesh);
    assert_quad(&mesh);
    for (size_t cut = 1; cut < 20; cut++) /* every one of the last bytes is needed */
      assert_string_equal(read(*state, &lam_format_ply, text.data, text.length - cut, &mesh),
                          "0: is cut off: values are missing at its end");
  }
}

/* The first byte behind a header whose lines end with CR alone may be 10, which is no line end. */
static void ply_header_ends_where_it_says(void **state) {
  static const char text[] = "ply\rformat binary_little_endian 1.0\relement vertex 1\r"
                             "property uchar x\rproperty uchar y\rproperty uchar z\rend_header\r"
                             "\n\2\3";
  lam_errors errors = {.arena = *state};
  int count;
  const lam_vec3 *x;
  assert_true(lam_format_ply.read_points(*state, text, sizeof text - 1, (lam_location){0}, &errors,
                                         &count, &x));
  assert_int_equal(count, 1);
  ASSERT_EXACT(x[0].x, 10);
  ASSERT_EXACT(x[0].z, 3);
}

static void bad_ply_is_refused(void **state) {
#define PLY_POINTS(format, count)                                                                  \
  "ply\nformat " format " 1.0\nelement vertex " count "\nproperty float x\n"
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "1: is not a PLY file: it does not begin with ply"},
      {"ply\nformat ascii 1.0\n", "2: the file ends where end_header is expected"},
      {"ply\nformat text 1.0\n",
       "2: \"text\" given, ascii, binary_little_endian or binary_big_endian expected"},
      {"ply\nproperty float x\n", "2: a property given before any element"},
      {PLY_POINTS("ascii", "1") "property half y\n",
       "5: \"half\" given, a type such as float, int or uchar expected"},
      {PLY_POINTS("ascii", "1") "property list float int y\n",
       "5: \"float\" given, a type of whole numbers expected"},
      {PLY_POINTS("ascii", "9999999999") "end_header\n",
       "3: number of elements: \"9999999999\" is not a number from 0 to 2147483647"},
      {PLY_POINTS("ascii", "2000000000") "end_header\n1\n",
       "6: the file ends where a value is expected"},
      {PLY_POINTS("binary_little_endian", "1") "end_header\n\xff\xff\xff\xff",
       "0: a vertex has a coordinate that is not a finite number"},
      {PLY_POINTS("ascii", "1") "end_header\n1\n", "0: has no faces"},
      {"ply\nformat ascii 1.0\nelement face 1\nproperty list char int vertex_index\n"
       "end_header\n-3 1 2 3\n",
       "6: a list of a number of items that is none"},
      {"ply\nformat ascii 1.0\nelement face 1\nproperty list char int vertex_index\n"
       "end_header\n3 1 2 -3\n",
       "6: face: a corner that is no vertex number (from 0)"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_mesh mesh;
    const char *message =
        read(*state, &lam_format_ply, cases[i].text, strlen(cases[i].text), &mesh);
    assert_string_equal(message, cases[i].message);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(obj_dialects_are_read),
      TEXT_TEST(obj_lines_are_counted),
      TEXT_TEST(marks_of_utf8_are_passed_over),
      TEXT_TEST(off_forms_are_read),
      TEXT_TEST(bad_off_is_refused),
      TEXT_TEST(ply_text_is_read),
      TEXT_TEST(ply_binary_is_read),
      TEXT_TEST(ply_header_ends_where_it_says),
      TEXT_TEST(bad_ply_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
