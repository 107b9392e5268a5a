#include "design/fill.h"
#include "design/describe.h"

#include <string.h>

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

static const lam_key *find_key(const lam_key *keys, const char *name) {
  for (; keys && keys->name; keys++) {
    if (strcmp(keys->name, name) == 0) return keys;
  }
  return NULL;
}

static bool takes_list(const lam_key *key) { return key->name && key->count != 1; }

/* The node itself when it is a map; a map whose first key has the value node when that is the short
 * form of one; NULL otherwise. first: the key that the short form fills. */
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

/* The name of item i of a map; first stands for a key that was left out. */
static const char *name_of(const lam_node *map, int i, const char *first) {
  return map->keys[i] ? map->keys[i]->text : first;
}

/* The item with this name; a written key goes before one that was left out. -1: none. */
static int index_of(const lam_node *map, const char *name, const char *first) {
  int unwritten = -1;
  for (int i = 0; i < map->count; i++) {
    if (strcmp(name_of(map, i, first), name) != 0) continue;
    if (map->keys[i]) return i;
    unwritten = i;
  }
  return unwritten;
}

static void complain_unknown(const lam_filler *filler, const lam_node *map, int i,
                             const char *first, const char *const *names, const lam_trail *trail) {
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, "no such key; expected one of ");
  lam_describe_names(&text, names);
  lam_describe_guess(&text, name_of(map, i, first), names);
  lam_fill_complain(filler, map->keys[i] ? map->keys[i]->location : map->location, trail, &text);
}

static void complain_twice(const lam_filler *filler, const lam_node *map, int i, int earlier,
                           const lam_trail *trail) {
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, "given twice; expected once");
  if (map->items[earlier]->location.line) {
    lam_text_printf(&text, " (first given in line %d)", map->items[earlier]->location.line);
  }
  lam_fill_complain(filler, map->keys[i]->location, trail, &text);
}

/* What the design gives. */
static void fill_given(const lam_filler *filler, const key_table *tables, const char *kind,
                       const lam_node *map, const char *first, const lam_trail *trail) {
  for (int i = 0; i < map->count; i++) {
    const char *name = name_of(map, i, first);
    lam_trail here = {trail, name, 0};
    int earlier = index_of(map, name, first);
    if (earlier != i) {
      if (map->keys[i]) complain_twice(filler, map, i, earlier, &here);
      continue;
    }
    const lam_key *key = NULL;
    int table = 0;
    for (; table < table_count && !(key = find_key(tables[table].keys, name)); table++) {
    }
    if (key) {
      if (key->given_offset) *(bool *)(tables[table].params + key->given_offset) = true;
      fill_value(filler, key, map->items[i], &here, tables[table].params);
    } else if (!kind || strcmp(name, kind) != 0) {
      complain_unknown(filler, map, i, first,
                       lam_key_names(filler->arena, kind, tables[0].keys, tables[1].keys), &here);
    }
  }
}

/* A default is a text in the design language. Plain words and numbers need no YAML reader. Nothing
 * ("" or "~") leaves the value zero: no text, no row, an empty list. */
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

static void complain_not_a_map(const lam_filler *filler, const lam_key *key, const lam_node *node,
                               const lam_trail *trail) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_item(&text, key);
  lam_fill_complain(filler, node->location, trail, &text);
}

static void fill_map(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  const lam_node *map = as_map(filler, node, key->keys);
  if (map)
    fill_tables(filler, (key_table[]){{key->keys, to}, {NULL, NULL}}, NULL, map, trail);
  else
    complain_not_a_map(filler, key, node, trail);
}

/* ---- rows ---- */

/* The registry row that the map's kind names, or NULL, with a message. */
static const lam_row_head *find_row(const lam_filler *filler, const lam_key *key,
                                    const lam_node *map, const lam_trail *trail) {
  const lam_registry *rows = lam_registry_with(filler->arena, key->rows, filler->added);
  const char *const *names = lam_registry_names(filler->arena, rows);
  lam_trail here = {trail, "kind", 0};
  int at = index_of(map, "kind", "kind");
  const lam_node *kind = at < 0 ? NULL : map->items[at];
  bool is_word = kind && kind->type == LAM_NODE_SCALAR;
  const lam_row_head *head = is_word ? lam_registry_find(rows, kind->text) : NULL;
  if (head) return head;
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

static void fill_row(const lam_filler *filler, const lam_key *key, const lam_node *node,
                     const lam_trail *trail, void *to) {
  const lam_node *map = as_map(filler, node, NULL);
  if (!map) {
    complain_not_a_map(filler, key, node, trail);
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

static void fill_items(const lam_filler *filler, const lam_key *key, const lam_node *list,
                       const lam_trail *trail, char *to) {
  size_t size = types[key->type].size ? types[key->type].size : key->size;
  for (int i = 0; i < list->count; i++) {
    lam_trail here = {trail, NULL, i};
    types[key->type].fill(filler, key, list->items[i], &here, to + (size_t)i * size);
  }
}

static void complain_length(const lam_filler *filler, const lam_key *key, const lam_node *node,
                            const lam_trail *trail) {
  lam_text text = lam_fill_given(filler, node);
  lam_describe_key(&text, key);
  lam_fill_complain(filler, node->location, trail, &text);
}

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
    lam_list *list = (lam_list *)to;
    size_t size = types[key->type].size ? types[key->type].size : key->size;
    list->count = is_list ? node->count : 1;
    list->items = lam_arena_alloc(filler->arena, (size_t)list->count, size);
    if (is_list)
      fill_items(filler, key, node, trail, list->items);
    else
      types[key->type].fill(filler, key, node, trail, list->items);
  }
}

void lam_fill_keys(const lam_filler *filler, const lam_key *keys, const lam_node *node,
                   const lam_trail *trail, void *params) {
  lam_key whole = {.type = LAM_KEY_MAP, .count = 1, .keys = keys};
  fill_map(filler, &whole, node, trail, params);
}
