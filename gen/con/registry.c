/* The list of constraints. To add one: write its file, and add its line here. */
#include "con/constraint.h"

/* clang-format off */
#define CONSTRAINTS(row) \
  row(planar_star) \
  row(planar_face) \
  row(orthogonal) \
  row(angle) \
  row(edge_length) \
  row(boundary_length) \
  row(fairness) \
  row(closeness) \
  row(handle) \
  row(proximity) \
  row(glide) \
  row(opposite_edges) \
  row(spherical_star)
/* clang-format on */

#define DECLARE(name) extern const lam_constraint_kind lam_con_##name;
CONSTRAINTS(DECLARE)

#define POINT(name) &lam_con_##name.head,
static const lam_row_head *const rows[] = {CONSTRAINTS(POINT)};
static const lam_row_head *const rows[] = {
    &lam_con_planar_star.head,
    &lam_con_planar_face.head,
    &lam_con_orthogonal.head,
    &lam_con_angle.head,
    &lam_con_edge_length.head,
    &lam_con_boundary_length.head,
    &lam_con_fairness.head,
    &lam_con_closeness.head,
    &lam_con_handle.head,
    &lam_con_proximity.head,
    &lam_con_glide.head,
    &lam_con_opposite_edges.head,
    &lam_con_spherical_star.head,
    &lam_con_geodesic_parallel.head,
    &lam_con_opposite_angles.head,
    &lam_con_equal_angles.head,
    &lam_con_equal_edges.head,
    &lam_con_jacobi.head,
    &lam_con_strip_widths.head,
};

const lam_registry lam_constraints = {"constraints", "constraint", rows, sizeof rows / sizeof *rows};
