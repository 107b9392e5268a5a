/* The surface nearest to another one, whatever the parameters of the two (Wu & Wang, step 6, asks for a small
 * distance).
 *
 * Sought are the inner points P of x = sum P_a R_a(u, v) for which integral r^2 du dv is least, with
 *   r = n.(x - y),  y the foot point of x on the target and n its normal there.
 * As y is the nearest point, dr = n.dx: moving y within the target changes nothing in first order (tangent distance;
 * Pottmann, Leopoldseder & Hofer, Approximation with active B-spline curves and surfaces, 2002). Gauss-Newton:
 *   gradient_a = integral r R_a n,   block_ab = integral R_a R_b n n^T + lambda R_a R_b.
 * Beyond its border the target goes on along its tangent planes, so borders that do not quite agree do no harm. */
#include "surf/least_area_paper.h"
#include "surf/least_area_parts.h"
#include "surf/spline_surface.h"
#include <math.h>
#include <string.h>

enum { along = 24, steps = 60, foot_steps = 30 }; /* along: quadrature places along a direction, at least */

typedef struct nearest {
  lam_area_form *form;
  const lam_nurbs *target;
  double low[2], high[2]; /* the target's domain */
} nearest;

/* Moves (u, v) in the target's domain towards the point nearest to x, by projected Gauss-Newton steps that are halved
 * until they come nearer. Returns what the target is there. */
static lam_jet find_foot(const nearest *n, lam_vec3 x, double at[2]) {
  lam_jet jet;
  lam_nurbs_eval(n->target, at[0], at[1], &jet);
  for (int k = 0; k < foot_steps; k++) {
    lam_vec3 d = lam_sub(x, jet.x);
    double E = lam_dot(jet.u, jet.u), F = lam_dot(jet.u, jet.v), G = lam_dot(jet.v, jet.v), now = lam_dot(d, d);
    double a[2] = {lam_dot(jet.u, d), lam_dot(jet.v, d)}, step[2] = {0, 0};
    bool held[2];
    for (int i = 0; i < 2; i++) held[i] = (at[i] <= n->low[i] && a[i] <= 0) || (at[i] >= n->high[i] && a[i] >= 0);
    double determinant = E * G - F * F;
    if (held[0] && held[1]) break;
    if (held[0]) {
      step[1] = a[1] / G;
    } else if (held[1]) {
      step[0] = a[0] / E;
    } else {
      step[0] = (G * a[0] - F * a[1]) / determinant;
      step[1] = (E * a[1] - F * a[0]) / determinant;
    }
    double t = 1, fall = 0;
    for (; t > 1e-3; t /= 2) {
      double to[2];
      lam_jet next;
      for (int i = 0; i < 2; i++) to[i] = fmin(fmax(at[i] + t * step[i], n->low[i]), n->high[i]);
      lam_nurbs_eval(n->target, to[0], to[1], &next);
      fall = now - lam_dot(lam_sub(x, next.x), lam_sub(x, next.x));
      if (!(fall > 0)) continue;
      memcpy(at, to, sizeof to);
      jet = next;
      break;
    }
    if (!(fall > 1e-12 * now)) break;
  }
  return jet;
}

/* What a place adds to the gradient and the blocks. */
static void add_place(const lam_area_form *form, int s, int t, const lam_area_place *place, lam_vec3 n, double r) {
  double nn[6] = {n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z};
  for (int a = 0; a < form->local; a++) {
    int point = lam_area_inner(form, s, t, a);
    if (point < 0) continue;
    double wa = place->weight * place->r[a];
    form->gradient[point] = lam_along(form->gradient[point], wa * r, n);
    for (int b = a; b < form->local; b++) {
      if (lam_area_inner(form, s, t, b) < 0) continue;
      double *block = form->blocks + ((size_t)point * form->window + lam_area_slot(form, a, b)) * LAM_AREA_TERMS;
      block[0] += wa * place->r[b];
      for (int c = 0; c < 6; c++) block[1 + c] += wa * place->r[b] * nn[c];
    }
  }
}

/* integral r^2, with its gradient / 2 and blocks; feet: u, v of every place, moved along. */
static double compare(const nearest *n, const lam_vec3 *points, double (*feet)[2]) {
  const lam_area_form *form = n->form;
  int total = form->inner[0] * form->inner[1];
  lam_area_place place;
  double sum = 0;
  memset(form->gradient, 0, (size_t)total * sizeof *form->gradient);
  memset(form->blocks, 0, (size_t)total * form->window * LAM_AREA_TERMS * sizeof *form->blocks);
  for (int s = 0; s < form->rule[0].spans; s++)
    for (int t = 0; t < form->rule[1].spans; t++)
      for (int k = 0; k < form->rule[0].places; k++)
        for (int l = 0; l < form->rule[1].places; l++) {
          lam_area_visit(form, points, s, t, k, l, &place);
          lam_jet y = find_foot(n, place.x, *feet++);
          lam_vec3 normal = lam_unit(lam_cross(y.u, y.v));
          double r = lam_dot(normal, lam_sub(place.x, y.x));
          sum += place.weight * r * r;
          add_place(form, s, t, &place, normal, r);
        }
  return sum;
}

/* The parameters of the places, as first feet. */
static double (*first_feet(lam_arena *arena, const lam_area_form *form, const nearest *n))[2] {
  int places = form->rule[0].places, count = 0, of[2];
  double(*feet)[2] =
      lam_arena_alloc(arena, (size_t)(form->rule[0].spans * form->rule[1].spans * places * places), sizeof *feet);
  for (int s = 0; s < form->rule[0].spans; s++)
    for (int t = 0; t < form->rule[1].spans; t++)
      for (of[0] = 0; of[0] < places; of[0]++)
        for (of[1] = 0; of[1] < places; of[1]++, count++)
          for (int d = 0; d < 2; d++) {
            const double *at = form->rule[d].at + (d ? t : s) * places;
            feet[count][d] = fmin(fmax(at[of[d]], n->low[d]), n->high[d]);
          }
  return feet;
}

lam_spline_surface lam_spline_surface_nearest(lam_arena *arena, const lam_spline_surface *start,
                                              const lam_spline_surface *target) {
  int all = start->count[0] * start->count[1];
  size_t size = (size_t)all * sizeof(lam_vec3);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  lam_spline_surface result = *start;
  result.points = memcpy(points, start->points, size);
  lam_arena_mark mark = lam_arena_mark_get(arena);
  nearest n = {.form = lam_area_form_make(arena, start, 0, lam_area_places(start, along)),
               .target = lam_nurbs_make(arena, target)};
  for (int d = 0; d < 2; d++) {
    n.low[d] = target->knots[d][target->degree[d]];
    n.high[d] = target->knots[d][target->count[d]];
  }
  lam_area_system system = lam_area_system_make(arena, n.form, 3);
  lam_vec3 *trial = LAM_NEW(arena, lam_vec3, all), *step = LAM_NEW(arena, lam_vec3, system.size / 3);
  double(*feet)[2] = first_feet(arena, n.form, &n);
  double now = compare(&n, points, feet), lambda = 1e-3;
  for (int k = 0; k < steps && lambda < 1e8; k++) {
    if (!lam_area_system_factor(&system, n.form, lambda)) {
      lambda *= 10;
      continue;
    }
    lam_area_system_step(arena, &system, n.form->gradient, step);
    lam_area_move(n.form, points, 1, step, trial);
    double next = compare(&n, trial, feet);
    if (!(next < now)) {
      lambda *= 10;
      compare(&n, points, feet);
      continue;
    }
    memcpy(points, trial, size);
    lambda = fmax(lambda / 10, 1e-6);
    bool still = now - next <= 1e-6 * now;
    now = next;
    if (still) break;
  }
  lam_arena_release(arena, mark);
  return result;
}
