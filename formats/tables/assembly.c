/* The order of assembly: a step per lamella, family A first, then family B, then everything else.
 * Family A is laid out with its slots up; every lamella of family B is lowered into them. */
#include "formats/format.h"
#include "formats/tables/csv.h"

#include <string.h>

static void header(lam_text *out) {
  static const char *const names[] = {"step",     "parts",  "family",  "kind",
                                      "quantity", "action", "splices", "crosses"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) lam_csv_text(out, names[i]);
  lam_csv_end_row(out);
}

/* Sheets of one lamella are handled together: true for the first of them. */
static bool leads(const lam_model *model, int index) {
  const lam_part *part = &model->parts[index];
  for (int i = 0; i < index && part->group >= 0; i++) {
    const lam_part *other = &model->parts[i];
    if (other->group == part->group && other->family == part->family &&
        strcmp(other->kind, part->kind) == 0)
      return false;
  }
  return true;
}

static bool same_lamella(const lam_part *a, const lam_part *b) {
  return a == b || (a->group >= 0 && a->group == b->group && a->family == b->family &&
                    strcmp(a->kind, b->kind) == 0);
}

/* Splices to close before the lamella can be set: its splices are one fewer than its pieces, per
 * sheet. */
static int splices(const lam_model *model, int index, int *sheets) {
  int pieces = 0;
  *sheets = 0;
  for (int i = 0; i < model->part_count; i++)
    *sheets += same_lamella(&model->parts[i], &model->parts[index]);
  for (int s = 0; s < model->sheet_count; s++)
    for (int k = 0; k < model->sheets[s].piece_count; k++) {
      int part = model->sheets[s].placed[k].part;
      pieces += part >= 0 && same_lamella(&model->parts[part], &model->parts[index]);
    }
  return pieces > *sheets ? pieces - *sheets : 0;
}

/* The lamellas of the other family, in order of the nodes along this one; "node:parts", separated
 * by semicolons. */
static void crosses(lam_text *out, const lam_model *model, int index) {
  const lam_part *part = &model->parts[index];
  lam_text list = {.arena = out->arena};
  double after = -1e300;
  for (;;) {
    int next = -1;
    for (int i = 0; i < model->crossing_count && part->family >= 0; i++) {
      const lam_crossing *node = &model->crossings[i];
      if (!same_lamella(&model->parts[node->parts[part->family]], part) ||
          node->along[part->family] <= after)
        continue;
      if (next < 0 || node->along[part->family] < model->crossings[next].along[part->family])
        next = i;
    }
    if (next < 0) break;
    lam_text sheets = {.arena = out->arena};
    lam_csv_sheets(&sheets, model, model->crossings[next].parts[1 - part->family]);
    lam_text_printf(&list, "%s%d: %s", list.length ? "; " : "", next + 1, sheets.data);
    after = model->crossings[next].along[part->family];
  }
  lam_csv_text(out, list.length ? list.data : "");
}

static const char *action(int family) {
  return family == 0   ? "lay out, slots up"
         : family == 1 ? "lower into the slots of family A"
                       : "fix at its nodes";
}

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

static int count_files(const lam_model *model) { return model->crossing_count > 0; }
static void path_of(const lam_model *model, int i, lam_text *path) {
  (void)model, (void)i;
  lam_text_add(path, "assembly.csv");
}

static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  static const int order[] = {0, 1, -1};
  int step = 0;
  (void)i;
  header(out);
  for (int f = 0; f < 3; f++)
    for (int p = 0; p < model->part_count; p++)
      if (model->parts[p].family == order[f] && leads(model, p)) row(out, model, p, ++step);
  return LAM_OK;
}

const lam_format lam_format_assembly = {
    .name = "assembly",
    .doc = "Order of assembly as CSV: numbered steps, family A, then family B, then what holds the "
           "nodes.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
