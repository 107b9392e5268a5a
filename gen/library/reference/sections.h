/* Everything that can be listed and shown, in sections: one list for lam_reference_list and
 * lam_reference_page. */
#ifndef LAM_LIBRARY_REFERENCE_SECTIONS_H
#define LAM_LIBRARY_REFERENCE_SECTIONS_H

#include "library/session_state.h"

/* One entry. Texts are NULL when there is nothing to say. */
typedef struct lam_listed {
  const char *name, *title, *doc, *equation, *source;
  const lam_key *keys;
  const char *file;          /* of a design, to be shown whole */
  const char *use, *trouble; /* what it is for, what can go wrong */
  const char *facts;         /* lines of further facts, under "How it is made" */
} lam_listed;

typedef struct lam_section {
  const char *name, *noun; /* "surfaces", "surface" */
  const char *doc;         /* where its entries are written in a design */
  const char *usage; /* how an entry is written, with %s for its name; NULL when it is not a kind */
  const lam_key *common; /* keys that every entry accepts; NULL when there are none */
  const lam_registry *registry;
  /* The entries, owned by the session. */
  lam_listed *(*collect)(lam_session *session, const struct lam_section *section, int *count);
} lam_section;

extern const lam_section lam_sections[]; /* ends with a section whose name is NULL */
/* NULL-terminated names of the sections. */
const char *const *lam_section_names(lam_arena *arena);

#endif
