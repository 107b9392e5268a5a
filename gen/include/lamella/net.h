/* Nets from arrays: solving and measuring without a design file. */
#ifndef LAMELLA_NET_H
#define LAMELLA_NET_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

/* ---- solving ---- */

/* A net to be solved. Only read, during the call. */
typedef struct lam_net_task {
  const char *net; /* what stands after `net:` in a design, in the form with braces: "{kind:
                      asymptotic, orthogonal: yes}". `from` is not given; `reference` needs no
                      file */
  lam_mesh start;  /* quads, none of them with three corners; vertices in meters */
  const lam_trimesh *reference; /* the surface that the key `reference` speaks of, meters; NULL:
                                   none */
} lam_net_task;

/* What came of it; owned by the session. */
typedef struct lam_net_solution {
  bool converged;     /* proven by the measures of the kind, and not degenerate */
  const char *reason; /* why it stopped, in words */
  int iterations;
  double residual; /* largest, in mean edges or radians */
  lam_mesh mesh;   /* vertices in meters; those and the faces of the start in the same order, unless
                      the keys ask for another mesh (diagonalize, coarsen, subdivide) */
  int polyline_count;
  const lam_polyline *polylines; /* of both families */
  int measure_count;
  const lam_measure *measures; /* computed from positions alone */
} lam_net_solution;

/* Moves the vertices until the constraints of the net's kind hold (guided projection, thesis 3.7).
 * Not converging is a result: LAM_OK, and solution->converged is false. The progress of the session
 * is told. solution is all zero with any other status than LAM_OK.
 *
 *   LAM_BAD_INPUT  the keys or the mesh are wrong: edges with more than two faces, triangles, faces
 *                  that are not oriented alike, vertices without faces
 *   LAM_IO         a file that the keys name cannot be read
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_net_solve(lam_session *session, const lam_net_task *task,
                                 lam_net_solution *solution);

/* ---- measuring ---- */

/* What is measured. Zeroed, with a mesh, it is every measure but the slow ones, angles against 90
 * degrees. Only read, during the call. */
typedef struct lam_measure_task {
  const lam_mesh *mesh;         /* quads, vertices in meters */
  const char *name;             /* of the mesh, for messages and maps; NULL: none */
  const char *as;               /* only the measures that prove this kind of net; NULL: all */
  double angle;                 /* crossing angle of angle_deviation, radians; 0: a right angle */
  const lam_trimesh *reference; /* mesh that distances are measured to, meters; NULL: none */
  const double *axis;           /* 6 numbers: a point (meters) and the direction, of any length but
                                   0, of the axis of a surface of revolution; NULL: none */
  const char *map;              /* a measure to be drawn as a color map; NULL: none */
  const char *map_path;         /* its file, .svg, .png or .glb; not NULL when map is given. A map
                                   does not replace a file called name or reference_name */
  const char *reference_name;   /* of the file of the reference; NULL: none */
} lam_measure_task;

/* What was measured; owned by the session. */
typedef struct lam_measured {
  int boundary_loops, irregular_vertices; /* irregular: inside, without four edges */
  int measure_count;
  const lam_measure *measures; /* those that need a reference or an axis: undefined without it */
} lam_measured;

/* Whether the names of the task (as, map, map_path) exist or can be written: to be asked before the
 * mesh is read, which may be NULL here. LAM_BAD_INPUT, LAM_NO_MEMORY. */
LAM_API lam_status lam_measure_task_check(lam_session *session, const lam_measure_task *task);

/* Measures the mesh as a net, and draws the map if there is one. measured is meaningful with
 * LAM_OK.
 *
 *   LAM_BAD_INPUT        the mesh is no net (the message says where), the reference has no triangle
 *                        with an area, or a name does not exist
 *   LAM_IO               the map cannot be written
 *   LAM_MISSING_PROGRAM  a map as .png needs rsvg-convert, which is not installed
 *   LAM_FAILED           rsvg-convert, or the library behind .glb, failed
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_measure_net(lam_session *session, const lam_measure_task *task,
                                   lam_measured *measured);

LAM_END_DECLS

#endif
