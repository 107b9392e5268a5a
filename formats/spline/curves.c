/* Curves that are read, for the readers of IGES, STEP, OBJ and JSON: their list, lines and arcs
 * as splines, parts of curves, and whether a curve bounds a surface. */
#include "formats/spline/curves.h"
#include "core/grow.h"
#include "core/numbers.h"

/* The list grows in the arena. */
void lam_curve_append(lam_arena *arena, lam_curve_list *list, const char *name, int family,
                      lam_spline_curve curve) {
  LAM_APPEND(arena, list->items, list->count, list->capacity,
             ((lam_named_curve){name, family, curve}));
}

/* Degree and knots are checked as those of a strip that is straight across. */
const char *lam_curve_problem(const lam_spline_curve *c) {
  static const double across[] = {0, 0, 1, 1};
  lam_spline_surface strip = {NULL, {c->degree, 1}, {c->count, 2}, {c->knots, across}, NULL, NULL};
  const char *problem = lam_spline_knots_problem(&strip, 0);
  if (problem) return problem;

  for (int i = 0; i < c->count; i++)
    if (!isfinite(lam_dot(c->points[i], c->points[i]))) return "a point too far away";
  for (int i = 0; c->weights && i < c->count; i++)
    if (!(c->weights[i] > 0)) return "a weight that is not positive";
  return NULL;
}

/* ---- lines and arcs ---- */

/* Two control points, of degree 1. */
lam_spline_curve lam_curve_line(lam_arena *arena, lam_vec3 a, lam_vec3 b) {
  static const double knots[] = {0, 0, 1, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 2);
  points[0] = a, points[1] = b;
  return (lam_spline_curve){1, 2, knots, points, NULL};
}

/* Pieces of at most a quarter turn; the middle point of a piece of angle 2h stands at 1 / cos h
 * with weight cos h (Piegl & Tiller, ch. 7.2). Knots are whole numbers, twice between pieces. */
lam_spline_curve lam_curve_arc(lam_arena *arena, lam_vec3 center, lam_vec3 x, lam_vec3 y,
                               double from, double to) {
  int pieces = (int)ceil((to - from) / (LAM_PI / 2) - 1e-9), count;
  if (pieces < 1) pieces = 1;
  count = 2 * pieces + 1;
  double h = (to - from) / (2 * pieces);
  double *knots = LAM_NEW(arena, double, count + 3), *weights = LAM_NEW(arena, double, count);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count);

  for (int i = 0; i < count; i++) {
    double t = from + i * h, r = i % 2 ? 1 / cos(h) : 1;
    points[i] = lam_along(lam_along(center, r * cos(t), x), r * sin(t), y);
    weights[i] = i % 2 ? cos(h) : 1;
  }

  for (int i = 0; i < count + 3; i++) knots[i] = i < 3 ? 0 : i >= count ? pieces : (i - 1) / 2;
  return (lam_spline_curve){2, count, knots, points, weights};
}

/* ---- parts ---- */

/* A curve stays as it is when the part is its whole domain and its knots are clamped there. */
lam_spline_curve lam_curve_part(lam_arena *arena, const lam_spline_curve *c, double low,
                                double high) {
  const double *k = c->knots;
  bool whole = low == k[c->degree] && high == k[c->count];
  if (whole && k[0] == low && k[c->count + c->degree] == high) return *c;
  return lam_spline_curve_cut(arena, c, low, high);
}

/* The parameter at which (x(t) - p) . x'(t), half the slope of the squared distance, changes its
 * sign from minus to plus between low and high, by bisection down to neighboring numbers. */
static double foot(lam_arena *arena, const lam_spline_side *s, lam_vec3 p, double low,
                   double high) {
  for (int i = 0; i < 200; i++) {
    double middle = (low + high) / 2;
    lam_vec3 slope, x = lam_spline_side_slope(arena, s, middle, &slope);
    if (middle <= low || middle >= high) break;
    *(lam_dot(lam_sub(x, p), slope) < 0 ? &low : &high) = middle;
  }
  return (low + high) / 2;
}

/* The parameter of the point nearest to p: the best of samples in every piece and of the feet
 * between them. A foot lies between two samples when the distance falls at one and rises at the
 * next. */
static double nearest(lam_arena *arena, const lam_spline_side *s, lam_vec3 p) {
  double best = s->knots[s->degree], least = INFINITY, before = best;
  bool falling = false;
  int samples = 2 * s->degree + 2;

  for (int i = s->degree; i < s->count; i++)
    for (int k = 0; k <= samples && s->knots[i] < s->knots[i + 1]; k++) {
      double t = k == samples ? s->knots[i + 1]
                              : s->knots[i] + (s->knots[i + 1] - s->knots[i]) * k / samples;
      lam_vec3 slope, x = lam_spline_side_slope(arena, s, t, &slope);
      bool rising = lam_dot(lam_sub(x, p), slope) >= 0;
      double at = falling && rising ? foot(arena, s, p, before, t) : t;

      double distance = lam_distance(lam_spline_side_point(arena, s, at), p),
             here = lam_distance(x, p);
      if (distance < least) least = distance, best = at;
      if (here < least) least = here, best = t;

      falling = !rising;
      before = t;
    }
  return best;
}

/* a and b are taken as the ends of the curve when they are there to a billionth of its size (or a
 * nanometer): of a closed curve both would be nearest to one end. */
lam_spline_curve lam_curve_between(lam_arena *arena, const lam_spline_curve *c, lam_vec3 a,
                                   lam_vec3 b) {
  lam_spline_side side = lam_spline_side_of_curve(c);
  double t[2] = {c->knots[c->degree], c->knots[c->count]}, length = t[1] - t[0];
  lam_vec3 ends[2] = {lam_spline_side_point(arena, &side, t[0]),
                      lam_spline_side_point(arena, &side, t[1])};

  double size = fmax(lam_distance(ends[0], ends[1]), lam_distance(a, b)),
         least = 1e-9 * fmax(size, 1);
  bool forward = lam_distance(a, ends[0]) <= least && lam_distance(b, ends[1]) <= least;
  bool backward = lam_distance(b, ends[0]) <= least && lam_distance(a, ends[1]) <= least;

  if (!forward && !backward) {
    double from = nearest(arena, &side, a), to = nearest(arena, &side, b), low = fmin(from, to),
           high = fmax(from, to);
    if (high - low > 1e-9 * length) t[0] = low, t[1] = high;
  }
  return lam_curve_part(arena, c, t[0], t[1]);
}

/* ---- borders ---- */

enum { border_samples = 256 };

/* The distance of p from the segment from a to b. */
static double distance_to_segment(lam_vec3 p, lam_vec3 a, lam_vec3 b) {
  lam_vec3 ab = lam_sub(b, a);
  double square = lam_dot(ab, ab), t = square > 0 ? lam_dot(lam_sub(p, a), ab) / square : 0;
  return lam_distance(p, lam_along(a, fmin(fmax(t, 0), 1), ab));
}

/* Whether p is within the tolerance of a polyline of count points. */
static bool is_near(lam_vec3 p, const lam_vec3 *line, int count, double tolerance) {
  for (int i = 0; i + 1 < count; i++)
    if (distance_to_segment(p, line[i], line[i + 1]) <= tolerance) return true;
  return false;
}

/* The point at a share f of the domain, 0 to 1. */
static lam_vec3 at_fraction(lam_arena *arena, const lam_spline_side *s, double f) {
  double low = s->knots[s->degree], high = s->knots[s->count];
  return lam_spline_side_point(arena, s, low + f * (high - low));
}

/* Whether the curves agree at corresponding parameters, taken forward or backward. */
static bool agree(lam_arena *arena, const lam_spline_side *a, const lam_spline_side *b,
                  double tolerance) {
  bool along[2] = {true, true};
  for (int k = 0; k <= 8; k++) {
    lam_vec3 x = at_fraction(arena, a, k / 8.0);
    for (int d = 0; d < 2; d++)
      along[d] &= lam_distance(x, at_fraction(arena, b, d ? 1 - k / 8.0 : k / 8.0)) <= tolerance;
  }
  return along[0] || along[1];
}

/* First by parameters: a border that was written beside its surface agrees with a side there.
 * Otherwise each of 16 points of the curve must be near some side, as a polyline. */
bool lam_curve_is_border(lam_arena *arena, const lam_spline_curve *curve,
                         const lam_spline_surface *surface) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_spline_side c = lam_spline_side_of_curve(curve), sides[4];
  double size = 0;
  for (int i = 0; i < surface->count[0] * surface->count[1]; i++)
    size = fmax(size, lam_distance(surface->points[i], surface->points[0]));

  bool found = false;
  for (int k = 0; k < 4 && !found; k++) {
    sides[k] = lam_spline_side_of(surface, k);
    found = agree(arena, &c, &sides[k], 1e-6 * size);
  }

  lam_vec3 *line = LAM_NEW(arena, lam_vec3, border_samples + 1);
  bool near[16] = {false};
  for (int k = 0; k < 4 && !found; k++) {
    for (int i = 0; i <= border_samples; i++)
      line[i] = at_fraction(arena, &sides[k], (double)i / border_samples);
    for (int i = 0; i < 16; i++)
      near[i] |= is_near(at_fraction(arena, &c, i / 15.0), line, border_samples + 1, 1e-4 * size);
  }

  bool all = true;
  for (int i = 0; i < 16; i++) all &= near[i];
  lam_arena_release(arena, mark);
  return found || all;
}
