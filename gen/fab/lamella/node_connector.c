/* The row `node-connector`: two star washers and a bolt at every node of a grid of paired
 * lamellas. Called through the registry (fab/parts/part_kinds.c) by design/parts_stage.c. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/flat/path.h"
#include "fab/lamella/lamella_make.h"
#include "fab/part_names.h"
#include "fab/turned.h"
#include "fab/workshop.h"

typedef struct connector_keys {
  int bolt; /* index in bolts */
  double washer, gap, arm;
  int material;
} connector_keys;

/* Hexagon bolts (ISO 4017), nuts (ISO 4032) and medium holes (ISO 273), in millimeters. */
static const struct {
  double diameter, across_flats, head, nut, hole;
} bolts[] = {
    {6, 10, 4, 5.2, 6.6}, {8, 13, 5.3, 6.8, 9}, {10, 16, 6.4, 8.4, 11}, {12, 18, 7.5, 10.8, 13.5}};
static const char *const bolt_names[] = {"M6", "M8", "M10", "M12", NULL};

static const double mm = 1e-3;
static const double seat = 0.05e-3; /* between washer and head or nut: parts must not touch */
enum { corners = 24 };              /* of a circle; a multiple of 12 */

/* ---- radii of lines around the axis ---- */

/* The radii of a circle in n directions. */
static double *circle(lam_arena *arena, int n, double radius) {
  double *r = LAM_NEW(arena, double, n);
  for (int k = 0; k < n; k++) r[k] = radius;
  return r;
}

/* The radii of a hexagon with this distance across its flats, in n directions: r = (s/2) /
 * cos(distance of the angle from the middle of its side). */
static double *hexagon(lam_arena *arena, const double *angle, int n, double across_flats) {
  double *r = LAM_NEW(arena, double, n);
  for (int k = 0; k < n; k++) {
    double turn = angle[k] - floor(angle[k] / (LAM_PI / 3) + 1e-9) * LAM_PI / 3;
    r[k] = across_flats / 2 / cos(turn - LAM_PI / 6);
  }
  return r;
}

/* ---- the washer ---- */

/* Angles and radii of a star with four arms along +-x and +-y: half width w, tips at distance a
 * from the center. In the first half quadrant the outline is x = a as far as y = w, then y = w as
 * far as x = y. Corners of the circle that fall near those of the star give way to them. angle
 * and radius have room for star_corners numbers; returns how many there are, sorted by angle. */
static int star(double w, double a, double *angle, double *radius) {
  double tip = atan2(w, a);
  int n = 0;

  for (int k = 0; k < corners; k++) {
    double t = 2 * LAM_PI * k / corners, quarter = floor(t / (LAM_PI / 2) + 1e-9) * LAM_PI / 2,
           r = t - quarter;
    double ahead = r - tip, before = r - (LAM_PI / 2 - tip), step = 2 * LAM_PI / corners;
    if (fabs(ahead) < step / 4 || fabs(before) < step / 4) continue;

    /* r is the angle in its quadrant; quadrants are mirrored at their bisector. */
    double half = r > LAM_PI / 4 + 1e-9 ? LAM_PI / 2 - r : r;
    angle[n] = t;
    radius[n++] = half < tip ? a / cos(half) : w / sin(half);
  }

  for (int q = 0; q < 4; q++)
    for (int side = 0; side < 2; side++) {
      angle[n] = q * LAM_PI / 2 + (side ? LAM_PI / 2 - tip : tip);
      radius[n++] = hypot(a, w);
    }

  for (int i = 1; i < n; i++) /* by angle */
    for (int k = i; k > 0 && angle[k] < angle[k - 1]; k--) {
      double t = angle[k], r = radius[k];
      angle[k] = angle[k - 1], radius[k] = radius[k - 1];
      angle[k - 1] = t, radius[k - 1] = r;
    }
  return n;
}

enum { star_corners = corners + 8 };

/* The flat pattern of a washer: the star with a round hole. */
static lam_flat *washer_flat(lam_arena *arena, const double *angle, const double *radius, int n,
                             double thickness, double hole) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_vec2 outline[star_corners];
  for (int k = 0; k < n; k++)
    outline[k] = lam_v2(radius[k] * cos(angle[k]), radius[k] * sin(angle[k]));
  lam_paths_add(&paths, LAM_LAYER_CUT, true, n, outline);
  lam_paths_hole(&paths, lam_v2(0, 0), hole);

  flat->thickness = thickness;
  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* ---- parts ---- */

/* The pose of the connector of a node: z along the normal, x along the bisector of the two
 * families. The four crossings of the sheets of a node lie on the x and the y axis then, at any
 * crossing angle. below: turned over, by half a turn about x. */
static lam_pose node_frame(const lam_grid_node *node, bool below) {
  lam_vec3 x = lam_unit(lam_add(node->t[0], node->t[1])), z = node->normal;
  x = lam_unit(lam_along(x, -lam_dot(x, z), z));
  lam_vec3 y = lam_cross(z, x);
  if (below) y = lam_scale(y, -1), z = lam_scale(z, -1);
  return (lam_pose){node->x, {x, y, z}};
}

/* What washers and bolts have in common: kind, class, material and mass. */
static void finish(lam_workshop *shop, lam_part *part, const connector_keys *k) {
  part->kind = "node-connector";
  part->family = part->group = -1;
  part->congruence = lam_workshop_next_class(shop);
  part->material = &lam_materials[k->material];
  part->mass = lam_trimesh_volume(&part->solid) * part->material->density;
}

/* One part with two instances per node, above and below the edges of the lamellas. */
static void add_washers(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k) {
  double angle[star_corners], radius[star_corners], low = grid->height / 2 + k->gap,
                                                    high = low + k->washer;

  double width = bolts[k->bolt].across_flats * mm;
  int n = star(width / 2, k->arm, angle, radius);
  const double *hole = circle(shop->arena, n, bolts[k->bolt].hole * mm / 2);
  const lam_turned_line lines[] = {{low, radius}, {high, radius}, {high, hole}, {low, hole}};

  const char *name = lam_arena_printf(shop->arena, "washer-%s", bolt_names[k->bolt]);
  lam_part part = {.name = lam_part_name(shop, name)};
  part.solid = lam_turned_solid(shop->arena, angle, n, lines, 4, NULL);

  part.instance_count = 2 * grid->node_count;
  part.instances = LAM_NEW(shop->arena, lam_pose, part.instance_count);
  for (int i = 0; i < part.instance_count; i++)
    part.instances[i] = node_frame(&grid->nodes[i / 2], i % 2);

  part.flat = washer_flat(shop->arena, angle, radius, n, k->washer, bolts[k->bolt].hole * mm);
  finish(shop, &part, k);

  const lam_fact list[] = {{"mass", "kg", part.mass},
                           {"size", "m", 2 * k->arm},
                           {"thickness", "m", k->washer},
                           {"hole", "m", bolts[k->bolt].hole * mm}};
  lam_part_set_facts(shop->arena, &part, list, sizeof list / sizeof list[0]);
  lam_workshop_part(shop, part);
}

/* One part with an instance per node. From below: the end of the shank, the nut, the shank
 * between the washers, the head. Two lines at one height bound a flat ring. */
static void add_bolts(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k) {
  double angle[corners], outer = grid->height / 2 + k->gap + k->washer + seat;
  for (int i = 0; i < corners; i++) angle[i] = 2 * LAM_PI * i / corners;

  double diameter = bolts[k->bolt].diameter * mm,
         end = -outer - bolts[k->bolt].nut * mm - diameter / 4;
  const double *shank = circle(shop->arena, corners, diameter / 2);
  const double *hexagonal = hexagon(shop->arena, angle, corners, bolts[k->bolt].across_flats * mm);
  const lam_turned_line lines[] = {{end, shank},
                                   {-outer - bolts[k->bolt].nut * mm, shank},
                                   {-outer - bolts[k->bolt].nut * mm, hexagonal},
                                   {-outer, hexagonal},
                                   {-outer, shank},
                                   {outer, shank},
                                   {outer, hexagonal},
                                   {outer + bolts[k->bolt].head * mm, hexagonal}};

  const char *name = lam_arena_printf(shop->arena, "bolt-%s", bolt_names[k->bolt]);
  lam_part part = {.name = lam_part_name(shop, name)};
  const double poles[2] = {lines[0].z, lines[sizeof lines / sizeof lines[0] - 1].z};
  part.solid =
      lam_turned_solid(shop->arena, angle, corners, lines, sizeof lines / sizeof lines[0], poles);

  part.instance_count = grid->node_count;
  part.instances = LAM_NEW(shop->arena, lam_pose, part.instance_count);
  for (int i = 0; i < part.instance_count; i++)
    part.instances[i] = node_frame(&grid->nodes[i], false);
  finish(shop, &part, k);

  const lam_fact list[] = {{"mass", "kg", part.mass},
                           {"diameter", "m", diameter},
                           {"size", "m", outer - end},
                           {"grip", "m", 2 * outer}};
  lam_part_set_facts(shop->arena, &part, list, sizeof list / sizeof list[0]);
  lam_workshop_part(shop, part);
}

/* ---- the row ---- */

/* How far arms must reach: over the crossings of the sheets, which lie d / sin(a/2) from the node,
 * d half the distance of the sheets and a the smaller of the two angles between them. */
static double reach_at(double pair, double thickness, double angle) {
  return pair / 2 / sin(fmin(angle, LAM_PI - angle) / 2) + thickness;
}

/* The message for arms that do not reach so far, and whether there is one. */
static bool refuse_arm(const connector_keys *k, double reach, lam_location location,
                       lam_errors *errors) {
  if (k->arm >= reach) return false;
  lam_error_add(
      errors, location, "arm",
      "%g mm does not reach over the crossings of the sheets: at least %.1f mm are needed",
      k->arm * 1e3, reach * 1e3);
  return true;
}

/* Messages for sizes that do not fit pairs of sheets: the bolt needs the open square between them,
 * and arms must be longer than its head is wide. */
static void check_sizes(const connector_keys *k, double pair, double thickness,
                        lam_location location, lam_errors *errors) {
  double room = pair - thickness, bolt = bolts[k->bolt].diameter * mm;
  if (room < bolt + 1e-3)
    lam_error_add(errors, location, "bolt",
                  "%s does not fit between sheets that leave %.1f mm: at least %.1f mm are needed, "
                  "so a pair of at least %.1f mm",
                  bolt_names[k->bolt], room * 1e3, (bolt + 1e-3) * 1e3,
                  (bolt + 1e-3 + thickness) * 1e3);

  if (k->arm < bolts[k->bolt].across_flats * mm)
    lam_error_add(errors, location, "arm",
                  "%g mm is too short for the head of %s: at least %g mm are needed", k->arm * 1e3,
                  bolt_names[k->bolt], bolts[k->bolt].across_flats);
}

/* Messages for sizes that do not fit the grid. */
static void check_grid(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k,
                       lam_location location) {
  double reach = 0;
  for (int i = 0; i < grid->node_count; i++)
    reach = fmax(reach, reach_at(grid->pair, grid->thickness, grid->nodes[i].angle));
  refuse_arm(k, reach, location, shop->errors);
  check_sizes(k, grid->pair, grid->thickness, location, shop->errors);
}

static const char needs_pairs[] =
    "node-connector needs paired lamellas of both families before it: a lamella row with pair and "
    "families [0, 1]";

/* Nodes are those of the last lamella row; no sheets cross at more than a right angle. */
static void check(const lam_row *rows, int i, lam_errors *errors) {
  int last = i - 1;
  while (last >= 0 && rows[last].head != &lam_part_lamella.head) last--;
  const lam_lamella_keys *lamella = last >= 0 ? rows[last].params : NULL;
  if (!lamella || !(lamella->pair > 0) || lamella->families.count != 2) {
    lam_error_add(errors, rows[i].location, "kind", "%s", needs_pairs);
    return;
  }

  const connector_keys *k = rows[i].params;
  double least = reach_at(lamella->pair, lamella->thickness, LAM_PI / 2);
  refuse_arm(k, least, rows[i].location, errors);
  check_sizes(k, lamella->pair, lamella->thickness, rows[i].location, errors);
}

/* Needs the last lamella grid of the workshop, in pairs and with crossings. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const connector_keys *k = params;
  const lam_lamella_grid *grid = shop->lamella_grid;
  int before = shop->errors->count;
  if (!grid || !(grid->pair > 0) || !grid->node_count) {
    lam_error_add(shop->errors, location, "kind", "%s", needs_pairs);
    return;
  }

  check_grid(shop, grid, k, location);
  if (shop->errors->count > before) return;
  add_washers(shop, grid, k);
  add_bolts(shop, grid, k);
}

static const lam_key keys[] = {
    LAM_CHOICE_KEY(
        connector_keys, "bolt", bolt, "M8", bolt_names,
        "Thread of the bolt; head, nut and hole follow from it (ISO 4017, ISO 4032, ISO 273)."),
    LAM_LENGTH_KEY(connector_keys, "washer", washer, "4 mm", 1e-4, 0.1,
                   "Thickness of the star washers."),
    LAM_LENGTH_KEY(
        connector_keys, "gap", gap, "1 mm", 1e-5, 0.1,
        "Between the edges of the lamellas and the washers, for edges are twisted and curved."),
    LAM_LENGTH_KEY(connector_keys, "arm", arm, "28 mm", 1e-3, 1,
                   "From the center of a washer to the tip of an arm."),
    LAM_CHOICE_KEY(connector_keys, "material", material, "steel", lam_material_names,
                   "What washers and bolts are made of."),
    {0}};

const lam_part_kind lam_part_node_connector = {
    .head = {.name = "node-connector",
             .title = "Star washers and a bolt at every node",
             .doc = "Two star-shaped washers above and below the edges of paired lamellas and a "
                    "hexagon bolt with nut through the open square between the sheets. The arms "
                    "point along the bisectors of the node, where the four crossings of its "
                    "sheets lie at any angle, so that one washer and one bolt serve all nodes. "
                    "Threads are not modeled. Washers need a gap where edges are strongly curved: "
                    "the clash check tells.",
             .source = "thesis 2.1",
             .keys = keys,
             .params_size = sizeof(connector_keys)},
    .make = make,
    .check = check};
