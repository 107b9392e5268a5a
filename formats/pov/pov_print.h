/* Prints in a POV-Ray scene: meshes with texture coordinates, on which print.png is shown. Called
 * by pov.c. */
#ifndef LAM_FORMATS_POV_POV_PRINT_H
#define LAM_FORMATS_POV_POV_PRINT_H

#include "core/error.h"
#include "core/model.h"
#include "core/text.h"

/* Declares Sheet_1, Sheet_2 ... and their texture; decimals: of coordinates in meters. */
void lam_pov_print_add(lam_text *out, const lam_print *print, int decimals);
/* Puts them into the scene, with running numbers; number is that of the last object before. */
void lam_pov_print_objects(lam_text *out, const lam_print *print, int number);
/* Adds the bytes of print.png. LAM_OK, or LAM_FAILED when libpng failed. */
lam_status lam_pov_print_picture(lam_text *out, const lam_print *print);

#endif
