/* The row `flat-pattern`: the whole net as one bent sheet, with the outline it is cut to. Called
 * through the registry (part_kinds.c) by design/parts_stage.c; the net is laid flat by
 * surf/flatten. */
#include "core/solid/triangles.h"
#include "fab/flat/lettering.h"
#include "fab/part_names.h"
#include "fab/workshop.h"
#include "surf/flatten/flatten.h"

#include <string.h>

typedef struct flat_pattern_keys {
  double thickness, strain;
  int marks, material;
} flat_pattern_keys;

/* The net laid flat. points: per vertex of the net; loop: the vertices of the boundary, in turn. */
typedef struct sheet {
  const flat_pattern_keys *keys;
  lam_flat_mesh mesh;
  lam_flattening flattening;
  lam_vec2 *points; /* flat, as drawn */
  int *loop, loop_count;
} sheet;

/* ---- the solid ---- */

/* The solid of the bent sheet: both sides half the thickness off the net, walls along the
 * boundary. Vertices: n above, then n below. */
static lam_trimesh thicken(lam_arena *arena, const sheet *s, const lam_vec3 *normals) {
  int n = s->mesh.vertex_count, t = s->mesh.triangle_count;
  lam_trimesh solid = {2 * n, LAM_NEW(arena, lam_vec3, 2 * n), 2 * t + 2 * s->loop_count, NULL};
  solid.triangles = lam_arena_alloc(arena, (size_t)solid.triangle_count, sizeof *solid.triangles);
  for (int v = 0; v < 2 * n; v++)
    solid.vertices[v] = lam_along(s->mesh.vertices[v % n],
                                  s->keys->thickness * (v < n ? 0.5 : -0.5), normals[v % n]);

  for (int k = 0; k < t; k++) {
    const int *c = s->mesh.triangles[k];
    memcpy(solid.triangles[k], c, 3 * sizeof *c);
    memcpy(solid.triangles[t + k], (int[3]){n + c[0], n + c[2], n + c[1]}, 3 * sizeof *c);
  }

  for (int k = 0; k < s->loop_count; k++) {
    int a = s->loop[k], b = s->loop[(k + 1) % s->loop_count];
    memcpy(solid.triangles[2 * t + 2 * k], (int[3]){b, a, n + a}, sizeof *solid.triangles);
    memcpy(solid.triangles[2 * t + 2 * k + 1], (int[3]){b, n + a, n + b}, sizeof *solid.triangles);
  }
  return solid;
}

/* ---- the pattern ---- */

/* The flattened points (count of them) about their mean, turned so that they spread most along x:
 * along the main axis of their second moments. */
static lam_vec2 *lay_along(lam_arena *arena, int count, const lam_vec2 *from) {
  lam_vec2 mean = {0}, *points = LAM_NEW(arena, lam_vec2, count);
  double xx = 0, xy = 0, yy = 0;
  for (int i = 0; i < count; i++)
    mean = lam_v2(mean.x + from[i].x / count, mean.y + from[i].y / count);

  for (int i = 0; i < count; i++) {
    double x = from[i].x - mean.x, y = from[i].y - mean.y;
    xx += x * x, xy += x * y, yy += y * y;
  }

  double turn = -0.5 * atan2(2 * xy, xx - yy);
  lam_motion placement = {cos(turn), sin(turn), {0, 0}};
  for (int i = 0; i < count; i++)
    points[i] = lam_motion_apply(&placement, lam_v2(from[i].x - mean.x, from[i].y - mean.y));
  return points;
}

/* The distance of p from the nearest of all paths, in meters. */
static double distance_to(const lam_paths *paths, lam_vec2 p) {
  double least = INFINITY;
  for (int i = 0; i < paths->count; i++) {
    const lam_path *path = &paths->items[i];
    for (int k = path->closed ? 0 : 1; k < path->count; k++) {
      lam_vec2 a = path->points[k ? k - 1 : path->count - 1], b = path->points[k];
      double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
      double t = square > 0 ? fmin(1, fmax(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / square)) : 0;
      least = fmin(least, hypot(a.x + t * dx - p.x, a.y + t * dy - p.y));
    }
  }
  return least;
}

/* Writes the name around the vertex furthest from the outline and the marks; its corners reach two
 * thirds of that distance. */
static void add_name(lam_paths *paths, const sheet *s, const char *name) {
  lam_vec2 at = s->points[0];
  double room = 0;
  for (int v = 0; v < s->mesh.vertex_count; v++) {
    double distance = distance_to(paths, s->points[v]);
    if (distance <= room) continue;
    room = distance;
    at = s->points[v];
  }

  double wide = lam_lettering_width(name, 1), height = 4. / 3 * room / hypot(1, wide);
  lam_lettering_add(paths, LAM_LAYER_LABEL, name,
                    lam_v2(at.x - wide * height / 2, at.y - height / 2), 0, height);
}

/* Engraves lines of the net, `marks` inside each family, as evenly spaced as the net allows. The
 * first and the last line of a family are left out, and marks stand m/(marks + 1) of the way
 * between them. */
static void add_marks(lam_arena *arena, lam_paths *paths, const sheet *s, const lam_net *net) {
  for (int family = 0; family < 2; family++) {
    int inner = 0, seen = 0;
    for (int i = 0; i < net->polyline_count; i++) inner += net->polylines[i].family == family;

    inner = inner > 2 ? inner - 2 : 0;

    for (int i = 0, k = 0; i < net->polyline_count; i++) {
      const lam_polyline *line = &net->polylines[i];
      if (line->family != family || k++ == 0 || k == inner + 2) continue;
      int marks = s->keys->marks < inner ? s->keys->marks : inner;
      /* Line k - 1 of inner + 1 gaps against the place of the next mark. */
      int wanted = (int)floor((seen + 1.) * (inner + 1) / (marks + 1) + 0.5);
      if (seen >= marks || k - 1 < wanted) continue;

      seen++;
      lam_vec2 *points = LAM_NEW(arena, lam_vec2, line->count);
      for (int v = 0; v < line->count; v++) points[v] = s->points[line->vertices[v]];
      lam_paths_add(paths, LAM_LAYER_ENGRAVE, line->closed, line->count, points);
    }
  }
}

/* The flat pattern: outline, marks, and the name last, for it avoids the others. */
static lam_flat *draw(lam_arena *arena, const sheet *s, const lam_net *net, const char *name) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_vec2 *outline = LAM_NEW(arena, lam_vec2, s->loop_count);
  for (int k = 0; k < s->loop_count; k++) outline[k] = s->points[s->loop[k]];
  lam_paths_add(&paths, LAM_LAYER_CUT, true, s->loop_count, outline);

  add_marks(arena, &paths, s, net);
  add_name(&paths, s, name);

  flat->thickness = s->keys->thickness;
  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* ---- the part ---- */

/* The largest normal curvature along edges, in absolute value: k = -dn.dx/dx.dx, 1/m. */
static double bend(const lam_flat_mesh *mesh, const lam_vec3 *normals) {
  double most = 0;
  for (int e = 0; e < mesh->edge_count; e++) {
    int a = mesh->edges[e][0], b = mesh->edges[e][1];
    lam_vec3 d = lam_sub(mesh->vertices[b], mesh->vertices[a]);
    double square = lam_dot(d, d);
    if (square > 0) most = fmax(most, fabs(lam_dot(lam_sub(normals[b], normals[a]), d)) / square);
  }
  return most;
}

/* The stage "flat-pattern". area in m^2; bending: the strain at the faces of the sheet. The
 * outline must not cross itself and no triangle turn over, or the pattern overlaps. */
static void report(lam_workshop *shop, const sheet *s, const lam_part *part, double area,
                   double bending) {
  const lam_flattening *f = &s->flattening;
  lam_stage *stage = lam_workshop_stage(shop, "flat-pattern");
  double unsound = !lam_part_is_sound(shop->arena, part),
         crossings = (double)lam_path_crossings(&part->flat->paths[0]);

  stage->converged = f->converged && f->flips == 0 && crossings == 0 && unsound == 0;
  if (!stage->converged)
    stage->reason = f->flips || crossings > 0 ? "the pattern overlaps itself"
                    : unsound > 0             ? "the solid is not sound"
                                              : "not converged";

  lam_stage_measure(shop->arena, stage, "flat_area", "m2", area, area, 1);
  lam_stage_measure(shop->arena, stage, "sheet_mass", "kg", part->mass, part->mass, 1);
  lam_stage_measure(shop->arena, stage, "flattening_strain", "", f->max_strain, f->rms_strain,
                    s->mesh.edge_count);
  lam_stage_measure(shop->arena, stage, "bending_strain", "", bending, bending, s->mesh.edge_count);
  lam_stage_count(shop->arena, stage, "turned_triangles", f->flips);
  lam_stage_count(shop->arena, stage, "outline_crossings", crossings);
  lam_stage_count(shop->arena, stage, "unsound_sheets", unsound);

  if (f->max_strain > part->material->max_strain)
    lam_stage_note(shop->arena, stage,
                   "%s yields above %.2g: places with more strain in the plane have to be formed",
                   part->material->name, part->material->max_strain);
  if (bending > part->material->max_strain)
    lam_stage_note(shop->arena, stage,
                   "bent beyond the elastic limit of %s where it is curved most: it stays bent",
                   part->material->name);
}

/* F1 for the first sheet of a design, F2 for the second ... */
static const char *sheet_name(const lam_workshop *shop) {
  int number = 1;
  for (int i = 0; i < shop->part_count; i++)
    number += strcmp(shop->parts[i].kind, "flat-pattern") == 0;
  return lam_part_name(shop, lam_arena_printf(shop->arena, "F%d", number));
}

/* Lays the net flat: its mesh, where its vertices come to lie, and the loop of its boundary. False,
 * with a message, when it is no disk or strains more than asked for. */
static bool lay_flat(lam_workshop *shop, sheet *s, lam_location location) {
  const lam_mesh *net = &shop->net->mesh;
  lam_arena *arena = shop->arena;
  lam_trimesh triangles = lam_mesh_triangles(arena, net);
  if (!lam_flat_disk(arena, net->vertex_count, net->vertices, shop->normals,
                     triangles.triangle_count, (const int(*)[3])triangles.triangles, &s->mesh)) {
    lam_error_add(shop->errors, location, "kind",
                  "flat-pattern given for a net that is no disk; expected one piece with one "
                  "boundary and no holes");
    return false;
  }

  s->flattening = lam_flatten(arena, &s->mesh);
  if (s->keys->strain > 0 && s->flattening.max_strain > s->keys->strain) {
    lam_error_add(shop->errors, location, "strain",
                  "%g allowed, but laying the net flat strains it by %.3g; expected a more "
                  "developable surface, or more",
                  s->keys->strain, s->flattening.max_strain);
    return false;
  }

  s->points = lay_along(arena, net->vertex_count, s->flattening.points);
  s->loop_count = lam_flat_boundary(arena, &s->mesh, &s->loop);
  return true;
}

/* One part for the whole net. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const flat_pattern_keys *k = params;
  lam_arena *arena = shop->arena;
  sheet s = {.keys = k};
  if (!lay_flat(shop, &s, location)) return;

  const char *name = sheet_name(shop);
  lam_part part = {.name = name,
                   .kind = "flat-pattern",
                   .family = -1,
                   .group = -1,
                   .material = &lam_materials[k->material]};
  part.congruence = lam_workshop_next_class(shop);
  part.solid = thicken(arena, &s, shop->normals);
  part.flat = draw(arena, &s, shop->net, name);

  /* Bent to the curvature k, a sheet of thickness t is strained by k t/2 at its faces. */
  double area = lam_path_area(&part.flat->paths[0]),
         bending = bend(&s.mesh, shop->normals) * k->thickness / 2;
  part.mass = area * k->thickness * part.material->density;
  const lam_fact facts[] = {{"mass", "kg", part.mass},
                            {"area", "m2", area},
                            {"flattening strain", "", s.flattening.max_strain},
                            {"bending strain", "", bending}};
  lam_part_set_facts(arena, &part, facts, sizeof facts / sizeof facts[0]);
  report(shop, &s, lam_workshop_part(shop, part), area, bending);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(flat_pattern_keys, "thickness", thickness, "2 mm", 1e-5, 0.1,
                   "Thickness of the sheet; the net lies in its middle."),
    LAM_INTEGER_KEY(flat_pattern_keys, "marks", marks, "3", 0, 1000,
                    "Lines of the net in each direction that are engraved, to find places by."),
    LAM_NUMBER_KEY(
        flat_pattern_keys, "strain", strain, "0", 0, 1,
        "The largest strain in the plane of the sheet that is accepted; 0: any, the report tells."),
    LAM_CHOICE_KEY(flat_pattern_keys, "material", material, "aluminum", lam_material_names,
                   "What the sheet is made of."),
    {0}};

const lam_part_kind lam_part_flat_pattern = {
    .head =
        {.name = "flat-pattern",
         .title = "The net as one bent sheet",
         .doc = "The net is laid flat with edges as long as they are on the surface, and becomes "
                "one sheet: its outline is cut, lines of the net are engraved, and the solid "
                "shows it bent. Exact for developable surfaces, with an error of the fourth power "
                "of the cell size; on others the sheet has to stretch, and the report says by how "
                "much, and whether the material takes it. A pattern that would overlap itself is "
                "reported. The net must be a disk: one boundary, no holes.",
         .equation = "sum (l - L)^2 -> min, L = c (1 + k^2 c^2 / 24)",
         .source =
             "Li & Deng, Construction and application of approximate developable surfaces, sec. 5",
         .keys = keys,
         .params_size = sizeof(flat_pattern_keys)},
    .make = make};
