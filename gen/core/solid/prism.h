/* The volume common to two closed surfaces, by integration: asks nothing of them but that they
 * are closed. Used by solid_shim.cc where the exact intersection is refused or takes too long. */
#ifndef LAM_CORE_SOLID_PRISM_H
#define LAM_CORE_SOLID_PRISM_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The common volume, m^3, exact up to rounding; noise is cut to 0. Where a surface winds around a
 * place more than once, it counts as often. a, b: closed and oriented, with finite coordinates.
 * LAM_NO_MEMORY. Never jumps: C++ may call it. */
lam_status lam_prism_volume(const lam_trimesh *a, const lam_trimesh *b, double *volume);

#ifdef __cplusplus
}
#endif

#endif
