/* Corner data of an asymptotic quadrilateral: how the curves meet, what forms need, and what no
 * surface can have. The tables are used all over this folder; make_quad.c calls the check before
 * anything is computed. */
#include "core/numbers.h"
#include "surf/asymptotic/quad_parts.h"

const char *const lam_quad_form_names[] = {
    [LAM_QUAD_BI7] = "bi-7", [LAM_QUAD_BI11] = "bi-11",   [LAM_QUAD_BI6] = "bi-6",
    [LAM_QUAD_BI8] = "bi-8", [LAM_QUAD_BI13] = "bi-13",   [LAM_QUAD_B_SPLINE] = "b-spline",
    [LAM_QUAD_C1] = "c1",    [LAM_QUAD_FORM_COUNT] = NULL};

const lam_quad_recipe lam_quad_recipes[LAM_QUAD_FORM_COUNT] = {
    [LAM_QUAD_BI7] = {.degree = 5, .surface = 7, .free = true},
    [LAM_QUAD_BI11] = {.degree = 5, .surface = 11},
    [LAM_QUAD_BI6] = {.degree = 4, .surface = 6, .free = true},
    [LAM_QUAD_BI8] = {.degree = 4, .surface = 8},
    [LAM_QUAD_BI13] = {.degree = 4, .surface = 13},
    [LAM_QUAD_B_SPLINE] = {.degree = 3, .inner = 2, .surface = 5, .multiplicity = 5},
    [LAM_QUAD_C1] = {.degree = 4, .inner = 2, .surface = 5, .multiplicity = 4, .free = true}};

const lam_quad_end lam_quad_other[4][2] = {
    {{1, 0}, {3, 0}}, {{0, 0}, {2, 0}}, {{1, 1}, {3, 1}}, {{0, 1}, {2, 1}}};
const int lam_quad_corner_of[4][2] = {{0, 1}, {0, 2}, {2, 3}, {1, 3}};
const lam_quad_end lam_quad_meeting[4][2] = {
    {{0, 0}, {1, 0}}, {{0, 1}, {3, 0}}, {{2, 0}, {1, 1}}, {{2, 1}, {3, 1}}};

static const char *const corner_names[] = {"(0,0)", "(1,0)", "(0,1)", "(1,1)"}; /* in messages */

/* Corners must be apart, tangents of some length and not parallel where two meet; adds messages. */
static void check_corners(const lam_quad_corners *q, lam_location location, lam_errors *errors) {
  int before = errors->count;
  double size = 0;
  for (int c = 1; c < 4; c++) size = fmax(size, lam_distance(q->corner[0], q->corner[c]));

  for (int a = 0; a < 4; a++)
    for (int b = a + 1; b < 4; b++)
      if (!(lam_distance(q->corner[a], q->corner[b]) > 1e-9 * size))
        lam_error_add(errors, location, "corners",
                      "the corners %s and %s coincide; expected four different points",
                      corner_names[a], corner_names[b]);

  for (int i = 0; i < 4; i++)
    for (int e = 0; e < 2; e++)
      if (!(lam_length(q->tangent[i][e]) > 1e-9 * size))
        lam_error_add(errors, location, "tangents",
                      "the tangent of r%d at %s has no length; expected a derivative", i + 1,
                      corner_names[lam_quad_corner_of[i][e]]);

  for (int c = 0; errors->count == before && c < 4; c++) {
    lam_quad_end p = lam_quad_meeting[c][0], r = lam_quad_meeting[c][1];
    lam_vec3 a = lam_unit(q->tangent[p.curve][p.end]), b = lam_unit(q->tangent[r.curve][r.end]);
    if (!(lam_length(lam_cross(a, b)) > 1e-6))
      lam_error_add(errors, location, "tangents",
                    "the tangents of r%d and r%d at %s are parallel; expected two directions that "
                    "span the tangent plane of the surface",
                    p.curve + 1, r.curve + 1, corner_names[c]);
  }
}

/* Curve i, declared straight, at its end e: the tangent must be along the chord, and the form must
 * allow it; adds messages. */
static void check_straight_end(const lam_quad_corners *q, lam_quad_form form, int i, int e,
                               lam_vec3 chord, lam_location location, lam_errors *errors) {
  lam_vec3 t = q->tangent[i][e];
  if (!(lam_length(lam_cross(t, chord)) <= 1e-6 * lam_length(t) * lam_length(chord) &&
        lam_dot(t, chord) > 0))
    lam_error_add(errors, location, "tangents",
                  "r%d is declared straight, but its tangent at %s is %.3g deg off the "
                  "chord; expected the chord",
                  i + 1, corner_names[lam_quad_corner_of[i][e]],
                  lam_angle(t, chord) * 180 / LAM_PI);

  if (form != LAM_QUAD_BI7 && form != LAM_QUAD_BI11)
    lam_error_add(errors, location, "form",
                  "r%d is straight, which %s does not allow; expected bi-7 or bi-11", i + 1,
                  lam_quad_form_names[form]);
}

/* An asymptotic curve without inflection bends to one side; a straight one lies on its chord. Adds
 * messages. */
static void check_sides(const lam_quad_corners *q, lam_quad_form form, lam_location location,
                        lam_errors *errors) {
  bool curvature_given = form != LAM_QUAD_BI6 && form != LAM_QUAD_BI8;
  for (int i = 0; i < 4; i++) {
    const int *side = q->side[i];
    lam_vec3 chord =
        lam_sub(q->corner[lam_quad_corner_of[i][1]], q->corner[lam_quad_corner_of[i][0]]);
    if (side[0] != side[1]) {
      lam_error_add(errors, location, "sides",
                    "r%d bends to side %+d at its start and %+d at its end; expected one side: a "
                    "curve that changes it has an inflection, and the surface would fold there",
                    i + 1, side[0], side[1]);
      continue;
    }

    for (int e = 0; e < 2; e++) {
      if (side[0] == 0) {
        check_straight_end(q, form, i, e, chord, location, errors);
      } else if (curvature_given && !(q->curvature[i][e] > 1e-9 / lam_length(chord))) {
        lam_error_add(errors, location, "curvatures",
                      "the curvature of r%d at %s is %g, an inflection; expected a positive value, "
                      "or side 0 for a straight curve",
                      i + 1, corner_names[lam_quad_corner_of[i][e]], q->curvature[i][e]);
      }
    }
  }
}

/* Inner knots must ascend between 0 and 1 with some distance; adds messages. */
static void check_knots(const lam_quad_corners *q, lam_location location, lam_errors *errors) {
  for (int d = 0; d < 2; d++) {
    double a = q->knots[d][0], b = q->knots[d][1];
    if (!(a > 1e-6 && b - a > 1e-6 && b < 1 - 1e-6))
      lam_error_add(errors, location, "knots",
                    "inner knots %g and %g of %s; expected two numbers that ascend between 0 and 1",
                    a, b, d ? "r2 and r4" : "r1 and r3");
  }
}

/* Sides only make sense where corners are sound, knots where sides are. */
bool lam_quad_corners_check(const lam_quad_corners *corners, lam_quad_form form,
                            lam_location location, lam_errors *errors) {
  int before = errors->count;
  check_corners(corners, location, errors);
  if (errors->count == before) check_sides(corners, form, location, errors);
  if (errors->count == before && lam_quad_recipes[form].inner)
    check_knots(corners, location, errors);

  for (int c = 0; form == LAM_QUAD_BI13 && c < 4; c++)
    if (!(corners->weight[c] > 0))
      lam_error_add(errors, location, "weights",
                    "the weight of corner %s is %g; expected a positive number", corner_names[c],
                    corners->weight[c]);
  return errors->count == before;
}
