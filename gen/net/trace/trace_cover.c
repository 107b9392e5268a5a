/* Which cells of a traced net lie on others, and how much of the surface they cover, by a fine
 * pattern of points in (u, v). A point on a side that two cells share is in exactly one of them:
 * the rule of even and odd crossings sees to it. Called by trace_net.c and trace_start.c. */
#include "net/trace/trace_cover.h"

#include <math.h>

struct lam_pattern {
  int side;
  double low[2], step[2]; /* of the points, in (u, v) */
  bool *taken;            /* side x side */
};

lam_pattern *lam_pattern_new(lam_arena *arena, const lam_line_field *field, int side) {
  lam_pattern *p = LAM_NEW(arena, lam_pattern, 1);
  p->side = side;
  p->taken = LAM_NEW(arena, bool, side *side);
  for (int c = 0; c < 2; c++) {
    p->step[c] = (field->high[c] - field->low[c]) / side;
    p->low[c] = field->low[c] + p->step[c] / 2;
  }
  return p;
}

/* Whether a line from (u, v) towards larger u crosses the outline an odd number of times. */
static bool is_inside(const lam_vec2 corner[4], double u, double v) {
  bool inside = false;
  for (int k = 0; k < 4; k++) {
    lam_vec2 a = corner[k], b = corner[(k + 1) & 3];
    if ((a.y > v) == (b.y > v)) continue;
    if (u < (b.x - a.x) * (v - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/* The points of the pattern between from and to along one coordinate: first to last - 1. */
static void between(const lam_pattern *p, int c, double from, double to, int *first, int *last) {
  *first = (int)fmin(fmax(ceil((from - p->low[c]) / p->step[c]), 0), p->side);
  *last = (int)fmin(fmax(floor((to - p->low[c]) / p->step[c]) + 1, 0), p->side);
}

/* Twice over the points in the box: whether they are free, then to take them. */
bool lam_pattern_lay(lam_pattern *p, const lam_vec2 corner[4]) {
  lam_vec2 low = corner[0], high = corner[0];
  for (int k = 1; k < 4; k++) {
    low = (lam_vec2){fmin(low.x, corner[k].x), fmin(low.y, corner[k].y)};
    high = (lam_vec2){fmax(high.x, corner[k].x), fmax(high.y, corner[k].y)};
  }
  int u0, u1, v0, v1;
  between(p, 0, low.x, high.x, &u0, &u1);
  between(p, 1, low.y, high.y, &v0, &v1);

  for (int take = 0; take < 2; take++)
    for (int i = u0; i < u1; i++)
      for (int j = v0; j < v1; j++) {
        if (!is_inside(corner, p->low[0] + i * p->step[0], p->low[1] + j * p->step[1])) continue;
        if (take)
          p->taken[i * p->side + j] = true;
        else if (p->taken[i * p->side + j])
          return false;
      }
  return true;
}

/* Points are weighted by the surface's area around them; singular ones have none. */
double lam_cells_coverage(lam_arena *arena, const lam_line_field *field, const lam_cells *cells) {
  enum { side = 128 };
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_pattern *p = lam_pattern_new(arena, field, side);
  for (int i = 0; i + 1 < cells->rows; i++)
    for (int j = 0; j + 1 < cells->columns; j++) {
      const lam_vec2 *a = &cells->at[i * cells->columns + j], *b = a + cells->columns;
      lam_pattern_lay(p, (lam_vec2[4]){a[0], b[0], b[1], a[1]});
    }

  double area = 0, covered = 0;
  for (int i = 0; i < side; i++)
    for (int j = 0; j < side; j++) {
      lam_jet jet;
      lam_surface_eval(field->surface, p->low[0] + i * p->step[0], p->low[1] + j * p->step[1],
                       &jet);
      double element = lam_length(lam_cross(jet.u, jet.v));
      if (!isfinite(element)) continue;
      area += element;
      if (p->taken[i * side + j]) covered += element;
    }
  lam_arena_release(arena, mark);
  return area > 0 ? covered / area : 0;
}
