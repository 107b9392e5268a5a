/* A make rule with one target and its files, each also as a rule of its own: a file that is gone
 * later must not stop make. Called by models.c. */
#include "library/write/make_rule.h"
#include "core/file.h"
#include "core/text.h"

#include <string.h>

/* What would end a name in a rule, or begin something else, is escaped as make wants it. */
static void add_name(lam_text *text, const char *name) {
  for (; *name; name++) {
    if (strchr(" #:*?[", *name)) lam_text_add(text, "\\");
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

/* The names of a rule: the target, then what it needs. Returns how many. */
static int names_of(lam_arena *arena, const char *folder, const lam_origin *origin,
                    const lam_output *output, const char ***names) {
  int files = origin ? origin->file_count : 0, count = 0;
  const char **all = LAM_NEW(arena, const char *, 2 + files + output->count);
  all[count++] = lam_arena_printf(arena, "%s/report.json", folder);
  if (origin && origin->path) all[count++] = origin->path;
  for (int i = 0; i < files; i++) all[count++] = origin->files[i];
  for (int i = 0; i < output->count; i++)
    if (output->files[i].template_path) all[count++] = output->files[i].template_path;
  *names = all;
  return count;
}

/* What a rule has no way to write: ; = | and % keep their meaning behind a backslash too, and a
 * backslash or a control character is not read as it stands. Tried with GNU make. */
static const char *unwritable(const char *name) {
  for (; *name; name++)
    if (strchr(";=|%\\", *name) || (unsigned char)*name < ' ') return name;
  return NULL;
}

void lam_make_rule_check(lam_session *session, const char *path, const char *folder,
                         const lam_origin *origin, const lam_output *output) {
  const char **names;
  int count = names_of(session->arena, folder, origin, output, &names);
  for (int i = 0; i < count; i++) {
    const char *bad = unwritable(names[i]);
    if (!bad) continue;
    bool control = (unsigned char)*bad < ' ';
    lam_error_add(&session->errors, (lam_location){.file = path}, "--deps",
                  "given %s; expected a path without %.*s, which a make rule cannot name", names[i],
                  control ? 18 : 1, control ? "control characters" : bad);
  }
}

/* The rule first, then the empty ones. */
lam_status lam_make_rule_write(lam_session *session, const char *path, const char *folder,
                               const lam_origin *origin, const lam_output *output) {
  rule r = {{.arena = session->arena}, {.arena = session->arena}};
  const char **names;
  int count = names_of(session->arena, folder, origin, output, &names);
  add_name(&r.needs, names[0]);
  lam_text_add(&r.needs, ":");
  for (int i = 1; i < count; i++) add_need(&r, names[i]);

  lam_text_printf(&r.needs, "\n%s", r.empty.length ? r.empty.data : "");
  return lam_file_write_atomic(path, r.needs.data, r.needs.length, &session->errors);
}
