/* Corner data that were left out: sides from the tangents, curvatures from the least bending
 * energy of the boundary (thesis, eq. 2.5). Called by asymptotic_quad.c. Slopes tilt the tangent
 * planes of the surface, and the boundary alone says little about them: with slopes left out,
 * everything is chosen for the least thin-plate energy of the bi-7 surface (thesis, eq. 2.8). */
#include "core/numeric/minimize.h"
#include "surf/asymptotic/quad_parts.h"

/* The side to which curve i bends as the cubic with the same ends: the sum of its second
 * derivatives there, r''(0) = 6 d - 4 r'(0) - 2 r'(1) and r''(1) = -6 d + 2 r'(0) + 4 r'(1), d
 * the chord, measured along the other curves into the patch. 0: the tangents are along the
 * chord, the curve is straight. */
static int natural_side(const lam_quad_corners *q, int i) {
  const lam_vec3 *t = q->tangent[i];
  lam_vec3 d = lam_sub(q->corner[lam_quad_corner_of[i][1]], q->corner[lam_quad_corner_of[i][0]]);
  double length = lam_length(d), into = 0;
  if (lam_length(lam_cross(t[0], d)) <= 1e-6 * lam_length(t[0]) * length &&
      lam_length(lam_cross(t[1], d)) <= 1e-6 * lam_length(t[1]) * length)
    return 0;

  for (int e = 0; e < 2; e++) {
    lam_quad_end o = lam_quad_other[i][e];
    lam_vec3 other = lam_scale(q->tangent[o.curve][o.end], o.end ? -1 : 1), edge = lam_unit(t[e]);
    lam_vec3 across = lam_unit(lam_along(other, -lam_dot(other, edge), edge));
    lam_vec3 bend = lam_along(lam_scale(d, e ? -6 : 6), e ? 2 : -4, t[0]);
    into += lam_dot(across, lam_along(bend, e ? 4 : -2, t[1]));
  }
  return into < 0 ? -1 : 1;
}

/* What is searched for, and where it is written to. */
typedef struct lam_completion {
  lam_arena *arena;
  lam_quad_corners *corners;
  lam_quad_form form;
  bool slopes, curvatures;
} lam_completion;

/* The distance of the ends of curve i. */
static double chord_of(const lam_quad_corners *q, int i) {
  return lam_distance(q->corner[lam_quad_corner_of[i][1]], q->corner[lam_quad_corner_of[i][0]]);
}

/* Writes the variables x into the corner data: the slope of every tangent against the horizontal
 * (if slopes are searched for), then log(curvature times chord). */
static void set_corners(const lam_completion *c, const double *x) {
  lam_quad_corners *q = c->corners;
  for (int k = 0; k < 8; k++) {
    int i = k / 2, e = k % 2;
    if (c->slopes) q->tangent[i][e].z = x[k] * hypot(q->tangent[i][e].x, q->tangent[i][e].y);
    if (c->curvatures) q->curvature[i][e] = exp(x[k + (c->slopes ? 8 : 0)]) / chord_of(q, i);
  }
}

/* The energy at x: of the bi-7 surface with slopes, otherwise of the boundary; INFINITY where
 * there is none. Curvatures are limited: neither straight nor a hook. */
static double energy_at(void *data, const double *x) {
  const lam_completion *c = data;
  for (int k = c->slopes ? 8 : 0; c->curvatures && k < (c->slopes ? 16 : 8); k++)
    if (!(fabs(x[k]) < 5)) return INFINITY;

  lam_arena_mark mark = lam_arena_mark_get(c->arena);
  lam_errors errors = {.arena = c->arena};
  lam_asymptotic_patch patch;
  double energy = INFINITY;

  set_corners(c, x);
  if (c->slopes && lam_asymptotic_patch_make(c->arena, c->corners, LAM_QUAD_BI7, (lam_location){0},
                                             &errors, &patch))
    energy = patch.energy;
  if (!c->slopes && lam_quad_boundary_make(c->arena, c->corners, c->form, (lam_location){0},
                                           &errors, &patch.boundary))
    energy = patch.boundary.energy;

  lam_arena_release(c->arena, mark);
  return energy;
}

/* Sets the eight slopes x to those of the chords, and the tangents with them. */
static void start_slopes(lam_quad_corners *corners, double *x) {
  for (int k = 0; k < 8; k++) {
    lam_vec3 d = lam_sub(corners->corner[lam_quad_corner_of[k / 2][1]],
                         corners->corner[lam_quad_corner_of[k / 2][0]]);
    x[k] = d.z / fmax(hypot(d.x, d.y), 1e-9 * lam_length(d));
    corners->tangent[k / 2][k % 2].z =
        x[k] * hypot(corners->tangent[k / 2][k % 2].x, corners->tangent[k / 2][k % 2].y);
  }
}

/* Sets x[first] to x[count - 1], all curvatures alike, to the best of seven starts from nearly
 * straight to strongly curved, and leaves the other variables. Returns the energy there. */
static double best_start(lam_completion *c, int first, int count, double *x) {
  double least = INFINITY, best = 0;
  for (int start = 0; start < 7; start++) {
    for (int k = first; k < count; k++) x[k] = -2.0 + 0.5 * start;
    double energy = energy_at(c, x);
    if (energy < least) {
      least = energy;
      best = -2.0 + 0.5 * start;
    }
    if (!c->curvatures) break;
  }
  for (int k = first; k < count; k++) x[k] = best;
  return least;
}

/* Sides first, then a search over slopes and curvatures. */
bool lam_quad_corners_complete(lam_arena *arena, lam_quad_corners *corners, lam_quad_form form,
                               lam_quad_missing missing, lam_location location,
                               lam_errors *errors) {
  /* A rational boundary is itself the result of a search: the quintic one stands for it. */
  lam_completion c = {arena, corners, form == LAM_QUAD_BI13 ? LAM_QUAD_BI7 : form, missing.slopes,
                      missing.curvatures};
  double x[LAM_MINIMIZE_MAX] = {0};
  bool curves = form != LAM_QUAD_BI6 && form != LAM_QUAD_BI8; /* those have no given curvatures */
  c.curvatures = c.curvatures && curves;
  if (c.slopes) start_slopes(corners, x);
  for (int i = 0; missing.sides && i < 4; i++)
    corners->side[i][0] = corners->side[i][1] = natural_side(corners, i);
  if (!c.slopes && !c.curvatures) return true;

  int count = 8 * (c.slopes + c.curvatures), first = 8 * c.slopes;
  if (!isfinite(best_start(&c, first, count, x))) { /* say what is wrong with the data */
    lam_quad_boundary boundary;
    int before = errors->count;
    lam_quad_boundary_make(arena, corners, c.form, location, errors, &boundary);
    if (errors->count == before)
      lam_error_add(errors, location, "tangents",
                    "no curvatures complete these tangents; expected other tangents");
    return false;
  }

  lam_minimize(count, energy_at, &c, 100, x);
  set_corners(&c, x);
  return true;
}
