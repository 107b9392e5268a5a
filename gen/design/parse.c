/* A design from its text: the tree with its overrides, filled by the key tables, then the checks
 * that tables cannot make. Called by library/ and bench/. */
#include "design/design.h"
#include "design/fill.h"
#include "design/tree.h"
#include "fab/workshop.h"
#include "net/handles.h"
#include "surf/placement.h"

#include <string.h>

/* The tree of a design with its overrides; NULL, with a message, when there is nothing to fill
 * from. */
static lam_node *read_tree(lam_arena *arena, const lam_design_text *text, lam_errors *errors) {
  lam_location origin = {text->path, 0, 0};
  int before = errors->count;
  lam_node *root = lam_tree_read(arena, text->bytes, text->count, origin, false, errors);
  if (!root && errors->count > before) return NULL;

  /* An empty file may get all of its content from overrides. */
  for (int i = 0; i < text->override_count; i++)
    lam_tree_override(arena, &root, text->overrides[i], errors);
  if (root && !lam_node_is_empty(root)) return root;

  origin.line = origin.column = 1;
  lam_error_add(errors, origin, NULL,
                "the file is empty; expected a map that begins with 'lamella: 1'");
  return NULL;
}

/* Without overrides and without added rows. */
bool lam_keys_parse(lam_arena *arena, const lam_key *keys, const char *bytes, size_t count,
                    const char *path, lam_errors *errors, void *params) {
  lam_design_text text = {.bytes = bytes, .count = count, .path = path};
  int before = errors->count;
  lam_node *root = read_tree(arena, &text, errors);
  lam_filler filler = {.arena = arena, .errors = errors};
  if (root) lam_fill_keys(&filler, keys, root, NULL, params);
  return errors->count == before;
}

/* ---- what tables cannot say ---- */

/* The item of a map with this key; NULL when there is none, or map is no map or NULL. */
static const lam_node *find(const lam_node *map, const char *key) {
  return map && map->type == LAM_NODE_MAP ? lam_node_find(map, key) : NULL;
}

/* Names become parts of file names and arguments of programs: nothing but letters, digits, - and _,
 * no - at the start, not too long. What is no text was told before. */
static void check_name(const lam_filler *filler, const lam_node *node, const lam_trail *trail) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  enum { longest = 64 };
  if (!node || node->type != LAM_NODE_SCALAR || lam_node_is_empty(node)) return;

  size_t length = strlen(node->text);
  if (length > 0 && length <= longest && node->text[0] != '-' &&
      strspn(node->text, letters) == length)
    return;

  lam_text text = lam_fill_given(filler, node);
  lam_text_printf(&text, "1 to %d letters, digits, - and _, with no - at the start", longest);
  lam_fill_complain(filler, node->location, trail, &text);
}

/* The value of a top-level key needs another key beside it. */
static void complain_alone(const lam_filler *filler, const lam_node *root, const char *key,
                           const char *words) {
  lam_trail trail = {NULL, key, 0};
  lam_text text = {.arena = filler->arena};
  lam_text_add(&text, words);
  lam_fill_complain(filler, find(root, key)->location, &trail, &text);
}

/* A stage needs the one before it: a net its surface, unless it makes its own start or begins with
 * a mesh; parts their net. */
static void check_stages(const lam_filler *filler, const lam_node *root, const lam_design *design) {
  const lam_net_common *net = design->net.common;
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;

  if (kind && !kind->start && !net->from.file && !net->from.design && !find(root, "surface")) {
    complain_alone(filler, root, "net",
                   "a net without a surface; expected surface: {...}, or from: {file: mesh.obj}");
  }

  if (design->parts.count > 0 && !find(root, "net")) {
    complain_alone(filler, root, "parts", "parts without a net; expected net: {...}");
  }
}

/* True when a message is about the value of key or about one inside it: "net", "net.grid", "net[0]"
 * (strchr finds the end of a text too); and when there are so many that it may have been left
 * out. */
static bool has_message(const lam_errors *errors, const char *key) {
  size_t length = strlen(key);
  if (errors->count > LAM_MOST_MESSAGES) return true;
  for (const lam_error *error = errors->first; error; error = error->next) {
    if (error->key && strncmp(error->key, key, length) == 0 && strchr(".[", error->key[length]))
      return true;
  }
  return false;
}

/* Keys of parts that do not go together: told with the row they are in. */
static void check_parts(const lam_filler *filler, const lam_design *design) {
  const lam_row *rows = design->parts.items;
  for (int i = 0; i < design->parts.count; i++) {
    const lam_part_kind *kind = (const lam_part_kind *)rows[i].head;
    const lam_error *last = filler->errors->last;
    if (!kind->check) continue;
    kind->check(rows, i, filler->errors);
    lam_errors_prefix(filler->errors, last, lam_arena_printf(filler->arena, "parts[%d]", i));
  }
}

/* Where to point to when the setting is not there: at the key, at `render`, or at the design. */
static lam_location location_of_setting(const lam_node *root) {
  const lam_node *render = find(root, "render"), *setting = find(render, "setting");
  return setting ? setting->location : render ? render->location : root->location;
}

/* All that tables cannot say. Keys are checked together only when each of them is right. */
static void check_root(const lam_filler *filler, const lam_node *root, const lam_design *design) {
  lam_trail name = {NULL, "name", 0}, render = {NULL, "render", 0};
  lam_trail setting = {&render, "setting", 0}, view = {&render, "view", 0};
  check_name(filler, find(root, "name"), &name);
  check_name(filler, find(find(root, "render"), "setting"), &setting);
  check_name(filler, find(find(root, "render"), "view"), &view);
  check_stages(filler, root, design);

  if (design->net.head && !has_message(filler->errors, "net"))
    lam_handles_check(design->net.common, design->net.location, filler->errors);
  if (design->surface.head && !has_message(filler->errors, "surface"))
    lam_placement_keys_check(design->surface.common, design->surface.location, filler->errors);
  if (!has_message(filler->errors, "parts")) check_parts(filler, design);
}

/* Everything is checked before it returns, so that all mistakes are shown at once. */
bool lam_design_parse(lam_arena *arena, const lam_design_text *text, lam_errors *errors,
                      lam_design *design) {
  int before = errors->count;
  *design = (lam_design){.path = lam_arena_copy(arena, text->path)};
  lam_design_text own = *text;
  own.path = design->path; /* messages and nodes outlive the caller's text */
  lam_node *root = read_tree(arena, &own, errors);
  if (!root) return false;

  lam_filler filler = {arena, errors, text->added};
  if (root->type != LAM_NODE_MAP) {
    lam_text words = lam_fill_given(&filler, root);
    lam_text_add(&words, "a map that begins with 'lamella: 1'");
    lam_fill_complain(&filler, root->location, NULL, &words);
    return false;
  }

  /* The tables first, then what they cannot say. */
  lam_fill_keys(&filler, lam_design_keys, root, NULL, design);
  check_root(&filler, root, design);

  /* Values that follow from others. */
  design->language = 1;
  design->render.quality = lam_qualities[design->render.quality_index];
  design->render.location = location_of_setting(root);
  if (!design->title) design->title = design->name;
  if (!design->source) design->source = "";
  return errors->count == before;
}
