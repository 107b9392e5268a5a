/* Parameters for points that a curve shall pass through (Piegl & Tiller, The NURBS Book, 9.2.1). */
#ifndef LAM_CURVE_BSPLINE_PARAMETERS_H
#define LAM_CURVE_BSPLINE_PARAMETERS_H

#include "core/vec3.h"

typedef enum lam_parameters {
  LAM_PARAMETERS_UNIFORM,        /* equal steps */
  LAM_PARAMETERS_CHORD,          /* steps like the distances d of the points */
  LAM_PARAMETERS_CENTRIPETAL,    /* like sqrt d (Lee 1989) */
  LAM_PARAMETERS_MODIFIED_CHORD, /* like d, longer beside turns (Foley & Nielson 1989) */
  LAM_PARAMETERS_COUNT
} lam_parameters;
extern const char *const lam_parameters_names[]; /* in the order of the kinds, NULL-terminated */

/* Fills t[0 .. count - 1], from 0 to 1, increasing. Precondition: count >= 2, neighboring points
 * differ (equal neighbors get equal parameters, except with uniform steps). */
void lam_parameters_choose(lam_parameters kind, int count, const lam_vec3 *points, double *t);

#endif
