/* The folder that a build writes into. It is opened once, and every name in it is reached from its
 * own descriptor without following links: what a name means cannot be changed by anybody else on
 * the way, and nothing outside is ever written or removed. While it is open no other build writes
 * into it. Called by models.c, write_files.c, manifest.c and render.c. */
#ifndef LAM_LIBRARY_WRITE_FOLDER_H
#define LAM_LIBRARY_WRITE_FOLDER_H

#include "core/error.h"
#include "core/progress.h"

#include <stdbool.h>

typedef struct lam_folder {
  const char *path; /* without a slash at its end */
  int descriptor;
  int leftovers[3]; /* places of its temporary files in core/leftover.h */
} lam_folder;

/* Temporary names in a folder, one at a time under its lock. POV-Ray keeps its state beside the
 * picture that it makes. */
#define LAM_FOLDER_PART ".lamella-part"
#define LAM_FOLDER_PICTURE ".lamella-part.png"
#define LAM_FOLDER_STATE ".lamella-part.pov-state"

/* Opens a folder, which is made when it is missing, and removes what a build that was killed has
 * left in it. A folder that another build has open is waited for, `wait` seconds at most, and
 * progress is told. Closed with arena, or by lam_folder_close. NULL with a message: LAM_IO. */
lam_folder *lam_folder_open(lam_arena *arena, const char *path, double wait,
                            const lam_progress *progress, lam_errors *errors);
/* Lets go of the lock and removes what is temporary. */
void lam_folder_close(lam_folder *folder);

/* In all functions below a name is relative to the folder; what has "..", a link to a folder or an
 * empty part on its way is refused (ELOOP, ENOTDIR or EINVAL). */

/* Writes a file, and the folders on its way, so that nobody sees half of it; what had its name is
 * replaced, a link itself and not what it points to. LAM_IO with a message. */
lam_status lam_folder_write(const lam_folder *folder, const char *name, const void *bytes,
                            size_t count, lam_errors *errors);
/* The bytes of a plain file, in arena; NULL: there is none that can be read, or it is larger than
 * 1 GiB. */
char *lam_folder_read(lam_arena *arena, const lam_folder *folder, const char *name, size_t *count);
/* Gives a file another name in the same folder of it; a file of that name is replaced. Returns 0,
 * or the error number. */
int lam_folder_rename(const lam_folder *folder, const char *name, const char *base);
/* Removes a file or a link; false: there is none. */
bool lam_folder_remove(const lam_folder *folder, const char *name);
/* Whether something has this name. */
bool lam_folder_has(const lam_folder *folder, const char *name);

#endif
