#include "cli/mesh_input.h"

#include "core/file.h"
#include "core/solid/triangles.h"
#include "formats/format.h"
#include <getopt.h>
#include <stdarg.h>
#include <stdio.h>

enum { largest_file = 1 << 30 };

void lam_verb_errors(const char *verb, const lam_errors *errors) {
  for (const lam_error *e = errors->first; e; e = e->next) {
    fprintf(stderr, "lamella %s: ", verb);
    if (e->location.file) fprintf(stderr, "%s:", e->location.file);
    if (e->location.line) fprintf(stderr, "%d:", e->location.line);
    fprintf(stderr, "%s%s\n", e->location.file || e->location.line ? " " : "", e->text);
  }
}

int lam_verb_error(const char *verb, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "lamella %s: ", verb);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
  va_end(arguments);
  return 2;
}

int lam_verb_option_error(char **argv, int result) {
  const char *what = result == ':' ? "needs a value" : "is not a known option, or takes no value";
  if (optopt > 0 && optopt < 256)
    return lam_verb_error(argv[0], "-%c %s (see --help)", optopt, what);
  return lam_verb_error(argv[0], "%s %s (see --help)", argv[optind - 1], what);
}

bool lam_mesh_input(lam_arena *arena, const char *path, bool self_intersections, lam_errors *errors,
                    lam_trimesh *mesh, lam_solid_facts *facts) {
  lam_location location = {.file = path};
  const lam_format *format = lam_format_for(path);
  if (!format || !format->read_triangles) {
    lam_error_add(errors, location, NULL, "is not a mesh file (.stl or .obj expected)");
    return false;
  }
  char *bytes;
  size_t count;
  if (lam_file_read(arena, path, largest_file, errors, &bytes, &count) != LAM_OK) return false;
  lam_trimesh loose;
  if (!format->read_triangles(arena, bytes, count, location, errors, &loose)) return false;
  *mesh = lam_trimesh_weld(arena, &loose, 0);
  if (!mesh->triangle_count) {
    lam_error_add(errors, location, NULL, "has no triangles with three different corners");
    return false;
  }
  lam_status status = lam_solid_measure(mesh, self_intersections, facts);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(arena);
  if (status != LAM_OK) lam_error_add(errors, location, NULL, "the mesh cannot be measured");
  return status == LAM_OK;
}

static json_t *point(lam_vec3 p) { return json_pack("[f,f,f]", p.x, p.y, p.z); }

json_t *lam_facts_json(const lam_solid_facts *f) {
  json_t *object =
      json_pack("{s:i,s:i,s:b,s:b,s:b,s:i,s:i,s:i,s:i}", "vertices", f->vertices, "triangles",
                f->triangles, "closed", f->closed, "oriented", f->oriented, "manifold", f->manifold,
                "boundary_edges", f->boundary_edges, "nonmanifold_edges", f->nonmanifold_edges,
                "components", f->components, "euler", f->euler);
  json_object_set_new(object, "genus", f->genus < 0 ? json_null() : json_integer(f->genus));
  if (f->self_intersections >= 0)
    json_object_set_new(object, "self_intersections", json_integer(f->self_intersections));
  json_object_set_new(object, "volume", json_real(f->volume));
  json_object_set_new(object, "area", json_real(f->area));
  json_object_set_new(object, "centroid", point(f->centroid));
  json_t *inertia = json_array();
  for (int i = 0; i < 6; i++) json_array_append_new(inertia, json_real(f->inertia[i]));
  json_object_set_new(object, "inertia", inertia);
  json_object_set_new(object, "min", point(f->min));
  json_object_set_new(object, "max", point(f->max));
  return object;
}

void lam_json_print(json_t *object) {
  json_dumpf(object, stdout, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
  putchar('\n');
  json_decref(object);
}
