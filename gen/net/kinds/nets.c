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

/* The names of all nets that have a form with auxiliary unknowns, with commas between. */
static const char *nets_of_thesis(lam_arena *arena) {
  const char *names = "";
  for (int i = 0; i < lam_nets.count; i++)
    if (((const lam_net_kind *)lam_nets.rows[i])->constrain_thesis)
      names = lam_arena_printf(arena, "%s%s%s", names, *names ? ", " : "", lam_nets.rows[i]->name);
  return names;
}

bool lam_net_method_check(const lam_net_kind *kind, const lam_net_common *common,
                          lam_location location, lam_errors *errors) {
  if (common->solver.method != LAM_METHOD_THESIS || kind->constrain_thesis) return true;
  lam_error_add(errors, location, "net.solver",
                "thesis, but %s has no form with auxiliary unknowns; expected lamella, or one of "
                "the nets %s",
                kind->head.name, nets_of_thesis(errors->arena));
  return false;
}
