/* Independent measures of a net, from positions alone: never the residuals that were minimized.
 * Like measures share a file *_measures.c; the list is in measure.c. Used by net/optimize.c,
 * design, cli, fab/parts/gauss_image.c and bench. */
#ifndef LAM_NET_MEASURES_MEASURE_H
#define LAM_NET_MEASURES_MEASURE_H

#include "core/solid/solid.h"
#include "mesh/net.h"
#include "surf/surface.h"

#include <math.h>

/* What a net is measured by and against; made by lam_measuring_of. Everything is read only. */
typedef struct lam_measuring {
  lam_arena *arena; /* of scratch and results */
  const lam_net *net;
  const lam_vec3 *positions; /* meters */
  double mean_edge;          /* meters */
  double target_angle;       /* for angle_deviation and circle_angle_deviation; radians */

  const lam_tree *reference;         /* a mesh to compare with; NULL: none */
  const lam_trimesh *reference_mesh; /* of the tree */
  const double *axis; /* point and direction of a surface of revolution (6 numbers); NULL: none */
  double coverage;    /* of the surface by traced lines, 0 to 1; 0: none were traced */
  const lam_vec3 *start; /* positions that strains are measured against; NULL: none */

  /* The surface that the vertices lie on, at these parameters; NULL: none, or not known. */
  const lam_surface *surface;
  const lam_vec2 *parameters;
  double surface_scale; /* by which the surface was enlarged */
} lam_measuring;

/* What a measure has one value on. */
typedef enum lam_measure_on {
  LAM_ON_VERTICES,
  LAM_ON_EDGES,
  LAM_ON_FACES,
  LAM_ON_NET
} lam_measure_on;

/* The value of elements on which a measure is not defined: not counted, not drawn. */
#define LAM_UNDEFINED (-INFINITY)

typedef struct lam_measure_kind {
  const char *name, *unit, *doc; /* unit: "" when there is none */
  lam_measure_on on;
  /* Writes the values of the elements (all LAM_UNDEFINED before). Scratch comes from in->arena. */
  void (*run)(const lam_measuring *in, double *values);
} lam_measure_kind;

extern const lam_measure_kind *const lam_measures[]; /* lam_measure_count of them */
extern const int lam_measure_count;
extern const lam_measure_kind lam_measure_coverage; /* one of them: design/net_stage.c adds it */
/* The measure called name, or NULL. */
const lam_measure_kind *lam_measure_find(const char *name);

/* Number of values: vertices, edges, faces or 1. */
int lam_measure_size(const lam_measure_kind *kind, const lam_net *net);
/* One value per element, lam_measure_size of them, in in->arena. */
double *lam_measure_values(const lam_measure_kind *kind, const lam_measuring *in);
/* Smallest, largest, mean and number of the defined values; all but the number are NaN when there
 * is none. A value that is not a number makes them all NaN. */
lam_measure lam_measure_summary(const lam_measure_kind *kind, const double *values, int count);

/* What measures need, with a right angle as the target and no reference, axis, start or surface.
 * net and positions (vertex_count, meters) are kept by pointer. */
lam_measuring lam_measuring_of(lam_arena *arena, const lam_net *net, const lam_vec3 *positions);
/* Runs the named measures (NULL-terminated; NULL: all but the slow ones, see layout.h) and returns
 * their summaries in in->arena; count: out, their number. Precondition: all names are known. */
lam_measure *lam_net_measure(const lam_measuring *in, const char *const *names, int *count);
/* The summary of one measure with the defaults of lam_measuring_of. Precondition: the name is
 * known. arena: of scratch, released at the end. */
lam_measure lam_net_measure_one(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                                const char *name);

/* Names the degenerate state of a solved net, or NULL: "not a number: ...", "shrunk: ...", "flown
 * apart: ...", "collapsed: ...", "flattened: ...", "folded: ...", "lies on itself: ...". before and
 * after are positions (vertex_count, of any one unit). Collapsed and flattened are judged against
 * the start, so that a plane that was a plane is none; folds and overlaps are failures whatever the
 * start had. The text is static or in arena. */
const char *lam_net_degenerate(lam_arena *arena, const lam_net *net, const lam_vec3 *before,
                               const lam_vec3 *after);

#endif
