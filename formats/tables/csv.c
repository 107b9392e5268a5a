/* Fields and rows of comma-separated values, for the tables of this folder. */
#include "formats/tables/csv.h"

#include <math.h>
#include <string.h>

/* The comma before a field, unless it is the first of its row. */
static void separate(lam_text *out) {
  if (out->length && out->data[out->length - 1] != '\n') lam_text_add(out, ",");
}

void lam_csv_header(lam_text *out, const char *const *names, int count) {
  for (int i = 0; i < count; i++) lam_csv_text(out, names[i]);
  lam_csv_end_row(out);
}

/* In quotes when it holds a comma, a quote or a line break; quotes inside are doubled. */
void lam_csv_text(lam_text *out, const char *string) {
  separate(out);
  if (!strpbrk(string, ",\"\r\n")) {
    lam_text_add(out, string);
    return;
  }

  lam_text_add(out, "\"");
  for (; *string; string++) {
    if (*string == '"') lam_text_add(out, "\"");
    lam_text_bytes(out, string, 1);
  }
  lam_text_add(out, "\"");
}

void lam_csv_integer(lam_text *out, long value) {
  separate(out);
  lam_text_printf(out, "%ld", value);
}

void lam_csv_number(lam_text *out, double value, int decimals) {
  separate(out);
  if (isfinite(value)) lam_text_number(out, value, decimals);
}

void lam_csv_empty(lam_text *out) { separate(out); }

void lam_csv_end_row(lam_text *out) { lam_text_add(out, "\r\n"); }

bool lam_csv_same_lamella(const lam_part *a, const lam_part *b) {
  return a == b || (a->group >= 0 && a->group == b->group && a->family == b->family &&
                    strcmp(a->kind, b->kind) == 0);
}

/* The part itself first, then the others in the order of the model. */
void lam_csv_sheets(lam_text *out, const lam_model *model, int part) {
  const lam_part *first = &model->parts[part];
  separate(out);
  lam_text_add(out, first->name);
  for (int i = 0; i < model->part_count; i++) {
    const lam_part *other = &model->parts[i];
    if (i != part && lam_csv_same_lamella(first, other)) lam_text_printf(out, " %s", other->name);
  }
}
