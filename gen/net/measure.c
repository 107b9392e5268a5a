#include "net/measure.h"

#include <assert.h>
#include <math.h>
#include <string.h>

extern const lam_measure_kind lam_measure_star_planarity, lam_measure_face_planarity, lam_measure_angle_deviation,
    lam_measure_crossing_angle, lam_measure_turning_angle, lam_measure_edge_length, lam_measure_shortest_edge,
    lam_measure_foldovers, lam_measure_flatness;
extern const lam_measure_kind lam_measure_edge_variation, lam_measure_opposite_edge_difference,
    lam_measure_star_sphericity, lam_measure_star_curvature, lam_measure_curvature_spread,
    lam_measure_circle_angle_deviation;

const lam_measure_kind *const lam_measures[] = {
    &lam_measure_star_planarity,
    &lam_measure_face_planarity,
    &lam_measure_angle_deviation,
    &lam_measure_crossing_angle,
    &lam_measure_turning_angle,
    &lam_measure_edge_length,
    &lam_measure_shortest_edge,
    &lam_measure_foldovers,
    &lam_measure_flatness,
    &lam_measure_edge_variation,
    &lam_measure_opposite_edge_difference,
    &lam_measure_star_sphericity,
    &lam_measure_star_curvature,
    &lam_measure_curvature_spread,
    &lam_measure_circle_angle_deviation,
};
const int lam_measure_count = sizeof lam_measures / sizeof *lam_measures;

const lam_measure_kind *lam_measure_find(const char *name) {
  for (int i = 0; i < lam_measure_count; i++)
    if (strcmp(lam_measures[i]->name, name) == 0) return lam_measures[i];
  return NULL;
}

int lam_measure_size(const lam_measure_kind *kind, const lam_net *net) {
  switch (kind->on) {
  case LAM_ON_VERTICES:
    return net->mesh.vertex_count;
  case LAM_ON_EDGES:
    return net->edge_count;
  case LAM_ON_FACES:
    return net->mesh.face_count;
  case LAM_ON_NET:
    break;
  }
  return 1;
}

double *lam_measure_values(const lam_measure_kind *kind, const lam_measuring *in) {
  int count = lam_measure_size(kind, in->net);
  double *values = LAM_NEW(in->arena, double, count);
  for (int i = 0; i < count; i++) values[i] = LAM_UNDEFINED;
  kind->run(in, values);
  return values;
}

lam_measure lam_measure_summary(const lam_measure_kind *kind, const double *values, int count) {
  lam_measure out = {.name = kind->name, .unit = kind->unit};
  for (int i = 0; i < count; i++) {
    if (values[i] == LAM_UNDEFINED) continue;
    /* a value that is not a number stays the largest */
    if (out.count == 0 || (!(values[i] <= out.max) && !isnan(out.max))) out.max = values[i];
    out.mean += values[i];
    out.count++;
  }
  if (out.count) out.mean /= (double)out.count;
  return out;
}

lam_measuring lam_measuring_of(lam_arena *arena, const lam_net *net, const lam_vec3 *positions) {
  return (lam_measuring){.arena = arena,
                         .net = net,
                         .positions = positions,
                         .mean_edge = lam_net_mean_edge(net, positions),
                         .target_angle = 3.14159265358979323846 / 2};
}

static lam_measure run_one(const lam_measure_kind *kind, const lam_measuring *in) {
  lam_arena_mark mark = lam_arena_mark_get(in->arena);
  lam_measure out = lam_measure_summary(kind, lam_measure_values(kind, in), lam_measure_size(kind, in->net));
  lam_arena_release(in->arena, mark);
  return out;
}

lam_measure *lam_net_measure(const lam_measuring *in, const char *const *names, int *count) {
  *count = lam_measure_count;
  if (names)
    for (*count = 0; names[*count];) (*count)++;
  lam_measure *out = LAM_NEW(in->arena, lam_measure, *count);
  for (int i = 0; i < *count; i++) {
    const lam_measure_kind *kind = names ? lam_measure_find(names[i]) : lam_measures[i];
    assert(kind && "a measure that is not in the list");
    out[i] = run_one(kind, in);
  }
  return out;
}

lam_measure lam_net_measure_one(lam_arena *arena, const lam_net *net, const lam_vec3 *positions, const char *name) {
  lam_measuring in = lam_measuring_of(arena, net, positions);
  const lam_measure_kind *kind = lam_measure_find(name);
  assert(kind && "a measure that is not in the list");
  return run_one(kind, &in);
}
