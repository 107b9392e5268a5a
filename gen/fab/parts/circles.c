/* The row `circles`: rings on the circles of the faces, and balls at the vertices. Called through
 * the registry (part_kinds.c) by design/parts_stage.c. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/flat/path.h"
#include "fab/turned.h"
#include "fab/workshop.h"
#include "mesh/tangential.h"

#include <string.h>

enum { CIRCLES_IN, CIRCLES_AROUND, CIRCLES_NONE };
static const char *const circle_names[] = {"incircles", "circumcircles", "none", NULL};

enum { corners = lam_turned_corners }; /* of a ring */

/* The keys of a row, in meters. */
typedef struct circles_keys {
  double width, thickness, gap;
  int circles, material;
  bool spheres, drawn;
} circles_keys;

/* A circle of a face, or a sphere at a vertex. */
typedef struct circle {
  lam_pose frame; /* z along the axis */
  double radius;
} circle;

/* ---- flat patterns ---- */

/* The flat pattern of a ring: a regular polygon like that of the solid, with a round hole. */
static lam_flat *ring_flat(lam_arena *arena, double inner, double outer, double thickness) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_vec2 outline[corners];
  for (int k = 0; k < corners; k++)
    outline[k] =
        lam_v2(outer * cos(2 * LAM_PI * k / corners), outer * sin(2 * LAM_PI * k / corners));
  lam_paths_add(&paths, LAM_LAYER_CUT, true, corners, outline);
  lam_paths_hole(&paths, lam_v2(0, 0), 2 * inner);

  flat->thickness = thickness;
  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* ---- where they are ---- */

/* The frame with z along the unit normal and x towards a point, made perpendicular to it. */
static lam_pose frame_of(lam_vec3 origin, lam_vec3 normal, lam_vec3 towards) {
  lam_vec3 x = lam_sub(towards, origin);
  x = lam_unit(lam_along(x, -lam_dot(x, normal), normal));
  return (lam_pose){origin, {x, lam_cross(normal, x), normal}};
}

/* Circle through three corners: center a + ((|B|^2 C - |C|^2 B) x M) / (2 |M|^2), with B and C
 * the other two seen from a and M = B x C. */
static circle circumcircle(const lam_vec3 *c) {
  lam_vec3 B = lam_sub(c[1], c[0]), C = lam_sub(c[2], c[0]), M = lam_cross(B, C);
  lam_vec3 mixed = lam_sub(lam_scale(C, lam_dot(B, B)), lam_scale(B, lam_dot(C, C)));
  lam_vec3 center = lam_along(c[0], .5 / lam_dot(M, M), lam_cross(mixed, M));
  return (circle){frame_of(center, lam_unit(M), c[0]), lam_distance(c[0], center)};
}

/* The incircle of a tangential quad (mesh/tangential.h). */
static circle incircle(const lam_vec3 *c) {
  lam_incircle found = lam_incircle_of(c);
  return (circle){frame_of(found.center, found.normal, c[0]), found.radius};
}

/* The circle of every face that the key `circles` asks for. */
static circle *face_circles(const lam_workshop *shop, const circles_keys *k) {
  const lam_mesh *mesh = &shop->net->mesh;
  circle *circles = LAM_NEW(shop->arena, circle, mesh->face_count);
  for (int f = 0; f < mesh->face_count; f++) {
    lam_vec3 c[4];
    for (int i = 0; i < 4; i++) c[i] = mesh->vertices[mesh->faces[f][i]];
    circles[f] = k->circles == CIRCLES_IN ? incircle(c) : circumcircle(c);
  }
  return circles;
}

/* The sphere of every vertex, as large as the incircles around it allow (lam_net_sphere_radii). */
static circle *vertex_spheres(const lam_workshop *shop) {
  const lam_mesh *mesh = &shop->net->mesh;
  double *radii = LAM_NEW(shop->arena, double, mesh->vertex_count);
  circle *spheres = LAM_NEW(shop->arena, circle, mesh->vertex_count);
  lam_net_sphere_radii(shop->net, mesh->vertices, radii);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_vec3 to = mesh->vertices[shop->net->ring[shop->net->ring_start[v]]];
    spheres[v] = (circle){frame_of(mesh->vertices[v], shop->normals[v], to), radii[v]};
  }
  return spheres;
}

/* ---- parts ---- */

/* What was made of one kind: how many instances, how many parts, the largest outer radius and the
 * sum of all. */
typedef struct summary {
  long count, kinds, left_out, unsound;
  double largest, sum;
} summary;

/* How many kinds of rings or balls earlier rows of the design made. */
static int kinds_before(const lam_workshop *shop, const char *noun) {
  int count = 0;
  for (int i = 0; i < shop->part_count; i++)
    count += strcmp(shop->parts[i].kind, "circles") == 0 &&
             strncmp(shop->parts[i].name, noun, strlen(noun)) == 0;
  return count;
}

/* The circles from number i on that have its radius, to a millionth of it, as instances of a part;
 * they are done then. */
static void take_equal(lam_arena *arena, const circle *circles, int count, int i, bool *done,
                       lam_part *part) {
  static const double same = 1e-6;
  part->instances = LAM_NEW(arena, lam_pose, count - i);
  for (int j = i; j < count; j++)
    if (!done[j] && fabs(circles[j].radius - circles[i].radius) <= same * circles[i].radius) {
      done[j] = true;
      part->instances[part->instance_count++] = circles[j].frame;
    }
}

/* Gives a part the solid, pattern, mass and facts of a ball of radius outer, or of a ring between
 * two radii. */
static void shape(lam_arena *arena, const circles_keys *k, bool ball, double inner, double outer,
                  lam_part *part) {
  part->drawn = k->drawn;
  part->material = &lam_materials[k->material];
  part->solid = ball ? lam_ball(arena, outer) : lam_ring(arena, inner, outer, k->thickness);
  if (!ball && !k->drawn) part->flat = ring_flat(arena, inner, outer, k->thickness);
  part->mass = lam_trimesh_volume(&part->solid) * part->material->density;
  const lam_fact facts[] = {{"diameter", "m", 2 * outer}, {"mass", "kg", part->mass}};
  lam_part_set_facts(arena, part, facts, 2);
}

/* One part for all circles of one radius, with as many instances as there are circles. Circles that
 * are too small for the width and the gap are counted and left out. */
static summary add_parts(lam_workshop *shop, const circles_keys *k, const circle *circles,
                         int count, bool balls) {
  summary s = {0};
  const char *noun = balls ? "ball" : "ring";
  int before = kinds_before(shop, noun);
  bool *done = LAM_NEW(shop->arena, bool, count);
  for (int i = 0; i < count; i++) {
    double outer = circles[i].radius - k->gap / 2, inner = outer - k->width;
    if (done[i]) continue;
    if (!(balls ? outer > 0 : inner > outer / 100)) {
      s.left_out++;
      continue;
    }

    lam_part part = {
        .kind = "circles", .family = -1, .group = -1, .congruence = lam_workshop_next_class(shop)};
    part.name = lam_arena_printf(shop->arena, "%s-%03ld", noun, before + ++s.kinds);
    take_equal(shop->arena, circles, count, i, done, &part);
    shape(shop->arena, k, balls, inner, outer, &part);

    s.unsound += !lam_part_is_sound(shop->arena, &part);
    s.count += part.instance_count;
    s.largest = fmax(s.largest, outer);
    s.sum += outer * part.instance_count;
    lam_workshop_part(shop, part);
  }
  return s;
}

/* Adds the measures of one kind under the given names; diameters are outer ones. */
static void tell(lam_workshop *shop, lam_stage *stage, const summary *s, const char *count,
                 const char *diameter, const char *distinct) {
  if (s->left_out)
    lam_stage_note(shop->arena, stage, "%ld circles are too small for their width", s->left_out);
  if (!s->count) return;
  double n = (double)s->count;
  lam_stage_count(shop->arena, stage, count, n);
  lam_stage_measure(shop->arena, stage, diameter, "m", 2 * s->largest, 2 * s->sum / n, s->count);
  lam_stage_count(shop->arena, stage, distinct, s->kinds);
}

/* Rings first, then balls; nothing at all to make is an error. */
static void check(const lam_row *rows, int i, lam_errors *errors) {
  const circles_keys *k = rows[i].params;
  if (k->circles == CIRCLES_NONE && !k->spheres)
    lam_error_add(errors, rows[i].location, "spheres",
                  "nothing to make: circles: none and spheres: no");
}

static void make(lam_workshop *shop, const void *params, lam_location location) {
  const circles_keys *k = params;
  const lam_mesh *mesh = &shop->net->mesh;
  summary rings = {0}, balls = {0};
  if (k->circles != CIRCLES_NONE)
    rings = add_parts(shop, k, face_circles(shop, k), mesh->face_count, false);
  if (k->spheres) balls = add_parts(shop, k, vertex_spheres(shop), mesh->vertex_count, true);

  if (!rings.count && !balls.count) {
    lam_error_add(shop->errors, location, "width",
                  "no circle is large enough for rings of this width and gap; expected less");
    return;
  }

  lam_stage *stage = lam_workshop_stage(shop, "circles");
  tell(shop, stage, &rings, "ring_count", "ring_diameter", "distinct_rings");
  tell(shop, stage, &balls, "ball_count", "ball_diameter", "distinct_balls");

  double unsound = (double)(rings.unsound + balls.unsound);
  lam_stage_count(shop->arena, stage, "unsound_parts", unsound);
  stage->converged = unsound == 0;
  if (!stage->converged) stage->reason = "solids that are not sound";
}

static const lam_key keys[] = {
    LAM_CHOICE_KEY(circles_keys, "circles", circles, "incircles", circle_names,
                   "Which circles of the faces become rings: incircles (S-isothermic nets), "
                   "circumcircles (circular nets), or none."),
    LAM_FLAG_KEY(circles_keys, "spheres", spheres, "no",
                 "Balls at the vertices, as large as the incircles allow: on an S-isothermic net "
                 "neighbors touch."),
    LAM_FLAG_KEY(circles_keys, "drawn", drawn, "no",
                 "Only to be looked at: they may pass through each other and through other parts, "
                 "the clash check leaves them out, and rings have no flat pattern."),
    LAM_LENGTH_KEY(circles_keys, "width", width, "20 mm", 1e-5, 10,
                   "Width of the rings, inward from the circle."),
    LAM_LENGTH_KEY(circles_keys, "thickness", thickness, "10 mm", 1e-5, 1,
                   "Thickness of the rings, half of it on either side of the face."),
    LAM_LENGTH_KEY(
        circles_keys, "gap", gap, "2 mm", 0, 1,
        "Between rings or balls that would touch; rings in different planes need thickness * "
        "tan(fold angle / 2)."),
    LAM_CHOICE_KEY(circles_keys, "material", material, "plywood", lam_material_names,
                   "What rings and balls are made of."),
    {0}};

const lam_part_kind lam_part_circles = {
    .head = {.name = "circles",
             .title = "Rings on the faces' circles, balls at the vertices",
             .doc = "On an S-isothermic net incircles of neighboring faces touch, and so do the "
                    "spheres at neighboring vertices: a packing of rings or balls that follows "
                    "the surface. Rings are flat and have a flat pattern. All circles of one "
                    "radius are one part with many instances. Rings on incircles and balls pass "
                    "through each other, and so do circumcircles of neighboring faces, which "
                    "share two vertices: `drawn` makes them for pictures, without a clash.",
             .source = "thesis 3.5.1 and 3.5.3, figures 3.44 and 3.50",
             .keys = keys,
             .params_size = sizeof(circles_keys)},
    .make = make,
    .check = check};
