/* Nets from arrays are measured: against an angle, an axis, a mesh; all measures or those of a
 * kind. Includes the public headers alone. */
#include <lamella/lamella.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* A tent of 2 x 2 unit cells, its middle 1/2 high. */
static lam_vec3 vertices[9];
static int faces[4][4];
static lam_mesh tent(void) {
  for (int v = 0; v < 9; v++) vertices[v] = (lam_vec3){v / 3, v % 3, v == 4 ? .5 : 0};
  for (int f = 0; f < 4; f++) {
    int corner = f / 2 * 3 + f % 2;
    const int face[4] = {corner, corner + 3, corner + 4, corner + 1};
    memcpy(faces[f], face, sizeof face);
  }
  return (lam_mesh){9, vertices, 4, faces};
}

static int set_up(void **state) { return lam_session_new((lam_session **)state); }
static int tear_down(void **state) {
  lam_session_free(*state);
  return 0;
}

static lam_measured measured(lam_session *session, const lam_measure_task *task) {
  lam_measured out;
  if (lam_measure_net(session, task, &out) != LAM_OK)
    fail_msg("%s", lam_session_messages(session)->text);
  return out;
}

static void assert_measure(const lam_measured *all, const char *name, long count, double max) {
  for (int i = 0; i < all->measure_count; i++) {
    const lam_measure *m = &all->measures[i];
    if (strcmp(m->name, name) != 0) continue;
    if (m->count != count || (count && !(fabs(m->max - max) <= 1e-13)))
      fail_msg("%s is %.17g on %ld, expected %.17g on %ld", name, m->max, m->count, max, count);
    return;
  }
  fail_msg("no measure %s", name);
}

/* The families cross at 90 degrees over the middle, and turn by 2 atan(1/2) there. Without an axis
 * and a mesh their measures are undefined. */
static void measures_without_anything_beside(void **state) {
  lam_mesh mesh = tent();
  lam_measured all = measured(*state, &(lam_measure_task){.mesh = &mesh});
  assert_int_equal(all.boundary_loops, 1);
  assert_int_equal(all.irregular_vertices, 0);
  assert_int_equal(all.measure_count, 53); /* all but the three slow ones */
  assert_measure(&all, "angle_deviation", 1, 0);
  assert_measure(&all, "turning_angle", 1, 2 * atan(.5) * 180 / acos(-1));
  assert_measure(&all, "edge_length", 12, sqrt(1.25));
  assert_measure(&all, "clairaut_u", 0, 0);
  assert_measure(&all, "distance_to_reference", 0, 0);
}

/* Against 60 degrees; over the square z = 0, which the middle is 1/2 above; about an axis, where a
 * single inner vertex has no spread. */
static void measures_against_an_angle_a_mesh_and_an_axis(void **state) {
  lam_mesh mesh = tent();
  lam_vec3 corners[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  lam_trimesh square = {4, corners, 2, triangles};
  static const double axis[6] = {0, 0, 0, 0, 0, 2};
  lam_measured all = measured(
      *state, &(lam_measure_task){
                  .mesh = &mesh, .angle = acos(-1) / 3, .reference = &square, .axis = axis});
  assert_measure(&all, "angle_deviation", 1, 30);
  assert_measure(&all, "crossing_angle", 1, 90);
  assert_measure(&all, "distance_to_reference", 9, .5);
  assert_measure(&all, "clairaut_u", 1, 0);
  assert_measure(&all, "clairaut_v", 1, 0);
}

/* The measures that prove a kind are fewer, with its own among them. */
static void measures_of_a_kind(void **state) {
  lam_mesh mesh = tent();
  lam_measured all = measured(*state, &(lam_measure_task){.mesh = &mesh, .as = "asymptotic"});
  assert_true(all.measure_count < 20);
  assert_measure(&all, "star_planarity", 1, .4 / sqrt(1.25)); /* .1 or .4 off the plane z = .1 */
}

static void mistakes_have_the_name_of_the_option(void **state) {
  lam_session *session = *state;
  lam_mesh mesh = tent();
  lam_measured out;
  lam_measure_task task = {.mesh = &mesh, .as = "nothing", .map = "edge_length", .map_path = "x"};
  assert_int_equal(lam_measure_task_check(session, &task), LAM_BAD_INPUT);
  const lam_error *first = lam_session_messages(session);
  assert_string_equal(first->key, "--as");
  assert_string_equal(first->text, "nothing; expected a net of `lamella list nets`");
  assert_string_equal(first->next->key, "-o");
  assert_null(first->next->next);
  assert_int_equal(lam_measure_net(session, &task, &out), LAM_BAD_INPUT);
  assert_int_equal(out.measure_count, 0);

  lam_vec3 point[3] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  int triangle[1][3] = {{0, 1, 2}};
  lam_trimesh empty = {3, point, 1, triangle};
  task = (lam_measure_task){.mesh = &mesh, .reference = &empty};
  assert_int_equal(lam_measure_task_check(session, &task), LAM_OK);
  assert_int_equal(lam_measure_net(session, &task, &out), LAM_BAD_INPUT);
  assert_string_equal(lam_session_messages(session)->key, "--reference");
  faces[0][1] = 9;
  task = (lam_measure_task){.mesh = &mesh, .name = "tent.obj"};
  assert_int_equal(lam_measure_net(session, &task, &out), LAM_BAD_INPUT);
  assert_string_equal(lam_session_messages(session)->location.file, "tent.obj");
}

int main(void) {
#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)
  const struct CMUnitTest tests[] = {
      TEST(measures_without_anything_beside),
      TEST(measures_against_an_angle_a_mesh_and_an_axis),
      TEST(measures_of_a_kind),
      TEST(mistakes_have_the_name_of_the_option),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
