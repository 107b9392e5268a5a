/* The developed outline of a lamella with its slots. Called by lamella.c when all strips of a
 * grid have become parts. */
#include "fab/lamella/lamella_flat.h"
#include "fab/flat/unroll.h"
#include "fab/lamella/lamella_make.h"

#include <math.h>

/* A developed middle line that leaves its chord by less than this share of its length is cut
 * straight. Sheets of a pair run beside the asymptotic curve and develop to lines that leave
 * their chord by some 1e-4 of the length. Cut straight they are pushed into place with a strain
 * of a few 1e-5 (straightening_strain in the report), far below what bending and twisting ask of
 * them; 5e-4 is where a workshop would begin to see the curve. */
static const double straight_enough = 5e-4;

/* The developed middle line: steps as long as the curve is between stations, in the mean of the
 * headings at their ends. Positions along it are arc lengths therefore, and on an arc the points
 * lie outside of it by a third of the sag. Where the line bends up to an end, a short first step
 * keeps the direction there, for the cut across the strip is square to it. points: room for
 * station_count + 2; returns how many there are. */
static int middle_line(const lam_sheet_strip *strip, lam_vec2 *points) {
  static const double share = 1. / 64; /* of a step, next to an end */
  int n = strip->station_count, count = 1;
  points[0] = lam_v2(0, 0);

  for (int i = 1; i < n; i++) {
    const lam_station *a = &strip->stations[i - 1], *b = &strip->stations[i];
    double length = b->s - a->s, turn = b->heading - a->heading, part[3] = {0, 1, 1};
    if (turn != 0 && i == 1) part[0] = share;
    if (turn != 0 && i == n - 1) part[1] = 1 - share;

    for (int k = 0; k < 3; k++) {
      double from = k ? part[k - 1] : 0, step = (part[k] - from) * length;
      double heading = a->heading + (from + part[k]) / 2 * turn;
      if (step <= 0) continue;
      points[count] = lam_v2(points[count - 1].x + step * cos(heading),
                             points[count - 1].y + step * sin(heading));
      count++;
    }
  }
  return count;
}

bool lam_lamella_is_straight(lam_arena *arena, const lam_sheet_strip *strip) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_vec2 *line = LAM_NEW(arena, lam_vec2, strip->station_count + 2);
  double straightness = lam_straightness(line, middle_line(strip, line));
  lam_arena_release(arena, mark);
  return straightness < straight_enough;
}

/* The axis of the pattern. A straight one becomes its two ends, any other line is turned so that
 * its ends lie on the x axis, the first at the origin. The line of a reversed strip is mirrored end
 * for end; across, up stays up. */
static void develop(lam_arena *arena, const lam_sheet_strip *strip, lam_flat *flat) {
  int n = strip->station_count;
  lam_vec2 *line = LAM_NEW(arena, lam_vec2, n + 2);
  flat->axis = LAM_NEW(arena, lam_vec2, n + 2);
  if (lam_lamella_is_straight(arena, strip)) {
    flat->axis[1] = lam_v2(strip->stations[n - 1].s - strip->stations[0].s, 0);
    flat->axis_count = 2;
    return;
  }

  n = middle_line(strip, line);
  lam_vec2 first = line[flat->reversed ? n - 1 : 0], last = line[flat->reversed ? 0 : n - 1];
  double mirror = flat->reversed ? -1 : 1, dx = mirror * (last.x - first.x), dy = last.y - first.y;
  double chord = hypot(dx, dy), c = chord > 0 ? dx / chord : 1, s = chord > 0 ? -dy / chord : 0;

  for (int i = 0; i < n; i++) {
    lam_vec2 p = line[flat->reversed ? n - 1 - i : i];
    double px = mirror * (p.x - first.x), py = p.y - first.y;
    flat->axis[i] = lam_v2(c * px - s * py, s * px + c * py);
  }
  flat->axis_count = n;
}

/* The slot of a station in the flat pattern (see fab/lamella/lamella.h for the sizes): above the
 * floor in family 0, below it in family 1. */
static lam_flat_slot slot_of(const lam_lamella_grid *grid, const lam_sheet_strip *strip,
                             const lam_station *station, bool reversed) {
  double low, high;
  lam_station_extent(grid, station, &low, &high);
  double first = strip->stations[0].s, last = strip->stations[strip->station_count - 1].s;
  double at = reversed ? last - station->s : station->s - first;

  lam_flat_slot slot = {at + (reversed ? -high : low), at + (reversed ? -low : high),
                        -grid->clearance, grid->height / 2, at};
  if (strip->family == 1) {
    slot.bottom = -grid->height / 2;
    slot.top = grid->clearance;
  }
  return slot;
}

/* One edge of the outline, from the start of the axis to its end, at h = side * height/2, with
 * the slots that open there. Between corner points the edge runs parallel to the axis. points has
 * room for axis->count + 4 slot_count; returns how many there are. */
static int edge(const lam_flat *flat, const lam_axis *axis, double side, lam_vec2 *points) {
  double h = side * flat->height / 2;
  int count = 0, slot = 0, corner = 0;
  while (corner < axis->count || slot < flat->slot_count) {
    const lam_flat_slot *next = slot < flat->slot_count ? &flat->slots[slot] : NULL;

    /* Corners of the axis and slots come in the order of their positions. */
    if (next && (corner == axis->count || next->low <= axis->s[corner])) {
      double floor = side > 0 ? next->bottom : next->top;
      bool open = side > 0 ? next->top >= h : next->bottom <= h;

      /* A slot is a rectangle about the line across the strip at its middle; corners of the axis
       * inside of it are left out. */
      lam_vec2 up, x = lam_axis_point(axis, next->at, 0, &up);

      double ends[4][2] = {
          {next->low, h}, {next->low, floor}, {next->high, floor}, {next->high, h}};
      for (int i = 0; i < 4 && open; i++) {
        double along = ends[i][0] - next->at, across = ends[i][1];
        points[count++] =
            lam_v2(x.x + up.y * along + up.x * across, x.y - up.x * along + up.y * across);
      }
      while (open && corner < axis->count && axis->s[corner] <= next->high) corner++;
      slot++;
    } else
      points[count++] = lam_axis_point(axis, axis->s[corner++], h, NULL);
  }
  return count;
}

/* The outline: the lower edge from start to end, then the upper one back, counterclockwise. */
static void outline(lam_arena *arena, const lam_flat *flat, const lam_axis *axis,
                    lam_paths *paths) {
  int most = axis->count + 4 * flat->slot_count;
  lam_vec2 *points = LAM_NEW(arena, lam_vec2, 2 * most);
  int count = edge(flat, axis, -1, points);
  lam_vec2 *upper = LAM_NEW(arena, lam_vec2, most);
  for (int i = edge(flat, axis, 1, upper) - 1; i >= 0; i--) points[count++] = upper[i];
  lam_paths_add(paths, LAM_LAYER_CUT, true, count, points);
}

/* Axis, slots, outline, marks: each is drawn from what stands before it. */
lam_flat *lam_lamella_flat(lam_arena *arena, const lam_lamella_grid *grid,
                           const lam_sheet_strip *strip) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  int n = strip->station_count;
  const char **names = LAM_NEW(arena, const char *, n);
  flat->thickness = grid->thickness;
  flat->height = grid->height;
  flat->reversed = strip->offset > 0;
  flat->slots = LAM_NEW(arena, lam_flat_slot, n);

  develop(arena, strip, flat);
  for (int i = 0; i < n; i++) {
    const lam_station *station = &strip->stations[flat->reversed ? n - 1 - i : i];
    if (station->partner < 0) continue;
    names[flat->slot_count] = grid->strips[station->partner].name;
    flat->slots[flat->slot_count++] = slot_of(grid, strip, station, flat->reversed);
  }

  lam_axis axis = lam_axis_make(arena, flat->axis, flat->axis_count);
  lam_paths paths = {.arena = arena};
  outline(arena, flat, &axis, &paths);
  lam_flat_marks(arena, flat, strip->name, strip->family, grid->pair > 0, names, &paths);

  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* Single sheets and the sheets of pairs are strips alike, and every strip is a part. */
void lam_lamella_flats(lam_workshop *workshop) {
  const lam_lamella_grid *grid = workshop->lamella_grid;
  for (int i = 0; grid && i < grid->strip_count; i++) {
    const lam_sheet_strip *strip = &grid->strips[i];
    workshop->parts[strip->part].flat = lam_lamella_flat(workshop->arena, grid, strip);
  }
}
