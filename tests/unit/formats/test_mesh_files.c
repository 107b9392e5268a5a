/* Reading and writing STL and OBJ; whole files on disk. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/file.h"
#include "core/solid/solid.h"
#include "formats/format.h"
#include "mesh_fixture.h"
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

extern const lam_format lam_format_stl, lam_format_obj;

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

/* A model of two parts: a box of 12 m x 100 mm x 1.5 mm, and a 10 mm cube that stands in two
 * places. */
static lam_model two_parts(lam_arena *arena) {
  static lam_pose frames[2] = {{{1, 2, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                               {{-1, 0, 0}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}};
  lam_part *parts = LAM_NEW(arena, lam_part, 2);
  parts[0] =
      (lam_part){.name = "A01", .solid = mesh_box(arena, lam_v3(0, 0, 0), lam_v3(12, 0.0015, 0.1))};
  parts[1] = (lam_part){.name = "node", .solid = mesh_cube(arena, 0, 0, 0, 0.01)};
  parts[1].instance_count = 2;
  parts[1].instances = frames;
  return (lam_model){.name = "box", .part_count = 2, .parts = parts};
}

static lam_text written(lam_arena *arena, const lam_format *format, const lam_model *model, int i) {
  lam_text text = {.arena = arena};
  assert_int_equal(format->write(model, i, &text), LAM_OK);
  return text;
}

static const char *path_of(lam_arena *arena, const lam_format *format, const lam_model *model,
                           int i) {
  lam_text text = {.arena = arena};
  format->path(model, i, &text);
  return text.data;
}

static bool read_stl(lam_arena *arena, const char *bytes, size_t count, lam_trimesh *mesh,
                     const char **message) {
  lam_errors errors = {.arena = arena};
  bool read = lam_format_stl.read_triangles(arena, bytes, count, (lam_location){.file = "x"},
                                            &errors, mesh);
  *message = errors.first ? lam_arena_printf(arena, "%d: %s", errors.first->location.line,
                                             errors.first->text)
                          : NULL;
  assert_int_equal(read, errors.count == 0);
  return read;
}

/* ---- STL ---- */

static void stl_keeps_solids(void **state) {
  lam_model model = two_parts(*state);
  assert_int_equal(lam_format_stl.count(&model), 3);
  assert_string_equal(path_of(*state, &lam_format_stl, &model, 0), "parts/A01.stl");
  assert_string_equal(path_of(*state, &lam_format_stl, &model, 2), "assembly.stl");
  lam_text text = written(*state, &lam_format_stl, &model, 0);
  assert_int_equal(text.length, 84 + 12 * 50);
  assert_memory_not_equal(text.data, "solid", 5);
  lam_trimesh mesh;
  const char *message;
  assert_true(read_stl(*state, text.data, text.length, &mesh, &message));
  assert_int_equal(mesh.vertex_count, 8);
  assert_near(lam_trimesh_volume(&mesh), 12 * 0.0015 * 0.1, 1e-12);
  text = written(*state, &lam_format_stl, &model,
                 2); /* with both instances: 36 triangles in three components */
  assert_true(read_stl(*state, text.data, text.length, &mesh, &message));
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(&mesh, true, &facts), LAM_OK);
  assert_int_equal(facts.components, 3);
  assert_true(facts.closed && facts.oriented && facts.self_intersections == 0);
  assert_near(facts.volume, 12 * 0.0015 * 0.1 + 2e-6, 1e-11);
  assert_near(facts.min.x, -1.01,
              1e-6); /* the second node is turned by 90 degrees and stands at x = -1 */
}

/* The first triangle of the cube lies in the plane z = 0 and looks down. */
static void stl_normals_are_computed(void **state) {
  lam_model model = two_parts(*state);
  lam_text text = written(*state, &lam_format_stl, &model, 1);
  float normal[3];
  memcpy(normal, text.data + 84, sizeof normal);
  assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == -1);
}

static const char tetrahedron[] =
    "solid a b c\n"
    " facet normal 0 0 -1\n  outer loop\n   vertex 0 0 0\n   vertex 0 1e3 0\n"
    "   vertex 1000 0 0\n  endloop\n endfacet\n"
    "FACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0 VERTEX 1000 0 0 VERTEX 0 0 1000.0\n"
    "ENDLOOP ENDFACET\r\n"
    "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 1000 vertex 0 1000 0 endloop "
    "endfacet\n"
    "facet normal 1 1 1 outer loop vertex 1000 0 0 vertex 0 1000 0 vertex 0 0 1000\n"
    "endloop endfacet endsolid a b c\n";

/* A corner of a cube of 1 m: volume 1/6. */
static void stl_text_is_read(void **state) {
  lam_trimesh mesh;
  const char *message;
  if (!read_stl(*state, tetrahedron, strlen(tetrahedron), &mesh, &message)) fail_msg("%s", message);
  assert_int_equal(mesh.vertex_count, 4);
  assert_int_equal(mesh.triangle_count, 4);
  assert_near(lam_trimesh_volume(&mesh), 1. / 6, 1e-15);
}

static void bad_stl_is_refused_with_a_reason(void **state) {
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "0: is not an STL file: it neither begins with \"solid\" nor has a header"},
      {"hello", "0: is not an STL file: it neither begins with \"solid\" nor has a header"},
      {"solid x\nendsolid x\n", "0: has no triangles"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n",
       "4: vertex: \"zero\" is not a number"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
       "4: vertex: 2 numbers given, 3 expected"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
       "6: \"endloop\" given, \"vertex\" expected"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1e999 0 0\n",
       "6: vertex: \"1e999\" is not a number"},
      {"solid x\nfacet normal 0 0 1\nouter", "3: the file ends where \"loop\" is expected"},
      {"solid x\nface normal\n", "2: \"face\" given, \"facet\" or \"endsolid\" expected"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0x1 0 0\n",
       "4: vertex: \"0x1\" is not a number"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_trimesh mesh;
    const char *message;
    assert_false(read_stl(*state, cases[i].text, strlen(cases[i].text), &mesh, &message));
    assert_string_equal(message, cases[i].message);
  }
}

static void bad_binary_stl_is_refused_with_a_reason(void **state) {
  lam_model model = two_parts(*state);
  lam_text text = written(*state, &lam_format_stl, &model, 0);
  lam_trimesh mesh;
  const char *message;
  assert_false(read_stl(*state, text.data, text.length - 1, &mesh, &message));
  assert_string_equal(message,
                      "0: a binary STL file of 12 triangles has 684 bytes; this one has 683");
  memset(text.data + 84 + 50 + 12, 0xff, 4); /* a nan in the second triangle */
  assert_false(read_stl(*state, text.data, text.length, &mesh, &message));
  assert_string_equal(message, "0: triangle 2 has a coordinate that is not a finite number");
  memset(text.data + 80, 0xff, 4);
  assert_false(read_stl(*state, text.data, text.length, &mesh, &message));
  assert_string_equal(
      message,
      "0: a binary STL file of 4294967295 triangles has 214748364834 bytes; this one has 684");
}

/* admesh is a program of its own: it must find the same volume and nothing to repair. */
static void admesh_agrees(void **state) {
  lam_model model = two_parts(*state);
  lam_text text = written(*state, &lam_format_stl, &model, 1);
  lam_errors errors = {.arena = *state};
  char folder[] = "/tmp/lamella-test-XXXXXX";
  assert_non_null(mkdtemp(folder));
  char *path = lam_arena_printf(*state, "%s/cube.stl", folder);
  assert_int_equal(lam_file_write_atomic(path, text.data, text.length, &errors), LAM_OK);
  FILE *report = popen(lam_arena_printf(*state, "admesh %s 2>/dev/null", path), "r");
  char line[256];
  double volume = -1;
  bool ran = false;
  while (report && fgets(line, sizeof line, report)) {
    const char *found = strstr(line, "Volume");
    ran = true;
    if (found) sscanf(strchr(found, ':') + 1, "%lf", &volume);
  }
  if (report) pclose(report);
  unlink(path);
  rmdir(folder);
  if (!ran) skip();
  assert_near(volume, 1000, 1e-3); /* mm^3 */
}

/* ---- OBJ ---- */

static bool read_obj(lam_arena *arena, const char *text, lam_mesh *mesh, const char **message) {
  lam_errors errors = {.arena = arena};
  bool read = lam_format_obj.read_mesh(arena, text, strlen(text), (lam_location){.file = "x"},
                                       &errors, mesh);
  *message = errors.first ? lam_arena_printf(arena, "%d: %s", errors.first->location.line,
                                             errors.first->text)
                          : NULL;
  assert_int_equal(read, errors.count == 0);
  return read;
}

static void obj_keeps_nets(void **state) {
  lam_vec3 p[6] = {{0, 0, 1. / 3}, {1e-7 / 3, 0, 0}, {-1234.56789012345, 2e5 / 3, 0},
                   {0, 1, 0},      {1, 1, 1},        {2, 1, -1}};
  int faces[2][4] = {{0, 1, 4, 3}, {1, 2, 5, -1}}, line[3] = {0, 1, 2}, loop[4] = {0, 1, 4, 3};
  lam_mesh net = {6, p, 2, faces}, read;
  lam_polyline lines[2] = {{-1, true, 4, loop}, {0, false, 3, line}};
  lam_model model = {.name = "net", .net = &net, .polyline_count = 2, .polylines = lines};
  assert_int_equal(lam_format_obj.count(&model), 1);
  assert_string_equal(path_of(*state, &lam_format_obj, &model, 0), "net.obj");
  lam_text text = written(*state, &lam_format_obj, &model, 0);
  assert_non_null(strstr(text.data, "g family_0\nl 1 2 3\ng boundary\nl 1 2 5 4 1\n"));
  assert_non_null(strstr(text.data, "v 0 0 0.333333333333\n"));
  const char *message;
  if (!read_obj(*state, text.data, &read, &message)) fail_msg("%s", message);
  assert_int_equal(read.vertex_count, 6);
  assert_int_equal(read.face_count, 2);
  assert_memory_equal(read.faces, faces, sizeof faces);
  for (int i = 0; i < 6; i++) /* 12 significant digits */
    assert_near(lam_distance(read.vertices[i], p[i]), 0, 1e-11 * lam_length(p[i]));
}

static void obj_keeps_parts(void **state) {
  lam_model model = two_parts(*state);
  assert_int_equal(lam_format_obj.count(&model), 1);
  assert_string_equal(path_of(*state, &lam_format_obj, &model, 0), "parts.obj");
  lam_text text = written(*state, &lam_format_obj, &model, 0);
  lam_errors errors = {.arena = *state};
  lam_trimesh mesh;
  assert_true(lam_format_obj.read_triangles(*state, text.data, text.length, (lam_location){0},
                                            &errors, &mesh));
  assert_int_equal(mesh.triangle_count, 36);
  assert_near(lam_trimesh_volume(&mesh), 12 * 0.0015 * 0.1 + 2e-6, 1e-14);
}

static const char usual_obj[] =
    "# a comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\r\nv 1 1 0 0.5 0.5 0.5\n"
    "v 0 1 0\nvt 0 0\nvn 0 0 1\ng x\nusemtl y\ns off\n"
    "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4//1 -3//1 -2//1\nf 1/1 3/1 4/1 # end\nl 1 2 3\n";

static void obj_forms_are_read(void **state) {
  lam_mesh mesh;
  const char *message;
  if (!read_obj(*state, usual_obj, &mesh, &message)) fail_msg("%s", message);
  const int faces[3][4] = {{0, 1, 2, 3}, {0, 1, 2, -1}, {0, 2, 3, -1}};
  assert_int_equal(mesh.face_count, 3);
  assert_memory_equal(mesh.faces, faces, sizeof faces);
  lam_errors errors = {.arena = *state};
  const char *pentagon =
      "f 1 2 3 4 5\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0"; /* the face comes first */
  lam_trimesh fan;
  assert_true(lam_format_obj.read_triangles(*state, pentagon, strlen(pentagon), (lam_location){0},
                                            &errors, &fan));
  assert_int_equal(fan.triangle_count, 3);
  assert_near(lam_trimesh_area(&fan), 3, 1e-15); /* a rectangle of 2 and a triangle of 1 */
}

static void bad_obj_is_refused_with_a_reason(void **state) {
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "0: has no faces"},
      {"v 0 0 0\n", "0: has no faces"},
      {"v 0 0\n", "1: vertex: 2 numbers given, 3 expected"},
      {"v 0 0 0\nv 1,5 0 0\n", "2: vertex: \"1,5\" is not a number"},
      {"v 0 0 nan\n", "1: vertex: \"nan\" is not a number"},
      {"v 0 0 0\nv 1 0 0\nv 1 1 0\n\nf 1 2 4\n", "5: face: vertex 4 given, but the file has 3"},
      {"v 0 0 0\nf 1 -2 1\n", "2: face: vertex -2 given, but only 1 vertices stand above it"},
      {"v 0 0 0\nf 1 0 1\n",
       "2: face: \"0\" given, a vertex number such as 12 or 12/3/4 (from 1, or negative) expected"},
      {"v 0 0 0\nf 1 1/2/3/4 1\n", "2: face: \"1/2/3/4\" given, a vertex number such as 12 or "
                                   "12/3/4 (from 1, or negative) expected"},
      {"v 0 0 0\nf 1 99999999999999999999 1\n",
       "2: face: \"99999999999999999999\" given, a vertex number such as 12 or "
       "12/3/4 (from 1, or negative) expected"},
      {"v 0 0 0\nf 1 1\n", "2: face: 2 corners given, 3 or 4 expected"},
      {"v 0 0 0\nf 1 1 1 1 1\n", "2: face: 5 corners given, 3 or 4 expected"},
      {"solid x\n", "1: \"solid\" given, a statement such as v or f expected"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_mesh mesh;
    const char *message;
    assert_false(read_obj(*state, cases[i].text, &mesh, &message));
    assert_string_equal(message, cases[i].message);
  }
}

static void errors_stop_after_a_while(void **state) {
  lam_text text = {.arena = *state};
  lam_errors errors = {.arena = *state};
  lam_mesh mesh;
  for (int i = 0; i < 1000; i++) lam_text_add(&text, "v a b c\n");
  assert_false(
      lam_format_obj.read_mesh(*state, text.data, text.length, (lam_location){0}, &errors, &mesh));
  assert_int_equal(errors.count, 20);
}

/* Numbers keep their decimal point where the locale has a comma. */
static void files_do_not_depend_on_the_locale(void **state) {
  const char *before = lam_arena_copy(*state, setlocale(LC_ALL, NULL));
  if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8")) skip();
  lam_trimesh mesh;
  const char *message;
  assert_true(read_stl(*state, tetrahedron, strlen(tetrahedron), &mesh, &message));
  lam_model model = two_parts(*state);
  assert_null(strchr(written(*state, &lam_format_obj, &model, 0).data + 40, ','));
  setlocale(LC_ALL, before);
}

/* ---- whole files ---- */

static void files_are_replaced_whole(void **state) {
  lam_errors errors = {.arena = *state};
  char folder[] = "/tmp/lamella-test-XXXXXX", *bytes;
  size_t count;
  assert_non_null(mkdtemp(folder));
  char *deep = lam_arena_printf(*state, "%s/a/b//c/", folder),
       *path = lam_arena_printf(*state, "%sfile", deep);
  assert_int_equal(lam_path_make_dirs(deep, &errors), LAM_OK);
  assert_int_equal(lam_path_make_dirs(deep, &errors), LAM_OK); /* again */
  assert_int_equal(lam_file_write_atomic(path, "one\0two", 7, &errors), LAM_OK);
  assert_int_equal(lam_file_write_atomic(path, "three", 5, &errors), LAM_OK);
  assert_int_equal(lam_file_read(*state, path, 100, &errors, &bytes, &count), LAM_OK);
  assert_int_equal(count, 5);
  assert_string_equal(bytes, "three");
  assert_int_equal(errors.count, 0);
  assert_int_equal(lam_file_read(*state, path, 4, &errors, &bytes, &count), LAM_BAD_INPUT);
  assert_string_equal(errors.last->text, "is larger than 4 bytes");
  assert_int_equal(lam_file_read(*state, "/no/such", 4, &errors, &bytes, &count), LAM_IO);
  assert_string_equal(errors.last->text, "cannot be opened: No such file or directory");
  assert_string_equal(errors.last->location.file, "/no/such");
  assert_int_equal(lam_file_read(*state, folder, 4, &errors, &bytes, &count), LAM_IO);
  assert_string_equal(errors.last->text, "cannot be read: Is a directory");
  assert_int_equal(lam_file_write_atomic("/no/such/file", "x", 1, &errors), LAM_IO);
  assert_int_equal(lam_path_make_dirs(lam_arena_printf(*state, "%s/x", path), &errors), LAM_IO);
  assert_string_equal(errors.last->text, "is not a folder: Not a directory");
  assert_int_equal(lam_file_write_atomic("/dev/null", "x", 1, &errors), LAM_OK);
  struct stat info;
  assert_true(stat("/dev/null", &info) == 0 && S_ISCHR(info.st_mode)); /* still what it was */
  assert_int_equal(
      system(lam_arena_printf(*state, "test \"$(ls -A %s)\" = file && rm -r %s", deep, folder)), 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(stl_keeps_solids),
      TEST(stl_normals_are_computed),
      TEST(stl_text_is_read),
      TEST(bad_stl_is_refused_with_a_reason),
      TEST(bad_binary_stl_is_refused_with_a_reason),
      TEST(admesh_agrees),
      TEST(obj_keeps_nets),
      TEST(obj_keeps_parts),
      TEST(obj_forms_are_read),
      TEST(bad_obj_is_refused_with_a_reason),
      TEST(errors_stop_after_a_while),
      TEST(files_do_not_depend_on_the_locale),
      TEST(files_are_replaced_whole),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
