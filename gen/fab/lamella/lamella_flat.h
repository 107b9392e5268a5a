/* Flat patterns of lamellas: the developed outline with its slots, marks and names. Called by
 * lamella.c; outlines are drawn in lamella_flat.c, marks in lamella_marks.c. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_FLAT_H
#define LAM_FAB_LAMELLA_LAMELLA_FLAT_H

#include "fab/flat/axis.h"
#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

/* Gives every part of workshop->lamella_grid its flat pattern, owned by the workshop's arena.
 * Does nothing when there is no grid. */
void lam_lamella_flats(lam_workshop *workshop);

/* The flat pattern of one strip, owned by arena. Across the strip is the height direction m of
 * its stations, upwards. The side that faces the viewer, and is marked, is the outer one of a
 * pair; the pattern of a sheet with a positive offset is therefore reversed: it begins at the
 * sheet's last station. A single sheet shows the side that -b points to. A line that is straight
 * to 5e-4 of its length is drawn straight. */
lam_flat *lam_lamella_flat(lam_arena *arena, const lam_lamella_grid *grid,
                           const lam_sheet_strip *strip);

/* Whether the pattern of a strip is cut straight. Otherwise it is cut as it develops. arena is only
 * used for scratch. */
bool lam_lamella_is_straight(lam_arena *arena, const lam_sheet_strip *strip);

/* Draws the marks of a strip with the outline flat and adds them to paths:
 *
 *   - at every crossing a tick on ENGRAVE, between the slot and the opposite edge, and the
 *     partner's name beside it on LABEL;
 *   - the framed own name near both ends;
 *   - near the start a triangle (family 0) or a square (family 1), an arrow that points up, "UP",
 *     and in a pair "OUT".
 *
 * Nothing lies on a slot or outside of the part. What finds no room even at a tenth of its size
 * is left out. names has an entry per slot, in the order of flat->slots. */
void lam_flat_marks(lam_arena *arena, const lam_flat *flat, const char *name, int family, bool pair,
                    const char *const *names, lam_paths *paths);

#endif
