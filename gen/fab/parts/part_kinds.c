/* The list of all kinds of parts, those of fab/lamella too: the registry that the key `parts` of
 * a design chooses from. To add one: write its file, and add its line here. */
#include "fab/workshop.h"

/* clang-format off */
#define PARTS(row) \
  row(lamella) \
  row(node_connector) \
  row(panels) \
  row(bars) \
  row(support) \
  row(circles) \
  row(gauss_image) \
  row(flat_pattern) \
  row(skin) \
  row(frames)
/* clang-format on */

#define DECLARE(name) extern const lam_part_kind lam_part_##name;
PARTS(DECLARE)

#define POINT(name) &lam_part_##name.head,
static const lam_row_head *const rows[] = {PARTS(POINT)};

const lam_registry lam_part_kinds = {"parts", "part", rows, sizeof rows / sizeof rows[0]};
