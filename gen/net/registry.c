/* The list of nets. To add one: write its file, and add its line here. */
#include "net/kind.h"

/* clang-format off */
#define NETS(row) \
  row(asymptotic) \
  row(planar_quads) \
  row(chebyshev) \
  row(isogonal) \
  row(s_net) \
  row(cmc) \
  row(k_net) \
  row(free)
/* clang-format on */

#define DECLARE(name) extern const lam_net_kind lam_net_##name;
NETS(DECLARE)

#define POINT(name) &lam_net_##name.head,
static const lam_row_head *const rows[] = {NETS(POINT)};
extern const lam_net_kind lam_net_asymptotic, lam_net_planar_quads, lam_net_free;
extern const lam_net_kind lam_net_chebyshev, lam_net_isogonal, lam_net_s_net, lam_net_cmc, lam_net_k_net;
extern const lam_net_kind lam_net_geodesic_parallel, lam_net_geodesic, lam_net_voss, lam_net_dog, lam_net_dig;

static const lam_row_head *const rows[] = {
    &lam_net_asymptotic.head,
    &lam_net_planar_quads.head,
    &lam_net_chebyshev.head,
    &lam_net_isogonal.head,
    &lam_net_s_net.head,
    &lam_net_cmc.head,
    &lam_net_k_net.head,
    &lam_net_geodesic_parallel.head,
    &lam_net_geodesic.head,
    &lam_net_voss.head,
    &lam_net_dog.head,
    &lam_net_dig.head,
    &lam_net_free.head,
};

const lam_registry lam_nets = {"nets", "net", rows, sizeof rows / sizeof *rows};
