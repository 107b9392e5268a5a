/* The row `node-connector`: two star washers and a bolt at every node of a grid of paired lamellas.
 */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/flat/path.h"
#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

#include <string.h>

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

/* ---- solids of rings ---- */

/* A ring: corners points at height z, at the distances radius[k] in the directions angle[k]. A
 * radius of 0 is a single point. */
typedef struct ring {
  double z;
  const double *radius;
} ring;

/* The solid between consecutive rings around the z axis; rings[0] and rings[count-1] are joined to
 * each other when closed (a solid with a hole), and are flat caps otherwise. The section (radius,
 * z) runs counterclockwise, seen with radius to the right and z up. */
static lam_trimesh ring_solid(lam_arena *arena, const double *angle, int n, const ring *rings,
                              int count, bool closed) {
  int caps = closed ? 0 : 2, bands = closed ? count : count - 1;
  lam_trimesh mesh = {n * count + caps, LAM_NEW(arena, lam_vec3, n * count + caps), 0, NULL};
  mesh.triangles =
      (int(*)[3])lam_arena_alloc(arena, (size_t)(2 * n * bands + caps * n), sizeof *mesh.triangles);
  for (int r = 0; r < count; r++)
    for (int k = 0; k < n; k++)
      mesh.vertices[r * n + k] = lam_v3(rings[r].radius[k] * cos(angle[k]),
                                        rings[r].radius[k] * sin(angle[k]), rings[r].z);
  for (int r = 0; r < bands; r++)
    for (int k = 0; k < n; k++) {
      int next = (k + 1) % n, up = (r + 1) % count;
      int a = r * n + k, b = r * n + next, c = up * n + next, d = up * n + k;
      memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){a, b, c}, sizeof(int[3]));
      memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){a, c, d}, sizeof(int[3]));
    }
  if (closed) return mesh;
  int low = n * count, high = low + 1;
  mesh.vertices[low] = lam_v3(0, 0, rings[0].z);
  mesh.vertices[high] = lam_v3(0, 0, rings[count - 1].z);
  for (int k = 0; k < n; k++) {
    int next = (k + 1) % n, top = (count - 1) * n;
    memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){low, next, k}, sizeof(int[3]));
    memcpy(mesh.triangles[mesh.triangle_count++], (int[3]){high, top + k, top + next},
           sizeof(int[3]));
  }
  return mesh;
}

/* A circle as a regular polygon around it (outside) or in it. */
static double *circle(lam_arena *arena, int n, double radius) {
  double *r = LAM_NEW(arena, double, n);
  for (int k = 0; k < n; k++) r[k] = radius;
  return r;
}

/* A hexagon with this distance across its flats: r = (s/2) / cos(distance of the angle from the
 * middle of its side). */
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
 * far as x = y. Corners of the circle that fall near those of the star give way to them. */
static int star(double w, double a, double *angle, double *radius) {
  double tip = atan2(w, a);
  int n = 0;
  for (int k = 0; k < corners; k++) {
    double t = 2 * LAM_PI * k / corners, quarter = floor(t / (LAM_PI / 2) + 1e-9) * LAM_PI / 2,
           r = t - quarter;
    double half = r > LAM_PI / 4 + 1e-9 ? LAM_PI / 2 - r : r;
    double ahead = r - tip, before = r - (LAM_PI / 2 - tip), step = 2 * LAM_PI / corners;
    if (fabs(ahead) < step / 4 || fabs(before) < step / 4) continue;
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

static lam_flat *washer_flat(lam_arena *arena, const double *angle, const double *radius, int n,
                             double thickness, double hole) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_vec2 outline[star_corners];
  for (int k = 0; k < n; k++)
    outline[k] = lam_v2(radius[k] * cos(angle[k]), radius[k] * sin(angle[k]));
  lam_paths_add(&paths, LAM_LAYER_CUT, true, n, outline);
  lam_paths_hole(&paths, lam_v2(0, 0), hole);
  flat->paths = paths.items;
  flat->path_count = paths.count;
  flat->thickness = thickness;
  lam_paths_bounds(paths.items, paths.count, &flat->min, &flat->max);
  return flat;
}

/* ---- parts ---- */

/* z along the normal, x along the bisector of the two families: the four crossings of the sheets of
 * a node lie on the x and the y axis, at any crossing angle. */
static lam_pose node_frame(const lam_grid_node *node, bool below) {
  lam_vec3 x = lam_unit(lam_add(node->t[0], node->t[1])), z = node->normal;
  x = lam_unit(lam_along(x, -lam_dot(x, z), z));
  lam_vec3 y = lam_cross(z, x);
  if (below) y = lam_scale(y, -1), z = lam_scale(z, -1);
  return (lam_pose){node->x, {x, y, z}};
}

static void finish(lam_workshop *shop, lam_part *part, const connector_keys *k) {
  part->kind = "node-connector";
  part->family = part->group = -1;
  part->congruence = lam_workshop_next_class(shop);
  part->material = &lam_materials[k->material];
  part->mass = lam_trimesh_volume(&part->solid) * part->material->density;
}

static void add_washers(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k) {
  double angle[star_corners], radius[star_corners], low = grid->height / 2 + k->gap,
                                                    high = low + k->washer;
  double width = bolts[k->bolt].across_flats * mm;
  int n = star(width / 2, k->arm, angle, radius);
  const double *hole = circle(shop->arena, n, bolts[k->bolt].hole * mm / 2);
  const ring rings[] = {{low, radius}, {high, radius}, {high, hole}, {low, hole}};
  lam_part part = {.name = lam_arena_printf(shop->arena, "washer-%s", bolt_names[k->bolt])};
  part.solid = ring_solid(shop->arena, angle, n, rings, 4, true);
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

static void add_bolts(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k) {
  double angle[corners], outer = grid->height / 2 + k->gap + k->washer + seat;
  for (int i = 0; i < corners; i++) angle[i] = 2 * LAM_PI * i / corners;
  double diameter = bolts[k->bolt].diameter * mm,
         end = -outer - bolts[k->bolt].nut * mm - diameter / 4;
  const double *shank = circle(shop->arena, corners, diameter / 2);
  const double *hexagonal = hexagon(shop->arena, angle, corners, bolts[k->bolt].across_flats * mm);
  const ring rings[] = {{end, shank},
                        {-outer - bolts[k->bolt].nut * mm, shank},
                        {-outer - bolts[k->bolt].nut * mm, hexagonal},
                        {-outer, hexagonal},
                        {-outer, shank},
                        {outer, shank},
                        {outer, hexagonal},
                        {outer + bolts[k->bolt].head * mm, hexagonal}};
  lam_part part = {.name = lam_arena_printf(shop->arena, "bolt-%s", bolt_names[k->bolt])};
  part.solid =
      ring_solid(shop->arena, angle, corners, rings, sizeof rings / sizeof rings[0], false);
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

/* The bolt needs the open square between the sheets; arms must reach over the crossings of the
 * sheets, which lie at most d / sin(a/2) from the node for the smaller a of the two angles there.
 */
static void check(lam_workshop *shop, const lam_lamella_grid *grid, const connector_keys *k,
                  lam_location location) {
  double room = grid->pair - grid->thickness, bolt = bolts[k->bolt].diameter * mm, reach = 0;
  if (room < bolt + 1e-3)
    lam_error_add(shop->errors, location, "bolt",
                  "%s does not fit between sheets that leave %.1f mm: at least %.1f mm are needed, "
                  "so a pair of at least %.1f mm",
                  bolt_names[k->bolt], room * 1e3, (bolt + 1e-3) * 1e3,
                  (bolt + 1e-3 + grid->thickness) * 1e3);
  for (int i = 0; i < grid->node_count; i++) {
    double a = fmin(grid->nodes[i].angle, LAM_PI - grid->nodes[i].angle);
    reach = fmax(reach, grid->pair / 2 / sin(a / 2) + grid->thickness);
  }
  if (k->arm < reach)
    lam_error_add(
        shop->errors, location, "arm",
        "%g mm does not reach over the crossings of the sheets: at least %.1f mm are needed",
        k->arm * 1e3, reach * 1e3);
  if (k->arm < bolts[k->bolt].across_flats * mm)
    lam_error_add(shop->errors, location, "arm",
                  "%g mm is too short for the head of %s: at least %g mm are needed", k->arm * 1e3,
                  bolt_names[k->bolt], bolts[k->bolt].across_flats);
}

static void make(lam_workshop *shop, const void *params, lam_location location) {
  const connector_keys *k = params;
  const lam_lamella_grid *grid = shop->lamella_grid;
  int before = shop->errors->count;
  if (!grid || !(grid->pair > 0) || !grid->node_count) {
    lam_error_add(shop->errors, location, "kind",
                  "node-connector needs paired lamellas of both families before it: a lamella row "
                  "with pair and families [0, 1]");
    return;
  }
  check(shop, grid, k, location);
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
                    "hexagon bolt with nut "
                    "through the open "
                    "square between the sheets. The arms point along the bisectors of the node, "
                    "where the four "
                    "crossings of its "
                    "sheets lie at any angle, so that one washer and one bolt serve all nodes. "
                    "Threads are not "
                    "modeled. Washers "
                    "need a gap where edges are strongly curved: the clash check tells.",
             .source = "thesis 2.1",
             .keys = keys,
             .params_size = sizeof(connector_keys)},
    .make = make};
