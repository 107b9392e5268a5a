/* Designs: reading them with all the files and other designs that they name, checking, building.
 * A design file is a YAML map; its keys are lam_reference_page(session, "design", ...). */
#ifndef LAMELLA_DESIGN_H
#define LAMELLA_DESIGN_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

/* ---- reading ---- */

/* A design that was read: constant, and owned by the session that read it. */
typedef struct lam_design lam_design;

/* A design's text and what is changed in it. Zeroed, with a path, it is the file. Read during the
 * call only. */
typedef struct lam_design_source {
  const char *path;   /* of the file; files that the design names lie beside it. NULL only with
                         text: they lie in the current folder then */
  const char *text;   /* instead of the file's content: UTF-8; NULL: the file is read */
  size_t length;      /* of text, in bytes; a zero at its end is not needed */
  int override_count; /* changes, made in order before anything is checked */
  const char *const *overrides; /* such as "net.grid=[40,40]", "parts[0].height=80 mm" */
} lam_design_source;

/* Reads a design and checks all that shows without computing: keys, units, ranges, files that are
 * missing, measures and settings that do not exist. Every mistake is a message, with its line where
 * it is known.
 *
 *   design  owned by the session; NULL with any other status than LAM_OK
 *
 *   LAM_BAD_INPUT  the design is wrong
 *   LAM_IO         the file cannot be read
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_design_read(lam_session *session, const lam_design_source *source,
                                   const lam_design **design);
/* The same, and makes the surface and the net's start (unless that is the net of another design),
 * which shows mistakes that keys have only together. This may take as long as computing the
 * surface. Statuses as above; LAM_IO also for the files that are named. */
LAM_API lam_status lam_design_check(lam_session *session, const lam_design_source *source,
                                    const lam_design **design);

/* What a design would make, in lines for a person: *text is owned by the session, and NULL with
 * LAM_NO_MEMORY, the only failure. */
LAM_API lam_status lam_design_describe(lam_session *session, const lam_design *design,
                                       const char **text);
/* The name of a design, which is that of its files. Lives as long as the design. Any thread. */
LAM_API const char *lam_design_name(const lam_design *design);

/* ---- building ---- */

/* Builds the model: reads what the design names (each file once; other designs are built as far as
 * their net), then makes surface, net, parts and sheets. A net that does not converge is no error:
 * the report says so, see lam_report_converged.
 *
 *   design  not changed; read by this session, and kept by the model
 *   model   owned by the session; NULL with any other status than LAM_OK
 *
 *   LAM_BAD_INPUT  keys that do not fit together, a file that is damaged, a design in net.from that
 *                  is wrong, has no net or does not converge
 *   LAM_IO         a file that the design names cannot be read
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_design_build(lam_session *session, const lam_design *design,
                                    const lam_model **model);

/* Whether every stage of a report converged; stages that do not iterate count as converged unless
 * they failed. report: that of a model, not NULL. Any thread. */
LAM_API bool lam_report_converged(const lam_report *report);

/* ---- shipped designs ---- */

/* Copies a shipped design, and the files that it names, to start from. Nothing is overwritten, and
 * nothing is written before everything was checked; files beside the target that are there already
 * with the same bytes are fine.
 *
 *   name    one of lam_reference_list(session, "designs", ...)
 *   target  the new file, in a folder that exists; NULL: NAME.yaml in the current folder
 *   files   the paths that were written, NULL-terminated, owned by the session; meaningful with
 *           LAM_OK
 *
 *   LAM_BAD_INPUT  there is no such design, or a file that would be written is there
 *   LAM_IO         a file cannot be read or written; what was written before it stays
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_design_copy(lam_session *session, const char *name, const char *target,
                                   const char *const **files);

LAM_END_DECLS

#endif
