/* Measures of the fairness of a curve, by integration between its breaks. Called by
 * curve_fairing.c for its reports, and by the kernel's users. */
#include "curve/curve_fairness.h"
#include "core/numeric/fit.h"
#include "core/numeric/quadrature.h"
#include "curve/frenet.h"

enum { RULE = 8 };

/* Curvature k = |c| / v^3 with c = x' x x'', v = |x'|, and its change by arc length (dk/dt) / v:
 *   dk/dt = c.c' / (|c| v^3) - 3 |c| x'.x'' / v^5  with c' = x' x x''',
 * where c.c' / |c| is replaced by |c'| at an inflection (c = 0). */
static void curvature_of(const lam_vec3 x[4], double *curvature, double *change, double *speed) {
  lam_vec3 c = lam_cross(x[1], x[2]), dc = lam_cross(x[1], x[3]);
  double v = lam_length(x[1]), size = lam_length(c), cube = v * v * v;
  double grows = size > 0 ? lam_dot(c, dc) / size : lam_length(dc);
  *curvature = size / cube;
  *change = (grows / cube - 3 * size * lam_dot(x[1], x[2]) / (cube * v * v)) / v;
  *speed = v;
}

/* Adds the integrals over [a, b], where the curve is smooth. */
static void add_part(const lam_curve *curve, double a, double b, lam_fairness *f) {
  double nodes[RULE], weights[RULE];
  lam_gauss_rule(RULE, nodes, weights);

  for (int i = 0; i < RULE; i++) {
    lam_vec3 x[4];
    double k, change, speed;
    curve->eval(curve->data, a + (b - a) * nodes[i], 3, x);
    curvature_of(x, &k, &change, &speed);

    double ds = weights[i] * (b - a) * speed;
    f->bending += k * k * ds;
    f->curvature_change += change * change * ds;
    f->curvature_variation += fabs(change) * ds;
  }
}

/* The curvature vector at t, 1/m. */
static lam_vec3 curvature_vector_at(const lam_curve *curve, double t) {
  lam_vec3 x[3];
  curve->eval(curve->data, t, 2, x);
  return lam_curvature_vector(x[1], x[2]);
}

/* Sign changes of the turn (x' x x'') . n / |x'|^3, with n the normal of the plane of best fit,
 * at the middles of `samples` intervals per part; what is below 1e-9 of the largest turn has no
 * sign. */
static int count_inflections(lam_arena *arena, const lam_curve *curve, const double *breakpoints,
                             int samples) {
  int parts = curve->break_count + 1, count = parts * samples, changes = 0;
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count), *turns = LAM_NEW(arena, lam_vec3, count),
           center;
  double most = 0, before = 0, spread[3];

  for (int i = 0; i < count; i++) {
    int part = i / samples;
    double s = (i % samples + 0.5) / samples;
    lam_vec3 x[3];
    double low = breakpoints[part], high = breakpoints[part + 1];
    curve->eval(curve->data, low + s * (high - low), 2, x);
    points[i] = x[0];
    turns[i] = lam_scale(lam_cross(x[1], x[2]), 1 / pow(lam_length(x[1]), 3));
  }

  lam_vec3 normal = lam_fit_plane(points, count, &center, spread);
  for (int i = 0; i < count; i++) most = fmax(most, fabs(lam_dot(turns[i], normal)));

  for (int i = 0; i < count; i++) {
    double turn = lam_dot(turns[i], normal);
    if (fabs(turn) <= 1e-9 * most) continue;
    changes += turn * before < 0;
    before = turn;
  }

  return changes;
}

/* Integrals over the parts, and at each break inside the jump of the curvature vector, its left
 * limit being taken one number below the break. */
lam_fairness lam_curve_fairness(lam_arena *arena, const lam_curve *curve, int samples) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  const double *breakpoints = lam_curve_breakpoints(arena, curve);
  lam_fairness f = {.inflections = count_inflections(arena, curve, breakpoints, samples)};

  for (int part = 0; part <= curve->break_count; part++) {
    double low = breakpoints[part], step = (breakpoints[part + 1] - low) / samples;
    for (int i = 0; i < samples; i++) add_part(curve, low + i * step, low + (i + 1) * step, &f);

    if (part == 0) continue;
    lam_vec3 after = curvature_vector_at(curve, low),
             before = curvature_vector_at(curve, nextafter(low, -INFINITY));
    f.curvature_jump = fmax(f.curvature_jump, lam_distance(after, before));
    f.curvature_variation += fabs(lam_length(after) - lam_length(before));
  }

  lam_arena_release(arena, mark);
  return f;
}
