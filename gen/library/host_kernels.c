/* The instruction set of the linear algebra, as the face shows it. Called through
 * lamella/session.h, by cli/main.c. */
#include "solve/factor/front.h"
#include <lamella/session.h>

const char *lam_kernels(void) { return lam_front_kernels_choose()->name; }
