#include "core/text.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

void lam_text_bytes(lam_text *text, const void *bytes, size_t count) {
  char *room = make_room(text, count);
  if (count) memcpy(room, bytes, count);
  room[count] = 0;
  text->length += count;
}

void lam_text_add(lam_text *text, const char *string) {
  lam_text_bytes(text, string, strlen(string));
}

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

void lam_text_number(lam_text *text, double value, int decimals) {
  assert(isfinite(value) && decimals >= 0);
  char digits[400];
  int length = snprintf(digits, sizeof digits, "%.*f", decimals, value);
  for (int i = 0; i < length; i++)
    if (digits[i] == ',') digits[i] = '.'; /* a locale's decimal comma */
  if (decimals) {
    while (digits[length - 1] == '0') length--;
    if (digits[length - 1] == '.') length--;
  }
  if (length == 2 && digits[0] == '-' && digits[1] == '0') {
    digits[0] = '0';
    length = 1;
  }
  lam_text_bytes(text, digits, (size_t)length);
}

void lam_text_real(lam_text *text, double value) {
  assert(isfinite(value));
  char scientific[40], digits[24];
  int precision = 0;
  do snprintf(scientific, sizeof scientific, "%.*e", precision, fabs(value));
  while (precision++ < 16 && strtod(scientific, NULL) != fabs(value));
  int count = 0;
  const char *at = scientific;
  for (; *at != 'e'; at++)
    if (*at >= '0' && *at <= '9') digits[count++] = *at; /* passes over a locale's decimal sign */
  int exponent = atoi(at + 1);
  while (count > 1 && digits[count - 1] == '0') count--;
  digits[count] = 0;
  if (value < 0) lam_text_add(text, "-");
  if (exponent < -4 || exponent > 15) {
    lam_text_printf(text, "%c.%sE%d", digits[0], count > 1 ? digits + 1 : "0", exponent);
    return;
  }
  if (exponent < 0) lam_text_printf(text, "0.%.*s%s", -exponent - 1, "0000", digits);
  for (int i = 0; exponent >= 0 && (i < count || i <= exponent + 1); i++) {
    if (i == exponent + 1) lam_text_add(text, ".");
    lam_text_bytes(text, i < count ? digits + i : "0", 1);
  }
}

void lam_text_quoted(lam_text *text, const char *string) {
  lam_text_bytes(text, "\"", 1);
  for (; *string; string++) {
    if ((unsigned char)*string < ' ') continue;
    if (*string == '"' || *string == '\\') lam_text_bytes(text, "\\", 1);
    lam_text_bytes(text, string, 1);
  }
  lam_text_bytes(text, "\"", 1);
}

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
