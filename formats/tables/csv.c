#include "formats/tables/csv.h"

#include <math.h>
#include <string.h>

static void separate(lam_text *out) {
  if (out->length && out->data[out->length - 1] != '\n') lam_text_add(out, ",");
}

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

void lam_csv_sheets(lam_text *out, const lam_model *model, int part) {
  const lam_part *first = &model->parts[part];
  separate(out);
  lam_text_add(out, first->name);
  for (int i = 0; i < model->part_count; i++) {
    const lam_part *other = &model->parts[i];
    if (i == part || first->group < 0 || other->group != first->group ||
        other->family != first->family || strcmp(other->kind, first->kind) != 0)
      continue;
    lam_text_printf(out, " %s", other->name);
  }
}
