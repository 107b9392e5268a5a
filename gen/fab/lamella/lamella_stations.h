/* The stations of a sheet along its curve: those at vertices of the net, ends, and as many in
 * between as it bends. Called by lamella_grid.c. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_STATIONS_H
#define LAM_FAB_LAMELLA_LAMELLA_STATIONS_H

#include "fab/lamella/lamella_curve.h"

/* The stations of a strip at the vertices that its curve goes through, as far as they are known
 * without it. Those from first to last are the strip's own; others lie beyond its ends. */
typedef struct lam_places {
  int count, first, last;
  lam_station *stations;
} lam_places;

/* What of its curve a strip uses, from `from` to `to` in arc length, and how far it runs on
 * straight beyond these, in meters; straight: it does at that end, be it by nothing. */
typedef struct lam_span {
  double from, to, extend;
  bool straight[2];
} lam_span;

/* Fills stations, station_count and length of a strip: its places with arc length and heading, both
 * ends, and stations in between that keep chords within .05 mm of the edges. curve: through all
 * places, in order. The stations are owned by arena. */
void lam_strip_lay(lam_arena *arena, const lam_lamella_grid *grid, lam_sheet_strip *strip,
                   const lam_strip_curve *curve, const lam_places *places, const lam_span *used);

#endif
