/* The list of files that a build made, kept in its folder as .lamella-files: the design's name,
 * then one path per line. With it the next build of the design takes away what it no longer makes,
 * so that nobody cuts a part that is gone. Called by models.c. */
#ifndef LAM_LIBRARY_WRITE_MANIFEST_H
#define LAM_LIBRARY_WRITE_MANIFEST_H

#include "core/error.h"
#include <stdbool.h>

/* Removes the files that the last build of this design made in the folder and that this one did
 * not, and writes the new list. Files of other designs, and all that lamella did not write, are
 * left alone.
 *
 *   folder   without a slash at its end
 *   design   its name
 *   made     count paths that start with the folder
 * partial not everything was to be made: nothing is removed, and what was made before stays listed
 *
 * Returns how many files were removed. A list that cannot be written is added to errors
 * (LAM_IO). */
int lam_manifest_update(lam_arena *arena, const char *folder, const char *design, int count,
                        const char *const *made, bool partial, lam_errors *errors);

#endif
