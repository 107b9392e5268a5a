/* The constraint `glide`: boundary vertices slide along the boundary curve of the start. Listed in
 * constraints.c; net/optimize.c adds it for `boundary: glide`. */
#include "con/constraint.h"
#include "con/kernel.h"

#include <string.h>

/* A vertex on a straight line through P along the unit direction d: with unit vectors a, b
 * orthogonal to d and to each other,
 *   r = (a.(v - P), b.(v - P))   (2 rows, length);  p = P, a, b
 *   dr/dv = a, b */
static void on_line(int n, const double *x, const double *p, double *r, double *J) {
  for (int i = 0; i < 2; i++) {
    const double *a = p + 3 + 3 * i;
    r[i] = a[0] * (x[0] - p[0]) + a[1] * (x[1] - p[1]) + a[2] * (x[2] - p[2]);
    if (J) memcpy(J + i * n, a, sizeof(double) * 3);
  }
}

/* The parameters of on_line for the line through point along direction (of any length). a is
 * orthogonal to the coordinate axis that is farthest from the direction. */
static void set_line(double *p, lam_vec3 point, lam_vec3 direction) {
  lam_vec3 d = lam_unit(direction);
  lam_vec3 least = fabs(d.x) <= fabs(d.y) && fabs(d.x) <= fabs(d.z) ? lam_v3(1, 0, 0)
                   : fabs(d.y) <= fabs(d.z)                         ? lam_v3(0, 1, 0)
                                                                    : lam_v3(0, 0, 1);
  lam_vec3 a = lam_unit(lam_cross(d, least)), b = lam_cross(d, a);

  lam_vec3 all[3] = {point, a, b};
  for (int i = 0; i < 3; i++) {
    p[3 * i] = all[i].x;
    p[3 * i + 1] = all[i].y;
    p[3 * i + 2] = all[i].z;
  }
}

/* ---- the boundary curve ---- */

/* A side of the boundary at the start, as a polyline. Vertices follow it: their foot point and
 * tangent are found anew every iteration. */
typedef struct track {
  int count;   /* points */
  bool closed; /* the loop has no corner */
  const lam_vec3 *points;
} track;

typedef struct glider {
  const track *curve;
  int segment; /* of the last foot */
} glider;

static int segments_of(const track *t) { return t->closed ? t->count : t->count - 1; }

/* The point of segment s that is nearest to v; returns their distance. */
static double foot_on_segment(const track *t, int s, lam_vec3 v, lam_vec3 *foot) {
  lam_vec3 a = t->points[s], b = t->points[(s + 1) % t->count], d = lam_sub(b, a);
  double u = lam_dot(lam_sub(v, a), d) / lam_dot(d, d);
  *foot = lam_along(a, u < 0 ? 0 : u > 1 ? 1 : u, d);
  return lam_distance(*foot, v);
}

/* The segment nearest to v and the foot point on it. Only the segments near the last one are
 * searched, so that a step costs the same for any length of the boundary. */
static int nearest_segment(const track *t, int last, lam_vec3 v, lam_vec3 *nearest) {
  int segments = segments_of(t), best = last, reach = 4;
  double least = INFINITY;
  *nearest = v;
  for (int k = -reach; k <= reach; k++) {
    int s = last + k;
    if (t->closed) s = ((s % segments) + segments) % segments;
    if (s < 0 || s >= segments) continue;

    lam_vec3 foot;
    double distance = foot_on_segment(t, s, v, &foot);
    if (distance < least) {
      least = distance;
      best = s;
      *nearest = foot;
    }
  }
  return best;
}

/* The tangent at a foot on segment s: between the directions of the segment and its neighbor, so
 * that it turns continuously. At an end of an open curve there is no neighbor. */
static lam_vec3 tangent_at(const track *t, int s, lam_vec3 foot) {
  int segments = segments_of(t);
  lam_vec3 a = t->points[s], b = t->points[(s + 1) % t->count];
  double length = lam_distance(a, b), u = length > 0 ? lam_distance(a, foot) / length : 0;
  int other = u < .5 ? s - 1 : s + 1;
  if (t->closed) other = (other + segments) % segments;
  lam_vec3 own = lam_unit(lam_sub(b, a));
  if (other < 0 || other >= segments) return own;

  /* the neighbor's share grows from 0 in the middle of the segment to 1/2 at its end */
  lam_vec3 next = lam_unit(lam_sub(t->points[(other + 1) % t->count], t->points[other]));
  return lam_unit(lam_mix(own, next, fabs(u - .5)));
}

/* The block's update: every vertex gets the line through its foot point along the tangent. */
static void follow(struct lam_block *block, const double *x, const int *offset, void *context) {
  glider *gliders = context;
  for (int i = 0; i < block->count; i++) {
    const track *t = gliders[i].curve;
    lam_vec3 v = lam_local(x + offset[block->nodes[i]], 0), foot;
    int s = nearest_segment(t, gliders[i].segment, v, &foot);
    gliders[i].segment = s;
    set_line(block->params + 9 * i, foot, tangent_at(t, s, foot));
  }
}

/* ---- the block ---- */

/* The side where its vertices are now, which is the start. */
static track *track_of(const lam_problem *problem, const lam_polyline *side) {
  lam_vec3 *points = LAM_NEW(problem->arena, lam_vec3, side->count);
  for (int i = 0; i < side->count; i++) points[i] = lam_local(problem->x, side->vertices[i]);
  track *t = LAM_NEW(problem->arena, track, 1);
  *t = (track){side->count, side->closed, points};
  return t;
}

/* The corner at which an open side begins becomes fixed (its other end begins the next side); the
 * vertices between the corners, of a closed side all, glide. The first foot of each is searched
 * near the segment that begins with it. */
static void add_side(lam_scope *scope, const lam_polyline *side, double weight) {
  lam_arena *arena = scope->problem->arena;
  const track *t = track_of(scope->problem, side);
  int first = side->closed ? 0 : 1, count = side->closed ? side->count : side->count - 2;
  if (!side->closed) scope->problem->fixed[side->vertices[0]] = true;
  glider *gliders = LAM_NEW(arena, glider, count);
  for (int i = 0; i < count; i++) gliders[i] = (glider){t, first + i};

  lam_block block = {.name = "glide", .kernel = on_line, .rows = 2, .role = LAM_HARD, .arity = 1};
  block.weight = weight;
  block.count = count;
  block.nodes = side->vertices + first;
  block.param_count = 9;
  block.params = LAM_NEW(arena, double, 9 * count);
  block.update = follow;
  block.context = gliders;
  lam_problem_add(scope->problem, block);
}

/* One block per side. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_polyline *sides;
  int count = lam_scope_sides(scope, &sides);
  for (int s = 0; s < count; s++) add_side(scope, &sides[s], weight);
}

const lam_constraint_kind lam_con_glide = {
    {"glide", "Gliding on the boundary",
     "Boundary vertices stay on the boundary curve of the start and may slide along it; corners "
     "stay where they are. Straight edges stay straight.",
     "a.(v - P) = b.(v - P) = 0, foot point P and normals a, b found anew every iteration",
     "thesis 3.7", NULL, 0},
    add};
