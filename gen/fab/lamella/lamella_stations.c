/* Lays the stations of a sheet along its curve. Called by lamella_grid.c. */
#include "fab/lamella/lamella_stations.h"
#include "core/grow.h"
#include "fab/lamella/lamella_make.h"

/* How far the chords between stations may leave the edges of a strip, in meters. */
static const double largest_sag = 0.05e-3;

/* A strip while its stations are laid along its curve. */
typedef struct track {
  lam_arena *arena;
  const lam_lamella_grid *grid;
  lam_sheet_strip *strip;
  const lam_strip_curve *curve;
  int capacity;
  double begun; /* where the strip begins, in the arc length of the curve */
} track;

/* Appends a station; s: in the arc length of the curve. */
static void add_station(track *t, lam_station q, double s) {
  q.s = s - t->begun;
  LAM_APPEND(t->arena, t->strip->stations, t->strip->station_count, t->capacity, q);
}

/* Appends stations between the slots at a and b of the curve, as many as it bends. */
static void add_between(track *t, double a, double b) {
  if (b <= a) return; /* the ribs that are too narrow are reported later */
  int steps = lam_strip_curve_steps(t->curve, a, b, t->grid->height, largest_sag);
  for (int k = 1; k < steps; k++) {
    double s = a + (b - a) * k / steps;
    lam_station q = lam_strip_curve_station(t->curve, s);
    q.between = true;
    add_station(t, q, s);
  }
}

/* Appends the end (0 or 1) of a strip: on its curve, or straight on from its last place, with the
 * same section; there is nothing to add where it runs on by nothing, past no slot. */
static void add_end(track *t, const lam_span *used, const lam_places *all, int end) {
  double s = end ? used->to : used->from, step = end ? used->extend : -used->extend;
  if (!used->straight[end]) {
    add_station(t, lam_strip_curve_station(t->curve, s), s);
    return;
  }

  int i = end ? all->last : all->first;
  const lam_station *place = &all->stations[i];
  if (step == 0 && place->partner < 0) return;
  add_station(t,
              (lam_station){.x = lam_along(place->x, step, place->t),
                            .t = place->t,
                            .m = place->m,
                            .heading = t->curve->heading[i],
                            .partner = -1,
                            .crossing = -1,
                            .vertex = -1},
              s + step);
}

/* From end to end; between two slots the strip follows its curve. */
void lam_strip_lay(lam_arena *arena, const lam_lamella_grid *grid, lam_sheet_strip *strip,
                   const lam_strip_curve *curve, const lam_places *places, const lam_span *used) {
  track t = {arena, grid, strip, curve, 0, used->from - (used->straight[0] ? used->extend : 0)};
  double low, high, behind = used->from;
  add_end(&t, used, places, 0);

  for (int i = places->first; i <= places->last; i++) {
    lam_station q = places->stations[i];
    lam_station_extent(grid, &q, &low, &high);
    add_between(&t, behind, curve->s[i] + low);
    q.heading = curve->heading[i];
    add_station(&t, q, curve->s[i]);
    behind = curve->s[i] + high;
  }

  add_between(&t, behind, used->to);
  add_end(&t, used, places, 1);
  strip->length = strip->stations[strip->station_count - 1].s;
}
