/* The list of files that a build made, kept in its folder as .lamella-files: the design's name,
 * then a path and the hash of its bytes per line. With it the next build of the design takes away
 * what it no longer makes, so that nobody cuts a part that is gone, and sees what somebody has
 * changed since. Called by models.c and write_files.c. */
#ifndef LAM_LIBRARY_WRITE_MANIFEST_H
#define LAM_LIBRARY_WRITE_MANIFEST_H

#include "library/write/folder.h"

#include <stdint.h>

/* A file of a list. */
typedef struct lam_listed_file {
  const char *name;
  bool has_hash; /* false: what it held is not known */
  uint64_t hash;
} lam_listed_file;

/* Files in the order of their names. */
typedef struct lam_manifest {
  const char *design; /* whose build made them; NULL: there is no list */
  int count;
  lam_listed_file *files;
} lam_manifest;

/* The hash of a file's bytes (64-bit FNV-1a). */
uint64_t lam_manifest_hash(const void *bytes, size_t count);
/* The list in the folder; one that cannot be read is none. Lists of earlier versions, without
 * hashes, are read too. */
lam_manifest lam_manifest_read(lam_arena *arena, const lam_folder *folder);
/* The file of this name, or NULL. */
const lam_listed_file *lam_manifest_find(const lam_manifest *manifest, const char *name);
/* Sorts the files and takes out all but one of those with the same name, whose hash is not known
 * then. */
void lam_manifest_sort(lam_manifest *manifest);
/* Writes a list; its files are sorted first. LAM_IO with a message. */
lam_status lam_manifest_write(const lam_folder *folder, lam_manifest *manifest, lam_errors *errors);

/* Whether the file in the folder is another one than that which was listed; false when there is no
 * such file, when it is not listed, or when its hash is not known. */
bool lam_manifest_changed(lam_arena *arena, const lam_folder *folder, const lam_manifest *old,
                          const char *name);

#endif
