/* Running text for the terminal: wrapped, indented, measured in columns. Called by the other files
 * of this folder. */
#include "library/reference/wrap.h"

#include <string.h>

/* The columns that length bytes of UTF-8 take: one per character, whose later bytes are
 * 10xxxxxx. */
static int columns_of(const char *word, size_t length) {
  int columns = 0;
  for (size_t i = 0; i < length; i++) columns += ((unsigned char)word[i] & 0xC0) != 0x80;
  return columns;
}

int lam_columns(const char *words) { return columns_of(words, strlen(words)); }

void lam_spaces(lam_text *text, int count) {
  for (int i = 0; i < count; i++) lam_text_add(text, " ");
}

/* Word by word: one that does not fit begins a new line, unless it is alone on its line. */
void lam_wrap(lam_text *text, const char *words, int column, int indent) {
  bool begins = true; /* nothing was written on this line yet */
  for (words += strspn(words, " \n"); *words; words += strspn(words, " \n")) {
    size_t length = strcspn(words, " \n");
    int columns = columns_of(words, length);

    if (!begins && column + 1 + columns > LAM_PAGE_WIDTH) {
      lam_text_add(text, "\n");
      lam_spaces(text, indent);
      column = indent;
      begins = true;
    }

    if (!begins) lam_text_add(text, " ");
    lam_text_bytes(text, words, length);
    column += columns + !begins;
    begins = false;
    words += length;
  }
  lam_text_add(text, "\n");
}
