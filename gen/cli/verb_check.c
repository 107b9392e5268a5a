/* lamella check DESIGN [--set KEY=VALUE]...: reads a design, finds everything wrong with it, and
 * says what would be built. */
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "core/file.h"
#include "design/design.h"
#include "design/tree.h"
#include "formats/format.h"
#include "library/references.h"
#include "library/value_text.h"
#include "library/wrap.h"
#include "net/net_kind.h"
#include "surf/placement.h"

#include <stdio.h>
#include <string.h>

static const char usage[] = "usage: lamella check DESIGN.yaml [--set KEY=VALUE]...";

enum { label_width = 10 };

typedef struct arguments {
  const char *path;
  lam_override *overrides;
  int override_count;
} arguments;

/* ---- what would be built ---- */

static void add_line(lam_text *text, const char *label, const char *words) {
  lam_text_add(text, label);
  lam_spaces(text, label_width - lam_columns(label));
  lam_wrap(text, words, label_width, label_width);
}

static void add_row(lam_text *text, const char *label, const lam_row *row, const lam_key *common) {
  lam_text words = {.arena = text->arena};
  lam_text values = {.arena = text->arena};
  if (!row->head) return;
  lam_value_text(&values, row->head->keys, row->params);
  if (common) {
    if (values.length > 0) lam_text_add(&values, ", ");
    lam_value_text(&values, common, row->common);
  }
  lam_text_printf(&words, "%s%s%s", row->head->name, values.length > 0 ? ": " : "",
                  values.length > 0 ? values.data : "");
  add_line(text, label, words.data);
}

static void add_map(lam_text *text, const char *label, const void *params) {
  for (const lam_key *key = lam_design_keys; key->name; key++) {
    if (strcmp(key->name, label) != 0) continue;
    lam_text words = {.arena = text->arena};
    lam_value_text(&words, key->keys, (const char *)params + key->offset);
    add_line(text, label, words.data);
  }
}

static void add_formats(lam_text *text) {
  lam_text words = {.arena = text->arena};
  lam_text_add(&words, "");
  for (int i = 0; i < lam_format_count; i++) {
    if (lam_formats[i]->path)
      lam_text_printf(&words, "%s%s", words.length > 0 ? ", " : "", lam_formats[i]->name);
  }
  add_line(text, "outputs", words.data);
}

static void describe(lam_text *text, const lam_design *design) {
  const lam_row *parts = design->parts.items;
  add_line(text, "design", lam_arena_printf(text->arena, "%s: %s", design->name, design->title));
  if (design->source[0]) add_line(text, "source", design->source);
  add_row(text, "surface", &design->surface, lam_placement_key_table);
  add_row(text, "net", &design->net, lam_net_common_keys);
  for (int i = 0; i < design->parts.count; i++) add_row(text, "part", &parts[i], NULL);
  if (design->parts.count > 0) add_map(text, "sheets", design);
  add_map(text, "render", design);
  add_formats(text);
}

/* ---- the verb ---- */

/* -1: go on; otherwise the exit status. */
static int read_arguments(lam_arena *arena, int argc, char **argv, arguments *out) {
  out->overrides = LAM_NEW(arena, lam_override, argc);
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--help") == 0) return puts(usage) < 0;
    if (strcmp(argv[i], "--set") == 0) {
      if (++i == argc) return lam_complain_plain(2, "check: --set without KEY=VALUE\n%s", usage);
      out->overrides[out->override_count++].text = argv[i];
    } else if (argv[i][0] == '-' || out->path) {
      return lam_complain_plain(2, "check: %s is not expected here\n%s", argv[i], usage);
    } else {
      out->path = argv[i];
    }
  }
  return out->path ? -1 : lam_complain_plain(2, "check: expected a design file\n%s", usage);
}

static int check(lam_arena *arena, int argc, char **argv) {
  arguments given = {0};
  lam_errors errors = {.arena = arena};
  lam_design design;
  char *bytes = NULL;
  size_t count = 0;
  int status = read_arguments(arena, argc, argv, &given);
  if (status >= 0) return status;
  if (lam_file_read(arena, given.path, (size_t)LAM_DESIGN_MAX_BYTES, &errors, &bytes, &count) !=
      LAM_OK)
    return lam_complain(&errors);
  if (lam_design_parse(arena, bytes, count, given.path, given.overrides, given.override_count,
                       &errors, &design)) {
    lam_references_check(&design, true, &errors);
  }
  if (errors.count > 0) return lam_complain(&errors);
  lam_text text = {.arena = arena};
  describe(&text, &design);
  fputs(text.data, stdout);
  return 0;
}

int lam_verb_check(int argc, char **argv) { return lam_verb_run(check, argc, argv); }
