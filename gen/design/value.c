/* Scalars of the design language: numbers with units, flags, choices and texts. Called by fill.c,
 * through its table of types. */
#include "design/describe.h"
#include "design/fill.h"

#include <errno.h>
#include <limits.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- numbers ---- */

/* The end of the number that text begins with: digits with an optional sign, point and exponent.
 * text itself when there is no number. An E without digits behind it is not part of the number. */
static const char *number_end(const char *text) {
  const char *at = text + (*text == '-' || *text == '+');
  size_t whole = strspn(at, "0123456789"), part = 0;
  at += whole;
  if (*at == '.') {
    part = strspn(at + 1, "0123456789");
    at += 1 + part;
  }
  if (whole + part == 0) return text;

  if (*at == 'e' || *at == 'E') {
    const char *power = at + 1 + (at[1] == '-' || at[1] == '+');
    size_t digits = strspn(power, "0123456789");
    if (digits > 0) at = power + digits;
  }
  return at;
}

/* The number that text begins with; *rest is what follows it. 0 and text itself when there is no
 * number. */
static double read_number(lam_arena *arena, const char *text, const char **rest) {
  *rest = number_end(text);
  if (*rest == text) return 0;

  /* strtod expects the locale's decimal sign. */
  char *digits = lam_arena_copy(arena, text);
  digits[*rest - text] = 0;
  char *point = strchr(digits, '.');
  const char *local = localeconv()->decimal_point;
  if (point && local[0] && !local[1]) *point = local[0];
  return strtod(digits, NULL);
}

/* The unit of that name, of any kind, or NULL. */
static const lam_unit_name *find_unit(const char *name) {
  for (const lam_unit_name *unit = lam_unit_names; unit->name; unit++) {
    if (strcmp(unit->name, name) == 0) return unit;
  }
  return NULL;
}

/* The names of the units of one kind, NULL-terminated; there are fewer than eight. */
static const char *const *unit_names_of(lam_arena *arena, lam_key_unit unit) {
  const char **names = LAM_NEW(arena, const char *, 8);
  int count = 0;
  for (const lam_unit_name *row = lam_unit_names; row->name; row++) {
    if (row->unit == unit) names[count++] = row->name;
  }
  return names;
}

/* Something is wrong with the unit `given` that follows the number: there should be none, it is
 * missing, it is unknown, or it is of another kind. Says what is expected. */
static void complain_unit(const lam_filler *filler, const lam_key *key, const lam_node *node,
                          const lam_trail *trail, const char *given) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_item(&text, key);

  if (key->unit == LAM_UNIT_NONE) {
    if (find_unit(given)) lam_text_add(&text, ", without a unit");
  } else if (!*given) {
    lam_text_printf(&text, ", such as %s %s", node->text,
                    key->unit == LAM_UNIT_LENGTH ? "mm" : "deg");
  } else if (!find_unit(given)) {
    lam_describe_guess(&text, given, unit_names_of(filler->arena, key->unit));
  }
  lam_fill_complain(filler, node->location, trail, &text);
}

/* True when value lies within the limits. A value that misses a limit by rounding alone becomes the
 * limit. */
static bool within(const lam_key *key, double *value) {
  if (!(key->min < key->max)) return true;
  if (*value < key->min && *value >= key->min - 1e-12 * fabs(key->min)) *value = key->min;
  if (*value > key->max && *value <= key->max + 1e-12 * fabs(key->max)) *value = key->max;
  return *value >= key->min && *value <= key->max;
}

/* The value is beyond the limits of the key, which are told in the unit of the value (NULL: in one
 * that reads well). */
static void complain_range(const lam_filler *filler, const lam_key *key, const lam_node *node,
                           const lam_trail *trail, const lam_unit_name *unit) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_range(&text, key, unit);
  lam_fill_complain(filler, node->location, trail, &text);
}

/* A number and its unit, with spaces between or none: "0.8 m", "80mm", "12". */
void lam_fill_number(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  const char *rest = NULL;
  double given = node->type == LAM_NODE_SCALAR ? read_number(filler->arena, node->text, &rest) : 0;
  if (node->type != LAM_NODE_SCALAR || rest == node->text) {
    lam_fill_complain_type(filler, key, node, trail);
    return;
  }

  /* 0 is the same length or angle in every unit: it may stand alone. */
  rest += strspn(rest, " ");
  const lam_unit_name *unit = find_unit(rest);
  bool right = *rest ? unit && unit->unit == key->unit : key->unit == LAM_UNIT_NONE || given == 0;
  if (!right) {
    complain_unit(filler, key, node, trail, rest);
    return;
  }

  double value = unit ? given / unit->divide * unit->multiply : given;
  if (!isfinite(value)) {
    lam_text text = lam_fill_given(filler, node);
    lam_text_add(&text, "a number that fits (below 1e308)");
    lam_fill_complain(filler, node->location, trail, &text);
  } else if (within(key, &value)) {
    *(double *)to = value;
  } else {
    complain_range(filler, key, node, trail, unit);
  }
}

/* Decimal digits with an optional sign. */
void lam_fill_integer(const lam_filler *filler, const lam_key *key, const lam_node *node,
                      const lam_trail *trail, void *to) {
  char *rest = NULL;
  errno = 0;
  bool starts =
      node->type == LAM_NODE_SCALAR && node->text[0] && strchr("+-0123456789", node->text[0]);
  long value = starts ? strtol(node->text, &rest, 10) : 0;
  if (!starts || rest == node->text || *rest) {
    lam_fill_complain_type(filler, key, node, trail);
    return;
  }

  /* The key's own range is the better message; without one, the limits of int hold. */
  double checked = (double)value;
  if (!within(key, &checked)) {
    complain_range(filler, key, node, trail, NULL);
  } else if (errno || value < INT_MIN || value > INT_MAX) {
    lam_text text = lam_fill_given(filler, node);
    lam_text_printf(&text, "a whole number from %d to %d", INT_MIN, INT_MAX);
    lam_fill_complain(filler, node->location, trail, &text);
  } else {
    *(int *)to = (int)value;
  }
}

/* ---- words ---- */

/* YAML's words for flags, in any case; every second one means true. */
void lam_fill_flag(const lam_filler *filler, const lam_key *key, const lam_node *node,
                   const lam_trail *trail, void *to) {
  static const char *const words[] = {"no", "yes", "false", "true", "off", "on", NULL};

  for (int i = 0; words[i] && node->type == LAM_NODE_SCALAR; i++) {
    if (strcasecmp(node->text, words[i]) == 0) {
      *(bool *)to = i % 2;
      return;
    }
  }
  lam_fill_complain_type(filler, key, node, trail);
}

/* One of the key's words, exactly as they are written. */
void lam_fill_choice(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  for (int i = 0; key->choices[i] && node->type == LAM_NODE_SCALAR; i++) {
    if (strcmp(node->text, key->choices[i]) == 0) {
      *(int *)to = i;
      return;
    }
  }

  /* With a single word to choose from there is nothing to guess. */
  lam_text text = lam_fill_given(filler, node);
  lam_describe_item(&text, key);
  if (node->type == LAM_NODE_SCALAR && key->choices[1])
    lam_describe_guess(&text, node->text, key->choices);
  lam_fill_complain(filler, node->location, trail, &text);
}

/* True for texts that every format can hold in a line: without control characters (the C0 set, DEL,
 * and the C1 set, which is C2 80..9F in UTF-8), the separators of lines and paragraphs (E2 80 A8
 * and A9), and what is no character. */
static bool is_one_line(const char *text) {
  for (int size; *text; text += size) {
    const unsigned char *c = (const unsigned char *)text;
    size = lam_utf8_size(text);
    if (!size || *c < ' ' || *c == 0x7F || (*c == 0xC2 && c[1] < 0xA0)) return false;
    if (*c == 0xE2 && c[1] == 0x80 && (c[2] == 0xA8 || c[2] == 0xA9)) return false;
  }
  return true;
}

/* One line of at most 1000 bytes, which is kept by pointer. */
void lam_fill_text(const lam_filler *filler, const lam_key *key, const lam_node *node,
                   const lam_trail *trail, void *to) {
  enum { longest = 1000 };

  bool is_text = node->type == LAM_NODE_SCALAR && !lam_node_is_empty(node);
  if (!is_text) {
    lam_fill_complain_type(filler, key, node, trail);
  } else if (!is_one_line(node->text) || strlen(node->text) > longest) {
    lam_text text = lam_fill_given(filler, node);
    lam_text_printf(&text, "one line of at most %d characters", longest);
    lam_fill_complain(filler, node->location, trail, &text);
  } else {
    *(const char **)to = node->text;
  }
}
