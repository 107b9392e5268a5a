/* Comma-separated values as in RFC 4180: a header row, CRLF at the end of rows, quotes only where
 * needed, decimal points. For the tables beside it: assembly.c, bom.c and nodes.c. */
#ifndef LAM_FORMATS_TABLES_CSV_H
#define LAM_FORMATS_TABLES_CSV_H

#include "core/model.h"
#include "core/text.h"

/* The first row: count names of columns. */
void lam_csv_header(lam_text *out, const char *const *names, int count);
/* One field each, UTF-8; the comma before it is written when the row has begun. */
void lam_csv_text(lam_text *out, const char *string);
void lam_csv_integer(lam_text *out, long value);
/* With at most so many decimals; an empty field when value is not finite. */
void lam_csv_number(lam_text *out, double value, int decimals);
void lam_csv_empty(lam_text *out);
void lam_csv_end_row(lam_text *out);

/* Whether two parts are sheets of one lamella: of the same group (>= 0), family and kind, or one
 * part. */
bool lam_csv_same_lamella(const lam_part *a, const lam_part *b);
/* The names of all sheets of the lamella that parts[part] belongs to, that one first, separated
 * by spaces, as one field: "A07a A07b". */
void lam_csv_sheets(lam_text *out, const lam_model *model, int part);

#endif
