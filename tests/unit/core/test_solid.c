/* Exact questions about meshes: measures, self-intersections, closest points, overlaps, distances.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/solid/prism.h"
#include "core/solid/solid.h"
#include "mesh_fixture.h"
#include <stdlib.h>
#include <time.h>

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

static lam_solid_facts measured(const lam_trimesh *mesh) {
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(mesh, true, &facts), LAM_OK);
  return facts;
}

static double overlap_of(const lam_trimesh *a, const lam_trimesh *b, const lam_pose *frame_b) {
  lam_solid_set *set = lam_solid_set_new();
  double volume = -1, reversed = -1;
  assert_int_equal(lam_solid_set_add(set, a, NULL), 0);
  assert_int_equal(lam_solid_set_add(set, b, frame_b), 1);
  assert_int_equal(lam_solid_set_overlap(set, 0, 1, &volume), LAM_OK);
  assert_int_equal(lam_solid_set_overlap(set, 1, 0, &reversed), LAM_OK);
  assert_near(volume, reversed, 1e-12);
  lam_solid_set_free(set);
  return volume;
}

/* ---- measures ---- */

/* A box of sides a, b, c: volume abc, inertia V (b^2 + c^2) / 12, products 0. */
static void a_box_is_measured(void **state) {
  lam_trimesh box = mesh_box(*state, lam_v3(1, 2, 3), lam_v3(3, 5, 7));
  lam_solid_facts f = measured(&box);
  assert_true(f.closed && f.oriented && f.manifold);
  assert_int_equal(f.components, 1);
  assert_int_equal(f.euler, 2);
  assert_int_equal(f.genus, 0);
  assert_int_equal(f.self_intersections, 0);
  assert_near(f.volume, 24, 1e-12);
  assert_near(f.area, 2 * (2 * 3 + 3 * 4 + 4 * 2), 1e-12);
  assert_near(lam_distance(f.centroid, lam_v3(2, 3.5, 5)), 0, 1e-12);
  const double expected[6] = {
      24 * (9 + 16) / 12., 24 * (4 + 16) / 12., 24 * (4 + 9) / 12., 0, 0, 0};
  for (int i = 0; i < 6; i++) assert_near(f.inertia[i], expected[i], 1e-11);
  assert_near(lam_distance(f.min, lam_v3(1, 2, 3)), 0, 0);
  assert_near(lam_distance(f.max, lam_v3(3, 5, 7)), 0, 0);
}

/* The same box turned by 30 degrees about z: I_xy of the turned tensor is (Ixx - Iyy) sin cos. */
static void products_of_inertia_are_entries_of_the_tensor(void **state) {
  lam_trimesh box = mesh_box(*state, lam_v3(0, 0, 0), lam_v3(2, 3, 4));
  double c = cos(mesh_pi / 6), s = sin(mesh_pi / 6);
  lam_pose frame = {{5, 6, 7}, {{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  lam_trimesh turned = lam_trimesh_placed(*state, &box, &frame);
  lam_solid_facts f = measured(&turned);
  assert_near(f.inertia[3], (50 - 40) * s * c, 1e-10);
  assert_near(f.inertia[0], 50 * c * c + 40 * s * s, 1e-10);
}

/* Volume of a polygonal torus of revolution: the m-gon's area times the n-gon's perimeter of the
 * swept centroid gives V = (m/2) r^2 sin(2 pi/m) * n R sin(2 pi/n); Euler number 0. */
static void a_torus_has_genus_one(void **state) {
  lam_trimesh torus = mesh_torus(*state, 3, 1, 64, 48);
  lam_solid_facts f = measured(&torus);
  assert_true(f.closed && f.oriented && f.manifold);
  assert_int_equal(f.euler, 0);
  assert_int_equal(f.genus, 1);
  assert_int_equal(f.self_intersections, 0);
  assert_near(f.volume, 24 * sin(2 * mesh_pi / 48) * 64 * 3 * sin(2 * mesh_pi / 64), 1e-9);
}

static void open_inverted_and_inconsistent_meshes_are_told(void **state) {
  lam_trimesh cube = mesh_cube(*state, 0, 0, 0, 1), inverted = mesh_inverted(*state, &cube);
  lam_solid_facts f = measured(&inverted);
  assert_true(f.closed && !f.oriented);
  assert_near(f.volume, -1, 1e-14);
  int swap = cube.triangles[3][0];
  cube.triangles[3][0] = cube.triangles[3][1];
  cube.triangles[3][1] = swap;
  assert_true(measured(&cube).closed && !measured(&cube).oriented);
  cube.triangles[3][1] = cube.triangles[3][0];
  cube.triangles[3][0] = swap;
  cube.triangle_count = 11; /* one triangle is missing: a triangular hole */
  f = measured(&cube);
  assert_true(!f.closed && f.oriented);
  assert_int_equal(f.boundary_edges, 3);
  assert_int_equal(f.genus, -1);
  assert_near(f.volume, 0, 0);
}

/* A cube of side 3 with a hollow of side 1: the inner surface is inverted, and that is right. */
static void a_cavity_is_oriented(void **state) {
  lam_trimesh outer = mesh_cube(*state, 0, 0, 0, 3), inner = mesh_cube(*state, 1, 1, 1, 1);
  inner = mesh_inverted(*state, &inner);
  lam_trimesh shell = mesh_pair(*state, &outer, &inner);
  lam_solid_facts f = measured(&shell);
  assert_true(f.closed && f.oriented);
  assert_int_equal(f.components, 2);
  assert_near(f.volume, 26, 1e-12);
  inner = mesh_cube(*state, 4, 4, 4, 1);
  inner = mesh_inverted(*state, &inner);
  shell = mesh_pair(*state, &outer, &inner); /* an inverted cube outside is wrong */
  assert_false(measured(&shell).oriented);
}

/* Two cubes that share a corner, an edge, a face. */
static void touching_cubes_stay_two_components(void **state) {
  lam_trimesh cube = mesh_cube(*state, 0, 0, 0, 1);
  const lam_vec3 at[3] = {{1, 1, 1}, {1, 1, 0}, {1, 0, 0}};
  const int nonmanifold_edges[3] = {0, 1, 5}; /* a face has four edges and a diagonal */
  for (int i = 0; i < 3; i++) {
    lam_trimesh other = mesh_cube(*state, at[i].x, at[i].y, at[i].z, 1);
    lam_trimesh both = mesh_pair(*state, &cube, &other);
    lam_solid_facts f = measured(&both);
    assert_int_equal(f.components, 2);
    assert_int_equal(f.nonmanifold_edges, nonmanifold_edges[i]);
    assert_false(f.manifold);
    assert_int_equal(f.closed, nonmanifold_edges[i] == 0);
    assert_true(f.oriented);
    assert_near(f.volume, 2, 1e-12);
  }
}

/* Cubes 0..2 and 1..3: three faces of each are cut, in six pairs of faces. Testing all pairs of
 * triangles with rational arithmetic (every edge of one against the other) gives 18. */
static void self_intersections_are_found(void **state) {
  lam_trimesh a = mesh_cube(*state, 0, 0, 0, 2), b = mesh_cube(*state, 1, 1, 1, 2);
  lam_trimesh both = mesh_pair(*state, &a, &b);
  lam_solid_facts f = measured(&both);
  assert_true(f.closed && f.oriented);
  assert_int_equal(f.components, 2);
  assert_int_equal(f.self_intersections, 18);
  a.vertices[7] = lam_v3(0.5, 0.5, -1); /* a corner is pushed through the opposite face */
  assert_true(measured(&a).self_intersections > 0);
}

/* Two triangles over a common edge, folded flat onto each other. */
static void a_flat_fold_intersects_itself(void **state) {
  (void)state;
  lam_vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, 0}};
  int t[2][3] = {{0, 1, 2}, {1, 0, 3}};
  lam_trimesh mesh = {4, p, 2, t};
  assert_int_equal(measured(&mesh).self_intersections, 1);
  p[3].y = -0.5; /* unfolded */
  assert_int_equal(measured(&mesh).self_intersections, 0);
}

static void wrong_meshes_are_refused(void **state) {
  lam_trimesh cube = mesh_cube(*state, 0, 0, 0, 1);
  lam_solid_facts f;
  cube.triangles[5][1] = 8;
  assert_int_equal(lam_solid_measure(&cube, true, &f), LAM_BAD_INPUT);
  assert_null(lam_tree_new(&cube, NULL));
  cube.triangles[5][1] = 5;
  cube.vertices[3].x = NAN;
  assert_int_equal(lam_solid_measure(&cube, true, &f), LAM_BAD_INPUT);
  assert_null(lam_tree_new(&cube, NULL));
  cube = mesh_cube(*state, 0, 0, 0, 1);
  cube.triangle_count = 11;
  lam_solid_set *set = lam_solid_set_new();
  assert_int_equal(lam_solid_set_add(set, &cube, NULL), -1); /* open */
  cube.triangle_count = 12;
  cube = mesh_inverted(*state, &cube);
  assert_int_equal(lam_solid_set_add(set, &cube, NULL), -1); /* inside out */
  lam_solid_set_free(set);
}

/* ---- closest points ---- */

/* Feet of points on a unit cube: on a face, on an edge, on a corner, from inside. */
static void closest_points_on_a_cube(void **state) {
  lam_trimesh cube = mesh_cube(*state, 0, 0, 0, 1);
  lam_tree *tree = lam_tree_new(&cube, NULL);
  const lam_vec3 queries[4] = {{0.25, 0.5, 3}, {2, 2, 0.3}, {-1, -1, -1}, {0.5, 0.4, 0.1}};
  const lam_vec3 feet[4] = {{0.25, 0.5, 1}, {1, 1, 0.3}, {0, 0, 0}, {0.5, 0.4, 0}};
  for (int i = 0; i < 4; i++) {
    lam_vec3 foot;
    int triangle;
    lam_tree_closest(tree, queries[i], &foot, &triangle);
    assert_near(lam_distance(foot, feet[i]), 0, 1e-15);
    assert_in_range(triangle, 0, 11);
    const int *t = cube.triangles[triangle]; /* the foot lies in the plane of that triangle */
    lam_vec3 n = lam_cross(lam_sub(cube.vertices[t[1]], cube.vertices[t[0]]),
                           lam_sub(cube.vertices[t[2]], cube.vertices[t[0]]));
    assert_near(lam_dot(n, lam_sub(foot, cube.vertices[t[0]])), 0, 1e-15);
  }
  lam_tree_free(tree);
}

/* ---- overlaps ---- */

static void overlaps_of_two_cubes(void **state) {
  static const struct {
    double x, y, z, side, volume;
  } cases[] = {
      {1, 1, 1, 2, 1}, /* corners overlap in a unit cube */
      {0.5, 0.25, 0.125, 2, 1.5 * 1.75 * 1.875},
      {2, 0, 0, 2, 0},          /* a common face */
      {2, 0.5, 0.5, 1, 0},      /* a face within a face */
      {2, 2, 0, 2, 0},          /* a common edge */
      {2, 2, 2, 2, 0},          /* a common corner */
      {3, 0, 0, 1, 0},          /* apart */
      {0.5, 0.5, 0.5, 1, 1},    /* inside */
      {0, 0, 0, 2, 8},          /* the same */
      {0, 0, 0, 1, 1},          /* inside, three faces in common */
      {0.5, 0.5, -1, 1, 0},     /* stands below, touching */
      {0.5, 0.5, -0.5, 1, 0.5}, /* sticks in */
      {-1, -1, -1, 5, 8},       /* around */
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_trimesh a = mesh_cube(*state, 0, 0, 0, 2);
    lam_trimesh b = mesh_cube(*state, cases[i].x, cases[i].y, cases[i].z, cases[i].side);
    double volume = overlap_of(&a, &b, NULL);
    if (fabs(volume - cases[i].volume) > (cases[i].volume > 0 ? 1e-14 : 0))
      fail_msg("case %zu: %.17g", i, volume);
    assert_int_equal(lam_prism_volume(&a, &b, &volume), LAM_OK);
    if (fabs(volume - cases[i].volume) > 1e-14)
      fail_msg("case %zu by integration: %.17g", i, volume);
  }
}

/* A unit cube turned by 45 degrees about z and a square bar of the same height: the octagon common
 * to both squares has the area 2 sqrt(2) - 2 (a regular octagon of inradius 1/2). */
static void overlap_of_turned_cubes(void **state) {
  lam_trimesh cube = mesh_cube(*state, -0.5, -0.5, -0.5, 1);
  double c = sqrt(0.5);
  lam_pose turned = {{0, 0, 0}, {{c, c, 0}, {-c, c, 0}, {0, 0, 1}}};
  assert_near(overlap_of(&cube, &cube, &turned), 2 * sqrt(2) - 2, 1e-14);
  lam_pose mirrored = {{0.5, 0, 0}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  assert_near(overlap_of(&cube, &cube, &mirrored), 0.5, 1e-14);
}

/* A hollow cube and a bar through its wall: only the wall counts. A bar inside the hollow: nothing.
 */
static void cavities_are_empty(void **state) {
  lam_trimesh outer = mesh_cube(*state, 0, 0, 0, 3), inner = mesh_cube(*state, 1, 1, 1, 1);
  inner = mesh_inverted(*state, &inner);
  lam_trimesh shell = mesh_pair(*state, &outer, &inner);
  lam_trimesh bar = mesh_box(*state, lam_v3(-1, 1.25, 1.25), lam_v3(4, 1.75, 1.75));
  assert_near(overlap_of(&shell, &bar, NULL), 2 * 0.25, 1e-14);
  lam_trimesh small = mesh_cube(*state, 1.25, 1.25, 1.25, 0.5);
  assert_near(overlap_of(&shell, &small, NULL), 0, 0);
}

/* Two unit cubes with a common edge dip 0.25 into a plate: 2 x 0.25. The common volume is not a
 * manifold there. */
static void an_intersection_that_is_no_manifold(void **state) {
  lam_trimesh low = mesh_cube(*state, 0, 0, 0, 1), high = mesh_cube(*state, 1, 1, 0, 1);
  lam_trimesh steps = mesh_pair(*state, &low, &high); /* two cubes with a common edge */
  lam_trimesh plate = mesh_box(*state, lam_v3(-1, -1, -1), lam_v3(3, 3, 0.25));
  assert_near(overlap_of(&steps, &plate, NULL), 0.5, 1e-14);
  /* One connected solid whose part below z = 1 is two cubes with a common edge: a cap joins them
   * above. */
  lam_trimesh cap = mesh_box(*state, lam_v3(0, 0, 1), lam_v3(2, 2, 2));
  lam_trimesh table = mesh_pair(*state, &steps, &cap); /* touching faces */
  assert_near(overlap_of(&table, &plate, NULL), 0.5, 1e-14);
}

/* Components that overlap count twice where they do: the cubes hold 8 + 8, and below z = 1.5 6 + 2.
 */
static void overlapping_components_count_twice(void **state) {
  lam_trimesh a = mesh_cube(*state, 0, 0, 0, 2), b = mesh_cube(*state, 1, 1, 1, 2);
  lam_trimesh both = mesh_pair(*state, &a, &b);
  lam_trimesh around = mesh_cube(*state, -1, -1, -1, 6),
              half = mesh_box(*state, lam_v3(-1, -1, -1), lam_v3(4, 4, 1.5));
  assert_near(overlap_of(&both, &around, NULL), 16, 1e-13);
  assert_near(overlap_of(&both, &half, NULL), 6 + 2, 1e-13);
}

/* A bar bent around a square until its end runs over its beginning: one component. In plan its four
 * trapezoids have the areas 2, 2, 2 and 3.5; a plate that reaches half its height of 1 covers 9.5 /
 * 2, the doubled part counted twice. Corefinement cannot answer this. */
static void a_component_that_cuts_itself_is_answered(void **state) {
  static const double plan[5][4] = {
      {1, 1, 0, 0}, {2, 1, 3, 0}, {2, 2, 3, 3}, {1, 2, 0, 3}, {1, -1, 0, -1}};
  lam_vec3 sections[5][4];
  for (int i = 0; i < 5; i++)
    for (int k = 0; k < 4; k++) {
      const double *p = k == 1 || k == 2 ? plan[i] : plan[i] + 2;
      sections[i][k] = lam_v3(p[0], p[1], k >= 2);
    }
  lam_trimesh bar = mesh_tube(*state, 5, sections),
              plate = mesh_box(*state, lam_v3(-5, -5, -5), lam_v3(5, 5, 0.5));
  assert_near(measured(&bar).volume, 9.5, 1e-13);
  assert_true(measured(&bar).self_intersections > 0);
  assert_near(overlap_of(&bar, &plate, NULL), 4.75, 1e-13);
}

/* Of a torus of 2 x 96 x 64 triangles (a large mesh, answered by integration) a box around the half
 * x > 0 holds half the volume, for the torus is symmetric. The whole volume comes from the
 * divergence theorem. */
static void a_large_mesh_and_a_box(void **state) {
  lam_trimesh torus = mesh_torus(*state, 3, 1, 96, 64);
  double whole = measured(&torus).volume;
  lam_trimesh right = mesh_box(*state, lam_v3(0, -5, -2), lam_v3(5, 5, 2));
  lam_trimesh low = mesh_box(*state, lam_v3(-5, -5, -2), lam_v3(5, 5, 0));
  assert_near(overlap_of(&torus, &right, NULL), whole / 2, 1e-12 * whole);
  assert_near(overlap_of(&torus, &low, NULL), whole / 2, 1e-12 * whole);
  lam_trimesh beside = mesh_box(*state, lam_v3(-1, -1, -2), lam_v3(1, 1, 2)); /* in the hole */
  assert_near(overlap_of(&torus, &beside, NULL), 0, 0);
}

/* Integration and corefinement share no code: they must agree on any pair of solids. */
static void integration_agrees_with_corefinement(void **state) {
  lam_trimesh torus = mesh_torus(*state, 3, 1, 24, 16);
  for (int i = 0; i < 12; i++) {
    double s = sin(i), c = cos(i);
    lam_pose frame = {{0.5 * i, 0.3 * c, 0.2 * s}, {{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
    lam_trimesh placed = lam_trimesh_placed(*state, &torus, &frame);
    double volume = -1;
    assert_int_equal(lam_prism_volume(&torus, &placed, &volume), LAM_OK);
    assert_near(overlap_of(&torus, &torus, &frame), volume, 1e-9);
  }
}

static void candidates_are_the_pairs_with_common_boxes(void **state) {
  lam_solid_set *set = lam_solid_set_new();
  for (int i = 0; i < 5; i++) { /* a row in which neighbors overlap */
    lam_trimesh cube = mesh_cube(*state, 0.75 * (4 - i), 0, 0, 1);
    assert_int_equal(lam_solid_set_add(set, &cube, NULL), i);
  }
  int(*pairs)[2], count;
  assert_int_equal(lam_solid_set_candidates(set, &pairs, &count), LAM_OK);
  assert_int_equal(count, 4);
  for (int i = 0; i < 4; i++) {
    assert_int_equal(pairs[i][0], i);
    assert_int_equal(pairs[i][1], i + 1);
  }
  free(pairs);
  lam_solid_set_free(set);
}

/* A grid of 100 + 100 wavy strips of 1000 triangles, in two layers 2 mm apart: every pair of strips
 * across is a candidate by its boxes, and none overlaps. */
static lam_trimesh strip(lam_arena *arena, double offset, bool across, double level) {
  enum { n = 125 };
  lam_vec3 sections[n][4];
  for (int i = 0; i < n; i++)
    for (int k = 0; k < 4; k++) {
      double x = 10. * i / (n - 1), y = offset + ((k == 1 || k == 2) != across ? 0.0015 : 0);
      double z = level + (k >= 2 ? 0.1 : 0) + 0.5 * sin(x) * sin(offset);
      sections[i][k] = across ? lam_v3(y, x, z) : lam_v3(x, y, z);
    }
  return mesh_tube(arena, n, sections);
}

static void many_solids_are_checked_quickly(void **state) {
  lam_solid_set *set = lam_solid_set_new();
  clock_t start = clock();
  for (int i = 0; i < 200; i++) {
    lam_arena_mark mark = lam_arena_mark_get(*state);
    double offset = 10 * (i / 2 + 0.5) / 100;
    lam_trimesh mesh = strip(*state, offset, i % 2, i % 2 ? 0.102 : 0);
    assert_int_equal(lam_solid_set_add(set, &mesh, NULL), i);
    lam_arena_release(*state, mark);
  }
  int(*pairs)[2], count;
  assert_int_equal(lam_solid_set_candidates(set, &pairs, &count), LAM_OK);
  assert_in_range(count, 3000, 10000);
  for (int i = 0; i < count; i++) {
    double volume;
    assert_int_equal(lam_solid_set_overlap(set, pairs[i][0], pairs[i][1], &volume), LAM_OK);
    assert_near(volume, 0, 0);
  }
  double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  print_message("%d candidates in %.2f s\n", count, seconds);
  free(pairs);
  lam_solid_set_free(set);
}

/* ---- distances ---- */

/* A unit cube and the same one moved by 0.1 along x: 0.1 both ways. With a point of one pulled out
 * to a distance of 2, only one direction sees it. */
static void hausdorff_distances(void **state) {
  lam_trimesh a = mesh_cube(*state, 0, 0, 0, 1), b = mesh_cube(*state, 0.1, 0, 0, 1);
  double ab = -1, ba = -1;
  assert_int_equal(lam_solid_hausdorff(&a, &a, 0.1, &ab, &ba), LAM_OK);
  assert_near(ab + ba, 0, 0);
  assert_int_equal(lam_solid_hausdorff(&a, &b, 0.1, &ab, &ba), LAM_OK);
  assert_near(ab, 0.1, 1e-15);
  assert_near(ba, 0.1, 1e-15);
  lam_trimesh slab = mesh_box(*state, lam_v3(0, 0, 0), lam_v3(1, 1, 0.5)); /* half of a */
  assert_int_equal(lam_solid_hausdorff(&a, &slab, 0.1, &ab, &ba), LAM_OK);
  assert_near(ab, 0.5, 1e-15);
  assert_near(ba, 0.45,
              0.05); /* the middle of the slab's top is .5 from a; samples are up to .1 apart */
  assert_int_equal(lam_solid_hausdorff(&a, &slab, 0, &ab, &ba), LAM_BAD_INPUT);
}

/* Every allocation from an arena fails once: the status says so, and nothing is lost or jumps
 * through C++. */
static void running_out_of_memory_is_a_status(void **state) {
  lam_trimesh a = mesh_cube(*state, 0, 0, 0, 2), b = mesh_cube(*state, 1, 1, 1, 2);
  int failures = 0;
  for (long n = 0; n < 20; n++) {
    lam_solid_facts facts;
    double volume;
    lam_alloc_fail_after(n);
    lam_status measured_status = lam_solid_measure(&a, true, &facts);
    lam_alloc_fail_after(n);
    lam_status volume_status = lam_prism_volume(&a, &b, &volume);
    lam_solid_set *set = lam_solid_set_new();
    lam_alloc_fail_after(n);
    int index = lam_solid_set_add(set, &a, NULL);
    lam_alloc_fail_after(-1);
    lam_solid_set_free(set);
    assert_true(measured_status == LAM_OK || measured_status == LAM_NO_MEMORY);
    assert_true(volume_status == LAM_OK || volume_status == LAM_NO_MEMORY);
    failures += (measured_status != LAM_OK) + (volume_status != LAM_OK) + (index < 0);
  }
  assert_true(failures >= 6); /* at least the arena itself and its first block, in each */
}

/* ---- welding ---- */

static void welding_merges_equal_points(void **state) {
  lam_vec3 p[6] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 1e-9, 0}, {0, 0, 1}};
  int t[2][3] = {{0, 1, 2}, {3, 4, 5}};
  lam_trimesh mesh = {6, p, 2, t};
  assert_int_equal(lam_trimesh_weld(*state, &mesh, 0).vertex_count, 5); /* -0 is 0 */
  lam_trimesh welded = lam_trimesh_weld(*state, &mesh, 1e-6);
  assert_int_equal(welded.vertex_count, 4);
  assert_int_equal(welded.triangles[1][1], 1);
  t[1][2] = 1; /* becomes degenerate when points merge */
  assert_int_equal(lam_trimesh_weld(*state, &mesh, 1e-6).triangle_count, 1);
}

/* The shorter diagonal of a kite with corners (0,0), (2,0), (3,3), (0,2) joins corners 1 and 3. */
static void quads_are_cut_along_the_shorter_diagonal(void **state) {
  lam_vec3 p[4] = {{0, 0, 0}, {2, 0, 0}, {3, 3, 0}, {0, 2, 0}};
  int f[2][4] = {{0, 1, 2, 3}, {0, 1, 2, -1}};
  lam_mesh mesh = {4, p, 2, f};
  lam_trimesh cut = lam_mesh_triangles(*state, &mesh);
  assert_int_equal(cut.triangle_count, 3);
  const int expected[3][3] = {{1, 2, 3}, {1, 3, 0}, {0, 1, 2}};
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) assert_int_equal(cut.triangles[i][k], expected[i][k]);
  cut.triangle_count = 2;
  assert_near(lam_trimesh_area(&cut), 6, 1e-15); /* shoelace formula */
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(a_box_is_measured),
      TEST(products_of_inertia_are_entries_of_the_tensor),
      TEST(a_torus_has_genus_one),
      TEST(open_inverted_and_inconsistent_meshes_are_told),
      TEST(a_cavity_is_oriented),
      TEST(touching_cubes_stay_two_components),
      TEST(self_intersections_are_found),
      TEST(a_flat_fold_intersects_itself),
      TEST(wrong_meshes_are_refused),
      TEST(closest_points_on_a_cube),
      TEST(overlaps_of_two_cubes),
      TEST(overlap_of_turned_cubes),
      TEST(cavities_are_empty),
      TEST(an_intersection_that_is_no_manifold),
      TEST(overlapping_components_count_twice),
      TEST(a_component_that_cuts_itself_is_answered),
      TEST(a_large_mesh_and_a_box),
      TEST(integration_agrees_with_corefinement),
      TEST(candidates_are_the_pairs_with_common_boxes),
      TEST(many_solids_are_checked_quickly),
      TEST(hausdorff_distances),
      TEST(running_out_of_memory_is_a_status),
      TEST(welding_merges_equal_points),
      TEST(quads_are_cut_along_the_shorter_diagonal),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
