/* The list of nets. To add one: write its file, and add its line here. */
#include "net/kind.h"

extern const lam_net_kind lam_net_asymptotic, lam_net_planar_quads, lam_net_free;
extern const lam_net_kind lam_net_circular, lam_net_conical, lam_net_isothermic, lam_net_s_isothermic,
    lam_net_isogonal_molding;

static const lam_row_head *const rows[] = {
    &lam_net_asymptotic.head, &lam_net_planar_quads.head, &lam_net_circular.head,         &lam_net_conical.head,
    &lam_net_isothermic.head, &lam_net_s_isothermic.head, &lam_net_isogonal_molding.head, &lam_net_free.head,
};
/* clang-format off */
#define NETS(row) \
  row(asymptotic) \
  row(planar_quads) \
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
  row(circular) \
  row(conical) \
  row(isothermic) \
  row(s_isothermic) \
  row(free)
/* clang-format on */

#define DECLARE(name) extern const lam_net_kind lam_net_##name;
NETS(DECLARE)

#define POINT(name) &lam_net_##name.head,
static const lam_row_head *const rows[] = {NETS(POINT)};

const lam_registry lam_nets = {"nets", "net", rows, sizeof rows / sizeof *rows};
