/* The common volume of two closed surfaces as a sum over pairs of triangles. Called by
 * solid_shim.cc. */
#include "core/solid/prism.h"

#include "core/solid/triangles.h"
#include <stdlib.h>

/* A closed surface is the sum of the prisms that stand below its triangles down to some plane,
 * those below triangles that face up counted +, the others -. So the volume common to two closed
 * surfaces is the sum over pairs of triangles
 *   sign sign' integral of min(height, height')
 * over the area that both cover in plan. Both heights are linear there: the area is cut where
 * they are equal. */

/* A triangle seen from above: counterclockwise. */
typedef struct shadow {
  double x[3], y[3], z[3];
  double min[2], max[2]; /* in x and y */
  double doubled;        /* twice the area in plan */
  int sign;              /* 1: faces up, -1: faces down */
} shadow;

/* A corner in plan, with its height on both triangles. */
typedef struct plan_point {
  double x, y, height[2];
} plan_point;

/* A triangle clipped by three lines and one more has at most 7 corners. */
typedef struct polygon {
  int count;
  plan_point points[8];
} polygon;

/* The shadow of a triangle, with coordinates from the origin. False when it is upright: no area
 * in plan. */
static bool make_shadow(const lam_trimesh *mesh, int triangle, lam_vec3 origin, shadow *s) {
  lam_vec3 p[3];
  for (int k = 0; k < 3; k++) p[k] = lam_sub(mesh->vertices[mesh->triangles[triangle][k]], origin);
  double doubled = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  if (doubled == 0) return false;
  s->sign = doubled > 0 ? 1 : -1;
  s->doubled = fabs(doubled);
  for (int k = 0; k < 3; k++) {
    lam_vec3 q = p[doubled > 0 ? k : 2 - k];
    s->x[k] = q.x;
    s->y[k] = q.y;
    s->z[k] = q.z;
  }

  s->min[0] = fmin(s->x[0], fmin(s->x[1], s->x[2]));
  s->max[0] = fmax(s->x[0], fmax(s->x[1], s->x[2]));
  s->min[1] = fmin(s->y[0], fmin(s->y[1], s->y[2]));
  s->max[1] = fmax(s->y[0], fmax(s->y[1], s->y[2]));
  return true;
}

/* The height of the triangle's plane at (x, y), by barycentric coordinates; kept within the
 * triangle's own heights, which matters for needles. */
static double height_at(const shadow *s, double x, double y) {
  double u =
      ((x - s->x[0]) * (s->y[2] - s->y[0]) - (s->x[2] - s->x[0]) * (y - s->y[0])) / s->doubled;
  double v =
      ((s->x[1] - s->x[0]) * (y - s->y[0]) - (x - s->x[0]) * (s->y[1] - s->y[0])) / s->doubled;

  double h = s->z[0] + u * (s->z[1] - s->z[0]) + v * (s->z[2] - s->z[0]);
  double low = fmin(s->z[0], fmin(s->z[1], s->z[2])), high = fmax(s->z[0], fmax(s->z[1], s->z[2]));
  return fmin(fmax(h, low), high);
}

/* Keeps the part of a convex polygon where a linear function is >= 0 (Sutherland & Hodgman);
 * value: its values at the corners. */
static void clip(polygon *p, const double *value) {
  polygon kept = {0};
  for (int i = 0; i < p->count; i++) {
    int j = (i + 1) % p->count;
    const plan_point *a = &p->points[i], *b = &p->points[j];

    double u = value[i], v = value[j];
    if (u >= 0 && kept.count < 8) kept.points[kept.count++] = *a;
    if (((u > 0 && v < 0) || (u < 0 && v > 0)) && kept.count < 8) {
      double t = u / (u - v);
      plan_point *q = &kept.points[kept.count++];
      *q = (plan_point){a->x + t * (b->x - a->x), a->y + t * (b->y - a->y), {0}};
      for (int k = 0; k < 2; k++) q->height[k] = a->height[k] + t * (b->height[k] - a->height[k]);
    }
  }

  *p = kept;
}

/* The integral of height k over the part of the polygon where it is the smaller of the two. Where
 * both are equal all over, height 0 counts as the smaller. */
static double integral_where_smaller(polygon p, int k) {
  double value[8], largest = 0, sum = 0;
  for (int i = 0; i < p.count; i++) {
    value[i] = p.points[i].height[1 - k] - p.points[i].height[k];
    largest = fmax(largest, value[i]);
  }
  if (k == 1 && largest == 0) return 0;

  clip(&p, value);

  /* Of a linear height over a triangle: its area times the mean of the heights at the corners. */
  for (int i = 2; i < p.count; i++) {
    const plan_point *a = &p.points[0], *b = &p.points[i - 1], *c = &p.points[i];
    double doubled = (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
    sum += doubled / 6 * (a->height[k] + b->height[k] + c->height[k]);
  }
  return sum;
}

/* The integral of the smaller height over the area that two triangles share in plan: s clipped by
 * the sides of t. */
static double common_prism(const shadow *s, const shadow *t) {
  polygon p = {.count = 3};
  for (int k = 0; k < 3; k++) p.points[k] = (plan_point){s->x[k], s->y[k], {s->z[k], 0}};

  for (int k = 0; k < 3; k++) {
    int l = (k + 1) % 3;
    double side[8];
    for (int i = 0; i < p.count; i++)
      side[i] = (t->x[l] - t->x[k]) * (p.points[i].y - t->y[k]) -
                (p.points[i].x - t->x[k]) * (t->y[l] - t->y[k]);
    clip(&p, side);
  }
  for (int i = 0; i < p.count; i++)
    p.points[i].height[1] = height_at(t, p.points[i].x, p.points[i].y);
  return integral_where_smaller(p, 0) + integral_where_smaller(p, 1);
}

/* Ascending in min x, for the sweep. */
static int by_start(const void *a, const void *b) {
  const shadow *s = a, *t = b;
  return (s->min[0] > t->min[0]) - (s->min[0] < t->min[0]);
}

/* The shadows of the triangles that lie over or under the box from low to high, in the order of
 * the sweep; returns how many. */
static int make_shadows(lam_arena *arena, const lam_trimesh *mesh, lam_vec3 origin, lam_vec3 low,
                        lam_vec3 high, shadow **shadows) {
  int count = 0;
  *shadows = LAM_NEW(arena, shadow, mesh->triangle_count);
  for (int i = 0; i < mesh->triangle_count; i++) {
    shadow *s = &(*shadows)[count];
    if (!make_shadow(mesh, i, origin, s)) continue;

    bool beside =
        s->max[0] < low.x || s->min[0] > high.x || s->max[1] < low.y || s->min[1] > high.y;
    count += !beside;
  }

  qsort(*shadows, (size_t)count, sizeof **shadows, by_start);
  return count;
}

/* The sum over all pairs of triangles whose boxes overlap in plan, by a sweep along x. What is
 * small beside the sum of the terms' sizes is noise. */
static double sum_pairs(const shadow *a, int a_count, const shadow *b, int b_count) {
  double sum = 0, size = 0, widest = 0;
  for (int i = 0; i < b_count; i++) widest = fmax(widest, b[i].max[0] - b[i].min[0]);

  for (int i = 0, first = 0; i < a_count; i++) {
    /* Nothing before first can reach a[i]: no triangle of b is wider than widest. */
    while (first < b_count && b[first].min[0] < a[i].min[0] - widest) first++;
    for (int j = first; j < b_count && b[j].min[0] <= a[i].max[0]; j++) {
      if (b[j].max[0] < a[i].min[0] || b[j].max[1] < a[i].min[1] || b[j].min[1] > a[i].max[1])
        continue;

      double term = common_prism(&a[i], &b[j]);
      sum += a[i].sign * b[j].sign * term;
      size += fabs(term);
    }
  }

  return fabs(sum) < 1e-13 * size ? 0 : sum;
}

/* Prisms down to a plane through the middle of the overlap of the boxes: small numbers where it
 * matters. Only triangles over or under the other surface's box are taken. */
static double common_volume(lam_arena *arena, const lam_trimesh *a, const lam_trimesh *b) {
  lam_vec3 min[2], max[2];
  lam_points_bounds(a->vertices, a->vertex_count, &min[0], &max[0]);
  lam_points_bounds(b->vertices, b->vertex_count, &min[1], &max[1]);
  lam_vec3 origin = lam_scale(lam_v3(fmax(min[0].x, min[1].x) + fmin(max[0].x, max[1].x),
                                     fmax(min[0].y, min[1].y) + fmin(max[0].y, max[1].y),
                                     fmax(min[0].z, min[1].z) + fmin(max[0].z, max[1].z)),
                              0.5);

  lam_vec3 low[2], high[2]; /* seen from the origin */
  for (int k = 0; k < 2; k++) {
    low[k] = lam_sub(min[k], origin);
    high[k] = lam_sub(max[k], origin);
  }

  shadow *shadows[2];
  int count_a = make_shadows(arena, a, origin, low[1], high[1], &shadows[0]);
  int count_b = make_shadows(arena, b, origin, low[0], high[0], &shadows[1]);
  return sum_pairs(shadows[0], count_a, shadows[1], count_b);
}

/* An arena of its own, whose jump ends here: C++ frames may lie above. */
lam_status lam_prism_volume(const lam_trimesh *a, const lam_trimesh *b, double *volume) {
  lam_arena *arena = lam_arena_new();
  if (!arena) return LAM_NO_MEMORY;
  jmp_buf point;
  if (!LAM_ARENA_TRY(arena, point)) {
    lam_arena_free(arena);
    return LAM_NO_MEMORY;
  }

  *volume = common_volume(arena, a, b);
  lam_arena_free(arena);
  return LAM_OK;
}
