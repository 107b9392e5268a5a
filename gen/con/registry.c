#include "con/constraint.h"

static const lam_row_head *const rows[] = {
    &lam_con_planar_star.head,    &lam_con_planar_face.head,     &lam_con_orthogonal.head, &lam_con_angle.head,
    &lam_con_edge_length.head,    &lam_con_boundary_length.head, &lam_con_fairness.head,   &lam_con_closeness.head,
    &lam_con_handle.head,         &lam_con_proximity.head,       &lam_con_glide.head,      &lam_con_opposite_edges.head,
    &lam_con_spherical_star.head,
};

const lam_registry lam_constraints = {"constraints", "constraint", rows, sizeof rows / sizeof *rows};
