/* Sheets of stock: every flat part becomes pieces that fit (split where too long), these get
 * their kerf, and are nested by material and thickness. Called by design/parts_stage.c. */
#include "fab/flat/sheet.h"
#include "fab/flat/axis.h"
#include "fab/flat/nest.h"
#include "fab/flat/path_offset.h"
#include "fab/flat/splice.h"
#include "fab/flat/turn.h"

#include <math.h>
#include <string.h>

/* What is to be cut from which stock, and the pieces found so far. */
typedef struct cutting_job {
  lam_arena *arena;
  const lam_part *parts;
  lam_sheet_options options;
  double room[2]; /* of a sheet without its margins; the longer side first */
  lam_location location;
  lam_errors *errors;
  lam_pieces pieces;
  int unplaced; /* pieces, or parts that could not be split, that lie on no sheet: told each */
} cutting_job;

/* How many pieces a part is cut into at most. */
enum { most_pieces = 200 };

/* The key of the design that messages about the size of the stock name. */
static const char *const stock_key = "sheets.stock";

/* The cuts of the sheets of one lamella so far, as positions along its direction of travel. */
typedef struct group_cuts {
  int group, count, sheets;
  double *items;
} group_cuts;

/* Where in its free play a splice goes, from 0 to 1: different for the sheets of a pair, and
 * from one lamella to the next. */
static double stagger(int group, int sheet) {
  static const double fractions[2][2] = {{0.15, 0.65}, {0.4, 0.9}};
  return fractions[group % 2 ? 1 : 0][sheet % 2];
}

/* How much the kerf adds to the size of a strip, in meters: itself where corners are square to
 * the axis of a straight strip, at most sqrt(2) times that where the corners of a bent strip
 * point askew. */
static double growth(const cutting_job *job, const lam_flat *flat) {
  return job->options.kerf * (flat->axis_count > 2 ? sqrt(2) : 1);
}

/* How much the pieces from `first` on exceed the room of a sheet, in length (excess[0]) and in
 * height (excess[1]), in meters; at most 0 when all fit. */
static void find_excess(const cutting_job *job, const lam_flat *flat, int first, double excess[2]) {
  excess[0] = excess[1] = -INFINITY;
  for (int i = first; i < job->pieces.count; i++) {
    const lam_piece *piece = &job->pieces.items[i];
    lam_vec2 min, max;
    lam_paths_bounds(piece->paths, piece->path_count, &min, &max);
    excess[0] = fmax(excess[0], max.x - min.x + growth(job, flat) - job->room[0]);
    excess[1] = fmax(excess[1], max.y - min.y + growth(job, flat) - job->room[1]);
  }
}

/* Cuts a strip into pieces that fit and adds them to the job. Bent pieces are wider than their
 * ends are apart, and higher than the strip: for them the greatest length along the axis is
 * lowered until they fit. Returns the number of cuts, or -1 when there are no such cuts;
 * nothing is added then. */
static int cut_strip(cutting_job *job, int index, const double *avoid, int avoid_count,
                     double fraction, double **cuts) {
  const lam_part *part = &job->parts[index];
  double longest = job->room[0] - job->options.kerf,
         shortest = 2 * lam_splice_for(part->flat->height).half;
  int first = job->pieces.count;

  while (longest > shortest) {
    double excess[2];
    int count =
        lam_splice_cuts(job->arena, part->flat, longest, avoid, avoid_count, fraction, cuts);

    if (count < 0) return -1;
    /* The pieces of the attempt before are dropped. */
    job->pieces.count = first;
    lam_splice_pieces(&job->pieces, index, part, *cuts, count);
    find_excess(job, part->flat, first, excess);

    if (excess[0] <= 1e-9 && excess[1] <= 1e-9) return count;
    longest = excess[1] > 1e-9 ? 0.9 * longest : longest - excess[0] - 1e-6;
  }

  job->pieces.count = first;
  return -1;
}

/* Splits a strip that is too long. earlier: the cuts of the other sheets of its lamella; begun
 * anew when the lamella is another one, and extended by the cuts made here. A strip that cannot
 * be split becomes a message. */
static void split_part(cutting_job *job, int index, group_cuts *earlier) {
  const lam_part *part = &job->parts[index];
  const lam_flat *flat = part->flat;
  double length = lam_axis_make(job->arena, flat->axis, flat->axis_count).length, *cuts;
  if (length > most_pieces * job->room[0]) {
    lam_error_add(job->errors, job->location, stock_key,
                  "%s is %.0f m long, the sheet has room for %.0f mm; expected parts of at most %d "
                  "sheets' lengths",
                  part->name, length, job->room[0] * 1e3, most_pieces);
    return;
  }
  if (part->group < 0 || earlier->group != part->group)
    *earlier = (group_cuts){part->group, 0, 0, NULL};

  /* Cuts are kept along the lamella's direction of travel; a reversed pattern runs against it. */
  double *avoid = LAM_NEW(job->arena, double, earlier->count);
  for (int i = 0; i < earlier->count; i++)
    avoid[i] = flat->reversed ? length - earlier->items[i] : earlier->items[i];

  int count =
      cut_strip(job, index, avoid, earlier->count, stagger(part->group, earlier->sheets), &cuts);
  if (count < 0) {
    lam_error_add(job->errors, job->location, stock_key,
                  "%s is %.0f mm long, the sheet has room for %.0f mm x %.0f mm, and its slots "
                  "leave no room for splices of %.0f mm",
                  part->name, length * 1e3, job->room[0] * 1e3, job->room[1] * 1e3,
                  2e3 * lam_splice_for(flat->height).half);
    job->unplaced++;
    return;
  }

  double *all = LAM_NEW(job->arena, double, earlier->count + count);
  for (int i = 0; i < earlier->count; i++) all[i] = earlier->items[i];
  for (int i = 0; i < count; i++)
    all[earlier->count + i] = flat->reversed ? length - cuts[i] : cuts[i];
  *earlier = (group_cuts){part->group, earlier->count + count, earlier->sheets + 1, all};
}

/* True for a strip that a sheet has no room for, but may have for its pieces: its height must
 * fit. */
static bool must_be_split(const cutting_job *job, const lam_flat *flat) {
  double kerf = growth(job, flat), width = flat->max.x - flat->min.x + kerf,
         height = flat->max.y - flat->min.y + kerf;
  return flat->axis_count >= 2 && flat->height + kerf <= job->room[1] + 1e-9 &&
         (width > job->room[0] + 1e-9 || height > job->room[1] + 1e-9);
}

/* Every instance of every flat part as pieces that are short enough. */
static void make_pieces(cutting_job *job, int part_count) {
  group_cuts earlier = {-1, 0, 0, NULL};
  for (int i = 0; i < part_count; i++) {
    const lam_part *part = &job->parts[i];
    if (!part->flat) continue;

    const lam_flat *flat = part->flat;
    int copies = part->instance_count > 0 ? part->instance_count : 1;
    for (int copy = 0; copy < copies; copy++) {
      if (must_be_split(job, flat)) {
        split_part(job, i, &earlier);
        continue;
      }
      lam_pieces_add(&job->pieces,
                     (lam_piece){i, part->name, part->material, flat->thickness, part->length,
                                 lam_paths_area(flat->paths, flat->path_count), flat->path_count,
                                 flat->paths});
    }
  }
}

/* Widens the outlines of a piece by half the kerf, and narrows its holes. The piece gets its
 * own list of paths, for copies of a part share theirs. False, with a message, when a gap would
 * close. */
static bool apply_kerf(cutting_job *job, lam_piece *piece) {
  lam_path *paths = LAM_NEW(job->arena, lam_path, piece->path_count);
  if (piece->path_count) memcpy(paths, piece->paths, (size_t)piece->path_count * sizeof *paths);

  for (int i = 0; i < piece->path_count && job->options.kerf > 0; i++) {
    lam_path *path = &paths[i];
    if (path->layer != LAM_LAYER_CUT || !path->closed) continue;

    lam_vec2 *moved = LAM_NEW(job->arena, lam_vec2, LAM_OFFSET_ROOM(path->count));
    double half = path->hole ? -job->options.kerf / 2 : job->options.kerf / 2;
    if (path->radius + half > 0 && path->radius > 0) {
      lam_path_resize(path, moved, path->radius + half);
      continue;
    }

    if (!lam_offset_polygon(job->arena, path->points, path->count, half, moved, &path->count)) {
      lam_error_add(job->errors, job->location, "sheets.kerf",
                    "%s has a slot or hole narrower than the kerf of %.3f mm", piece->label,
                    job->options.kerf * 1e3);
      job->unplaced++;
      return false;
    }

    path->points = moved;
  }
  piece->paths = paths;
  return true;
}

/* The size of a piece with its spacing as an item to be nested; min is the lower left corner of
 * its paths, which are turned where they fit no sheet as they lie. False, with a message, when a
 * sheet has no room for it. */
static bool measure(cutting_job *job, lam_piece *piece, lam_nest_item *item, lam_vec2 *min) {
  lam_motion turn;
  bool fits = lam_turn_to_fit(job->arena, piece->paths, piece->path_count, job->room, &turn);
  if (turn.cosine != 1)
    piece->paths = lam_paths_placed(job->arena, piece->paths, piece->path_count, &turn);

  lam_vec2 max;
  lam_paths_bounds(piece->paths, piece->path_count, min, &max);
  double width = max.x - min->x, height = max.y - min->y;
  *item = (lam_nest_item){width + job->options.spacing, height + job->options.spacing, 0, 0, 0};
  if (fits) return true;

  job->unplaced++;
  lam_error_add(
      job->errors, job->location, stock_key,
      "%s needs %.1f mm x %.1f mm, the sheet has room for %.1f mm x %.1f mm inside its margins",
      piece->label, width * 1e3, height * 1e3, job->room[0] * 1e3, job->room[1] * 1e3);
  return false;
}

/* Whether two pieces may lie on one sheet. */
static bool same_stock(const lam_piece *a, const lam_piece *b) {
  return a->material == b->material && a->thickness == b->thickness;
}

/* A piece where it lies on its sheet: moved so that min comes to the place of its item inside
 * the margins; on upright stock turned by a quarter, for nesting knows only lying sheets. */
static lam_sheet_piece place_piece(cutting_job *job, const lam_piece *piece,
                                   const lam_nest_item *item, lam_vec2 min) {
  double margin = job->options.margin, x = item->x + margin, y = item->y + margin;
  bool upright = job->options.stock[1] > job->options.stock[0];
  lam_motion move = {1, 0, {x - min.x, y - min.y}};
  if (upright) move = (lam_motion){0, 1, {job->options.stock[0] - y + min.y, x - min.x}};

  return (lam_sheet_piece){
      piece->part,       piece->label,
      piece->area,       piece->length,
      piece->path_count, lam_paths_placed(job->arena, piece->paths, piece->path_count, &move)};
}

/* An empty sheet of the stock that a piece needs, with room for `most` pieces. */
static lam_sheet new_sheet(const cutting_job *job, const lam_piece *piece, int number, int most) {
  return (lam_sheet){.name = lam_arena_printf(job->arena, "sheet-%02d", number),
                     .width = job->options.stock[0],
                     .height = job->options.stock[1],
                     .material = piece->material,
                     .thickness = piece->thickness,
                     .kerf = job->options.kerf,
                     .placed = LAM_NEW(job->arena, lam_sheet_piece, most)};
}

/* Nests the pieces listed in chosen, all of one material and thickness, and appends their
 * sheets. Pieces that fit no sheet are left out. */
static void nest_group(cutting_job *job, const int *chosen, int count, lam_sheets *sheets) {
  lam_nest_item *items = LAM_NEW(job->arena, lam_nest_item, count);
  lam_vec2 *mins = LAM_NEW(job->arena, lam_vec2, count);
  int *fitting = LAM_NEW(job->arena, int, count), fit = 0;
  for (int i = 0; i < count; i++)
    if (measure(job, &job->pieces.items[chosen[i]], &items[fit], &mins[fit]))
      fitting[fit++] = chosen[i];

  /* Every item carries its spacing on its right and above, so the sheet is larger by one
   * spacing. */
  const lam_sheet_options *options = &job->options;
  int made = lam_nest(job->arena, items, fit, job->room[0] + options->spacing,
                      job->room[1] + options->spacing);

  for (int s = 0; s < made; s++) {
    lam_sheet *sheet = &sheets->sheets[sheets->count++];
    *sheet = new_sheet(job, &job->pieces.items[chosen[0]], sheets->count, fit);

    for (int i = 0; i < fit; i++) {
      if (items[i].sheet != s) continue;
      const lam_piece *piece = &job->pieces.items[fitting[i]];
      sheet->placed[sheet->piece_count++] = place_piece(job, piece, &items[i], mins[i]);
      sheet->used += piece->area / (sheet->width * sheet->height);
    }
  }
}

/* See the header; the longer side of the stock lies along x while pieces are cut and nested. */
lam_sheets lam_sheets_make(lam_arena *arena, const lam_part *parts, int part_count,
                           lam_sheet_options options, lam_location location, lam_errors *errors) {
  double width = options.stock[0] - 2 * options.margin,
         height = options.stock[1] - 2 * options.margin;
  cutting_job job = {arena,    parts,  options,          {fmax(width, height), fmin(width, height)},
                     location, errors, {.arena = arena}, 0};
  lam_sheets sheets = {0};
  if (job.room[1] <= 0) {
    lam_error_add(errors, location, stock_key,
                  "the margins of %.1f mm leave nothing of a sheet of %.0f mm x %.0f mm",
                  options.margin * 1e3, options.stock[0] * 1e3, options.stock[1] * 1e3);
    return sheets;
  }

  make_pieces(&job, part_count);
  int count = job.pieces.count;

  /* A sheet holds one piece at least, so there are no more sheets than pieces. */
  sheets.sheets = LAM_NEW(arena, lam_sheet, count);
  bool *done = LAM_NEW(arena, bool, count);
  int *chosen = LAM_NEW(arena, int, count);

  for (int i = 0; i < count; i++) done[i] = !apply_kerf(&job, &job.pieces.items[i]);

  /* A piece that is not done yet begins the next group. */
  for (int i = 0; i < count; i++) {
    int n = 0;
    for (int k = i; k < count; k++) {
      if (done[k] || !same_stock(&job.pieces.items[i], &job.pieces.items[k])) continue;
      done[k] = true;
      chosen[n++] = k;
    }
    if (n) nest_group(&job, chosen, n, &sheets);
  }

  sheets.unplaced = job.unplaced;
  return sheets;
}
