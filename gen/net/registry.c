#include "net/kind.h"

extern const lam_net_kind lam_net_asymptotic, lam_net_planar_quads, lam_net_free;
extern const lam_net_kind lam_net_chebyshev, lam_net_isogonal, lam_net_s_net, lam_net_cmc, lam_net_k_net;

static const lam_row_head *const rows[] = {
    &lam_net_asymptotic.head, &lam_net_planar_quads.head, &lam_net_chebyshev.head, &lam_net_isogonal.head,
    &lam_net_s_net.head,      &lam_net_cmc.head,          &lam_net_k_net.head,     &lam_net_free.head,
};

const lam_registry lam_nets = {"nets", "net", rows, sizeof rows / sizeof *rows};
