/* The net as a POV-Ray scene shows it when a design has no parts: white faces and thin lines. */
#ifndef LAM_FORMATS_POV_POV_NET_H
#define LAM_FORMATS_POV_POV_NET_H

#include "core/model.h"
#include "core/text.h"

/* Declares Net_Faces (a smooth mesh) and Net_Lines (a cylinder per edge, a sphere per vertex; twice
 * as thick along the boundary). */
void lam_pov_net_add(lam_text *out, const lam_mesh *net, double smooth_angle, int decimals);

/* Text of the scene language: <x,y,z>. */
void lam_pov_vector(lam_text *out, lam_vec3 v, int decimals);
/* A mesh2 called name, its normals smooth across edges flatter than smooth_angle. */
void lam_pov_mesh(lam_text *out, const char *name, const lam_trimesh *mesh, double smooth_angle,
                  int decimals);

#endif
