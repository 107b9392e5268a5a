/* What is measured on lamellas, from their stations and solids alone. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_CHECKS_H
#define LAM_FAB_LAMELLA_LAMELLA_CHECKS_H

#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

typedef struct lam_strip_measures {
  double straightness;  /* of the strip of edge planes, unrolled (fab/unroll.h) */
  double straightening; /* height/2 times the largest curvature of that flat line: the strain at the
                           edges when a strip that was cut straight is forced into place */
  double normal_straightness; /* of the triangulated strip between the edges x -+ height/2 m */
  double bending_strain;      /* thickness/2 times the largest curvature about m */
  double twist;               /* largest rate of twist, rad/m */
  double twist_strain; /* thickness times that: the shear strain at the faces of a twisted strip */
  double edge_strain;  /* (height/2)^2 twist^2 / 2: how much longer the fibers at the edges become
                          than the middle */
  double edge_difference; /* of the lengths of the edges and of the middle line, relative, over the
                             whole strip */
  int slots;
} lam_strip_measures;
lam_strip_measures lam_strip_measure(lam_arena *arena, const lam_lamella_grid *grid,
                                     const lam_sheet_strip *strip);

/* Adds the stage "lamellas" for a grid whose parts are in the workshop: straightness, strains
 * against the material's limit, crossing angles (nodes inside the net, and on its boundary),
 * solids. strips: strip_count measures. */
void lam_lamella_stage(lam_workshop *workshop, const lam_lamella_grid *grid,
                       const lam_strip_measures *strips);

/* Adds the stage "clash": the volumes in which parts overlap, over all pairs of parts and instances
 * whose boxes do. To be called when all parts are made. Adds nothing when there are no parts. A
 * failure of the library becomes a note, and the stage has not converged. */
void lam_workshop_clash(lam_workshop *workshop);

#endif
