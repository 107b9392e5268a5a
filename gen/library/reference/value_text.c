/* Parsed values back as text: one function per type of key, and what is not worth a word. Called by
 * describe_design.c. */
#include "library/reference/value_text.h"
#include "design/describe.h"

#include <string.h>

enum { shown_items = 8 }; /* of a list */

/* ---- one value ----
 * Each appends the value at `at`, stored as core/key.h says for its type. */

static void add_number(lam_text *text, const lam_key *key, const void *at) {
  lam_describe_quantity(text, *(const double *)at, key->unit);
}
static void add_integer(lam_text *text, const lam_key *key, const void *at) {
  (void)key;
  lam_text_printf(text, "%d", *(const int *)at);
}
static void add_flag(lam_text *text, const lam_key *key, const void *at) {
  (void)key;
  lam_text_add(text, *(const bool *)at ? "yes" : "no");
}
static void add_choice(lam_text *text, const lam_key *key, const void *at) {
  lam_text_add(text, key->choices[*(const int *)at]);
}
static void add_string(lam_text *text, const lam_key *key, const void *at) {
  const char *string = *(const char *const *)at;
  (void)key;
  lam_text_add(text, string ? string : "~");
}
static void add_map(lam_text *text, const lam_key *key, const void *at) {
  lam_text_add(text, "{");
  lam_value_text(text, key->keys, at);
  lam_text_add(text, "}");
}
/* The kind, with the values of its own keys in braces. */
static void add_row(lam_text *text, const lam_key *key, const void *at) {
  const lam_row *row = at;
  (void)key;
  lam_text_add(text, row->head->name);

  if (!row->head->keys || !row->head->keys->name) return;
  lam_text_add(text, " {");
  lam_value_text(text, row->head->keys, row->params);
  lam_text_add(text, "}");
}

/* By lam_key_type: the size of a stored value, and its function. */
static const struct {
  size_t size; /* 0: that of the key */
  void (*add)(lam_text *text, const lam_key *key, const void *at);
} types[] = {
    [LAM_KEY_NUMBER] = {sizeof(double), add_number},
    [LAM_KEY_INTEGER] = {sizeof(int), add_integer},
    [LAM_KEY_FLAG] = {sizeof(bool), add_flag},
    [LAM_KEY_CHOICE] = {sizeof(int), add_choice},
    [LAM_KEY_TEXT] = {sizeof(const char *), add_string},
    [LAM_KEY_MAP] = {0, add_map},
    [LAM_KEY_ROW] = {sizeof(lam_row), add_row},
};

/* ---- all values of a table ---- */

/* Whether a key is not worth a word: the design left it to the program, or it is an empty list, an
 * optional text or a row that is not there. */
static bool is_skipped(const lam_key *key, const char *params) {
  const char *at = params + key->offset;
  bool optional = key->initial && (!key->initial[0] || strcmp(key->initial, "~") == 0);
  if (key->given_offset && !*(const bool *)(params + key->given_offset)) return true;
  if (key->count == 0) return ((const lam_list *)at)->count == 0;
  if (key->type == LAM_KEY_TEXT && key->count == 1) return optional && !*(const char *const *)at;
  return key->type == LAM_KEY_ROW && !((const lam_row *)at)->head;
}

/* count values of a key in brackets; of long lists the first ones. */
static void add_items(lam_text *text, const lam_key *key, const char *items, int count) {
  size_t size = types[key->type].size ? types[key->type].size : key->size;

  lam_text_add(text, "[");
  for (int i = 0; i < count && i < shown_items; i++) {
    if (i > 0) lam_text_add(text, ", ");
    types[key->type].add(text, key, items + (size_t)i * size);
  }
  if (count > shown_items) lam_text_printf(text, ", ... %d in all", count);
  lam_text_add(text, "]");
}

/* A key stores one value, as many as it counts, or a list. */
void lam_value_text(lam_text *text, const lam_key *keys, const void *params) {
  bool first = true;
  for (const lam_key *key = keys; key && key->name; key++) {
    if (is_skipped(key, params)) continue;
    const char *at = (const char *)params + key->offset;
    const lam_list *list = (const lam_list *)at;
    lam_text_printf(text, "%s%s ", first ? "" : ", ", key->name);
    first = false;

    if (key->count == 1)
      types[key->type].add(text, key, at);
    else if (key->count > 1)
      add_items(text, key, at, key->count);
    else
      add_items(text, key, list->items, list->count);
  }
}
