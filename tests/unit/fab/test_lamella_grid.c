/* Where lamellas begin and end: at irregular vertices, on closed lines, at the last crossing; which
 * lines carry them; and which strips are the same part. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

/* ---- six rhombi of n by n faces around a vertex, all in a plane ---- */

enum { largest_star = 3 };

/* Sector s has the directions at 60 s and 60 (s + 1) degrees. The middle is the first vertex,
 * and the lines that reach it begin there; or the last one, and they end there. */
static lam_mesh star(lam_arena *arena, int n, double edge, bool last) {
  int count = 1 + 6 * n * (n + 1), next = 1, index[6][largest_star + 1][largest_star + 1];
  lam_mesh mesh = {count, LAM_NEW(arena, lam_vec3, count), 0, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(arena, (size_t)(6 * n * n), sizeof *mesh.faces);
  for (int s = 0; s < 6; s++)
    for (int a = 1; a <= n; a++)
      for (int b = 0; b <= n; b++) {
        double t = s * LAM_PI / 3, u = t + LAM_PI / 3;
        index[s][a][b] = last ? count - 1 - next : next;
        mesh.vertices[index[s][a][b]] =
            lam_v3(edge * (a * cos(t) + b * cos(u)), edge * (a * sin(t) + b * sin(u)), 0);
        next++;
      }
  for (int s = 0; s < 6; s++)
    for (int b = 0; b <= n; b++)
      index[s][0][b] = b ? index[(s + 1) % 6][b][0] : last ? count - 1 : 0;
  for (int s = 0; s < 6; s++)
    for (int a = 0; a < n; a++)
      for (int b = 0; b < n; b++) {
        const int face[4] = {index[s][a][b], index[s][a + 1][b], index[s][a + 1][b + 1],
                             index[s][a][b + 1]};
        memcpy(mesh.faces[mesh.face_count++], face, sizeof face);
      }
  return mesh;
}

/* Six lamellas come to the middle, 60 degrees from each other. With the half width w they clear
 * each other from w / tan 30 on, and the clearance more is kept. Sheets of a pair stand 12.5 mm
 * beside. */
static void lamellas_end_short_of_an_irregular_vertex(void **state) {
  for (int k = 0; k < 4; k++) {
    int pair = k % 2;
    lam_mesh mesh = star(*state, 2, 1, k / 2);
    int middle = k / 2 ? mesh.vertex_count - 1 : 0;
    lam_workshop shop = fixture_workshop(*state, &mesh);
    lam_lamella_keys keys = fixture_keys();
    keys.pair = pair * .025;
    fixture_make(&shop, "lamella", &keys);
    assert_int_equal(shop.errors->count, 0);
    double w = pair * .0125 + .001 + .00025, back = w / tan(LAM_PI / 6) + .00025;
    int ends = 0;
    for (int i = 0; i < shop.lamella_grid->strip_count; i++) {
      const lam_sheet_strip *strip = &shop.lamella_grid->strips[i];
      for (int j = 0; j < strip->station_count; j++) {
        const lam_station *q = &strip->stations[j];
        if (lam_length(q->x) > .2) continue;
        assert_int_equal(j, k / 2 ? strip->station_count - 1 : 0);
        assert_int_equal(q->partner, -1);
        assert_near(lam_length(q->x), hypot(back, pair * .0125), 1e-12);
        assert_near(fabs(lam_dot(q->x, q->t)), back, 1e-12);
        lam_vec3 left = lam_cross(q->m, q->t);
        assert_near(lam_dot(q->x, left), strip->offset, 1e-12);
        /* their line reaches the middle */
        const lam_polyline *axis = &shop.lamella_grid->axes[strip->group];
        assert_int_equal(axis->vertices[j ? axis->count - 1 : 0], middle);
        ends++;
      }
    }
    assert_int_equal(ends, pair ? 12 : 6);
    lam_workshop_clash(&shop);
    assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 0, 0);
  }
}

/* Ending 24.1 mm short takes more than .4 of edges of 60 mm, and less of edges of 61 mm. */
static void irregular_vertices_need_long_edges(void **state) {
  static const double edges[] = {.06, .06, .061};
  for (int k = 0; k < 3; k++) {
    lam_mesh mesh = star(*state, 2, edges[k], k == 1);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    lam_lamella_keys keys = fixture_keys();
    keys.pair = .025;
    fixture_make(&shop, "lamella", &keys);
    const lam_error *error = shop.errors->first;
    if (k == 2) {
      assert_true(!error || !strstr(error->text, "have to end"));
      continue;
    }
    assert_int_equal(shop.errors->count, 1);
    assert_string_equal(
        error->text,
        lam_arena_printf(
            *state,
            "at net vertex %d lamellas have to end 24.1 mm short to clear each other, and the edge "
            "there is 60.0 mm long: take a coarser net or thinner lamellas",
            k ? mesh.vertex_count : 1));
  }
}

/* Makes the middle the second vertex, after the tip of a sector: lines begin there still, but
 * are not the first ones. */
static void put_tip_first(lam_mesh *mesh, int tip) {
  int to[3][2] = {{0, 1}, {tip, 0}, {1, tip}};
  lam_vec3 at[3] = {mesh->vertices[0], mesh->vertices[tip], mesh->vertices[1]};
  for (int i = 0; i < 3; i++) mesh->vertices[to[i][1]] = at[i];
  for (int k = 0; k < 4 * mesh->face_count; k++) {
    int *v = &mesh->faces[k / 4][k % 4], was = *v;
    for (int i = 0; i < 3; i++)
      if (was == to[i][0]) *v = to[i][1];
  }
}

/* Two lines lie between the middle and the boundary. Every fourth line is in order with the middle,
 * or two lines beside it: the boundary is one line away from a lamella either way, and so the lines
 * to the middle carry them. */
static void lines_to_an_irregular_vertex_carry(void **state) {
  for (int k = 0; k < 3; k++) {
    lam_mesh mesh = star(*state, 3, 1, k == 1);
    int middle = k == 0 ? 0 : k == 1 ? mesh.vertex_count - 1 : 1;
    if (k == 2) put_tip_first(&mesh, 12); /* a = b = 3 in the first sector */
    assert_near(lam_length(mesh.vertices[middle]), 0, 0);
    if (k == 2) assert_near(lam_length(mesh.vertices[0]), 3 * sqrt(3), 1e-12);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    for (int family = 0; family < 2; family++) {
      const bool *on = lam_lamella_select(*state, shop.net, family, 4, true);
      for (int i = 0; i < shop.net->polyline_count; i++) {
        const lam_polyline *line = &shop.net->polylines[i];
        bool reaches = line->vertices[k == 1 ? line->count - 1 : 0] == middle;
        assert_int_equal(on[i], reaches && line->family == family);
      }
    }
  }
}

/* ---- closed lines ---- */

/* The station number k of those that are not between nodes. */
static const lam_station *node_station(const lam_sheet_strip *strip, int k) {
  for (int i = 0; i < strip->station_count; i++)
    if (!strip->stations[i].between && k-- == 0) return &strip->stations[i];
  return NULL;
}

/* Twelve rays, circles of 2 m and 3 m: a ring begins half the clearance after the middle of the
 * arc from its last vertex to its first, and ends half the clearance before; both ends and all
 * between lie on the circle, to 2e-5 m (fifth degree through nodes 30 degrees apart). */
static void rings_are_cut_between_two_nodes(void **state) {
  lam_mesh mesh = lam_mesh_grid(*state, 12, 2, true, false);
  for (int i = 0; i < 24; i++) {
    double r = 3 - i % 2, t = i / 2 * LAM_PI / 6;
    mesh.vertices[i] = lam_v3(r * cos(t), r * sin(t), 0);
  }
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.joint.clearance = .004;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 0);
  const lam_sheet_strip *ring = &shop.lamella_grid->strips[0];
  assert_null(node_station(ring, 14));
  const lam_vec3 *at = shop.net->mesh.vertices;
  const int *v = shop.lamella_grid->axes[0].vertices;
  lam_vec3 a = at[v[11]], b = at[v[0]], along = lam_unit(lam_sub(b, a));
  double radius = lam_length(a);
  lam_vec3 middle = lam_scale(lam_unit(lam_add(a, b)), radius);
  const lam_station *first = &ring->stations[0], *last = &ring->stations[ring->station_count - 1];
  assert_near(lam_distance(first->x, lam_along(middle, .002, along)), 0, 2e-5);
  assert_near(lam_distance(last->x, lam_along(middle, -.002, along)), 0, 2e-5);
  assert_near(lam_distance(first->x, last->x), .004, 1e-7);
  assert_near(lam_distance(first->t, along), 0, 1e-3); /* .002 m / radius further on */
  assert_near(lam_distance(last->t, along), 0, 1.1e-3);
  for (int k = 1; k < 13; k++) {
    const lam_station *q = node_station(ring, k);
    assert_near(lam_distance(q->x, at[v[k - 1]]), 0, 1e-12);
    assert_near(lam_dot(q->x, q->t), 0, 1e-12); /* square to the radius */
    assert_near(q->angle, LAM_PI / 2, 1e-12);
  }
  for (int i = 0; i < ring->station_count; i++)
    assert_near(lam_length(ring->stations[i].x), radius, 2e-5);
  assert_near(ring->length / (2 * LAM_PI * radius - .004), 1, 5e-6);
}

/* On a cone: the directions at both ends of a ring are those of the cone there, up and along. */
static void rings_on_a_cone_are_cut_upright(void **state) {
  lam_mesh mesh = lam_mesh_grid(*state, 12, 2, true, false);
  for (int i = 0; i < 24; i++) {
    double r = 3 - i % 2, t = i / 2 * LAM_PI / 6;
    mesh.vertices[i] = lam_v3(r * cos(t), r * sin(t), r);
  }
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.joint.clearance = .004;
  fixture_make(&shop, "lamella", &keys);
  const lam_sheet_strip *ring = &shop.lamella_grid->strips[0];
  for (int end = 0; end < 2; end++) {
    const lam_station *q = &ring->stations[end ? ring->station_count - 1 : 0];
    int node = shop.lamella_grid->axes[0].vertices[0];
    lam_vec3 out = lam_unit(lam_v3(q->x.x, q->x.y, 0)), n = shop.normals[node],
             radial = lam_unit(
                 lam_v3(shop.net->mesh.vertices[node].x, shop.net->mesh.vertices[node].y, 0));
    /* the same share of up and outwards as at a node */
    assert_near(q->m.z, n.z, 1e-4);
    assert_near(lam_dot(q->m, out), lam_dot(n, radial), 1e-4);
    assert_near(lam_dot(q->m, q->t), 0, 1e-12);
    assert_near(lam_dot(q->t, out), 0, 1e-4);
  }
}

/* ---- which lines ---- */

static lam_vec3 plane(double u, double v) { return lam_v3(u, v, 0); }

/* Of 8 lines every third, fourth ...: first and last where the step divides 7, otherwise the
 * rest is shared between both ends; without the lines along the boundary when asked. */
static void every_kth_line_carries(void **state) {
  static const struct {
    int every;
    bool boundary;
    const char *lines;
  } cases[] = {{1, true, "11111111"},  {1, false, "01111110"}, {7, true, "10000001"},
               {7, false, "00000000"}, {3, true, NULL},        {5, true, "01000010"}};
  lam_mesh mesh = fixture_grid(*state, 3, 8, plane);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  for (int c = 0; c < 6; c++) {
    const bool *on = lam_lamella_select(*state, shop.net, 0, cases[c].every, cases[c].boundary);
    char lines[9] = {0};
    int most = 0, last = -1;
    for (int i = 0; i < 8; i++) {
      lines[i] = on[i] ? '1' : '0';
      if (on[i] && last >= 0) assert_int_equal(i - last, cases[c].every);
      if (on[i]) last = i;
      most += on[i];
    }
    for (int i = 8; i < shop.net->polyline_count; i++) assert_false(on[i]);
    if (cases[c].lines)
      assert_string_equal(lines, cases[c].lines);
    else
      assert_int_equal(most, 3); /* 0, 3, 6 or 1, 4, 7 */
  }
}

/* ---- equal strips ---- */

/* A strip of 2 m with slots for square crossings at these places; family 0 unless told. */
static lam_sheet_strip strip_of(lam_arena *arena, int count, const double *at, double length) {
  lam_sheet_strip strip = {.length = length, .stations = LAM_NEW(arena, lam_station, count + 2)};
  strip.stations[strip.station_count++] = (lam_station){.partner = -1};
  for (int i = 0; i < count; i++)
    strip.stations[strip.station_count++] =
        (lam_station){.s = at[i], .partner = 0, .slot_angle = LAM_PI / 2};
  strip.stations[strip.station_count++] = (lam_station){.s = length, .partner = -1};
  return strip;
}

/* The same forwards and backwards, to a tenth of a millimeter; not when family, number of slots,
 * length or a slot's side differs. A slot that is wider to one side is wider to the other
 * backwards. */
static void strips_are_equal_both_ways(void **state) {
  lam_lamella_grid grid = {.height = .1, .thickness = .002, .strip_count = 9};
  grid.strips = LAM_NEW(*state, lam_sheet_strip, 9);
  const double at[3] = {.5, .7, 1.1}, back[3] = {.9, 1.3, 1.5}, near[3] = {.50005, .7, 1.1},
               off[3] = {.5002, .7, 1.1};
  const double *places[9] = {at, back, near, off, at, at, at, at, back};
  for (int i = 0; i < 9; i++)
    grid.strips[i] = strip_of(*state, i == 5 ? 2 : 3, places[i], i == 6 ? 2.001 : 2);
  grid.strips[4].family = 1;
  grid.strips[7].stations[1].slot_high = .01;
  grid.strips[8].stations[3].slot_low = -.01; /* the slot at 1.5 from the start, .5 from the end */
  static const int expected[9] = {3, 3, 3, 4, 5, 6, 7, 8, 8};
  int class[9];
  assert_int_equal(lam_lamella_classes(*state, &grid, 3, class), 6);
  for (int i = 0; i < 9; i++) assert_int_equal(class[i], expected[i]);
}

/* ---- the solid ---- */

/* One crossing in the middle of 2 m: sections at the ends, and at -+w/2 of the slot. The slot takes
 * t w (H/2 + c) away, from above in family 0, from below in family 1; its lines are those of the
 * section. Widened by 3 mm to one side, it takes more. */
static void a_slotted_strip_is_a_row_of_cells(void **state) {
  lam_lamella_grid grid = {.height = .1, .thickness = .002, .clearance = .001};
  for (int family = 0; family < 2; family++)
    for (int wide = 0; wide < 2; wide++) {
      lam_sheet_strip strip = strip_of(*state, 1, (double[]){1}, 2);
      strip.family = family;
      for (int k = 0; k < 3; k++) {
        strip.stations[k].x = lam_v3(k, 0, 0);
        strip.stations[k].t = lam_v3(1, 0, 0);
        strip.stations[k].m = lam_v3(0, 0, 1);
      }
      if (wide) strip.stations[1].slot_high = .003;
      lam_part part = {.solid = lam_lamella_solid(*state, &grid, &strip)};
      double w = .004 + .003 * wide; /* t + 2 c */
      assert_near(lam_trimesh_volume(&part.solid), .002 * (.2 - w * .051), 1e-15);
      assert_true(lam_part_is_sound(*state, &part));
      assert_int_equal(part.solid.vertex_count, 4 * 6);
      static const double x[4] = {0, .998, 1.002, 2};
      for (int v = 0; v < 24; v++) {
        int section = v / 6, level = v % 6 / 2;
        double floor = family ? .001 : -.001, z = level == 0 ? -.05 : level == 1 ? floor : .05;
        assert_near(part.solid.vertices[v].x, x[section] + (wide && section == 2 ? .003 : 0),
                    1e-15);
        assert_near(part.solid.vertices[v].y, v % 2 ? .001 : -.001, 1e-15);
        assert_near(part.solid.vertices[v].z, z, 1e-15);
      }
    }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(lamellas_end_short_of_an_irregular_vertex),
      TEST(irregular_vertices_need_long_edges),
      TEST(lines_to_an_irregular_vertex_carry),
      TEST(rings_are_cut_between_two_nodes),
      TEST(rings_on_a_cone_are_cut_upright),
      TEST(every_kth_line_carries),
      TEST(strips_are_equal_both_ways),
      TEST(a_slotted_strip_is_a_row_of_cells),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
