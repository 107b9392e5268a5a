/* Keys of the design language. Every registry row (surface, net, constraint, part, ...) lists its
 * keys in one table; the parser (design/fill.c) fills the row's parameter struct from it, and the
 * help, the reference pages (library/) and the tests read the same table. Defaults are texts in the
 * design language, so that there is one parser and one source for them.
 *
 * How a value is stored at `offset` in the parameter struct:
 *   type            count 1                  count n > 1       count 0 (any number)
 *   NUMBER          double                   double[n]         lam_list of double
 *   INTEGER         int                      int[n]            lam_list of int
 *   FLAG            bool                     bool[n]           -
 *   CHOICE          int (index in choices)   int[n]            -
 *   TEXT            const char *             -                 lam_list of const char *
 *   MAP             the nested struct        -                 lam_list of the nested struct
 *   ROW             lam_row                  -                 lam_list of lam_row
 * A scalar where a MAP is expected fills the map's first key (`from: surface` is `from: {stage:
 * surface}`); a scalar where a ROW is expected is its kind. A single value where a list of any
 * length is expected is a list of one. A list longer or shorter than asked for is an error that
 * states both lengths. */
#ifndef LAM_CORE_KEY_H
#define LAM_CORE_KEY_H

#include "core/error.h"
#include <stdbool.h>
#include <stddef.h>

typedef enum lam_key_type {
  LAM_KEY_NUMBER,
  LAM_KEY_INTEGER,
  LAM_KEY_FLAG,
  LAM_KEY_CHOICE,
  LAM_KEY_TEXT,
  LAM_KEY_MAP,
  LAM_KEY_ROW
} lam_key_type;

/* LENGTH: a number with m, cm, mm or um; stored in meters. ANGLE: deg or rad; stored in radians. A
 * bare number with a unit missing is an error, except 0. */
typedef enum lam_key_unit { LAM_UNIT_NONE, LAM_UNIT_LENGTH, LAM_UNIT_ANGLE } lam_key_unit;

/* One key. A table of keys ends with one whose name is NULL. */
typedef struct lam_key {
  const char *name; /* as written before the colon */
  lam_key_type type;
  lam_key_unit unit;   /* of a NUMBER; LAM_UNIT_NONE for all other types */
  size_t offset;       /* in the parameter struct, where the value is stored */
  int count;           /* 1: one value; n > 1: a list of n; 0: a list of any length */
  const char *initial; /* the default, as it would stand in a design; NULL: the key must be given */
  /* NUMBER, INTEGER: limits in stored units, inclusive. min == max: none; -1e300 or 1e300: none on
   * that side. */
  double min, max;
  const char *const *choices; /* CHOICE: NULL-terminated */
  const struct lam_key *keys; /* MAP: keys of the nested struct; ROW: keys accepted beside every
                                 row's own; may be NULL */
  size_t size;                /* MAP, ROW: size of the struct that keys fill */
  const struct lam_registry *rows; /* ROW: the registry that `kind:` is looked up in */
  size_t given_offset; /* when not 0: a bool there says whether the design gave the key */
  const char *doc;     /* one sentence, for the reference page */
} lam_key;

/* The value of a key with count 0. */
typedef struct lam_list {
  int count;
  void *items; /* count values, contiguous; owned by the design's arena */
} lam_list;

/* The common head of every registry row: a kind (of surfaces, nets, ...) is a struct whose first
 * member is a lam_row_head. */
typedef struct lam_row_head {
  const char *name;     /* as written after `kind:` */
  const char *title;    /* a few words */
  const char *doc;      /* what it is, what it is for, what can go wrong: a paragraph */
  const char *equation; /* plain text; NULL when there is none */
  const char *source;   /* paper, section, equation; NULL when there is none */
  const lam_key *keys;  /* parameters; NULL when there are none */
  size_t params_size;   /* of the parameter struct */
} lam_row_head;

/* A registry: rows[0..count-1] each point to a lam_row_head. */
typedef struct lam_registry {
  const char *name; /* plural, as in `lamella list surfaces` */
  const char *noun; /* singular, for messages: "surface" */
  const lam_row_head *const *rows;
  int count;
} lam_registry;

/* A row that a design has chosen, with its parameters. head is NULL when the design does not give
 * the key. Owned by the design's arena. */
typedef struct lam_row {
  const lam_row_head *head;
  void *params; /* of head->params_size bytes, filled from head->keys */
  void *common; /* of the key's size bytes, filled from the key's own keys: those that every row of
                 * the registry accepts */
  lam_location location; /* where it stands in the design */
} lam_row;

/* ---- rows of key tables ----
 *
 * `of` is the parameter struct, `member` where the value goes; how many values a key takes follows
 * from the member: a lam_list takes any number, an array as many as it has, everything else one.
 * Further fields may follow the sentence: LAM_GIVEN(of, flag), .keys = ..., .size = ... */
#define LAM_NUMBER_KEY(of, key, member, initial, min, max, doc, ...)                               \
  LAM_RANGE_KEY_(of, key, member, NUMBER, double, LAM_UNIT_NONE, initial, min, max, doc,           \
                 __VA_ARGS__)
#define LAM_LENGTH_KEY(of, key, member, initial, min, max, doc, ...)                               \
  LAM_RANGE_KEY_(of, key, member, NUMBER, double, LAM_UNIT_LENGTH, initial, min, max, doc,         \
                 __VA_ARGS__)
#define LAM_ANGLE_KEY(of, key, member, initial, min, max, doc, ...)                                \
  LAM_RANGE_KEY_(of, key, member, NUMBER, double, LAM_UNIT_ANGLE, initial, min, max, doc,          \
                 __VA_ARGS__)
#define LAM_INTEGER_KEY(of, key, member, initial, min, max, doc, ...)                              \
  LAM_RANGE_KEY_(of, key, member, INTEGER, int, LAM_UNIT_NONE, initial, min, max, doc, __VA_ARGS__)
#define LAM_FLAG_KEY(of, key, member, initial, doc, ...)                                           \
  LAM_ONE_KEY_(of, key, member, FLAG, bool, initial, doc, __VA_ARGS__)
#define LAM_CHOICE_KEY(of, key, member, initial, names, doc, ...)                                  \
  LAM_ONE_KEY_(of, key, member, CHOICE, int, initial, doc, .choices = names, __VA_ARGS__)
#define LAM_TEXT_KEY(of, key, member, initial, doc, ...)                                           \
  LAM_ONE_KEY_(of, key, member, TEXT, const char *, initial, doc, __VA_ARGS__)
/* inner: the table of the nested struct, which is the member. */
#define LAM_MAP_KEY(of, key, member, initial, inner, doc, ...)                                     \
  {                                                                                                \
    LAM_KEY_FIELDS_(of, key, member, MAP, LAM_MEMBER_(of, member), initial, doc),                  \
        .keys = inner, .size = sizeof(LAM_MEMBER_(of, member)), __VA_ARGS__                        \
  }
/* The same for any number of nested structs of type item: the member is a lam_list. */
#define LAM_MAPS_KEY(of, key, member, initial, inner, item, doc, ...)                              \
  {                                                                                                \
    LAM_KEY_FIELDS_(of, key, member, MAP, item, initial, doc), .keys = inner,                      \
                                                               .size = sizeof(item), __VA_ARGS__   \
  }
#define LAM_ROW_KEY(of, key, member, initial, registry, doc, ...)                                  \
  LAM_ONE_KEY_(of, key, member, ROW, lam_row, initial, doc, .rows = registry, __VA_ARGS__)
/* A bool of the struct that says whether the design gave the key. */
#define LAM_GIVEN(of, flag) .given_offset = offsetof(of, flag)

#define LAM_MEMBER_(of, member) (((of *)0)->member)
#define LAM_KEY_FIELDS_(of, key, member, kind, item, text, sentence)                               \
  .name = key, .type = LAM_KEY_##kind, .offset = offsetof(of, member), .initial = text,            \
  .doc = sentence,                                                                                 \
  .count = _Generic(LAM_MEMBER_(of, member), lam_list : 0, default                                 \
                    : (int)(sizeof(LAM_MEMBER_(of, member)) / sizeof(item)))
#define LAM_ONE_KEY_(of, key, member, kind, item, initial, doc, ...)                               \
  { LAM_KEY_FIELDS_(of, key, member, kind, item, initial, doc), __VA_ARGS__ }
#define LAM_RANGE_KEY_(of, key, member, kind, item, measured, initial, least, most, doc, ...)      \
  {                                                                                                \
    LAM_KEY_FIELDS_(of, key, member, kind, item, initial, doc), .unit = measured, .min = least,    \
                                                                .max = most, __VA_ARGS__           \
  }

/* ---- registries ---- */

/* The row called name, or NULL; the first one when several have the name. */
const lam_row_head *lam_registry_find(const lam_registry *registry, const char *name);

/* Rows that a program adds to a registry, for its own designs. */
typedef struct lam_added_rows {
  const lam_registry *registry; /* that they are added to */
  int count;
  const lam_row_head *const *rows;
} lam_added_rows;

/* The registry with the rows that were added to it behind its own, in arena; the registry itself
 * when there are none. added may be NULL, or for another registry. */
const lam_registry *lam_registry_with(lam_arena *arena, const lam_registry *registry,
                                      const lam_added_rows *added);

#endif
