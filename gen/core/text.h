/* A growing byte buffer: every writer of formats/ writes into one, and library/ writes it to disk;
 * messages of design/ are put together in one. Numbers are formatted the same way on every machine
 * and under every locale. */
#ifndef LAM_CORE_TEXT_H
#define LAM_CORE_TEXT_H

#include "core/arena.h"
#include <stdbool.h>
#include <stdint.h>

/* Begins zeroed but for arena. A copy of the struct writes into the same data: only one of the two
 * may be added to. */
typedef struct lam_text {
  lam_arena *arena; /* owns data */
  char *data;       /* length bytes, followed by a zero that is not counted; NULL while empty */
  size_t length, capacity;
} lam_text;

/* ---- text ---- */

/* Appends a zero-terminated string. */
void lam_text_add(lam_text *text, const char *string);
/* Appends count bytes, which may include zeros. bytes may be NULL when count is 0. */
void lam_text_bytes(lam_text *text, const void *bytes, size_t count);
/* Appends a string formatted as by printf. Numbers with a decimal sign belong into lam_text_number
 * or lam_text_real: printf writes the locale's. */
void lam_text_printf(lam_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Appends string in double quotes, with \ and " escaped by a backslash, control characters dropped;
 * bytes that are no UTF-8, as names of files may have them, become question marks. */
void lam_text_quoted(lam_text *text, const char *string);
/* How many bytes the character at string takes in UTF-8 (1 to 4); 0 when there is none: the string
 * ends, its bytes are no UTF-8 (RFC 3629), or stand for U+FFFE or U+FFFF, which are none. */
int lam_utf8_size(const char *string);

/* ---- numbers ---- */

/* Appends value with at most the given number of decimals, 0 to 80. Trailing zeros are dropped, and
 * the point when no decimal is left; what rounds to zero is "0", never "-0". The decimal sign is a
 * point in every locale; never an exponent. value must be finite. */
void lam_text_number(lam_text *text, double value, int decimals);
/* Appends the shortest decimal number that reads back as the same double: 0.25, -12.0, 1.5E-7.
 * Always with a decimal point and a digit on both sides of it, the exponent with an upper-case E:
 * what JSON, STEP and IGES all read. -0 is written as 0.0. value must be finite. */
void lam_text_real(lam_text *text, double value);

/* ---- little-endian binary ---- */

/* Each appends 2, 4 or 4 bytes; f32 is the IEEE single-precision format. */
void lam_text_u16(lam_text *text, uint16_t value);
void lam_text_u32(lam_text *text, uint32_t value);
void lam_text_f32(lam_text *text, float value);

#endif
