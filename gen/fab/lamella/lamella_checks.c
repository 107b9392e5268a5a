/* The measures of lamellas and of the clash of parts. Called by lamella.c and, for the clash, by
 * design/parts_stage.c. Nothing here is taken from the optimization: positions and solids alone. */
#include "fab/lamella/lamella_checks.h"
#include "core/numbers.h"
#include "core/solid/solid.h"
#include "fab/flat/unroll.h"
#include "fab/lamella/lamella_flat.h"
#include "mesh/line_curve.h"

#include <stdlib.h>

/* ---- one strip ---- */

/* The middle line of a strip as its nodes see it: stations at the same node (two in pairs) become
 * one point. The first and the last point are the ends of the strip, which are straight extensions
 * or cuts. flat is the line developed (lam_unroll). */
typedef struct middle_line {
  int count;
  lam_vec3 *x, *m;
  lam_vec2 *flat;
} middle_line;

/* Stations at the same node become their mean point, with their mean direction m. */
static middle_line middle_line_of(lam_arena *arena, const lam_sheet_strip *strip) {
  int n = strip->station_count;
  middle_line p = {0, LAM_NEW(arena, lam_vec3, n), LAM_NEW(arena, lam_vec3, n),
                   LAM_NEW(arena, lam_vec2, n)};

  for (int i = 0; i < n;) {
    if (strip->stations[i].between) {
      i++;
      continue;
    }

    int j = i, crossing = strip->stations[i].crossing;
    lam_vec3 x = {0, 0, 0}, m = {0, 0, 0};
    do {
      x = lam_add(x, strip->stations[j].x);
      m = lam_add(m, strip->stations[j].m);
      j++;
    } while (j < n && crossing >= 0 && strip->stations[j].crossing == crossing);

    p.x[p.count] = lam_scale(x, 1.0 / (j - i));
    p.m[p.count++] = lam_unit(m);
    i = j;
  }

  lam_unroll(p.x, p.m, p.count, p.flat);
  return p;
}

/* Curvature about m at b, per meter: the turn of the edges a b and b c, seen along m, over the
 * mean of their lengths. */
static double curvature(lam_vec3 a, lam_vec3 b, lam_vec3 c, lam_vec3 m) {
  lam_vec3 in = lam_sub(b, a), out = lam_sub(c, b);
  double length = (lam_length(in) + lam_length(out)) / 2;
  in = lam_along(in, -lam_dot(in, m), m);
  out = lam_along(out, -lam_dot(out, m), m);
  return length > 0 ? lam_angle(in, out) / length : 0;
}

/* The same in the plane. */
static double flat_curvature(lam_vec2 a, lam_vec2 b, lam_vec2 c) {
  return curvature(lam_v3(a.x, a.y, 0), lam_v3(b.x, b.y, 0), lam_v3(c.x, c.y, 0), lam_v3(0, 0, 1));
}

/* Twist, rad/m: the turn of m about the edge a b, over its length. */
static double twist(lam_vec3 a, lam_vec3 b, lam_vec3 ma, lam_vec3 mb) {
  double length = lam_distance(a, b);
  lam_vec3 e = lam_unit(lam_sub(b, a));
  ma = lam_along(ma, -lam_dot(ma, e), e);
  mb = lam_along(mb, -lam_dot(mb, e), e);
  return length > 0 ? lam_angle(ma, mb) / length : 0;
}

/* The length of the line x + h m. */
static double edge_length(const lam_vec3 *x, const lam_vec3 *m, int n, double h) {
  double sum = 0;
  for (int i = 1; i < n; i++)
    sum += lam_distance(lam_along(x[i - 1], h, m[i - 1]), lam_along(x[i], h, m[i]));
  return sum;
}

/* Straightness and lengths are those of the stations at nodes and ends; curvature and twist those
 * of the middle line, without its first and its last edge, which are straight extensions. Those in
 * between are drawn, and prove nothing. */
lam_strip_measures lam_strip_measure(lam_arena *arena, const lam_lamella_grid *grid,
                                     const lam_sheet_strip *strip) {
  lam_strip_measures r = {0};
  int all = strip->station_count, n = 0;
  double half = grid->height / 2;
  lam_arena_mark mark = lam_arena_mark_get(arena);

  lam_vec3 *x = LAM_NEW(arena, lam_vec3, all), *m = LAM_NEW(arena, lam_vec3, all);
  lam_vec2 *flat = LAM_NEW(arena, lam_vec2, all);
  for (int i = 0; i < all; i++) {
    if (strip->stations[i].between) continue;
    x[n] = strip->stations[i].x;
    m[n++] = strip->stations[i].m;
    r.slots += strip->stations[i].partner >= 0;
  }

  lam_unroll(x, m, n, flat);
  r.straightness = lam_straightness(flat, n);
  lam_unroll_triangles(x, m, grid->height, n, flat);
  r.normal_straightness = lam_straightness(flat, n);

  double middle = edge_length(x, m, n, 0);
  if (middle > 0)
    r.edge_difference = fmax(fabs(edge_length(x, m, n, half) / middle - 1),
                             fabs(edge_length(x, m, n, -half) / middle - 1));

  middle_line p = middle_line_of(arena, strip);
  double bend = 0, bow = 0;
  for (int i = 1; i + 2 < p.count; i++) {
    if (i > 1) bend = fmax(bend, curvature(p.x[i - 1], p.x[i], p.x[i + 1], p.m[i]));
    if (i > 1) bow = fmax(bow, flat_curvature(p.flat[i - 1], p.flat[i], p.flat[i + 1]));
    r.twist = fmax(r.twist, twist(p.x[i], p.x[i + 1], p.m[i], p.m[i + 1]));
  }

  r.bending_strain = grid->thickness / 2 * bend;
  r.straightening = lam_lamella_is_straight(arena, strip) ? half * bow : 0;
  r.twist_strain = grid->thickness * r.twist;
  r.edge_strain = half * half * r.twist * r.twist / 2;

  lam_arena_release(arena, mark);
  return r;
}

/* ---- the stage "lamellas" ---- */

/* Least, largest and mean of numbers that come one by one. */
typedef struct spread {
  double min, max, sum;
  long count;
} spread;

/* The first number begins the spread. */
static void spread_add(spread *s, double value) {
  s->min = s->count ? fmin(s->min, value) : value;
  s->max = s->count ? fmax(s->max, value) : value;
  s->sum += value;
  s->count++;
}

/* Adds a measure of a spread to a stage; nothing when it has no number. */
static void measure_spread(lam_workshop *shop, lam_stage *stage, const char *name, const char *unit,
                           const spread *s) {
  if (s->count)
    lam_stage_measure_add(
        shop->arena, stage,
        (lam_measure){name, unit, s->min, s->max, s->sum / (double)s->count, s->count});
}

/* One measure per number of lam_strip_measures, over all strips; then a note that holds the
 * largest strain of all against what the material bears. */
static void measure_strips(lam_workshop *shop, lam_stage *stage, const lam_lamella_grid *grid,
                           const lam_strip_measures *strips) {
  static const struct {
    const char *name, *unit;
    size_t offset;
  } rows[] = {
      {"sheet_straightness", "of length", offsetof(lam_strip_measures, straightness)},
      {"normal_strip_straightness", "of length", offsetof(lam_strip_measures, normal_straightness)},
      {"straightening_strain", "", offsetof(lam_strip_measures, straightening)},
      {"bending_strain", "", offsetof(lam_strip_measures, bending_strain)},
      {"twist", "rad/m", offsetof(lam_strip_measures, twist)},
      {"twist_strain", "", offsetof(lam_strip_measures, twist_strain)},
      {"edge_strain", "", offsetof(lam_strip_measures, edge_strain)},
      {"edge_length_difference", "of length", offsetof(lam_strip_measures, edge_difference)}};

  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    spread s = {0};
    for (int i = 0; i < grid->strip_count; i++)
      spread_add(&s, *(const double *)((const char *)&strips[i] + rows[k].offset));
    measure_spread(shop, stage, rows[k].name, rows[k].unit, &s);
  }

  spread worst = {0};
  for (int i = 0; i < grid->strip_count; i++)
    spread_add(&worst, fmax(fmax(strips[i].bending_strain, strips[i].twist_strain),
                            fmax(strips[i].edge_strain, strips[i].straightening)));
  if (grid->strip_count)
    lam_stage_note(shop->arena, stage, "largest strain %.3g; %s stays elastic up to %.3g: %s",
                   worst.max, grid->material->name, grid->material->max_strain,
                   worst.max <= grid->material->max_strain
                       ? "within the limit"
                       : "beyond the limit, lamellas would have to be formed");
}

/* The straightness of lamellas themselves: of the sheet, or of the middle between the two sheets
 * of a pair. A sheet at a constant distance from an asymptotic line is not quite asymptotic, so
 * it is less straight than the lamella. */
static void measure_lamellas(lam_workshop *shop, lam_stage *stage, const lam_lamella_grid *grid) {
  spread s = {0};
  lam_arena_mark mark = lam_arena_mark_get(shop->arena);

  for (int i = 0; i<grid->strip_count; i += grid->pair> 0 ? 2 : 1) {
    middle_line p = middle_line_of(shop->arena, &grid->strips[i]);
    /* Both sheets have a point at every node, in the same order. */
    if (grid->pair > 0) {
      middle_line q = middle_line_of(shop->arena, &grid->strips[i + 1]);
      for (int k = 0; k < p.count; k++) {
        p.x[k] = lam_mix(p.x[k], q.x[k], 0.5);
        p.m[k] = lam_unit(lam_add(p.m[k], q.m[k]));
      }
      lam_unroll(p.x, p.m, p.count, p.flat);
    }

    spread_add(&s, lam_straightness(p.flat, p.count));
  }

  lam_arena_release(shop->arena, mark);
  measure_spread(shop, stage, "unrolled_straightness", "of length", &s);
}

/* Where the vertex number `index` of a lamella's axis lies along its sheets: the mean arc length
 * over all stations at that vertex, of both sheets of a pair. NaN when there is none. */
static double place_along(const lam_lamella_grid *grid, const lam_sheet_strip *first, int vertex) {
  double sum = 0;
  int count = 0, sheets = grid->pair > 0 ? 2 : 1;
  for (int k = 0; k < sheets; k++)
    for (int i = 0; i < first[k].station_count; i++) {
      const lam_station *q = &first[k].stations[i];
      if (q->between || q->vertex != vertex) continue;
      sum += q->s;
      count++;
    }
  return count ? sum / count : NAN;
}

/* How much the lengths of lamellas are off those of smooth axes: from the first vertex with a
 * station to the last, against the cubic spline through the vertices of the net (which CAD programs
 * get), as a share of its length. The sheets of a pair are longer and shorter than the axis between
 * them: their mean counts, which twist makes longer by (pair twist)^2 / 8. */
static void measure_lengths(lam_workshop *shop, lam_stage *stage, const lam_lamella_grid *grid) {
  spread s = {0};
  lam_arena_mark mark = lam_arena_mark_get(shop->arena);

  for (int i = 0; grid->axes && i<grid->strip_count; i += grid->pair> 0 ? 2 : 1) {
    const lam_sheet_strip *strip = &grid->strips[i];
    const lam_polyline *axis = &grid->axes[strip->group];
    int first = 0, last = axis->count - 1;
    while (first < last && isnan(place_along(grid, strip, axis->vertices[first]))) first++;
    while (first < last && isnan(place_along(grid, strip, axis->vertices[last]))) last--;
    if (first == last) continue;

    const double *smooth = lam_polyline_lengths(shop->arena, shop->net->mesh.vertices, axis);
    double made = place_along(grid, strip, axis->vertices[last]) -
                  place_along(grid, strip, axis->vertices[first]);
    spread_add(&s, fabs(made / (smooth[last] - smooth[first]) - 1));
  }

  lam_arena_release(shop->arena, mark);
  measure_spread(shop, stage, "length_error", "of length", &s);
}

/* Angles of nodes around regular vertices, and of all others, against the mean of the former (of
 * all when there is none). off[0]: deviations at regular vertices, off[1]: at the others, in
 * degrees. */
static void measure_angles(lam_workshop *shop, lam_stage *stage, const lam_lamella_grid *grid) {
  spread inside = {0}, all = {0}, off[2] = {inside, inside};
  for (int i = 0; i < grid->node_count; i++) {
    spread_add(&all, grid->nodes[i].angle);
    if (shop->net->star_of_vertex[grid->nodes[i].vertex] >= 0)
      spread_add(&inside, grid->nodes[i].angle);
  }
  if (!all.count) return;

  const spread *reference = inside.count ? &inside : &all;
  double mean = reference->sum / (double)reference->count;
  for (int i = 0; i < grid->node_count; i++)
    spread_add(&off[shop->net->star_of_vertex[grid->nodes[i].vertex] < 0],
               fabs(grid->nodes[i].angle - mean) / LAM_DEGREE);

  lam_measure crossing = {
      "crossing_angle",  "deg",           reference->min / LAM_DEGREE, reference->max / LAM_DEGREE,
      mean / LAM_DEGREE, reference->count};
  lam_stage_measure_add(shop->arena, stage, crossing);
  measure_spread(shop, stage, "crossing_angle_deviation", "deg", &off[0]);
  measure_spread(shop, stage, "crossing_angle_deviation_boundary", "deg", &off[1]);
}

/* Checks the solids of all strips: closed and in one piece, oriented, free of self-intersections.
 * The stage has converged only when all of them are sound and could be checked. */
static void measure_solids(lam_workshop *shop, lam_stage *stage, const lam_lamella_grid *grid) {
  long open = 0, turned = 0, crossed = 0, failed = 0;
  bool ran_out = false;
  for (int i = 0; i < grid->strip_count; i++) {
    lam_solid_facts facts;
    lam_progress_tell(shop->progress, "checking solids", (double)i / grid->strip_count,
                      grid->strips[i].name);

    lam_status status = lam_solid_measure(&shop->parts[grid->strips[i].part].solid, true, &facts);
    if (status != LAM_OK) {
      ran_out = ran_out || status == LAM_NO_MEMORY;
      failed++;
      continue;
    }

    open += !facts.closed || !facts.manifold || facts.components != 1;
    turned += !facts.oriented;
    crossed += facts.self_intersections != 0;
  }

  lam_stage_count(shop->arena, stage, "open_parts", (double)open);
  lam_stage_count(shop->arena, stage, "unoriented_parts", (double)turned);
  lam_stage_count(shop->arena, stage, "self_intersecting_parts", (double)crossed);
  stage->converged = !(open || turned || crossed || failed);
  if (ran_out) stage->reason = "out of memory";
  if (failed) lam_stage_note(shop->arena, stage, "%ld parts could not be checked", failed);
}

/* See the header; the solids come last, for they decide whether the stage has converged. */
void lam_lamella_stage(lam_workshop *shop, const lam_lamella_grid *grid,
                       const lam_strip_measures *strips) {
  lam_stage *stage = lam_workshop_stage(shop, "lamellas");
  measure_lamellas(shop, stage, grid);
  measure_lengths(shop, stage, grid);
  measure_strips(shop, stage, grid, strips);
  measure_angles(shop, stage, grid);
  measure_solids(shop, stage, grid);
}

/* ---- the stage "clash" ---- */

/* Puts all parts that are more than drawn, instance by instance, into the set; part_of[i] is the
 * part of its solid i. */
static lam_status add_solids(lam_workshop *shop, lam_solid_set *set, int *part_of) {
  for (int i = 0; i < shop->part_count; i++) {
    const lam_part *part = &shop->parts[i];
    if (part->drawn) continue;
    for (int k = 0; k < (part->instance_count ? part->instance_count : 1); k++) {
      int index =
          lam_solid_set_add(set, &part->solid, part->instance_count ? &part->instances[k] : NULL);
      if (index < 0) return index == -2 ? LAM_NO_MEMORY : LAM_FAILED;
      part_of[index] = i;
    }
  }
  return LAM_OK;
}

/* What was found: count pairs of `pairs` overlap, by at most max and altogether by sum (m^3).
 * worst: the parts of the pair that overlaps most, or that could not be computed. */
typedef struct clash {
  long pairs, count;
  double max, sum;
  int worst[2]; /* parts */
  lam_status status;
} clash;

/* Overlaps of all pairs whose boxes do. The solids and the list of pairs belong to the library;
 * they are freed with the arena. Stops at the first pair that fails, which is then the worst. */
static clash measure_clash(lam_workshop *shop) {
  clash c = {.status = LAM_NO_MEMORY};
  lam_solid_set *set = lam_solid_set_new();
  if (!set) return c;
  lam_arena_defer(shop->arena, lam_solid_set_free, set);

  int solids = 0, (*pairs)[2] = NULL, pair_count = 0;
  for (int i = 0; i < shop->part_count; i++)
    solids += shop->parts[i].instance_count ? shop->parts[i].instance_count : 1;
  int *part_of = LAM_NEW(shop->arena, int, solids);
  c.status = add_solids(shop, set, part_of);
  if (c.status != LAM_OK) return c;

  c.status = lam_solid_set_candidates(set, &pairs, &pair_count);
  if (c.status != LAM_OK) return c;
  lam_arena_defer(shop->arena, free, pairs);

  for (int k = 0; k < pair_count; k++) {
    double volume = 0;
    if (k % 64 == 0)
      lam_progress_tell(shop->progress, "checking clashes", (double)k / pair_count, "");

    c.status = lam_solid_set_overlap(set, pairs[k][0], pairs[k][1], &volume);
    c.pairs++;
    if (c.status != LAM_OK || volume > c.max)
      for (int end = 0; end < 2; end++) c.worst[end] = part_of[pairs[k][end]];

    if (c.status != LAM_OK) return c;
    c.count += volume > 0;
    c.sum += volume;
    c.max = fmax(c.max, volume);
  }
  return c;
}

/* See the header. What the library needs is released before the stage is written. */
void lam_workshop_clash(lam_workshop *shop) {
  int drawn = 0;
  for (int i = 0; i < shop->part_count; i++) drawn += shop->parts[i].drawn;
  if (drawn == shop->part_count) return;

  lam_arena_mark mark = lam_arena_mark_get(shop->arena);
  clash c = measure_clash(shop);
  lam_arena_release(shop->arena, mark);

  lam_stage *stage = lam_workshop_stage(shop, "clash");
  const char *names[2] = {shop->parts[c.worst[0]].name, shop->parts[c.worst[1]].name};
  stage->converged = c.status == LAM_OK && c.count == 0;
  if (!stage->converged)
    stage->reason = c.status == LAM_OK          ? "parts overlap"
                    : c.status == LAM_NO_MEMORY ? "not computed: out of memory"
                                                : "not computed";

  if (c.status == LAM_NO_MEMORY) return;
  if (c.status != LAM_OK) {
    lam_stage_note(shop->arena, stage, "the overlap of parts could not be computed (%s, %s)",
                   names[0], names[1]);
    return;
  }

  lam_stage_measure(shop->arena, stage, "clash_volume", "m3", c.max,
                    c.pairs ? c.sum / (double)c.pairs : 0, c.pairs);
  lam_stage_measure(shop->arena, stage, "clash_volume_sum", "m3", c.sum, c.sum, c.pairs);
  lam_stage_count(shop->arena, stage, "clash_count", (double)c.count);
  lam_stage_count(shop->arena, stage, "pairs_checked", (double)c.pairs);

  if (drawn) lam_stage_note(shop->arena, stage, "%d parts are drawn only and were left out", drawn);
  if (c.count)
    lam_stage_note(shop->arena, stage,
                   "%ld pairs of parts overlap, most of all %s and %s (%.3g mm3)", c.count,
                   names[0], names[1], c.max * 1e9);
}
