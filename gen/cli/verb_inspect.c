/* lamella inspect FILE: whether a triangle mesh is a valid solid, and its measures. Called by
 * main.c. */
#include "cli/arguments.h"
#include "cli/solid_facts.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"

#include <math.h>
#include <stdio.h>

static const char usage[] =
    "usage: lamella inspect FILE [--json]\n"
    "\n"
    "Says whether a triangle mesh is a valid solid, and measures it. STL files are read in "
    "millimeters, OBJ, OFF\n"
    "and PLY files in meters. Vertices at exactly the same place are merged first.\n"
    "\n"
    "  --json   the same as JSON, in SI units (m, m^2, m^3; inertia in m^5: xx, yy, zz, xy, yz, "
    "zx, density 1)\n"
    "  --help   this text\n"
    "\n"
    "exit code: 0 a valid solid; 1 open, not oriented or self-intersecting; 2 bad input";

/* ---- text ---- */

static const char *yes_or_no(bool value) { return value ? "yes" : "no"; }

static void print_point(const char *name, lam_vec3 p, double scale, const char *unit) {
  printf("%-20s %.6g %.6g %.6g %s\n", name, p.x * scale, p.y * scale, p.z * scale, unit);
}

/* How the triangles hang together. */
static void print_topology(const lam_solid_facts *f) {
  printf("%-20s %d\n%-20s %d\n", "triangles", f->triangles, "vertices", f->vertices);
  printf("%-20s %s", "closed", yes_or_no(f->closed));
  if (f->boundary_edges) printf(", %d boundary edges", f->boundary_edges);
  if (f->nonmanifold_edges) printf(", %d edges with more than two triangles", f->nonmanifold_edges);

  printf("\n%-20s %s\n%-20s %s\n", "oriented", yes_or_no(f->oriented), "manifold",
         yes_or_no(f->manifold));
  if (f->self_intersections < 0)
    printf("%-20s not counted: millions of its triangles lie over each other\n",
           "self-intersections");
  else
    printf("%-20s %ld\n", "self-intersections", f->self_intersections);
  printf("%-20s %d\n%-20s %d\n", "components", f->components, "Euler number", f->euler);
  if (f->genus >= 0)
    printf("%-20s %d\n", "genus", f->genus);
  else
    printf("%-20s -\n", "genus");
}

/* Lengths in millimeters for what is smaller than a meter, else in meters. */
static void print_measures(const lam_solid_facts *f) {
  lam_vec3 size = {f->max.x - f->min.x, f->max.y - f->min.y, f->max.z - f->min.z};
  bool small = sqrt(size.x * size.x + size.y * size.y + size.z * size.z) < 1;
  const char *unit = small ? "mm" : "m";
  double s = small ? 1000 : 1;

  printf("%-20s %.9g %s^3\n", "volume", f->volume * s * s * s, unit);
  printf("%-20s %.9g %s^2\n", "area", f->area * s * s, unit);
  print_point("centroid", f->centroid, s, unit);
  const double *inertia = f->inertia, s5 = s * s * s * s * s;
  printf("%-20s xx %.6g, yy %.6g, zz %.6g, xy %.6g, yz %.6g, zx %.6g %s^5\n", "inertia",
         inertia[0] * s5, inertia[1] * s5, inertia[2] * s5, inertia[3] * s5, inertia[4] * s5,
         inertia[5] * s5, unit);

  print_point("bounding box, from", f->min, s, unit);
  print_point("bounding box, to", f->max, s, unit);
  print_point("size", size, s, unit);
}

static void print_text(const lam_solid_facts *facts, bool valid) {
  print_topology(facts);
  print_measures(facts);
  printf("%-20s %s\n", "valid solid", yes_or_no(valid));
}

/* ---- JSON ---- */

/* The file and the verdict, then all facts. Returns the exit status. */
static int print_json(const char *path, const lam_solid_facts *facts, bool valid) {
  json_t *object = json_pack("{s:s,s:b}", "file", path, "valid", valid);
  json_t *measured = lam_facts_json(facts);
  json_object_update(object, measured);
  json_decref(measured);
  return lam_json_print(object, valid ? 0 : 1, 12);
}

/* ---- the verb ---- */

/* 0: a valid solid; 1: none; otherwise the status of a file that cannot be read. */
static int inspect(lam_session *session, int argc, char **argv) {
  const char *path;
  bool json = false;
  const lam_option table[] = {{"--json", .flag = &json}, {.name = NULL}};
  lam_arguments arguments = {usage, table, 1, 1, "a mesh file"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &path, &count);
  if (status >= 0) return status;

  lam_solid_facts facts;
  lam_status inspected = lam_inspect(session, path, true, &facts);
  if (inspected != LAM_OK) return lam_verb_status(session, inspected);

  bool valid = facts.closed && facts.oriented && facts.self_intersections == 0;
  if (json) return print_json(path, &facts, valid);
  print_text(&facts, valid);
  return valid ? 0 : 1;
}

int lam_verb_inspect(int argc, char **argv) { return lam_verb_run(inspect, argc, argv); }
