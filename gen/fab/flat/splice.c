/* The pieces of a part that is cut, with their bolt holes and labels, and the splice plates.
 * Called by fab/flat/sheet.c; lam_splice_for also by splice_cuts.c. */
#include "fab/flat/splice.h"
#include "core/grow.h"
#include "fab/flat/face.h"
#include "fab/flat/lettering.h"

#include <math.h>

/* Bolts and their clearance holes (EN 20273, medium series), the largest first. */
static const struct {
  const char *name;
  double hole;
} bolts[] = {{"M12", 13.5e-3}, {"M10", 11e-3}, {"M8", 9e-3},   {"M6", 6.6e-3},
             {"M5", 5.5e-3},   {"M4", 4.5e-3}, {"M3", 3.4e-3}, {"M2", 2.4e-3}};

/* From the smallest bolt up: the last one whose hole is small enough stays. */
lam_splice lam_splice_for(double strip_height) {
  double largest = strip_height / 10 * (1 + 1e-9), hole = largest;
  const char *bolt = "pin";
  for (size_t i = sizeof bolts / sizeof *bolts; i-- > 0;)
    if (bolts[i].hole <= largest) {
      hole = bolts[i].hole;
      bolt = bolts[i].name;
    }

  return (lam_splice){
      bolt, hole, 7 * hole, 0.8 * strip_height, {2 * hole, 5 * hole}, strip_height / 4};
}

void lam_pieces_add(lam_pieces *pieces, lam_piece piece) {
  LAM_APPEND(pieces->arena, pieces->items, pieces->count, pieces->capacity, piece);
}

/* A straight cut through the plane: points with (p - x) . t < 0 are before it. */
typedef struct cut_line {
  lam_vec2 x, t;
} cut_line;

/* The cut across a strip at position s: square to the axis, t in the direction of travel. */
static cut_line line_at(const lam_axis *axis, double s) {
  lam_vec2 up, x = lam_axis_point(axis, s, 0, &up);
  return (cut_line){x, {up.y, -up.x}};
}

/* The distance of p from the cut, positive after it. */
static double side_of(const cut_line *line, lam_vec2 p) {
  return (p.x - line->x.x) * line->t.x + (p.y - line->x.y) * line->t.y;
}

/* The point between a and b where a distance that is da at a and db at b (of opposite signs) is
 * 0. */
static lam_vec2 between(lam_vec2 a, lam_vec2 b, double da, double db) {
  double t = da / (da - db);
  return lam_v2(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
}

/* Splits a closed outline at a line that crosses it twice within `reach` of line->x (elsewhere a
 * bent strip may meet the line again). before and after receive up to outline->count + 2 points,
 * beginning with the one that follows the first crossing; where there are no two crossings, all
 * points come to one side. */
static void split_outline(const lam_path *outline, const cut_line *line, double reach,
                          lam_path *before, lam_path *after) {
  int edges[2] = {-1, -1}, found = 0, n = outline->count;
  lam_vec2 hits[2];
  for (int i = 0; i < n && found < 2; i++) {
    lam_vec2 a = outline->points[i], b = outline->points[(i + 1) % n];
    double da = side_of(line, a), db = side_of(line, b);
    if ((da < 0) == (db < 0)) continue;
    hits[found] = between(a, b, da, db);
    if (hypot(hits[found].x - line->x.x, hits[found].y - line->x.y) > reach) continue;
    edges[found++] = i;
  }

  /* Points are dealt out in turn, to the other side after each crossing; which one begins follows
   * from the end of the first side that crosses. */
  before->count = after->count = 0;
  lam_path *current = side_of(line, outline->points[(edges[0] + 1) % n]) < 0 ? after : before;
  for (int i = 0; i < n; i++) {
    if (found == 2 && (i == edges[0] || i == edges[1])) {
      lam_vec2 hit = hits[i == edges[0] ? 0 : 1];
      current->points[current->count++] = outline->points[i];
      current->points[current->count++] = hit;
      current = current == before ? after : before;
      current->points[current->count++] = hit;
    } else
      current->points[current->count++] = outline->points[i];
  }
}

/* The number of cuts before s: the index of the piece it is on. */
static int piece_of(const double *cuts, int count, double s) {
  int piece = 0;
  while (piece < count && s >= cuts[piece]) piece++;
  return piece;
}

/* Whether all points of a mark lie on one piece; first: the piece of its first point. */
static bool is_whole(const lam_path *mark, const lam_axis *axis, const double *cuts, int cut_count,
                     int *first) {
  bool whole = true;
  *first = -1;
  for (int i = 0; i < mark->count; i++) {
    int piece = piece_of(cuts, cut_count, lam_axis_locate(axis, mark->points[i]).x);
    if (i == 0) *first = piece;
    whole = whole && piece == *first;
  }
  return whole;
}

/* Shares a mark among the pieces it lies on. One that lies on several becomes open strokes, from
 * cut to cut; shares has one list per piece. */
static void split_mark(const lam_path *mark, const lam_axis *axis, const double *cuts,
                       int cut_count, lam_paths *shares) {
  int n = mark->count, steps = mark->closed ? n + 1 : n, first;
  if (is_whole(mark, axis, cuts, cut_count, &first)) {
    lam_paths *share = &shares[first];
    bool goes_on =
        mark->joined && share->count && share->items[share->count - 1].layer == mark->layer;
    lam_path *whole = lam_paths_add(share, mark->layer, mark->closed, n, mark->points);
    whole->hole = mark->hole;
    whole->radius = mark->radius;
    whole->joined = goes_on;
    return;
  }

  lam_vec2 *run = LAM_NEW(shares->arena, lam_vec2, steps + 2);
  int count = 0, current = first;
  for (int i = 0; i < steps; i++) {
    lam_vec2 point = mark->points[i % n];
    int piece = piece_of(cuts, cut_count, lam_axis_locate(axis, point).x);

    /* A side of the mark may pass several cuts: the stroke ends at each and goes on from there. */
    while (piece != current) {
      int next = piece > current ? current + 1 : current - 1;
      cut_line line = line_at(axis, cuts[piece > current ? current : next]);
      lam_vec2 last = run[count - 1],
               hit = between(last, point, side_of(&line, last), side_of(&line, point));
      run[count++] = hit;
      lam_paths_add(&shares[current], mark->layer, false, count, run);
      run[0] = hit;
      count = 1;
      current = next;
    }
    run[count++] = point;
  }
  if (count > 1) lam_paths_add(&shares[current], mark->layer, false, count, run);
}

/* The four holes on one side of a cut: two columns of two. side: -1 before the cut, +1 after it. */
static void drill(lam_paths *paths, const lam_splice *splice, const cut_line *line, double side) {
  for (int i = 0; i < 4; i++) {
    double along = side * splice->columns[i / 2], across = splice->row * (i % 2 ? 1 : -1);
    lam_paths_hole(paths,
                   lam_v2(line->x.x + along * line->t.x - across * line->t.y,
                          line->x.y + along * line->t.y + across * line->t.x),
                   splice->hole);
  }
}

/* Writes the piece's own label near both its ends (low and high along the axis), clear of slots,
 * holes and the part's marks. paths: those of the piece; the labels are added to them. */
static void label_piece(lam_arena *arena, const lam_flat *flat, const lam_axis *axis, double low,
                        double high, const char *label, lam_paths *paths) {
  lam_face face = lam_face_make(arena, axis, low, high, flat->height);
  for (int i = 0; i < flat->slot_count; i++) {
    const lam_flat_slot *slot = &flat->slots[i];
    lam_face_take(&face, (lam_face_box){slot->low, slot->high, slot->bottom, slot->top});
  }

  for (int i = 0; i < paths->count; i++) {
    const lam_path *path = &paths->items[i];
    if (path->layer == LAM_LAYER_CUT && !path->hole) continue;

    lam_face_box box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int k = 0; k < path->count; k++) {
      lam_vec2 at = lam_axis_locate(axis, path->points[k]);
      box = (lam_face_box){fmin(box.low, at.x), fmax(box.high, at.x), fmin(box.bottom, at.y),
                           fmax(box.top, at.y)};
    }
    lam_face_take(&face, box);
  }

  double centers[3] = {0, -flat->height / 4, flat->height / 4};
  lam_face_name(&face, paths, label, true, centers, 3);
  lam_face_name(&face, paths, label, false, centers, 3);
}

/* Adds a piece from low to high along the axis, turned so that the middles of its ends lie on a
 * line along x. */
static void add_piece(lam_pieces *pieces, int part_index, const lam_part *part,
                      const lam_axis *axis, double low, double high, const char *label,
                      const lam_paths *paths) {
  lam_vec2 a = lam_axis_point(axis, low, 0, NULL), b = lam_axis_point(axis, high, 0, NULL);
  double chord = hypot(b.x - a.x, b.y - a.y);
  lam_motion turn = {(b.x - a.x) / chord, -(b.y - a.y) / chord, {0, 0}};

  lam_pieces_add(pieces,
                 (lam_piece){part_index, label, part->material, part->flat->thickness, high - low,
                             lam_paths_area(paths->items, paths->count), paths->count,
                             lam_paths_placed(pieces->arena, paths->items, paths->count, &turn)});
}

/* Adds the plate of one cut: a rectangle with eight holes, labelled with the size of its bolts. */
static void add_plate(lam_pieces *pieces, const lam_part *part, const lam_splice *splice) {
  lam_paths paths = {.arena = pieces->arena};
  double half = splice->half, side = splice->height / 2, size = lam_letter_height(splice->height);
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4,
                (lam_vec2[]){{-half, -side}, {half, -side}, {half, side}, {-half, side}});

  cut_line middle = {{0, 0}, {1, 0}};
  drill(&paths, splice, &middle, -1);
  drill(&paths, splice, &middle, 1);

  /* Letters shrink until they take at most .8 of the plate's length. */
  size *= fmin(1, 1.6 * half / lam_lettering_width(splice->bolt, size));
  lam_lettering_add(&paths, LAM_LAYER_LABEL, splice->bolt,
                    lam_v2(-lam_lettering_width(splice->bolt, size) / 2, -size / 2), 0, size);

  const char *label = lam_arena_printf(pieces->arena, "splice-%.0f", part->flat->height * 1e3);
  lam_pieces_add(pieces,
                 (lam_piece){-1, label, part->material, part->flat->thickness, 2 * half,
                             lam_paths_area(paths.items, paths.count), paths.count, paths.items});
}

/* Splits the outline of a strip at its cuts, from its start: what lies before a cut goes to that
 * piece, what lies after it is split at the next one. */
static void split_at_cuts(const lam_path *outline, const lam_axis *axis, double height,
                          const double *cuts, int cut_count, lam_paths *shares) {
  lam_arena *arena = shares->arena;
  lam_path rest = *outline;
  for (int k = 0; k < cut_count; k++) {
    cut_line line = line_at(axis, cuts[k]);
    lam_path before = {.points = LAM_NEW(arena, lam_vec2, rest.count + 4)};
    lam_path after = {.points = LAM_NEW(arena, lam_vec2, rest.count + 4)};
    split_outline(&rest, &line, height, &before, &after);
    lam_paths_add(&shares[k], LAM_LAYER_CUT, true, before.count, before.points);
    rest = after;
  }
  lam_paths_add(&shares[cut_count], LAM_LAYER_CUT, true, rest.count, rest.points);
}

/* See the header. shares[k] collects the paths of piece k; there is a plate for every cut. */
void lam_splice_pieces(lam_pieces *pieces, int part_index, const lam_part *part, const double *cuts,
                       int cut_count) {
  lam_arena *arena = pieces->arena;
  const lam_flat *flat = part->flat;
  lam_axis axis = lam_axis_make(arena, flat->axis, flat->axis_count);
  lam_splice splice = lam_splice_for(flat->height);

  lam_paths *shares = LAM_NEW(arena, lam_paths, cut_count + 1);
  for (int k = 0; k <= cut_count; k++) shares[k].arena = arena;
  for (int i = 0; i < flat->path_count; i++) {
    const lam_path *path = &flat->paths[i];
    if (path->layer != LAM_LAYER_CUT || path->hole)
      split_mark(path, &axis, cuts, cut_count, shares);
    else
      split_at_cuts(path, &axis, flat->height, cuts, cut_count, shares);
  }

  for (int k = 0; k <= cut_count; k++) {
    double low = k ? cuts[k - 1] : 0, high = k < cut_count ? cuts[k] : axis.length;
    cut_line start = line_at(&axis, low), end = line_at(&axis, high);
    if (k) drill(&shares[k], &splice, &start, 1);
    if (k < cut_count) drill(&shares[k], &splice, &end, -1);

    const char *label = lam_arena_printf(arena, "%s.%d", part->name, k + 1);
    label_piece(arena, flat, &axis, low, high, label, &shares[k]);
    add_piece(pieces, part_index, part, &axis, low, high, label, &shares[k]);
    if (k < cut_count) add_plate(pieces, part, &splice);
  }
}
