/* The row `lamella`: strips normal to the net along its polylines, with half-lap slots. Its make
 * function is called through the registry (fab/parts/part_kinds.c) by design/parts_stage.c; the
 * geometry stands in lamella_grid.c, lamella_solid.c and lamella_flat.c. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/lamella/lamella_checks.h"
#include "fab/lamella/lamella_flat.h"
#include "fab/lamella/lamella_make.h"

#include <string.h>

/* ---- keys ---- */
static const char *const joint_kinds[] = {
    [LAM_JOINT_HALF_LAP] = "half-lap", [LAM_JOINT_NONE] = "none", NULL};

static const lam_key joint_keys[] = {
    LAM_CHOICE_KEY(lam_joint_keys, "kind", kind, "half-lap", joint_kinds,
                   "half-lap: both lamellas are slotted to mid height, family 0 from above and "
                   "family 1 from below; none: they run through each other."),
    LAM_LENGTH_KEY(lam_joint_keys, "clearance", clearance, "0.25 mm", 1e-5, 0.01,
                   "Gap between a slot and the partner on either side, and half the gap between "
                   "the two floors."),
    LAM_ANGLE_KEY(lam_joint_keys, "scissor", scissor, "0", 0, 1.5707963267948966,
                  "The smallest angle to which nodes may be turned during erection, both ways: "
                  "slots are widened for it; 0: nodes do not turn."),
    {0}};

static const lam_key keys[] = {
    LAM_INTEGER_KEY(lam_lamella_keys, "families", families, "[0, 1]", 0, 1,
                    "The families of polylines that carry lamellas."),
    LAM_LENGTH_KEY(lam_lamella_keys, "height", height, "100 mm", 1e-3, 10,
                   "Width of the strip, along the normal of the net; the net is at its middle."),
    LAM_LENGTH_KEY(lam_lamella_keys, "thickness", thickness, "1.5 mm", 1e-5, 1,
                   "Thickness of the sheet."),
    LAM_LENGTH_KEY(lam_lamella_keys, "pair", pair, "0", 0, 10,
                   "Distance between the middle planes of the two sheets of a lamella; 0: a "
                   "lamella is one sheet on the polyline."),
    LAM_INTEGER_KEY(
        lam_lamella_keys, "every", every, "1", 1, 1000,
        "Every k-th polyline of a family carries a lamella. The first and the last polyline are "
        "among them where k divides their distance; a finer net gives smoother lamellas."),
    LAM_LENGTH_KEY(lam_lamella_keys, "extend", extend, "50 mm", 0, 10,
                   "How far lamellas run on straight past their last crossing (past the end of the "
                   "polyline when nothing crosses)."),
    LAM_MAP_KEY(lam_lamella_keys, "joint", joint, "half-lap", joint_keys,
                "How lamellas of the two families pass each other."),
    LAM_CHOICE_KEY(lam_lamella_keys, "material", material, "steel", lam_material_names,
                   "What the sheets are made of."),
    LAM_FLAG_KEY(lam_lamella_keys, "boundary", boundary, "yes",
                 "Whether polylines along the boundary of the net carry lamellas."),
    {0}};

/* ---- checks of keys taken together ---- */
/* Messages for keys that fit their ranges but not each other. */
static void check_keys(const lam_lamella_keys *k, lam_location location, lam_errors *errors) {
  const int *family = k->families.items;
  double needed = k->thickness + 2 * k->joint.clearance;

  if (k->families.count < 1 || k->families.count > 2 ||
      (k->families.count == 2 && family[0] == family[1]))
    lam_error_add(errors, location, "families", "expected [0], [1] or [0, 1]");

  if (k->pair > 0 && k->pair < needed)
    lam_error_add(
        errors, location, "pair",
        "%g mm is less than the thickness and twice the clearance: expected 0 or at least %g mm",
        k->pair * 1e3, needed * 1e3);

  if (k->height < 8 * k->joint.clearance)
    lam_error_add(errors, location, "joint.clearance",
                  "%g mm is too much for a height of %g mm: expected at most %g mm",
                  k->joint.clearance * 1e3, k->height * 1e3, k->height / 8 * 1e3);
  if (k->height < k->thickness)
    lam_error_add(errors, location, "height", "%g mm is less than the thickness of %g mm",
                  k->height * 1e3, k->thickness * 1e3);
}

static bool has_family(const lam_lamella_keys *k, int family) {
  for (int i = 0; i < k->families.count; i++)
    if (((const int *)k->families.items)[i] == family) return true;
  return false;
}

/* A family has its lamellas once. */
static void check_row(const lam_row *rows, int i, lam_errors *errors) {
  const lam_lamella_keys *k = rows[i].params;
  check_keys(k, rows[i].location, errors);

  for (int family = 0; family < 2; family++)
    for (int before = 0; before < i && has_family(k, family); before++) {
      if (rows[before].head != rows[i].head || !has_family(rows[before].params, family)) continue;
      lam_error_add(errors, rows[i].location, "families",
                    "family %d has lamellas already, by parts[%d]; expected the other one", family,
                    before);
    }
}

/* Lamellas are slotted from two sides. */
static void check_net(lam_workshop *shop, lam_location location) {
  if (shop->net->family_conflicts)
    lam_error_add(shop->errors, location, NULL,
                  "the polylines of this net do not fall into two families (%d edges in "
                  "conflict), so lamellas cannot be slotted from two sides",
                  shop->net->family_conflicts);
}

/* A second row may carry another family: names are unique as long as no family has lamellas
 * twice. */
static void check_names(lam_workshop *shop, const lam_lamella_grid *grid, lam_location location) {
  for (int i = 0; i < grid->strip_count; i++)
    for (int k = 0; k < shop->part_count; k++)
      if (strcmp(shop->parts[k].name, grid->strips[i].name) == 0) {
        lam_error_add(shop->errors, location, "families",
                      "family %d has lamellas already (part %s)", grid->strips[i].family,
                      grid->strips[i].name);
        return;
      }
}

/* The least distance between neighboring nodes of a lamella, m; infinite when none has two. */
static double least_spacing(lam_workshop *shop, const lam_lamella_grid *grid) {
  const lam_grid_node **node_at =
      LAM_NEW(shop->arena, const lam_grid_node *, shop->net->mesh.vertex_count);
  for (int i = 0; i < grid->node_count; i++) node_at[grid->nodes[i].vertex] = &grid->nodes[i];

  double least = INFINITY;
  for (int i = 0; i < grid->strip_count; i++) {
    const lam_polyline *axis = &grid->axes[grid->strips[i].group];
    const lam_grid_node *before = NULL;
    for (int k = 0; k < axis->count; k++) {
      const lam_grid_node *node = node_at[axis->vertices[k]];
      if (node && before) least = fmin(least, lam_distance(node->x, before->x));
      if (node) before = node;
    }
  }
  return least;
}

/* Sheets of a pair that are farther apart than its nodes would stand behind each other's slots. */
static void check_pair(lam_workshop *shop, const lam_lamella_keys *k, const lam_lamella_grid *grid,
                       lam_location location) {
  double least = k->pair > 0 ? least_spacing(shop, grid) : INFINITY;
  if (k->pair + k->thickness < least) return;
  lam_error_add(shop->errors, location, "pair",
                "%g mm; expected less than %.0f mm, as the nearest crossings of a lamella are %.0f "
                "mm apart",
                k->pair * 1e3, fmax(0, least - k->thickness) * 1e3, least * 1e3);
}

/* ---- records for OpenSCAD ---- */
static const lam_record_column columns[] = {
    {"x", true, 4},        {"y", true, 4},         {"z", true, 4},        {"tx", false, 7},
    {"ty", false, 7},      {"tz", false, 7},       {"mx", false, 7},      {"my", false, 7},
    {"mz", false, 7},      {"s", true, 4},         {"partner", false, 0}, {"slot_angle", false, 6},
    {"slot_low", true, 4}, {"slot_high", true, 4}, {"heading", false, 7}};
enum { column_count = sizeof columns / sizeof columns[0] };

/* The stations of a strip as the table that lamella.scad rebuilds it from: a row per station. The
 * heading is that of the pattern: none where it is cut straight. */
static lam_record *make_record(lam_arena *arena, const lam_lamella_grid *grid,
                               const lam_sheet_strip *strip) {
  double *value = LAM_NEW(arena, double, column_count * strip->station_count);
  lam_record *record = LAM_NEW(arena, lam_record, 1);
  *record = (lam_record){strip->name, strip->family, column_count, strip->station_count, value};
  bool straight = lam_lamella_is_straight(arena, strip);

  for (int i = 0; i < strip->station_count; i++) {
    const lam_station *q = &strip->stations[i];
    const double row[column_count] = {q->x.x,
                                      q->x.y,
                                      q->x.z,
                                      q->t.x,
                                      q->t.y,
                                      q->t.z,
                                      q->m.x,
                                      q->m.y,
                                      q->m.z,
                                      q->s,
                                      q->partner < 0 ? -1 : grid->strips[q->partner].part,
                                      q->slot_angle / LAM_DEGREE,
                                      q->slot_low,
                                      q->slot_high,
                                      straight ? 0 : q->heading / LAM_DEGREE};

    memcpy(value + i * column_count, row, sizeof row);
  }
  return record;
}

/* Adds the kind of records with the settings that all lamellas share. Records of one kind share
 * their settings: false when an earlier row has others, and OpenSCAD is given solids then. */
static bool add_record_kind(lam_workshop *shop, const lam_lamella_grid *grid,
                            const lam_lamella_keys *k) {
  const lam_setting all[] = {
      {"height", "Sheet", "[20:1:300]", "Width of the strips", grid->height, true},
      {"thickness", "Sheet", "[0.5:0.1:20]", "Thickness of the sheet", grid->thickness, true},
      {"clearance", "Joint", "[0.01:0.01:2]", "Gap on either side of a slot", grid->clearance,
       true},
      {"slots", "Joint", "[0:1:1]", "1: with slots, 0: without",
       k->joint.kind == LAM_JOINT_HALF_LAP, false}};
  enum { count = sizeof all / sizeof all[0] };

  for (int i = 0; i < shop->record_kind_count; i++) {
    if (strcmp(shop->record_kinds[i].kind, "lamella") != 0) continue;
    for (int s = 0; s < count; s++)
      if (shop->record_kinds[i].settings[s].value != all[s].value) return false;
    return true;
  }

  lam_setting *settings = LAM_NEW(shop->arena, lam_setting, count);
  memcpy(settings, all, sizeof all);
  lam_workshop_record_kind(
      shop, (lam_record_kind){"lamella", "lamella.scad", column_count, columns, count, settings});
  return true;
}

/* ---- parts ---- */
/* The facts of a strip for the bill of materials; count receives their number. */
static lam_fact *make_facts(lam_arena *arena, const lam_part *part, const lam_strip_measures *m,
                            int *count) {
  const lam_fact facts[] = {{"length", "m", part->length},
                            {"mass", "kg", part->mass},
                            {"slots", "", m->slots},
                            {"bending strain", "", m->bending_strain},
                            {"twist strain", "", m->twist_strain},
                            {"edge strain", "", m->edge_strain},
                            {"unrolled straightness", "", m->straightness}};
  *count = sizeof facts / sizeof facts[0];
  lam_fact *copy = LAM_NEW(arena, lam_fact, *count);
  memcpy(copy, facts, sizeof facts);
  return copy;
}

/* The part of one strip: solid, mass, record (when its settings fit the kind) and facts. */
static void add_part(lam_workshop *shop, const lam_lamella_grid *grid, const lam_sheet_strip *strip,
                     int class, bool record, const lam_strip_measures *measures) {
  lam_part part = {.name = strip->name,
                   .kind = "lamella",
                   .family = strip->family,
                   .group = strip->group,
                   .congruence = class,
                   .material = grid->material,
                   .length = strip->length};

  part.solid = lam_lamella_solid(shop->arena, grid, strip);
  part.mass = lam_trimesh_volume(&part.solid) * grid->material->density;
  if (record) part.record = make_record(shop->arena, grid, strip);
  part.facts = make_facts(shop->arena, &part, measures, &part.fact_count);
  lam_workshop_part(shop, part);
}

/* Where a node of the grid lies along a strip that passes it: the mean over the strip's crossings
 * there, which are two when the partner is a pair. */
static double node_along(const lam_sheet_strip *strip, int node) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < strip->station_count; i++) {
    if (strip->stations[i].between || strip->stations[i].crossing != node) continue;
    sum += strip->stations[i].s;
    count++;
  }
  return sum / count;
}

/* A crossing of lamellas for every node of the grid, with its place on every sheet: the sheets of a
 * pair do not begin beside each other. In pairs its parts are the first sheets of both lamellas. */
static void add_crossings(lam_workshop *shop, const lam_lamella_grid *grid) {
  int sheets = grid->pair > 0 ? 2 : 1;
  for (int i = 0; i < grid->node_count; i++) {
    const lam_grid_node *node = &grid->nodes[i];
    lam_crossing c = {
        .position = node->x, .normal = node->normal, .angle = node->angle, .flat_angle = NAN};

    for (int f = 0; f < 2; f++) {
      const lam_sheet_strip *strip = &grid->strips[node->lamella[f] * sheets];
      c.parts[f] = strip->part;
      c.along[f] = node_along(strip, i);
      c.second[f] = sheets == 2 ? node_along(strip + 1, i) : NAN;
    }

    lam_workshop_crossing(shop, c);
  }
}

/* One curve for each lamella, also when it is a pair of sheets. */
static void add_axes(lam_workshop *shop, const lam_lamella_grid *grid) {
  for (int i = 0; i < grid->strip_count; i++) {
    const lam_sheet_strip *strip = &grid->strips[i];
    if (i && strip[-1].group == strip->group) continue;
    lam_workshop_curve(shop,
                       lam_arena_printf(shop->arena, "%c%02d", 'A' + strip->family, strip->number),
                       &grid->axes[strip->group]);
  }
}

/* Keys are checked first, then the net against them; parts are made only when nothing is wrong.
 * The order of the steps matters: flat patterns and crossings refer to the parts of the strips. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const lam_lamella_keys *k = params;
  lam_lamella_grid *grid = LAM_NEW(shop->arena, lam_lamella_grid, 1);
  int before = shop->errors->count;

  check_keys(k, location, shop->errors);
  check_net(shop, location);
  if (shop->errors->count > before ||
      !lam_lamella_layout(shop, k, location, shop->part_count, grid))
    return;

  check_names(shop, grid, location);
  check_pair(shop, k, grid, location);
  if (!grid->strip_count)
    lam_error_add(shop->errors, location, "families", "the net has no polylines of these families");
  if (shop->errors->count > before) return;

  int *class = LAM_NEW(shop->arena, int, grid->strip_count);
  lam_lamella_classes(shop->arena, grid, lam_workshop_next_class(shop), class);
  bool record = add_record_kind(shop, grid, k);
  lam_strip_measures *measures = LAM_NEW(shop->arena, lam_strip_measures, grid->strip_count);
  for (int i = 0; i < grid->strip_count; i++) {
    lam_progress_tell(shop->progress, "lamellas", (double)i / grid->strip_count,
                      grid->strips[i].name);
    measures[i] = lam_strip_measure(shop->arena, grid, &grid->strips[i]);
    add_part(shop, grid, &grid->strips[i], class[i], record, &measures[i]);
  }

  add_axes(shop, grid);
  shop->lamella_grid = grid;
  lam_lamella_flats(shop);
  add_crossings(shop, grid);
  lam_lamella_stage(shop, grid, measures);
}

const lam_part_kind lam_part_lamella = {
    .head = {.name = "lamella",
             .title = "Lamellas with half-lap slots",
             .doc = "Strips of sheet that stand normal to the net along its polylines, single or "
                    "in pairs, slotted where they cross: family 0 opens up, family 1 opens down. "
                    "They are named A01, A02 and so on in family 0, B01 and so on in family 1, "
                    "with a and b for the left and the right sheet of a pair. On an asymptotic "
                    "net they unroll to straight strips; on other nets they do not, and the "
                    "report says by how much. A lamella along a closed polyline is cut once, "
                    "midway between two nodes. At an irregular vertex, where more than two "
                    "lamellas meet, they end short of it.",
             .equation = "material { x + h m + y b : |h| <= height/2, |y| <= thickness/2 }, m "
                         "normal to the net, b = m x t; slot width = thickness (1 + |cos a|) / "
                         "sin a + 2 clearance; a partner at distance e from the node, on a sheet "
                         "at distance d, stands at (d cos a - e) / sin a",
             .source = "thesis 2.1, 3.2.4, fig. 3.21",
             .keys = keys,
             .params_size = sizeof(lam_lamella_keys)},
    .make = make,
    .check = check_row};
