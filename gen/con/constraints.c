/* The list of constraints: net/net_keys.c looks up those that a design asks for, and the reference
 * pages are made from it (library/reference). To add one: write its file, and add its line here;
 * declare it in constraint.h when nets are made of it. */
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
  row(spherical_star) \
  row(geodesic_parallel) \
  row(opposite_angles) \
  row(equal_angles) \
  row(equal_edges) \
  row(jacobi) \
  row(strip_widths) \
  row(circular) \
  row(conical) \
  row(isothermic) \
  row(s_isothermic)
/* clang-format on */

#define DECLARE(name) extern const lam_constraint_kind lam_con_##name;
CONSTRAINTS(DECLARE)

#define POINT(name) &lam_con_##name.head,
static const lam_row_head *const rows[] = {CONSTRAINTS(POINT)};

const lam_registry lam_constraints = {"constraints", "constraint", rows,
                                      sizeof rows / sizeof *rows};
