/* Coarser nets and nets of diagonals, on every topology. */
#include "mesh/coarsen.h"
#include "mesh/diagonalize.h"
#include "net_fixture.h"

static lam_coarse coarsened(net_fixture *f, const lam_net *net) {
  lam_coarse coarse = {0};
  const char *why = lam_net_coarsen(f->arena, net, &coarse);
  if (why) fail_msg("not coarsened: %s", why);
  return coarse;
}

/* The mean of a fine vertex' parents. */
static lam_vec3 mean(const lam_coarse *coarse, int v) {
  lam_vec3 sum = {0, 0, 0};
  for (int k = 0; k < 4; k++)
    sum = lam_along(sum, .25, coarse->mesh.vertices[coarse->parents[v][k]]);
  return sum;
}

/* n x m cells become the grid of the lines 0, 2, 4 ... and the last one, in the same order and with
 * the same families. In the plane every vertex is the mean of its parents. */
static void grids_keep_every_other_line(void **state) {
  net_fixture *f = *state;
  for (int n = 1; n < 8; n++)
    for (int m = 1; m < 8; m++) {
      if (n * m == 1) continue;
      lam_mesh mesh = net_grid(f->arena, n + 1, m + 1, net_plane);
      lam_net net = net_built(f, &mesh);
      lam_coarse coarse = coarsened(f, &net);
      int rows = (n + 1) / 2 + 1, columns = (m + 1) / 2 + 1;
      assert_int_equal(coarse.mesh.vertex_count, rows * columns);
      lam_mesh plain = lam_mesh_grid(f->arena, rows, columns, false, false);
      assert_int_equal(coarse.mesh.face_count, plain.face_count);
      assert_memory_equal(coarse.mesh.faces, plain.faces,
                          sizeof *plain.faces * (size_t)plain.face_count);
      for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
          lam_vec3 x = lam_v3(i + 1 < rows ? 2 * i : n, j + 1 < columns ? 2 * j : m, 0);
          assert_near(lam_distance(coarse.mesh.vertices[i * columns + j], x), 0, 0);
          assert_near(lam_distance(mesh.vertices[coarse.kept[i * columns + j]], x), 0, 0);
        }
      for (int v = 0; v < mesh.vertex_count; v++)
        assert_near(lam_distance(mean(&coarse, v), mesh.vertices[v]), 0, 1e-15);
    }
}

static bool same_cycle(const int *a, const int *b) {
  for (int turn = 0; turn < 4; turn++) {
    int k = 0;
    while (k < 4 && a[k] == b[(turn + k) & 3]) k++;
    if (k == 4) return true;
  }
  return false;
}

/* Subdividing and coarsening gives the same net back: open, closed, with irregular vertices of
 * valence 3 and 6, with a hole. Vertices from edges and faces are the means of the ends and corners
 * that they came from. */
static void coarsening_reverses_subdivision(void **state) {
  net_fixture *f = *state;
  lam_mesh meshes[] = {net_torus(f->arena, 5, 7, 3, 1),
                       net_tube(f->arena, 5, 3),
                       net_round_cube(f),
                       net_monkey(f, 3, 0),
                       net_monkey(f, 3, 1),
                       net_cube(f->arena),
                       net_monkey(f, 1, 0),
                       net_torus(f->arena, 4, 3, 3, 1)};
  for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
    lam_net net = net_built(f, &meshes[i]);
    lam_mesh fine = lam_net_catmull_clark(f->arena, &net);
    memcpy(fine.vertices, net.mesh.vertices, sizeof(lam_vec3) * (size_t)net.mesh.vertex_count);
    lam_net refined = net_built(f, &fine);
    lam_coarse coarse = coarsened(f, &refined);
    int nv = net.mesh.vertex_count;
    assert_int_equal(coarse.mesh.vertex_count, nv);
    assert_int_equal(coarse.mesh.face_count, net.mesh.face_count);
    assert_memory_equal(coarse.mesh.vertices, net.mesh.vertices, sizeof(lam_vec3) * (size_t)nv);
    for (int face = 0; face < net.mesh.face_count; face++)
      assert_true(same_cycle(coarse.mesh.faces[face], net.mesh.faces[face]));
    for (int e = 0; e < net.edge_count; e++) {
      const int *ends = net.edges[e].vertex, *p = coarse.parents[nv + e];
      assert_true((p[0] == ends[0] && p[1] == ends[1]) || (p[0] == ends[1] && p[1] == ends[0]));
      assert_true(p[2] == p[0] && p[3] == p[1]);
    }
    for (int face = 0; face < net.mesh.face_count; face++)
      assert_true(same_cycle(coarse.parents[nv + net.edge_count + face], net.mesh.faces[face]));
    for (int v = 0; v < nv; v++)
      for (int k = 0; k < 4; k++) assert_int_equal(coarse.parents[v][k], v);
    lam_net again = net_built(f, &coarse.mesh);
    assert_int_equal(again.irregular_count, net.irregular_count);
    for (int e = 0; e < again.edge_count && !net.family_conflicts; e++)
      for (int d = 0; d < net.edge_count; d++)
        if ((again.edges[e].vertex[0] == net.edges[d].vertex[0] &&
             again.edges[e].vertex[1] == net.edges[d].vertex[1]) ||
            (again.edges[e].vertex[0] == net.edges[d].vertex[1] &&
             again.edges[e].vertex[1] == net.edges[d].vertex[0]))
          assert_int_equal(again.edges[e].family, net.edges[d].family);
  }
}

/* An odd ring has no every other line; a monkey saddle of odd reach keeps its rim; two pieces are
 * coarsened each by itself. */
static void what_does_not_pair_up(void **state) {
  net_fixture *f = *state;
  lam_coarse coarse;
  lam_mesh odd = net_tube(f->arena, 7, 4), small = net_tube(f->arena, 4, 4),
           one = net_grid(f->arena, 2, 2, net_plane), cube = net_cube(f->arena);
  lam_net net = net_built(f, &odd);
  assert_non_null(strstr(lam_net_coarsen(f->arena, &net, &coarse), "odd number"));
  net = net_built(f, &small);
  assert_non_null(strstr(lam_net_coarsen(f->arena, &net, &coarse), "fewer than 6"));
  net = net_built(f, &one);
  assert_non_null(strstr(lam_net_coarsen(f->arena, &net, &coarse), "single face"));
  net = net_built(f, &cube);
  assert_non_null(strstr(lam_net_coarsen(f->arena, &net, &coarse), "odd number"));
  lam_mesh monkey = net_monkey(f, 5, 0);
  net = net_built(f, &monkey);
  coarse = coarsened(f, &net);
  lam_net again = net_built(f, &coarse.mesh);
  assert_int_equal(again.irregular_count, 1);
  assert_int_equal(coarse.mesh.vertex_count, 1 + 6 * 3 * 4); /* lines 0, 2, 4, 5 */
  lam_mesh a = net_grid(f->arena, 3, 3, net_plane),
           both = {18, LAM_NEW(f->arena, lam_vec3, 18), 8, NULL};
  both.faces = (int(*)[4])lam_arena_alloc(f->arena, 8, sizeof *both.faces);
  for (int i = 0; i < 8; i++)
    for (int k = 0; k < 4; k++) both.faces[i][k] = a.faces[i % 4][k] + 9 * (i / 4);
  for (int v = 0; v < 18; v++)
    both.vertices[v] = lam_add(a.vertices[v % 9], lam_v3(v >= 9 ? 5 : 0, 0, 0));
  net = net_built(f, &both);
  coarse = coarsened(f, &net);
  assert_int_equal(coarse.mesh.vertex_count, 8);
  assert_int_equal(coarse.mesh.face_count, 2);
}

/* 4 x 6 cells: a face around every inner vertex with i + j odd (7 of 15); edges are diagonals, of
 * length sqrt 2. A torus of n x m vertices: half of them stay, and as many faces. The monkey saddle
 * keeps its vertex of valence 6. Twice diagonalized is coarsened, on a torus. */
static void diagonals(void **state) {
  net_fixture *f = *state;
  lam_mesh meshes[] = {net_grid(f->arena, 5, 7, net_plane), net_torus(f->arena, 8, 12, 3, 1),
                       net_monkey(f, 4, 0)},
           out;
  static const int faces[] = {7, 48, -1}, irregular[] = {0, 0, 1};
  for (int i = 0; i < 3; i++) {
    lam_net net = net_built(f, &meshes[i]);
    assert_null(lam_net_diagonalize(f->arena, &net, &out));
    lam_net again = net_built(f, &out);
    if (faces[i] >= 0) assert_int_equal(out.face_count, faces[i]);
    assert_int_equal(again.irregular_count, irregular[i]);
    assert_int_equal(again.mesh.vertex_count - again.edge_count + again.mesh.face_count,
                     i == 1 ? 0 : 1);
    if (i == 0)
      for (int e = 0; e < again.edge_count; e++)
        assert_near(lam_distance(out.vertices[again.edges[e].vertex[0]],
                                 out.vertices[again.edges[e].vertex[1]]),
                    sqrt(2), 1e-15);
    if (i != 1) continue;
    assert_null(lam_net_diagonalize(f->arena, &again, &out));
    lam_coarse coarse = coarsened(f, &net);
    assert_int_equal(out.vertex_count, coarse.mesh.vertex_count);
    assert_memory_equal(out.vertices, coarse.mesh.vertices,
                        sizeof(lam_vec3) * (size_t)out.vertex_count);
  }
  lam_mesh odd = net_tube(f->arena, 7, 4), cube = net_cube(f->arena),
           strip = net_grid(f->arena, 2, 5, net_plane);
  lam_net net = net_built(f, &odd);
  assert_non_null(strstr(lam_net_diagonalize(f->arena, &net, &out), "odd number of edges"));
  net = net_built(f, &cube);
  assert_non_null(strstr(lam_net_diagonalize(f->arena, &net, &out), "odd number of edges apart"));
  net = net_built(f, &strip);
  assert_non_null(strstr(lam_net_diagonalize(f->arena, &net, &out), "no inner vertex"));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(grids_keep_every_other_line),
      NET_TEST(coarsening_reverses_subdivision),
      NET_TEST(what_does_not_pair_up),
      NET_TEST(diagonals),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
