/* The list of files that a build made, kept in its folder as .lamella-files: the design's name,
 * then one path per line. With it the next build of the design takes away what it no longer makes,
 * so that nobody cuts a part that is gone.
 */
#ifndef LAM_LIBRARY_WRITE_MANIFEST_H
#define LAM_LIBRARY_WRITE_MANIFEST_H

#include "core/error.h"
#include <stdbool.h>

/* Removes the files that the last build of this design made in the folder and that are not among
 * `made` (paths that start with the folder), unless `partial`: then they stay listed. Files of
 * other designs, and all that lamella did not write, are left alone. Returns how many were removed.
 */
int lam_manifest_update(lam_arena *arena, const char *folder, const char *design, int count,
                        const char *const *made, bool partial, lam_errors *errors);

#endif
