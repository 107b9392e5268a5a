/* Measures as color maps, and the check of names that a person gives. Called by
 * design/pipeline_run.c, library/sources.c and cli/verb_measure.c. */
#include "net/measures/measure_map.h"
#include "net/measures/layout.h"
#include "net/measures/measuring.h"

#include <string.h>

/* An unknown name is answered with the nearest one there is. */
const lam_measure_kind *lam_measure_named(const char *name, bool mapped, lam_location location,
                                          const char *key, lam_errors *errors) {
  const lam_measure_kind *kind = lam_measure_find(name);
  if (kind && mapped && kind->on == LAM_ON_NET) {
    lam_error_add(
        errors, location, key,
        "%s is one number for the whole net; expected a measure of vertices, edges or faces", name);
    return NULL;
  }
  if (kind) return kind;

  const char **names = LAM_NEW(errors->arena, const char *, lam_measure_count + 1);
  for (int i = 0; i < lam_measure_count; i++) names[i] = lam_measures[i]->name;
  const char *near = lam_did_you_mean(name, names);
  lam_error_add(errors, location, key,
                "given %s; expected measures of `lamella list measures`%s%s%s", name,
                near ? " (did you mean " : "", near ? near : "", near ? "?)" : "");
  return NULL;
}

void lam_measures_check(const lam_list *names, bool mapped, lam_location location, const char *key,
                        lam_errors *errors) {
  for (int i = 0; i < names->count; i++)
    lam_measure_named(((const char *const *)names->items)[i], mapped, location, key, errors);
}

/* Values, summary and what a picture needs: normals, edges, the plane that is compared with. */
lam_map lam_net_map(const lam_measuring *in, const lam_measure_kind *kind) {
  static const lam_map_on elements[] = {[LAM_ON_VERTICES] = LAM_MAP_VERTICES,
                                        [LAM_ON_EDGES] = LAM_MAP_EDGES,
                                        [LAM_ON_FACES] = LAM_MAP_FACES};
  const lam_net *net = in->net;
  lam_map map = {.on = elements[kind->on], .doc = kind->doc, .count = lam_measure_size(kind, net)};
  map.values = lam_measure_values(kind, in);
  map.summary = lam_measure_summary(kind, map.values, map.count);
  map.normals = lam_measuring_normals(in);
  map.layout = lam_measure_layout(kind, in);

  if (map.on == LAM_MAP_EDGES) {
    int(*edges)[2] = (int(*)[2])lam_arena_alloc(in->arena, (size_t)net->edge_count, sizeof *edges);
    for (int e = 0; e < net->edge_count; e++)
      for (int k = 0; k < 2; k++) edges[e][k] = net->edges[e].vertex[k];
    map.edges = (const int(*)[2])edges;
  }

  return map;
}

/* The range of all maps with this scale; 0, 0 when there is none, as for a lone value. */
static void shared_range(const lam_map *maps, const char *const *scales, int count,
                         const char *scale, double range[2]) {
  range[0] = INFINITY, range[1] = -INFINITY;
  for (int i = 0; i < count; i++) {
    if (!scales[i] || strcmp(scales[i], scale) != 0) continue;
    range[0] = fmin(range[0], maps[i].summary.min);
    range[1] = fmax(range[1], maps[i].summary.max);
  }
  if (!(range[0] < range[1])) range[0] = range[1] = 0;
}

/* Each map by itself, then one range for all maps of a scale. */
lam_map *lam_net_maps(const lam_measuring *in, const lam_list *names) {
  int count = names->count;
  lam_map *maps = LAM_NEW(in->arena, lam_map, count);
  const char **scales = LAM_NEW(in->arena, const char *, count);
  for (int i = 0; i < count; i++) {
    const lam_measure_kind *kind = lam_measure_find(((const char *const *)names->items)[i]);
    maps[i] = lam_net_map(in, kind);
    scales[i] = lam_measure_scale(kind);
  }

  for (int i = 0; i < count; i++)
    if (scales[i]) shared_range(maps, scales, count, scales[i], maps[i].range);
  return maps;
}
