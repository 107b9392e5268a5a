/* The row `skin`: a smooth skin over an asymptotic net, or the sheet of a spline surface. Called
 * through the registry (part_kinds.c) by design/parts_stage.c. */
#include "fab/parts/skin.h"
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/part_names.h"
#include "fab/workshop.h"

#include <string.h>

enum { FROM_NET, FROM_SURFACE };
enum { PIECES_WHOLE, PIECES_CELLS };
static const char *const from_names[] = {"net", "surface", NULL};
static const char *const piece_names[] = {"whole", "cells", NULL};

/* The keys of a row; lengths in meters. */
typedef struct skin_keys {
  int from, every, subdivisions, pieces, material;
  double thickness, offset;
} skin_keys;

/* The skin of one row: its patches, or the surfaces of the workshop. */
typedef struct skin {
  lam_workshop *shop;
  const skin_keys *keys;
  int count;
  lam_spline_surface *surfaces;
  bool fitted; /* all edges are asymptotic curves */
  lam_stage *stage;
} skin;

/* ---- patches ---- */

/* Keeps the patches that were made, numbered, for parts and writers. A patch that was not made
 * has no points. */
static void keep_patches(skin *s, int count, const lam_asymptotic_patch *patches) {
  int digits = 1;
  for (int k = count; k >= 10; k /= 10) digits++;
  s->surfaces = LAM_NEW(s->shop->arena, lam_spline_surface, count);

  for (int k = 0; k < count; k++) {
    if (!patches[k].surface.points) continue;
    lam_spline_surface *to = &s->surfaces[s->count++];
    *to = patches[k].surface;
    to->name = lam_arena_printf(s->shop->arena, "patch-%0*d", digits, s->count);
    lam_workshop_surface(s->shop, *to);
  }
}

/* Measures and notes about what is not as promised: cells left out, tilted normals, edges that
 * are no asymptotic curves. */
static void tell(skin *s, const lam_skin_net *cells, const lam_skin_fit *fit) {
  lam_arena *arena = s->shop->arena;
  int folded = cells->cell_count - fit->made, left_out = cells->irregular + folded;

  lam_stage_count(arena, s->stage, "cells_left_out", left_out);
  lam_stage_measure(arena, s->stage, "star_tilt", "deg", fit->tilt * 180 / LAM_PI, NAN,
                    s->shop->net->mesh.vertex_count);

  if (cells->irregular)
    lam_stage_note(arena, s->stage, "%d cells left out: no two lines cross at one of their corners",
                   cells->irregular);
  if (folded)
    lam_stage_note(arena, s->stage, "%d cells left out: their patches fold over along an edge",
                   folded);
  if (cells->uncovered)
    lam_stage_note(arena, s->stage, "%d faces of the net lie in no cell of %d x %d faces",
                   cells->uncovered, cells->every, cells->every);

  if (!fit->converged)
    lam_stage_note(arena, s->stage,
                   "no asymptotic curves through all vertices were found: after %d steps edges "
                   "miss their ends by up to %.2g m, and are bent there to meet them",
                   fit->steps, fit->missed);
  if (fit->contradictions)
    lam_stage_note(arena, s->stage,
                   "%d edges of cells turn the normals against their family: the net is no "
                   "asymptotic net of a surface with K < 0 there",
                   fit->contradictions);
}

/* Patches over the cells of the net, all edges found together
 * (surf/asymptotic/asymptotic_skin.h). False, with a message, when there is no cell or no patch. */
static bool fill_net(skin *s, lam_location location) {
  lam_workshop *shop = s->shop;
  lam_skin_net cells = lam_skin_net_make(shop->arena, shop->net, s->keys->every);
  if (cells.cell_count == 0) {
    lam_error_add(shop->errors, location, "every",
                  "%d leaves no cell of %d x %d faces with four regular corners; expected less",
                  s->keys->every, s->keys->every, s->keys->every);
    return false;
  }

  lam_asymptotic_patch *patches = LAM_NEW(shop->arena, lam_asymptotic_patch, cells.cell_count);
  lam_skin_fit fit =
      lam_asymptotic_skin_fill(shop->arena, shop->net->mesh.vertex_count, cells.vertices,
                               cells.cell_count, cells.cells, patches);
  if (fit.made == 0) {
    lam_error_add(shop->errors, location, "kind",
                  "the lines of the net are no asymptotic curves: %d edges of cells turn the "
                  "normals against their family, and all patches fold over; expected an "
                  "asymptotic net",
                  fit.contradictions);
    return false;
  }

  s->fitted = fit.converged;
  keep_patches(s, cells.cell_count, patches);
  tell(s, &cells, &fit);

  if (cells.every > 1)
    lam_stage_measure(shop->arena, s->stage, "net_distance", "m",
                      lam_skin_distance(shop->net, &cells, patches), NAN,
                      4L * (cells.every - 1) * cells.cell_count);
  return true;
}

/* The design's own spline surfaces instead of patches; false, with a message, when it has none. */
static bool take_surfaces(skin *s, lam_location location) {
  lam_workshop *shop = s->shop;
  if (shop->surface_count == 0) {
    lam_error_add(
        shop->errors, location, "from",
        "surface, but the design's surface is no spline; expected net, or a spline surface");
    return false;
  }
  s->count = shop->surface_count;
  s->surfaces = shop->surfaces;
  return true;
}

/* ---- solids ---- */

/* The part of one piece: a shell with its middle at the offset from the surface. */
static void add_part(skin *s, const lam_skin_mesh *mesh, const int *piece, int number,
                     const char *name) {
  lam_workshop *shop = s->shop;
  const skin_keys *k = s->keys;
  lam_part part = {.name = name, .kind = "skin", .family = -1, .group = -1};
  part.material = &lam_materials[k->material];
  part.solid = lam_skin_shell(shop->arena, mesh, piece, number, k->offset - k->thickness / 2,
                              k->offset + k->thickness / 2);
  part.mass = lam_trimesh_volume(&part.solid) * part.material->density;

  const lam_fact facts[] = {{"thickness", "m", k->thickness}, {"mass", "kg", part.mass}};
  lam_part_set_facts(shop->arena, &part, facts, sizeof facts / sizeof facts[0]);
  lam_workshop_part(shop, part);
}

/* Parts for all pieces, named by the row's letters, from S on, and their number, and their
 * measures. Pieces are what hangs together, or the cells one by one. */
static void add_parts(skin *s, const lam_skin_mesh *mesh) {
  lam_workshop *shop = s->shop;
  int *piece = LAM_NEW(shop->arena, int, mesh->cell_count), first = shop->part_count, digits = 1;
  int count = lam_skin_pieces(shop->arena, mesh, piece);
  if (s->keys->pieces == PIECES_CELLS) {
    count = mesh->cell_count;
    for (int c = 0; c < count; c++) piece[c] = c;
  }

  const char *letters = lam_part_letters(shop, 'S');
  for (int e = count; e >= 10; e /= 10) digits++;
  for (int k = 0; k < count; k++)
    add_part(s, mesh, piece, k, lam_arena_printf(shop->arena, "%s%0*d", letters, digits, k + 1));

  double mass = 0, heaviest = 0;
  long unsound = 0;
  for (int i = first; i < shop->part_count; i++) {
    mass += shop->parts[i].mass;
    heaviest = fmax(heaviest, shop->parts[i].mass);
    unsound += !lam_part_is_sound(shop->arena, &shop->parts[i]);
  }

  lam_stage_measure(shop->arena, s->stage, "piece_mass", "kg", heaviest, mass / count, count);
  lam_stage_measure(shop->arena, s->stage, "piece_mass_sum", "kg", mass, mass, count);
  lam_stage_count(shop->arena, s->stage, "unsound_pieces", unsound);
  s->stage->converged = unsound == 0 && s->fitted;
}

/* ---- the report ---- */

/* The measures of a skin over a net: seams, sides, joints, bending energy and curvature. */
static void report(skin *s, const lam_skin_mesh *mesh) {
  lam_arena *arena = s->shop->arena;
  lam_skin_facts f = lam_skin_measure(arena, mesh, s->surfaces);

  lam_stage_count(arena, s->stage, "patch_count", s->count);
  if (f.seams) {
    lam_stage_measure(arena, s->stage, "normal_jump", "rad", f.jump, f.jump_sum / f.seams, f.seams);
    lam_stage_measure(arena, s->stage, "gap", "m", f.gap, NAN, f.seams);
  }

  lam_stage_measure(arena, s->stage, "edge_normal_curvature", "of sqrt(-K)", f.slant,
                    f.slant_sum / (double)f.sides, f.sides);
  if (f.exact < f.sides)
    lam_stage_note(arena, s->stage, "%ld of %ld sides of patches are asymptotic curves to 1e-8",
                   f.exact, f.sides);
  if (f.joints) lam_stage_measure(arena, s->stage, "edge_kink", "rad", f.kink, NAN, f.joints);

  lam_stage_measure(arena, s->stage, "thin_plate_energy", "m^2", f.largest_energy,
                    f.energy / s->count, s->count);
  lam_stage_measure(arena, s->stage, "thin_plate_energy_sum", "m^2", f.energy, f.energy, s->count);
  lam_stage_measure_add(
      arena, s->stage,
      (lam_measure){"gaussian_curvature", "1/m^2", f.least_k, f.largest_k, NAN, f.samples});
  lam_stage_count(arena, s->stage, "not_saddle", f.domes);

  if (f.domes)
    lam_stage_note(arena, s->stage,
                   "%ld of %ld sampled places are no saddle points: the skin curls there", f.domes,
                   f.samples);
}

/* Patches, then their samples, then solids. Only a skin over a net has promises to be measured. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  skin s = {
      .shop = shop, .keys = params, .stage = lam_workshop_stage(shop, "skin"), .fitted = true};
  if (s.keys->from == FROM_NET ? !fill_net(&s, location) : !take_surfaces(&s, location)) return;

  lam_skin_mesh mesh = lam_skin_mesh_make(shop->arena, s.count, s.surfaces, s.keys->subdivisions);
  if (s.keys->from == FROM_NET)
    report(&s, &mesh);
  else
    lam_stage_count(shop->arena, s.stage, "patch_count", s.count);
  add_parts(&s, &mesh);
}

static const lam_key keys[] = {
    LAM_CHOICE_KEY(
        skin_keys, "from", from, "net", from_names,
        "net: a patch over every cell of the asymptotic net; surface: the design's own spline "
        "surface."),
    LAM_INTEGER_KEY(skin_keys, "every", every, "1", 1, 1000,
                    "Edges of the net along a side of a patch, as for lamellas."),
    LAM_LENGTH_KEY(skin_keys, "thickness", thickness, "10 mm", 1e-5, 2, "Thickness of the skin."),
    LAM_LENGTH_KEY(skin_keys, "offset", offset, "0", -10, 10,
                   "How far its middle stands off the surface, along the normals."),
    LAM_INTEGER_KEY(skin_keys, "subdivisions", subdivisions, "6", 1, 200,
                    "Facets of the solid along a side of a patch."),
    LAM_CHOICE_KEY(skin_keys, "pieces", pieces, "whole", piece_names,
                   "whole: one solid of all patches that hang together; cells: one each."),
    LAM_CHOICE_KEY(skin_keys, "material", material, "concrete", lam_material_names,
                   "What the skin is made of."),
    {0}};

const lam_part_kind lam_part_skin = {
    .head =
        {.name = "skin",
         .title = "Smooth skin over an asymptotic net",
         .doc =
             "One smooth patch over every cell of an asymptotic net, through its vertices. "
             "Neighboring patches share their edge and the tangent planes along it, and the edges "
             "are asymptotic curves of the skin, so that lamellas follow them upright; curves run "
             "on smoothly through the vertices. All edges are found together, from one vector "
             "along the normal at every vertex (Lelieuvre's formula). Between the edges of the "
             "skin the net may be finer (`every`): the skin passes by those vertices closely. A "
             "net of one face per patch is met exactly, but is itself only near to smooth "
             "asymptotic lines, for which its edges have to bend more. Cells at irregular "
             "vertices, where no two lines cross, are left out. The patches go into surface.json, "
             "STEP and IGES as they are, and into all others as a thin closed solid.",
         .source = "thesis chapter 2; Huhnen-Venedey & Roerig, Discretization of asymptotic line "
                   "parametrizations using hyperboloid surface patches",
         .keys = keys,
         .params_size = sizeof(skin_keys)},
    .make = make};
