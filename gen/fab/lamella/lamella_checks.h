/* What is measured on lamellas, from their stations and solids alone, and on all parts together.
 * Called by lamella.c; the clash check by design/parts_stage.c. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_CHECKS_H
#define LAM_FAB_LAMELLA_LAMELLA_CHECKS_H

#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

typedef struct lam_strip_measures {
  /* Of the strip of edge planes, unrolled (fab/flat/unroll.h): the share of its length by which it
   * leaves its chord. */
  double straightness;
  /* The strain at the edges that the shape it is cut to leaves to be forced: height/2 times the
   * largest curvature of that flat line when the strip is cut straight, 0 when it is cut as it
   * develops. */
  double straightening;
  double normal_straightness; /* of the triangulated strip between the edges x -+ height/2 m */
  double bending_strain;      /* thickness/2 times the largest curvature about m */
  double twist;               /* largest rate of twist, rad/m */
  double twist_strain; /* thickness times that: the shear strain at the faces of a twisted strip */
  /* (height/2)^2 twist^2 / 2: how much longer the fibers at the edges become than the middle. */
  double edge_strain;
  /* Relative difference of the lengths of the edges and of the middle line of the strip. */
  double edge_difference;
  int slots;
} lam_strip_measures;
/* The measures of one strip of a grid. arena is only used for scratch. */
lam_strip_measures lam_strip_measure(lam_arena *arena, const lam_lamella_grid *grid,
                                     const lam_sheet_strip *strip);

/* Adds the stage "lamellas" for a grid whose parts are in the workshop: straightness, strains
 * against the material's limit, crossing angles (nodes inside the net, and on its boundary),
 * solids. strips: a measure per strip of the grid. */
void lam_lamella_stage(lam_workshop *workshop, const lam_lamella_grid *grid,
                       const lam_strip_measures *strips);

/* Adds the stage "clash": the volumes in which parts overlap, over all pairs of parts and
 * instances whose boxes do. To be called when all parts are made. Adds nothing when there are no
 * parts, or none that is more than drawn. A failure of the library becomes a note, and the stage
 * has not converged. */
void lam_workshop_clash(lam_workshop *workshop);

#endif
