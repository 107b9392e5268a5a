/* lamella measure MESH.obj: independent measures of any quad mesh. */
#include "net/measure.h"
#include "cli/complain.h"
#include "cli/mesh_files.h"
#include "cli/report_table.h"
#include "cli/run.h"
#include "cli/verbs.h"
#include "net/kind.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: lamella measure MESH.obj [--as NET] [--angle DEGREES] [--json]\n"
    "  --as NET         only the measures that prove this kind of net (see lamella list nets)\n"
    "  --angle DEGREES  the crossing angle that angle_deviation is measured against (default: 90)\n"
    "  --json           prints JSON";

typedef struct arguments {
  const char *path, *as;
  double angle;
  bool json;
} arguments;

static int read_arguments(int argc, char **argv, arguments *out) {
  for (int i = 1; i < argc; i++) {
    const char *a = argv[i];
    if (strcmp(a, "--help") == 0) return puts(usage) < 0;
    if (strcmp(a, "--json") == 0)
      out->json = true;
    else if (strcmp(a, "--as") == 0 && i + 1 < argc)
      out->as = argv[++i];
    else if (strcmp(a, "--angle") == 0 && i + 1 < argc) {
      char *end;
      out->angle = strtod(argv[++i], &end);
      if (*end || end == argv[i] || !(out->angle > 0 && out->angle < 180))
        return lam_complain_plain(2, "measure: --angle %s; expected degrees between 0 and 180", argv[i]);
    } else if (a[0] == '-' || out->path)
      return lam_complain_plain(2, "measure: %s is not expected here\n%s", a, usage);
    else
      out->path = a;
  }
  return out->path ? -1 : lam_complain_plain(2, "measure: expected a mesh file\n%s", usage);
}

/* null: undefined, or not a number. */
static json_t *number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

static void print_json(const char *path, const lam_net *net, const lam_measure *measures, int count) {
  json_t *list = json_object();
  for (int i = 0; i < count; i++) {
    const lam_measure *m = &measures[i];
    json_object_set_new(list, m->name,
                        json_pack("{s:o, s:o, s:o, s:s, s:I}", "min", number(m->min), "mean", number(m->mean), "max",
                                  number(m->max), "unit", m->unit, "count", (json_int_t)m->count));
  }
  json_t *root = json_pack("{s:s, s:i, s:i, s:i, s:o}", "mesh", path, "vertices", net->mesh.vertex_count, "faces",
                           net->mesh.face_count, "irregular_vertices", net->irregular_count, "measures", list);
  json_dumpf(root, stdout, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
  putchar('\n');
  json_decref(root);
}

static int measure(lam_arena *arena, int argc, char **argv) {
  arguments given = {.angle = 90};
  lam_errors errors = {.arena = arena};
  int status = read_arguments(argc, argv, &given);
  if (status >= 0) return status;
  const lam_net_kind *kind = NULL;
  if (given.as && !(kind = (const lam_net_kind *)lam_registry_find(&lam_nets, given.as)))
    return lam_complain_plain(2, "measure: --as %s; expected a net of `lamella list nets`", given.as);
  lam_mesh mesh;
  lam_net net;
  if (!lam_input_mesh(arena, given.path, &errors, &mesh) ||
      !lam_net_build(arena, &mesh, (lam_place){.file = given.path}, &errors, &net))
    return lam_complain(&errors);
  int count;
  lam_measuring measuring = lam_measuring_of(arena, &net, net.mesh.vertices);
  measuring.target_angle = given.angle * M_PI / 180;
  lam_measure *measures = lam_net_measure(&measuring, kind ? kind->measures : NULL, &count);
  if (given.json) {
    print_json(given.path, &net, measures, count);
  } else {
    printf("%s: %d vertices, %d faces, %d boundary loops, %d irregular vertices\n", given.path, net.mesh.vertex_count,
           net.mesh.face_count, net.loop_count, net.irregular_count);
    lam_measures_print(measures, count, stdout);
  }
  return 0;
}

int lam_verb_measure(int argc, char **argv) { return lam_verb_run(measure, argc, argv); }
