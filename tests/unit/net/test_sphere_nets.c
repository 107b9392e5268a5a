/* Nets of spherical stars: what their theory says about the surface, measured without the solver's
 * equations. */
#include "core/numeric/fit.h"
#include "jet_fixture.h"
#include "net/optimize.h"

typedef struct solved {
  lam_net net;
  lam_vec3 *start, *normals;
  lam_net_result result;
} solved;

static solved solve(net_fixture *f, const lam_mesh *mesh, const char *kind_name, const char *params,
                    const char *keys) {
  solved s = {.net = net_built(f, mesh), .start = mesh->vertices};
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, kind_name);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, keys);
  common->from.file = "test";
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, params),
                     .common = common};
  bool done = lam_net_optimize(f->arena, &job, &s.net, &f->errors, &s.result);
  net_no_errors(f, kind_name);
  assert_true(done);
  s.normals = LAM_NEW(f->arena, lam_vec3, mesh->vertex_count);
  lam_net_normals(&s.net, s.net.mesh.vertices, s.normals);
  return s;
}

/* A mesh of the tables in meters of its own: 1 unit there is `unit` meters. */
static lam_mesh case_mesh(net_fixture *f, const char *name, double unit) {
  lam_mesh mesh =
      net_obj(f->arena, lam_arena_printf(f->arena, "tests/cases/nets/%s_init.obj", name));
  for (int v = 0; v < mesh.vertex_count; v++) mesh.vertices[v] = lam_scale(mesh.vertices[v], unit);
  return mesh;
}

static lam_measure measured(net_fixture *f, const solved *s, const char *name) {
  return lam_net_measure_one(f->arena, &s->net, s->net.mesh.vertices, name);
}

static void must_converge(const solved *s, const char *what) {
  if (!s->result.converged) fail_msg("%s: %s", what, s->result.reason);
}

/* ---- mean curvature ---- */

/* Gradient of area and volume of the triangle v, a, b by v. */
static void triangle_gradients(lam_vec3 v, lam_vec3 a, lam_vec3 b, double share, lam_vec3 *area,
                               lam_vec3 *volume) {
  lam_vec3 n = lam_unit(lam_cross(lam_sub(a, v), lam_sub(b, v)));
  *area = lam_along(*area, share / 2, lam_cross(n, lam_sub(b, a)));
  *volume = lam_along(*volume, share / 6, lam_cross(lam_sub(a, v), lam_sub(b, v)));
}

/* H of the polyhedral surface, by the change of area over the change of volume as v moves along the
 * normal: dA = 2 H dV. Each quad counts half by either of its diagonals. Outward normals of a tube
 * give a positive H. */
static double polyhedral_mean_curvature(const solved *s, int v) {
  const lam_mesh *mesh = &s->net.mesh;
  const lam_vec3 *x = mesh->vertices;
  lam_vec3 area = {0, 0, 0}, volume = {0, 0, 0};
  for (int k = 0; k < mesh->face_count; k++)
    for (int c = 0; c < 4; c++) {
      const int *face = mesh->faces[k];
      if (face[c] != v) continue;
      lam_vec3 a = x[face[(c + 1) & 3]], o = x[face[(c + 2) & 3]], b = x[face[(c + 3) & 3]];
      triangle_gradients(x[v], a, b, .5, &area, &volume);
      triangle_gradients(x[v], a, o, .5, &area, &volume);
      triangle_gradients(x[v], o, b, .5, &area, &volume);
    }
  return lam_dot(area, s->normals[v]) / lam_dot(volume, s->normals[v]) / 2;
}

/* The unduloid with bulge 1 and neck .3 / 1.7 has H = 1 / (1 + neck), normals outwards. Its
 * diagonals on finer and finer grids: the net of the radius -1/H has stars of just this radius, and
 * the surface's mean curvature tends to H with the square of the edge. Compared at the same
 * vertices, an eighth of the net and more from the border. */
static void mean_curvature_tends_to_the_radius(void **state) {
  net_fixture *f = *state;
  static const double limit[3] = {.03, .008, .002};
  double H = 1 / (1 + .17647), before[2] = {0, 0};
  for (int level = 0; level < 3; level++) {
    int cells = 12 << level, n = cells + 1;
    lam_mesh mesh =
        net_sampled(f, "unduloid", "{neck: 0.17647}", LAM_CHART_DIAGONAL, cells, cells, 0);
    solved s =
        solve(f, &mesh, "cmc", lam_arena_printf(f->arena, "{radius: -%.12f m}", 1 / H), "{}");
    must_converge(&s, "unduloid");
    assert_near(1 / measured(f, &s, "star_curvature").mean, -1 / H, 1e-9);
    assert_below(measured(f, &s, "curvature_spread").max, 1e-10);
    assert_below(measured(f, &s, "circle_angle_deviation").max, 1e-9);
    double worst[2] = {0, 0};
    for (int i = 3; i <= 9; i++)
      for (int j = 3; j <= 9; j++) {
        int a = i << level, b = j << level;
        worst[0] = fmax(worst[0], fabs(polyhedral_mean_curvature(&s, a * n + b) - H));
        worst[1] = fmax(worst[1], fabs(jet_fit(s.net.mesh.vertices, s.normals, n, a, b).H + H));
      }
    assert_below(worst[0], limit[level]);
    for (int k = 0; level > 0 && k < 2; k++)
      if (!(worst[k] < before[k] / 3))
        fail_msg("%d cells: %g after %g", cells, worst[k], before[k]);
    memcpy(before, worst, sizeof worst);
  }
}

/* Closed rings of unduloid and nodoid, H = 1/2: the radius is 2 where it is given, and found within
 * 1 % where it is not; the polyhedral H is off by the polygons' error: rings of 16 vertices are
 * 1/cos(pi/16)^2 = 4 % too narrow. */
static void rings_of_radius_two(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *name;
    double unit;
  } rows[2] = {{"05_cmc_unduloid", .1975708073255066}, {"06_cmc_nodoid", .39882330308409253}};
  for (int i = 0; i < 2; i++) {
    lam_mesh mesh = case_mesh(f, rows[i].name, rows[i].unit);
    solved s = solve(f, &mesh, "cmc", "{radius: 2 m}", "{}");
    must_converge(&s, rows[i].name);
    assert_near(1 / measured(f, &s, "star_curvature").max, 2, 1e-11);
    assert_near(1 / measured(f, &s, "star_curvature").mean, 2, 1e-11);
    double sum = 0;
    for (int k = 0; k < s.net.star_count; k++)
      sum -= polyhedral_mean_curvature(&s, s.net.stars[k].center);
    assert_near(sum / s.net.star_count, .5, .02);
    solved free_radius = solve(f, &mesh, "cmc", "{}", "{}");
    must_converge(&free_radius, rows[i].name);
    assert_near(1 / measured(f, &free_radius, "star_curvature").mean, 2, .02);
  }
}

/* Seen from the other side the same net has the opposite radius, and not the first one. */
/* ---- the border ---- */

/* The largest share by which the sphere through a border vertex and its three neighbors misses the
 * radius: its center c is at equal distances, c.E = |E|^2 / 2 for the three edges E (Cramer). */
static double border_off(const solved *s, double radius) {
  const lam_net *net = &s->net;
  double most = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (!net->boundary[v] || lam_net_valence(net, v) != 3) continue;
    lam_vec3 e[3], c = {0, 0, 0};
    for (int k = 0; k < 3; k++)
      e[k] = lam_sub(net->mesh.vertices[net->ring[net->ring_start[v] + k]], net->mesh.vertices[v]);
    double d = lam_dot(e[0], lam_cross(e[1], e[2]));
    for (int k = 0; k < 3; k++)
      c = lam_along(c, lam_dot(e[k], e[k]) / 2 / d, lam_cross(e[(k + 1) % 3], e[(k + 2) % 3]));
    most = fmax(most, fabs(lam_length(c) / radius - 1));
  }
  return most;
}

/* With `border` the stars on the border lie on spheres of the same radius as those inside; without,
 * they are several per cent off. */
static void the_border_keeps_the_radius(void **state) {
  net_fixture *f = *state;
  static const char *const keys[2] = {"{}", "{border: yes}"};
  for (int k = 0; k < 2; k++) {
    lam_mesh mesh = net_sampled(f, "unduloid", "{neck: 0.7}", LAM_CHART_DIAGONAL, 12, 12, 0);
    solved s = solve(f, &mesh, "cmc", keys[k], "{}");
    must_converge(&s, keys[k]);
    double off = border_off(&s, fabs(1 / measured(f, &s, "star_curvature").mean));
    if (k)
      assert_below(off, 1e-9);
    else
      assert_true(off > .01);
  }
  lam_mesh mesh = net_sampled(f, "unduloid", "{neck: 0.7}", LAM_CHART_DIAGONAL, 12, 12, 0);
  solved s = solve(f, &mesh, "cmc", "{border: yes}", "{}");
  double radius = 1 / measured(f, &s, "star_curvature").mean;
  char *given = lam_arena_printf(f->arena, "{border: yes, radius: %.6g m}", radius * 1.01);
  s = solve(f, &mesh, "cmc", given, "{}");
  must_converge(&s, given);
  assert_below(border_off(&s, fabs(radius * 1.01)), 1e-5);
}

static void the_radius_has_a_sign(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = case_mesh(f, "05_cmc_unduloid", .1975708073255066),
           other = case_mesh(f, "05_cmc_unduloid", .1975708073255066);
  for (int k = 0; k < other.face_count; k++) {
    int swap = other.faces[k][1];
    other.faces[k][1] = other.faces[k][3];
    other.faces[k][3] = swap;
  }
  solved s = solve(f, &mesh, "cmc", "{radius: 2 m}", "{}"),
         t = solve(f, &other, "cmc", "{radius: -2 m}", "{}");
  must_converge(&s, "outside");
  must_converge(&t, "inside");
  assert_near(1 / measured(f, &t, "star_curvature").mean, -2, 1e-11);
  for (int v = 0; v < mesh.vertex_count; v++)
    assert_below(lam_distance(s.net.mesh.vertices[v], t.net.mesh.vertices[v]), 1e-9);
  solved wrong = solve(f, &mesh, "cmc", "{radius: -2 m}", "{}");
  assert_true(!wrong.result.converged || wrong.result.drift > 1);
}

/* ---- what kind of surface ---- */

/* Eigenvalues of a symmetric matrix by Jacobi rotations; the smallest. */
static double smallest_eigenvalue(double a[6][6]) {
  for (int sweep = 0; sweep < 60; sweep++)
    for (int p = 0; p < 5; p++)
      for (int q = p + 1; q < 6; q++) {
        if (fabs(a[p][q]) < 1e-300) continue;
        double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]),
               t = copysign(1, theta) / (fabs(theta) + hypot(theta, 1));
        double c = 1 / hypot(t, 1), s = t * c;
        for (int pass = 0; pass < 2; pass++)
          for (int k = 0; k < 6; k++) {
            double *x = pass ? &a[p][k] : &a[k][p], *y = pass ? &a[q][k] : &a[k][q], old = *x;
            *x = c * old - s * *y;
            *y = s * old + c * *y;
          }
      }
  double least = INFINITY;
  for (int i = 0; i < 6; i++) least = fmin(least, a[i][i]);
  return least;
}

/* The normals of a surface of revolution meet its axis, those of a helical surface belong to a
 * linear complex: a combination of (n, x cross n) vanishes for all of them. Root mean square of the
 * best combination, with x from the middle of the net and in units of its radius of gyration. */
static double no_motion_keeps_it(const solved *s) {
  const lam_net *net = &s->net;
  lam_vec3 middle = {0, 0, 0};
  double square = 0, a[6][6] = {{0}};
  for (int k = 0; k < net->star_count; k++)
    middle = lam_along(middle, 1.0 / net->star_count, net->mesh.vertices[net->stars[k].center]);
  for (int k = 0; k < net->star_count; k++) {
    lam_vec3 d = lam_sub(net->mesh.vertices[net->stars[k].center], middle);
    square += lam_dot(d, d) / net->star_count;
  }
  for (int k = 0; k < net->star_count; k++) {
    int v = net->stars[k].center;
    lam_vec3 n = s->normals[v],
             m = lam_cross(lam_scale(lam_sub(net->mesh.vertices[v], middle), 1 / sqrt(square)), n);
    double w[6] = {n.x, n.y, n.z, m.x, m.y, m.z};
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++) a[i][j] += w[i] * w[j] / net->star_count;
  }
  return sqrt(fmax(smallest_eigenvalue(a), 0));
}

/* The ring keeps its axis; the patch with pulled corners has none, though its mean curvature is as
 * constant. */
static void constant_mean_curvature_without_rotation(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = case_mesh(f, "05_cmc_unduloid", .1975708073255066);
  solved round = solve(f, &mesh, "cmc", "{radius: 2 m}", "{}");
  mesh = case_mesh(f, "07_cmc_nonrotational_patch", .07181619299822746);
  solved free_form = solve(f, &mesh, "cmc", "{radius: -2 m}", "{}");
  must_converge(&free_form, "patch");
  double sum = 0, squares = 0, count = 0;
  for (int i = 2; i < 15; i++)
    for (int j = 2; j < 15; j++, count++) {
      double H = polyhedral_mean_curvature(&free_form, 17 * i + j);
      sum += H;
      squares += H * H;
    }
  assert_below(no_motion_keeps_it(&round), 1e-9);
  assert_true(no_motion_keeps_it(&free_form) > .005);
  assert_near(sum / count, .5, .004);
  assert_below(sqrt(squares / count - sum * sum / count / count), .001);
}

typedef struct shape {
  lam_vec3 principal; /* direction of k1 */
  double k1, k2;      /* |k1| >= |k2| */
} shape;

/* Principal curvatures and one direction: height over the tangent plane of the vertex normal fitted
 * by a polynomial of degree 4 as in jet_fixture.h, three times with the normal of the fit. */
static shape principal(const lam_vec3 *x, lam_vec3 n, int m, int i, int j) {
  int c = i * m + j;
  double scale = lam_distance(x[c], x[c + 1]), r = 0, s = 0, t = 0;
  lam_vec3 a = {0, 0, 0}, b = a;
  for (int turn = 0; turn < 3; turn++) {
    a = lam_sub(x[c + m], x[c]);
    a = lam_unit(lam_along(a, -lam_dot(a, n), n));
    b = lam_cross(n, a);
    double A[jet_terms][jet_terms] = {{0}}, rhs[jet_terms] = {0};
    for (int di = -2; di <= 2; di++)
      for (int dj = -2; dj <= 2; dj++) {
        lam_vec3 d = lam_scale(lam_sub(x[c + di * m + dj], x[c]), 1 / scale);
        double u = lam_dot(d, a), v = lam_dot(d, b), w = lam_dot(d, n), row[jet_terms];
        int k = 0;
        for (int degree = 0; degree <= jet_degree; degree++)
          for (int q = 0; q <= degree; q++) row[k++] = pow(u, degree - q) * pow(v, q);
        for (int p = 0; p < jet_terms; p++) {
          rhs[p] += row[p] * w;
          for (int q = 0; q < jet_terms; q++) A[p][q] += row[p] * row[q];
        }
      }
    jet_solve(A, rhs);
    r = 2 * rhs[3], s = rhs[4], t = 2 * rhs[5];
    n = lam_unit(lam_along(lam_along(n, -rhs[1], a), -rhs[2], b));
  }
  double mean = (r + t) / 2, half = hypot((r - t) / 2, s), angle = atan2(2 * s, r - t) / 2;
  lam_vec3 high = lam_along(lam_scale(a, cos(angle)), sin(angle), b), low = lam_cross(n, high);
  bool first = fabs(mean + half) >= fabs(mean - half);
  return (shape){first ? high : low, (first ? mean + half : mean - half) / scale,
                 (first ? mean - half : mean + half) / scale};
}

/* The angle between the line halfway between the families and the nearer principal direction, in
 * degrees: the largest and the mean, `rows` rows from the border. */
static void off_symmetry(const solved *s, const lam_vec3 *x, int m, int rows, double *most,
                         double *mean) {
  double count = 0;
  *most = *mean = 0;
  for (int i = rows; i < m - rows; i++)
    for (int j = rows; j < m - rows; j++, count++) {
      int c = i * m + j;
      lam_vec3 u = lam_sub(lam_unit(lam_sub(x[c + m], x[c])), lam_unit(lam_sub(x[c - m], x[c])));
      lam_vec3 v = lam_sub(lam_unit(lam_sub(x[c + 1], x[c])), lam_unit(lam_sub(x[c - 1], x[c])));
      lam_vec3 halfway = lam_add(lam_unit(u), lam_unit(v));
      double angle =
          lam_angle(halfway, principal(x, s->normals[c], m, i, j).principal) * 180 / net_pi;
      angle = fmin(angle, 180 - angle);
      angle = fmin(angle, 90 - angle);
      *most = fmax(*most, angle);
      *mean += angle;
    }
  *mean /= count;
}

/* A height field on a grid turned by .3 against its principal directions: 35.04 degrees
 * off symmetry at most and 33.88 on average at the start, by an independent fit. A reference whose
 * guide kept the net twice as close to the start ended rippled, .85 degrees off at most and .14 on
 * average; a smooth net does better. */
static void principal_directions_halve_the_angles(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = case_mesh(f, "08_snet_principal_symmetric", 1);
  solved s = solve(f, &mesh, "s-net", "{}", "{}");
  must_converge(&s, "height field");
  double most, mean;
  off_symmetry(&s, s.start, 17, 2, &most, &mean);
  assert_near(most, 35.04, .01);
  assert_near(mean, 33.88, .01);
  off_symmetry(&s, s.net.mesh.vertices, 17, 2, &most, &mean);
  assert_below(most, .1);
  assert_below(mean, .02);
}

/* Planar faces and an angle of 75 degrees: k2 / k1 = tan^2(37.5 deg) = .5888 in the limit, .5925 +-
 * .0014 on this grid in the reference, which stays as close to the start; .414 +- .079 at the
 * start. A smoother net comes nearer. */
static void planar_and_isogonal_fix_the_curvature_ratio(void **state) {
  net_fixture *f = *state;
  static const char *const keys[2] = {"{solver: {closeness: 0.3}}", "{}"};
  static const double expected[2] = {.5925, .5910}, within[2] = {.001, .0022};
  lam_mesh mesh = case_mesh(f, "09_snet_planar_75deg", 1);
  for (int run = 0; run < 2; run++) {
    solved s = solve(f, &mesh, "s-net", "{planar: yes, angle: 75 deg}", keys[run]);
    must_converge(&s, "cap");
    double sum = 0, squares = 0, count = 0;
    for (int i = 3; i < 12; i++)
      for (int j = 3; j < 12; j++, count++) {
        shape k = principal(s.net.mesh.vertices, s.normals[15 * i + j], 15, i, j);
        sum += k.k2 / k.k1;
        squares += pow(k.k2 / k.k1, 2);
      }
    assert_near(sum / count, expected[run], within[run]);
    assert_below(sqrt(squares / count - sum * sum / count / count), .001);
    assert_below(measured(f, &s, "face_planarity").max, 1e-12);
  }
}

/* ---- the plane as a sphere ---- */

static double largest_distance(const lam_net *a, const lam_net *b) {
  double most = 0;
  for (int v = 0; v < a->mesh.vertex_count; v++)
    most = fmax(most, lam_distance(a->mesh.vertices[v], b->mesh.vertices[v]));
  return most;
}

/* Solves the constraint alone; positions in mean edges. */
static lam_net stars_of_radius(net_fixture *f, const lam_mesh *mesh, double radius) {
  lam_net net = net_built(f, mesh);
  double unit = lam_net_mean_edge(&net, mesh->vertices);
  for (int v = 0; v < mesh->vertex_count; v++)
    net.mesh.vertices[v] = lam_scale(net.mesh.vertices[v], 1 / unit);
  lam_problem *problem = lam_problem_new(f->arena, mesh->vertex_count, net.mesh.vertices);
  lam_scope scope = {.problem = problem, .net = &net, .unit = unit, .errors = &f->errors};
  lam_spherical_star_params params = {.radius = radius};
  lam_con_spherical_star.add(&scope, &params, 1, (lam_location){0});
  net_no_errors(f, "stars");
  lam_schedule schedule = lam_schedule_default();
  assert_true(lam_guided_solve(problem, &schedule, NULL).converged);
  lam_problem_positions(problem, net.mesh.vertices);
  return net;
}

/* A saddle: spheres of infinite radius are planes, and give the asymptotic net from the same start
 * up to the choice among many (both move as little as they can). Spheres of radius r join it as
 * 1/r. */
static void spheres_of_infinite_radius_are_planes(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = case_mesh(f, "12_anet_scherk", 1);
  lam_net flat = stars_of_radius(f, &mesh, INFINITY);
  assert_below(lam_net_measure_one(f->arena, &flat, flat.mesh.vertices, "star_planarity").max,
               1e-12);
  solved asymptotic = solve(f, &mesh, "asymptotic", "{border: no}", "{}");
  must_converge(&asymptotic, "asymptotic");
  assert_below(largest_distance(&flat, &asymptotic.net), .2 * asymptotic.result.drift);
  double before = 0;
  for (double radius = 1e2; radius < 2e6; radius *= 10) {
    lam_net near = stars_of_radius(f, &mesh, radius), other = stars_of_radius(f, &mesh, -radius);
    double distance = largest_distance(&near, &flat);
    assert_near(lam_net_measure_one(f->arena, &near, near.mesh.vertices, "star_curvature").mean,
                1 / radius, 1e-12);
    assert_near(lam_net_measure_one(f->arena, &other, other.mesh.vertices, "star_curvature").mean,
                -1 / radius, 1e-12);
    if (before > 0) assert_near(before / distance, 10, 2);
    before = distance;
  }
}

/* ---- wrong input ---- */

static void complains(net_fixture *f, const lam_mesh *mesh, const char *kind_name,
                      const char *params, const char *says) {
  lam_net net = net_built(f, mesh);
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, kind_name);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, "{}");
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, params),
                     .common = common};
  lam_net_result result;
  int before = f->errors.count;
  assert_false(lam_net_optimize(f->arena, &job, &net, &f->errors, &result));
  assert_int_equal(f->errors.count, before + 1);
  if (!strstr(f->errors.last->text, says)) fail_msg("%s: %s", params, f->errors.last->text);
}

static void contradictions_are_told(void **state) {
  static const struct {
    const char *kind, *params, *says;
  } rows[] = {{"cmc", "{radius: 400 mm}", "given 0.4 m; expected at least half the mean edge"},
              {"cmc", "{radius: -1 mm}", "given -0.001 m"},
              {"cmc", "{isogonal: no, angle: 70 deg}", "isogonal: no"},
              {"chebyshev", "{generalized: yes, length: 1 m}", "generalized: yes"}};
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 5, 6, net_saddle);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    complains(f, &mesh, rows[i].kind, rows[i].params, rows[i].says);
    f->errors = (lam_errors){.arena = f->arena};
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(mean_curvature_tends_to_the_radius),
      NET_TEST(rings_of_radius_two),
      NET_TEST(the_radius_has_a_sign),
      NET_TEST(the_border_keeps_the_radius),
      NET_TEST(constant_mean_curvature_without_rotation),
      NET_TEST(principal_directions_halve_the_angles),
      NET_TEST(planar_and_isogonal_fix_the_curvature_ratio),
      NET_TEST(spheres_of_infinite_radius_are_planes),
      NET_TEST(contradictions_are_told),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
