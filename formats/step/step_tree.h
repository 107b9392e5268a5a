/* The data of a STEP file (ISO 10303-21) as a tree, whatever its schema: entities by number, each
 * with its records. Used by the other files of the STEP reader (step_reader.h). */
#ifndef LAM_FORMATS_STEP_STEP_TREE_H
#define LAM_FORMATS_STEP_STEP_TREE_H

#include "formats/scan.h"

typedef enum lam_step_type {
  LAM_STEP_NOTHING, /* $ or *: left out */
  LAM_STEP_NUMBER,
  LAM_STEP_TEXT,      /* a string, an enumeration or binary: not looked into */
  LAM_STEP_REFERENCE, /* #12 */
  LAM_STEP_LIST,
  LAM_STEP_RECORD /* KEYWORD(...) */
} lam_step_type;

typedef struct lam_step_value {
  lam_step_type type;
  lam_word word;                      /* of TEXT with its quotes or dots; the keyword of a RECORD */
  double number;                      /* of NUMBER */
  long entity;                        /* of REFERENCE */
  int count;                          /* of LIST and RECORD */
  const struct lam_step_value *first; /* of LIST and RECORD: the items */
  const struct lam_step_value *next;  /* in the list that this value stands in */
} lam_step_value;

typedef struct lam_step_entity {
  long number;
  int line;
  const lam_step_value *records; /* linked; more than one for a complex instance */
} lam_step_entity;

typedef struct lam_step_tree {
  int count;
  lam_step_entity *entities; /* in the order of their numbers */
} lam_step_tree;

/* Reads the whole text of scan (lam_scan_begin), whose bytes must stay; the tree is owned by
 * arena. False with one message when it is no STEP file, cut off or not well formed. What a
 * reference points to is not checked. */
bool lam_step_tree_read(lam_arena *arena, lam_scan *scan, lam_step_tree *tree);

/* The entity with this number; NULL: there is none. */
const lam_step_entity *lam_step_find(const lam_step_tree *tree, long number);
/* The record of an entity with this keyword; NULL: it has none, or entity is NULL. */
const lam_step_value *lam_step_record(const lam_step_entity *entity, const char *keyword);
/* Item i of a list or record; NULL: it has fewer, or is neither, or is NULL. */
const lam_step_value *lam_step_item(const lam_step_value *list, int i);
/* The same when it is of this type, NULL otherwise. */
const lam_step_value *lam_step_typed(const lam_step_value *list, int i, lam_step_type type);

#endif
