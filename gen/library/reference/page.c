/* Pages of the reference: title, paragraphs, equation, an example of use, tables of keys. Called by
 * reference.c. */
#include "library/reference/page.h"
#include "design/describe.h"
#include "library/reference/wrap.h"

#include <string.h>

/* ---- keys ---- */

/* The columns that the longest name of a key takes, and two more. */
static int name_column(const lam_key *keys) {
  int width = 0;
  for (; keys->name; keys++) {
    int columns = lam_columns(keys->name);
    if (columns > width) width = columns;
  }
  return width + 2;
}

/* What a key takes and what holds without it: "a length in m, cm, mm or um from 1 mm to 1 m;
 * default: 100 mm". */
static const char *facts_of(lam_arena *arena, const lam_key *key) {
  lam_text text = {.arena = arena};
  const bool is_nested = key->type == LAM_KEY_MAP; /* its keys follow anyway */
  if (is_nested)
    lam_text_add(&text,
                 key->count == 1 ? "a map of the keys below" : "a list of maps of the keys below");
  else
    lam_describe_key(&text, key);

  if (!key->initial)
    lam_text_add(&text, "; required");
  else if (!key->initial[0] || strcmp(key->initial, "~") == 0)
    lam_text_add(&text, "; optional");
  else if (strcmp(key->initial, "{}") != 0)
    lam_text_printf(&text, "; default: %s", key->initial);
  return text.data;
}

/* Name and facts on a line, the sentence under the facts. */
void lam_page_keys(lam_text *text, const lam_key *keys, int indent) {
  int column = indent + name_column(keys);
  for (const lam_key *key = keys; key->name; key++) {
    lam_spaces(text, indent);
    lam_text_add(text, key->name);
    lam_spaces(text, column - indent - lam_columns(key->name));
    lam_wrap(text, facts_of(text->arena, key), column, column);

    if (key->doc) {
      lam_spaces(text, column);
      lam_wrap(text, key->doc, column, column);
    }
    if (key->type == LAM_KEY_MAP) lam_page_keys(text, key->keys, indent + 4);
  }
}

static bool has_keys(const lam_key *keys) { return keys && keys->name; }

/* A table under a title; nothing when there are no keys. */
static void add_keys(lam_text *text, const char *title, const lam_key *keys) {
  if (!has_keys(keys)) return;
  lam_text_printf(text, "\n%s\n", title);
  lam_page_keys(text, keys, 2);
}

/* ---- entries ---- */

/* Words under a title (NULL: under an empty line); nothing when there are none. */
static void add_paragraph(lam_text *text, const char *title, const char *words) {
  if (!words || !*words) return;
  if (title)
    lam_text_printf(text, "\n%s\n", title);
  else
    lam_text_add(text, "\n");
  lam_spaces(text, 2);
  lam_wrap(text, words, 2, 2);
}

/* The same for lines, such as those of equations, which are kept; one that is too long is
 * wrapped. */
static void add_lines(lam_text *text, const char *title, const char *lines) {
  if (!lines || !*lines) return;

  lam_text_printf(text, "\n%s\n", title);
  while (*lines) {
    size_t length = strcspn(lines, "\n");
    char *line = lam_arena_printf(text->arena, "%.*s", (int)length, lines);

    lam_spaces(text, 2);
    if (lam_columns(line) + 2 > LAM_PAGE_WIDTH)
      lam_wrap(text, line, 2, 4);
    else
      lam_text_printf(text, "%s\n", line);

    lines += length + (lines[length] == '\n');
  }
}

/* Appends the keys to a line of usage: those that must be given, then the others with their
 * defaults while they fit on the page. */
static void add_pairs(lam_text *line, const lam_key *keys) {
  for (const lam_key *key = keys; key && key->name; key++)
    if (!key->initial) lam_text_printf(line, ", %s: ...", key->name);

  for (const lam_key *key = keys; key && key->name; key++) {
    if (!key->initial || !key->initial[0] || strchr("~[{", key->initial[0])) continue;
    const char *pair = lam_arena_printf(line->arena, ", %s: %s", key->name, key->initial);
    if (lam_columns(line->data) + lam_columns(pair) + 6 > LAM_PAGE_WIDTH) break;
    lam_text_add(line, pair);
  }
}

/* What closes the brackets that a usage opens, but for the brace of the kind: nothing after
 * "surface: {kind: %s", the list after "parts: [{kind: %s", and the map around it after
 * "net: {..., constraints: [{kind: %s". */
static const char *closing(const char *usage) {
  if (!strchr(usage, '[')) return "";
  return strstr(usage, "...") ? "]}" : "]";
}

/* How the entry is written in a design: "surface: {kind: enneper, order: 1}". */
static void add_usage(lam_text *text, const lam_section *section, const lam_listed *entry) {
  if (!section->usage) return;
  const char *hole = strstr(section->usage, "%s");
  lam_text line = {.arena = text->arena};
  lam_text_bytes(&line, section->usage, (size_t)(hole - section->usage));
  lam_text_printf(&line, "%s%s", entry->name, hole + 2);

  add_pairs(&line, entry->keys);
  lam_text_printf(text, "\nIn a design\n  %s}%s\n", line.data, closing(section->usage));
}

/* Name, noun and title, then whatever the entry has, in this order. */
void lam_page_entry(lam_text *text, const lam_section *section, const lam_listed *entry) {
  lam_text_printf(text, "%s (%s)", entry->name, section->noun);
  if (entry->title) {
    lam_text_add(text, ": ");
    int column = lam_columns(entry->name) + lam_columns(section->noun) + 5;
    lam_wrap(text, entry->title, column, 2);
  } else {
    lam_text_add(text, "\n");
  }

  add_paragraph(text, NULL, entry->doc);
  add_paragraph(text, "What it is for", entry->use);
  add_paragraph(text, "What can go wrong", entry->trouble);
  add_lines(text, "Equation", entry->equation);
  add_lines(text, "How it is made", entry->facts);
  add_paragraph(text, "Source", entry->source);

  add_usage(text, section, entry);
  add_keys(text, "Keys", entry->keys);
  if (has_keys(section->common)) {
    add_keys(text, lam_arena_printf(text->arena, "Keys of every %s", section->noun),
             section->common);
  }
}
