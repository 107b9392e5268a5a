/* The mesh that a net starts from, read of a file and made ready: its unit and size, vertices that
 * lie twice or in no face, faces that are turned. Called by sources.c and read_files.c. */
#ifndef LAM_LIBRARY_START_MESH_H
#define LAM_LIBRARY_START_MESH_H

#include "design/inputs.h"
#include "net/net_kind.h"

/* Reads the mesh file of net.from into inputs->net, in meters, with notes on what was found.
 *
 *   path      of the file
 *   from      its unit, size and weld; zeroed: meters, as it is
 *   location  of the net in the design, for messages about keys
 *
 * All is owned by arena. False with messages. */
bool lam_start_mesh_read(lam_arena *arena, const char *path, const lam_net_source *from,
                         lam_location location, lam_errors *errors, lam_inputs *inputs);
/* The same for the finished net of another design, of which only the size may change. mesh is
 * kept where that is not asked for. */
bool lam_start_mesh_take(lam_arena *arena, const lam_mesh *mesh, const lam_net_source *from,
                         lam_location location, lam_errors *errors, lam_inputs *inputs);

/* The factor that turns coordinates of the file, as its format is read, into meters when they are
 * in this unit (an index into lam_file_units). */
double lam_start_mesh_unit(const char *path, int unit);
/* Multiplies count points by a factor, in place. */
void lam_start_mesh_scale(lam_vec3 *points, int count, double factor);

#endif
