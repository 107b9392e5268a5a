/* Distances between two meshes from samples of their surfaces. Called by
 * net/measures/reference_measures.c and library/compare_meshes.c. */
#include "core/solid/solid.h"

#include <stdlib.h>

/* The largest distance from samples of one mesh to another. */
typedef struct farthest {
  const lam_tree *other;
  double distance;
  bool failed;
} farthest;

/* Takes one point into account. */
static void sample(farthest *f, lam_vec3 p) {
  lam_vec3 closest;
  int triangle;
  lam_tree_closest(f->other, p, &closest, &triangle);
  f->failed = f->failed || triangle < 0;
  f->distance = fmax(f->distance, lam_distance(p, closest));
}

/* Rows of samples parallel to the longest edge, from it to the opposite corner; rows, and samples
 * in a row, are at most `spacing` apart. The corners are left out: every vertex is sampled once. */
static void sample_triangle(farthest *f, const lam_vec3 corners[3], double spacing) {
  /* The longest edge: from corner k. */
  int k = 0;
  double length = 0;
  for (int l = 0; l < 3; l++) {
    double edge = lam_distance(corners[l], corners[(l + 1) % 3]);
    if (edge > length) {
      length = edge;
      k = l;
    }
  }

  lam_vec3 a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
  double height = length > 0 ? lam_length(lam_cross(lam_sub(b, a), lam_sub(c, a))) / length : 0;
  double rows = fmax(1, ceil(height / spacing));

  for (double r = 0; r < rows && !f->failed; r++) {
    lam_vec3 p = lam_mix(a, c, r / rows), q = lam_mix(b, c, r / rows);
    double steps = fmax(1, ceil(length * (1 - r / rows) / spacing)), inset = r == 0;
    for (double s = inset; s <= steps - inset && !f->failed; s++)
      sample(f, lam_mix(p, q, s / steps));
  }
}

/* The largest distance from a mesh to a tree. sampled: per vertex of `from`, all false. */
static double one_way(const lam_trimesh *from, const lam_tree *to, double spacing, bool *sampled,
                      bool *failed) {
  farthest f = {.other = to};

  for (int i = 0; i < from->triangle_count && !f.failed; i++) {
    lam_vec3 corners[3];
    for (int k = 0; k < 3; k++) {
      int v = from->triangles[i][k];
      corners[k] = from->vertices[v];
      if (!sampled[v]) sample(&f, corners[k]);
      sampled[v] = true;
    }
    sample_triangle(&f, corners, spacing);
  }

  *failed = *failed || f.failed;
  return f.distance;
}

/* The trees are made first: that checks both meshes. */
lam_status lam_solid_hausdorff(const lam_trimesh *a, const lam_trimesh *b, double spacing,
                               double *a_to_b, double *b_to_a) {
  if (!(spacing > 0)) return LAM_BAD_INPUT;

  bool failed = false;
  lam_status status;
  lam_tree *tree_a = lam_tree_new(a, &status), *tree_b = tree_a ? lam_tree_new(b, &status) : NULL;
  bool *sampled_a = calloc((size_t)a->vertex_count + 1, sizeof(bool));
  bool *sampled_b = calloc((size_t)b->vertex_count + 1, sizeof(bool));

  if (tree_b && sampled_a && sampled_b) {
    *a_to_b = one_way(a, tree_b, spacing, sampled_a, &failed);
    *b_to_a = one_way(b, tree_a, spacing, sampled_b, &failed);
  }

  bool ran_out = status == LAM_NO_MEMORY || !sampled_a || !sampled_b || lam_tree_ran_out(tree_a) ||
                 lam_tree_ran_out(tree_b);
  status = ran_out ? LAM_NO_MEMORY : failed || !tree_b ? LAM_FAILED : LAM_OK;
  free(sampled_a);
  free(sampled_b);
  lam_tree_free(tree_a);
  lam_tree_free(tree_b);
  return status;
}
