/* Messages about values of a design, with the path of keys that leads to them. Called by fill.c,
 * value.c and parse.c. */
#include "design/describe.h"
#include "design/fill.h"

/* Appends the path of a trail, such as "parts[0].height", from the root down. */
static void add_trail(lam_text *text, const lam_trail *trail) {
  if (!trail) return;
  add_trail(text, trail->parent);
  if (!trail->name)
    lam_text_printf(text, "[%d]", trail->index);
  else
    lam_text_printf(text, "%s%s", text->length ? "." : "", trail->name);
}

/* The message carries the path beside its text, as the key of lam_error. */
void lam_fill_complain(const lam_filler *filler, lam_location location, const lam_trail *trail,
                       const lam_text *text) {
  lam_text path = {.arena = filler->arena};
  add_trail(&path, trail);
  lam_error_add(filler->errors, location, path.data, "%s", text->data);
}

/* For values of the wrong type: a word where a number is expected, a list where a map is. */
void lam_fill_complain_type(const lam_filler *filler, const lam_key *key, const lam_node *node,
                            const lam_trail *trail) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_item(&text, key);
  lam_fill_complain(filler, node->location, trail, &text);
}

/* The beginning of most messages. */
lam_text lam_fill_given(const lam_filler *filler, const lam_node *node) {
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, "given ");
  lam_describe_node(&text, node);
  lam_text_add(&text, "; expected ");
  return text;
}
