/* Damped Newton for least area: (A'' + lambda M) d = -A', M the Hessian of I/2
 * (area_variation.c). Called by area_solve.c.
 *
 * Moving the points within the surface costs nothing, so A'' alone is close to singular; lambda
 * has a floor. Where it stops, a direction in which A'' is negative tells a saddle point, which
 * is left. */
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* The least lambda, by the higher of the two degrees. */
static double floor_of(const lam_area_form *form) {
  int p = form->rule[0].degree, q = form->rule[1].degree, degree = p > q ? p : q;
  return degree < 5 ? 1e-6 : degree < 7 ? 1e-3 : 1e-2;
}

/* A direction goes down when A'' < -saddle M there; smaller values are noise of the almost free
 * movements. */
static const double saddle = 1e-3;

/* A step goes down like a line when it gains more than this part of what its slope promises; a
 * parabola gives 1/2. */
static const double line_part = 0.7;

/* Damping that hardly shortens steps. */
static const double weak = 1e-3;

enum { recent = 8 }; /* steps whose fall is remembered */

typedef struct newton {
  const lam_area_form *form;
  const lam_area_system *system;
  int count;                 /* inner points */
  lam_vec3 *points, *trial;  /* whole nets: where the surface is, and where a step would take it */
  lam_vec3 *step, *gradient; /* inner points; the gradient is that of points */
  double value, scale;       /* what is minimized, at points; the area at the start */
  double lambda, floor;      /* damping, and its least value */
  double fall;               /* of the value in the last step */
  double falls[recent];      /* in the last steps, in a ring */
  double promise;            /* of the least damped step tried last: how much the value falls */
  bool stuck;                /* no step of any length goes down */
  bool known;                /* the second variation is that of points */
  double factored;           /* the damping that the system is factorized with; NAN: none */
  bool short_step;           /* the last step was, by a damping that can still be lowered */
  int evaluations;
} newton;

/* Takes over value and gradient of the points, which were computed last. */
static void keep(newton *n, double value) {
  n->value = value;
  n->known = false;
  memcpy(n->gradient, n->form->gradient, (size_t)n->count * sizeof *n->gradient);
}

/* Computes value and gradient of the points. */
static void look(newton *n) {
  keep(n, lam_area_slope(n->form, n->points));
  n->evaluations++;
}

/* Factorizes A'' + lambda M at the points, unless it is done already; false: not positive
 * definite. */
static bool factor(newton *n, double lambda) {
  if (n->known && n->factored == lambda) return true;
  if (!n->known) lam_area_blocks(n->form, n->points);
  n->known = true;
  bool definite = lam_area_system_factor(n->system, n->form, lambda);
  n->factored = definite ? lambda : NAN;
  return definite;
}

/* Takes t times the step. value: that after it. seen: the form's gradient is that after it. */
static void accept(newton *n, double t, double value, bool seen) {
  lam_area_move(n->form, n->points, t, n->step, n->points);
  n->fall = n->value - value;
  if (seen)
    keep(n, value);
  else
    look(n);
}

/* How many times the step to take when the area falls along it like a line, as it does for
 * movements within the surface, which are almost free: doubled once or twice while it goes on
 * falling. value: in, after one step; out, after as many as are returned. */
static double lengthen(newton *n, double *value) {
  double t = 1;
  for (; t < 4; t *= 2) {
    lam_area_move(n->form, n->points, 2 * t, n->step, n->trial);
    double next = lam_area_value(n->form, n->trial);
    n->evaluations++;
    if (!(next < *value)) break;
    *value = next;
  }
  return t;
}

/* One step downhill, the damping raised until the area falls enough; false: no step of any
 * length goes down. */
static bool descend(lam_arena *arena, newton *n) {
  bool raised = false, first = true;
  n->stuck = false;
  for (; n->lambda < 1e8; n->lambda *= 4, raised = true) {
    if (!factor(n, n->lambda)) continue;
    lam_area_system_step(arena, n->system, n->gradient, n->step);

    double slope = lam_area_product(n->count, n->gradient, n->step);
    if (first) n->promise = -slope / 2;
    first = false;
    lam_area_move(n->form, n->points, 1, n->step, n->trial);
    double value = lam_area_slope(n->form, n->trial);
    n->evaluations++;

    if (-slope < 1e-15 * n->scale) { /* nothing left to gain */
      n->fall = 0;
      n->short_step = false;
      if (value < n->value) accept(n, 1, value, true);
      return true;
    }
    if (!(value < n->value + 1e-4 * slope)) continue;

    /* A full Newton step promises half of -slope. */
    n->short_step = !raised && n->lambda > fmax(weak, n->floor);
    double fall = n->value - value;
    if (fall > -0.25 * slope) n->lambda = fmax(n->floor, n->lambda / 10);
    bool line = fall > -line_part * slope;
    double t = line ? lengthen(n, &value) : 1;
    accept(n, t, value, !line);
    return true;
  }
  n->stuck = true;
  if (first) n->promise = INFINITY;
  return false;
}

/* The first damping, from what a strongly damped step promises: the less of the area, the nearer
 * the minimum. */
static void begin(lam_arena *arena, newton *n) {
  look(n);
  n->lambda = 1;
  if (!factor(n, n->lambda)) return;

  lam_area_system_step(arena, n->system, n->gradient, n->step);
  double promise = -lam_area_product(n->count, n->gradient, n->step) / n->scale;
  n->lambda = fmax(n->floor, fmin(1, 5 * sqrt(promise)));
}

/* Whether the second variation has a direction that goes down at a stationary surface: then the
 * points move a little along their normals, without any symmetry. The normal of a point is that
 * of its four neighbors in the net. */
static bool leave_saddle(newton *n) {
  const lam_area_form *form = n->form;
  if (factor(n, saddle)) return false;

  double size = 0.02 * sqrt(n->scale);
  const lam_vec3 *net = n->points;
  int columns = form->surface.count[1];
  for (int k = 0; k < n->count; k++) {
    int at = lam_area_index(form, k);
    lam_vec3 normal = lam_unit(lam_cross(lam_sub(net[at + columns], net[at - columns]),
                                         lam_sub(net[at + 1], net[at - 1])));
    n->step[k] = lam_scale(normal, size * (1 + 0.7 * sin(1.3 * k + 0.4) + 0.5 * cos(2.9 * k)));
  }

  lam_area_move(form, n->points, 1, n->step, n->points);
  n->lambda = 1;
  look(n);
  return true;
}

/* A stationary surface, to come back to. */
typedef struct stationary {
  lam_vec3 *points; /* the whole net */
  double value;     /* infinite: none yet */
} stationary;

/* Whether a stationary surface is a minimum. If not, the surface leaves it, and the descent goes
 * on; where that leads to no less area, what seemed to go down was noise, and the surface before it
 * is the minimum. */
static bool is_minimum(newton *n, double tolerance, stationary *before,
                       lam_least_area_result *result) {
  size_t bytes = (size_t)(n->form->surface.count[0] * n->form->surface.count[1]) * sizeof(lam_vec3);
  bool less = n->value < before->value - tolerance * n->scale;
  if (!less) result->saddles--;
  if (!less && n->value > before->value) {
    memcpy(n->points, before->points, bytes);
    return true;
  }

  memcpy(before->points, n->points, bytes);
  before->value = n->value;
  return !less || !leave_saddle(n);
}

/* Goes down until the area falls no more, past up to four saddle points. */
void lam_area_newton(lam_arena *arena, const lam_area_form *form,
                     const lam_least_area_options *options, lam_vec3 *points,
                     lam_least_area_result *result) {
  int all = form->surface.count[0] * form->surface.count[1],
      total = form->inner[0] * form->inner[1];
  lam_area_system system = lam_area_system_make(arena, form, 3);
  newton n = {.form = form,
              .system = &system,
              .count = total,
              .points = points,
              .trial = LAM_NEW(arena, lam_vec3, all),
              .step = LAM_NEW(arena, lam_vec3, total),
              .gradient = LAM_NEW(arena, lam_vec3, total),
              .floor = floor_of(form),
              .scale = result->area};
  for (int k = 0; k < recent; k++) n.falls[k] = INFINITY;

  stationary before = {LAM_NEW(arena, lam_vec3, all), INFINITY};

  begin(arena, &n);
  for (; result->iterations < options->most; result->iterations++) {
    if (!descend(arena, &n)) {
      /* To rounding, there is nothing to gain any more: that is stationary, too. */
      n.fall = n.promise;
      n.short_step = false;
      result->reason = "no step goes down any more";
    }

    n.falls[result->iterations % recent] = n.fall;

    /* A small fall says nothing while the damping shortens the steps. */
    result->converged = options->enough > 0
                            ? n.value <= options->enough
                            : n.fall <= options->tolerance * n.scale && !n.short_step;
    if (!result->converged && n.stuck) break;
    if (!result->converged) continue;
    result->iterations++;
    result->reason = lam_area_converged(options);

    /* Stationary is not enough. */
    if (options->enough > 0 || options->accept_saddles ||
        is_minimum(&n, options->tolerance, &before, result))
      break;
    result->converged = false;
    result->reason = "as many steps as allowed";
    if (++result->saddles > 4) {
      result->reason = "stationary, but no minimum";
      break;
    }
  }
  result->fall = 0;
  for (int k = 0; k < recent; k++) result->fall += n.falls[k];
  result->evaluations += n.evaluations;
}
