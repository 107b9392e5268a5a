/* Prints in a POV-Ray scene: meshes with places of print.png at their vertices. */
#ifndef LAM_FORMATS_POV_POV_PRINT_H
#define LAM_FORMATS_POV_POV_PRINT_H

#include "core/error.h"
#include "core/model.h"
#include "core/text.h"

/* Declares Sheet_1, Sheet_2 ... and their texture. */
void lam_pov_print_add(lam_text *out, const lam_print *print, int decimals);
/* Places them; number is that of the last object before. */
void lam_pov_print_objects(lam_text *out, const lam_print *print, int number);
/* The bytes of print.png. */
lam_status lam_pov_print_picture(lam_text *out, const lam_print *print);

#endif
