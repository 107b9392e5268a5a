#include "net/measure.h"

#include <math.h>

static const double degrees = 180 / 3.14159265358979323846;

static double star_angle(const lam_measuring *in, const lam_star *star) {
  lam_vec3 e[4];
  for (int k = 0; k < 4; k++) e[k] = lam_unit(lam_sub(in->positions[star->neighbor[k]], in->positions[star->center]));
  return lam_angle(lam_sub(e[0], e[2]), lam_sub(e[1], e[3]));
}

static void angle_deviation(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] = fabs(star_angle(in, &in->net->stars[s]) - in->target_angle) * degrees;
}

static void crossing_angle(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++)
    values[in->net->stars[s].center] = star_angle(in, &in->net->stars[s]) * degrees;
}

/* Angle between the edge that arrives at a star and the one that leaves it, the larger one of the two families. */
static void turning_angle(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    lam_vec3 c = in->positions[star->center];
    double turn[2];
    for (int k = 0; k < 2; k++)
      turn[k] =
          lam_angle(lam_sub(in->positions[star->neighbor[k]], c), lam_sub(c, in->positions[star->neighbor[k + 2]]));
    values[star->center] = (turn[1] > turn[0] || isnan(turn[1]) ? turn[1] : turn[0]) * degrees;
  }
}

const lam_measure_kind lam_measure_angle_deviation = {
    "angle_deviation", "deg",
    "crossing angle of the families at regular vertices, against the angle aimed at (90 degrees by default)",
    LAM_ON_VERTICES, angle_deviation};
const lam_measure_kind lam_measure_crossing_angle = {
    "crossing_angle", "deg", "crossing angle of the families at regular vertices", LAM_ON_VERTICES, crossing_angle};
const lam_measure_kind lam_measure_turning_angle = {
    "turning_angle", "deg", "angle by which a polyline turns at a regular vertex, the larger one of both families",
    LAM_ON_VERTICES, turning_angle};
