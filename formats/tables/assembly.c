/* The order of assembly (assembly.csv; listed in formats/list/formats.c): a step per lamella,
 * family A first, then family B, then everything else. Family A is laid out with its slots up;
 * every lamella of family B is lowered into them. */
#include "formats/format.h"
#include "formats/tables/csv.h"

#include <string.h>

static const char *const columns[] = {"step",     "parts",  "family",  "kind",
                                      "quantity", "action", "splices", "crosses"};

/* Whether a part is the first of its lamella: the sheets of one are handled together, in one
 * step. */
static bool leads(const lam_model *model, int index) {
  for (int i = 0; i < index; i++)
    if (lam_csv_same_lamella(&model->parts[i], &model->parts[index])) return false;
  return true;
}

/* How many splices must be closed before the lamella of a part can be set: a sheet in n pieces
 * has n - 1. sheets: how many sheets (layers) the lamella has; its pieces are counted on the
 * cutting sheets. */
static int splices(const lam_model *model, int index, int *sheets) {
  int pieces = 0;
  *sheets = 0;
  for (int i = 0; i < model->part_count; i++)
    *sheets += lam_csv_same_lamella(&model->parts[i], &model->parts[index]);

  for (int s = 0; s < model->sheet_count; s++)
    for (int k = 0; k < model->sheets[s].piece_count; k++) {
      int part = model->sheets[s].placed[k].part;
      pieces += part >= 0 && lam_csv_same_lamella(&model->parts[part], &model->parts[index]);
    }
  return pieces > *sheets ? pieces - *sheets : 0;
}

/* The node that comes next along the lamella of a part, behind the arc length `after` (meters); -1:
 * none, or the part belongs to no family. */
static int next_node(const lam_model *model, const lam_part *part, double after) {
  int next = -1;
  for (int i = 0; i < model->crossing_count && part->family >= 0; i++) {
    const lam_crossing *node = &model->crossings[i];
    double along = node->along[part->family];
    if (!lam_csv_same_lamella(&model->parts[node->parts[part->family]], part) || along <= after)
      continue;
    if (next < 0 || along < model->crossings[next].along[part->family]) next = i;
  }
  return next;
}

/* The field `crosses`: the lamellas of the other family, in order of the nodes along this one, as
 * "node:parts" separated by semicolons. Nodes count from 1, as in nodes.csv. */
static void crosses(lam_text *out, const lam_model *model, int index) {
  const lam_part *part = &model->parts[index];
  lam_text list = {.arena = out->arena};
  double after = -1e300; /* before all */

  for (int node; (node = next_node(model, part, after)) >= 0;) {
    const lam_crossing *crossing = &model->crossings[node];
    lam_text sheets = {.arena = out->arena};
    lam_csv_sheets(&sheets, model, crossing->parts[1 - part->family]);
    lam_text_printf(&list, "%s%d: %s", list.length ? "; " : "", node + 1, sheets.data);
    after = crossing->along[part->family];
  }
  lam_csv_text(out, list.length ? list.data : "");
}

/* What is done with a lamella of a family, in a few words. */
static const char *action(int family) {
  return family == 0   ? "lay out, slots up"
         : family == 1 ? "lower into the slots of family A"
                       : "fix at its nodes";
}

/* A step: the lamella that parts[index] stands for. Parts of no family have no splices to close. */
static void row(lam_text *out, const lam_model *model, int index, int step) {
  const lam_part *part = &model->parts[index];
  int sheets, joints = splices(model, index, &sheets);
  bool strip = part->family == 0 || part->family == 1;

  lam_csv_integer(out, step);
  lam_csv_sheets(out, model, index);
  lam_csv_text(out, part->family == 0 ? "A" : part->family == 1 ? "B" : "");
  lam_csv_text(out, part->kind ? part->kind : "");
  lam_csv_integer(out, part->instance_count > 0 ? part->instance_count : sheets);
  lam_csv_text(out, action(part->family));
  lam_csv_integer(out, strip ? joints : 0);
  crosses(out, model, index);
  lam_csv_end_row(out);
}

/* One file, when there are nodes. */
static int count_files(const lam_model *model) { return model->crossing_count > 0; }
static void path_of(const lam_model *model, int i, lam_text *path) {
  (void)model, (void)i;
  lam_text_add(path, "assembly.csv");
}

/* Steps are numbered from 1, family by family. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  static const int order[] = {0, 1, -1};
  int step = 0;
  (void)i;
  lam_csv_header(out, columns, sizeof columns / sizeof *columns);
  for (int f = 0; f < 3; f++)
    for (int p = 0; p < model->part_count; p++)
      if (model->parts[p].family == order[f] && leads(model, p)) row(out, model, p, ++step);
  return LAM_OK;
}

const lam_format lam_format_assembly = {
    .name = "assembly",
    .doc = "Order of assembly as CSV: numbered steps, family A, then family B, then what holds "
           "the nodes.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
