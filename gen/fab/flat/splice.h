/* Parts longer than the stock are cut into pieces, joined by bolted splice plates. Called by
 * fab/flat/sheet.c; where to cut stands in splice_cuts.c, the pieces in splice.c. Meters. */
#ifndef LAM_FAB_FLAT_SPLICE_H
#define LAM_FAB_FLAT_SPLICE_H

#include "fab/flat/path.h"

/* A piece of a part, or a splice plate, at its true size: the kerf is not applied. */
typedef struct lam_piece {
  int part; /* index of the part; -1: a splice plate */
  const char *label;
  const lam_material *material;
  double thickness, length, area; /* length along the axis of the part; area without holes */
  int path_count;
  lam_path *paths;
} lam_piece;

/* A list that grows; begins as {.arena = arena}. */
typedef struct lam_pieces {
  lam_arena *arena;
  int count, capacity;
  lam_piece *items;
} lam_pieces;

/* Appends a copy of piece; its label and paths are kept by pointer. */
void lam_pieces_add(lam_pieces *pieces, lam_piece piece);

/* A butt joint under a plate with two rows of two bolts on each side. */
typedef struct lam_splice {
  const char *bolt;  /* "M8"; "pin" below the smallest bolt */
  double hole;       /* diameter */
  double half;       /* half the plate's length: it reaches this far from the cut */
  double height;     /* of the plate */
  double columns[2]; /* distances of the holes from the cut */
  double row;        /* distance of the holes from the axis */
} lam_splice;

/* The joint for a strip of the given height: the largest bolt whose clearance hole (EN 20273,
 * medium) is at most height/10; end distance 2 holes, spacing 3 holes (EN 1993-1-8, table 3.3
 * asks for 1.2 and 2.2). Below the smallest bolt a hole of height/10 for a pin. */
lam_splice lam_splice_for(double strip_height);

/* Chooses where to cut a strip so that no piece is longer than `longest`, with as few cuts as
 * there can be.
 *
 *   - A plate never touches a slot or its neighborhood of one slot width.
 *   - Where possible it touches no marks either.
 *   - Where possible the cuts stay a plate's length away from those in avoid (avoid_count cuts of
 *     the other sheet of a pair).
 *   - fraction (0 to 1) says where in its free play every cut goes, so that neighbors are
 *     staggered.
 *
 * Positions are along the axis, in increasing order; *cuts is owned by arena. Returns their
 * number, or -1 when there is no room for a splice. */
int lam_splice_cuts(lam_arena *arena, const lam_flat *flat, double longest, const double *avoid,
                    int avoid_count, double fraction, double **cuts);

/* Adds the pieces of a part cut at cut_count given positions (in increasing order), labelled
 * NAME.1, NAME.2 ..., with bolt holes, and a plate per cut. part must have a flat pattern with an
 * axis. Every piece lies with its ends on a line along x. */
void lam_splice_pieces(lam_pieces *pieces, int part_index, const lam_part *part, const double *cuts,
                       int cut_count);

#endif
