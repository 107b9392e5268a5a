/* The reference manual: everything that has a name, as text for a person, made from the same tables
 * that designs are read with. */
#ifndef LAMELLA_REFERENCE_H
#define LAMELLA_REFERENCE_H

#include <lamella/session.h>

LAM_BEGIN_DECLS

/* The names and titles of a section, a line each.
 *
 *   section  surfaces, nets, constraints, measures, parts, materials, formats or designs; NULL: all
 *            of them, under headings
 *   text     UTF-8, owned by the session; NULL with any other status than LAM_OK
 *
 *   LAM_BAD_INPUT  there is no such section
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_reference_list(lam_session *session, const char *section, const char **text);

/* The page of anything that is listed, wrapped at 80 columns: what it is, its equation and source,
 * its keys with their defaults. Where several things have the name, their pages follow each other.
 *
 *   name  as listed, or "design": the keys of a design file
 *   text  UTF-8, owned by the session; NULL with any other status than LAM_OK
 *
 *   LAM_BAD_INPUT  nothing has that name
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_reference_page(lam_session *session, const char *name, const char **text);

LAM_END_DECLS

#endif
