/* The row `support`: flat beams between a net and its offset, without torsion in the nodes.
 * Called through the registry (part_kinds.c) by design/parts_stage.c.
 *
 * Directions d at the vertices span a quad with every edge: between x + low d and x + high d. On
 * a circular net the mirrored normals, and on a conical net the axes of the cones, make all these
 * quads flat, and the quads around a vertex share its axis. A plate of thickness t on a quad ends
 * before the node so that it stays gap/2 away from the planes that halve its angles a to the
 * other quads around the axis: its end is parallel to the axis, at the distance
 *   g = (gap/2 + t/2 cos(a/2)) / sin(a/2)
 * from it, a the smallest of these angles. */
#include "core/solid/triangles.h"
#include "fab/part_names.h"
#include "fab/parts/panel.h"
#include "fab/workshop.h"
#include "mesh/offset.h"

#include <string.h>

enum { ALONG_AUTO, ALONG_NORMALS, ALONG_AXES };
enum { EDGES_ALL, EDGES_INNER };
static const char *const along_names[] = {"auto", "normals", "axes", NULL};
static const char *const edge_names[] = {"all", "inner", NULL};

/* The keys of a row, in meters. */
typedef struct support_keys {
  double height, offset, thickness, gap, flat;
  int along, edges, material;
} support_keys;

/* The beams of one row: plate i stands on edge edge[i] of the net. */
typedef struct support_set {
  lam_workshop *shop;
  const support_keys *keys;
  const lam_vec3 *directions;
  bool axes; /* the directions are those of cones */
  lam_panel_layer layer;
  int count, *edge;
  lam_panel *plates;
  long twisted, short_edges; /* edges left out */
  double warp;               /* largest of all quads, m */
} support_set;

/* ---- directions ---- */

/* The largest twist of the quads inside the net for these directions (lam_net_edge_twist). */
static double largest_twist(const lam_net *net, const lam_vec3 *directions) {
  double twist = 0;
  for (int e = 0; e < net->edge_count; e++)
    if (net->edges[e].face[1] >= 0)
      twist = fmax(twist, lam_net_edge_twist(net, net->mesh.vertices, directions, e));
  return twist;
}

/* Takes the directions that the key `along` asks for, or the ones with the flatter quads inside
 * the net; normals when both are flat. */
static void choose_directions(support_set *set) {
  lam_workshop *shop = set->shop;
  const lam_net *net = shop->net;
  lam_vec3 *normals = LAM_NEW(shop->arena, lam_vec3, net->mesh.vertex_count);
  lam_vec3 *axes = LAM_NEW(shop->arena, lam_vec3, net->mesh.vertex_count);
  lam_net_mirrored_normals(shop->arena, net, net->mesh.vertices, normals);
  lam_net_cone_axes(shop->arena, net, net->mesh.vertices, axes);

  double twist[2] = {largest_twist(net, normals), largest_twist(net, axes)};
  set->axes = set->keys->along == ALONG_AXES ||
              (set->keys->along == ALONG_AUTO && twist[1] < twist[0] && twist[0] > 1e-9);
  set->directions = set->axes ? axes : normals;
}

/* ---- one plate ---- */

/* How far from the axis at v the plate on the edge towards w begins: the largest g over the other
 * edges at v, with directions seen along the axis. */
static double setback(const support_set *set, int v, int w) {
  const lam_net *net = set->shop->net;
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 axis = lam_unit(set->directions[v]), own = lam_sub(x[w], x[v]);
  double g = 0;
  own = lam_along(own, -lam_dot(own, axis), axis);

  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
    lam_vec3 other = lam_sub(x[net->ring[i]], x[v]);
    if (net->ring[i] == w) continue;
    double half = lam_angle(own, lam_along(other, -lam_dot(other, axis), axis)) / 2;
    g = fmax(g, (set->keys->gap / 2 + set->keys->thickness / 2 * cos(half)) / sin(half));
  }
  return g;
}

/* The share of the side from a to b that ends at the distance g from the line through a along the
 * unit axis. */
static double share(lam_vec3 a, lam_vec3 b, lam_vec3 axis, double g) {
  return g / lam_length(lam_cross(lam_sub(b, a), axis));
}

/* The quad that the directions span with an edge, corners in the order low v0, low v1, high v1,
 * high v0, moved into its plane of best fit: through their mean, square to the cross product of
 * the diagonals. Also sets what a panel says of itself: normal, diagonal, warp. */
static void span_quad(const support_set *set, int edge, lam_vec3 corner[4], lam_panel *plate) {
  const int *v = set->shop->net->edges[edge].vertex;
  const lam_vec3 *x = set->shop->net->mesh.vertices, *d = set->directions;
  double low = set->keys->offset, high = low + set->keys->height;
  corner[0] = lam_along(x[v[0]], low, d[v[0]]);
  corner[1] = lam_along(x[v[1]], low, d[v[1]]);
  corner[2] = lam_along(x[v[1]], high, d[v[1]]);
  corner[3] = lam_along(x[v[0]], high, d[v[0]]);

  lam_vec3 diagonal[2] = {lam_sub(corner[2], corner[0]), lam_sub(corner[3], corner[1])},
           center = {0, 0, 0};
  plate->normal = lam_unit(lam_cross(diagonal[0], diagonal[1]));
  plate->diagonal = (lam_length(diagonal[0]) + lam_length(diagonal[1])) / 2;
  plate->warp = fabs(lam_dot(plate->normal, lam_sub(corner[1], corner[0])));
  plate->flat = true;

  for (int k = 0; k < 4; k++) center = lam_along(center, .25, corner[k]);
  for (int k = 0; k < 4; k++)
    corner[k] =
        lam_along(corner[k], -lam_dot(plate->normal, lam_sub(corner[k], center)), plate->normal);
}

/* The plate on an edge: its quad, cut off before the nodes at both ends. False when the nodes leave
 * too little of the edge. */
static bool make_plate(const support_set *set, int edge, lam_panel *plate) {
  static const double least = .1; /* share of an edge that must remain */
  const int *v = set->shop->net->edges[edge].vertex;
  double cut[4]; /* shares cut off at the corners, along the lower and the upper side */
  lam_vec3 corner[4];
  span_quad(set, edge, corner, plate);

  for (int end = 0; end < 2; end++) {
    double g = setback(set, v[end], v[1 - end]);
    lam_vec3 axis = lam_unit(end ? lam_sub(corner[2], corner[1]) : lam_sub(corner[3], corner[0]));
    cut[end] = share(corner[end], corner[1 - end], axis, g);
    cut[3 - end] = share(corner[3 - end], corner[2 + end], axis, g);
  }

  if (!(cut[0] + cut[1] < 1 - least && cut[2] + cut[3] < 1 - least)) return false;
  for (int k = 0; k < 4; k++) plate->corner[k] = lam_mix(corner[k], corner[k ^ 1], cut[k]);
  return true;
}

/* Makes the plates on all edges of the row; those that are not flat to the tolerance, or too
 * short, are counted and left out. */
static void make_plates(support_set *set) {
  const lam_net *net = set->shop->net;
  set->edge = LAM_NEW(set->shop->arena, int, net->edge_count);
  set->plates = LAM_NEW(set->shop->arena, lam_panel, net->edge_count);

  for (int e = 0; e < net->edge_count; e++) {
    lam_panel *plate = &set->plates[set->count];
    if (set->keys->edges == EDGES_INNER && net->edges[e].face[1] < 0) continue;

    if (!make_plate(set, e, plate)) {
      set->short_edges++;
      continue;
    }

    set->warp = fmax(set->warp, plate->warp);
    if (plate->warp > set->keys->flat * plate->diagonal) {
      set->twisted++;
      continue;
    }
    set->edge[set->count++] = e;
  }
}

/* ---- parts ---- */

/* The part of plate i. Its length is that of its longer side between the nodes. */
static void add_part(const support_set *set, int i, const char *name, int class) {
  lam_workshop *shop = set->shop;
  const lam_panel *plate = &set->plates[i];
  lam_part part = {.name = name, .kind = "support", .group = -1, .congruence = class};
  part.family = shop->net->edges[set->edge[i]].family;
  part.material = &lam_materials[set->keys->material];
  part.solid = lam_panel_solid(shop->arena, plate, &set->layer);
  part.flat = lam_panel_flat(shop->arena, plate, &set->layer, name);

  part.length = fmax(lam_distance(plate->corner[0], plate->corner[1]),
                     lam_distance(plate->corner[2], plate->corner[3]));
  part.mass = lam_trimesh_volume(&part.solid) * part.material->density;

  const lam_fact facts[] = {{"length", "m", part.length},
                            {"mass", "kg", part.mass},
                            {"thickness", "m", set->keys->thickness},
                            {"warp", "m", plate->warp}};
  lam_part_set_facts(shop->arena, &part, facts, sizeof facts / sizeof facts[0]);
  lam_workshop_part(shop, part);
}

/* The stage "support". first: index of the first part of the set; classes: how many different
 * plates there are. */
static void report(const support_set *set, int first, int classes) {
  lam_workshop *shop = set->shop;
  lam_stage *stage = lam_workshop_stage(shop, "support");
  double n = set->count, length = 0, longest = 0, mass = 0, heaviest = 0, warp = 0;
  long unsound = 0;

  for (int i = 0; i < set->count; i++) {
    const lam_part *part = &shop->parts[first + i];
    longest = fmax(longest, part->length);
    heaviest = fmax(heaviest, part->mass);
    length += part->length;
    mass += part->mass;
    warp += set->plates[i].warp;
    unsound += !lam_part_is_sound(shop->arena, part);
  }

  lam_stage_count(shop->arena, stage, "support_count", n);
  lam_stage_measure(shop->arena, stage, "support_length", "m", longest, length / n, set->count);
  lam_stage_measure(shop->arena, stage, "support_mass", "kg", heaviest, mass / n, set->count);
  lam_stage_measure(shop->arena, stage, "support_mass_sum", "kg", mass, mass, set->count);
  lam_stage_measure(shop->arena, stage, "warp", "mm", set->warp * 1e3, warp / n * 1e3, set->count);
  lam_stage_count(shop->arena, stage, "distinct_supports", classes);
  lam_stage_count(shop->arena, stage, "unsound_supports", unsound);

  stage->converged = unsound == 0;
  if (!stage->converged) stage->reason = "solids that are not sound";

  lam_stage_note(shop->arena, stage, "beams stand along %s",
                 set->axes
                     ? "the axes of cones: a constant distance between the faces of both layers"
                     : "mirrored normals: a constant distance between the nodes of both layers");

  if (set->twisted)
    lam_stage_note(
        shop->arena, stage,
        "%ld edges are left out: net and offset span quads whose diagonals pass at up to %.3g mm",
        set->twisted, set->warp * 1e3);
  if (set->short_edges)
    lam_stage_note(shop->arena, stage, "%ld edges are too short for their nodes", set->short_edges);
}

/* Beams of a row are named by its letters, from S on, and the number of their edge. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const support_keys *k = params;
  support_set set = {
      .shop = shop, .keys = k, .layer = {.low = -k->thickness / 2, .high = k->thickness / 2}};

  choose_directions(&set);
  make_plates(&set);
  if (!set.count) {
    lam_error_add(shop->errors, location, "flat",
                  "no edge has a flat beam: %ld are twisted by up to %.3g mm, %ld too short; "
                  "expected a circular or a conical net",
                  set.twisted, set.warp * 1e3, set.short_edges);
    return;
  }

  int *class = LAM_NEW(shop->arena, int, set.count), first = shop->part_count, digits = 1;
  int classes =
      lam_panel_classes(shop->arena, set.plates, set.count, lam_workshop_next_class(shop), class);

  const char *letters = lam_part_letters(shop, 'S');
  for (int e = shop->net->edge_count; e >= 10; e /= 10) digits++;
  for (int i = 0; i < set.count; i++) {
    const char *name = lam_arena_printf(shop->arena, "%s%0*d", letters, digits, set.edge[i] + 1);
    lam_progress_tell(shop->progress, "support", (double)i / set.count, name);
    add_part(&set, i, name, class[i]);
  }

  report(&set, first, classes);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(support_keys, "height", height, "100 mm", 1e-4, 10,
                   "From the net, or the offset below, to the layer above it."),
    LAM_LENGTH_KEY(support_keys, "offset", offset, "0", -10, 10,
                   "Where the beams begin, measured from the net along their nodes."),
    LAM_LENGTH_KEY(support_keys, "thickness", thickness, "8 mm", 1e-5, 1,
                   "Thickness of the plates."),
    LAM_LENGTH_KEY(support_keys, "gap", gap, "2 mm", 0, 0.1,
                   "Between the plates that meet in a node, where they come closest."),
    LAM_CHOICE_KEY(
        support_keys, "along", along, "auto", along_names,
        "Directions of the nodes: normals (circular nets: nodes of both layers at a constant "
        "distance), axes of the cones (conical nets: faces of both layers at a constant "
        "distance), or those of the two that make the flatter beams."),
    LAM_CHOICE_KEY(support_keys, "edges", edges, "all", edge_names,
                   "All edges, or those inside the net."),
    LAM_NUMBER_KEY(support_keys, "flat", flat, "0.001", 0, 0.1,
                   "A beam is made when the diagonals of its quad pass at no more than this share "
                   "of their mean length."),
    LAM_CHOICE_KEY(support_keys, "material", material, "steel", lam_material_names,
                   "What the beams are made of."),
    {0}};

const lam_part_kind lam_part_support = {
    .head = {.name = "support",
             .title = "Flat beams between a net and its offset",
             .doc = "On every edge a flat plate between the net and a layer at a constant "
                    "distance, cut from sheet. The plates around a node stand on one axis: nodes "
                    "have no torsion. Circular and conical nets have such beams on every edge "
                    "inside the net, circular nets along the boundary too; on other nets edges "
                    "are left out, and the report says how many and how far their quads are from "
                    "flat. Panels with the same `offset` lie on either layer of a conical net. "
                    "Beams are named after the number of their edge: S001 and so on, T001 in the "
                    "second row. Where a face is bent so much that beams of neighboring nodes "
                    "meet, the clash check shows it.",
             .source = "thesis 3.5.2, figure 3.47; Liu et al. 2006",
             .keys = keys,
             .params_size = sizeof(support_keys)},
    .make = make};
