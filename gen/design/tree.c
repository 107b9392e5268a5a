/* Nodes of the document tree: made by yaml.c and override.c, looked up by parse.c and fill.c. */
#include "design/tree.h"
#include <string.h>

/* Everything but type and location is zero: no text, no items, not plain. */
lam_node *lam_node_new(lam_arena *arena, lam_node_type type, lam_location location) {
  lam_node *node = LAM_NEW(arena, lam_node, 1);
  node->type = type;
  node->location = location;
  return node;
}

/* True for 0 too. */
static bool is_power_of_two(int n) { return (n & (n - 1)) == 0; }

/* The array old of count items, or a larger copy when it is full. Arrays hold a power of two of
 * items, at least 1, so that they are full when count is 0 or a power of two: a node needs no
 * capacity, and the many nodes with a few items little room (lam_grow would give each 16). */
static lam_node **grown(lam_arena *arena, lam_node **old, int count) {
  if (!is_power_of_two(count)) return old;
  lam_node **larger = LAM_NEW(arena, lam_node *, count > 0 ? 2 * count : 1);
  if (count > 0) memcpy(larger, old, (size_t)count * sizeof *larger);
  return larger;
}

/* A map's keys and items grow together. */
void lam_node_append(lam_arena *arena, lam_node *node, lam_node *key, lam_node *item) {
  if (node->type == LAM_NODE_MAP) {
    node->keys = grown(arena, node->keys, node->count);
    node->keys[node->count] = key;
  }
  node->items = grown(arena, node->items, node->count);
  node->items[node->count++] = item;
}

/* Items without a key of their own (see lam_node) are passed over. */
lam_node *lam_node_find(const lam_node *map, const char *key) {
  for (int i = 0; i < map->count; i++) {
    if (map->keys[i] && strcmp(map->keys[i]->text, key) == 0) return map->items[i];
  }
  return NULL;
}

/* In quotes, all three are texts. */
bool lam_node_is_empty(const lam_node *node) {
  return node->type == LAM_NODE_SCALAR && node->plain &&
         (node->text[0] == '\0' || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}
