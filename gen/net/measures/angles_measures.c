/* Crossing angles of the families and turning angles of the polylines at regular vertices, in
 * degrees. Rows of the list in net/measures/measure.c, which calls them. */
#include "core/numbers.h"
#include "net/measures/measuring.h"

#include <math.h>

/* |crossing angle - target_angle|. */
static void angle_deviation(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] =
        fabs(lam_star_crossing_angle(in, &in->net->stars[s]) - in->target_angle) *
        LAM_DEGREES_PER_RADIAN;
}

static void crossing_angle(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] =
        lam_star_crossing_angle(in, &in->net->stars[s]) * LAM_DEGREES_PER_RADIAN;
}

/* Angle between the edge of a family that arrives at a star and the one that leaves
 * it, in degrees. */
static double turn(const lam_measuring *in, const lam_star *star, int family) {
  lam_vec3 c = in->positions[star->center];
  return lam_angle(lam_sub(in->positions[star->neighbor[family]], c),
                   lam_sub(c, in->positions[star->neighbor[family + 2]])) *
         LAM_DEGREES_PER_RADIAN;
}

/* The larger turn of both families; not a number where one of them is not. */
static void turning_angle(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    double u = turn(in, star, 0), v = turn(in, star, 1);
    values[star->center] = v > u || isnan(v) ? v : u;
  }
}

static void turning_angle_u(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] = turn(in, &in->net->stars[s], 0);
}

static void turning_angle_v(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] = turn(in, &in->net->stars[s], 1);
}

const lam_measure_kind lam_measure_angle_deviation = {
    "angle_deviation", "deg",
    "crossing angle of the families at regular vertices, against the angle aimed at (90 degrees by "
    "default)",
    LAM_ON_VERTICES, angle_deviation};
const lam_measure_kind lam_measure_crossing_angle = {
    "crossing_angle", "deg", "crossing angle of the families at regular vertices", LAM_ON_VERTICES,
    crossing_angle};
const lam_measure_kind lam_measure_turning_angle = {
    "turning_angle", "deg",
    "angle by which a polyline turns at a regular vertex, the larger one of both families",
    LAM_ON_VERTICES, turning_angle};
const lam_measure_kind lam_measure_turning_angle_u = {
    "turning_angle_u", "deg", "angle by which polylines of family 0 turn at regular vertices",
    LAM_ON_VERTICES, turning_angle_u};
const lam_measure_kind lam_measure_turning_angle_v = {
    "turning_angle_v", "deg", "angle by which polylines of family 1 turn at regular vertices",
    LAM_ON_VERTICES, turning_angle_v};
