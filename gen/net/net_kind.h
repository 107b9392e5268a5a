/* Kinds of nets: one per file of net/kinds; the list is net/kinds/nets.c. A kind says which
 * parameterization it starts from, which constraints it is made of, how it is solved, and which
 * independent measures prove it. Read by design, net/optimize.c, cli, bench and library. */
#ifndef LAM_NET_NET_KIND_H
#define LAM_NET_NET_KIND_H

#include "con/constraint.h"
#include "net/measures/measure.h"
#include "solve/guided.h"
#include "surf/surface.h"

/* What leads the net while the fairness fades: weights are relative to it, and all of it is gone
 * in the result. */
typedef struct lam_guide {
  lam_fair fair;    /* what fairness is put on */
  double closeness; /* of every vertex to its position at the start */
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
  double file_closeness; /* at least so much closeness where the start is a file; 0: no matter */

  /* Adds the hard constraints. params: the struct of head.keys, or NULL when it has none. On
   * wrong input adds to scope->errors. */
  void (*constrain)(lam_scope *scope, const void *params, lam_location location);
  const char *const *measures; /* NULL-terminated names (net/measures/measure.h) */
  /* The one of them that shows whether the net is of this kind: where it is undefined everywhere,
   * nothing was solved. NULL: every net is of this kind. */
  const char *proof;
  /* The crossing angle that is aimed at, radians; NAN: none with these params. NULL: never one. */
  double (*target_angle)(const void *params);

  /* The same constraints in the form of thesis 3.7, with auxiliary unknowns and equations that
   * are at most quadratic; NULL: the thesis gives none. */
  void (*constrain_thesis)(lam_scope *scope, const void *params, lam_location location);
  /* Makes the mesh that the net starts from, of grid cells, where it is not sampled from a
   * surface; NULL: it is. A mesh from a file comes first. Owned by arena; meters. On wrong input
   * adds to errors and returns false. */
  bool (*start)(lam_arena *arena, const void *params, const int grid[2], lam_location location,
                lam_errors *errors, lam_mesh *mesh);
} lam_net_kind;

extern const lam_registry lam_nets; /* of lam_net_kind */

/* Whether the kind has a form for the method that the keys ask for (net/kinds/nets.c); otherwise a
 * message that names the nets that do. */
struct lam_net_common;
bool lam_net_method_check(const lam_net_kind *kind, const struct lam_net_common *common,
                          lam_location location, lam_errors *errors);

/* ---- keys that every net accepts: filled from the tables of net/net_keys.c ---- */

typedef enum lam_boundary {
  LAM_BOUNDARY_FREE,
  LAM_BOUNDARY_FIXED,
  LAM_BOUNDARY_GLIDE
} lam_boundary;

/* What the net starts from: a mesh file, the net of another design, or the surface of this one. */
typedef struct lam_net_source {
  int stage;          /* 0: the surface */
  const char *file;   /* NULL: none */
  int unit;           /* of the file: an index into lam_file_units */
  double size;        /* largest extent that the mesh is scaled to, meters; 0: as it is */
  double weld;        /* vertices closer than this are joined, meters; meaningful when given */
  bool weld_given;
  const char *design; /* NULL: none */
  int lines;          /* 0: those that the net's kind asks for; else the chart + 1 */
  bool trace;         /* traced even where the surface has the chart in closed form */
  double at[2];       /* u, v of the surface; meaningful when given */
  bool at_given;
  double spacing; /* meters before `size`; 0: as far as the lines reach */
  int base;       /* geodesic parallels: 0: of a line u = const, 1: of a line v = const */
} lam_net_source;

typedef struct lam_handle {
  int vertex[2]; /* {index, -1} */
  double to[3];  /* meters */
  int steps;
  bool release; /* lets go at the end */
  /* As the design gives it (net/handles.h); with nothing of this, vertex and to are meant. */
  lam_list index, goal; /* of int; of double, meters */
  double at[3], by[3];  /* meters */
  bool at_given, by_given, side_given;
  int side, degree; /* lam_side; of the B-spline of a side */
} lam_handle;

typedef struct lam_reference_keys {
  const char *file; /* NULL: none */
  int unit;         /* of the file: an index into lam_file_units */
  double weight;    /* of the distance against the constraints; meaningful when given */
  bool weight_given;
} lam_reference_keys;

/* The units that a mesh file can be read in, after "auto" (that of its format), which is 0 meters;
 * ends with a NULL name. In the order of the choices of `unit`. */
typedef struct lam_file_unit {
  const char *name;
  double meters;
} lam_file_unit;
extern const lam_file_unit lam_file_units[];

typedef enum lam_method { LAM_METHOD_LAMELLA, LAM_METHOD_THESIS } lam_method;

/* Without their `_given` the kind's own defaults hold. */
typedef struct lam_solver_keys {
  int method;     /* lam_method */
  double epsilon; /* damping of LAM_METHOD_THESIS */
  double fairness, closeness, stiffness, tolerance;
  bool fairness_given, closeness_given, stiffness_given, tolerance_given, fair_given;
  int fair; /* lam_fair */
  int iterations;
  bool smooth; /* one smoothing step before the solver */
} lam_solver_keys;

typedef struct lam_net_common {
  lam_net_source from;
  int grid[2];      /* cells along family 0 and 1 */
  int hole;         /* rings of cells left out around a flat point */
  bool diagonalize; /* these three change the start, in this order */
  int coarsen;
  int subdivide;
  int levels; /* coarser nets that are solved first */
  bool levels_given;
  int boundary;         /* lam_boundary */
  lam_list handles;     /* of lam_handle */
  lam_list constraints; /* of lam_row of lam_constraints */
  lam_list measures;    /* of const char *: for the report, beside the kind's own */
  lam_reference_keys reference;
  bool reference_given;
  lam_solver_keys solver;
  int animate;  /* frames kept on the way to the solution, at most; 0: none */
  double noise; /* random displacement of the start, relative to the mean edge */
  int seed;     /* of the noise */
} lam_net_common;

extern const lam_key lam_net_common_keys[]; /* of lam_net_common */

#endif
