/* Tidying of meshes that other programs have written. Counts follow from how meshes are made. */
#include "mesh/net.h"
#include "mesh/tidy.h"
#include "tests/unit/text_fixture.h"

/* A plane grid of 4 x 4 faces with 25 vertices, 1 m apart; vertex (i, j) at 5 i + j. */
static lam_mesh grid(lam_arena *arena) {
  lam_mesh mesh = lam_mesh_grid(arena, 5, 5, false, false);
  for (int v = 0; v < 25; v++) mesh.vertices[v] = lam_v3(v / 5, v % 5, 0);
  return mesh;
}

/* The grid in two pieces, the row i = 2 standing in both, `gap` apart: 30 vertices. */
static lam_mesh seam(lam_arena *arena, double gap) {
  lam_mesh mesh = grid(arena), two = mesh;
  two.vertex_count = 30;
  two.vertices = LAM_NEW(arena, lam_vec3, 30);
  memcpy(two.vertices, mesh.vertices, 25 * sizeof *two.vertices);
  for (int j = 0; j < 5; j++) two.vertices[25 + j] = lam_v3(2 + gap, j, 0);
  for (int f = 8; f < 16; f++) /* the faces of rows 2 and 3 */
    for (int k = 0; k < 4; k++)
      if (two.faces[f][k] / 5 == 2) two.faces[f][k] += 15;
  return two;
}

static lam_tidied tidied(lam_arena *arena, lam_mesh *mesh, double tolerance) {
  lam_tidied found;
  int face;
  assert_true(lam_mesh_tidy(arena, mesh, tolerance, &found, &face));
  return found;
}

/* Whether the mesh becomes a net. */
static bool is_net(lam_arena *arena, const lam_mesh *mesh) {
  lam_errors errors = {.arena = arena};
  lam_net net;
  return lam_net_build(arena, mesh, (lam_location){0}, &errors, &net);
}

static void a_mesh_in_order_stays(void **state) {
  lam_mesh mesh = grid(*state), before = mesh;
  lam_tidied found = tidied(*state, &mesh, -1);
  assert_memory_equal(&found, (&(lam_tidied){.pieces = 1}), sizeof found);
  assert_true(mesh.vertices == before.vertices && mesh.faces == before.faces);
}

/* Five vertices lie in two places; welding leaves the 25 of the grid. */
static void seams_are_counted_and_welded(void **state) {
  lam_mesh mesh = seam(*state, 0);
  lam_tidied found = tidied(*state, &mesh, -1);
  assert_int_equal(found.doubled, 5);
  assert_int_equal(found.pieces, 2);
  assert_int_equal(mesh.vertex_count, 30);
  found = tidied(*state, &mesh, 0);
  assert_int_equal(found.welded, 5);
  assert_int_equal(found.unused, 0);
  assert_int_equal(found.doubled, 0);
  assert_int_equal(found.pieces, 1);
  assert_int_equal(mesh.vertex_count, 25);
  assert_memory_equal(mesh.faces, grid(*state).faces, 16 * sizeof *mesh.faces);
}

/* A seam of 1 cm is joined within 2 cm, and not within 5 mm; whether the grid that vertices are
 * looked up in has a border there does not matter. */
static void welding_keeps_to_its_tolerance(void **state) {
  for (int i = 0; i < 50; i++) {
    lam_mesh mesh = seam(*state, .01), far = mesh;
    for (int v = 0; v < 30; v++) mesh.vertices[v].x += .0013 * i;
    assert_int_equal(tidied(*state, &mesh, .02).welded, 5);
    assert_int_equal(tidied(*state, &far, .005).welded, 0);
  }
}

static void welding_does_not_collapse_faces(void **state) {
  lam_mesh mesh = grid(*state);
  lam_tidied found;
  int face = -1;
  assert_false(lam_mesh_tidy(*state, &mesh, 1.1, &found, &face));
  assert_int_equal(face, 0);
  assert_int_equal(mesh.vertex_count, 25);
}

/* Vertices in no face before, between and behind those of faces. */
static void unused_vertices_are_left_out(void **state) {
  lam_mesh mesh = grid(*state), more = mesh;
  more.vertex_count = 28;
  more.vertices = LAM_NEW(*state, lam_vec3, 28);
  for (int v = 0, to = 1; v < 25; v++, to += 1 + (v == 7)) {
    more.vertices[to] = mesh.vertices[v];
    for (int f = 0; f < 16; f++)
      for (int k = 0; k < 4; k++)
        if (grid(*state).faces[f][k] == v) more.faces[f][k] = to;
  }
  assert_int_equal(tidied(*state, &more, -1).unused, 3);
  assert_int_equal(more.vertex_count, 25);
  assert_memory_equal(more.vertices, grid(*state).vertices, 25 * sizeof *more.vertices);
  assert_true(is_net(*state, &more));
}

static void reverse(int *face) {
  int kept = face[1];
  face[1] = face[3];
  face[3] = kept;
}

/* Whichever part is smaller is turned. */
static void faces_are_turned(void **state) {
  for (int turned = 1; turned < 16; turned++) {
    lam_mesh mesh = grid(*state);
    for (int f = 0; f < turned; f++) reverse(mesh.faces[7 * f % 16]);
    lam_tidied found = tidied(*state, &mesh, -1);
    assert_int_equal(found.turned, turned <= 8 ? turned : 16 - turned);
    assert_true(is_net(*state, &mesh));
  }
}

/* A Moebius strip of 12 faces stays as it is, and so do faces that stand twice, for the net to
 * refuse. */
static void what_cannot_be_mended_is_left(void **state) {
  lam_mesh strip = lam_mesh_grid(*state, 12, 2, true, false);
  strip.faces[11][1] = 1, strip.faces[11][2] = 0; /* from vertices 22, 23 to 1, 0 */
  for (int v = 0; v < 24; v++) strip.vertices[v] = lam_v3(cos(v / 2), sin(v / 2), v % 2);
  tidied(*state, &strip, -1);
  assert_false(is_net(*state, &strip));

  lam_mesh alone = {4, grid(*state).vertices, 2, (int[2][4]){{0, 5, 6, 1}, {0, 5, 6, 1}}};
  lam_mesh twice = {7, grid(*state).vertices, 2, alone.faces};
  assert_int_equal(tidied(*state, &twice, -1).turned, 0);
  assert_false(is_net(*state, &twice));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(a_mesh_in_order_stays),          TEXT_TEST(seams_are_counted_and_welded),
      TEXT_TEST(welding_keeps_to_its_tolerance), TEXT_TEST(welding_does_not_collapse_faces),
      TEXT_TEST(unused_vertices_are_left_out),   TEXT_TEST(faces_are_turned),
      TEXT_TEST(what_cannot_be_mended_is_left),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
