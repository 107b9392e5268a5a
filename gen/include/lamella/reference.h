/* The reference manual: everything that has a name, as text for a person, made from the registries. */
#ifndef LAMELLA_REFERENCE_H
#define LAMELLA_REFERENCE_H

#include <lamella/session.h>

LAM_BEGIN_DECLS

/* The names and titles of a section (surfaces, nets, constraints, measures, parts, materials,
 * formats, designs), a line each; section NULL: all, under headings. LAM_BAD_INPUT: there is no such
 * section. LAM_NO_MEMORY. */
LAM_API lam_status lam_reference_list(lam_session *session, const char *section, const char **text);
/* The page of anything that is listed, or "design": the keys of a design file. LAM_BAD_INPUT: nothing
 * has that name. LAM_NO_MEMORY. */
LAM_API lam_status lam_reference_page(lam_session *session, const char *name, const char **text);

LAM_END_DECLS

#endif
