/* The values of a parsed design back in words: a line for every stage. Called through
 * lamella/design.h, by cli/verb_check.c. */
#include "design/design.h"
#include "formats/list/formats.h"
#include "library/reference/value_text.h"
#include "library/reference/wrap.h"
#include "library/session_state.h"
#include "net/net_kind.h"
#include "surf/placement.h"

#include <string.h>

enum { label_width = 10 }; /* columns that words begin at */

/* A label and words, wrapped beside it. */
static void add_line(lam_text *text, const char *label, const char *words) {
  lam_text_add(text, label);
  lam_spaces(text, label_width - lam_columns(label));
  lam_wrap(text, words, label_width, label_width);
}

/* A row by its kind and the values of its keys. common: the table of the keys that every row
 * accepts; NULL: none. Nothing when the design does not give the row. */
static void add_row(lam_text *text, const char *label, const lam_row *row, const lam_key *common) {
  lam_text words = {.arena = text->arena};
  lam_text values = {.arena = text->arena};
  if (!row->head) return;

  lam_value_text(&values, row->head->keys, row->params);
  if (common) {
    if (values.length > 0) lam_text_add(&values, ", ");
    lam_value_text(&values, common, row->common);
  }

  lam_text_printf(&words, "%s%s%s", row->head->name, values.length > 0 ? ": " : "",
                  values.length > 0 ? values.data : "");
  add_line(text, label, words.data);
}

/* The values of a top-level key that is a map: label is its name, params the design. */
static void add_map(lam_text *text, const char *label, const void *params) {
  for (const lam_key *key = lam_design_keys; key->name; key++) {
    if (strcmp(key->name, label) != 0) continue;
    lam_text words = {.arena = text->arena};
    lam_value_text(&words, key->keys, (const char *)params + key->offset);
    add_line(text, label, words.data);
  }
}

/* The formats that are written. */
static void add_formats(lam_text *text) {
  lam_text words = {.arena = text->arena};
  lam_text_add(&words, "");
  for (int i = 0; i < lam_format_count; i++) {
    if (lam_formats[i]->path)
      lam_text_printf(&words, "%s%s", words.length > 0 ? ", " : "", lam_formats[i]->name);
  }
  add_line(text, "outputs", words.data);
}

/* In the order in which a design is built. */
static void add_design(lam_text *text, const lam_design *design) {
  const lam_row *parts = design->parts.items;
  add_line(text, "design", lam_arena_printf(text->arena, "%s: %s", design->name, design->title));
  if (design->source[0]) add_line(text, "source", design->source);

  add_row(text, "surface", &design->surface, lam_placement_key_table);
  add_row(text, "net", &design->net, lam_net_common_keys);
  for (int i = 0; i < design->parts.count; i++) add_row(text, "part", &parts[i], NULL);

  if (design->parts.count > 0) add_map(text, "sheets", design);
  add_map(text, "render", design);
  add_formats(text);
}

/* Cannot fail but for memory. */
static lam_status describe(lam_session *session, const lam_design *design, const char **text) {
  lam_text words = {.arena = session->arena};
  add_design(&words, design);
  *text = words.data;
  return LAM_OK;
}

/* Declared in include/lamella/design.h. */
lam_status lam_design_describe(lam_session *session, const lam_design *design, const char **text) {
  *text = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, describe(session, design, text));
}
