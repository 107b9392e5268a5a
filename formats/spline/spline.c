/* Clamped knots and sides of spline surfaces, and the list of those that are read. Called by the
 * writers and readers of formats/iges, formats/step, formats/mesh and by the files beside it. */
#include "formats/spline/spline.h"
#include "core/grow.h"

#include <string.h>

enum { coordinates = 4 }; /* w x, w y, w z, w */

/* A spline curve whose control points are rows of `width` numbers: homogeneous points, side by
 * side. */
typedef struct rows {
  int degree, count, width;
  double *knots, *points; /* count + degree + 1; count x width; there is room for more */
} rows;

/* (w x, w y, w z, w) of a point p with weight w. */
static void homogeneous(lam_vec3 p, double w, double to[coordinates]) {
  to[0] = w * p.x, to[1] = w * p.y, to[2] = w * p.z, to[3] = w;
}

/* The same curve run through backward: t becomes -t. */
static void reverse(rows *r) {
  int knots = r->count + r->degree + 1;
  for (int i = 0, j = knots - 1; i <= j; i++, j--) {
    double low = -r->knots[i];
    r->knots[i] = -r->knots[j];
    r->knots[j] = low;
  }

  for (int i = 0, j = r->count - 1; i < j; i++, j--)
    for (int c = 0; c < r->width; c++) {
      double low = r->points[i * r->width + c];
      r->points[i * r->width + c] = r->points[j * r->width + c];
      r->points[j * r->width + c] = low;
    }
}

/* Inserts the knot t into the piece knots[k] <= t < knots[k + 1], where it stands `times` times
 * already (W. Boehm): Q_i = a_i P_i + (1 - a_i) P_(i-1) with a_i = (t - knots[i]) / (knots[i +
 * degree] - knots[i]), for k - degree < i <= k - times; points behind move up. Precondition: room
 * for one more. */
static void insert(rows *r, double t, int k, int times) {
  for (int i = r->count; i > k - r->degree; i--) {
    double a = i > k - times ? 0 : (t - r->knots[i]) / (r->knots[i + r->degree] - r->knots[i]);
    double *at = r->points + i * r->width;
    for (int c = 0; c < r->width; c++)
      at[c] = (a == 0 ? 0 : a * at[c]) + (1 - a) * at[c - r->width];
  }

  int last = r->count + r->degree;
  memmove(r->knots + k + 2, r->knots + k + 1, (size_t)(last - k) * sizeof *r->knots);
  r->knots[k + 1] = t;
  r->count++;
}

/* Cuts the curve off below t, in its domain: t is inserted until it stands degree times, then
 * what lies before is dropped and t stands once more. Precondition: room for degree more points
 * and knots. */
static void cut_low(rows *r, double t) {
  int k = r->degree, times = 0;
  while (r->knots[k + 1] <= t) k++;
  while (times <= k && r->knots[k - times] == t) times++;
  for (; times < r->degree; times++, k++) insert(r, t, k, times);

  int first = k - r->degree, knots = r->count + r->degree + 1;
  memmove(r->knots, r->knots + first, (size_t)(knots - first) * sizeof *r->knots);
  memmove(r->points, r->points + first * r->width,
          (size_t)(r->count - first) * (size_t)r->width * sizeof *r->points);
  r->count -= first;
  for (int i = 0; i <= r->degree; i++) r->knots[i] = t;
}

static bool is_clamped(const lam_spline_surface *s, int d) {
  const double *knots = s->knots[d];
  return knots[0] == knots[s->degree[d]] && knots[s->count[d]] == knots[s->count[d] + s->degree[d]];
}

/* The control net as rows of direction d, with room for cutting it at both ends. */
static rows rows_of(lam_arena *arena, const lam_spline_surface *s, int d) {
  int other = s->count[1 - d], room = s->count[d] + 2 * s->degree[d];
  rows r = {.degree = s->degree[d], .count = s->count[d], .width = coordinates * other};
  r.knots = LAM_NEW(arena, double, room + s->degree[d] + 1);
  memcpy(r.knots, s->knots[d], (size_t)(r.count + r.degree + 1) * sizeof *r.knots);

  r.points = LAM_NEW(arena, double, room *r.width);
  for (int i = 0; i < r.count; i++)
    for (int j = 0; j < other; j++) {
      int at = d ? j * r.count + i : i * other + j;
      homogeneous(s->points[at], s->weights ? s->weights[at] : 1,
                  r.points + i * r.width + coordinates * j);
    }
  return r;
}

/* Clamps the knots of direction d: the domain is cut off at both ends, where it begins. Without
 * weights the last coordinate stays 1 but for rounding, and is dropped. */
static void clamp(lam_arena *arena, lam_spline_surface *s, int d) {
  int other = s->count[1 - d];
  rows r = rows_of(arena, s, d);
  for (int end = 0; end < 2; end++) {
    cut_low(&r, r.knots[r.degree]);
    reverse(&r);
  }

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, r.count * other);
  double *weights = s->weights ? LAM_NEW(arena, double, r.count *other) : NULL;
  for (int i = 0; i < r.count; i++)
    for (int j = 0; j < other; j++) {
      int at = d ? j * r.count + i : i * other + j;
      const double *from = r.points + i * r.width + coordinates * j;
      points[at] = weights ? lam_scale(lam_v3(from[0], from[1], from[2]), 1 / from[3])
                           : lam_v3(from[0], from[1], from[2]);
      if (weights) weights[at] = from[3];
    }

  s->count[d] = r.count;
  s->knots[d] = r.knots;
  s->points = points;
  s->weights = weights;
}

/* Cut off below low; then, run through backward, below -high. */
lam_spline_curve lam_spline_curve_cut(lam_arena *arena, const lam_spline_curve *c, double low,
                                      double high) {
  int room = c->count + 2 * c->degree;
  rows r = {.degree = c->degree, .count = c->count, .width = coordinates};
  r.knots = LAM_NEW(arena, double, room + c->degree + 1);
  r.points = LAM_NEW(arena, double, room *coordinates);
  memcpy(r.knots, c->knots, (size_t)(c->count + c->degree + 1) * sizeof *r.knots);
  for (int i = 0; i < c->count; i++)
    homogeneous(c->points[i], c->weights ? c->weights[i] : 1, r.points + coordinates * i);

  cut_low(&r, low);
  reverse(&r);
  cut_low(&r, -high);
  reverse(&r);

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, r.count);
  double *weights = c->weights ? LAM_NEW(arena, double, r.count) : NULL;
  for (int i = 0; i < r.count; i++) {
    const double *from = r.points + coordinates * i;
    points[i] = lam_scale(lam_v3(from[0], from[1], from[2]), 1 / from[3]);
    if (weights) weights[i] = from[3];
  }
  return (lam_spline_curve){c->degree, r.count, r.knots, points, weights};
}

/* One direction after the other; one that is clamped already keeps its arrays. */
lam_spline_surface lam_spline_clamped(lam_arena *arena, const lam_spline_surface *surface) {
  lam_spline_surface s = *surface;
  for (int d = 0; d < 2; d++)
    if (!is_clamped(&s, d)) clamp(arena, &s, d);
  return s;
}

/* ---- sides ---- */

/* Control points stand row by row, v running fastest: sides 0 and 2 are columns, 1 and 3 rows. */
lam_spline_side lam_spline_side_of(const lam_spline_surface *s, int k) {
  int along = k & 1, n = s->count[0], m = s->count[1];
  return (lam_spline_side){.degree = s->degree[along],
                           .count = s->count[along],
                           .first = k == 1   ? (n - 1) * m
                                    : k == 2 ? m - 1
                                             : 0,
                           .stride = along ? 1 : m,
                           .knots = s->knots[along],
                           .points = s->points,
                           .weights = s->weights};
}

/* All points, one after another. */
lam_spline_side lam_spline_side_of_curve(const lam_spline_curve *curve) {
  return (lam_spline_side){.degree = curve->degree,
                           .count = curve->count,
                           .stride = 1,
                           .knots = curve->knots,
                           .points = curve->points,
                           .weights = curve->weights};
}

lam_vec3 lam_spline_side_point(lam_arena *arena, const lam_spline_side *side, double t) {
  lam_vec3 slope;
  return lam_spline_side_slope(arena, side, t, &slope);
}

/* De Boor's algorithm on homogeneous points (X, w); its last two points give the derivative of
 * the homogeneous curve, and x' = (X' - w' x) / w. */
lam_vec3 lam_spline_side_slope(lam_arena *arena, const lam_spline_side *s, double t,
                               lam_vec3 *slope) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int p = s->degree, low = p, high = s->count;

  /* The piece knots[low] <= t < knots[low + 1]; at the end of the domain, the last one. */
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(s->knots[middle] <= t ? &low : &high) = middle;
  }
  while (low > p && s->knots[low] == s->knots[low + 1]) low--;

  double(*x)[coordinates] =
      (double(*)[coordinates])lam_arena_alloc(arena, (size_t)p + 1, sizeof *x),
  d[coordinates];
  for (int j = 0; j <= p; j++) {
    int at = s->first + (low - p + j) * s->stride;
    homogeneous(s->points[at], s->weights ? s->weights[at] : 1, x[j]);
  }

  for (int r = 1; r <= p; r++)
    for (int j = p; j >= r; j--) {
      double from = s->knots[low - p + j], width = s->knots[low + 1 + j - r] - from,
             a = (t - from) / width;
      for (int c = 0; c < coordinates; c++) {
        d[c] = p * (x[j][c] - x[j - 1][c]) / width;
        x[j][c] = (1 - a) * x[j - 1][c] + a * x[j][c];
      }
    }

  lam_vec3 point = lam_scale(lam_v3(x[p][0], x[p][1], x[p][2]), 1 / x[p][3]);
  *slope = lam_scale(lam_along(lam_v3(d[0], d[1], d[2]), -d[3], point), 1 / x[p][3]);
  lam_arena_release(arena, mark);
  return point;
}

bool lam_spline_meet(lam_vec3 a, lam_vec3 b) { return lam_distance(a, b) <= 1e-9; }

/* All control points are the first one. */
bool lam_spline_side_is_point(const lam_spline_side *s) {
  for (int i = 1; i < s->count; i++)
    if (!lam_spline_meet(s->points[s->first + i * s->stride], s->points[s->first])) return false;
  return true;
}

/* Compares control points: sides of one direction share its knots. */
bool lam_spline_sides_meet(const lam_spline_side *a, const lam_spline_side *b) {
  for (int i = 0; i < a->count; i++) {
    int at = a->first + i * a->stride, bt = b->first + i * b->stride;
    if (!lam_spline_meet(a->points[at], b->points[bt])) return false;
    if (a->weights && fabs(a->weights[at] - b->weights[bt]) > 1e-12 * a->weights[at]) return false;
  }
  return true;
}

/* ---- what was read ---- */

/* The notes stand in an array beside the items, which grows with them. */
void lam_spline_append(lam_arena *arena, lam_spline_list *list, const lam_spline_surface *surface,
                       const char *note) {
  int room = list->capacity;
  list->notes = lam_grow(arena, list->notes, list->count, &room, sizeof *list->notes);
  list->notes[list->count] = note;
  LAM_APPEND(arena, list->items, list->count, list->capacity, *surface);
}

/* Texts for the report of the surface that is taken from the file. */
const char *lam_spline_note(bool trimmed, bool placed) {
  if (trimmed && placed)
    return "in the file this face is trimmed to a part of its surface, and components are placed "
           "in an assembly: the whole surface is taken, where its component was drawn";
  if (trimmed)
    return "in the file this face is trimmed to a part of its surface: the whole surface is taken";
  return placed ? "in the file components are placed in an assembly: the surface is taken where "
                  "its component was drawn"
                : NULL;
}

/* Written so that a knot that is not a number decreases. */
const char *lam_spline_knots_problem(const lam_spline_surface *s, int d) {
  if (s->degree[d] < 1) return "a degree less than 1";
  if (s->count[d] <= s->degree[d]) return "too few points for its degree";

  int knots = s->count[d] + s->degree[d] + 1;
  for (int i = 1; i < knots; i++)
    if (!(s->knots[d][i] >= s->knots[d][i - 1])) return "knots that decrease";
  return s->knots[d][s->degree[d]] < s->knots[d][s->count[d]] ? NULL : "knots with an empty domain";
}

/* The square of a point's distance from the origin must be finite, too. */
const char *lam_spline_problem(const lam_spline_surface *s) {
  for (int d = 0; d < 2; d++) {
    const char *problem = lam_spline_knots_problem(s, d);
    if (problem) return problem;
  }

  for (int i = 0; i < s->count[0] * s->count[1]; i++)
    if (!isfinite(lam_dot(s->points[i], s->points[i]))) return "a point too far away";
  for (int i = 0; s->weights && i < s->count[0] * s->count[1]; i++)
    if (!(s->weights[i] > 0)) return "a weight that is not positive";
  return NULL;
}
