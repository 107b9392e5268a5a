/* What a surface over an asymptotic boundary promises, measured from the surface alone. Called
 * by asymptotic_quad.c for the report, by the benchmark and, for the energy, by rational_patch.c
 * and fab/parts/skin_measure.c. */
#include "core/numeric/quadrature.h"
#include "surf/asymptotic/asymptotic_quad.h"
#include "surf/spline/spline_surface.h"

/* Of the parameter line through a point with the derivatives d and dd: |k_n| and |r' x r''| /
 * |r'|^3, and the sine between its binormal and the normal of the surface. */
static void measure_line(lam_vec3 d, lam_vec3 dd, lam_vec3 normal, double *normal_curvature,
                         double *curvature, double *sine) {
  lam_vec3 bend = lam_cross(d, dd);
  *normal_curvature = fabs(lam_dot(normal, dd)) / lam_dot(d, d);
  *curvature = lam_length(bend) / pow(lam_length(d), 3);
  *sine = lam_length(lam_cross(normal, lam_unit(bend)));
}

/* Moves t off the knots of direction d, where the second derivatives jump. */
static double off_knots(const lam_spline_surface *s, int d, double t) {
  for (int k = s->degree[d] + 1; k < s->count[d]; k++)
    if (fabs(t - s->knots[d][k]) < 1e-9) return t + 1e-6;
  return t;
}

/* At evenly spaced parameters without the ends. */
void lam_asymptotic_residuals(lam_arena *arena, const lam_spline_surface *surface,
                              const bool straight[4], int samples, double *ratio, double *sine) {
  const lam_nurbs *nurbs = lam_nurbs_make(arena, surface);
  *ratio = *sine = 0;
  for (int i = 0; i < 4; i++)
    for (int k = 1; k <= samples; k++) {
      double t = off_knots(surface, i % 2, (double)k / (samples + 1)), kn, curvature, angle;
      lam_jet jet;
      lam_nurbs_eval(nurbs, i % 2 ? i / 2 : t, i % 2 ? t : i / 2, &jet);
      lam_vec3 normal = lam_unit(lam_cross(jet.u, jet.v));

      measure_line(i % 2 ? jet.v : jet.u, i % 2 ? jet.vv : jet.uu, normal, &kn, &curvature, &angle);
      if (straight[i]) { /* no curvature to compare with: the speed is the length of the chord */
        *ratio = fmax(*ratio, kn * lam_length(i % 2 ? jet.v : jet.u));
        continue;
      }
      *ratio = fmax(*ratio, kn / curvature);
      *sine = fmax(*sine, angle);
    }
}

/* Spans that are empty are left out. */
double lam_thin_plate_energy(lam_arena *arena, const lam_spline_surface *surface, int count) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  const lam_nurbs *nurbs = lam_nurbs_make(arena, surface);
  double *nodes = LAM_NEW(arena, double, count), *weights = LAM_NEW(arena, double, count), sum = 0;
  lam_gauss_rule(count, nodes, weights);

  for (int a = surface->degree[0]; a < surface->count[0]; a++)
    for (int b = surface->degree[1]; b < surface->count[1]; b++) {
      double u = surface->knots[0][a], v = surface->knots[1][b];
      double du = surface->knots[0][a + 1] - u, dv = surface->knots[1][b + 1] - v;
      for (int g = 0; du * dv > 0 && g < count * count; g++) {
        lam_jet jet;
        lam_nurbs_eval(nurbs, u + du * nodes[g / count], v + dv * nodes[g % count], &jet);
        sum += du * dv * weights[g / count] * weights[g % count] *
               (lam_dot(jet.uu, jet.uu) + 2 * lam_dot(jet.uv, jet.uv) + lam_dot(jet.vv, jet.vv));
      }
    }

  lam_arena_release(arena, mark);
  return sum;
}
