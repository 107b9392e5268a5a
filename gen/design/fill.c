/* From the document tree to parameter structs: maps, rows of registries and lists, by their key
 * tables. Called by parse.c; scalars are stored by value.c. */
#include "design/fill.h"
#include "design/describe.h"

#include <string.h>

/* Stores one value, not a list of them, in `to`. */
typedef void (*fill_one)(const lam_filler *filler, const lam_key *key, const lam_node *node,
                         const lam_trail *trail, void *to);

/* The tables that one map is read with: a row's own keys and those that all rows of its registry
 * accept. */
typedef struct key_table {
  const lam_key *keys; /* may be NULL */
  char *params;
} key_table;
enum { table_count = 2 };

static void fill_value(const lam_filler *filler, const lam_key *key, const lam_node *node,
                       const lam_trail *trail, char *params);

/* ---- maps ---- */

/* The key of a table that has the name, or NULL. keys may be NULL. */
static const lam_key *find_key(const lam_key *keys, const char *name) {
  for (; keys && keys->name; keys++) {
    if (strcmp(keys->name, name) == 0) return keys;
  }
  return NULL;
}

/* The end of an empty table takes nothing. */
static bool takes_list(const lam_key *key) { return key->name && key->count != 1; }

/* The node itself when it is a map. When it is the short form of one (`from: surface`), a map with
 * the node as the value of the first key, which is left unwritten. NULL when it is neither:
 * nothing, or a list where the first key takes none. first: the first key of the table; NULL for a
 * row, whose short form is its kind. */
static const lam_node *as_map(const lam_filler *filler, const lam_node *node,
                              const lam_key *first) {
  if (node->type == LAM_NODE_MAP) return node;
  bool is_short =
      node->type == LAM_NODE_LIST ? first && takes_list(first) : !lam_node_is_empty(node);
  if (!is_short) return NULL;

  lam_node *map = lam_node_new(filler->arena, LAM_NODE_MAP, node->location);
  lam_node_append(filler->arena, map, NULL, (lam_node *)node);
  return map;
}

/* The name of item i of a map; first is that of a key that was left unwritten. */
static const char *name_of(const lam_node *map, int i, const char *first) {
  return map->keys[i] ? map->keys[i]->text : first;
}

/* The index of the item with this name, or -1: the first one that was written with it, before one
 * whose key was left unwritten. */
static int index_of(const lam_node *map, const char *name, const char *first) {
  int unwritten = -1;
  for (int i = 0; i < map->count; i++) {
    if (strcmp(name_of(map, i, first), name) != 0) continue;
    if (map->keys[i]) return i;
    unwritten = i;
  }
  return unwritten;
}

/* Item i of the map has a key that is none of names. */
static void complain_unknown(const lam_filler *filler, const lam_node *map, int i,
                             const char *first, const char *const *names, const lam_trail *trail) {
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, "no such key; expected one of ");
  lam_describe_names(&text, names);
  lam_describe_guess(&text, name_of(map, i, first), names);
  lam_fill_complain(filler, map->keys[i] ? map->keys[i]->location : map->location, trail, &text);
}

/* Item i of the map has the same key as the item `earlier`. Overrides have no line to point to. */
static void complain_twice(const lam_filler *filler, const lam_node *map, int i, int earlier,
                           const lam_trail *trail) {
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, "given twice; expected once");
  if (map->items[earlier]->location.line) {
    lam_text_printf(&text, " (first given in line %d)", map->items[earlier]->location.line);
  }
  lam_fill_complain(filler, map->keys[i]->location, trail, &text);
}

/* The value of `name` that a map gives, in whichever table has that key. False when none has. */
static bool fill_named(const lam_filler *filler, const key_table *tables, const char *name,
                       const lam_node *value, const lam_trail *trail) {
  for (int table = 0; table < table_count; table++) {
    const lam_key *key = find_key(tables[table].keys, name);
    if (!key) continue;

    if (key->given_offset) *(bool *)(tables[table].params + key->given_offset) = true;
    fill_value(filler, key, value, trail, tables[table].params);
    return true;
  }
  return false;
}

/* Stores what the map gives. Keys that no table has and keys that are given twice get a message.
 *
 *   kind   "kind" for the map of a row, whose kind is no key of the tables; NULL otherwise
 *   first  the name of a key that was left unwritten */
static void fill_given(const lam_filler *filler, const key_table *tables, const char *kind,
                       const lam_node *map, const char *first, const lam_trail *trail) {
  for (int i = 0; i < map->count; i++) {
    const char *name = name_of(map, i, first);
    lam_trail here = {trail, name, 0};

    /* An override of a short form writes its first key beside the unwritten one: it replaces it. */
    int earlier = index_of(map, name, first);
    if (earlier != i) {
      if (map->keys[i]) complain_twice(filler, map, i, earlier, &here);
      continue;
    }

    bool known = fill_named(filler, tables, name, map->items[i], &here);
    if (!known && (!kind || strcmp(name, kind) != 0)) {
      complain_unknown(filler, map, i, first,
                       lam_key_names(filler->arena, kind, tables[0].keys, tables[1].keys), &here);
    }
  }
}

/* The tree of a default, which is a text in the design language. Plain words and numbers need no
 * YAML reader, and most defaults are such. NULL with a message when it is wrong YAML. */
static lam_node *default_node(const lam_filler *filler, const char *text, lam_location location) {
  static const char simple[] =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.+-_ ";
  if (text[strspn(text, simple)] || text[0] == ' ' || (text[0] == '-' && text[1] == ' ')) {
    return lam_tree_read(filler->arena, text, strlen(text), location, true, filler->errors);
  }

  lam_node *node = lam_node_new(filler->arena, LAM_NODE_SCALAR, location);
  node->text = text;
  node->plain = true;
  return node;
}

/* Stores the default of a key that the map at location does not have; a message when it has none.
 * Nothing ("" or "~") leaves the value zero: no text, no row, an empty list. */
static void fill_default(const lam_filler *filler, const lam_key *key, lam_location location,
                         const lam_trail *trail, char *params) {
  if (!key->initial) {
    lam_text text = {.arena = filler->arena};
    lam_text_add(&text, "missing; expected ");
    lam_describe_key(&text, key);
    lam_fill_complain(filler, location, trail, &text);
  } else if (key->initial[0]) {
    const lam_node *node = default_node(filler, key->initial, location);
    if (node && !lam_node_is_empty(node)) fill_value(filler, key, node, trail, params);
  }
}

/* Fills the structs of the tables from a map: what it gives, then the defaults of what it does not.
 * kind: as for fill_given. */
static void fill_tables(const lam_filler *filler, const key_table *tables, const char *kind,
                        const lam_node *map, const lam_trail *trail) {
  const char *first = kind                                     ? kind
                      : tables[0].keys && tables[0].keys->name ? tables[0].keys->name
                                                               : "";
  fill_given(filler, tables, kind, map, first, trail);

  for (int table = 0; table < table_count; table++) {
    for (const lam_key *key = tables[table].keys; key && key->name; key++) {
      lam_trail here = {trail, key->name, 0};
      if (index_of(map, key->name, first) < 0)
        fill_default(filler, key, map->location, &here, tables[table].params);
    }
  }
}

/* MAP: the nested struct at `to`. */
static void fill_map(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  const lam_node *map = as_map(filler, node, key->keys);
  if (map)
    fill_tables(filler, (key_table[]){{key->keys, to}, {NULL, NULL}}, NULL, map, trail);
  else
    lam_fill_complain_type(filler, key, node, trail);
}

/* ---- rows ---- */

/* The row that the map's kind names, of the registry or added by the program; NULL with a message
 * when there is none. */
static const lam_row_head *find_row(const lam_filler *filler, const lam_key *key,
                                    const lam_node *map, const lam_trail *trail) {
  const lam_registry *rows = lam_registry_with(filler->arena, key->rows, filler->added);
  const char *const *names = lam_registry_names(filler->arena, rows);
  int at = index_of(map, "kind", "kind");
  const lam_node *kind = at < 0 ? NULL : map->items[at];
  bool is_word = kind && kind->type == LAM_NODE_SCALAR;
  const lam_row_head *head = is_word ? lam_registry_find(rows, kind->text) : NULL;
  if (head) return head;

  lam_trail here = {trail, "kind", 0};
  lam_text text = {.arena = filler->arena};
  if (kind)
    text = lam_fill_given(filler, kind);
  else
    lam_text_add(&text, "missing; expected ");
  lam_text_printf(&text, "one of the %s ", key->rows->name);
  lam_describe_names(&text, names);
  if (is_word) lam_describe_guess(&text, kind->text, names);
  lam_fill_complain(filler, kind ? kind->location : map->location, &here, &text);
  return NULL;
}

/* ROW: the lam_row at `to`. Its kind's own parameters and those that all kinds of the registry
 * share are filled from the same map. */
static void fill_row(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  const lam_node *map = as_map(filler, node, NULL);
  if (!map) {
    lam_fill_complain_type(filler, key, node, trail);
    return;
  }

  const lam_row_head *head = find_row(filler, key, map, trail);
  if (!head) return;

  lam_row *row = to;
  row->head = head;
  row->location = map->location;
  row->params = lam_arena_alloc(filler->arena, 1, head->params_size);
  row->common = lam_arena_alloc(filler->arena, 1, key->size);
  fill_tables(filler, (key_table[]){{head->keys, row->params}, {key->keys, row->common}}, "kind",
              map, trail);
}

/* ---- values and lists ---- */

/* How each type is stored; a size of 0 stands for the key's own. */
static const struct {
  size_t size;
  fill_one fill;
} types[] = {
    [LAM_KEY_NUMBER] = {sizeof(double), lam_fill_number},
    [LAM_KEY_INTEGER] = {sizeof(int), lam_fill_integer},
    [LAM_KEY_FLAG] = {sizeof(bool), lam_fill_flag},
    [LAM_KEY_CHOICE] = {sizeof(int), lam_fill_choice},
    [LAM_KEY_TEXT] = {sizeof(const char *), lam_fill_text},
    [LAM_KEY_MAP] = {0, fill_map},
    [LAM_KEY_ROW] = {sizeof(lam_row), fill_row},
};

/* Bytes of one value of the key. */
static size_t size_of(const lam_key *key) {
  return types[key->type].size ? types[key->type].size : key->size;
}

/* Stores the items of a list one behind the other, from `to` on. */
static void fill_items(const lam_filler *filler, const lam_key *key, const lam_node *list,
                       const lam_trail *trail, char *to) {
  size_t size = size_of(key);
  for (int i = 0; i < list->count; i++) {
    lam_trail here = {trail, NULL, i};
    types[key->type].fill(filler, key, list->items[i], &here, to + (size_t)i * size);
  }
}

/* The node is no list, empty, or a list of another length than the key's. */
static void complain_length(const lam_filler *filler, const lam_key *key, const lam_node *node,
                            const lam_trail *trail) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_key(&text, key);
  lam_fill_complain(filler, node->location, trail, &text);
}

/* Count 0: a lam_list of any length at `to`. A single value is a list of one. */
static void fill_list(const lam_filler *filler, const lam_key *key, const lam_node *node,
                      const lam_trail *trail, lam_list *to) {
  bool is_list = node->type == LAM_NODE_LIST;
  to->count = is_list ? node->count : 1;
  to->items = lam_arena_alloc(filler->arena, (size_t)to->count, size_of(key));

  if (is_list)
    fill_items(filler, key, node, trail, to->items);
  else
    types[key->type].fill(filler, key, node, trail, to->items);
}

/* Stores the value of a key, a single one or a list, at the key's offset in params. */
static void fill_value(const lam_filler *filler, const lam_key *key, const lam_node *node,
                       const lam_trail *trail, char *params) {
  char *to = params + key->offset;
  bool is_list = node->type == LAM_NODE_LIST;

  if (key->count == 1) {
    types[key->type].fill(filler, key, node, trail, to);
  } else if (key->count > 1) {
    if (is_list && node->count == key->count)
      fill_items(filler, key, node, trail, to);
    else
      complain_length(filler, key, node, trail);
  } else if (!is_list && lam_node_is_empty(node)) {
    complain_length(filler, key, node, trail);
  } else {
    fill_list(filler, key, node, trail, (lam_list *)to);
  }
}

/* As if the whole were the value of one key. */
void lam_fill_keys(const lam_filler *filler, const lam_key *keys, const lam_node *node,
                   const lam_trail *trail, void *params) {
  lam_key whole = {.type = LAM_KEY_MAP, .count = 1, .keys = keys};
  fill_map(filler, &whole, node, trail, params);
}
