/* STL, OBJ, OFF and PLY files of any bytes: the readers must not crash, must say what is wrong in
 * single lines, and what they do read must be measured without harm.
 *
 * As a fuzzer:
 *   clang -g -O1 -std=c11 -D_GNU_SOURCE -fsanitize=fuzzer,address,undefined -Igen -I.
 * tests/torture/fuzz_mesh.c \ formats/mesh/stl.c formats/mesh/obj.c formats/mesh/off.c
 * formats/mesh/ply.c formats/scan.c \ build/liblamella.a -lgmp
 * -lmpfr -lstdc++ -lm -o fuzz_mesh
 *   ./fuzz_mesh -max_len=4096 corpus
 * As a test, with -DLAM_FUZZ_DRIVER: mutates small files in a fixed sequence.
 *   fuzz_mesh [ROUNDS [SEED]] */
#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "formats/format.h"
#include "mesh/tidy.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const lam_format lam_format_stl, lam_format_obj, lam_format_off, lam_format_ply;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void fail(const char *what) {
  fprintf(stderr, "fuzz_mesh: %s\n", what);
  abort();
}

static void check_messages(const lam_errors *errors, bool good) {
  if (good != (errors->count == 0)) fail("messages and result disagree");
  for (const lam_error *e = errors->first; e; e = e->next)
    if (!e->text[0] || strchr(e->text, '\n') || e->location.line < 0)
      fail("a message is not one line");
}

/* Closest points and overlaps with a box, of small meshes. */
static void use(lam_arena *arena, const lam_trimesh *read) {
  enum { largest = 400 };
  if (read->triangle_count > largest) return;
  lam_trimesh mesh = lam_trimesh_weld(arena, read, 0);
  lam_solid_facts facts;
  if (lam_solid_measure(&mesh, true, &facts) != LAM_OK)
    fail("a mesh that was read cannot be measured");
  if (facts.components > facts.triangles || facts.self_intersections < 0) fail("wrong counts");
  lam_tree *tree = lam_tree_new(&mesh, NULL);
  if (tree) {
    lam_vec3 closest;
    int triangle;
    lam_tree_closest(tree, lam_v3(0.1, 0.2, 0.3), &closest, &triangle);
    if (triangle < 0 || triangle >= mesh.triangle_count) fail("no closest triangle");
    lam_tree_free(tree);
  }
  lam_solid_set *set = lam_solid_set_new();
  lam_pose moved = {{0.001, 0.002, 0.003}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double volume = 0;
  if (set && lam_solid_set_add(set, &mesh, NULL) == 0 && lam_solid_set_add(set, &mesh, &moved) == 1)
    if (lam_solid_set_overlap(set, 0, 1, &volume) == LAM_OK && !(volume >= 0))
      fail("a negative overlap");
  lam_solid_set_free(set);
}

/* Faces, tidied once as they are and once welded, and points. */
static void use_faces(const lam_format *format, lam_arena *arena, const char *bytes, size_t size) {
  lam_location location = {.file = "fuzz"};
  lam_errors errors = {.arena = arena}, more = {.arena = arena};
  lam_mesh mesh;
  bool good = format->read_mesh && format->read_mesh(arena, bytes, size, location, &errors, &mesh);
  if (format->read_mesh) check_messages(&errors, good);
  for (int k = 0; good && k < 2; k++) {
    lam_tidied found;
    int face;
    lam_mesh tidied = mesh;
    if (!lam_mesh_tidy(arena, &tidied, k ? .5 : -1, &found, &face)) continue;
    if (found.unused < 0 || found.turned > mesh.face_count || found.pieces > mesh.face_count ||
        tidied.vertex_count + found.unused + found.welded != mesh.vertex_count)
      fail("wrong counts of tidying");
  }

  int count;
  const lam_vec3 *points;
  if (format->read_points)
    check_messages(&more,
                   format->read_points(arena, bytes, size, location, &more, &count, &points));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const lam_format *const formats[] = {&lam_format_stl, &lam_format_obj, &lam_format_off,
                                       &lam_format_ply};
  for (int i = 0; i < 4; i++) {
    lam_arena *arena = lam_arena_new();
    if (!arena) return 0;
    char *bytes = lam_arena_alloc(arena, size, 1);
    if (size) memcpy(bytes, data, size);
    lam_errors errors = {.arena = arena};
    lam_trimesh triangles;
    bool good = formats[i]->read_triangles(arena, bytes, size, (lam_location){.file = "fuzz"},
                                           &errors, &triangles);
    check_messages(&errors, good);
    if (good) use(arena, &triangles);
    use_faces(formats[i], arena, bytes, size);
    lam_arena_free(arena);
  }
  return 0;
}

#ifdef LAM_FUZZ_DRIVER
#include "tests/torture/fuzz.h"

static const char obj[] =
    "# cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5/1 6/1 8/1 7/1\nf 1//1 2//1 6//1 5//1\nf -6 -2 -1 -5\nf 1/1/1 5 7 3\nf 2 4 8 6\n"
    "g x\nl 1 2 3\nusemtl y\n";
static const char stl[] =
    "solid t\nfacet normal 0 0 -1 outer loop vertex 0 0 0 vertex 0 9 0 vertex 9 0 0 endloop "
    "endfacet\n"
    "facet normal 0 -1 0 outer loop vertex 0 0 0 vertex 9 0 0 vertex 0 0 9 endloop endfacet\n"
    "facet normal -1 0 0 outer loop vertex 0 0 0 vertex 0 0 9 vertex 0 9 0 endloop endfacet\n"
    "facet normal 1 1 1 outer loop vertex 9 0 0 vertex 0 9 0 vertex 0 0 9 endloop endfacet\n"
    "endsolid t\n";

static const char off[] =
    "OFF # cube\n8 6 12\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
    "4 0 2 3 1\n4 4 5 7 6 255 0 0\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n3 1 3 7\n";
static const char ply[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n3 0 3 1\n";

/* The same as ply, binary with the little end first. */
static size_t binary_ply_seed(uint8_t *bytes) {
  static const char header[] =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  static const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  static const int face[4] = {0, 1, 2, 3};
  size_t size = sizeof header - 1;
  memcpy(bytes, header, size);
  memcpy(bytes + size, corners, sizeof corners);
  size += sizeof corners;
  bytes[size++] = 4;
  memcpy(bytes + size, face, sizeof face);
  return size + sizeof face;
}

/* A binary STL of the text's four triangles, with small whole coordinates. */
static size_t binary_seed(uint8_t *bytes) {
  static const float corners[4][9] = {{0, 0, 0, 0, 9, 0, 9, 0, 0},
                                      {0, 0, 0, 9, 0, 0, 0, 0, 9},
                                      {0, 0, 0, 0, 0, 9, 0, 9, 0},
                                      {9, 0, 0, 0, 9, 0, 0, 0, 9}};
  memset(bytes, 0, 84 + 200);
  bytes[80] = 4;
  for (int i = 0; i < 4; i++) memcpy(bytes + 84 + 50 * i + 12, corners[i], 36);
  return 84 + 200;
}

static const char likely[] = "0123456789.-/e \nvf";

int main(int argc, char **argv) {
  long rounds = argc > 1 ? atol(argv[1]) : 20000;
  uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
  if (!state) state = 1;
  uint8_t bytes[4096];
  for (long i = 0; i < rounds; i++) {
    size_t size = 0;
    switch (i % 6) {
    case 0:
      memcpy(bytes, obj, size = sizeof obj - 1);
      break;
    case 1:
      memcpy(bytes, stl, size = sizeof stl - 1);
      break;
    case 2:
      memcpy(bytes, off, size = sizeof off - 1);
      break;
    case 3:
      memcpy(bytes, ply, size = sizeof ply - 1);
      break;
    case 4:
      size = binary_ply_seed(bytes);
      break;
    default:
      size = binary_seed(bytes);
    }
    if (i >= 6)
      size =
          fuzz_mutate(&state, likely, bytes, size, sizeof bytes); /* the seeds themselves first */
    LLVMFuzzerTestOneInput(bytes, size);
  }
  printf("%ld files\n", rounds);
  return 0;
}
#endif
