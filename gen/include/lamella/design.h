/* Designs: reading them with all the files and other designs that they name, checking, building. */
#ifndef LAMELLA_DESIGN_H
#define LAMELLA_DESIGN_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

typedef struct lam_design lam_design;

/* A design's text and what is changed in it. */
typedef struct lam_design_source {
  const char *path;             /* of the file; files that the design names lie beside it */
  const char *text;             /* instead of the file's content, UTF-8; NULL: the file is read */
  size_t length;                /* of text, in bytes */
  int override_count;           /* changes, in order */
  const char *const *overrides; /* such as "net.grid=[40,40]", "parts[0].height=80 mm" */
} lam_design_source;

/* Reads a design and checks all that shows without computing: keys, units, ranges, files that are
 * missing, measures and settings that do not exist. Every mistake is a message. With text, path is
 * for messages and for finding files beside it, and may be NULL (the current folder).
 * LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY; *design is NULL then. */
LAM_API lam_status lam_design_read(lam_session *session, const lam_design_source *source,
                                   const lam_design **design);
/* The same, and makes the surface, which shows mistakes that keys have only together. This may take
 * as long as computing the surface. */
LAM_API lam_status lam_design_check(lam_session *session, const lam_design_source *source,
                                    const lam_design **design);

/* What a design would make, in lines for a person, in *text. LAM_NO_MEMORY. */
LAM_API lam_status lam_design_describe(lam_session *session, const lam_design *design,
                                       const char **text);
/* The name of a design, which is that of its files. */
LAM_API const char *lam_design_name(const lam_design *design);

/* Reads what the design names (each file once, other designs are built as far as their net) and
 * builds the model. A net that does not converge is no error: the report says so, see
 * lam_report_converged. The design is not changed. LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY; *model is
 * NULL then. */
LAM_API lam_status lam_design_build(lam_session *session, const lam_design *design,
                                    const lam_model **model);

/* Whether every stage of a report converged. */
LAM_API bool lam_report_converged(const lam_report *report);

/* Copies a shipped design, and the files that it names, to start from: to target, or to NAME.yaml in
 * the current folder when target is NULL. Nothing is overwritten: a file that is there already and
 * differs is LAM_BAD_INPUT. *files: the paths that were written, NULL-terminated. */
LAM_API lam_status lam_design_copy(lam_session *session, const char *name, const char *target,
                                   const char *const **files);

LAM_END_DECLS

#endif
