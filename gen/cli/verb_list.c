/* lamella list [SECTION]: what there is, by name and title. */
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "library/registries.h"
#include "library/wrap.h"

#include <stdio.h>
#include <string.h>

static const char usage[] =
    "usage: lamella list [surfaces|nets|constraints|measures|parts|materials|formats|designs]";

static int widest(const lam_listed *listed, int count, const char *(*text_of)(const lam_listed *)) {
  int width = 0;
  for (int i = 0; i < count; i++) {
    const char *words = text_of(&listed[i]);
    int columns = words ? lam_columns(words) : 0;
    if (columns > width) width = columns;
  }
  return width;
}

static const char *name_of(const lam_listed *listed) { return listed->name; }
static const char *title_of(const lam_listed *listed) { return listed->title; }

static void add_section(lam_text *text, const lam_section *section, int indent) {
  int count = 0;
  const lam_listed *listed = section->collect(text->arena, section, &count);
  int names = widest(listed, count, name_of), titles = widest(listed, count, title_of);
  for (int i = 0; i < count; i++) {
    lam_spaces(text, indent);
    lam_text_add(text, listed[i].name);
    lam_spaces(text, names - lam_columns(listed[i].name) + 2);
    lam_text_add(text, listed[i].title ? listed[i].title : "");
    if (listed[i].file && listed[i].source) { /* designs have a third column */
      lam_spaces(text, titles - lam_columns(listed[i].title) + 2);
      lam_text_add(text, listed[i].source);
    }
    lam_text_add(text, "\n");
  }
}

static int unknown_section(lam_arena *arena, const char *name) {
  const char *guess = lam_did_you_mean(name, lam_section_names(arena));
  if (guess)
    return lam_complain_plain(2, "list: nothing is called %s (did you mean %s?)\n%s", name, guess,
                              usage);
  return lam_complain_plain(2, "list: nothing is called %s\n%s", name, usage);
}

static int list(lam_arena *arena, int argc, char **argv) {
  const char *chosen = argc > 1 ? argv[1] : NULL;
  lam_text text = {.arena = arena};
  bool found = false;
  if (argc > 2) return lam_complain_plain(2, "list: too many arguments\n%s", usage);
  if (chosen && strcmp(chosen, "--help") == 0) return puts(usage) < 0;
  for (const lam_section *section = lam_sections; section->name; section++) {
    if (chosen && strcmp(chosen, section->name) != 0) continue;
    if (!chosen) lam_text_printf(&text, "%s%s\n", found ? "\n" : "", section->name);
    add_section(&text, section, chosen ? 0 : 2);
    found = true;
  }
  if (!found) return unknown_section(arena, chosen);
  if (text.length > 0) fputs(text.data, stdout);
  return 0;
}

int lam_verb_list(int argc, char **argv) { return lam_verb_run(list, argc, argv); }
