/* Reads four boundary curves as a design gives them, in numbers or in a file, and says what is
 * wrong with them. Called by surf/kinds/coons.c, surf/area/least_area.c and
 * surf/developable/developable.c. */
#include "surf/spline/sides_keys.h"
#include "curve/bspline/basis.h"
#include "curve/curve.h"

enum { MAX_POINTS = 1000 };

/* Whether all numbers of a list are the same. */
static bool all_equal(const lam_list *list) {
  const double *x = list->items;
  for (int i = 1; i < list->count; i++)
    if (x[i] != x[0]) return false;
  return true;
}

/* One curve of the list; what it lacks is a message at curves[index].*. */
typedef struct reader {
  lam_arena *arena;
  const lam_side_keys *keys;
  lam_sides_limits limits;
  int index, count, degree, unit;
  lam_location location;
  lam_errors *errors;
} reader;

/* The key of a message about the reader's curve. */
static const char *key_of(const reader *r, const char *name) {
  return lam_arena_printf(r->arena, "curves[%d].%s", r->index, name);
}

/* Weights: none or one per point, positive; all the same where the surface is polynomial. */
static void check_weights(const reader *r) {
  const lam_list *weights = &r->keys->weights;
  if (!weights->count) return;

  const char *key = key_of(r, "weights");
  if (weights->count != r->count)
    lam_error_add(r->errors, r->location, key,
                  "%d weights given; expected %d: one per point, or none", weights->count,
                  r->count);
  else if (lam_weights_check(weights, key, r->location, r->errors) && r->limits.no_weights &&
           !all_equal(weights))
    lam_error_add(r->errors, r->location, key,
                  "different weights given; expected none: this surface is polynomial");
}

/* Knots: none, or as many as points and degree ask for, and sound. */
static void check_knots(const reader *r) {
  const lam_list *knots = &r->keys->knots;
  const char *problem =
      knots->count ? lam_knots_problem(r->degree, r->count, knots->count, knots->items) : NULL;
  if (problem)
    lam_error_add(r->errors, r->location, key_of(r, "knots"),
                  "%d knots given with degree %d: they %s", knots->count, r->degree, problem);
}

/* Vectors across the side: none, or one per point. */
static void check_across(const reader *r) {
  int given = r->keys->across.count;
  if (given && given != 3 * r->count)
    lam_error_add(
        r->errors, r->location, key_of(r, "across"),
        "%d numbers given; expected %d: x, y and z of one vector for each of the %d points", given,
        3 * r->count, r->count);
}

/* Whether the numbers of one curve fit together; all of what is wrong is told at once. */
static bool check(const reader *r) {
  int given = r->keys->points.count, before = r->errors->count;
  int most = r->count - 1 < r->limits.degree ? r->count - 1 : r->limits.degree;

  if (given % 3 || r->count < 2 || r->count > MAX_POINTS)
    lam_error_add(r->errors, r->location, key_of(r, "points"),
                  "%d numbers given; expected x, y and z of 2 to %d points", given, MAX_POINTS);
  else if (r->degree > most)
    lam_error_add(r->errors, r->location, key_of(r, "degree"),
                  "degree %d with %d points; expected at most %d", r->degree, r->count, most);

  if (r->errors->count > before) return false;
  check_weights(r);
  check_knots(r);
  check_across(r);
  return r->errors->count == before;
}

/* A curve that has passed the check. Knots that are not given are evenly spaced. */
static void read_curve(const reader *r, lam_spline_curve *side, lam_bspline *across) {
  const lam_side_keys *keys = r->keys;
  double *even = LAM_NEW(r->arena, double, r->count + r->degree + 1);
  lam_knots_clamped(r->degree, r->count, even);
  *side = (lam_spline_curve){r->degree, r->count, keys->knots.count ? keys->knots.items : even,
                             lam_points_read(r->arena, &keys->points, r->unit),
                             keys->weights.count ? keys->weights.items : NULL};

  /* The vectors across are control points of a spline with the knots of the side, without
   * weights. */
  if (!keys->across.count) return;
  lam_spline_curve vectors = *side;
  vectors.points = lam_points_read(r->arena, &keys->across, r->unit);
  vectors.weights = NULL;
  *across = lam_spline_curve_net(r->arena, &vectors, false);
}

/* ---- curves of a file ---- */

/* Adds a message; false. */
static bool fail(lam_errors *errors, lam_location location, const char *key, const char *text) {
  lam_error_add(errors, location, key, "%s", text);
  return false;
}

/* Whether the file has been read and is clear about which four of its curves are meant. */
static bool has_four(const lam_sides_keys *keys, lam_location location, lam_errors *errors) {
  int count = keys->read_count;
  if (keys->curves_given)
    return fail(errors, location, "file", "given beside curves; expected one of them");

  if (!keys->read) {
    lam_error_add(errors, location, "file", "%s cannot be read: this caller loads no files",
                  keys->file);
    return false;
  }

  if (count < LAM_SIDES || (count > LAM_SIDES && !keys->pick.count)) {
    lam_error_add(errors, location, "file", "%s has %d curve%s; expected four%s", keys->file, count,
                  count == 1 ? "" : "s",
                  count > LAM_SIDES ? ", or pick: with the numbers of four" : "");
    return false;
  }

  if (keys->pick.count && keys->pick.count != LAM_SIDES) {
    lam_error_add(errors, location, "pick", "%d curves picked; expected 4", keys->pick.count);
    return false;
  }
  return true;
}

/* The indices of the four curves to take, from 0; false with a message when there are not
 * four. */
static bool pick(const lam_sides_keys *keys, lam_location location, lam_errors *errors,
                 int chosen[LAM_SIDES]) {
  const int *picked = keys->pick.items;
  int count = keys->read_count;
  if (!has_four(keys, location, errors)) return false;

  for (int i = 0; i < LAM_SIDES; i++) {
    chosen[i] = keys->pick.count ? picked[i] - 1 : i;
    if (chosen[i] >= count) {
      lam_error_add(errors, location, "pick", "curve %d asked for, but %s has %d", chosen[i] + 1,
                    keys->file, count);
      return false;
    }
    for (int k = 0; k < i; k++)
      if (chosen[k] == chosen[i]) {
        lam_error_add(errors, location, "pick",
                      "curve %d picked twice; expected four different ones", chosen[i] + 1);
        return false;
      }
  }
  return true;
}

/* Whether a curve of the file can be a side; what is wrong with it is a message at `file`. */
static bool take(const lam_named_curve *curve, lam_sides_limits limits, lam_location location,
                 lam_errors *errors) {
  const lam_spline_curve *c = &curve->spline;
  bool weighted = false;
  for (int i = 1; c->weights && i < c->count; i++) weighted |= c->weights[i] != c->weights[0];

  const char *problem =
      c->degree <= limits.degree
          ? lam_knots_problem(c->degree, c->count, c->count + c->degree + 1, c->knots)
          : NULL;

  if (c->degree > limits.degree)
    lam_error_add(errors, location, "file", "curve %s has degree %d; expected at most %d",
                  curve->name, c->degree, limits.degree);
  else if (problem)
    lam_error_add(errors, location, "file", "the knots of curve %s %s", curve->name, problem);
  else if (weighted && limits.no_weights)
    lam_error_add(errors, location, "file",
                  "curve %s is rational (an arc is, too); expected polynomial curves: this surface "
                  "is polynomial",
                  curve->name);
  else
    return true;
  return false;
}

/* ---- sides ---- */

/* The four curves as they were given, and what they are called in messages. */
typedef struct given_sides {
  lam_sides sides;
  const char *key;              /* of all */
  const char *names[LAM_SIDES]; /* of each */
} given_sides;

/* The four curves of the file; false with messages. */
static bool read_file(const lam_sides_keys *keys, lam_sides_limits limits, lam_location location,
                      lam_errors *errors, given_sides *given) {
  int chosen[LAM_SIDES], before = errors->count;
  given->key = "file";
  if (!pick(keys, location, errors, chosen)) return false;

  for (int i = 0; i < LAM_SIDES; i++) {
    const lam_named_curve *curve = &keys->read[chosen[i]];
    given->names[i] = lam_arena_printf(errors->arena, "curve %d (%s)", chosen[i] + 1, curve->name);
    if (take(curve, limits, location, errors)) given->sides.side[i] = curve->spline;
  }
  return errors->count == before;
}

/* The four curves of the list, degree 0 standing for 3 or less; false with messages. */
static bool read_numbers(lam_arena *arena, const lam_sides_keys *keys, lam_sides_limits limits,
                         lam_location location, lam_errors *errors, given_sides *given) {
  int before = errors->count;
  given->key = "curves";
  if (keys->pick.count) return fail(errors, location, "pick", "given without file; expected both");
  if (keys->curves.count != LAM_SIDES) {
    lam_error_add(errors, location, "curves", "%d curves given; expected 4", keys->curves.count);
    return false;
  }

  for (int i = 0; i < LAM_SIDES; i++) {
    const lam_side_keys *curve = (const lam_side_keys *)keys->curves.items + i;
    int count = curve->points.count / 3, degree = curve->degree ? curve->degree
                                                  : count > 3   ? 3
                                                                : count - 1;
    reader r = {arena, curve, limits, i, count, degree, keys->unit, location, errors};
    given->names[i] = lam_arena_printf(arena, "curves[%d]", i);
    if (check(&r)) read_curve(&r, &given->sides.side[i], &given->sides.across[i]);
  }
  return errors->count == before;
}

/* The message for curves that do not meet, about their worst gap, or for points that are all
 * one. */
static void explain_gap(const given_sides *given, bool of_file, const lam_sides_gap *gap,
                        lam_location location, lam_errors *errors) {
  static const char *const ends[] = {"start", "end"};
  const char *first_end = ends[gap->end[0]], *second_end = ends[gap->end[1]];
  const char *first = given->names[gap->curve[0]], *second = given->names[gap->curve[1]];

  if (gap->distance > 0 && of_file)
    lam_error_add(
        errors, location, "file",
        "the %s of %s lies %.3g m from the %s of %s; expected four curves that meet end to end",
        second_end, second, gap->distance, first_end, first);
  else if (gap->distance > 0)
    lam_error_add(errors, location, second,
                  "its %s lies %.3g m from the %s of %s; expected four curves that meet end to end",
                  second_end, gap->distance, first_end, first);
  else
    lam_error_add(errors, location, given->key, "all points are one; expected four curves");
}

/* Reads the curves of the file or of the list, then joins them. */
bool lam_sides_read(lam_arena *arena, const lam_sides_keys *keys, lam_sides_limits limits,
                    lam_location location, lam_errors *errors, lam_sides *sides) {
  given_sides given = {.key = NULL};
  bool sound = keys->file ? read_file(keys, limits, location, errors, &given)
                          : read_numbers(arena, keys, limits, location, errors, &given);
  if (!sound) return false;

  lam_sides_gap gap = {0};
  if (lam_sides_join(arena, &given.sides, sides, &gap)) return true;
  explain_gap(&given, keys->file != NULL, &gap, location, errors);
  return false;
}

/* The rows that both tables share. */
#define CURVE_ROWS                                                                                 \
  LAM_NUMBER_KEY(lam_side_keys, "points", points, NULL, 0, 0,                                      \
                 "x, y, z of every control point; two for a straight side."),                      \
      LAM_NUMBER_KEY(lam_side_keys, "weights", weights, "[]", 0, 0,                                \
                     "Positive weight of every control point; none: all 1."),                      \
      LAM_NUMBER_KEY(lam_side_keys, "knots", knots, "[]", 0, 0,                                    \
                     "Knots, number of points + degree + 1, that do not decrease; none: clamped "  \
                     "and evenly spaced."),                                                        \
      LAM_INTEGER_KEY(lam_side_keys, "degree", degree, "0", 0, LAM_BASIS_MAX_DEGREE,               \
                      "Polynomial degree; 0: 3, or less when there are fewer than four points.")

const lam_key lam_side_table[] = {CURVE_ROWS, {0}};
const lam_key lam_side_across_table[] = {
    CURVE_ROWS,
    LAM_NUMBER_KEY(
        lam_side_keys, "across", across, "[]", 0, 0,
        "Derivatives across the side, by v from v=0 to v=1 or by u from u=0 to u=1, as x, y, z of "
        "one control vector per point; none: mixed from the slopes of the sides that end there."),
    {0}};
