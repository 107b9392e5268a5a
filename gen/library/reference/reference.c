/* The reference manual: lists of names, and pages. Called through lamella/reference.h, by
 * cli/verb_list.c and cli/verb_show.c. */
#include <lamella/reference.h>

#include "core/file.h"
#include "core/grow.h"
#include "design/design.h"
#include "design/tree.h"
#include "library/names.h"
#include "library/reference/page.h"
#include "library/reference/sections.h"
#include "library/reference/wrap.h"

#include <string.h>

/* ---- lists ---- */

/* The columns of the longest title, or name. */
static int widest(const lam_listed *listed, int count, bool titles) {
  int width = 0;
  for (int i = 0; i < count; i++) {
    const char *words = titles ? listed[i].title : listed[i].name;
    int columns = words ? lam_columns(words) : 0;
    if (columns > width) width = columns;
  }
  return width;
}

/* Name and title in columns; designs have their source as a third one. */
static void add_section(lam_session *session, lam_text *text, const lam_section *section,
                        int indent) {
  int count = 0;
  const lam_listed *listed = section->collect(session, section, &count);
  int names = widest(listed, count, false), titles = widest(listed, count, true);

  for (int i = 0; i < count; i++) {
    lam_spaces(text, indent);
    lam_text_add(text, listed[i].name);
    lam_spaces(text, names - lam_columns(listed[i].name) + 2);
    lam_text_add(text, listed[i].title ? listed[i].title : "");

    if (listed[i].file && listed[i].source) {
      lam_spaces(text, titles - lam_columns(listed[i].title) + 2);
      lam_text_add(text, listed[i].source);
    }
    lam_text_add(text, "\n");
  }
}

/* chosen: the name of a section, or NULL: all of them, under their names. */
static lam_status list(lam_session *session, const char *chosen, const char **out) {
  lam_text text = {.arena = session->arena};
  if (chosen && !lam_name_known(&session->errors, lam_section_names(session->arena), chosen,
                                "nothing is called", NULL))
    return LAM_OK;

  for (const lam_section *section = lam_sections; section->name; section++) {
    if (chosen && strcmp(chosen, section->name) != 0) continue;
    if (!chosen) lam_text_printf(&text, "%s%s\n", text.length ? "\n" : "", section->name);
    add_section(session, &text, section, chosen ? 0 : 2);
  }

  /* Designs are files: without their folder the list of all says so, and theirs is no list. */
  if (chosen && strcmp(chosen, "designs") == 0 && !lam_session_needs_templates(session))
    return LAM_OK;
  if (!chosen && !lam_session_templates(session))
    lam_text_add(&text, "\nno designs: the templates folder is not found; set LAMELLA_TEMPLATES\n");

  *out = text.length ? text.data : "";
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/reference.h. */
lam_status lam_reference_list(lam_session *session, const char *section, const char **text) {
  *text = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, list(session, section, text));
}

/* ---- pages ---- */

/* A shipped design is its own best page: its file follows the title. */
static void add_file(lam_text *text, const char *path) {
  lam_errors unread = {.arena = text->arena};
  char *bytes = NULL;
  size_t count = 0;
  if (lam_file_read(text->arena, path, (size_t)LAM_DESIGN_MAX_BYTES, &unread, &bytes, &count) !=
      LAM_OK)
    return;

  lam_text_add(text, "\n");
  lam_text_bytes(text, bytes, count);
}

/* The page of the design language itself: what no key says, then the table of all keys. */
static void add_language(lam_text *text) {
  lam_text_add(text, "design: the keys of a design file\n\n  ");
  lam_wrap(text,
           "A design is a YAML map. Lengths and angles are written with their unit (100 mm, 60 "
           "deg), flags as yes or no. Stages are optional and run top to bottom: surface, net, "
           "parts. A map may be written by its first key alone: net: asymptotic is net: {kind: "
           "asymptotic}. A single value stands for a list of one. --set KEY=VALUE overrides any "
           "key: --set net.grid=[40,40], --set parts[0].height='80 mm'.",
           2, 2);
  lam_text_add(text, "\nKeys\n");
  lam_page_keys(text, lam_design_keys, 2);
}

/* The names of all entries, for a guess. */
typedef struct known_names {
  int count, capacity;
  const char **items; /* NULL-terminated when all are added */
} known_names;

/* The pages of all entries of a section with this name; a rule stands between pages. */
static void add_pages(lam_session *session, lam_text *text, const lam_section *section,
                      const char *name, known_names *known) {
  int count = 0;
  const lam_listed *listed = section->collect(session, section, &count);
  for (int i = 0; i < count; i++) {
    LAM_APPEND(session->arena, known->items, known->count, known->capacity, listed[i].name);
    if (strcmp(listed[i].name, name) != 0) continue;
    if (text->length) lam_text_add(text, "\n----\n\n");
    lam_page_entry(text, section, &listed[i]);
    if (listed[i].file) add_file(text, listed[i].file);
  }
}

/* Every section is looked through: a name may stand in several of them. */
static lam_status page(lam_session *session, const char *name, const char **out) {
  lam_text text = {.arena = session->arena};
  known_names known = {0};
  LAM_APPEND(session->arena, known.items, known.count, known.capacity, "design");
  if (strcmp(name, "design") == 0) add_language(&text);
  for (const lam_section *section = lam_sections; section->name; section++)
    add_pages(session, &text, section, name, &known);
  LAM_APPEND(session->arena, known.items, known.count, known.capacity, NULL);

  if (text.length)
    *out = text.data;
  else
    lam_name_known(&session->errors, known.items, name, "nothing is called",
                   lam_session_templates(session)
                       ? "lamella list shows all names"
                       : "the templates folder with the designs is not found; set "
                         "LAMELLA_TEMPLATES");
  return LAM_OK;
}

/* The page stays NULL when nothing has the name. */
lam_status lam_reference_page(lam_session *session, const char *name, const char **text) {
  *text = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, page(session, name, text));
}
