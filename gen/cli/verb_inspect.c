#include "cli/mesh_input.h"
#include "cli/verbs.h"

#include <getopt.h>
#include <stdio.h>

static const char help[] =
    "usage: lamella inspect FILE.stl|FILE.obj [--json]\n"
    "\n"
    "Says whether a triangle mesh is a valid solid, and measures it. STL files are read in "
    "millimeters, OBJ files in\n"
    "meters. Vertices at exactly the same place are merged first.\n"
    "\n"
    "  --json   the same as JSON, in SI units (m, m^2, m^3; inertia in m^5: xx, yy, zz, xy, yz, "
    "zx, density 1)\n"
    "  --help   this text\n"
    "\n"
    "exit code: 0 a valid solid; 1 open, not oriented or self-intersecting; 2 bad input\n";

static void print_point(const char *name, lam_vec3 p, double scale, const char *unit) {
  printf("%-20s %.6g %.6g %.6g %s\n", name, p.x * scale, p.y * scale, p.z * scale, unit);
}

/* Lengths in millimeters for what is smaller than a meter, else in meters. */
static void print_facts(const lam_solid_facts *f) {
  bool small = lam_distance(f->min, f->max) < 1;
  const char *unit = small ? "mm" : "m";
  double s = small ? 1000 : 1;
  printf("%-20s %d\n%-20s %d\n", "triangles", f->triangles, "vertices", f->vertices);
  printf("%-20s %s", "closed", f->closed ? "yes" : "no");
  if (f->boundary_edges) printf(", %d boundary edges", f->boundary_edges);
  if (f->nonmanifold_edges) printf(", %d edges with more than two triangles", f->nonmanifold_edges);
  printf("\n%-20s %s\n%-20s %s\n", "oriented", f->oriented ? "yes" : "no", "manifold",
         f->manifold ? "yes" : "no");
  printf("%-20s %ld\n", "self-intersections", f->self_intersections);
  printf("%-20s %d\n%-20s %d\n", "components", f->components, "Euler number", f->euler);
  if (f->genus >= 0)
    printf("%-20s %d\n", "genus", f->genus);
  else
    printf("%-20s -\n", "genus");
  printf("%-20s %.9g %s^3\n", "volume", f->volume * s * s * s, unit);
  printf("%-20s %.9g %s^2\n", "area", f->area * s * s, unit);
  print_point("centroid", f->centroid, s, unit);
  const double *inertia = f->inertia, s5 = s * s * s * s * s;
  printf("%-20s xx %.6g, yy %.6g, zz %.6g, xy %.6g, yz %.6g, zx %.6g %s^5\n", "inertia",
         inertia[0] * s5, inertia[1] * s5, inertia[2] * s5, inertia[3] * s5, inertia[4] * s5,
         inertia[5] * s5, unit);
  print_point("bounding box, from", f->min, s, unit);
  print_point("bounding box, to", f->max, s, unit);
  print_point("size", lam_sub(f->max, f->min), s, unit);
}

static int inspect(lam_arena *arena, const char *path, bool json) {
  lam_errors errors = {.arena = arena};
  lam_trimesh mesh;
  lam_solid_facts facts;
  if (!lam_mesh_input(arena, path, true, &errors, &mesh, &facts)) {
    lam_verb_errors("inspect", &errors);
    return 2;
  }
  bool valid = facts.closed && facts.oriented && facts.self_intersections == 0;
  if (json) {
    json_t *object = json_pack("{s:s,s:b}", "file", path, "valid", valid);
    json_t *measured = lam_facts_json(&facts);
    json_object_update(object, measured);
    json_decref(measured);
    lam_json_print(object);
  } else {
    print_facts(&facts);
    printf("%-20s %s\n", "valid solid", valid ? "yes" : "no");
  }
  return valid ? 0 : 1;
}

/* Above every character, so that getopt_long's optopt tells short options from long ones. */
enum { option_json = 256, option_help };

int lam_verb_inspect(int argc, char **argv) {
  static const struct option options[] = {{"json", no_argument, NULL, option_json},
                                          {"help", no_argument, NULL, option_help},
                                          {NULL, 0, NULL, 0}};
  bool json = false;
  opterr = optind = 0;
  for (int result; (result = getopt_long(argc, argv, ":", options, NULL)) != -1;) {
    if (result == option_help) return fputs(help, stdout) < 0 ? 2 : 0;
    if (result != option_json) return lam_verb_option_error(argv, result);
    json = true;
  }
  if (argc - optind != 1)
    return lam_verb_error(argv[0], "%d files given, 1 expected (see --help)", argc - optind);
  lam_arena *arena = lam_arena_new();
  if (!arena) return lam_verb_error(argv[0], "out of memory");
  int code = LAM_ARENA_TRY(arena) ? inspect(arena, argv[optind], json)
                                  : lam_verb_error(argv[0], "out of memory");
  lam_arena_free(arena);
  return code;
}
