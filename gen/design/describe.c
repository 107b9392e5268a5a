/* Words for keys, values and names, put together from the key tables. Called by fill.c, value.c,
 * complaint.c and override.c for messages, and by library/ for reference pages. */
#include "design/describe.h"
#include "core/numbers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const lam_unit_name lam_unit_names[] = {
    {"mm", LAM_UNIT_LENGTH, 1000, 1},     {"cm", LAM_UNIT_LENGTH, 100, 1},
    {"m", LAM_UNIT_LENGTH, 1, 1},         {"um", LAM_UNIT_LENGTH, 1e6, 1},
    {"deg", LAM_UNIT_ANGLE, 180, LAM_PI}, {"rad", LAM_UNIT_ANGLE, 1, 1},
    {NULL, LAM_UNIT_NONE, 1, 1},
};

/* What each type is called, alone and in a list. A ROW is described by its registry. */
typedef struct type_words {
  const char *one, *many;
} type_words;

static const type_words number_words[] = {
    [LAM_UNIT_NONE] = {"a number", "numbers"},
    [LAM_UNIT_LENGTH] = {"a length in m, cm, mm or um", "lengths in m, cm, mm or um"},
    [LAM_UNIT_ANGLE] = {"an angle in deg or rad", "angles in deg or rad"},
};
static const type_words other_words[] = {
    [LAM_KEY_INTEGER] = {"a whole number", "whole numbers"},
    [LAM_KEY_FLAG] = {"yes or no", "flags (yes or no)"},
    [LAM_KEY_CHOICE] = {"one of ", "words out of "},
    [LAM_KEY_TEXT] = {"a text", "texts"},
    [LAM_KEY_MAP] = {"a map with keys out of ", "maps with keys out of "},
};

/* ---- values ---- */

/* A number with up to six significant digits; the decimal sign is a point in every locale. */
static void add_number(lam_text *text, double value) {
  char digits[32];
  snprintf(digits, sizeof digits, "%.6g", value);
  for (char *c = digits; *c; c++) {
    if (*c == ',') *c = '.'; /* a locale's decimal comma */
  }
  lam_text_add(text, digits);
}

/* A stored value in the given unit, and the unit. */
static void add_in_unit(lam_text *text, double value, const lam_unit_name *unit) {
  add_number(text, value / unit->multiply * unit->divide);
  lam_text_printf(text, " %s", unit->name);
}

/* What lengths are shown in. */
static const lam_unit_name meter = {"m", LAM_UNIT_LENGTH, 1, 1};
static const lam_unit_name millimeter = {"mm", LAM_UNIT_LENGTH, 1000, 1};
static const lam_unit_name micrometer = {"um", LAM_UNIT_LENGTH, 1e6, 1};

/* Lengths from 1 m on in meters, from 0.1 mm on in millimeters, smaller ones in micrometers; angles
 * in degrees. */
void lam_describe_quantity(lam_text *text, double value, lam_key_unit unit) {
  double size = fabs(value);
  if (unit == LAM_UNIT_NONE || size == 0 || isnan(value)) {
    add_number(text, value);
  } else if (unit == LAM_UNIT_ANGLE) {
    add_number(text, value / LAM_PI * 180);
    lam_text_add(text, " deg");
  } else {
    add_in_unit(text, value, size >= 1 ? &meter : size >= 1e-4 ? &millimeter : &micrometer);
  }
}

/* A text, or its first 60 bytes and three points; no character is cut in half (bytes 80..BF
 * continue one in UTF-8). */
static void add_shortened(lam_text *text, const char *given) {
  enum { longest = 60 };
  size_t length = strlen(given);
  if (length > longest) {
    length = longest;
    while (length > 0 && ((unsigned char)given[length] & 0xC0) == 0x80) length--;
    lam_text_bytes(text, given, length);
    lam_text_add(text, "...");
  } else {
    lam_text_add(text, given);
  }
}

/* Maps and lists are told by their size, scalars as they were written. */
void lam_describe_node(lam_text *text, const lam_node *node) {
  if (node->type == LAM_NODE_MAP) {
    lam_text_add(text, "a map");
  } else if (node->type == LAM_NODE_LIST) {
    lam_text_printf(text, "a list of %d value%s", node->count, node->count == 1 ? "" : "s");
  } else if (lam_node_is_empty(node)) {
    lam_text_add(text, "nothing");
  } else {
    const char *quote = node->plain ? "" : "'";
    lam_text_add(text, quote);
    add_shortened(text, node->text);
    lam_text_add(text, quote);
  }
}

/* ---- keys ---- */

/* A limit in the unit that was given, if any; 0 needs none. */
static void add_limit(lam_text *text, double value, lam_key_unit own, const lam_unit_name *unit) {
  if (unit && value != 0)
    add_in_unit(text, value, unit);
  else
    lam_describe_quantity(text, value, own);
}

/* Nothing for keys without limits, and for all that are no numbers. */
void lam_describe_range(lam_text *text, const lam_key *key, const lam_unit_name *unit) {
  bool is_number = key->type == LAM_KEY_NUMBER || key->type == LAM_KEY_INTEGER;
  if (!is_number || !(key->min < key->max)) return;

  /* Tables write 1e300 where a key has a limit on the other side only. */
  bool has_min = key->min > -1e300, has_max = key->max < 1e300;
  if (has_min) {
    lam_text_add(text, has_max ? "from " : "at least ");
    add_limit(text, key->min, key->unit, unit);
  }
  if (has_max) {
    lam_text_add(text, has_min ? " to " : "at most ");
    add_limit(text, key->max, key->unit, unit);
  }
}

/* NUMBER is called by its unit, all other types by themselves. */
static const char *words_of(const lam_key *key, bool many) {
  const type_words *words =
      key->type == LAM_KEY_NUMBER ? &number_words[key->unit] : &other_words[key->type];
  return many ? words->many : words->one;
}

/* The words, keys or kinds that the key takes; nothing for other types. */
static void add_names_of(lam_text *text, const lam_key *key) {
  if (key->type == LAM_KEY_CHOICE) lam_describe_names(text, key->choices);
  if (key->type == LAM_KEY_MAP)
    lam_describe_names(text, lam_key_names(text->arena, NULL, key->keys, NULL));
  if (key->type == LAM_KEY_ROW)
    lam_describe_names(text, lam_registry_names(text->arena, key->rows));
}

/* What one item of the key takes, or several: the type, the names to choose from, the range. */
static void add_items(lam_text *text, const lam_key *key, bool many) {
  if (key->type == LAM_KEY_ROW) {
    lam_text_printf(text, many ? "%s, each a map with a kind out of " : "a map with a kind out of ",
                    key->rows->name);
  } else {
    /* A single word to choose from is said without "one of". */
    bool single = key->type == LAM_KEY_CHOICE && !many && key->choices[0] && !key->choices[1];
    if (!single) lam_text_add(text, words_of(key, many));
  }
  add_names_of(text, key);

  /* A range gets a space before it, and most keys have none. */
  lam_text range = {.arena = text->arena};
  lam_describe_range(&range, key, NULL);
  if (range.length) lam_text_printf(text, " %s", range.data);
}

void lam_describe_item(lam_text *text, const lam_key *key) { add_items(text, key, false); }

/* A list says how long it is, when that is fixed. */
void lam_describe_key(lam_text *text, const lam_key *key) {
  if (key->count == 0) lam_text_add(text, "a list of ");
  if (key->count > 1) lam_text_printf(text, "a list of %d ", key->count);
  add_items(text, key, key->count != 1);
}

/* ---- names ---- */

void lam_describe_names(lam_text *text, const char *const *names) {
  for (int i = 0; names[i]; i++) lam_text_printf(text, "%s%s", i ? ", " : "", names[i]);
}

void lam_describe_guess(lam_text *text, const char *given, const char *const *names) {
  const char *guess = lam_did_you_mean(given, names);
  if (guess) lam_text_printf(text, " (did you mean %s?)", guess);
}

/* The number of keys of a table; keys may be NULL. */
static int table_length(const lam_key *keys) {
  int count = 0;
  while (keys && keys[count].name) count++;
  return count;
}

/* One more than the names, so that the list ends with the arena's zeros. */
const char *const *lam_key_names(lam_arena *arena, const char *first, const lam_key *keys,
                                 const lam_key *more) {
  int own = table_length(keys), others = table_length(more), count = 0;
  const char **names = LAM_NEW(arena, const char *, own + others + 2);

  if (first) names[count++] = first;
  for (int i = 0; i < own; i++) names[count++] = keys[i].name;
  for (int i = 0; i < others; i++) names[count++] = more[i].name;
  return names;
}

const char *const *lam_registry_names(lam_arena *arena, const lam_registry *registry) {
  const char **names = LAM_NEW(arena, const char *, registry->count + 1);
  for (int i = 0; i < registry->count; i++) names[i] = registry->rows[i]->name;
  return names;
}
