/* lamella show NAME: the reference page of anything that is listed. */
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "core/file.h"
#include "design/design.h"
#include "design/tree.h"
#include "library/page.h"
#include "library/registries.h"
#include "library/wrap.h"

#include <stdio.h>
#include <string.h>

static const char usage[] = "usage: lamella show NAME   (a name from lamella list, or design for "
                            "the keys of a design file)";

/* A shipped design is its own best page: its file follows the title. */
static void add_file(lam_text *text, const char *path) {
  lam_errors errors = {.arena = text->arena};
  char *bytes = NULL;
  size_t count = 0;
  if (lam_file_read(text->arena, path, (size_t)LAM_DESIGN_MAX_BYTES, &errors, &bytes, &count) !=
      LAM_OK)
    return;
  lam_text_add(text, "\n");
  lam_text_bytes(text, bytes, count);
}

static void add_language(lam_text *text) {
  lam_text_add(text, "design: the keys of a design file\n\n  ");
  lam_wrap(text,
           "A design is a YAML map. Lengths and angles are written with their unit (100 mm, 60 "
           "deg), flags as yes or no. "
           "Stages are optional and run top to bottom: surface, net, parts. A map may be written "
           "by its first key alone: "
           "net: asymptotic is net: {kind: asymptotic}. A single value stands for a list of one. "
           "--set KEY=VALUE overrides "
           "any key: --set net.grid=[40,40], --set parts[0].height='80 mm'.",
           2, 2);
  lam_text_add(text, "\nKeys\n");
  lam_page_keys(text, lam_design_keys, 2);
}

/* The pages of all entries with this name; names collects what there is, for a guess. Returns the
 * number found. */
static int add_pages(lam_text *text, const char *name, const char **names, int most) {
  int found = 0, known = 0;
  names[known++] = "design";
  if (strcmp(name, "design") == 0) {
    add_language(text);
    found++;
  }
  for (const lam_section *section = lam_sections; section->name; section++) {
    int count = 0;
    const lam_listed *listed = section->collect(text->arena, section, &count);
    for (int i = 0; i < count; i++) {
      if (known < most) names[known++] = listed[i].name;
      if (strcmp(listed[i].name, name) != 0) continue;
      if (found++ > 0) lam_text_add(text, "\n----\n\n");
      lam_page_entry(text, section, &listed[i]);
      if (listed[i].file) add_file(text, listed[i].file);
    }
  }
  return found;
}

static int show(lam_arena *arena, int argc, char **argv) {
  enum { most = 2000 };
  const char **names = LAM_NEW(arena, const char *, most + 1);
  lam_text text = {.arena = arena};
  if (argc == 2 && strcmp(argv[1], "--help") == 0) return puts(usage) < 0;
  if (argc != 2) return lam_complain_plain(2, "show: expected one name\n%s", usage);
  if (add_pages(&text, argv[1], names, most) > 0) {
    fputs(text.data, stdout);
    return 0;
  }
  const char *guess = lam_did_you_mean(argv[1], names);
  if (guess)
    return lam_complain_plain(2, "show: nothing is called %s (did you mean %s?)", argv[1], guess);
  return lam_complain_plain(2, "show: nothing is called %s; lamella list shows all names", argv[1]);
}

int lam_verb_show(int argc, char **argv) { return lam_verb_run(show, argc, argv); }
