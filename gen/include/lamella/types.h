/* Plain geometry: vectors, meshes, splines. Meters, radians, z up. Pointers are read only unless a
 * function says otherwise; who owns what they point to stands at the function that gives them. */
#ifndef LAMELLA_TYPES_H
#define LAMELLA_TYPES_H

#include <lamella/api.h>
#include <stdbool.h>
#include <stddef.h>

LAM_BEGIN_DECLS

/* ---- vectors ---- */

typedef struct lam_vec2 {
  double x, y;
} lam_vec2;

typedef struct lam_vec3 {
  double x, y, z;
} lam_vec3;

/* ---- meshes ---- */

/* Triangles as three indices of vertices each, from 0: counterclockwise seen from outside. */
typedef struct lam_trimesh {
  int vertex_count;
  lam_vec3 *vertices; /* vertex_count */
  int triangle_count;
  int (*triangles)[3]; /* triangle_count x 3 */
} lam_trimesh;

/* A quad mesh: four indices of vertices per face, from 0, counterclockwise seen from the side of
 * the normal; a face with three corners has corners[3] == -1. */
typedef struct lam_mesh {
  int vertex_count;
  lam_vec3 *vertices; /* vertex_count */
  int face_count;
  int (*faces)[4]; /* face_count x 4 */
} lam_mesh;

/* A line of a net, from vertex to vertex. */
typedef struct lam_polyline {
  int family;  /* 0 or 1; -1 for a boundary loop */
  bool closed; /* the last vertex is joined to the first, and is not repeated */
  int count;
  int *vertices; /* count indices of the net's vertices */
} lam_polyline;

/* ---- splines ---- */

/* A spline curve x(t) = sum N_i(t) w_i P_i / sum N_i(t) w_i, with B-splines N_i. */
typedef struct lam_spline_curve {
  int degree, count;
  const double *knots;    /* count + degree + 1 numbers that do not decrease */
  const lam_vec3 *points; /* count; meters, not multiplied by weights */
  const double *weights;  /* count, positive; NULL: all 1, a polynomial curve */
} lam_spline_curve;

/* A tensor-product spline surface
 * x(u,v) = sum N_i(u) N_j(v) w_ij P_ij / sum N_i(u) N_j(v) w_ij. */
typedef struct lam_spline_surface {
  const char *name; /* unique and file-name safe; NULL outside a model */
  int degree[2], count[2];
  const double *knots[2]; /* count + degree + 1 numbers that do not decrease */
  const lam_vec3 *points; /* count[0] x count[1], v running fastest; meters, without weights */
  const double *weights;  /* positive, in the order of points; NULL: all 1 */
} lam_spline_surface;

/* A curve for CAD programs: the axis of a lamella, or a line of the net. */
typedef struct lam_named_curve {
  const char *name; /* unique among the curves and file-name safe, for instance "A07" */
  int family;       /* 0, 1, or -1 */
  lam_spline_curve spline;
} lam_named_curve;

/* ---- progress ---- */

/* How a long computation tells what it is doing. tell may be NULL: nobody is told.
 *   context   as below
 *   stage     a few words; NULL at the end of lam_model_write, when all is done
 *   fraction  0 to 1, negative when unknown
 *   detail    for instance "iteration 3, residual 1e-5"; may be empty
 * The texts live during the call only. It is called from the thread that called the library, and
 * must not call the session. */
typedef struct lam_progress {
  void (*tell)(void *context, const char *stage, double fraction, const char *detail);
  void *context; /* handed to tell */
} lam_progress;

LAM_END_DECLS

#endif
