/* Everything that can be listed and shown, in sections: one list for lam_reference_list and
 * lam_reference_page (reference.c); entries are turned into pages by page.c. */
#ifndef LAM_LIBRARY_REFERENCE_SECTIONS_H
#define LAM_LIBRARY_REFERENCE_SECTIONS_H

#include "library/session_state.h"

/* One entry. Texts are NULL when there is nothing to say. */
typedef struct lam_listed {
  const char *name, *title, *doc, *equation, *source;
  const lam_key *keys;       /* NULL: none */
  const char *file;          /* of a design, to be shown whole */
  const char *use, *trouble; /* what it is for, what can go wrong */
  const char *facts;         /* lines of further facts, under "How it is made" */
} lam_listed;

/* What is listed under one name. */
typedef struct lam_section {
  const char *name, *noun; /* "surfaces", "surface" */
  const char *doc;         /* where its entries are written in a design */
  const char *usage; /* how an entry is written, with %s for its name; NULL when it is not a kind */
  const lam_key *common;        /* keys that every entry accepts; NULL when there are none */
  const lam_registry *registry; /* whose rows are listed; NULL: the entries stand elsewhere */
  /* The entries, *count of them, owned by the session. */
  lam_listed *(*collect)(lam_session *session, const struct lam_section *section, int *count);
} lam_section;

extern const lam_section lam_sections[]; /* ends with a section whose name is NULL */
/* The names of the sections, NULL-terminated, in arena. */
const char *const *lam_section_names(lam_arena *arena);

#endif
