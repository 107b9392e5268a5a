/* The sparse system of the inner points, from the blocks of a form. Called by the methods for
 * least area and by nearest.c, which fills blocks of its own.
 *
 * Point (i, j) shares a span with (i + di, j + dj), |di|, |dj| <= degree; the lower triangle of
 * the matrix is listed by columns. */
#include "surf/area/area_parts.h"

/* Runs the statement that follows for every neighbor `other` of a point that comes after it or is
 * itself, ascending; slot is where the block of the two stands in the point's window. */
#define EACH_NEIGHBOR(form, point, other, slot)                                                    \
  for (int di_ = 0, i_ = (point) / (form)->inner[1], j_ = (point) % (form)->inner[1],              \
           q_ = (form)->rule[1].degree;                                                            \
       di_ <= (form)->rule[0].degree && i_ + di_ < (form)->inner[0]; di_++)                        \
    for (int dj_ = di_ ? -q_ : 0, slot, other; dj_ <= q_; dj_++)                                   \
      if (slot = di_ * (2 * q_ + 1) + dj_ + q_, other = (i_ + di_) * (form)->inner[1] + j_ + dj_,  \
          j_ + dj_ >= 0 && j_ + dj_ < (form)->inner[1])

/* A fill-reducing order of the points, expanded to components per point. */
static void find_order(lam_arena *arena, const lam_area_form *form, int components, int *order) {
  int total = form->inner[0] * form->inner[1], p = form->rule[0].degree, q = form->rule[1].degree,
      count = 0;
  int *start = LAM_NEW(arena, int, total + 1), *points = LAM_NEW(arena, int, total);
  int *neighbor = LAM_NEW(arena, int, total *(2 * p + 1) * (2 * q + 1));

  /* The neighbors of every point, before it and after it. */
  for (int a = 0; a < total; a++) {
    int i = a / form->inner[1], j = a % form->inner[1];
    start[a] = count;
    for (int k = i - p; k <= i + p; k++)
      for (int l = j - q; l <= j + q; l++)
        if (k >= 0 && k < form->inner[0] && l >= 0 && l < form->inner[1] && (k != i || l != j))
          neighbor[count++] = k * form->inner[1] + l;
  }
  start[total] = count;

  lam_factor_order(arena, total, start, neighbor, points);
  for (int a = 0; a < total; a++)
    for (int c = 0; c < components; c++) order[a * components + c] = points[a] * components + c;
}

/* Columns in the order of points and components; rows of a column ascend. */
lam_area_system lam_area_system_make(lam_arena *arena, const lam_area_form *form, int components) {
  int total = form->inner[0] * form->inner[1], size = total * components, count = 0;
  int *start = LAM_NEW(arena, int, size + 1), *order = LAM_NEW(arena, int, size);
  int *row = LAM_NEW(arena, int, (size_t)total * form->window * components * components);

  for (int a = 0; a < total; a++)
    for (int c = 0; c < components; c++) {
      start[a * components + c] = count;
      EACH_NEIGHBOR(form, a, b, slot) {
        (void)slot;
        for (int d = b == a ? c : 0; d < components; d++) row[count++] = b * components + d;
      }
    }
  start[size] = count;

  find_order(arena, form, components, order);
  return (lam_area_system){components,
                           size,
                           start,
                           row,
                           LAM_NEW(arena, double, count),
                           lam_factor_analyze(arena, size, start, row, order)};
}

/* Where entry (c, d) of a block stands among its terms: the symmetric term, the skew term (-1:
 * none) and its sign. */
static const struct {
  int symmetric, skew;
  double sign;
} terms[3][3] = {{{1, -1, 0}, {2, 9, 1}, {3, 8, -1}},
                 {{2, 9, -1}, {4, -1, 0}, {5, 7, 1}},
                 {{3, 8, 1}, {5, 7, -1}, {6, -1, 0}}};

/* Values in the order in which lam_area_system_make lists the rows. */
bool lam_area_system_factor(const lam_area_system *system, const lam_area_form *form,
                            double lambda) {
  int total = form->inner[0] * form->inner[1], count = 0;

  for (int a = 0; a < total; a++)
    for (int c = 0; c < system->components; c++) EACH_NEIGHBOR(form, a, b, slot) {
        const double *e = form->blocks + ((size_t)a * form->window + slot) * LAM_AREA_TERMS;
        if (system->components == 1) {
          system->values[count++] = e[0];
          continue;
        }

        for (int d = b == a ? c : 0; d < 3; d++) {
          double skew = terms[c][d].skew < 0 ? 0 : terms[c][d].sign * e[terms[c][d].skew];
          system->values[count++] = e[terms[c][d].symmetric] + skew + (c == d ? lambda * e[0] : 0);
        }
      }
  return lam_factor_refactor(system->factor, system->values);
}

/* With one component the three coordinates are solved for one after the other. */
void lam_area_system_step(lam_arena *arena, const lam_area_system *system, const lam_vec3 *gradient,
                          lam_vec3 *step) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int n = system->size, separate = system->components == 1 ? 3 : 1,
      stride = system->components == 1 ? 3 : 1;
  double *b = LAM_NEW(arena, double, n);

  for (int c = 0; c < separate; c++) {
    for (int i = 0; i < n; i++) b[i] = -(&gradient[0].x)[i * stride + c];
    lam_factor_solve(system->factor, b, b);
    for (int i = 0; i < n; i++) (&step[0].x)[i * stride + c] = b[i];
  }
  lam_arena_release(arena, mark);
}
