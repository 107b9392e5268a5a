#include "con/constraint.h"
#include "con/kernel.h"

#include <string.h>

/* A vertex on a straight line through P along the unit direction d: with unit vectors a, b
 * orthogonal to d and to each other, r = (a.(v - P), b.(v - P))   (2 rows, length);  p = P, a, b */
static void on_line(int n, const double *x, const double *p, double *r, double *J) {
  for (int i = 0; i < 2; i++) {
    const double *a = p + 3 + 3 * i;
    r[i] = a[0] * (x[0] - p[0]) + a[1] * (x[1] - p[1]) + a[2] * (x[2] - p[2]);
    if (J) memcpy(J + i * n, a, sizeof(double) * 3);
  }
}

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

void lam_glide_add(lam_scope *scope, double weight, int count, const int *vertices,
                   const lam_vec3 *points, const lam_vec3 *directions) {
  double *params = LAM_NEW(scope->problem->arena, double, 9 * count);
  for (int i = 0; i < count; i++) set_line(params + 9 * i, points[i], directions[i]);
  lam_problem_add(scope->problem, (lam_block){.name = "glide",
                                              .kernel = on_line,
                                              .rows = 2,
                                              .role = LAM_HARD,
                                              .weight = weight,
                                              .count = count,
                                              .arity = 1,
                                              .nodes = vertices,
                                              .param_count = 9,
                                              .params = params});
}

/* The boundary curve at the start, followed by a vertex: a polyline with its foot point and tangent
 * found anew every iteration. Only the segments near the last foot are searched, so a step costs
 * the same for any boundary length. */
typedef struct track {
  int count; /* points; the curve is closed when the loop has no corner */
  bool closed;
  const lam_vec3 *points;
} track;

typedef struct glider {
  const track *curve;
  int segment; /* of the last foot */
} glider;

static double foot_on_segment(const track *t, int s, lam_vec3 v, lam_vec3 *foot) {
  lam_vec3 a = t->points[s], b = t->points[(s + 1) % t->count], d = lam_sub(b, a);
  double u = lam_dot(lam_sub(v, a), d) / lam_dot(d, d);
  *foot = lam_along(a, u < 0 ? 0 : u > 1 ? 1 : u, d);
  return lam_distance(*foot, v);
}

/* The tangent at a foot: between the directions of the segment and its neighbor, so that it turns
 * continuously. */
static lam_vec3 tangent_at(const track *t, int s, lam_vec3 foot) {
  int last = t->closed ? t->count : t->count - 1;
  lam_vec3 a = t->points[s], b = t->points[(s + 1) % t->count];
  double length = lam_distance(a, b), u = length > 0 ? lam_distance(a, foot) / length : 0;
  int other = u < .5 ? s - 1 : s + 1;
  if (t->closed) other = (other + last) % last;
  lam_vec3 own = lam_unit(lam_sub(b, a));
  if (other < 0 || other >= last) return own;
  lam_vec3 next = lam_unit(lam_sub(t->points[(other + 1) % t->count], t->points[other]));
  return lam_unit(lam_mix(own, next, fabs(u - .5)));
}

static void follow(struct lam_block *block, const double *x, const int *offset, void *context) {
  glider *gliders = context;
  for (int i = 0; i < block->count; i++) {
    const track *t = gliders[i].curve;
    lam_vec3 v = lam_local(x + offset[block->nodes[i]], 0), foot, best_foot = v;
    int segments = t->closed ? t->count : t->count - 1, best = gliders[i].segment, reach = 4;
    double least = INFINITY;
    for (int k = -reach; k <= reach; k++) {
      int s = gliders[i].segment + k;
      if (t->closed) s = ((s % segments) + segments) % segments;
      if (s < 0 || s >= segments) continue;
      double distance = foot_on_segment(t, s, v, &foot);
      if (distance < least) {
        least = distance;
        best = s;
        best_foot = foot;
      }
    }
    gliders[i].segment = best;
    set_line(block->params + 9 * i, best_foot, tangent_at(t, best, best_foot));
  }
}

/* A boundary loop is cut at its corners (boundary vertices of valence 2): corners stay, the
 * vertices between them glide. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_net *net = scope->net;
  lam_arena *arena = scope->problem->arena;
  lam_vec3 *positions = LAM_NEW(arena, lam_vec3, net->mesh.vertex_count);
  lam_problem_positions(scope->problem, positions);
  for (int l = 0; l < net->loop_count; l++) {
    const lam_polyline *loop = &net->loops[l];
    int n = loop->count, corner = 0;
    while (corner < n &&
           net->ring_start[loop->vertices[corner] + 1] - net->ring_start[loop->vertices[corner]] !=
               2)
      corner++;
    bool closed = corner == n;
    int start = closed ? 0 : corner;
    for (int from = 0; from < n;) {
      int to = from + 1;
      while (to < n && (closed || net->ring_start[loop->vertices[(start + to) % n] + 1] -
                                          net->ring_start[loop->vertices[(start + to) % n]] !=
                                      2))
        to++;
      track *t = LAM_NEW(arena, track, 1);
      t->closed = closed;
      t->count = closed ? n : to - from + 1;
      lam_vec3 *points = LAM_NEW(arena, lam_vec3, t->count);
      for (int i = 0; i < t->count; i++)
        points[i] = positions[loop->vertices[(start + from + i) % n]];
      t->points = points;
      int first = closed ? 0 : 1, count = closed ? n : to - from - 1;
      if (!closed) scope->problem->fixed[loop->vertices[(start + from) % n]] = true;
      int *vertices = LAM_NEW(arena, int, count);
      glider *gliders = LAM_NEW(arena, glider, count);
      for (int i = 0; i < count; i++) {
        vertices[i] = loop->vertices[(start + from + first + i) % n];
        gliders[i] =
            (glider){t, first + i < (closed ? n : t->count - 1) ? first + i : first + i - 1};
      }
      lam_problem_add(scope->problem, (lam_block){.name = "glide",
                                                  .kernel = on_line,
                                                  .rows = 2,
                                                  .role = LAM_HARD,
                                                  .weight = weight,
                                                  .count = count,
                                                  .arity = 1,
                                                  .nodes = vertices,
                                                  .param_count = 9,
                                                  .params = LAM_NEW(arena, double, 9 * count),
                                                  .update = follow,
                                                  .context = gliders});
      from = to;
    }
  }
}

const lam_constraint_kind lam_con_glide = {
    {"glide", "Gliding on the boundary",
     "Boundary vertices stay on the boundary curve of the start and may slide along it; corners "
     "stay where they are. "
     "Straight "
     "edges stay straight.",
     "a.(v - P) = b.(v - P) = 0, foot point P and normals a, b found anew every iteration",
     "thesis 3.7", NULL, 0},
    add};
