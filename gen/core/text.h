/* A growing byte buffer: every writer writes into one, and the program writes it to disk. Numbers
 * are formatted the same way on every machine and under every locale. */
#ifndef LAM_CORE_TEXT_H
#define LAM_CORE_TEXT_H

#include "core/arena.h"
#include <stdbool.h>
#include <stdint.h>

typedef struct lam_text {
  lam_arena *arena; /* owns data */
  char *data;       /* length bytes, followed by a zero that is not counted; NULL while empty */
  size_t length, capacity;
} lam_text;

void lam_text_add(lam_text *text, const char *string);
void lam_text_bytes(lam_text *text, const void *bytes, size_t count);
void lam_text_printf(lam_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* value with at most the given number of decimals: trailing zeros and "-0" are dropped; always a
 * decimal point, never an exponent. value must be finite. */
void lam_text_number(lam_text *text, double value, int decimals);
/* The shortest decimal number that reads back as the same double: 0.25, -12.0, 1.5E-7. Always with
 * a decimal point and a digit on both sides of it, the exponent with an upper-case E: what JSON,
 * STEP and IGES all read. value must be finite. */
void lam_text_real(lam_text *text, double value);
/* string in double quotes, with \ and " escaped by a backslash, control characters dropped. */
void lam_text_quoted(lam_text *text, const char *string);
/* Little-endian binary. */
void lam_text_u16(lam_text *text, uint16_t value);
void lam_text_u32(lam_text *text, uint32_t value);
void lam_text_f32(lam_text *text, float value);

#endif
