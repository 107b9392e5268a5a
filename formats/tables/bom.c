/* The bill of materials (bom.csv; listed in formats/list/formats.c): a row per part, then a row per
 * kind of splice plate. Lengths in millimeters, masses in kilograms. */
#include "formats/format.h"
#include "formats/tables/csv.h"

#include <string.h>

static const char *const columns[] = {"part",       "kind",         "family",      "quantity",
                                      "congruence", "length_mm",    "height_mm",   "thickness_mm",
                                      "material",   "mass_each_kg", "mass_all_kg", "slots",
                                      "slots_open", "pieces",       "sheets"};

/* A positive number, or an empty field. */
static void positive(lam_text *out, double value, int decimals) {
  if (value > 0)
    lam_csv_number(out, value, decimals);
  else
    lam_csv_empty(out);
}

/* Which way the slots of a strip open, told from the first: "up" when it reaches the upper edge,
 * which is half the height away from the axis. Empty for parts without slots. */
static const char *opening(const lam_flat *flat) {
  if (!flat || !flat->slot_count) return "";
  return flat->slots[0].top >= flat->height / 2 ? "up" : "down";
}

/* How many pieces of a part lie on sheets, and the names of those sheets. part -1: of splice
 * plates with this label, on sheets of the same material and thickness as `like`. label and like
 * may be NULL: any. */
static int find_pieces(const lam_model *model, int part, const char *label, const lam_sheet *like,
                       lam_text *names) {
  int pieces = 0;
  for (int i = 0; i < model->sheet_count; i++) {
    const lam_sheet *sheet = &model->sheets[i];
    int here = 0;
    if (like && (sheet->material != like->material || sheet->thickness != like->thickness))
      continue;

    for (int k = 0; k < sheet->piece_count; k++)
      here +=
          sheet->placed[k].part == part && (!label || strcmp(sheet->placed[k].label, label) == 0);

    if (here) lam_text_printf(names, "%s%s", names->length ? " " : "", sheet->name);
    pieces += here;
  }
  return pieces;
}

/* A row of the table, in the order of its columns. A part with instances counts as many as it
 * has. */
static void part_row(lam_text *out, const lam_model *model, int index) {
  const lam_part *part = &model->parts[index];
  const lam_flat *flat = part->flat;
  int quantity = part->instance_count > 0 ? part->instance_count : 1;
  lam_text sheets = {.arena = out->arena};
  int pieces = find_pieces(model, index, NULL, NULL, &sheets);

  lam_csv_text(out, part->name);
  lam_csv_text(out, part->kind ? part->kind : "");
  lam_csv_text(out, part->family == 0 ? "A" : part->family == 1 ? "B" : "");
  lam_csv_integer(out, quantity);
  positive(out, part->congruence, 0);
  positive(out, part->length * 1e3, 3);
  positive(out, flat ? flat->height * 1e3 : 0, 3);
  positive(out, flat ? flat->thickness * 1e3 : 0, 3);
  lam_csv_text(out, part->material ? part->material->name : "");
  positive(out, part->mass, 6);
  positive(out, part->mass * quantity, 6);
  lam_csv_integer(out, flat ? flat->slot_count : 0);
  lam_csv_text(out, opening(flat));
  lam_csv_integer(out, pieces);
  lam_csv_text(out, sheets.length ? sheets.data : "");
  lam_csv_end_row(out);
}

/* The row of one kind of splice plate; plate is the first of its kind, lying on sheet. */
static void plate_row(lam_text *out, const lam_model *model, const lam_sheet *sheet,
                      const lam_sheet_piece *plate) {
  lam_text sheets = {.arena = out->arena};
  int quantity = find_pieces(model, -1, plate->label, sheet, &sheets);
  double mass = sheet->material ? plate->area * sheet->thickness * sheet->material->density : 0;

  lam_csv_text(out, plate->label);
  lam_csv_text(out, "splice-plate");
  lam_csv_empty(out);
  lam_csv_integer(out, quantity);
  lam_csv_empty(out);
  positive(out, plate->length * 1e3, 3);
  lam_csv_empty(out);
  positive(out, sheet->thickness * 1e3, 3);
  lam_csv_text(out, sheet->material ? sheet->material->name : "");
  positive(out, mass, 6);
  positive(out, mass * quantity, 6);
  lam_csv_integer(out, 0);
  lam_csv_empty(out);
  lam_csv_integer(out, quantity);
  lam_csv_text(out, sheets.data);
  lam_csv_end_row(out);
}

/* Whether a plate of this label, material and thickness comes before placed[k] of sheet s: it has
 * its row already. */
static bool seen_before(const lam_model *model, int s, int k) {
  const lam_sheet *sheet = &model->sheets[s];
  for (int i = 0; i <= s; i++) {
    const lam_sheet *other = &model->sheets[i];

    if (other->material != sheet->material || other->thickness != sheet->thickness) continue;

    for (int j = 0; j < (i < s ? other->piece_count : k); j++)
      if (other->placed[j].part < 0 && strcmp(other->placed[j].label, sheet->placed[k].label) == 0)
        return true;
  }
  return false;
}

static int count_files(const lam_model *model) { return model->part_count > 0; }
static void path_of(const lam_model *model, int i, lam_text *path) {
  (void)model, (void)i;
  lam_text_add(path, "bom.csv");
}

/* Parts in the order of the model; plates in the order in which they lie on the sheets. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_csv_header(out, columns, sizeof columns / sizeof *columns);
  for (int p = 0; p < model->part_count; p++) part_row(out, model, p);

  for (int s = 0; s < model->sheet_count; s++)
    for (int k = 0; k < model->sheets[s].piece_count; k++) {
      const lam_sheet_piece *placed = &model->sheets[s].placed[k];
      if (placed->part < 0 && !seen_before(model, s, k))
        plate_row(out, model, &model->sheets[s], placed);
    }
  return LAM_OK;
}

const lam_format lam_format_bom = {
    .name = "bom",
    .doc = "Bill of materials as CSV: part, quantity, congruence class, sizes, mass, slots, "
           "pieces and the sheets they lie on.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
