/* Kinds of nets: one per file; the list is net/registry.c. A kind says which parameterization it
 * starts from, which constraints it is made of, how it is solved, and which independent measures
 * prove it. */
#ifndef LAM_NET_NET_KIND_H
#define LAM_NET_NET_KIND_H

#include "con/constraint.h"
#include "net/measures/measure.h"
#include "solve/guided.h"
#include "surf/surface.h"

/* What leads the net while the fairness fades: weights are relative to it, and all of it is gone in
 * the result. */
typedef struct lam_guide {
  lam_fair fair;    /* what fairness is put on */
  double closeness; /* of every vertex to its place at the start */
  double stiffness; /* of every edge to its length at the start */
} lam_guide;

typedef struct lam_net_kind {
  lam_row_head head;
  const char *use;       /* what it is for in building */
  const char *trouble;   /* what can go wrong, and what to do then */
  lam_chart chart;       /* the parameterization that it starts from */
  int levels;            /* default of the key `levels`: coarse nets that are solved first */
  lam_schedule schedule; /* default */
  lam_guide guide;       /* default */
  void (*constrain)(lam_scope *scope, const void *params,
                    lam_location location);   /* adds the hard constraints */
  const char *const *measures;                /* NULL-terminated names (net/measure.h) */
  double (*target_angle)(const void *params); /* NULL: no crossing angle is aimed at */
  /* The same constraints in the form of thesis 3.7, with auxiliary unknowns and equations that are
   * at most quadratic; NULL: the thesis gives none. */
  void (*constrain_thesis)(lam_scope *scope, const void *params, lam_location location);
  /* Makes the mesh that the net starts from, of grid cells, where it is not sampled from a surface;
   * NULL: it is. A mesh from a file comes first. On wrong input adds to errors and returns false.
   */
  bool (*start)(lam_arena *arena, const void *params, const int grid[2], lam_location location,
                lam_errors *errors, lam_mesh *mesh);
} lam_net_kind;

extern const lam_registry lam_nets;

/* ---- keys that every net accepts ---- */
typedef enum lam_boundary {
  LAM_BOUNDARY_FREE,
  LAM_BOUNDARY_FIXED,
  LAM_BOUNDARY_GLIDE
} lam_boundary;

typedef struct lam_net_source {
  int stage; /* 0: the surface */
  const char *file;
  const char *design;
  int lines;  /* 0: those that the net's kind asks for; else the chart + 1 */
  bool trace; /* traced even where the surface has the chart in closed form */
  double at[2];
  bool at_given;
  double spacing; /* meters before `size`; 0: as far as the lines reach */
  int base;       /* geodesic parallels: 0: of a line u = const, 1: of a line v = const */
} lam_net_source;

typedef struct lam_handle {
  int vertex[2]; /* {index, -1} */
  double to[3];  /* meters */
  int steps;
  bool release;
  /* As the design gives it (net/handles.h); with nothing of this, vertex and to are meant. */
  lam_list index, goal; /* of int; of double */
  double at[3], by[3];
  bool at_given, by_given, side_given;
  int side, degree;
} lam_handle;

typedef struct lam_reference_keys {
  const char *file;
  double weight;
} lam_reference_keys;

typedef enum lam_method { LAM_METHOD_LAMELLA, LAM_METHOD_THESIS } lam_method;

typedef struct lam_solver_keys {
  int method; /* lam_method */
  double epsilon;
  double fairness, closeness, stiffness, tolerance;
  bool fairness_given, closeness_given, stiffness_given, tolerance_given, fair_given;
  int fair; /* lam_fair */
  int iterations;
  bool smooth;
} lam_solver_keys;

typedef struct lam_net_common {
  lam_net_source from;
  int grid[2];
  int hole;
  bool diagonalize;
  int coarsen;
  int subdivide;
  int levels;
  bool levels_given;
  int boundary;         /* lam_boundary */
  lam_list handles;     /* of lam_handle */
  lam_list constraints; /* of lam_row of lam_constraints */
  lam_list measures;    /* of const char *: for the report, beside the kind's own */
  lam_reference_keys reference;
  bool reference_given;
  lam_solver_keys solver;
  int animate;
  double noise;
  int seed;
} lam_net_common;

extern const lam_key lam_net_common_keys[];

#endif
