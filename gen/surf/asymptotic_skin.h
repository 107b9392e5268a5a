/* Smooth skins over nets whose mesh polylines are to become asymptotic curves: one bi-9 patch per face. Patches that
 * share an edge share its curve and the tangent planes along it, because those are the osculating planes of the curve.
 */
#ifndef LAM_SURF_ASYMPTOTIC_SKIN_H
#define LAM_SURF_ASYMPTOTIC_SKIN_H

#include "surf/asymptotic_quad.h"

/* A vertex where two asymptotic curves cross: along u (0) and along v (1). */
typedef struct lam_skin_vertex {
  lam_vec3 point;
  lam_vec3 tangent[2]; /* derivatives when every edge has the parameter length 1; not parallel */
  double curvature[2]; /* 1/m; positive where the curve bends towards the other tangent; may be 0 */
  double torsion;      /* 1/m, of the curve along u; that along v has the opposite one */
} lam_skin_vertex;

/* The patches over count[0] x count[1] vertices (v running fastest), (count[0] - 1) x (count[1] - 1) of them in the
 * same order. The curves have degree 7 and, with the given ends, the least integral of |r'''|^2. false, with an error,
 * when some patch folds over its boundary or tangents are parallel. */
bool lam_asymptotic_skin_make(lam_arena *arena, const int count[2], const lam_skin_vertex *vertices, lam_place place,
                              lam_errors *errors, lam_asymptotic_patch *patches);

#endif
