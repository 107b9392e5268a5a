/* Comma-separated values as in RFC 4180: a header row, CRLF at the end of rows, quotes only where
 * needed, decimal points. */
#ifndef LAM_FORMATS_TABLES_CSV_H
#define LAM_FORMATS_TABLES_CSV_H

#include "core/model.h"
#include "core/text.h"

/* One field each; the comma before it is written when the row has begun. */
void lam_csv_text(lam_text *out, const char *string);
void lam_csv_integer(lam_text *out, long value);
/* An empty field when value is not finite. */
void lam_csv_number(lam_text *out, double value, int decimals);
void lam_csv_empty(lam_text *out);
void lam_csv_end_row(lam_text *out);

/* The sheets of the lamella that parts[part] belongs to, separated by spaces, as one field: "A07a
 * A07b". */
void lam_csv_sheets(lam_text *out, const lam_model *model, int part);

#endif
