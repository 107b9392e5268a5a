/* Lamellas on curved, closed and irregular nets: soundness of the solids, clashes, strains. */
#include "core/numbers.h"
#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

static double measured(const lam_workshop *shop, const char *stage, const char *name) {
  return fixture_measure(shop, stage, name)->max;
}

/* Everything that must hold on any net: sound solids, no clash. */
static lam_workshop assert_buildable(void **state, const lam_mesh *mesh, lam_lamella_keys keys) {
  lam_workshop shop = fixture_workshop(fixture_arena(state), mesh);
  fixture_make(&shop, "lamella", &keys);
  if (shop.errors->count) fail_msg("%s", shop.errors->first->text);
  assert_near(measured(&shop, "lamellas", "open_parts"), 0, 0);
  assert_near(measured(&shop, "lamellas", "unoriented_parts"), 0, 0);
  assert_near(measured(&shop, "lamellas", "self_intersecting_parts"), 0, 0);
  lam_workshop_clash(&shop);
  assert_near(measured(&shop, "clash", "clash_volume_sum"), 0, 0);
  assert_near(measured(&shop, "clash", "clash_count"), 0, 0);
  return shop;
}

/* Without slots every crossing of sheets overlaps, in at least t^2 H, the volume at a right angle
 * (less 2 % for twist).
 */
static void assert_clash_without_slots(void **state, const lam_mesh *mesh, lam_lamella_keys keys) {
  lam_workshop shop = fixture_workshop(fixture_arena(state), mesh);
  keys.joint.kind = LAM_JOINT_NONE;
  fixture_make(&shop, "lamella", &keys);
  lam_workshop_clash(&shop);
  int crossings = shop.crossing_count * (keys.pair > 0 ? 4 : 1);
  assert_true(measured(&shop, "clash", "clash_count") > 0);
  assert_true(measured(&shop, "clash", "clash_volume_sum") >=
              0.98 * crossings * keys.thickness * keys.thickness * keys.height);
}

/* How many stations stand at vertices of the net and at the ends. */
static int nodes_and_ends(const lam_sheet_strip *strip) {
  int count = 0;
  for (int i = 0; i < strip->station_count; i++) count += !strip->stations[i].between;
  return count;
}

/* z = x y / 2 over 4 m x 4 m: K = -1/4 at the middle. */
static lam_vec3 hypar(double u, double v) { return lam_v3(2 * u, 2 * v, 2 * u * v); }

/* The straight lines of the surface carry the lamellas, so they do not bend. The normal turns about
 * the line y = 0 by atan(x/2): fastest at the middle. */
static void hyperbolic_paraboloid(void **state) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 9, 9, hypar);
  lam_workshop shop = assert_buildable(state, &mesh, fixture_keys());
  assert_near(measured(&shop, "lamellas", "bending_strain"), 0, 1e-15);
  assert_near(measured(&shop, "lamellas", "sheet_straightness"), 0, 1e-12);
  /* between the nodes at 0 and 0.5 m the normal turns by atan(1/4): the rate is atan(1/4) / (1/2)
   */
  assert_near(measured(&shop, "lamellas", "twist"), atan(0.25) / 0.5, 1e-12);
  assert_near(measured(&shop, "lamellas", "twist_strain"), 0.002 * atan(0.25) / 0.5, 1e-14);
  assert_near(measured(&shop, "lamellas", "edge_strain"),
              0.05 * 0.05 * pow(atan(0.25) / 0.5, 2) / 2, 1e-14);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.025;
  keys.joint.scissor = LAM_PI / 3;
  assert_buildable(state, &mesh, keys);
  keys.joint.scissor = 0;
  keys.every = 2;
  shop = assert_buildable(state, &mesh, keys);
  assert_clash_without_slots(state, &mesh, keys);
  assert_int_equal(shop.part_count, 20);
  assert_int_equal(nodes_and_ends(&shop.lamella_grid->strips[0]), 2 + 5 * 2 + 4);
}

static const char *const asymptotic[] = {
    "tests/cases/nets/10_anet_enneper_final.obj", "tests/cases/nets/11_anet_catenoid_final.obj",
    "tests/cases/nets/12_anet_scherk_final.obj", "tests/cases/nets/13_anet_crpc60_final.obj",
    "tests/cases/nets/14_anet_pseudosphere_final.obj"};

static void asymptotic_nets_are_buildable(void **state) {
  for (int i = 0; i < 5; i++) {
    lam_mesh mesh = fixture_obj(fixture_arena(state), asymptotic[i], 0.4);
    lam_workshop shop = assert_buildable(state, &mesh, fixture_keys());
    assert_int_equal(shop.part_count, 34);
    assert_int_equal(shop.crossing_count, 289);
    if (i == 0) assert_clash_without_slots(state, &mesh, fixture_keys());
    lam_arena_free(*state);
    *state = lam_arena_new();
  }
}

/* Paired, on Enneper's surface: crossings of the net at 90 degrees (the optimizer's tolerance),
 * lamellas straight to twice 5e-5 on this coarse net; the sheets, 12.5 mm off the asymptotic lines,
 * less so, within the elastic limit. */
static void paired_enneper(void **state) {
  lam_mesh mesh = fixture_obj(fixture_arena(state), asymptotic[0], 0.4);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.025;
  keys.thickness = 0.0015;
  keys.joint.scissor = LAM_PI / 3;
  lam_workshop shop = assert_buildable(state, &mesh, keys);
  assert_int_equal(shop.part_count, 68);
  assert_near(fixture_measure(&shop, "lamellas", "crossing_angle")->mean, 90, 1e-9);
  assert_true(measured(&shop, "lamellas", "crossing_angle_deviation") < 1e-6);
  assert_true(measured(&shop, "lamellas", "unrolled_straightness") < 1e-4);
  assert_true(measured(&shop, "lamellas", "sheet_straightness") < 5e-4);
  assert_true(measured(&shop, "lamellas", "straightening_strain") < 0.0011 / 5);
  assert_true(measured(&shop, "lamellas", "bending_strain") < 0.0011);
}

/* The net maps to itself under half turns, which reverse lamellas and swap first and last: 17
 * lamellas of a family are 9 different parts (A01 = A17, ..., A09), each the same forwards and
 * backwards. */
static void congruent_parts(void **state) {
  lam_mesh mesh = fixture_obj(fixture_arena(state), asymptotic[0], 0.4);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  for (int i = 0; i < 17; i++) {
    assert_int_equal(shop.parts[i].congruence, 1 + (i < 9 ? i : 16 - i));
    assert_int_equal(shop.parts[17 + i].congruence, 10 + (i < 9 ? i : 16 - i));
  }
}

/* A plane net of circles and rays: 24 rays, circles of radius 2, 3 and 4. A ring is cut midway
 * between two nodes; its ends leave the clearance between them. Rings are cut as long as the circle
 * is, 2 pi R. The polygon of n corners turns by 2 pi/n per side 2 R sin(pi/n). */
static lam_mesh annulus(lam_arena *arena, bool cylinder) {
  lam_mesh mesh = lam_mesh_grid(arena, 24, 3, true, false);
  for (int i = 0; i < 24; i++)
    for (int j = 0; j < 3; j++) {
      double a = 2 * LAM_PI * i / 24, r = cylinder ? 3 : 4 - j;
      mesh.vertices[i * 3 + j] = lam_v3(r * cos(a), r * sin(a), cylinder ? j : 0);
    }
  return mesh;
}

static void closed_rings(void **state) {
  lam_mesh mesh = annulus(fixture_arena(state), false);
  lam_workshop shop = assert_buildable(state, &mesh, fixture_keys());
  assert_int_equal(shop.part_count, 3 + 24);
  assert_near(shop.parts[0].length / (2 * LAM_PI * 4 - 0.00025), 1, 1e-7);
  double turn = 2 * LAM_PI / 24, side = 2 * 2 * sin(LAM_PI / 24);
  assert_near(measured(&shop, "lamellas", "bending_strain"), 0.001 * turn / side, 1e-12);
  const lam_sheet_strip *ring = &shop.lamella_grid->strips[0];
  assert_int_equal(nodes_and_ends(ring), 26);
  assert_near(lam_distance(ring->stations[0].x, ring->stations[ring->station_count - 1].x), 0.00025,
              1e-9);
  mesh = annulus(fixture_arena(state), true);
  lam_lamella_keys keys = fixture_keys();
  assert_buildable(state, &mesh, keys);
  keys.pair = 0.025;
  assert_buildable(state, &mesh, keys);
}

/* `sectors` sectors of size x size rhombi around a vertex, on a monkey saddle when there are six.
 * With a hole, the faces with both coordinates below `hole` are left out, as are vertices that no
 * face uses. */
static lam_mesh branched(lam_arena *arena, int sectors, int size, int hole) {
  enum { most = 13 };
  lam_mesh mesh = {hole ? 0 : 1, LAM_NEW(arena, lam_vec3, 1 + sectors * size * (size + 1)), 0,
                   NULL};
  mesh.faces =
      (int(*)[4])lam_arena_alloc(arena, (size_t)(sectors * size * size), sizeof *mesh.faces);
  int index[8][most][most]; /* a along the sector's first ray, b along its second */
  for (int s = 0; s < sectors; s++)
    for (int a = 1; a <= size; a++)
      for (int b = 0; b <= size; b++) {
        if (a < hole && b < hole) continue;
        double t = 2 * LAM_PI * s / sectors, u = t + 2 * LAM_PI / sectors;
        double x = a * cos(t) + b * cos(u), y = a * sin(t) + b * sin(u), r = hypot(x, y);
        index[s][a][b] = mesh.vertex_count;
        mesh.vertices[mesh.vertex_count++] =
            lam_v3(x, y, r * r * r * cos(3 * atan2(y, x)) / (20 * size * size));
      }
  for (int s = 0; s < sectors; s++)
    for (int b = 0; b <= size; b++) index[s][0][b] = b ? index[(s + 1) % sectors][b][0] : 0;
  for (int s = 0; s < sectors; s++)
    for (int a = 0; a < size; a++)
      for (int b = 0; b < size; b++) {
        if (a < hole && b < hole) continue;
        int corner[4] = {index[s][a][b], index[s][a + 1][b], index[s][a + 1][b + 1],
                         index[s][a][b + 1]};
        memcpy(mesh.faces[mesh.face_count++], corner, sizeof corner);
      }
  return mesh;
}

/* Selected polylines of `family` that a polyline of the other family crosses: every k-th vertex of
 * it, beginning at the first (every line of these nets begins and ends on a selected one). */
static void assert_every_kth(void **state, const lam_mesh *mesh, int every) {
  lam_workshop shop = fixture_workshop(fixture_arena(state), mesh);
  const lam_net *net = shop.net;
  for (int family = 0; family < 2; family++) {
    bool *on = LAM_NEW(shop.arena, bool, net->mesh.vertex_count);
    const bool *selected = lam_lamella_select(shop.arena, net, family, every, true);
    for (int i = 0; i < net->polyline_count; i++)
      for (int k = 0; selected[i] && k < net->polylines[i].count; k++)
        on[net->polylines[i].vertices[k]] = true;
    for (int i = 0; i < net->polyline_count; i++)
      for (int k = 0; net->polylines[i].family != family && k < net->polylines[i].count; k++)
        assert_int_equal(on[net->polylines[i].vertices[k]], k % every == 0);
  }
}

/* On branched nets, with the irregular vertex and with a hole in its place, and on grids. */
static void every_kth_polyline(void **state) {
  lam_mesh mesh = branched(fixture_arena(state), 6, 12, 0);
  for (int every = 1; every <= 4; every++) assert_every_kth(state, &mesh, every);
  mesh = branched(fixture_arena(state), 6, 12, 4);
  assert_every_kth(state, &mesh, 2);
  assert_every_kth(state, &mesh, 4);
  mesh = branched(fixture_arena(state), 8, 6, 0);
  assert_every_kth(state, &mesh, 3);
  mesh = fixture_grid(fixture_arena(state), 13, 7, hypar);
  assert_every_kth(state, &mesh, 3);
  /* 8 polylines, every fifth: the second and the seventh, as far from both ends */
  mesh = fixture_grid(fixture_arena(state), 3, 8, hypar);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  const bool *selected = lam_lamella_select(shop.arena, shop.net, 0, 5, true);
  for (int i = 0; i < 8; i++) assert_int_equal(selected[i], i == 1 || i == 6);
}

/* Six lamellas end short of the irregular vertex; sheets of half width w at 60 degrees clear each
 * other from w / tan 30 on. */
static void irregular_vertex(void **state) {
  lam_mesh mesh = branched(fixture_arena(state), 6, 3, 0);
  lam_lamella_keys keys = fixture_keys();
  for (int pair = 0; pair < 2; pair++) {
    keys.pair = pair * 0.025;
    lam_workshop shop = assert_buildable(state, &mesh, keys);
    double nearest = INFINITY;
    for (int i = 0; i < shop.lamella_grid->strip_count; i++)
      for (int k = 0; k < shop.lamella_grid->strips[i].station_count; k++)
        nearest = fmin(nearest, lam_length(shop.lamella_grid->strips[i].stations[k].x));
    double w = keys.pair / 2 + keys.thickness / 2 + keys.joint.clearance;
    assert_near(nearest, hypot(w / tan(LAM_PI / 6) + keys.joint.clearance, keys.pair / 2), 2e-3);
    for (int i = 0; i < shop.crossing_count; i++)
      assert_true(lam_length(shop.crossings[i].position) > 0.5);
  }
}

static void odd_vertices_are_refused(void **state) {
  lam_mesh mesh = branched(fixture_arena(state), 5, 3, 0);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_non_null(strstr(shop.errors->first->text, "do not fall into two families"));
}

/* A net over a dome (K > 0) can be built too; its lamellas do not unroll straight, and the measure
 * says so. */
static lam_vec3 dome(double u, double v) { return lam_v3(2 * u, 2 * v, 1 - 0.3 * (u * u + v * v)); }
static void a_dome_is_not_straight(void **state) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 9, 9, dome);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.03;
  lam_workshop shop = assert_buildable(state, &mesh, keys);
  assert_true(measured(&shop, "lamellas", "unrolled_straightness") > 0.05);
  /* lamellas along parallels of a dome in vertical planes would bow by 0.3 / 4 of their length */
  assert_near(measured(&shop, "lamellas", "unrolled_straightness"), 0.3 / 4, 0.02);
}

/* ---- connectors ---- */
typedef struct connector_keys {
  int bolt;
  double washer, gap, arm;
  int material;
} connector_keys;

/* The washer is a plus of width s (across flats) and length 2 arm, less a hole; the polygons stay
 * within 1 % of a circle. */
static void connectors(void **state) {
  lam_mesh mesh = fixture_obj(fixture_arena(state), asymptotic[0], 0.6);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.025;
  fixture_make(&shop, "lamella", &keys);
  int sheets = shop.part_count;
  connector_keys connector = {1, 0.004, 0.001, 0.028, 0};
  fixture_make(&shop, "node-connector", &connector);
  assert_int_equal(shop.errors->count, 0);
  assert_int_equal(shop.part_count, sheets + 2);
  const lam_part *washer = &shop.parts[sheets], *bolt = &shop.parts[sheets + 1];
  assert_int_equal(washer->instance_count, 2 * 289);
  assert_int_equal(bolt->instance_count, 289);
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(&washer->solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold && facts.components == 1);
  assert_int_equal(facts.genus, 1);
  assert_int_equal(facts.self_intersections, 0);
  double star = 2 * 0.013 * 0.056 - 0.013 * 0.013, hole = LAM_PI * 0.0045 * 0.0045;
  assert_near(facts.volume, 0.004 * (star - hole), 0.004 * 0.02 * hole);
  assert_int_equal(lam_solid_measure(&bolt->solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold && facts.components == 1);
  assert_int_equal(facts.genus, 0);
  assert_int_equal(facts.self_intersections, 0);
  /* head 5.3 and nut 6.8 high over a hexagon of s = 13; the shank between and 2 mm beyond */
  double hexagon = sqrt(3) / 2 * 0.013 * 0.013,
         shank = LAM_PI * 0.004 * 0.004 * (0.1 + 2 * 0.00505 + 0.002);
  assert_near(facts.volume, hexagon * (0.0053 + 0.0068) + shank, 0.02 * shank);
  assert_near(bolt->mass, 7850 * facts.volume, 1e-12);
  for (int i = 0; i < washer->instance_count; i++) {
    const lam_pose *f = &washer->instances[i];
    for (int a = 0; a < 3; a++)
      for (int b = 0; b < 3; b++) assert_near(lam_dot(f->axis[a], f->axis[b]), a == b, 1e-12);
    assert_near(lam_dot(lam_cross(f->axis[0], f->axis[1]), f->axis[2]), 1, 1e-12);
  }
  lam_workshop_clash(&shop);
  assert_near(measured(&shop, "clash", "clash_volume_sum"), 0, 0);
  assert_true(measured(&shop, "clash", "pairs_checked") > 4 * 3 * 289);
}

static void connector_messages(void **state) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 4, 4, hypar);
  connector_keys fine = {0, 0.004, 0.001, 0.028, 0};
  struct {
    double pair;
    connector_keys keys;
    const char *text;
  } cases[] = {{0, fine, "node-connector needs paired lamellas of both families before it"},
               {0.025, {3, 0.004, 0.001, 0.028, 0}, NULL},
               {0.012,
                {3, 0.004, 0.001, 0.028, 0},
                "M12 does not fit between sheets that leave 10.0 mm: at least 13.0 mm"},
               {0.025,
                {0, 0.004, 0.001, 0.015, 0},
                "15 mm does not reach over the crossings of the sheets"}};
  for (int i = 0; i < 4; i++) {
    lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
    lam_lamella_keys keys = fixture_keys();
    keys.pair = cases[i].pair;
    fixture_make(&shop, "lamella", &keys);
    fixture_make(&shop, "node-connector", &cases[i].keys);
    assert_int_equal(shop.errors->count, cases[i].text != NULL);
    if (cases[i].text && !strstr(shop.errors->first->text, cases[i].text))
      fail_msg("%s", shop.errors->first->text);
  }
}

/* Makes lamellas and looks for clashes, with the n-th allocation failing. True when nothing failed.
 */
static bool survives(int n) {
  lam_arena *arena = lam_arena_new();
  volatile bool done = false;
  jmp_buf point;
  if (LAM_ARENA_TRY(arena, point)) {
    lam_mesh mesh = fixture_grid(arena, 9, 9, hypar);
    lam_workshop shop = fixture_workshop(arena, &mesh);
    lam_lamella_keys keys = fixture_keys();
    lam_alloc_fail_after(n);
    fixture_make(&shop, "lamella", &keys);
    lam_workshop_clash(&shop);
    done = true;
  }
  lam_alloc_fail_after(-1);
  lam_arena_free(arena);
  return done;
}

/* Every allocation may fail: control comes back to the recovery point. */
static void running_out_of_memory(void **state) {
  (void)state;
  int n = 0;
  while (n < 200 && !survives(n)) n++;
  assert_in_range(n, 1, 199);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(hyperbolic_paraboloid),  TEST(asymptotic_nets_are_buildable),
      TEST(paired_enneper),         TEST(congruent_parts),
      TEST(closed_rings),           TEST(every_kth_polyline),
      TEST(irregular_vertex),       TEST(odd_vertices_are_refused),
      TEST(a_dome_is_not_straight), TEST(connectors),
      TEST(connector_messages),     TEST(running_out_of_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
