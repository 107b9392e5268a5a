/* The list of all measures, and how they are run and summed up. Called by
 * net/optimize_measures.c, degenerate.c, measure_map.c, cli/verb_measure.c,
 * fab/parts/gauss_image.c and bench. */
#include "core/numbers.h"
#include "net/measures/layout.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* The list of measures. To add one: write it into a file *_measures.c, and add its line here. */
/* clang-format off */
#define MEASURES(row) \
  row(star_planarity) \
  row(face_planarity) \
  row(angle_deviation) \
  row(crossing_angle) \
  row(turning_angle) \
  row(edge_length) \
  row(shortest_edge) \
  row(foldovers) \
  row(overlaps) \
  row(flatness) \
  row(edge_variation) \
  row(opposite_edge_difference) \
  row(star_sphericity) \
  row(star_curvature) \
  row(curvature_spread) \
  row(circle_angle_deviation) \
  row(turning_angle_u) \
  row(turning_angle_v) \
  row(edge_ratio) \
  row(mean_curvature) \
  row(gauss_curvature) \
  row(curvature_ratio) \
  row(cotangent_mean_curvature) \
  row(gauss_image_area) \
  row(gauss_image_area_signed) \
  row(angle_defect) \
  row(principal_deviation) \
  row(distance_to_reference) \
  row(distance_from_reference) \
  row(opposite_angle) \
  row(angle_spread) \
  row(geodesic_error_u) \
  row(geodesic_error_v) \
  row(orthogonality) \
  row(straightness_u) \
  row(straightness_v) \
  row(clairaut_u) \
  row(clairaut_v) \
  row(edge_variation_u) \
  row(edge_variation_v) \
  row(spacing_u) \
  row(spacing_v) \
  row(edge_strain) \
  row(shear_strain) \
  row(circularity) \
  row(conicality) \
  row(cross_ratio) \
  row(incircle_contact) \
  row(surface_gauss_curvature) \
  row(coverage) \
  row(flattening_distortion) \
  row(flattening_stretch) \
  row(flattening_compression) \
  row(parameter_distortion) \
  row(parameter_stretch) \
  row(parameter_compression)
/* clang-format on */

#define DECLARE(name) extern const lam_measure_kind lam_measure_##name;
MEASURES(DECLARE)

#define POINT(name) &lam_measure_##name,
const lam_measure_kind *const lam_measures[] = {MEASURES(POINT)};
const int lam_measure_count = sizeof lam_measures / sizeof *lam_measures;

const lam_measure_kind *lam_measure_find(const char *name) {
  for (int i = 0; i < lam_measure_count; i++)
    if (strcmp(lam_measures[i]->name, name) == 0) return lam_measures[i];
  return NULL;
}

/* The number of elements that the measure has values on. */
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

/* Elements that run leaves out stay undefined. */
double *lam_measure_values(const lam_measure_kind *kind, const lam_measuring *in) {
  int count = lam_measure_size(kind, in->net);
  double *values = LAM_NEW(in->arena, double, count);
  for (int i = 0; i < count; i++) values[i] = LAM_UNDEFINED;
  kind->run(in, values);
  return values;
}

/* Over the defined values; NaN where there is none. */
lam_measure lam_measure_summary(const lam_measure_kind *kind, const double *values, int count) {
  lam_measure out = {.name = kind->name, .unit = kind->unit, .min = NAN, .max = NAN, .mean = NAN};
  double sum = 0;
  for (int i = 0; i < count; i++) {
    if (values[i] == LAM_UNDEFINED) continue;

    /* A value that is not a number stays the smallest and the largest. */
    if (out.count == 0 || (!(values[i] >= out.min) && !isnan(out.min))) out.min = values[i];
    if (out.count == 0 || (!(values[i] <= out.max) && !isnan(out.max))) out.max = values[i];
    sum += values[i];
    out.count++;
  }

  if (out.count) out.mean = sum / (double)out.count;
  return out;
}

/* The defaults of what measures need. */
lam_measuring lam_measuring_of(lam_arena *arena, const lam_net *net, const lam_vec3 *positions) {
  return (lam_measuring){.arena = arena,
                         .net = net,
                         .positions = positions,
                         .mean_edge = lam_net_mean_edge(net, positions),
                         .target_angle = LAM_PI / 2};
}

/* The summary of one measure; its scratch and values are released. */
static lam_measure run_one(const lam_measure_kind *kind, const lam_measuring *in) {
  lam_arena_mark mark = lam_arena_mark_get(in->arena);
  lam_measure out =
      lam_measure_summary(kind, lam_measure_values(kind, in), lam_measure_size(kind, in->net));
  lam_arena_release(in->arena, mark);
  return out;
}

/* The list is gone through twice, with names or without: to count, and to run. */
lam_measure *lam_net_measure(const lam_measuring *in, const char *const *names, int *count) {
  *count = 0;
  for (int i = 0; names ? names[i] != NULL : i < lam_measure_count; i++) ++*count;
  lam_measure *out = LAM_NEW(in->arena, lam_measure, *count);

  *count = 0;
  for (int i = 0; names ? names[i] != NULL : i < lam_measure_count; i++) {
    const lam_measure_kind *kind = names ? lam_measure_find(names[i]) : lam_measures[i];
    assert(kind && "a measure that is not in the list");
    if (names || !lam_measure_is_slow(kind)) out[(*count)++] = run_one(kind, in);
  }
  return out;
}

/* One measure by its name, with the defaults. */
lam_measure lam_net_measure_one(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                                const char *name) {
  lam_measuring in = lam_measuring_of(arena, net, positions);
  const lam_measure_kind *kind = lam_measure_find(name);
  assert(kind && "a measure that is not in the list");
  return run_one(kind, &in);
}
