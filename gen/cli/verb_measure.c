/* lamella measure MESH.obj: independent measures of any quad mesh. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/report_table.h"
#include "cli/solid_facts.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/format.h>
#include <lamella/net.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: lamella measure MESH [--as NET] [--angle DEGREES] [--reference FILE] "
    "[--axis PX,PY,PZ,DX,DY,DZ]\n"
    "                       [--map MEASURE -o FILE] [--json]\n"
    "  --as NET          only the measures that prove this kind of net (see lamella list nets)\n"
    "  --angle DEGREES   the crossing angle that angle_deviation is measured against "
    "(default: 90)\n"
    "  --reference FILE  a mesh (OBJ, OFF, PLY or STL) that distances are measured to\n"
    "  --axis NUMBERS    point (meters) and direction of the axis of a surface of revolution\n"
    "  --map MEASURE     draws a color map (see lamella list measures) into the file after "
    "-o: .svg, .png or .glb\n"
    "  --json            prints JSON";

/* ---- options ---- */

/* Reads count numbers separated by commas. False: text is anything else. */
static bool read_numbers(const char *text, int count, double *numbers) {
  for (int i = 0; i < count; i++) {
    char *end;
    numbers[i] = strtod(text, &end);
    if (end == text || !isfinite(numbers[i]) || *end != (i + 1 < count ? ',' : 0)) return false;
    text = end + 1;
  }
  return true;
}

/* Puts the angle (degrees; NULL: 90) and the axis (six numbers; NULL: none) into the task, the
 * latter by pointer to numbers. Returns -1, or the exit status after a complaint. */
static int read_options(const char *angle, const char *axis, double numbers[6],
                        lam_measure_task *task) {
  double degrees = 90;
  if (angle && (!read_numbers(angle, 1, &degrees) || !(degrees > 0 && degrees < 180)))
    return lam_complain_plain(2, "measure: --angle %s; expected degrees between 0 and 180", angle);
  task->angle = degrees * M_PI / 180;

  const double *d = numbers + 3;
  if (axis && (!read_numbers(axis, 6, numbers) || !(hypot(hypot(d[0], d[1]), d[2]) > 0)))
    return lam_complain_plain(
        2, "measure: --axis %s; expected six numbers: a point and a direction, PX,PY,PZ,DX,DY,DZ",
        axis);
  if (axis) task->axis = numbers;

  if (!task->map != !task->map_path)
    return lam_complain_plain(2, "measure: --map MEASURE and -o FILE are given together\n%s",
                              usage);
  return -1;
}

/* ---- results ---- */

/* null: undefined, or not a number. */
static json_t *number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

/* As in report.json (formats/tables/report.c): a count has one value. */
static json_t *measure_entry(const lam_measure *m) {
  if (strcmp(m->unit, LAM_UNIT_COUNT) == 0)
    return json_pack("{s:o, s:s}", "value",
                     isfinite(m->max) ? json_integer((json_int_t)m->max) : json_null(), "unit",
                     m->unit);
  return json_pack("{s:o, s:o, s:o, s:s, s:I}", "min", number(m->min), "mean", number(m->mean),
                   "max", number(m->max), "unit", m->unit, "count", (json_int_t)m->count);
}

/* The measures by name, beside a few facts of the mesh. Returns the exit status. */
static int print_json(const lam_measure_task *task, const lam_measured *measured) {
  json_t *list = json_object();
  for (int i = 0; i < measured->measure_count; i++) {
    const lam_measure *m = &measured->measures[i];
    json_object_set_new(list, m->name, measure_entry(m));
  }

  json_t *root = json_pack("{s:s, s:i, s:i, s:i, s:o}", "mesh", task->name, "vertices",
                           task->mesh->vertex_count, "faces", task->mesh->face_count,
                           "irregular_vertices", measured->irregular_vertices, "measures", list);
  return lam_json_print(root, 0, 9);
}

/* A line about the mesh, then the measures. */
static void print_text(const lam_measure_task *task, const lam_measured *measured) {
  printf("%s: %d vertices, %d faces, %d boundary loops, %d irregular vertices\n", task->name,
         task->mesh->vertex_count, task->mesh->face_count, measured->boundary_loops,
         measured->irregular_vertices);
  lam_measures_print(measured->measures, measured->measure_count, stdout);
}

/* ---- the verb ---- */

/* Reads the meshes of the task, whose names are checked first; reference: a file, or NULL. */
static lam_status read_meshes(lam_session *session, const char *reference, lam_mesh *mesh,
                              lam_trimesh *triangles, lam_measure_task *task) {
  task->reference_name = reference;
  lam_status status = lam_measure_task_check(session, task);
  if (status == LAM_OK) status = lam_read_mesh(session, task->name, mesh);
  task->mesh = mesh;
  for (const lam_error *note = lam_session_notes(session); note; note = note->next)
    lam_complain_plain(0, "%s: %s", task->name, note->text);
  if (status != LAM_OK || !reference) return status;

  task->reference = triangles;
  return lam_read_triangles(session, reference, triangles);
}

/* Reads the meshes of the task and measures. A map that cannot be written is status 1. */
static int run_task(lam_session *session, lam_measure_task *task, const char *reference,
                    bool json) {
  lam_mesh mesh;
  lam_trimesh triangles;
  lam_measured measured;
  lam_status status = read_meshes(session, reference, &mesh, &triangles, task);
  if (status != LAM_OK) return lam_verb_status(session, status);

  status = lam_measure_net(session, task, &measured);
  if (status == LAM_IO) return lam_complain(session), 1;
  if (status != LAM_OK) return lam_verb_status(session, status);

  if (json) return print_json(task, &measured);
  print_text(task, &measured);
  return 0;
}

/* The name of the mesh is its file. */
static int measure(lam_session *session, int argc, char **argv) {
  const char *reference = NULL, *angle = NULL, *axis = NULL;
  double numbers[6];
  bool json = false;
  lam_measure_task task = {0};
  const lam_option table[] = {{"--as", .value = &task.as},
                              {"--angle", .value = &angle},
                              {"--reference", .value = &reference},
                              {"--map", .value = &task.map},
                              {"--axis", .value = &axis},
                              {"-o", .value = &task.map_path},
                              {"--json", .flag = &json},
                              {.name = NULL}};

  lam_arguments arguments = {usage, table, 1, 1, "a mesh file"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &task.name, &count);
  if (status < 0) status = read_options(angle, axis, numbers, &task);
  return status >= 0 ? status : run_task(session, &task, reference, json);
}

int lam_verb_measure(int argc, char **argv) { return lam_verb_run(measure, argc, argv); }
