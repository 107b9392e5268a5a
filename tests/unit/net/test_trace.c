/* Lines traced on surfaces, and the nets that they make. */
#include "core/numbers.h"
#include "net/measures/measure.h"
#include "net/trace/trace.h"
#include "net_fixture.h"

static lam_surface surface_of(net_fixture *f, const char *name, const char *keys) {
  const lam_row_head *head = lam_registry_find(&lam_surfaces, name);
  assert_non_null(head);
  lam_row row = {.head = head, .params = lam_arena_alloc(f->arena, 1, head->params_size + 1)};
  if (head->keys)
    lam_keys_parse(f->arena, head->keys, keys, strlen(keys), NULL, &f->errors, row.params);
  lam_surface surface = lam_surface_make(f->arena, &row, &f->errors);
  net_no_errors(f, name);
  return surface;
}

static lam_vec3 point_at(const lam_line *line, double s) {
  lam_line_point p = lam_line_at(line, s);
  return lam_surface_point(line->field->surface, LAM_CHART_NATURAL, 0, p.y[0], p.y[1]);
}

static lam_vec3 tangent_at(const lam_line *line, double s) {
  lam_line_point p = lam_line_at(line, s);
  lam_jet jet;
  lam_surface_eval(line->field->surface, p.y[0], p.y[1], &jet);
  return lam_along(lam_scale(jet.u, p.y[2]), p.y[3], jet.v);
}

/* From the point p towards the unit vector t: cos s p + sin s t, on a sphere of radius 1. */
static void geodesics_on_the_sphere_are_great_circles(void **state) {
  net_fixture *f = *state;
  lam_surface sphere = surface_of(f, "sphere", "{radius: 1}");
  lam_placement_keys wide = {.v = {-1.5, 1.5}, .v_given = true};
  double at[2] = {.3, .2};
  lam_line_field field = lam_line_field_make(&sphere, LAM_CHART_GEODESIC_PARALLEL, &wide, at);
  for (int k = 0; k < 12; k++) {
    lam_vec2 d = {cos(.5 * k + .1), sin(.5 * k + .1)};
    lam_line line = lam_line_trace(f->arena, &field, at[0], at[1], d, 1, 1, NULL);
    lam_vec3 p = point_at(&line, 0), t = tangent_at(&line, 0);
    assert_near(lam_length(t), 1, 1e-14);
    for (double s = -1; s <= 1; s += .125)
      assert_near(lam_distance(point_at(&line, s), lam_along(lam_scale(p, cos(s)), sin(s), t)), 0,
                  1e-9);
    /* strips of great circles: j = cos s; they meet in a tenth of their distance at acos(.1) */
    assert_near(lam_line_at(&line, 1).y[4], cos(1), 1e-9);
  }
}

/* A cylinder of radius 2 unrolls isometrically: a geodesic is a helix. */
static void geodesics_on_the_cylinder_are_helices(void **state) {
  net_fixture *f = *state;
  lam_surface cylinder = surface_of(f, "revolution", "{profile: [2, 0,  2, 4]}");
  lam_placement_keys plain = {0};
  double at[2] = {3, .5};
  lam_line_field field = lam_line_field_make(&cylinder, LAM_CHART_GEODESIC_PARALLEL, &plain, at);
  lam_line line =
      lam_line_trace(f->arena, &field, at[0], at[1], (lam_vec2){.5 * .8, .25 * .6}, 20, 20, NULL);
  assert_near(lam_line_last(&line), 2 / .6, 1e-9); /* the border z = 4 */
  assert_int_equal(line.end[1], LAM_END_BORDER);
  for (double s = -3; s <= 3; s += .25) {
    double u = 3 + .4 * s;
    assert_near(lam_distance(point_at(&line, s), lam_v3(2 * cos(u), 2 * sin(u), 2 + .6 * s)), 0,
                1e-8);
  }
}

/* Clairaut: r cos(angle to the parallel) = r^2 u' does not change along a geodesic of a surface of
 * revolution. */
static void geodesics_of_revolution_keep_clairauts_constant(void **state) {
  net_fixture *f = *state;
  static const char *const rows[][2] = {
      {"torus", "{ring: 3, tube: 1}"},
      {"catenoid", "{}"},
      {"pseudosphere", "{}"},
      {"revolution", "{profile: [1.2, 0,  0.8, 1,  0.7, 2,  0.9, 3]}"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_surface surface = surface_of(f, rows[i][0], rows[i][1]);
    lam_placement_keys plain = {0};
    double q[2], p[2], at[2];
    bool closed[2];
    surface.kind->domain(surface.data, LAM_CHART_NATURAL, p, q, closed);
    at[0] = 1, at[1] = q[0] + .4 * (q[1] - q[0]);
    lam_line_field field = lam_line_field_make(&surface, LAM_CHART_GEODESIC_PARALLEL, &plain, at);
    for (int k = 0; k < 8; k++) {
      lam_line line = lam_line_trace(f->arena, &field, at[0], at[1],
                                     (lam_vec2){cos(k + .2), sin(k + .2)}, 6, 6, NULL);
      lam_vec3 x = point_at(&line, 0);
      double constant = (x.x * x.x + x.y * x.y) * lam_line_at(&line, 0).y[2];
      assert_true(lam_line_last(&line) - lam_line_first(&line) > .2);
      for (int s = 0; s < line.count; s++) {
        x = point_at(&line, line.points[s].s);
        assert_near((x.x * x.x + x.y * x.y) * line.points[s].y[2], constant, 1e-8);
        assert_near(lam_length(tangent_at(&line, line.points[s].s)), 1, 1e-8);
      }
    }
  }
}

/* Asymptotic lines u + v and u - v = const of catenoid and pseudosphere, u - v and u + v of
 * Enneper's surface; rings and meridians of the torus. A line keeps its constant. */
static void traced_lines_keep_the_constants_of_closed_charts(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *name, *keys;
    lam_chart chart;
    double at[2], a, b; /* a u + b v is constant on one branch, its mirror image on the other */
  } rows[] = {
      {"catenoid", "{}", LAM_CHART_ASYMPTOTIC, {3, .2}, 1, 1},
      {"pseudosphere", "{}", LAM_CHART_ASYMPTOTIC, {3, 1.2}, 1, 1},
      {"enneper", "{}", LAM_CHART_ASYMPTOTIC, {.1, .2}, 1, 1},
      {"torus", "{}", LAM_CHART_PRINCIPAL, {1, .4}, 1, 0},
      {"catenoid", "{}", LAM_CHART_PRINCIPAL, {1, .4}, 1, 0},
      {"enneper", "{}", LAM_CHART_PRINCIPAL, {.1, .4}, 1, 0},
      {"enneper", "{}", LAM_CHART_DIAGONAL, {.1, .4}, 1, 1},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_surface surface = surface_of(f, rows[i].name, rows[i].keys);
    lam_placement_keys plain = {0};
    const double *at = rows[i].at;
    lam_line_field field = lam_line_field_make(&surface, rows[i].chart, &plain, at);
    for (int branch = 0; branch < 2; branch++) {
      lam_vec2 d[2];
      field.branch = branch;
      assert_true(lam_line_directions(&field, at[0], at[1], d));
      lam_line line = lam_line_trace(f->arena, &field, at[0], at[1], d[branch], 20, 20, NULL);
      assert_true(line.count > 5);
      double along[2] = {0, 0};
      for (int k = 0; k < line.count; k++) {
        double du = line.points[k].y[0] - at[0], dv = line.points[k].y[1] - at[1];
        double c[2] = {rows[i].a * du + rows[i].b * dv,
                       rows[i].b ? rows[i].a * du - rows[i].b * dv : dv};
        for (int j = 0; j < 2; j++) along[j] = fmax(along[j], fabs(c[j]));
      }
      assert_near(fmin(along[0], along[1]), 0, 1e-7);
      assert_true(fmax(along[0], along[1]) > .3);
    }
  }
}

/* Jacobi's ellipsoidal coordinates: along a curvature line one of the two roots of x^2/(a^2 - t) +
 * y^2/(b^2 - t) + z^2/(c^2 - t) = 1 that lie between the squares of the axes does not change.
 * Closed lines end at their beginning. */
static void curvature_lines_of_the_ellipsoid(void **state) {
  net_fixture *f = *state;
  lam_surface surface = surface_of(f, "ellipsoid", "{axes: [3, 2, 1]}");
  lam_placement_keys plain = {.v = {-1.5, 1.5}, .v_given = true};
  double at[2] = {1, .4};
  lam_line_field field = lam_line_field_make(&surface, LAM_CHART_PRINCIPAL, &plain, at);
  for (int branch = 0; branch < 2; branch++) {
    lam_vec2 d[2];
    field.branch = branch;
    assert_true(lam_line_directions(&field, at[0], at[1], d));
    lam_line line = lam_line_trace(f->arena, &field, at[0], at[1], d[branch], 30, 30, NULL);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < line.count; k++) {
      lam_vec3 x = point_at(&line, line.points[k].s);
      /* X(b-t)(c-t) + Y(a-t)(c-t) + Z(a-t)(b-t) = (a-t)(b-t)(c-t): one root is 0 on the surface,
       * the others those of t^2 - (a + b + c - X - Y - Z) t + (bc + ac + ab - X(b+c) - Y(a+c) -
       * Z(a+b)) with X = x^2 ... */
      double a = 9, b = 4, c = 1, X = x.x * x.x, Y = x.y * x.y, Z = x.z * x.z;
      double half = (a + b + c - X - Y - Z) / 2;
      double product = b * c + a * c + a * b - X * (b + c) - Y * (a + c) - Z * (a + b);
      double root = sqrt(half * half - product), t[2] = {half - root, half + root};
      for (int j = 0; j < 2; j++) low[j] = fmin(low[j], t[j]), high[j] = fmax(high[j], t[j]);
    }
    assert_near(fmin(high[0] - low[0], high[1] - low[1]), 0, 1e-6);
    assert_true(fmax(high[0] - low[0], high[1] - low[1]) > .5);
  }
}

static lam_traced reached; /* by the last net that was traced */
static lam_mesh traced(net_fixture *f, const char *name, const char *keys, lam_chart chart, int n,
                       int m, int hole, lam_trace_options options, lam_placement_keys placing) {
  lam_surface surface = surface_of(f, name, keys);
  lam_mesh mesh = {0};
  lam_trace_net(f->arena, &surface, chart, (int[2]){n, m}, hole, &options, &placing,
                (lam_location){0}, &f->errors, &mesh, &reached);
  return mesh;
}

static double measure(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, mesh->vertices, name).max;
}

/* Vertices of traced asymptotic nets lie at crossings of u + v = const and u - v = const to 1e-6:
 * differences of longitude and height along a family are equal. Catenoid: v = z, u the longitude.
 */
static void traced_asymptotic_net_of_the_catenoid(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = traced(f, "catenoid", "{}", LAM_CHART_ASYMPTOTIC, 10, 8, 0,
                         (lam_trace_options){0}, (lam_placement_keys){0});
  net_no_errors(f, "catenoid");
  assert_int_equal(mesh.vertex_count, 11 * 9);
  for (int i = 0; i < 11; i++)
    for (int j = 0; j < 9; j++) {
      lam_vec3 x = mesh.vertices[i * 9 + j], r = mesh.vertices[i * 9], c = mesh.vertices[j];
      assert_near(hypot(x.x, x.y), cosh(x.z), 1e-9);
      double du = atan2(r.x * x.y - r.y * x.x, r.x * x.x + r.y * x.y), dv = x.z - r.z;
      assert_near(remainder(du + dv, 2 * net_pi), 0, 1e-6); /* family 1: v grows, u falls */
      if (j) assert_true(dv > 0);
      du = atan2(c.x * x.y - c.y * x.x, c.x * x.x + c.y * x.y), dv = x.z - c.z;
      assert_near(remainder(du - dv, 2 * net_pi), 0, 1e-6); /* family 0: both grow */
      if (i) assert_true(dv > 0);
    }
}

/* Planarity of the stars falls with the square of the spacing and more: to less than 1/3.2 when the
 * cells are halved. Surfaces without a closed chart: the inner half of the torus, and a bumpy
 * graph. */
static void traced_asymptotic_nets_have_planar_stars(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *name, *keys;
    double at[2];
    bool given;
  } rows[] = {{"torus", "{}", {0, LAM_PI}, true},
              {"enneper", "{}", {0, 0}, false},
              {"hyperbolic-paraboloid", "{}", {0, 0}, false},
              {"pseudosphere", "{}", {1, 1}, true}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    double planarity[2];
    for (int fine = 0; fine < 2; fine++) {
      lam_mesh mesh = traced(
          f, rows[i].name, rows[i].keys, LAM_CHART_ASYMPTOTIC, fine ? 16 : 8, fine ? 16 : 8, 0,
          (lam_trace_options){.at = rows[i].given ? rows[i].at : NULL}, (lam_placement_keys){0});
      net_no_errors(f, rows[i].name);
      assert_int_equal(mesh.vertex_count, fine ? 17 * 17 : 81);
      planarity[fine] = measure(f, &mesh, "star_planarity");
      assert_near(measure(f, &mesh, "foldovers"), 0, 0);
    }
    if (!(planarity[1] < planarity[0] / 3.2 || planarity[0] < 1e-9))
      fail_msg("%s: planarity %g, then %g", rows[i].name, planarity[0], planarity[1]);
  }
}

/* Directions of the two lines at the vertices of principal nets are orthogonal: so are the edges,
 * up to the square of the spacing. Rings that close are closed: the torus around its tube, and
 * around its ring. */
static void traced_principal_nets_are_orthogonal_and_close(void **state) {
  net_fixture *f = *state;
  lam_mesh ring = traced(f, "torus", "{}", LAM_CHART_PRINCIPAL, 24, 12, 0, (lam_trace_options){0},
                         (lam_placement_keys){0});
  net_no_errors(f, "torus");
  lam_net net = net_built(f, &ring);
  assert_int_equal(ring.vertex_count, 24 * 12);
  assert_int_equal(net.loop_count, 0);
  for (int v = 0; v < ring.vertex_count; v++) {
    lam_vec3 x = ring.vertices[v];
    assert_near(hypot(hypot(x.x, x.y) - 3, x.z), 1, 1e-12);
    double u = atan2(x.y, x.x) * 24 / (2 * net_pi),
           w = atan2(x.z, hypot(x.x, x.y) - 3) * 12 / (2 * net_pi);
    assert_near(u - round(u), 0, 1e-6);
    assert_near(w - round(w), 0, 1e-6);
  }
  for (int pass = 0; pass < 2; pass++) {
    static const double at[2] = {1.5, .1};
    int n = pass ? 32 : 16;
    lam_mesh mesh = traced(
        f, "ellipsoid", "{}", LAM_CHART_PRINCIPAL, n, n, 0, (lam_trace_options){.at = at},
        (lam_placement_keys){.u = {.7, 2.3}, .u_given = true, .v = {-.6, .7}, .v_given = true});
    net_no_errors(f, "ellipsoid");
    assert_int_equal(mesh.vertex_count, (n + 1) * (n + 1));
    assert_below(measure(f, &mesh, "face_planarity"), pass ? 4e-4 : 1.6e-3);
    net = net_built(f, &mesh);
    lam_measure angle = lam_net_measure_one(f->arena, &net, mesh.vertices, "crossing_angle");
    assert_near(angle.mean, 90, pass ? .1 : .4);
  }
}

/* The spacing holds on the base lines; the net goes as far as lines of that spacing cross, at most
 * `grid` cells. */
static void spacing_is_kept(void **state) {
  net_fixture *f = *state;
  static const double at[2] = {.1, -.1};
  lam_mesh mesh = traced(f, "enneper", "{}", LAM_CHART_ASYMPTOTIC, 6, 4, 0,
                         (lam_trace_options){.at = at, .spacing = .1}, (lam_placement_keys){0});
  net_no_errors(f, "enneper");
  assert_int_equal(mesh.vertex_count, 7 * 5);
  lam_surface enneper = surface_of(f, "enneper", "{}");
  lam_vec3 middle = lam_surface_point(&enneper, LAM_CHART_NATURAL, 0, .1, -.1);
  assert_near(lam_distance(mesh.vertices[3 * 5 + 2], middle), 0, 1e-12);
  for (int i = 0; i < 6; i++)
    assert_near(lam_distance(mesh.vertices[5 * i + 2], mesh.vertices[5 * i + 7]), .1,
                1e-4); /* chord and arc */
}

/* On the plane geodesic parallels of a straight line are squares, polar coordinates circles. On the
 * sphere, circles around the pole of radius sin s; on every surface both families cross at right
 * angles (Gauss' lemma). */
static void geodesic_coordinates(void **state) {
  net_fixture *f = *state;
  lam_placement_keys plain = {0};
  static const double at[2] = {1, .3};
  lam_mesh mesh = traced(f, "sphere", "{radius: 2}", LAM_CHART_GEODESIC_POLAR, 6, 20, 2,
                         (lam_trace_options){.at = at, .spacing = .15}, plain);
  net_no_errors(f, "sphere");
  assert_int_equal(mesh.vertex_count, 5 * 20);
  lam_surface sphere = surface_of(f, "sphere", "{radius: 2}");
  lam_vec3 pole = lam_surface_point(&sphere, LAM_CHART_NATURAL, 0, 1, .3);
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 20; j++) {
      lam_vec3 x = mesh.vertices[i * 20 + j];
      assert_near(2 * lam_angle(lam_sub(x, lam_v3(0, 0, 0)), pole), .15 * (i + 2), 1e-8);
      assert_near(
          lam_angle(lam_cross(pole, x), lam_cross(pole, mesh.vertices[i * 20 + (j + 1) % 20])),
          2 * net_pi / 20, 1e-8);
    }
  lam_net polar = net_built(f, &mesh);
  assert_int_equal(polar.loop_count, 2);

  static const char *const names[] = {"torus", "enneper", "ellipsoid", "monge", "pseudosphere"};
  for (size_t k = 0; k < sizeof names / sizeof *names; k++)
    for (int base = 0; base < 2; base++) {
      double worst[2] = {0, 0}, range[2][2];
      bool closed[2];
      lam_surface surface = surface_of(f, names[k], "{}");
      surface.kind->domain(surface.data, LAM_CHART_NATURAL, range[0], range[1], closed);
      for (int c = 0; c < 2; c++) { /* far from where geodesics meet */
        double middle = (range[c][0] + range[c][1]) / 2, half = .15 * (range[c][1] - range[c][0]);
        range[c][0] = middle - half, range[c][1] = middle + half;
      }
      plain = (lam_placement_keys){.u = {range[0][0], range[0][1]},
                                   .v = {range[1][0], range[1][1]},
                                   .u_given = true,
                                   .v_given = true};
      for (int fine = 0; fine < 2; fine++) {
        int n = fine ? 24 : 12;
        mesh = traced(f, names[k], "{}", LAM_CHART_GEODESIC_PARALLEL, n, n, 0,
                      (lam_trace_options){.base = base}, plain);
        net_no_errors(f, names[k]);
        lam_net net = net_built(f, &mesh);
        assert_int_equal(mesh.vertex_count, (n + 1) * (n + 1));
        for (int s = 0; s < net.star_count; s++) {
          const lam_star *star = &net.stars[s];
          if (fine && (star->center / (n + 1) % 2 || star->center % (n + 1) % 2))
            continue; /* at the same places */
          lam_vec3 a = lam_sub(mesh.vertices[star->neighbor[0]], mesh.vertices[star->neighbor[2]]);
          lam_vec3 b = lam_sub(mesh.vertices[star->neighbor[1]], mesh.vertices[star->neighbor[3]]);
          worst[fine] = fmax(worst[fine], fabs(lam_angle(a, b) - net_pi / 2));
        }
      }
      if (!(worst[1] < worst[0] / 3.5 || worst[0] < 1e-9))
        fail_msg("%s, base %d: %g rad from a right angle, then %g", names[k], base, worst[0],
                 worst[1]);
      assert_below(worst[1], .01);
    }
}

/* Lines that reach every corner cover everything. On the square [-1, 1]^2 of a plane, circles of
 * radius r/8 around the middle, the first left out, cover pi (1 - 1/64) / 4 of it; twelve of a
 * hundred cells in the middle .12; the largest rectangle along the diagonals has half the area, and
 * the seeds of its lines come to within a twelfth of its sides. */
static void coverage_of_the_square(void **state) {
  net_fixture *f = *state;
  lam_placement_keys square = {.u = {-1, 1}, .v = {-1, 1}, .u_given = true, .v_given = true};
  const char *plane = "{x2: 0, xy: 0, y2: 0}", *bowl = "{x2: 1e-3, y2: 2e-3}";
  traced(f, "monge", plane, LAM_CHART_NATURAL, 10, 10, 0, (lam_trace_options){0}, square);
  net_no_errors(f, "natural");
  assert_near(reached.coverage, 1, 1e-12);
  assert_int_equal(reached.cells[0], 10);

  traced(f, "monge", plane, LAM_CHART_GEODESIC_POLAR, 8, 64, 0, (lam_trace_options){0}, square);
  net_no_errors(f, "polar");
  assert_near(reached.coverage, net_pi * (1 - 1. / 64) / 4, .01);

  traced(f, "monge", plane, LAM_CHART_NATURAL, 4, 3, 0, (lam_trace_options){.spacing = .2}, square);
  net_no_errors(f, "spacing");
  assert_near(reached.coverage, .12, .01);
  assert_true(reached.cells[0] == 4 && reached.cells[1] == 3);

  traced(f, "monge", plane, LAM_CHART_NATURAL, 40, 3, 0, (lam_trace_options){.spacing = .2},
         square);
  assert_true(reached.cells[0] == 10 && reached.cells[1] == 3);

  /* Diagonals of a bowl so shallow that it is a square: the middle is the best place to begin. */
  traced(f, "monge", bowl, LAM_CHART_DIAGONAL, 10, 10, 0, (lam_trace_options){0}, square);
  net_no_errors(f, "diagonal");
  assert_true(reached.coverage > .5 * 11 / 12 && reached.coverage < .51);
}

/* Every wrong wish says what is wrong, and where lines would be. */
static void what_cannot_be_traced(void **state) {
  net_fixture *f = *state;
  static const double outside[2] = {0, 9}, convex[2] = {0, 0};
  static const struct {
    const char *name, *keys;
    lam_chart chart;
    const double *at;
    double spacing;
    int hole;
    const char *why;
  } rows[] = {
      {"sphere", "{}", LAM_CHART_ASYMPTOTIC, NULL, 0, 0, "the surface has none in this range"},
      {"sphere", "{}", LAM_CHART_PRINCIPAL, NULL, 0, 0, "umbilic"},
      {"torus", "{}", LAM_CHART_ASYMPTOTIC, convex, 0, 0,
       "K = 0.25; expected a point with K < 0, such as"},
      {"torus", "{}", LAM_CHART_ASYMPTOTIC, outside, 0, 0, "expected"},
      {"enneper", "{}", LAM_CHART_ASYMPTOTIC, NULL, 50, 0, "too short for one cell"},
      {"enneper", "{}", LAM_CHART_GEODESIC_POLAR, NULL, 50, 0, "too short for one cell"},
      {"enneper", "{}", LAM_CHART_ASYMPTOTIC, NULL, 0, 2, "expected 0"},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    traced(f, rows[i].name, rows[i].keys, rows[i].chart, 8, 8, rows[i].hole,
           (lam_trace_options){.at = rows[i].at, .spacing = rows[i].spacing},
           (lam_placement_keys){.v = {-3, 3.2}, .v_given = rows[i].at == outside});
    if (f->errors.count != 1) fail_msg("%s, row %zu: %d errors", rows[i].name, i, f->errors.count);
    if (!strstr(f->errors.first->text, rows[i].why))
      fail_msg("\"%s\" does not say \"%s\"", f->errors.first->text, rows[i].why);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(geodesics_on_the_sphere_are_great_circles),
      NET_TEST(geodesics_on_the_cylinder_are_helices),
      NET_TEST(geodesics_of_revolution_keep_clairauts_constant),
      NET_TEST(traced_lines_keep_the_constants_of_closed_charts),
      NET_TEST(curvature_lines_of_the_ellipsoid),
      NET_TEST(traced_asymptotic_net_of_the_catenoid),
      NET_TEST(traced_asymptotic_nets_have_planar_stars),
      NET_TEST(traced_principal_nets_are_orthogonal_and_close),
      NET_TEST(spacing_is_kept),
      NET_TEST(geodesic_coordinates),
      NET_TEST(coverage_of_the_square),
      NET_TEST(what_cannot_be_traced),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
