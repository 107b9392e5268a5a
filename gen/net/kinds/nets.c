/* The list of nets, read through lam_nets by design, library, cli and net/optimize.c. To add one:
 * write its file, and add its line here. */
#include "net/net_kind.h"

/* clang-format off */
#define NETS(row) \
  row(asymptotic) \
  row(planar_quads) \
  row(circular) \
  row(conical) \
  row(isothermic) \
  row(s_isothermic) \
  row(isogonal_molding) \
  row(chebyshev) \
  row(isogonal) \
  row(s_net) \
  row(cmc) \
  row(k_net) \
  row(geodesic_parallel) \
  row(geodesic) \
  row(voss) \
  row(dog) \
  row(dig) \
  row(free)
/* clang-format on */

#define DECLARE(name) extern const lam_net_kind lam_net_##name;
NETS(DECLARE)

#define POINT(name) &lam_net_##name.head,
static const lam_row_head *const rows[] = {NETS(POINT)};

const lam_registry lam_nets = {"nets", "net", rows, sizeof rows / sizeof *rows};
