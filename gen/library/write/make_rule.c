/* A make rule with one target and its files, each also as a rule of its own: a file that is gone
 * later must not stop make. Called by models.c. */
#include "library/write/make_rule.h"
#include "core/file.h"
#include "core/text.h"

/* What would end a name in a rule, or begin something else, is escaped as make wants it. */
static void add_name(lam_text *text, const char *name) {
  for (; *name; name++) {
    if (*name == ' ' || *name == '#') lam_text_add(text, "\\");
    if (*name == '$') lam_text_add(text, "$");
    lam_text_bytes(text, name, 1);
  }
}

/* A rule under construction: the files that its target needs, and their empty rules. */
typedef struct rule {
  lam_text needs, empty;
} rule;

/* One more file that the target needs, on a line of its own. */
static void add_need(rule *r, const char *name) {
  lam_text_add(&r->needs, " \\\n  ");
  add_name(&r->needs, name);
  add_name(&r->empty, name);
  lam_text_add(&r->empty, ":\n");
}

/* The rule first, then the empty ones. */
void lam_make_rule_write(lam_session *session, const char *path, const char *folder,
                         const lam_origin *origin, const lam_paths *templates) {
  rule r = {{.arena = session->arena}, {.arena = session->arena}};
  add_name(&r.needs, lam_arena_printf(session->arena, "%s/report.json", folder));
  lam_text_add(&r.needs, ":");

  if (origin && origin->path) add_need(&r, origin->path);
  for (int i = 0; origin && i < origin->file_count; i++) add_need(&r, origin->files[i]);
  for (int i = 0; i < templates->count; i++) add_need(&r, templates->items[i]);

  lam_text_printf(&r.needs, "\n%s", r.empty.length ? r.empty.data : "");
  lam_file_write_atomic(path, r.needs.data, r.needs.length, &session->errors);
}
