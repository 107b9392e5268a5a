/* JSON of solids. Called by verb_inspect.c, diff_meshes.c and diff_pictures.c. */
#include "cli/solid_facts.h"
#include "cli/complain.h"

#include <stdio.h>
#include <stdlib.h>

static json_t *point(lam_vec3 p) { return json_pack("[f,f,f]", p.x, p.y, p.z); }

/* The genus is null where there is none; self-intersections are left out when nobody looked. */
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

/* Set by the first piece of JSON that there was no memory for: jansson leaves it out silently. */
static bool ran_out;

static void *take(size_t size) {
  void *bytes = malloc(size);
  ran_out = ran_out || !bytes;
  return bytes;
}

void lam_json_begin(void) { json_set_alloc_funcs(take, free); }

/* As text first: nothing is printed unless all of it is. The names of files may be no UTF-8, which
 * JSON has no place for. */
int lam_json_print(json_t *object, int status, int digits) {
  char *text = json_dumps(object, JSON_INDENT(2) | JSON_REAL_PRECISION((size_t)digits));
  json_decref(object);
  if (text && !ran_out)
    puts(text);
  else
    status = lam_complain_plain(1, ran_out ? "out of memory"
                                           : "--json: the name of a file is no UTF-8, as all of "
                                             "JSON is");
  free(text);
  return status;
}
