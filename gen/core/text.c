/* A growing byte buffer with numbers that look the same everywhere. Called by the writers of
 * formats/, by library/ and by the messages of design/. */
#include "core/text.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- bytes ---- */

/* Where the next count bytes and a zero behind them fit: the buffer is moved into one of at least
 * twice the size when they do not. length stays. */
static char *make_room(lam_text *text, size_t count) {
  if (text->capacity - text->length <= count) {
    size_t capacity = text->capacity ? text->capacity * 2 : 4096;
    while (capacity - text->length <= count) capacity *= 2;

    char *data = lam_arena_alloc(text->arena, capacity, 1);
    if (text->length) memcpy(data, text->data, text->length);
    text->data = data;
    text->capacity = capacity;
  }
  return text->data + text->length;
}

/* The zero behind the text is written each time: data is a C string at any moment. */
void lam_text_bytes(lam_text *text, const void *bytes, size_t count) {
  char *room = make_room(text, count);
  if (count) memcpy(room, bytes, count);
  room[count] = 0;
  text->length += count;
}

void lam_text_add(lam_text *text, const char *string) {
  lam_text_bytes(text, string, strlen(string));
}

/* A first pass measures, a second one writes into the buffer itself. */
void lam_text_printf(lam_text *text, const char *format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  assert(length >= 0);

  vsnprintf(make_room(text, (size_t)length), (size_t)length + 1, format, again);
  va_end(again);
  text->length += (size_t)length;
}

/* By the first byte: how many there are, and the least number that needs so many. What follows has
 * six bits each. */
int lam_utf8_size(const char *string) {
  static const struct {
    unsigned char mask, head;
    unsigned least;
  } forms[] = {{0x80, 0, 1}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};
  const unsigned char *byte = (const unsigned char *)string;
  for (int extra = 0; extra < 4; extra++) {
    if ((byte[0] & forms[extra].mask) != forms[extra].head) continue;
    unsigned code = byte[0] & (unsigned char)~forms[extra].mask;
    for (int i = 1; i <= extra; i++) {
      if ((byte[i] & 0xc0) != 0x80) return 0;
      code = code << 6 | (byte[i] & 0x3f);
    }

    bool surrogate = code >= 0xd800 && code < 0xe000, none = code == 0xfffe || code == 0xffff;
    return code >= forms[extra].least && code <= 0x10ffff && !surrogate && !none ? extra + 1 : 0;
  }
  return 0;
}

/* Below the space are control characters. */
void lam_text_quoted(lam_text *text, const char *string) {
  lam_text_bytes(text, "\"", 1);
  for (int size; *string; string += size ? size : 1) {
    size = lam_utf8_size(string);
    if ((unsigned char)*string < ' ') continue;
    if (*string == '"' || *string == '\\') lam_text_bytes(text, "\\", 1);
    lam_text_bytes(text, size ? string : "?", size ? (size_t)size : 1);
  }
  lam_text_bytes(text, "\"", 1);
}

/* ---- numbers ---- */

/* 400 characters hold the largest double (309 digits) with 80 decimals and more. */
void lam_text_number(lam_text *text, double value, int decimals) {
  assert(isfinite(value) && decimals >= 0);
  char digits[400];
  int length = snprintf(digits, sizeof digits, "%.*f", decimals, value);
  for (int i = 0; i < length; i++)
    if (digits[i] == ',') digits[i] = '.'; /* a locale's decimal comma */

  /* Without decimals there is no point, and zeros at the end belong to the number. */
  if (decimals) {
    while (digits[length - 1] == '0') length--;
    if (digits[length - 1] == '.') length--;
  }

  /* What rounds to zero from below is zero. */
  if (length == 2 && digits[0] == '-' && digits[1] == '0') {
    digits[0] = '0';
    length = 1;
  }
  lam_text_bytes(text, digits, (size_t)length);
}

/* The shortest significant digits of |value| that read back as the same double, without trailing
 * zeros but at least one, zero-terminated in digits; returns their number. |value| is
 * d.ddd * 10^exponent. 17 digits are always enough. */
static int shortest_digits(double value, char digits[24], int *exponent) {
  char scientific[40];
  int precision = 0;
  do snprintf(scientific, sizeof scientific, "%.*e", precision, fabs(value));
  while (precision++ < 16 && strtod(scientific, NULL) != fabs(value));

  int count = 0;
  const char *at = scientific;
  for (; *at != 'e'; at++)
    if (*at >= '0' && *at <= '9') digits[count++] = *at; /* passes over a locale's decimal sign */
  *exponent = atoi(at + 1);

  while (count > 1 && digits[count - 1] == '0') count--;
  digits[count] = 0;
  return count;
}

/* Positional between 1e-4 and 1e16, with an exponent otherwise. */
void lam_text_real(lam_text *text, double value) {
  assert(isfinite(value));
  char digits[24];
  int exponent, count = shortest_digits(value, digits, &exponent);

  if (value < 0) lam_text_add(text, "-");
  if (exponent < -4 || exponent > 15) {
    lam_text_printf(text, "%c.%sE%d", digits[0], count > 1 ? digits + 1 : "0", exponent);
    return;
  }

  /* Below 1: zeros between the point and the digits. */
  if (exponent < 0) lam_text_printf(text, "0.%.*s%s", -exponent - 1, "0000", digits);

  /* From 1 on: the point stands behind digit `exponent`. Zeros fill up what the digits leave open,
   * as far as one decimal. */
  for (int i = 0; exponent >= 0 && (i < count || i <= exponent + 1); i++) {
    if (i == exponent + 1) lam_text_add(text, ".");
    lam_text_bytes(text, i < count ? digits + i : "0", 1);
  }
}

/* ---- little-endian binary ---- */

void lam_text_u16(lam_text *text, uint16_t value) {
  unsigned char bytes[2] = {(unsigned char)value, (unsigned char)(value >> 8)};
  lam_text_bytes(text, bytes, 2);
}

void lam_text_u32(lam_text *text, uint32_t value) {
  unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8),
                            (unsigned char)(value >> 16), (unsigned char)(value >> 24)};
  lam_text_bytes(text, bytes, 4);
}

void lam_text_f32(lam_text *text, float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  lam_text_u32(text, bits);
}
