/* Fills parameter structs from the document tree, as their key tables say (core/key.h). Called by
 * design/parse.c; the steps are in fill.c (maps, rows, lists), value.c (scalars) and complaint.c
 * (messages). */
#ifndef LAM_DESIGN_FILL_H
#define LAM_DESIGN_FILL_H

#include "core/key.h"
#include "core/text.h"
#include "design/tree.h"

/* Where a value stands among the keys, for messages: a chain from the value up to the root, on the
 * stack. A step is a key (name) or an item of a list (name NULL, index). */
typedef struct lam_trail {
  const struct lam_trail *parent;
  const char *name;
  int index;
} lam_trail;

/* What all steps need. */
typedef struct lam_filler {
  lam_arena *arena;
  lam_errors *errors;
  const lam_added_rows *added; /* rows beside those of the registries; NULL: none */
} lam_filler;

/* Fills params from a map (or from the short form of one). Keys that the map does not have get
 * their defaults. Everything wrong is added to the filler's errors.
 *
 *   keys    table of the struct
 *   trail   of the map; NULL: the root
 *   params  the struct, zeroed; texts in it live as long as the filler's arena */
void lam_fill_keys(const lam_filler *filler, const lam_key *keys, const lam_node *node,
                   const lam_trail *trail, void *params);

/* Each stores one scalar in `to`, in stored units: a double (NUMBER), int (INTEGER), bool (FLAG),
 * int (CHOICE: the index of the word) or const char * (TEXT). When the node holds nothing that the
 * key takes, adds a message and leaves `to` as it is (value.c). */
void lam_fill_number(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to);
void lam_fill_integer(const lam_filler *filler, const lam_key *key, const lam_node *node,
                      const lam_trail *trail, void *to);
void lam_fill_flag(const lam_filler *filler, const lam_key *key, const lam_node *node,
                   const lam_trail *trail, void *to);
void lam_fill_choice(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to);
void lam_fill_text(const lam_filler *filler, const lam_key *key, const lam_node *node,
                   const lam_trail *trail, void *to);

/* Adds a message about the value at trail (complaint.c, as the next two). location: what it points
 * to; text: the message, not empty. */
void lam_fill_complain(const lam_filler *filler, lam_location location, const lam_trail *trail,
                       const lam_text *text);
/* Adds the message "given <node>; expected <what one item of the key takes>". */
void lam_fill_complain_type(const lam_filler *filler, const lam_key *key, const lam_node *node,
                            const lam_trail *trail);
/* The text "given <node>; expected " to go on with, in the filler's arena. */
lam_text lam_fill_given(const lam_filler *filler, const lam_node *node);

#endif
