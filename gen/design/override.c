/* Overrides: "net.grid=[40,40]" edits the tree before the key tables are filled from it. Called by
 * parse.c. */
#include "design/describe.h"
#include "design/tree.h"

#include <stdlib.h>
#include <string.h>

/* One step of a path: a name, or an index when name is NULL. */
typedef struct step {
  const char *name;
  int index;
} step;

/* One override: what all steps need. */
typedef struct override {
  lam_arena *arena;
  lam_errors *errors;
  lam_location location; /* names the override: "--set net.grid" */
} override;

enum { max_steps = 16 };

static void complain(const override *o, const char *text) {
  lam_error_add(o->errors, o->location, NULL, "%s", text);
}

/* Reads "[0]"; *at moves behind it. False, with a message, when there is no such index. Seven
 * digits are more than any list needs. */
static bool read_index(const override *o, const char **at, int *index) {
  char *rest = NULL;
  size_t digits = strspn(*at + 1, "0123456789");
  if (digits > 0 && digits < 8) *index = (int)strtol(*at + 1, &rest, 10);
  if (!rest || *rest != ']') {
    complain(o, "expected an index such as [0], which counts from 0");
    return false;
  }

  *at = rest + 1;
  return true;
}

/* Reads one step, "[0]" or "key" with a point before it unless it is the first; *at moves behind
 * it. False, with a message, when there is none. */
static bool read_step(const override *o, const char **at, bool first, step *out) {
  *out = (step){0};
  if (**at == '[') return read_index(o, at, &out->index);

  if (!first && **at == '.') (*at)++;
  size_t length = strcspn(*at, ".[]");
  if (length == 0) {
    complain(o, "expected a key such as net.grid or parts[0].height before the '='");
    return false;
  }

  char *name = lam_arena_copy(o->arena, *at);
  name[length] = 0;
  out->name = name;
  *at += length;
  return true;
}

/* Reads the steps of a path, at most max_steps. Returns their number; 0, with a message, when the
 * path is wrong. */
static int read_path(const override *o, const char *path, step *steps) {
  int count = 0;
  for (const char *at = path; *at || count == 0;) {
    if (count == max_steps) {
      complain(o, "too many keys; expected at most 16");
      return 0;
    }
    if (!read_step(o, &at, count == 0, &steps[count])) return 0;
    count++;
  }
  return count;
}

/* A value that was left empty, as in `key:`. */
static lam_node *empty_value(const override *o) {
  lam_node *node = lam_node_new(o->arena, LAM_NODE_SCALAR, o->location);
  node->text = "";
  node->plain = true;
  return node;
}

/* The slot of a map's key; a new one with an empty value when the map has none. NULL, with a
 * message, when the map is full. */
static lam_node **slot_of_key(const override *o, lam_node *map, const char *name) {
  for (int i = 0; i < map->count; i++) {
    if (map->keys[i] && strcmp(map->keys[i]->text, name) == 0) return &map->items[i];
  }

  if (map->count >= LAM_DESIGN_MAX_KEYS) {
    complain(o, "a map with more than 1000 keys");
    return NULL;
  }
  lam_node *key = lam_node_new(o->arena, LAM_NODE_SCALAR, o->location);
  key->text = name;
  lam_node_append(o->arena, map, key, empty_value(o));
  return &map->items[map->count - 1];
}

/* The slot that a name leads to from *slot, which becomes a map when it is nothing yet or the short
 * form of a map. NULL, with a message, when a list stands there. */
static lam_node **enter_name(const override *o, lam_node **slot, const char *name) {
  lam_node *node = *slot;
  if (node && node->type == LAM_NODE_LIST) {
    lam_error_add(o->errors, o->location, NULL,
                  "%s is a key, but a list of %d stands here; expected an index such as [0]", name,
                  node->count);
    return NULL;
  }

  if (!node || node->type != LAM_NODE_MAP) {
    *slot = lam_node_new(o->arena, LAM_NODE_MAP, o->location);
    if (node && !lam_node_is_empty(node)) lam_node_append(o->arena, *slot, NULL, node);
  }
  return slot_of_key(o, *slot, name);
}

/* The slot of a list's item. A single value stands for a list of one, and its slot for that of item
 * 0. NULL, with a message, when there is no such item. */
static lam_node **enter_index(const override *o, lam_node **slot, int index) {
  lam_node *node = *slot;
  int count = !node || lam_node_is_empty(node) ? 0 : node->type == LAM_NODE_LIST ? node->count : 1;
  if (index < count) return node->type == LAM_NODE_LIST ? &node->items[index] : slot;

  if (count == 0)
    lam_error_add(o->errors, o->location, NULL, "index [%d] of an empty list", index);
  else
    lam_error_add(o->errors, o->location, NULL, "index [%d] of a list of %d; expected 0 to %d",
                  index, count, count - 1);
  return NULL;
}

/* Puts a value where the path leads, from the root down. Nothing is set when a step has none. */
static void set_value(const override *o, lam_node **root, const char *path, lam_node *value) {
  step steps[max_steps];
  int count = read_path(o, path, steps);
  lam_node **slot = count > 0 ? root : NULL;
  for (int i = 0; i < count && slot; i++) {
    slot =
        steps[i].name ? enter_name(o, slot, steps[i].name) : enter_index(o, slot, steps[i].index);
  }
  if (slot) *slot = value;
}

/* The path before the '=' becomes the location of all messages: "--set net.grid". */
void lam_tree_override(lam_arena *arena, lam_node **root, const char *text, lam_errors *errors) {
  const char *equals = strchr(text, '=');
  int length = equals ? (int)(equals - text) : (int)strlen(text);
  char *path = lam_arena_printf(arena, "%.*s", length > 200 ? 200 : length, text);
  override o = {arena, errors, {lam_arena_printf(arena, "--set %s", path), 0, 0}};

  if (!equals) {
    complain(&o, "expected key=value, such as net.grid=[40,40]");
    return;
  }
  if (length > 200) {
    complain(&o, "a key of more than 200 characters");
    return;
  }

  /* The value is read as a document of its own; nothing behind the '=' empties the key. */
  int before = errors->count;
  lam_node *value = lam_tree_read(arena, equals + 1, strlen(equals + 1), o.location, true, errors);
  if (errors->count > before) return;
  set_value(&o, root, path, value ? value : empty_value(&o));
}
