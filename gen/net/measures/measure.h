/* Independent measures of a net, from positions alone: never the residuals that were minimized.
 * Like measures share a file measure_*.c; the list is in measure.c. */
#ifndef LAM_NET_MEASURES_MEASURE_H
#define LAM_NET_MEASURES_MEASURE_H

#include "core/solid/solid.h"
#include "mesh/net.h"
#include "surf/surface.h"

#include <math.h>

typedef struct lam_measuring {
  lam_arena *arena; /* of scratch and results */
  const lam_net *net;
  const lam_vec3 *positions; /* meters */
  double mean_edge;
  double target_angle;               /* for angle_deviation; radians */
  const lam_tree *reference;         /* a mesh to compare with; NULL: none */
  const lam_trimesh *reference_mesh; /* of the tree */
  const double *axis; /* point and direction of a surface of revolution (6 numbers); NULL: none */
  const lam_vec3 *start; /* positions that strains are measured against; NULL: none */
  const lam_surface
      *surface; /* that the vertices lie on, at these parameters; NULL: none, or not known */
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
  const char *name, *unit, *doc;
  lam_measure_on on;
  /* Writes the values of the elements (all LAM_UNDEFINED before). Scratch comes from in->arena. */
  void (*run)(const lam_measuring *in, double *values);
} lam_measure_kind;

extern const lam_measure_kind *const lam_measures[];
extern const int lam_measure_count;
const lam_measure_kind *lam_measure_find(const char *name); /* or NULL */

/* Number of values: vertices, edges, faces or 1. */
int lam_measure_size(const lam_measure_kind *kind, const lam_net *net);
/* One value per element, in in->arena. */
double *lam_measure_values(const lam_measure_kind *kind, const lam_measuring *in);
/* Smallest, largest, mean and number of the defined values; all but the number are NaN when there
 * is none. A value that is not a number makes them all NaN. */
lam_measure lam_measure_summary(const lam_measure_kind *kind, const double *values, int count);

/* What measures need, with a right angle as the target and no reference. */
lam_measuring lam_measuring_of(lam_arena *arena, const lam_net *net, const lam_vec3 *positions);
/* Runs the named measures (NULL-terminated; NULL: all but the slow ones, see net/layout.h) and
 * returns their summaries; count is the number. */
lam_measure *lam_net_measure(const lam_measuring *in, const char *const *names, int *count);
/* The summary of one measure. */
lam_measure lam_net_measure_one(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                                const char *name);

/* Names the degenerate state of a solved net, or NULL: "not a number: ...", "shrunk: ...", "flown
 * apart: ...", "collapsed: ...", "flattened: ...", "folded: ...". before and after are positions;
 * the states are judged against the start, so that a plane that was a plane is none. */
const char *lam_net_degenerate(lam_arena *arena, const lam_net *net, const lam_vec3 *before,
                               const lam_vec3 *after);

#endif
