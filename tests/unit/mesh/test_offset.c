/* Offsets of circular and conical nets, and Gauss images. Limits are ten times what reference
 * solutions reached (mirrored normals path-independent to 5e-12, vertex offset circular to 9e-13,
 * axes coplanar to 3e-12, Gauss image circular to 2e-10). */
#include "mesh/offset.h"
#include "net/optimize.h"
#include "net_fixture.h"

static lam_net solved(net_fixture *f, const char *name, const char *kind_name) {
  lam_mesh mesh = net_obj(f->arena, name);
  lam_net net = net_built(f, &mesh);
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, kind_name);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, "{from: {file: x}}");
  lam_net_job job = {.kind = kind, .common = common};
  lam_net_result result;
  assert_true(lam_net_optimize(f->arena, &job, &net, &f->errors, &result));
  assert_true(result.converged);
  return net;
}

static const char *const starts[] = {"tests/cases/nets/28_circular_ellipsoid_init.obj",
                                     "tests/cases/nets/29_conical_bump_init.obj"};

static double worst(net_fixture *f, const lam_net *net, const lam_vec3 *x, const char *name) {
  return lam_net_measure_one(f->arena, net, x, name).max;
}

/* All vertices at distance d, edges parallel, faces circular again; d of both signs. */
static void vertex_offset_of_a_circular_net(void **state) {
  net_fixture *f = *state;
  for (int s = 0; s < 2; s++) {
    lam_net net = solved(f, starts[s], "circular");
    int n = net.mesh.vertex_count;
    const lam_vec3 *x = net.mesh.vertices;
    lam_vec3 *normals = LAM_NEW(f->arena, lam_vec3, n), *y = LAM_NEW(f->arena, lam_vec3, n);
    lam_vec3 *smooth = LAM_NEW(f->arena, lam_vec3, n);
    assert_below(lam_net_mirrored_normals(f->arena, &net, x, normals), 5e-11);
    lam_net_normals(&net, x, smooth);
    for (int v = 0; v < n;
         v++) { /* the normals of a curvature line net: near those of the surface */
      assert_near(lam_length(normals[v]), 1, 1e-14);
      assert_below(lam_angle(normals[v], smooth[v]), .3);
    }
    for (double d = -.5; d <= .5; d += .25) {
      lam_net_offset(&net, x, normals, d, y);
      assert_below(worst(f, &net, y, "face_planarity"), 9e-12);
      assert_below(worst(f, &net, y, "circularity"), 9e-12);
      for (int e = 0; e < net.edge_count; e++) {
        const int *v = net.edges[e].vertex;
        lam_vec3 before = lam_unit(lam_sub(x[v[1]], x[v[0]])),
                 after = lam_unit(lam_sub(y[v[1]], y[v[0]]));
        assert_below(lam_length(lam_cross(before, after)), 5e-11);
        assert_below(lam_net_edge_twist(&net, x, normals, e), 5e-11);
      }
      for (int v = 0; v < n; v++) assert_near(lam_distance(x[v], y[v]), fabs(d), 1e-14);
    }
    /* the Gauss image: the same connectivity on the unit sphere */
    assert_below(worst(f, &net, normals, "circularity"), 5e-10);
  }
}

static bool is_inner(const lam_net *net, int edge) {
  return !net->boundary[net->edges[edge].vertex[0]] && !net->boundary[net->edges[edge].vertex[1]];
}

/* Every face plane moves by exactly d; the offset is conical with the same axes; neighboring axes
 * lie in a plane. */
static void face_offset_of_a_conical_net(void **state) {
  net_fixture *f = *state;
  for (int s = 0; s < 2; s++) {
    lam_net net = solved(f, starts[s], "conical");
    int n = net.mesh.vertex_count, faces = net.mesh.face_count;
    const lam_vec3 *x = net.mesh.vertices;
    lam_vec3 *axes = LAM_NEW(f->arena, lam_vec3, n), *again = LAM_NEW(f->arena, lam_vec3, n);
    lam_vec3 *y = LAM_NEW(f->arena, lam_vec3, n), *normals = LAM_NEW(f->arena, lam_vec3, faces);
    double limit = 1e-12, d = .4;
    assert_below(lam_net_cone_axes(f->arena, &net, x, axes), limit);
    lam_net_face_normals(&net, x, normals);
    lam_net_offset(&net, x, axes, d, y);
    for (int i = 0; i < faces; i++)
      for (int k = 0; k < 4; k++) {
        int v = net.mesh.faces[i][k];
        assert_near(lam_dot(normals[i], lam_sub(y[v], x[v])), d, limit);
      }
    assert_below(worst(f, &net, y, "face_planarity"), 9e-12);
    assert_below(worst(f, &net, y, "conicality"), 1e-8);
    for (int e = 0; e < net.edge_count; e++)
      if (is_inner(&net, e)) assert_below(lam_net_edge_twist(&net, x, axes, e), 3e-11);
    lam_net_cone_axes(f->arena, &net, y, again);
    for (int v = 0; v < n; v++) {
      assert_true(lam_length(axes[v]) >= 1 - 1e-14);
      if (!net.boundary[v]) assert_below(lam_distance(axes[v], again[v]), 1e-8);
    }
  }
}

static void gauss_image_of_a_conical_net(void **state) {
  net_fixture *f = *state;
  for (int s = 0; s < 2; s++) {
    lam_net net = solved(f, starts[s], "conical");
    int *vertex = LAM_NEW(f->arena, int, net.mesh.face_count);
    lam_vec3 *normals = LAM_NEW(f->arena, lam_vec3, net.mesh.face_count);
    lam_mesh image = lam_net_gauss_image(f->arena, &net, net.mesh.vertices, vertex);
    assert_int_equal(image.vertex_count,
                     14 * 14); /* every face of 15 x 15 vertices is at an inner vertex */
    assert_int_equal(image.face_count, 13 * 13);
    lam_net_face_normals(&net, net.mesh.vertices, normals);
    for (int i = 0; i < net.mesh.face_count; i++)
      assert_true(lam_distance(image.vertices[vertex[i]], normals[i]) == 0);
    lam_net dual = net_built(f, &image);
    assert_below(worst(f, &dual, image.vertices, "circularity"), 2e-9);
    /* four points of a sphere on a circle lie in a plane, too */
    assert_below(worst(f, &dual, image.vertices, "face_planarity"), 2e-9);
  }
}

/* What is not a curvature line net has no such offsets: on the bump itself the normals depend on
 * the way, no vertex is the tip of a cone, and the Gauss image is not circular. */
static void other_nets_are_told_apart(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_obj(f->arena, starts[1]);
  lam_net net = net_built(f, &mesh);
  lam_vec3 *out = LAM_NEW(f->arena, lam_vec3, mesh.vertex_count);
  assert_below(1e-2, lam_net_mirrored_normals(f->arena, &net, mesh.vertices, out));
  assert_below(1e-4, lam_net_cone_axes(f->arena, &net, mesh.vertices, out));
  lam_mesh image = lam_net_gauss_image(f->arena, &net, mesh.vertices, NULL);
  lam_net dual = net_built(f, &image);
  assert_below(1e-2, worst(f, &dual, image.vertices, "circularity"));
}

/* A prism of n sides: at the mid ring, axes point outward and have the length 1 / cos(pi / n), the
 * faces' distance growing by
 * 1. A plane: axes are its normal. Around a cube's corner: the diagonal (1, 1, 1). */
static void axes_in_closed_form(void **state) {
  net_fixture *f = *state;
  enum { n = 7 };
  lam_vec3 axes[4 * n];
  lam_mesh prism = lam_mesh_grid(f->arena, n, 3, true, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 3; j++)
      prism.vertices[3 * i + j] = lam_v3(cos(2 * net_pi * i / n), sin(2 * net_pi * i / n), j);
  lam_net net = net_built(f, &prism);
  assert_below(lam_net_cone_axes(f->arena, &net, prism.vertices, axes), 1e-15);
  for (int v = 0; v < 3 * n; v++) {
    lam_vec3 x = prism.vertices[v];
    assert_near(lam_distance(axes[v], lam_scale(lam_v3(x.x, x.y, 0), 1 / cos(net_pi / n))), 0,
                1e-14);
  }
  assert_below(lam_net_mirrored_normals(f->arena, &net, prism.vertices, axes), 1e-14);
  for (int v = 0; v < 3 * n; v++) {
    lam_vec3 x = prism.vertices[v];
    assert_near(lam_distance(axes[v], lam_v3(x.x, x.y, 0)), 0, 1e-14);
  }
  lam_mesh plane = net_grid(f->arena, 4, 4, net_plane), cube = net_cube(f->arena);
  net = net_built(f, &plane);
  lam_net_cone_axes(f->arena, &net, plane.vertices, axes);
  for (int v = 0; v < 16; v++) assert_near(lam_distance(axes[v], lam_v3(0, 0, 1)), 0, 1e-15);
  net = net_built(f, &cube);
  assert_below(lam_net_cone_axes(f->arena, &net, cube.vertices, axes), 1e-15);
  for (int v = 0; v < 8; v++) assert_near(lam_distance(axes[v], cube.vertices[v]), 0, 1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(vertex_offset_of_a_circular_net),
      NET_TEST(face_offset_of_a_conical_net),
      NET_TEST(gauss_image_of_a_conical_net),
      NET_TEST(other_nets_are_told_apart),
      NET_TEST(axes_in_closed_form),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
