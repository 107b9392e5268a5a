/* Flat patterns of lamellas: the developed outline with its slots, marks and names. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_FLAT_H
#define LAM_FAB_LAMELLA_LAMELLA_FLAT_H

#include "fab/flat/axis.h"
#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

/* A strip whose developed middle line leaves its chord by less than this share of its length is cut
 * straight. */
extern const double lam_flat_straight;

/* Gives every part of workshop->lamella_grid its flat pattern. Does nothing when there is no grid.
 */
void lam_lamella_flats(lam_workshop *workshop);

/* The flat pattern of one strip. Across the strip is the height direction m of its stations,
 * upwards. The side that faces the viewer, and is marked, is the outer one of a pair; the pattern
 * of a sheet with a positive offset is therefore reversed: it begins at the sheet's last station. A
 * single sheet shows the side that -b points to. */
lam_flat *lam_lamella_flat(lam_arena *arena, const lam_lamella_grid *grid,
                           const lam_sheet_strip *strip);

/* Draws the marks (fab/flat_marks.c): a tick on ENGRAVE at every crossing, between the slot and the
 * opposite edge; the partner's name beside it on LABEL; the framed own name near both ends; near
 * the start a triangle (family 0) or a square (family 1), an arrow that points up, "UP", and in a
 * pair "OUT". Nothing lies on a slot or outside of the part. What finds no room even at a tenth of
 * its size is left out. names has an entry per slot, in the order of flat->slots.
 */
void lam_flat_marks(lam_arena *arena, const lam_flat *flat, const char *name, int family, bool pair,
                    const char *const *names, lam_paths *paths);

#endif
