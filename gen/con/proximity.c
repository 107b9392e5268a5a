/* The constraint `proximity`: nearness to a reference mesh. Listed in constraints.c; net/optimize.c
 * adds it where a design gives `net.reference`. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Nearness to a reference surface: the distance to the tangent plane at the closest point (thesis
 * 3.7; closest points on triangles, found anew every iteration).
 *   r = n.(v - P)  (length), dr/dv = n;  p = P, n */
static void to_plane(int n, const double *x, const double *p, double *r, double *J) {
  (void)n;
  r[0] = p[3] * (x[0] - p[0]) + p[4] * (x[1] - p[1]) + p[5] * (x[2] - p[2]);
  if (!J) return;
  for (int c = 0; c < 3; c++) J[c] = p[3 + c];
}

typedef struct surface_context {
  const lam_tree *tree;
  const lam_trimesh *mesh;
} surface_context;

/* The point of the surface that is closest to v, and a unit normal there. */
static lam_vec3 closest_point(const surface_context *surface, lam_vec3 v, lam_vec3 *normal) {
  lam_vec3 foot;
  int triangle;
  lam_tree_closest(surface->tree, v, &foot, &triangle);
  *normal = lam_v3(0, 0, 0);
  if (triangle < 0) return v; /* memory ran out: lam_tree_ran_out tells the optimizer */

  const int *t = surface->mesh->triangles[triangle];
  lam_vec3 a = surface->mesh->vertices[t[0]];
  *normal = lam_unit(lam_cross(lam_sub(surface->mesh->vertices[t[1]], a),
                               lam_sub(surface->mesh->vertices[t[2]], a)));

  /* off the triangle's plane, the direction to the foot is the better normal: it serves edges and
   * borders too */
  lam_vec3 away = lam_sub(v, foot);
  if (lam_length(away) > 1e-9) *normal = lam_unit(away);
  return foot;
}

/* The block's update: every vertex gets the plane at its closest point. */
static void project(struct lam_block *block, const double *x, const int *offset, void *context) {
  for (int i = 0; i < block->count; i++) {
    lam_vec3 v = lam_local(x + offset[block->nodes[i]], 0), normal;
    lam_vec3 foot = closest_point(context, v, &normal);
    double *p = block->params + 6 * i;
    p[0] = foot.x, p[1] = foot.y, p[2] = foot.z;
    p[3] = normal.x, p[4] = normal.y, p[5] = normal.z;
  }
}

/* All vertices, softly. Without a reference: an error. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params;
  if (!scope->reference) {
    lam_error_add(scope->errors, location, "proximity",
                  "no reference is given; expected net.reference: {file: ...}");
    return;
  }

  lam_arena *arena = scope->problem->arena;
  int n = scope->net->mesh.vertex_count, *vertices = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++) vertices[v] = v;
  surface_context *context = LAM_NEW(arena, surface_context, 1);
  *context = (surface_context){scope->reference, scope->reference_mesh};

  lam_block block = {.name = "proximity", .kernel = to_plane, .rows = 1, .role = LAM_SOFT};
  block.weight = weight;
  block.count = n;
  block.arity = 1;
  block.nodes = vertices;
  block.param_count = 6;
  block.params = LAM_NEW(arena, double, 6 * n);
  block.update = project;
  block.context = context;
  lam_problem_add(scope->problem, block);
}

const lam_constraint_kind lam_con_proximity = {
    {"proximity", "Nearness to a reference",
     "Pulls the net onto a reference mesh while it may slide along it. Closest points are found on "
     "triangles, anew in every iteration. Pin something: fairness slides a free net tangentially.",
     "n.(v - P) -> small, P the closest point and n its normal", "thesis 3.7", NULL, 0},
    add};
