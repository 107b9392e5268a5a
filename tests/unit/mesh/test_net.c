/* Connectivity: counts known by hand, and properties that hold on every net. */
#include "net_fixture.h"
#include <stdlib.h>

static int valence(const lam_net *net, int v) {
  return net->ring_start[v + 1] - net->ring_start[v];
}

static const lam_edge *edge_between(const lam_net *net, int a, int b) {
  for (int e = 0; e < net->edge_count; e++) {
    const int *v = net->edges[e].vertex;
    if ((v[0] == a && v[1] == b) || (v[0] == b && v[1] == a)) return &net->edges[e];
  }
  fail_msg("vertices %d and %d are no edge", a, b);
  return NULL;
}

/* Whether the face runs from a to b. */
static bool face_runs(const lam_net *net, int face, int a, int b) {
  for (int k = 0; face >= 0 && k < 4; k++)
    if (net->mesh.faces[face][k] == a && net->mesh.faces[face][(k + 1) & 3] == b) return true;
  return false;
}

static void check_edges(const lam_net *net) {
  for (int e = 0; e < net->edge_count; e++) {
    const lam_edge *edge = &net->edges[e];
    assert_true(face_runs(net, edge->face[0], edge->vertex[0], edge->vertex[1]));
    assert_true(edge->face[1] < 0 ||
                face_runs(net, edge->face[1], edge->vertex[1], edge->vertex[0]));
    assert_true(edge->family == 0 || edge->family == 1);
    if (edge->face[1] < 0)
      assert_true(net->boundary[edge->vertex[0]] && net->boundary[edge->vertex[1]]);
  }
}

/* Neighbors a, b that follow each other around v belong to one face, which runs v -> a and b -> v.
 */
static void check_rings(const lam_net *net) {
  int sum = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    const int *ring = net->ring + net->ring_start[v];
    int n = valence(net, v);
    sum += n;
    for (int k = 0; k < n - net->boundary[v]; k++) {
      const lam_edge *edge = edge_between(net, v, ring[k]);
      int face = face_runs(net, edge->face[0], v, ring[k]) ? edge->face[0] : edge->face[1];
      assert_true(face_runs(net, face, v, ring[k]) && face_runs(net, face, ring[(k + 1) % n], v));
    }
    if (net->boundary[v]) {
      assert_int_equal(edge_between(net, v, ring[0])->face[1], -1);
      assert_int_equal(edge_between(net, v, ring[n - 1])->face[1], -1);
    }
  }
  assert_int_equal(sum, 2 * net->edge_count);
}

/* Every edge lies on exactly one polyline, of its family where families do not conflict. */
static void check_polylines(const lam_net *net) {
  int *seen = calloc((size_t)net->edge_count, sizeof *seen);
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (l) assert_true(line->family >= line[-1].family);
    for (int i = 0; i + 1 < line->count + line->closed; i++) {
      const lam_edge *edge =
          edge_between(net, line->vertices[i], line->vertices[(i + 1) % line->count]);
      seen[edge - net->edges]++;
      if (!net->family_conflicts) assert_int_equal(edge->family, line->family);
    }
  }
  for (int e = 0; e < net->edge_count; e++) assert_int_equal(seen[e], 1);
  free(seen);
}

/* Stars are regular, counterclockwise, +-u of family 0, +-v of family 1, and opposite neighbors
 * follow each other on a line. */
static void check_stars(const lam_net *net) {
  int regular = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++)
    regular += !net->boundary[v] && valence(net, v) == 4;
  assert_int_equal(net->star_count, regular);
  for (int s = 0; s < net->star_count; s++) {
    const lam_star *star = &net->stars[s];
    const int *ring = net->ring + net->ring_start[star->center];
    assert_int_equal(net->star_of_vertex[star->center], s);
    if (s) assert_true(star->center > star[-1].center);
    int turn = 0;
    while (turn < 3 && ring[turn] != star->neighbor[0]) turn++;
    for (int k = 0; k < 4; k++) {
      assert_int_equal(star->neighbor[k], ring[(turn + k) & 3]);
      if (!net->family_conflicts)
        assert_int_equal(edge_between(net, star->center, star->neighbor[k])->family, k & 1);
    }
  }
}

/* Every boundary edge lies on one loop, with its face on the left. */
static void check_loops(const lam_net *net) {
  int steps = 0, edges = 0;
  for (int l = 0; l < net->loop_count; l++) {
    const lam_polyline *loop = &net->loops[l];
    steps += loop->count;
    assert_int_equal(loop->family, -1);
    for (int i = 0; i < loop->count; i++) {
      const lam_edge *edge =
          edge_between(net, loop->vertices[i], loop->vertices[(i + 1) % loop->count]);
      assert_int_equal(edge->vertex[0], loop->vertices[i]);
      assert_int_equal(edge->face[1], -1);
    }
  }
  for (int e = 0; e < net->edge_count; e++) edges += net->edges[e].face[1] < 0;
  assert_int_equal(steps, edges);
}

typedef struct counts {
  int vertices, edges, faces, stars, lines, closed_lines, loops, irregular, euler;
  bool conflicts;
} counts;

static void check_net(net_fixture *f, const char *name, const lam_mesh *mesh, counts c) {
  lam_net net = net_built(f, mesh);
  int closed = 0;
  for (int l = 0; l < net.polyline_count; l++) closed += net.polylines[l].closed;
  counts found = {net.mesh.vertex_count,
                  net.edge_count,
                  net.mesh.face_count,
                  net.star_count,
                  net.polyline_count,
                  closed,
                  net.loop_count,
                  net.irregular_count,
                  net.mesh.vertex_count - net.edge_count + net.mesh.face_count,
                  net.family_conflicts > 0};
  const int *a = &found.vertices, *b = &c.vertices;
  for (int i = 0; i < 9; i++)
    if (a[i] != b[i]) fail_msg("%s: count %d is %d, expected %d", name, i, a[i], b[i]);
  assert_int_equal(found.conflicts, c.conflicts);
  check_edges(&net);
  check_rings(&net);
  check_polylines(&net);
  check_stars(&net);
  check_loops(&net);
}

/* n x m vertices: open, n(m-1) + m(n-1) edges, n + m lines; closed along u, n m + n(m-1) edges; a
 * torus, 2 n m edges.
 */
static void grids_have_the_counts_of_grids(void **state) {
  net_fixture *f = *state;
  for (int n = 2; n < 7; n++)
    for (int m = 2; m < 6; m++)
      for (int closed = 0; closed < 4; closed++) {
        bool u = closed & 1, v = closed & 2;
        if ((u && n < 3) || (v && m < 3)) continue;
        lam_mesh mesh = lam_mesh_grid(f->arena, n, m, u, v);
        int rows = u ? n : n - 1, columns = v ? m : m - 1, inner_n = u ? n : n - 2,
            inner_m = v ? m : m - 2;
        counts c = {n * m,
                    rows * m + n * columns,
                    rows * columns,
                    inner_n * inner_m,
                    n + m,
                    u * m + v * n,
                    u && v   ? 0
                    : u || v ? 2
                             : 1,
                    0,
                    u || v ? 0 : 1,
                    false};
        check_net(f, "grid", &mesh, c);
      }
}

/* Star (i, j) of a grid is (i+1, j), (i, j+1), (i-1, j), (i, j-1), around the seam too; line j of
 * family 0 is (0, j), (1, j) ... */
static void grids_keep_u_and_v(void **state) {
  net_fixture *f = *state;
  enum { n = 5, m = 4 };
  for (int closed = 0; closed < 4; closed++) {
    lam_mesh mesh = lam_mesh_grid(f->arena, n, m, closed & 1, closed & 2);
    lam_net net = net_built(f, &mesh);
    for (int s = 0; s < net.star_count; s++) {
      int i = net.stars[s].center / m, j = net.stars[s].center % m;
      int expected[4] = {(i + 1) % n * m + j, i * m + (j + 1) % m, (i + n - 1) % n * m + j,
                         i * m + (j + m - 1) % m};
      for (int k = 0; k < 4; k++) assert_int_equal(net.stars[s].neighbor[k], expected[k]);
    }
    for (int l = 0; l < net.polyline_count; l++) {
      int family = l >= m, start = family ? (l - m) * m : l, step = family ? 1 : m;
      assert_int_equal(net.polylines[l].family, family);
      for (int i = 0; i < net.polylines[l].count; i++)
        assert_int_equal(net.polylines[l].vertices[i], start + i * step);
    }
  }
}

/* The cube: three edges meet everywhere, so each is a line of its own and no two-coloring exists.
 * Its subdivision: 12 lines over the old edges, 3 closed ones across. Monkey saddle of n rings: 6
 * n(n+1) + 1 vertices, 6 n lines around the middle, 6 into it. Without the middle (one ring) the
 * lines run on through the corners of the hole. */
static void irregular_meshes(void **state) {
  net_fixture *f = *state;
  lam_mesh cube = net_cube(f->arena), round = net_round_cube(f), monkey = net_monkey(f, 4, 0),
           oculus = net_monkey(f, 4, 1);
  check_net(f, "cube", &cube, (counts){8, 12, 6, 0, 12, 0, 0, 8, 2, true});
  check_net(f, "round cube", &round, (counts){26, 48, 24, 18, 15, 3, 0, 8, 2, true});
  check_net(f, "monkey saddle", &monkey, (counts){121, 216, 96, 72, 30, 0, 1, 1, 1, false});
  check_net(f, "oculus", &oculus, (counts){120, 210, 90, 60, 30, 0, 2, 0, 0, false});
}

/* Two grids in one mesh: nothing is lost, and the Euler numbers add up. */
static void separate_pieces(void **state) {
  net_fixture *f = *state;
  lam_mesh a = net_grid(f->arena, 3, 3, net_plane),
           both = {18, LAM_NEW(f->arena, lam_vec3, 18), 8, NULL};
  both.faces = (int(*)[4])lam_arena_alloc(f->arena, 8, sizeof *both.faces);
  for (int i = 0; i < 8; i++)
    for (int k = 0; k < 4; k++) both.faces[i][k] = a.faces[i % 4][k] + 9 * (i / 4);
  for (int v = 0; v < 18; v++)
    both.vertices[v] = lam_add(a.vertices[v % 9], lam_v3(v >= 9 ? 5 : 0, 0, 0));
  check_net(f, "two grids", &both, (counts){18, 24, 8, 2, 12, 0, 2, 0, 2, false});
}

/* Every kind of mesh that is no net is refused with a message that says why. Vertices 0 to 7 of a
 * cube, faces as listed. */
static void wrong_meshes_are_refused(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *why;
    int vertices, faces, corners[4][4];
  } rows[] = {
      {"is a triangle", 4, 1, {{0, 1, 2, -1}}},
      {"names vertex 9", 8, 1, {{0, 1, 2, 8}}},
      {"names vertex 0", 8, 1, {{0, -1, 2, 3}}},
      {"names vertex 2 twice", 4, 1, {{0, 1, 1, 3}}},
      {"vertex 5 belongs to no face", 5, 1, {{0, 1, 2, 3}}},
      {"the mesh has no faces", 0, 0, {{0}}},
      {"more than two faces", 8, 3, {{0, 1, 2, 3}, {1, 0, 4, 5}, {0, 1, 6, 7}}},
      {"disagree in orientation", 6, 2, {{0, 1, 2, 3}, {0, 1, 4, 5}}},
      {"touches the boundary more than once", 7, 2, {{0, 1, 2, 3}, {0, 4, 5, 6}}},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_mesh mesh = {rows[i].vertices, LAM_NEW(f->arena, lam_vec3, 8), rows[i].faces, NULL};
    mesh.faces = (int(*)[4])lam_arena_alloc(f->arena, 4, sizeof *mesh.faces);
    memcpy(mesh.faces, rows[i].corners, sizeof rows[i].corners);
    lam_errors errors = {.arena = f->arena};
    lam_net net;
    assert_false(lam_net_build(f->arena, &mesh, (lam_location){"mesh.obj", 3, 0}, &errors, &net));
    assert_int_equal(errors.count, 1);
    assert_int_equal(errors.first->location.line, 3);
    if (!strstr(errors.first->text, rows[i].why))
      fail_msg("\"%s\" does not say \"%s\"", errors.first->text, rows[i].why);
  }
}

/* Two closed cubes that share a vertex: closed everywhere, yet no surface there. */
static void a_pinched_vertex_is_refused(void **state) {
  net_fixture *f = *state;
  lam_mesh cube = net_cube(f->arena), pair = {15, LAM_NEW(f->arena, lam_vec3, 15), 12, NULL};
  pair.faces = (int(*)[4])lam_arena_alloc(f->arena, 12, sizeof *pair.faces);
  for (int i = 0; i < 12; i++)
    for (int k = 0; k < 4; k++)
      pair.faces[i][k] = i < 6 ? cube.faces[i][k] : cube.faces[i - 6][k] + 7;
  lam_net net;
  assert_false(lam_net_build(f->arena, &pair, (lam_location){0}, &f->errors, &net));
  assert_non_null(strstr(f->errors.first->text, "vertex 8 do not form one fan"));
}

/* Plane: (0, 0, 1). Torus of 24 x 24: outwards, within the turn of one cell. A planar star in a
 * tilted plane: its normal to rounding. */
static void normals_point_to_the_side_of_the_faces(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 5, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_vec3 normals[24 * 24];
  lam_net_normals(&net, mesh.vertices, normals);
  for (int v = 0; v < 20; v++) assert_near(lam_distance(normals[v], lam_v3(0, 0, 1)), 0, 0);
  assert_near(lam_net_mean_edge(&net, mesh.vertices), 1, 1e-15);
  mesh = net_torus(f->arena, 24, 24, 3, 1);
  net = net_built(f, &mesh);
  lam_net_normals(&net, mesh.vertices, normals);
  for (int v = 0; v < 24 * 24; v++) {
    double u = 2 * net_pi * (v / 24) / 24;
    lam_vec3 outwards = lam_sub(mesh.vertices[v], lam_v3(3 * cos(u), 3 * sin(u), 0));
    assert_below(lam_angle(normals[v], outwards), .05);
  }
  lam_vec3 n = lam_unit(lam_v3(1, -2, 4)), a = lam_unit(lam_cross(n, lam_v3(0, 0, 1))),
           b = lam_cross(n, a);
  mesh = net_grid(f->arena, 3, 3, net_plane);
  net = net_built(f, &mesh);
  for (int v = 0; v < 9; v++)
    mesh.vertices[v] = lam_add(lam_scale(a, mesh.vertices[v].x + .2 * net_random(f)),
                               lam_scale(b, mesh.vertices[v].y + .2 * net_random(f)));
  mesh.vertices[0] = lam_v3(5, 5, 5); /* a corner: not in the star */
  lam_net_normals(&net, mesh.vertices, normals);
  assert_near(lam_distance(normals[4], n), 0, 1e-15);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(grids_have_the_counts_of_grids),
      NET_TEST(grids_keep_u_and_v),
      NET_TEST(irregular_meshes),
      NET_TEST(separate_pieces),
      NET_TEST(wrong_meshes_are_refused),
      NET_TEST(a_pinched_vertex_is_refused),
      NET_TEST(normals_point_to_the_side_of_the_faces),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
