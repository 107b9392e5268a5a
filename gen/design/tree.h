/* The document tree of a design: maps, lists and scalars, each with its location in the file. YAML
 * is turned into this tree (yaml.c); overrides edit it (override.c); the key tables are filled from
 * it (fill.c). Aliases are expanded: every node has one parent. */
#ifndef LAM_DESIGN_TREE_H
#define LAM_DESIGN_TREE_H

#include "core/error.h"
#include <stdbool.h>
#include <stddef.h>

typedef enum lam_node_type { LAM_NODE_SCALAR, LAM_NODE_LIST, LAM_NODE_MAP } lam_node_type;

typedef struct lam_node {
  lam_node_type type;
  lam_location location;
  const char *text; /* SCALAR: UTF-8, zero-terminated; NULL otherwise */
  bool plain;       /* SCALAR: written without quotes */
  int count;        /* LIST, MAP: the number of items */
  struct lam_node **items;
  /* MAP: the key of each item, always a scalar. NULL stands for the first key of the table that the
   * map is read with: an override that goes into the short form of a map turns the scalar into such
   * an item. */
  struct lam_node **keys;
} lam_node;

/* What a design may hold, so that no file can exhaust the program. */
enum {
  LAM_DESIGN_MAX_BYTES = 4 << 20,
  LAM_DESIGN_MAX_NODES = 500000,
  LAM_DESIGN_MAX_DEPTH = 32,
  LAM_DESIGN_MAX_KEYS = 1000, /* of one map */
  LAM_DESIGN_MAX_ANCHORS = 1000
};

/* ---- reading (yaml.c) ---- */

/* The tree of one YAML document, owned by arena; NULL when it is empty or wrong. Problems are added
 * to errors: an empty document is none. A key that is given twice stands in the map twice.
 *
 *   bytes, count  UTF-8; bytes may be NULL when count is 0. Not kept
 *   origin        where the document comes from; its texts are kept by pointer
 *   fixed         true: every node has the location origin (a default, an override); false: its own
 *                 line and column in origin.file */
lam_node *lam_tree_read(lam_arena *arena, const char *bytes, size_t count, lam_location origin,
                        bool fixed, lam_errors *errors);
/* ---- nodes (tree.c) ---- */

/* True for a value that was left empty: `key:`, `key: ~` or `key: null`. */
bool lam_node_is_empty(const lam_node *node);
/* The first item of a map with this key, or NULL. */
lam_node *lam_node_find(const lam_node *map, const char *key);
/* A new node without text and items, owned by arena. */
lam_node *lam_node_new(lam_arena *arena, lam_node_type type, lam_location location);
/* Appends an item to a list or a map, which the node was made as; key is NULL for lists, and may be
 * for maps (see keys). key and item are kept by pointer; the arrays grow in arena. */
void lam_node_append(lam_arena *arena, lam_node *node, lam_node *key, lam_node *item);

/* ---- changing (override.c) ---- */

/* Applies one override, such as "net.grid=[40,40]", to the tree. Missing maps are made. *root may
 * be NULL: an empty document. Problems are added to errors, and the value is not set then. */
void lam_tree_override(lam_arena *arena, lam_node **root, const char *text, lam_errors *errors);

#endif
