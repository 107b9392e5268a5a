/* Pieces of POV-Ray scene language, and the net as a scene shows it when a design has no parts:
 * white faces and thin lines. Called by pov.c and pov_print.c. */
#ifndef LAM_FORMATS_POV_POV_NET_H
#define LAM_FORMATS_POV_POV_NET_H

#include "core/model.h"
#include "core/text.h"

/* Declares Net_Faces (a smooth mesh) and Net_Lines (a cylinder per edge, a sphere per vertex;
 * twice as thick along the boundary). smooth_angle: radians, as for lam_pov_mesh; decimals: of
 * coordinates in meters. */
void lam_pov_net_add(lam_text *out, const lam_mesh *net, double smooth_angle, int decimals);

/* Text of the scene language: <x,y,z>, with at most so many decimals. */
void lam_pov_vector(lam_text *out, lam_vec3 v, int decimals);
/* Declares a mesh2 called name, whose normals are smooth across edges flatter than smooth_angle
 * (radians). */
void lam_pov_mesh(lam_text *out, const char *name, const lam_trimesh *mesh, double smooth_angle,
                  int decimals);

#endif
