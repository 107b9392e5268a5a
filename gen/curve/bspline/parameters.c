/* Parameters for interpolation, one function per kind. Called by curve/interpolate.c,
 * mesh/line_curve.c and surf/spline/spline_through.c; the names are the values of a key of
 * surf/kinds/interpolation.c. */
#include "curve/bspline/parameters.h"
#include <stddef.h>

const char *const lam_parameters_names[] = {[LAM_PARAMETERS_UNIFORM] = "uniform",
                                            [LAM_PARAMETERS_CHORD] = "chord",
                                            [LAM_PARAMETERS_CENTRIPETAL] = "centripetal",
                                            [LAM_PARAMETERS_MODIFIED_CHORD] = "modified-chord",
                                            [LAM_PARAMETERS_COUNT] = NULL};

/* The length of the parameter interval from point i to point i + 1, up to a common factor. */
typedef double step_length(int count, const lam_vec3 *p, int i);

/* One function per kind, in the order of lam_parameters. */
static double uniform(int count, const lam_vec3 *p, int i) {
  (void)count, (void)p, (void)i;
  return 1;
}

static double chord(int count, const lam_vec3 *p, int i) {
  (void)count;
  return lam_distance(p[i], p[i + 1]);
}

static double centripetal(int count, const lam_vec3 *p, int i) { return sqrt(chord(count, p, i)); }

/* d_i (1 + 3/2 theta_i d_i-1 / (d_i-1 + d_i) + 3/2 theta_i+1 d_i+1 / (d_i + d_i+1)), with theta_i
 * the turn at point i, at most a right angle, and 0 at the ends. */
static double modified_chord(int count, const lam_vec3 *p, int i) {
  double d = chord(count, p, i), factor = 1;

  for (int side = 0; side < 2; side++) {
    int joint = i + side, other = side ? i + 1 : i - 1;
    if (joint == 0 || joint == count - 1) continue;

    double turn = lam_angle(lam_sub(p[joint], p[joint - 1]), lam_sub(p[joint + 1], p[joint]));
    double next = chord(count, p, other);
    if (next > 0) factor += 1.5 * fmin(turn, M_PI_2) * next / (next + d);
  }

  return d * factor;
}

static step_length *const steps[] = {uniform, chord, centripetal, modified_chord};

/* Steps are summed first and divided by the sum last, so that t[0] is 0 and t[count - 1] is 1
 * exactly. Where all points are equal, even steps. */
void lam_parameters_choose(lam_parameters kind, int count, const lam_vec3 *points, double *t) {
  t[0] = 0;
  for (int i = 0; i + 1 < count; i++) t[i + 1] = t[i] + steps[kind](count, points, i);
  double total = t[count - 1];
  for (int i = 1; i < count; i++) t[i] = total > 0 ? t[i] / total : (double)i / (count - 1);
}
