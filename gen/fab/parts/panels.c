/* The row `panels`: a plate on every face of the net. Called through the registry (part_kinds.c)
 * by design/parts_stage.c; the geometry of a plate stands in panel.c. */
#include "core/solid/triangles.h"
#include "fab/part_names.h"
#include "fab/parts/panel.h"
#include "fab/workshop.h"

#include <string.h>

enum { SIDE_OUTWARD, SIDE_CENTERED, SIDE_INWARD };
enum { FACES_ALL, FACES_CHECKER, FACES_BANDS_0, FACES_BANDS_1 };
static const char *const side_names[] = {"outward", "centered", "inward", NULL};
static const char *const face_names[] = {"all", "checker", "bands-0", "bands-1", NULL};

typedef struct panels_keys {
  double thickness, gap, offset, flat;
  int side, faces, material, second;
  bool second_given;
} panels_keys;

/* The panels of one row, in the order of the faces. */
typedef struct panel_set {
  const panels_keys *keys;
  lam_panel_layer layer;
  int count;
  int *face; /* of the net */
  const lam_material **material;
  lam_panel *panels;
  long left_out, conflicts;
} panel_set;

/* ---- which faces ---- */

/* For every face and side (from a corner to the next), whether the color changes across it: always
 * on a checkerboard, for bands across the edges of one family. */
static void find_changes(const lam_net *net, int pattern, int (*changes)[4]) {
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++)
      for (int k = 0, f = net->edges[e].face[side]; f >= 0 && k < 4; k++)
        if (net->mesh.faces[f][k] == net->edges[e].vertex[side])
          changes[f][k] =
              pattern == FACES_CHECKER || net->edges[e].family == pattern - FACES_BANDS_0;
}

/* Colors the faces 0 and 1 (color: face_count) so that they change across the edges of the pattern,
 * spreading from the first face of every piece of the net. Returns the number of edges where that
 * cannot be continued; they are met from both sides. */
static long color_faces(lam_arena *arena, const lam_net *net, const int (*neighbor)[4], int pattern,
                        int *color) {
  int faces = net->mesh.face_count, *queue = LAM_NEW(arena, int, faces), (*changes)[4];
  changes = lam_arena_alloc(arena, (size_t)faces, sizeof *changes);
  find_changes(net, pattern, changes);

  for (int f = 0; f < faces; f++) color[f] = -1;
  long conflicts = 0;
  for (int start = 0; start < faces; start++) {
    int head = 0, tail = 0;
    if (color[start] >= 0) continue;
    color[start] = 0;
    queue[tail++] = start;

    for (; head < tail; head++)
      for (int k = 0, f = queue[head]; k < 4; k++) {
        int g = neighbor[f][k], wanted = color[f] ^ changes[f][k];
        if (g < 0) continue;
        if (color[g] >= 0) {
          conflicts += color[g] != wanted;
          continue;
        }
        color[g] = wanted;
        queue[tail++] = g;
      }
  }
  return conflicts / 2;
}

/* Chooses the faces of the row and makes their panels. Faces of color 1 get the second material,
 * or stay open when none is given; without a pattern all faces have color 0. */
static panel_set make_set(lam_workshop *shop, const panels_keys *k) {
  const lam_net *net = shop->net;
  int faces = net->mesh.face_count, *color = LAM_NEW(shop->arena, int, faces), (*neighbor)[4];
  neighbor = lam_arena_alloc(shop->arena, (size_t)faces, sizeof *neighbor);

  double low = k->offset - k->thickness * (k->side == SIDE_OUTWARD    ? 0
                                           : k->side == SIDE_CENTERED ? 0.5
                                                                      : 1);
  panel_set set = {.keys = k, .layer = {low, low + k->thickness, k->gap, k->flat}};

  set.face = LAM_NEW(shop->arena, int, faces);
  set.panels = LAM_NEW(shop->arena, lam_panel, faces);
  set.material = LAM_NEW(shop->arena, const lam_material *, faces);

  lam_panel_neighbors(net, neighbor);
  if (k->faces != FACES_ALL)
    set.conflicts = color_faces(shop->arena, net, (const int(*)[4])neighbor, k->faces, color);

  for (int f = 0; f < faces; f++) {
    if (color[f] && !k->second_given) continue;
    if (!lam_panel_make(net, (const int(*)[4])neighbor, f, &set.layer, &set.panels[set.count])) {
      set.left_out++;
      continue;
    }

    set.material[set.count] = &lam_materials[color[f] ? k->second : k->material];
    set.face[set.count++] = f;
  }
  return set;
}

/* ---- parts ---- */

/* The part of panel i; a twisted panel has no flat pattern. The area is that of a plate of this
 * volume. */
static lam_part *add_part(lam_workshop *shop, const panel_set *set, int i, const char *name,
                          int class) {
  const lam_panel *panel = &set->panels[i];
  const lam_vec3 *x = panel->corner;
  lam_part part = {.name = name, .kind = "panels", .family = -1, .group = -1, .congruence = class};
  part.material = set->material[i];
  part.solid = lam_panel_solid(shop->arena, panel, &set->layer);

  double volume = lam_trimesh_volume(&part.solid);
  part.mass = volume * part.material->density;
  if (panel->flat) part.flat = lam_panel_flat(shop->arena, panel, &set->layer, name);

  const lam_fact facts[] = {{"mass", "kg", part.mass},
                            {"area", "m2", volume / set->keys->thickness},
                            {"side 1", "m", lam_distance(x[0], x[1])},
                            {"side 2", "m", lam_distance(x[1], x[2])},
                            {"side 3", "m", lam_distance(x[2], x[3])},
                            {"side 4", "m", lam_distance(x[3], x[0])},
                            {"warp", "m", panel->warp}};
  lam_part_set_facts(shop->arena, &part, facts, sizeof facts / sizeof facts[0]);
  return lam_workshop_part(shop, part);
}

/* ---- the report ---- */

/* Largest and mean of numbers that come one by one. */
typedef struct spread {
  double max, sum;
  long count;
} spread;

static void take(spread *s, double value) {
  s->max = s->count ? fmax(s->max, value) : value;
  s->sum += value;
  s->count++;
}

/* Adds a measure of a spread to a stage; nothing when it has no number. */
static void measure(lam_workshop *shop, lam_stage *stage, const char *name, const char *unit,
                    const spread *s) {
  if (s->count)
    lam_stage_measure(shop->arena, stage, name, unit, s->max, s->sum / (double)s->count, s->count);
}

/* What the measures do not say: panels without a pattern, open faces, a pattern of faces that does
 * not go on. warp: the largest, in mm. */
static void add_notes(lam_workshop *shop, lam_stage *stage, const panel_set *set, long twisted,
                      double warp) {
  if (twisted)
    lam_stage_note(shop->arena, stage,
                   "%ld of %d panels are twisted: their diagonals pass at up to %.3g mm; they have "
                   "no flat pattern",
                   twisted, set->count, warp);
  if (set->left_out)
    lam_stage_note(shop->arena, stage, "%ld faces are too small for the gap and stay open",
                   set->left_out);
  if (set->conflicts)
    lam_stage_note(shop->arena, stage, "the pattern of faces cannot be continued across %ld edges",
                   set->conflicts);
}

/* The stage "panels". first: index of the first part of the set; classes: how many different plates
 * its flat panels are. */
static void report(lam_workshop *shop, const panel_set *set, int first, int classes) {
  lam_stage *stage = lam_workshop_stage(shop, "panels");
  spread area = {0}, size = {0}, warp = {0}, mass = {0}, unsound = {0};
  long twisted = 0;
  for (int i = 0; i < set->count; i++) {
    const lam_part *part = &shop->parts[first + i];
    const lam_panel *panel = &set->panels[i];
    take(&mass, part->mass);
    take(&area, part->facts[1].value);
    take(&size, fmax(lam_distance(panel->corner[0], panel->corner[2]),
                     lam_distance(panel->corner[1], panel->corner[3])));
    take(&warp, panel->warp * 1e3);
    take(&unsound, !lam_part_is_sound(shop->arena, part));
    twisted += !panel->flat;
  }

  double n = (double)set->count;
  lam_stage_count(shop->arena, stage, "panel_count", n);
  measure(shop, stage, "panel_area", "m2", &area);
  measure(shop, stage, "panel_diagonal", "m", &size);
  measure(shop, stage, "panel_mass", "kg", &mass);
  lam_stage_measure(shop->arena, stage, "panel_mass_sum", "kg", mass.sum, mass.sum, set->count);
  measure(shop, stage, "warp", "mm", &warp);
  lam_stage_count(shop->arena, stage, "twisted_panels", twisted);
  lam_stage_count(shop->arena, stage, "distinct_panels", classes);
  lam_stage_count(shop->arena, stage, "unsound_panels", unsound.sum);

  stage->converged = unsound.sum == 0;
  if (!stage->converged) stage->reason = "solids that are not sound";
  add_notes(shop, stage, set, twisted, warp.max);
}

/* Panels of a row are named by its letters, from P on, and the number of their face. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const panels_keys *k = params;
  panel_set set = make_set(shop, k);
  if (!set.count) {
    lam_error_add(
        shop->errors, location, "gap",
        "%g mm between plates of %g mm leaves nothing of any of the %d faces: expected less",
        k->gap * 1e3, k->thickness * 1e3, shop->net->mesh.face_count);
    return;
  }

  int *class = LAM_NEW(shop->arena, int, set.count), first = shop->part_count, digits = 1;
  int classes =
      lam_panel_classes(shop->arena, set.panels, set.count, lam_workshop_next_class(shop), class);

  const char *letters = lam_part_letters(shop, 'P');
  for (int f = shop->net->mesh.face_count; f >= 10; f /= 10) digits++;
  for (int i = 0; i < set.count; i++) {
    const char *name = lam_arena_printf(shop->arena, "%s%0*d", letters, digits, set.face[i] + 1);
    lam_progress_tell(shop->progress, "panels", (double)i / set.count, name);
    add_part(shop, &set, i, name, class[i]);
  }

  report(shop, &set, first, classes);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(panels_keys, "thickness", thickness, "10 mm", 1e-5, 1,
                   "Thickness of the plates."),
    LAM_LENGTH_KEY(panels_keys, "gap", gap, "10 mm", 0, 1,
                   "Distance between neighboring plates where they come closest."),
    LAM_LENGTH_KEY(panels_keys, "offset", offset, "0", -10, 10,
                   "How far the plates stand off the net, along its normal."),
    LAM_CHOICE_KEY(
        panels_keys, "side", side, "outward", side_names,
        "Where the plate lies: on the side of the normal, centered on the net, or on the other "
        "side."),
    LAM_CHOICE_KEY(
        panels_keys, "faces", faces, "all", face_names,
        "Which faces carry panels: all, every second one as on a checkerboard, or every second "
        "band along a family."),
    LAM_NUMBER_KEY(panels_keys, "flat", flat, "0.001", 0, 0.1,
                   "A face becomes a flat plate when its diagonals pass at no more than this share "
                   "of their mean length; a twisted panel otherwise."),
    LAM_CHOICE_KEY(panels_keys, "material", material, "aluminum", lam_material_names,
                   "What the panels are made of."),
    LAM_CHOICE_KEY(
        panels_keys, "second", second, "aluminum", lam_material_names,
        "What the other faces of a checkerboard or of bands are made of. Left out: they stay open.",
        LAM_GIVEN(panels_keys, second_given)),
    {0}};

const lam_part_kind lam_part_panels = {
    .head = {.name = "panels",
             .title = "A plate on every face",
             .doc = "Faces whose corners lie in a plane become plates with square edges and a "
                    "flat pattern; the gap between neighbors is the same all over the net, "
                    "whatever the angle of the fold, and plates reach to the edge at the "
                    "boundary. Other faces become twisted panels, thickened bilinear patches that "
                    "have to be formed; the report says how many and how far they are from flat. "
                    "Panels are named after the number of their face: P001 and so on, Q001 in the "
                    "second row of panels of a design. A panel that hits another one shows in the "
                    "clash check: the net is folded too sharply there.",
             .source = "thesis 3.1, planar quadrilaterals as panels",
             .keys = keys,
             .params_size = sizeof(panels_keys)},
    .make = make};
