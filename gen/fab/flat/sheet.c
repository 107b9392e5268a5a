#include "fab/flat/sheet.h"
#include "fab/flat/axis.h"
#include "fab/flat/nest.h"
#include "fab/flat/path_offset.h"
#include "fab/flat/splice.h"

#include <math.h>
#include <string.h>

typedef struct cutting {
  lam_arena *arena;
  const lam_part *parts;
  lam_sheet_options options;
  double room[2]; /* of a sheet without its margins; the longer side first */
  lam_location location;
  lam_errors *errors;
  lam_pieces pieces;
} cutting;

static const char *const stock_key = "sheets.stock";

/* The cuts of the sheets of one lamella, along its direction of travel. */
typedef struct group_cuts {
  int group, count, sheets;
  double *items;
} group_cuts;

/* Where in its free play a splice goes: apart in a pair and from one lamella to the next. */
static double stagger(int group, int sheet) {
  static const double fractions[2][2] = {{0.15, 0.65}, {0.4, 0.9}};
  return fractions[group % 2 ? 1 : 0][sheet % 2];
}

/* How much the kerf adds to the size of a strip; a corner that points askew moves further than one
 * that lies square. */
static double growth(const cutting *bench, const lam_flat *flat) {
  return bench->options.kerf * (flat->axis_count > 2 ? sqrt(2) : 1);
}

/* How much the longest, and the highest, of the pieces from `first` on exceed the sheet; at most 0
 * when all fit. */
static void find_excess(const cutting *bench, const lam_flat *flat, int first, double excess[2]) {
  excess[0] = excess[1] = -INFINITY;
  for (int i = first; i < bench->pieces.count; i++) {
    const lam_piece *piece = &bench->pieces.items[i];
    lam_vec2 min, max;
    lam_paths_bounds(piece->paths, piece->path_count, &min, &max);
    excess[0] = fmax(excess[0], max.x - min.x + growth(bench, flat) - bench->room[0]);
    excess[1] = fmax(excess[1], max.y - min.y + growth(bench, flat) - bench->room[1]);
  }
}

/* Cuts a strip into pieces that fit. Bent pieces are wider than their ends are apart, and high: for
 * them the greatest length is lowered until they fit. Returns the number of cuts, or -1. */
static int cut_strip(cutting *bench, int index, const double *avoid, int avoid_count,
                     double fraction, double **cuts) {
  const lam_part *part = &bench->parts[index];
  double longest = bench->room[0] - bench->options.kerf,
         shortest = 2 * lam_splice_for(part->flat->height).half;
  int first = bench->pieces.count;
  while (longest > shortest) {
    double excess[2];
    int count =
        lam_splice_cuts(bench->arena, part->flat, longest, avoid, avoid_count, fraction, cuts);
    if (count < 0) return -1;
    bench->pieces.count = first;
    lam_splice_pieces(&bench->pieces, index, part, *cuts, count);
    find_excess(bench, part->flat, first, excess);
    if (excess[0] <= 1e-9 && excess[1] <= 1e-9) return count;
    longest = excess[1] > 1e-9 ? 0.9 * longest : longest - excess[0] - 1e-6;
  }
  bench->pieces.count = first;
  return -1;
}

/* Splits a strip that is too long; earlier: the cuts of the last lamella, updated. */
static void split_part(cutting *bench, int index, group_cuts *earlier) {
  const lam_part *part = &bench->parts[index];
  const lam_flat *flat = part->flat;
  double length = lam_axis_make(bench->arena, flat->axis, flat->axis_count).length, *cuts;
  if (part->group < 0 || earlier->group != part->group)
    *earlier = (group_cuts){part->group, 0, 0, NULL};
  double *avoid = LAM_NEW(bench->arena, double, earlier->count);
  for (int i = 0; i < earlier->count; i++)
    avoid[i] = flat->reversed ? length - earlier->items[i] : earlier->items[i];
  int count =
      cut_strip(bench, index, avoid, earlier->count, stagger(part->group, earlier->sheets), &cuts);
  if (count < 0) {
    lam_error_add(bench->errors, bench->location, stock_key,
                  "%s is %.0f mm long, the sheet has room for %.0f mm x %.0f mm, and its slots "
                  "leave no room for splices "
                  "of %.0f mm",
                  part->name, length * 1e3, bench->room[0] * 1e3, bench->room[1] * 1e3,
                  2e3 * lam_splice_for(flat->height).half);
    return;
  }
  double *all = LAM_NEW(bench->arena, double, earlier->count + count);
  for (int i = 0; i < earlier->count; i++) all[i] = earlier->items[i];
  for (int i = 0; i < count; i++)
    all[earlier->count + i] = flat->reversed ? length - cuts[i] : cuts[i];
  *earlier = (group_cuts){part->group, earlier->count + count, earlier->sheets + 1, all};
}

/* True for a strip that a sheet has no room for, but may have for its pieces. */
static bool must_be_split(const cutting *bench, const lam_flat *flat) {
  double kerf = growth(bench, flat), width = flat->max.x - flat->min.x + kerf,
         height = flat->max.y - flat->min.y + kerf;
  return flat->axis_count >= 2 && flat->height + kerf <= bench->room[1] + 1e-9 &&
         (width > bench->room[0] + 1e-9 || height > bench->room[1] + 1e-9);
}

/* Every instance of every flat part as pieces that are short enough. */
static void make_pieces(cutting *bench, int part_count) {
  group_cuts earlier = {-1, 0, 0, NULL};
  for (int i = 0; i < part_count; i++) {
    const lam_part *part = &bench->parts[i];
    if (!part->flat) continue;
    const lam_flat *flat = part->flat;
    int copies = part->instance_count > 0 ? part->instance_count : 1;
    for (int copy = 0; copy < copies; copy++) {
      if (must_be_split(bench, flat)) {
        split_part(bench, i, &earlier);
        continue;
      }
      lam_pieces_add(&bench->pieces,
                     (lam_piece){i, part->name, part->material, flat->thickness, part->length,
                                 lam_paths_area(flat->paths, flat->path_count), flat->path_count,
                                 flat->paths});
    }
  }
}

/* Widens the outlines of a piece by half the kerf, and narrows its holes. */
static void apply_kerf(cutting *bench, lam_piece *piece) {
  lam_path *paths = LAM_NEW(bench->arena, lam_path, piece->path_count);
  if (piece->path_count) memcpy(paths, piece->paths, (size_t)piece->path_count * sizeof *paths);
  for (int i = 0; i < piece->path_count && bench->options.kerf > 0; i++) {
    lam_path *path = &paths[i];
    if (path->layer != LAM_LAYER_CUT || !path->closed) continue;
    lam_vec2 *moved = LAM_NEW(bench->arena, lam_vec2, LAM_OFFSET_ROOM(path->count));
    double half = bench->options.kerf / 2;
    lam_status status = lam_offset_polygon(path->points, path->count, path->hole ? -half : half,
                                           moved, &path->count);
    if (status == LAM_NO_MEMORY) lam_arena_exhausted(bench->arena);
    if (status != LAM_OK) {
      lam_error_add(bench->errors, bench->location, "sheets.kerf",
                    "%s has a slot or hole narrower than the kerf of %.3f mm", piece->label,
                    bench->options.kerf * 1e3);
      return;
    }
    path->points = moved;
  }
  piece->paths = paths;
}

/* Items that fit get their size; others a message. */
static bool measure(cutting *bench, const lam_piece *piece, lam_nest_item *item, lam_vec2 *min) {
  lam_vec2 max;
  lam_paths_bounds(piece->paths, piece->path_count, min, &max);
  double width = max.x - min->x, height = max.y - min->y;
  *item = (lam_nest_item){width + bench->options.spacing, height + bench->options.spacing, 0, 0, 0};
  if (width <= bench->room[0] + 1e-9 && height <= bench->room[1] + 1e-9) return true;
  lam_error_add(
      bench->errors, bench->location, stock_key,
      "%s needs %.1f mm x %.1f mm, the sheet has room for %.1f mm x %.1f mm inside its margins",
      piece->label, width * 1e3, height * 1e3, bench->room[0] * 1e3, bench->room[1] * 1e3);
  return false;
}

static bool same_stock(const lam_piece *a, const lam_piece *b) {
  return a->material == b->material && a->thickness == b->thickness;
}

/* Moves a piece to its place; on upright stock it is turned by a quarter. */
static lam_sheet_piece place_piece(cutting *bench, const lam_piece *piece,
                                   const lam_nest_item *item, lam_vec2 min) {
  double margin = bench->options.margin, x = item->x + margin, y = item->y + margin;
  bool upright = bench->options.stock[1] > bench->options.stock[0];
  lam_motion move = {1, 0, {x - min.x, y - min.y}};
  if (upright) move = (lam_motion){0, 1, {bench->options.stock[0] - y + min.y, x - min.x}};
  return (lam_sheet_piece){
      piece->part,       piece->label,
      piece->area,       piece->length,
      piece->path_count, lam_paths_placed(bench->arena, piece->paths, piece->path_count, &move)};
}

/* Nests the pieces listed in chosen, all of one material and thickness, and appends their sheets.
 */
static void nest_group(cutting *bench, const int *chosen, int count, lam_sheets *sheets) {
  lam_nest_item *items = LAM_NEW(bench->arena, lam_nest_item, count);
  lam_vec2 *mins = LAM_NEW(bench->arena, lam_vec2, count);
  int *fitting = LAM_NEW(bench->arena, int, count), fit = 0;
  for (int i = 0; i < count; i++)
    if (measure(bench, &bench->pieces.items[chosen[i]], &items[fit], &mins[fit]))
      fitting[fit++] = chosen[i];
  const lam_sheet_options *options = &bench->options;
  int made = lam_nest(bench->arena, items, fit, bench->room[0] + options->spacing,
                      bench->room[1] + options->spacing);
  const lam_piece *kind = &bench->pieces.items[chosen[0]];
  for (int s = 0; s < made; s++) {
    lam_sheet *sheet = &sheets->sheets[sheets->count++];
    *sheet = (lam_sheet){lam_arena_printf(bench->arena, "sheet-%02d", sheets->count),
                         options->stock[0],
                         options->stock[1],
                         kind->material,
                         kind->thickness,
                         options->kerf,
                         0,
                         LAM_NEW(bench->arena, lam_sheet_piece, fit),
                         0};
    for (int i = 0; i < fit; i++) {
      if (items[i].sheet != s) continue;
      const lam_piece *piece = &bench->pieces.items[fitting[i]];
      sheet->placed[sheet->piece_count++] = place_piece(bench, piece, &items[i], mins[i]);
      sheet->used += piece->area / (sheet->width * sheet->height);
    }
  }
}

lam_sheets lam_sheets_make(lam_arena *arena, const lam_part *parts, int part_count,
                           lam_sheet_options options, lam_location location, lam_errors *errors) {
  double width = options.stock[0] - 2 * options.margin,
         height = options.stock[1] - 2 * options.margin;
  cutting bench = {arena,    parts,  options,         {fmax(width, height), fmin(width, height)},
                   location, errors, {.arena = arena}};
  lam_sheets sheets = {0, NULL};
  if (bench.room[1] <= 0) {
    lam_error_add(errors, location, stock_key,
                  "the margins of %.1f mm leave nothing of a sheet of %.0f mm x %.0f mm",
                  options.margin * 1e3, options.stock[0] * 1e3, options.stock[1] * 1e3);
    return sheets;
  }
  make_pieces(&bench, part_count);
  int count = bench.pieces.count;
  sheets.sheets = LAM_NEW(arena, lam_sheet, count);
  bool *done = LAM_NEW(arena, bool, count);
  int *chosen = LAM_NEW(arena, int, count);
  for (int i = 0; i < count; i++) apply_kerf(&bench, &bench.pieces.items[i]);
  for (int i = 0; i < count; i++) {
    int n = 0;
    for (int k = i; k < count; k++) {
      if (done[k] || !same_stock(&bench.pieces.items[i], &bench.pieces.items[k])) continue;
      done[k] = true;
      chosen[n++] = k;
    }
    if (n) nest_group(&bench, chosen, n, &sheets);
  }
  return sheets;
}
