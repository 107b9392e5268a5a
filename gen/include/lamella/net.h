/* Nets from arrays: solving and measuring without a design file. */
#ifndef LAMELLA_NET_H
#define LAMELLA_NET_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

/* A net to be solved. */
typedef struct lam_net_task {
  const char *net; /* what stands after `net:` in a design: "{kind: asymptotic, orthogonal: yes}";
                      `from` is not given, `reference` needs no file */
  lam_mesh start;  /* quads, copied; vertices in meters */
  const lam_trimesh *reference; /* the surface that the key `reference` speaks of; NULL: none */
} lam_net_task;

/* What came of it. */
typedef struct lam_net_solution {
  bool converged;     /* proven by the measures of the kind, and not degenerate */
  const char *reason; /* why it stopped, in words */
  int iterations;
  double residual; /* largest, in mean edges or radians */
  lam_mesh mesh;   /* the same faces; vertices in meters */
  int polyline_count;
  const lam_polyline *polylines; /* of both families */
  int measure_count;
  const lam_measure *measures; /* computed from positions alone */
} lam_net_solution;

/* Moves the vertices until the constraints of the net's kind hold (guided projection, thesis 3.7).
 * Not converging is a result: LAM_OK, and solution->converged is false. LAM_BAD_INPUT: the keys or
 * the mesh are wrong. LAM_NO_MEMORY. */
LAM_API lam_status lam_net_solve(lam_session *session, const lam_net_task *task,
                                 lam_net_solution *solution);

/* What is measured. Zeroed, with a mesh, it is every measure but the slow ones, angles against 90
 * degrees. */
typedef struct lam_measure_task {
  const lam_mesh *mesh;         /* quads, vertices in meters */
  const char *name;             /* of the mesh, for messages and maps; NULL: none */
  const char *as;               /* only the measures that prove this kind of net; NULL: all */
  double angle;                 /* crossing angle of angle_deviation, radians; 0: a right angle */
  const lam_trimesh *reference; /* mesh that distances are measured to; NULL: none */
  const double *axis;   /* point (meters) and direction of the axis of a surface of revolution: 6
                                   numbers; NULL: none */
  const char *map;      /* a measure to be drawn as a color map; NULL: none */
  const char *map_path; /* its file: .svg, .png or .glb */
} lam_measure_task;

typedef struct lam_measured {
  int boundary_loops, irregular_vertices;
  int measure_count;
  const lam_measure *measures;
} lam_measured;

/* Whether the names of the task exist; the mesh may be NULL. LAM_BAD_INPUT. */
LAM_API lam_status lam_measure_task_check(lam_session *session, const lam_measure_task *task);
/* Measures the mesh as a net. LAM_BAD_INPUT: it is none (the message says where), or a name does not
 * exist. LAM_MISSING_PROGRAM, LAM_IO, LAM_FAILED: the map. LAM_NO_MEMORY. */
LAM_API lam_status lam_measure_net(lam_session *session, const lam_measure_task *task,
                                   lam_measured *measured);

LAM_END_DECLS

#endif
