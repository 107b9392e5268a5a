/* lamella measure MESH.obj: independent measures of any quad mesh. */
#include "cli/complain.h"
#include "cli/report_table.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "core/numbers.h"
#include "library/mesh_files.h"
#include "library/write_map.h"
#include "net/measures/measure.h"
#include "net/measures/measure_map.h"
#include "net/net_kind.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: lamella measure MESH.obj [--as NET] [--angle DEGREES] [--reference FILE] [--axis "
    "PX,PY,PZ,DX,DY,DZ]\n"
    "                       [--map MEASURE -o FILE] [--json]\n"
    "  --as NET          only the measures that prove this kind of net (see lamella list nets)\n"
    "  --angle DEGREES   the crossing angle that angle_deviation is measured against (default: "
    "90)\n"
    "  --reference FILE  a mesh (OBJ or STL) that distances are measured to\n"
    "  --axis NUMBERS    point (meters) and direction of the axis of a surface of revolution\n"
    "  --map MEASURE     draws a color map (see lamella list measures) into the file after -o: "
    ".svg, .png or .glb\n"
    "  --json            prints JSON";

typedef struct arguments {
  const char *path, *as, *reference, *map, *output, *angle_text, *axis_text;
  double angle, axis[6];
  bool json;
} arguments;

/* count numbers separated by commas, and nothing else. */
static bool read_numbers(const char *text, int count, double *numbers) {
  for (int i = 0; i < count; i++) {
    char *end;
    numbers[i] = strtod(text, &end);
    if (end == text || !isfinite(numbers[i]) || *end != (i + 1 < count ? ',' : 0)) return false;
    text = end + 1;
  }
  return true;
}

static int check_arguments(arguments *out) {
  if (out->angle_text &&
      (!read_numbers(out->angle_text, 1, &out->angle) || !(out->angle > 0 && out->angle < 180)))
    return lam_complain_plain(2, "measure: --angle %s; expected degrees between 0 and 180",
                              out->angle_text);
  const double *d = out->axis + 3;
  if (out->axis_text &&
      (!read_numbers(out->axis_text, 6, out->axis) || !(hypot(hypot(d[0], d[1]), d[2]) > 0)))
    return lam_complain_plain(
        2, "measure: --axis %s; expected six numbers: a point and a direction, PX,PY,PZ,DX,DY,DZ",
        out->axis_text);
  if (!out->map != !out->output)
    return lam_complain_plain(2, "measure: --map MEASURE and -o FILE are given together\n%s",
                              usage);
  return out->path ? -1 : lam_complain_plain(2, "measure: expected a mesh file\n%s", usage);
}

static int read_arguments(int argc, char **argv, arguments *out) {
  const struct {
    const char *name, **value;
  } options[] = {
      {"--as", &out->as},   {"--angle", &out->angle_text}, {"--reference", &out->reference},
      {"--map", &out->map}, {"--axis", &out->axis_text},   {"-o", &out->output}};
  for (int i = 1; i < argc; i++) {
    const char *a = argv[i], **value = NULL;
    if (strcmp(a, "--help") == 0) return puts(usage) < 0;
    for (size_t k = 0; k < sizeof options / sizeof *options; k++)
      if (strcmp(a, options[k].name) == 0) value = options[k].value;
    if (value && i + 1 < argc)
      *value = argv[++i];
    else if (strcmp(a, "--json") == 0)
      out->json = true;
    else if (value)
      return lam_complain_plain(2, "measure: %s needs a value\n%s", a, usage);
    else if (a[0] == '-' || out->path)
      return lam_complain_plain(2, "measure: %s is not expected here\n%s", a, usage);
    else
      out->path = a;
  }
  return check_arguments(out);
}

/* null: undefined, or not a number. */
static json_t *number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

static void print_json(const char *path, const lam_net *net, const lam_measure *measures,
                       int count) {
  json_t *list = json_object();
  for (int i = 0; i < count; i++) {
    const lam_measure *m = &measures[i];
    json_object_set_new(list, m->name,
                        json_pack("{s:o, s:o, s:o, s:s, s:I}", "min", number(m->min), "mean",
                                  number(m->mean), "max", number(m->max), "unit", m->unit, "count",
                                  (json_int_t)m->count));
  }
  json_t *root = json_pack("{s:s, s:i, s:i, s:i, s:o}", "mesh", path, "vertices",
                           net->mesh.vertex_count, "faces", net->mesh.face_count,
                           "irregular_vertices", net->irregular_count, "measures", list);
  json_dumpf(root, stdout, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
  putchar('\n');
  json_decref(root);
}

/* What measures need beside the net. The reference's tree is closed with the arena. */
static bool prepare(const arguments *given, lam_measuring *in, lam_errors *errors) {
  in->target_angle = given->angle * LAM_PI / 180;
  if (given->axis_text) in->axis = given->axis;
  if (!given->reference) return true;
  lam_trimesh *mesh = LAM_NEW(in->arena, lam_trimesh, 1);
  if (!lam_input_triangles(in->arena, given->reference, errors, mesh)) return false;
  lam_tree *tree = lam_tree_new(mesh);
  if (!tree) {
    lam_error_add(errors, (lam_location){.file = given->reference}, NULL,
                  "the mesh cannot be searched; it has no valid "
                  "triangle");
    return false;
  }
  lam_arena_defer(in->arena, lam_tree_free, tree);
  in->reference = tree;
  in->reference_mesh = mesh;
  return true;
}

static lam_status write_map(const arguments *given, const lam_measuring *in, lam_errors *errors) {
  const char *slash = strrchr(given->path, '/');
  lam_map map = lam_net_map(in, lam_measure_find(given->map));
  const char *file = slash ? slash + 1 : given->path, *dot = strrchr(file, '.');
  const char *name =
      lam_arena_printf(in->arena, "%.*s", (int)(dot ? dot - file : (long)strlen(file)), file);
  lam_model model = {.name = name, .net = &in->net->mesh, .map_count = 1, .maps = &map};
  return lam_measure_map_write(&model, given->output, errors);
}

static int measure(lam_arena *arena, int argc, char **argv) {
  arguments given = {.angle = 90};
  lam_errors errors = {.arena = arena};
  int status = read_arguments(argc, argv, &given);
  if (status >= 0) return status;
  const lam_net_kind *kind = NULL;
  if (given.as && !(kind = (const lam_net_kind *)lam_registry_find(&lam_nets, given.as)))
    return lam_complain_plain(2, "measure: --as %s; expected a net of `lamella list nets`",
                              given.as);
  if (given.map && (!lam_measure_named(given.map, true, (lam_location){0}, "--map", &errors) ||
                    !lam_measure_map_check(given.output, &errors)))
    return lam_complain(&errors);
  lam_mesh mesh;
  lam_net net;
  if (!lam_input_mesh(arena, given.path, &errors, &mesh) ||
      !lam_net_build(arena, &mesh, (lam_location){.file = given.path}, &errors, &net))
    return lam_complain(&errors);
  int count;
  lam_measuring measuring = lam_measuring_of(arena, &net, net.mesh.vertices);
  if (!prepare(&given, &measuring, &errors)) return lam_complain(&errors);
  if (given.map && write_map(&given, &measuring, &errors) != LAM_OK) {
    lam_complain(&errors);
    return 1;
  }
  lam_measure *measures = lam_net_measure(&measuring, kind ? kind->measures : NULL, &count);
  if (given.json) {
    print_json(given.path, &net, measures, count);
  } else {
    printf("%s: %d vertices, %d faces, %d boundary loops, %d irregular vertices\n", given.path,
           net.mesh.vertex_count, net.mesh.face_count, net.loop_count, net.irregular_count);
    lam_measures_print(measures, count, stdout);
  }
  return 0;
}

int lam_verb_measure(int argc, char **argv) { return lam_verb_run(measure, argc, argv); }
