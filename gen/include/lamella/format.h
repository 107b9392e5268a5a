/* Files: what is written from a model, and what is read. The formats are those of
 * lam_reference_list(session, "formats", ...). */
#ifndef LAMELLA_FORMAT_H
#define LAMELLA_FORMAT_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

/* ---- writing ---- */

/* How a model is written into a folder. Zeroed, with a folder, it writes everything. */
typedef struct lam_write_options {
  const char *folder; /* made when it is missing */
  const char *only;   /* formats to write, separated by commas; NULL: all */
  const char *skip;   /* formats not to write; NULL: none */
  const char *deps;   /* file for a make rule: what folder/report.json was made from; NULL: none */
  bool timings;       /* the report tells the seconds of every stage: not the same bytes every time */
} lam_write_options;

/* What was written. */
typedef struct lam_written {
  int file_count;
  const char *const *files; /* paths that start with the folder */
  int removed; /* files of the last build of this design that this one does not make: taken away */
} lam_written;

/* Whether the names in options->only and options->skip are formats. LAM_BAD_INPUT. */
LAM_API lam_status lam_write_options_check(lam_session *session, const lam_write_options *options);
/* Writes all that the model gives, and the templates that the files need beside them. What needs a
 * program that is missing is left out with a note. written may be NULL. LAM_BAD_INPUT (a format that
 * does not exist), LAM_IO, LAM_FAILED, LAM_NO_MEMORY. */
LAM_API lam_status lam_model_write(lam_session *session, const lam_model *model,
                                   const lam_write_options *options, lam_written *written);

/* One file as bytes, for programs that write files themselves. */
typedef struct lam_bytes {
  const char *name; /* relative to the output folder, for instance "parts/A07a.stl" */
  const char *data; /* length bytes, followed by a zero that is not counted */
  size_t length;
} lam_bytes;

/* The number of files that a format makes of the model; 0 when it has nothing to write, or is made
 * by another program (png), or does not exist. */
LAM_API int lam_model_file_count(const lam_model *model, const char *format);
/* File i (0 <= i < count) of a format. LAM_BAD_INPUT (there is no such file), LAM_FAILED,
 * LAM_NO_MEMORY. */
LAM_API lam_status lam_model_encode(lam_session *session, const lam_model *model,
                                    const char *format, int i, lam_bytes *file);

/* ---- reading ----
 * The format follows from the ending. Lengths are in meters afterwards. What is read belongs to the
 * session. LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY. */

/* The quads of a mesh file. */
LAM_API lam_status lam_read_mesh(lam_session *session, const char *path, lam_mesh *mesh);
/* The triangles of a mesh file; quads are halved. */
LAM_API lam_status lam_read_triangles(lam_session *session, const char *path, lam_trimesh *mesh);
/* Surface number face (from 1) of a CAD file. *note: what of it is not read, NULL: nothing. */
LAM_API lam_status lam_read_surface(lam_session *session, const char *path, int face,
                                    lam_spline_surface *surface, const char **note);
/* All curves of a CAD file. */
LAM_API lam_status lam_read_curves(lam_session *session, const char *path, int *count,
                                   const lam_named_curve **curves);
/* All points of a text file (.xyz, .csv, ...), or the vertices of a mesh. */
LAM_API lam_status lam_read_points(lam_session *session, const char *path, int *count,
                                   const lam_vec3 **points);

LAM_END_DECLS

#endif
