/* Edges of a skin with the tangent planes along them. For the files surf/asymptotic_*.c only; the mathematics is in
 * asymptotic_conormal.c.
 */
#ifndef LAM_SURF_ASYMPTOTIC_CONORMAL_H
#define LAM_SURF_ASYMPTOTIC_CONORMAL_H

#include "surf/asymptotic_parts.h"
#include "surf/asymptotic_skin.h"

enum { LAM_CONORMAL_DEGREE = 4, LAM_CONORMAL_POINTS = 5, LAM_CONORMAL_SURFACE = 9 };

typedef struct lam_conormal_edge {
  lam_vec3 points[LAM_SKIN_POINTS]; /* of the curve */
  int field_count;
  lam_vec3 field[3][LAM_CONORMAL_POINTS]; /* two or three vectors that span the tangent plane at every place */
  const char *trouble;                    /* NULL: none */
} lam_conormal_edge;

/* The edge that leaves one vertex along its first tangent and arrives at the other along that one's first tangent. */
lam_conormal_edge lam_conormal_edge_make(const lam_skin_vertex *from, const lam_skin_vertex *to);
/* The patch over four edges, in the order and direction r1, r2, r3, r4; patch->boundary is given. */
bool lam_conormal_patch_make(lam_arena *arena, const lam_conormal_edge edges[4], lam_place place, lam_errors *errors,
                             lam_asymptotic_patch *patch);

#endif
