/* Meshes as other programs write them, made ready to become nets: vertices that lie twice, vertices
 * in no face, faces that are turned the other way. Called by library/start_mesh.c for every mesh
 * file that a net starts from. */
#ifndef LAM_MESH_TIDY_H
#define LAM_MESH_TIDY_H

#include "core/error.h"
#include "core/model.h"

/* What was found in a mesh, and what was done about it. */
typedef struct lam_tidied {
  int doubled; /* places at which more than one vertex lies, after welding */
  int pieces;  /* of the mesh: faces that hang together by their vertices */
  int welded;  /* vertices that were joined to an earlier one, and are gone */
  int unused;  /* vertices in no face that were left out */
  int turned;  /* faces that were turned, so that all of a piece agree */
} lam_tidied;

/* Tidies a mesh. Vertices keep their order, faces their numbers; faces are turned to agree with the
 * larger part of their piece. What cannot be mended is left as it is, for lam_net_build to refuse:
 * edges of more than two faces, faces that name a vertex twice, faces with the same corners, pieces
 * with one side. Expected time O(n).
 *
 *   mesh       in and out; new arrays where something changed, owned by arena. Faces of three
 *              corners (the last is -1) may be among them
 *   tolerance  vertices that are closer become one (meters; 0: at the same place up to rounding);
 *              negative: none
 *
 * Welding that would make two corners of a face one is refused; *face is its number from 0 then,
 * the mesh stays as it was, and false is returned. */
bool lam_mesh_tidy(lam_arena *arena, lam_mesh *mesh, double tolerance, lam_tidied *found,
                   int *face);

#endif
