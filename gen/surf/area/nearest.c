/* The surface nearest to another one, whatever the parameters of the two (Wu & Wang, step 6,
 * asks for a small distance). Called by area_paper.c.
 *
 * Sought are the inner points P of x = sum P_a R_a(u, v) for which integral r^2 du dv is least,
 * with r = n.(x - y), y the foot point of x on the target and n its normal there. As y is the
 * nearest point, dr = n.dx: moving y within the target changes nothing in first order (tangent
 * distance; Pottmann, Leopoldseder & Hofer, Approximation with active B-spline curves and
 * surfaces, 2002). Gauss-Newton:
 *
 *   gradient_a = integral r R_a n,   block_ab = integral R_a R_b n n^T + lambda R_a R_b
 *
 * Beyond its border the target goes on along its tangent planes, so borders that do not quite
 * agree do no harm. */
#include "surf/area/area_paper.h"
#include "surf/area/area_parts.h"
#include "surf/spline/closest_on_surface.h"
#include "surf/spline/spline_surface.h"
#include <math.h>
#include <string.h>

/* Nodes of the quadrature along a direction, at least; steps, at most. */
enum { along = 24, steps = 60 };

typedef struct nearest {
  lam_area_form *form;
  const lam_spline_surface *target;
  const lam_nurbs *nurbs; /* the target */
} nearest;

/* Adds a node of span (s, t) to the gradient and the blocks. n: the target's normal, r: the
 * distance along it. */
static void add_node(const lam_area_form *form, int s, int t, const lam_area_node *node, lam_vec3 n,
                     double r) {
  double nn[6] = {n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z};
  for (int a = 0; a < form->local; a++) {
    int point = lam_area_inner(form, s, t, a);
    if (point < 0) continue;
    double wa = node->weight * node->r[a];
    form->gradient[point] = lam_along(form->gradient[point], wa * r, n);

    for (int b = a; b < form->local; b++) {
      if (lam_area_inner(form, s, t, b) < 0) continue;
      double *block = form->blocks +
                      ((size_t)point * form->window + lam_area_slot(form, a, b)) * LAM_AREA_TERMS;
      block[0] += wa * node->r[b];
      for (int c = 0; c < 6; c++) block[1 + c] += wa * node->r[b] * nn[c];
    }
  }
}

/* Returns integral r^2 and sets half its gradient and its blocks in the form. feet: u, v of the
 * foot of every node; in: where the search starts, out: where it ended. */
static double compare(const nearest *n, const lam_vec3 *points, lam_vec2 *feet) {
  const lam_area_form *form = n->form;
  int total = form->inner[0] * form->inner[1];
  lam_area_node node;
  double sum = 0;
  memset(form->gradient, 0, (size_t)total * sizeof *form->gradient);
  memset(form->blocks, 0, (size_t)total * form->window * LAM_AREA_TERMS * sizeof *form->blocks);

  for (int s = 0; s < form->rule[0].spans; s++)
    for (int t = 0; t < form->rule[1].spans; t++)
      for (int k = 0; k < form->rule[0].nodes; k++)
        for (int l = 0; l < form->rule[1].nodes; l++) {
          lam_area_node_eval(form, form->rule, points, s, t, k, l, &node);
          lam_closest_on_surface foot = lam_spline_surface_closest_from(n->target, node.x, *feet);
          lam_jet y;
          *feet++ = (lam_vec2){foot.u, foot.v};
          lam_nurbs_eval(n->nurbs, foot.u, foot.v, &y);

          lam_vec3 normal = lam_unit(lam_cross(y.u, y.v));
          double r = lam_dot(normal, lam_sub(node.x, y.x));
          sum += node.weight * r * r;
          add_node(form, s, t, &node, normal, r);
        }
  return sum;
}

/* The parameters of the nodes, where the search for their feet starts. */
static lam_vec2 *first_feet(lam_arena *arena, const lam_area_form *form) {
  const lam_area_rule *u = &form->rule[0], *v = &form->rule[1];
  int count = 0;
  lam_vec2 *feet = LAM_NEW(arena, lam_vec2, u->spans * v->spans * u->nodes * v->nodes);

  for (int s = 0; s < u->spans; s++)
    for (int t = 0; t < v->spans; t++)
      for (int k = 0; k < u->nodes; k++)
        for (int l = 0; l < v->nodes; l++)
          feet[count++] = (lam_vec2){u->at[s * u->nodes + k], v->at[t * v->nodes + l]};
  return feet;
}

/* Levenberg-Marquardt on the inner points until the mean square hardly falls. */
lam_spline_surface lam_spline_surface_nearest(lam_arena *arena, const lam_spline_surface *start,
                                              const lam_spline_surface *target) {
  int all = start->count[0] * start->count[1];
  size_t size = (size_t)all * sizeof(lam_vec3);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  lam_spline_surface result = *start;
  result.points = memcpy(points, start->points, size);

  lam_arena_mark mark = lam_arena_mark_get(arena);
  nearest n = {.form = lam_area_form_make(arena, start, 0, lam_area_node_count(start, along)),
               .target = target,
               .nurbs = lam_nurbs_make(arena, target)};
  lam_area_system system = lam_area_system_make(arena, n.form, 3);
  lam_vec3 *trial = LAM_NEW(arena, lam_vec3, all),
           *step = LAM_NEW(arena, lam_vec3, system.size / 3);
  lam_vec2 *feet = first_feet(arena, n.form);

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
      compare(&n, points, feet); /* gradient and blocks were those of the trial */
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
