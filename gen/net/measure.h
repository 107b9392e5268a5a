/* Independent measures of a net, from positions alone: never the residuals that were minimized. One list. */
#ifndef LAM_NET_MEASURE_H
#define LAM_NET_MEASURE_H

#include "net/net.h"

typedef struct lam_measuring {
  const lam_net *net;
  const lam_vec3 *positions;
  double mean_edge;
  double target_angle; /* for angle_deviation; radians */
} lam_measuring;

typedef struct lam_measure_kind {
  const char *name, *unit, *doc;
  /* Fills max, mean and count. */
  void (*run)(const lam_measuring *in, lam_measure *out);
} lam_measure_kind;

extern const lam_measure_kind lam_measures[];
extern const int lam_measure_count;

/* Runs the named measures (NULL-terminated; NULL: all) and returns them; count is the number. */
lam_measure *lam_net_measure(lam_arena *arena, const lam_net *net, const lam_vec3 *positions, double target_angle,
                             const char *const *names, int *count);
/* The value of one measure. */
lam_measure lam_net_measure_one(const lam_net *net, const lam_vec3 *positions, const char *name);

/* Names the degenerate state of a solved net, or NULL: "not a number: ...", "shrunk: ...", "flown apart: ...",
 * "collapsed: ...", "flattened: ...", "folded: ...". before and after are positions; the states are judged against the
 * start, so that a plane that was a plane is none. */
const char *lam_net_degenerate(const lam_net *net, const lam_vec3 *before, const lam_vec3 *after);

#endif
