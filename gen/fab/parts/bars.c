/* The row `bars`: straight bars along the edges of the net, mitered where they meet. Called
 * through the registry (part_kinds.c) by design/parts_stage.c. */
#include "core/numbers.h"
#include "core/solid/convex.h"
#include "core/solid/triangles.h"
#include "fab/material.h"
#include "fab/part_names.h"
#include "fab/workshop.h"

#include <stdlib.h>
#include <string.h>

enum { PROFILE_ROUND, PROFILE_SQUARE };
enum { EDGES_ALL, EDGES_INNER, EDGES_BOUNDARY };
static const char *const profile_names[] = {"round", "square", NULL};
static const char *const edge_names[] = {"all", "inner", "boundary", NULL};

/* Corners of a round section; vertices of the room through which solids pass (see keep). */
enum { round_corners = 16, staged = 1024 };

/* The keys of a row, in meters. */
typedef struct bars_keys {
  lam_list families; /* of int */
  double diameter, rim, wall, gap, offset;
  int profile, edges, material, second;
  bool second_given;
} bars_keys;

/* The bars of one row: bar b lies on edge edge[b] of the net. */
typedef struct bar_set {
  lam_workshop *shop;
  const bars_keys *keys;
  lam_vec3 *node;      /* per vertex of the net: where the axes meet */
  int count, *edge;    /* of the net */
  int *start, *around; /* the bars at every vertex: around[start[v] .. start[v+1]-1] */
  long skipped;        /* edges too short for a bar */
  lam_vec3 *staged_vertices;
  int (*staged_triangles)[3];
} bar_set;

/* ---- which edges ---- */

static bool is_rim(const lam_edge *edge) { return edge->face[0] < 0 || edge->face[1] < 0; }

/* Whether an edge becomes a bar. The boundary is taken whole, whatever the families, when it is
 * asked for or has a diameter of its own. */
static bool is_chosen(const bars_keys *k, const lam_edge *edge) {
  const int *family = k->families.items;
  bool listed = false;
  for (int i = 0; i < k->families.count; i++) listed |= family[i] == edge->family;
  if (k->edges == EDGES_INNER) return listed && !is_rim(edge);
  if (k->edges == EDGES_BOUNDARY) return is_rim(edge);
  return listed || (k->rim > 0 && is_rim(edge));
}

/* Diameter of a bar (side of a square one); the boundary may have its own. */
static double size_of(const bar_set *set, int bar) {
  const lam_edge *edge = &set->shop->net->edges[set->edge[bar]];
  return set->keys->rim > 0 && is_rim(edge) ? set->keys->rim : set->keys->diameter;
}

/* The other end of a bar. */
static int other_end(const bar_set *set, int bar, int vertex) {
  const int *v = set->shop->net->edges[set->edge[bar]].vertex;
  return v[0] == vertex ? v[1] : v[0];
}

/* Chooses the edges and lists the bars at every vertex. An edge shorter than a quarter of the
 * diameter gets none. */
static bar_set make_set(lam_workshop *shop, const bars_keys *k) {
  const lam_net *net = shop->net;
  int n = net->mesh.vertex_count;
  bar_set set = {.shop = shop, .keys = k, .edge = LAM_NEW(shop->arena, int, net->edge_count)};

  set.node = LAM_NEW(shop->arena, lam_vec3, n);
  for (int v = 0; v < n; v++)
    set.node[v] = lam_along(net->mesh.vertices[v], k->offset, shop->normals[v]);

  set.start = LAM_NEW(shop->arena, int, n + 1);
  for (int e = 0; e < net->edge_count; e++) {
    const int *v = net->edges[e].vertex;
    if (!is_chosen(k, &net->edges[e])) continue;
    if (!(lam_distance(set.node[v[0]], set.node[v[1]]) > k->diameter / 4)) {
      set.skipped++;
      continue;
    }
    set.edge[set.count++] = e;
    for (int end = 0; end < 2; end++) set.start[v[end] + 1]++;
  }

  /* The bars at every vertex in compressed form, in the order of the bars. */
  for (int v = 0; v < n; v++) set.start[v + 1] += set.start[v];
  set.around = LAM_NEW(shop->arena, int, 2 * set.count);
  int *filled = LAM_NEW(shop->arena, int, n);
  for (int b = 0; b < set.count; b++)
    for (int end = 0; end < 2; end++) {
      int v = net->edges[set.edge[b]].vertex[end];
      set.around[set.start[v] + filled[v]++] = b;
    }

  set.staged_vertices = LAM_NEW(shop->arena, lam_vec3, staged);
  set.staged_triangles =
      (int(*)[3])lam_arena_alloc(shop->arena, 2 * staged, sizeof *set.staged_triangles);
  return set;
}

/* ---- the solid ---- */

/* The section around the origin, counterclockwise: x across, y along the normal of the net. A
 * round bar is a regular polygon with the area of the circle. corner has room for round_corners;
 * returns how many there are. */
static int section(const bars_keys *k, double size, lam_vec2 *corner) {
  if (k->profile == PROFILE_SQUARE) {
    static const int sign[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    for (int i = 0; i < 4; i++)
      corner[i] = (lam_vec2){sign[i][0] * size / 2, sign[i][1] * size / 2};
    return 4;
  }

  double step = 2 * LAM_PI / round_corners, radius = size / 2 * sqrt(step / sin(step));
  for (int i = 0; i < round_corners; i++)
    corner[i] = (lam_vec2){radius * cos(step * i), radius * sin(step * i)};
  return round_corners;
}

/* Two bars that leave a node in the directions d and e are parted by the plane through the node
 * that halves their angle: each keeps the side of its own direction, less half the gap. */
static void miter(const bar_set *set, lam_convex *solid, int bar, int v) {
  lam_vec3 own = lam_unit(lam_sub(set->node[other_end(set, bar, v)], set->node[v]));
  for (int i = set->start[v]; i < set->start[v + 1]; i++) {
    if (set->around[i] == bar) continue;
    lam_vec3 d = lam_unit(lam_sub(set->node[other_end(set, set->around[i], v)], set->node[v]));
    lam_vec3 normal = lam_unit(lam_sub(own, d));
    lam_convex_cut(solid, lam_along(set->node[v], set->keys->gap / 2, normal), normal);
  }
}

/* Moves a mesh out of the memory after mark, which is released, so that the scratch of its making
 * does not stay. A mesh that is too large for the staging room is left where it is. */
static lam_trimesh keep(bar_set *set, lam_trimesh mesh, lam_arena_mark mark) {
  lam_arena *arena = set->shop->arena;
  if (mesh.vertex_count > staged || mesh.triangle_count > 2 * staged) return mesh;
  memcpy(set->staged_vertices, mesh.vertices, sizeof *mesh.vertices * (size_t)mesh.vertex_count);
  memcpy(set->staged_triangles, mesh.triangles,
         sizeof *mesh.triangles * (size_t)mesh.triangle_count);

  lam_arena_release(arena, mark);
  mesh.vertices = LAM_NEW(arena, lam_vec3, mesh.vertex_count);
  mesh.triangles =
      (int(*)[3])lam_arena_alloc(arena, (size_t)mesh.triangle_count, sizeof *mesh.triangles);
  memcpy(mesh.vertices, set->staged_vertices, sizeof *mesh.vertices * (size_t)mesh.vertex_count);
  memcpy(mesh.triangles, set->staged_triangles,
         sizeof *mesh.triangles * (size_t)mesh.triangle_count);
  return mesh;
}

/* The solid of a bar: a prism that reaches two diameters past both nodes, cut by the miter planes
 * there, and square through the node where no other bar ends. At sharp corners of the boundary a
 * miter is therefore cut off two diameters past the node. */
static lam_trimesh bar_solid(bar_set *set, int bar) {
  const int *v = set->shop->net->edges[set->edge[bar]].vertex;
  lam_arena *arena = set->shop->arena;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double size = size_of(set, bar);

  lam_vec3 a = set->node[v[0]], b = set->node[v[1]], t = lam_unit(lam_sub(b, a));
  /* Up is the mean of the normals at the ends, made perpendicular to the bar. */
  lam_vec3 up = lam_add(set->shop->normals[v[0]], set->shop->normals[v[1]]);
  up = lam_along(up, -lam_dot(up, t), t);
  if (lam_length(up) < 1e-6) up = lam_cross(t, fabs(t.z) < 0.9 ? lam_v3(0, 0, 1) : lam_v3(1, 0, 0));
  up = lam_unit(up);

  lam_vec3 across = lam_cross(up, t), from = lam_along(a, -2 * size, t), ring[round_corners];
  lam_vec2 corner[round_corners];
  int n = section(set->keys, size, corner);
  for (int i = 0; i < n; i++)
    ring[i] = lam_along(lam_along(from, corner[i].x, across), corner[i].y, up);

  lam_convex solid =
      lam_convex_prism(arena, ring, n, lam_scale(t, lam_distance(a, b) + 4 * size), 1e-7 * size);

  for (int end = 0; end < 2; end++) {
    bool alone = set->start[v[end] + 1] - set->start[v[end]] == 1;
    if (alone) lam_convex_cut(&solid, set->node[v[end]], end ? lam_scale(t, -1) : t);
    miter(set, &solid, bar, v[end]);
  }

  return keep(set, lam_convex_mesh(arena, &solid), mark);
}

/* ---- parts ---- */

/* The share of the section that is material. */
static double fullness(const bars_keys *k, double size) {
  double inside = k->wall > 0 ? fmax(0, 1 - 2 * k->wall / size) : 0;
  return 1 - inside * inside;
}

/* The part of one bar. With a wall its mass is that of a tube; the solid is drawn full. */
static void add_part(bar_set *set, int bar, const char *name) {
  lam_workshop *shop = set->shop;
  const lam_edge *edge = &shop->net->edges[set->edge[bar]];
  bool second = edge->family == 1 && set->keys->second_given;
  lam_part part = {.name = name, .kind = "bars", .family = -1, .group = -1};
  part.material = &lam_materials[second ? set->keys->second : set->keys->material];
  part.length = lam_distance(set->node[edge->vertex[0]], set->node[edge->vertex[1]]);

  part.solid = bar_solid(set, bar);
  part.mass = lam_trimesh_volume(&part.solid) * part.material->density *
              fullness(set->keys, size_of(set, bar));

  const lam_fact facts[] = {{"length", "m", part.length},
                            {"mass", "kg", part.mass},
                            {"diameter", "m", size_of(set, bar)}};
  lam_part_set_facts(shop->arena, &part, facts, sizeof facts / sizeof facts[0]);
  lam_workshop_part(shop, part);
}

/* ---- the report ---- */

/* For qsort: increasing. */
static int by_value(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* How many lengths there are, to a millimeter: lengths that follow each other more closely are
 * one. */
static int distinct_lengths(lam_arena *arena, const lam_part *parts, int count) {
  double *length = LAM_NEW(arena, double, count), last = -1;
  int distinct = 0;

  for (int i = 0; i < count; i++) length[i] = parts[i].length;
  qsort(length, (size_t)count, sizeof *length, by_value);
  for (int i = 0; i < count; i++)
    if (last < 0 || length[i] - last > 1e-3) {
      last = length[i];
      distinct++;
    }
  return distinct;
}

/* The stage "bars". first: index of the first part of the set. */
static void report(bar_set *set, int first) {
  lam_workshop *shop = set->shop;
  lam_stage *stage = lam_workshop_stage(shop, "bars");
  double n = set->count, longest = 0, length = 0, heaviest = 0, mass = 0, shortest = INFINITY;
  long unsound = 0;

  for (int i = first; i < first + set->count; i++) {
    const lam_part *part = &shop->parts[i];
    longest = fmax(longest, part->length);
    shortest = fmin(shortest, part->length);
    heaviest = fmax(heaviest, part->mass);
    length += part->length;
    mass += part->mass;
    unsound += !lam_part_is_sound(shop->arena, part);
  }

  int distinct = distinct_lengths(shop->arena, &shop->parts[first], set->count);
  lam_stage_count(shop->arena, stage, "bar_count", n);
  lam_stage_measure(shop->arena, stage, "bar_length", "m", longest, length / n, set->count);
  lam_stage_measure(shop->arena, stage, "bar_length_sum", "m", length, length, set->count);
  lam_stage_measure(shop->arena, stage, "bar_mass", "kg", heaviest, mass / n, set->count);
  lam_stage_measure(shop->arena, stage, "bar_mass_sum", "kg", mass, mass, set->count);
  lam_stage_count(shop->arena, stage, "distinct_lengths", distinct);
  lam_stage_count(shop->arena, stage, "unsound_bars", unsound);

  stage->converged = unsound == 0;
  if (!stage->converged) stage->reason = "solids that are not sound";
  lam_stage_note(shop->arena, stage, "bars from node to node are %.4g m to %.4g m long", shortest,
                 longest);

  if (set->skipped)
    lam_stage_note(shop->arena, stage, "%ld edges are too short for a bar", set->skipped);
}

static void check(const lam_row *rows, int i, lam_errors *errors) {
  const bars_keys *k = rows[i].params;
  if (k->wall > k->diameter / 2)
    lam_error_add(errors, rows[i].location, "wall", "%g mm is more than half the diameter of %g mm",
                  k->wall * 1e3, k->diameter * 1e3);
}

/* Bars of a row are named by its letters, from E on, and their number. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const bars_keys *k = params;
  bar_set set = make_set(shop, k);
  if (!set.count) {
    lam_error_add(shop->errors, location, "diameter",
                  "%g mm leaves no bar: the edges are shorter than a quarter of that, or there "
                  "are none of these families",
                  k->diameter * 1e3);
    return;
  }

  int first = shop->part_count, digits = 1;
  const char *letters = lam_part_letters(shop, 'E');
  for (int e = set.count; e >= 10; e /= 10) digits++;
  for (int i = 0; i < set.count; i++) {
    const char *name = lam_arena_printf(shop->arena, "%s%0*d", letters, digits, i + 1);
    lam_progress_tell(shop->progress, "bars", (double)i / set.count, name);
    add_part(&set, i, name);
  }

  report(&set, first);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(bars_keys, "diameter", diameter, "60 mm", 1e-4, 2,
                   "Diameter of a round bar, side of a square one."),
    LAM_CHOICE_KEY(bars_keys, "profile", profile, "round", profile_names,
                   "round, or square with two sides along the normal of the net."),
    LAM_INTEGER_KEY(bars_keys, "families", families, "[0, 1]", 0, 1,
                    "The families of edges that become bars."),
    LAM_CHOICE_KEY(bars_keys, "edges", edges, "all", edge_names,
                   "All edges of the families, those inside the net, or its whole boundary."),
    LAM_LENGTH_KEY(bars_keys, "rim", rim, "0", 0, 2,
                   "Diameter of the bars along the boundary; 0: as all others."),
    LAM_LENGTH_KEY(bars_keys, "wall", wall, "0", 0, 1,
                   "Wall of tubes, for their mass: solids are drawn full. 0: solid bars."),
    LAM_LENGTH_KEY(bars_keys, "gap", gap, "0.2 mm", 0, 0.1,
                   "Between the mitered ends of bars at a node."),
    LAM_LENGTH_KEY(bars_keys, "offset", offset, "0", -10, 10,
                   "How far the axes stand off the net, along its normals."),
    LAM_CHOICE_KEY(bars_keys, "material", material, "steel", lam_material_names,
                   "What the bars are made of."),
    LAM_CHOICE_KEY(bars_keys, "second", second, "steel", lam_material_names,
                   "What the bars of family 1 are made of. Left out: as family 0.",
                   LAM_GIVEN(bars_keys, second_given)),
    {0}};

const lam_part_kind lam_part_bars = {
    .head = {.name = "bars",
             .title = "Bars along the edges",
             .doc = "Straight round or square bars from node to node: a gridshell, or the frame "
                    "under panels. Where bars meet, each is cut by the planes that halve its "
                    "angles to the others, so that they fit together whatever the node looks like "
                    "and no two overlap. Bars of one row know of each other: take one row with "
                    "`rim` for a stronger boundary, not two rows.",
             .source = NULL,
             .keys = keys,
             .params_size = sizeof(bars_keys)},
    .make = make,
    .check = check};
