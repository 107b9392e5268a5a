/* Files: what is written from a model, and what is read. The formats are those of
 * lam_reference_list(session, "formats", ...). */
#ifndef LAMELLA_FORMAT_H
#define LAMELLA_FORMAT_H

#include <lamella/model.h>
#include <lamella/session.h>

LAM_BEGIN_DECLS

/* ---- writing into a folder ---- */

/* How a model is written into a folder. Zeroed, with a folder, it writes everything. Texts are read
 * during the call only. */
typedef struct lam_write_options {
  const char *folder; /* made when it is missing; not NULL */
  const char *only;   /* formats to write, separated by commas, without spaces; NULL: all */
  const char *skip;   /* formats not to write, in the same form; NULL: none */
  const char *deps;   /* file for a make rule: what folder/report.json was made from; NULL: none */
  bool timings; /* the report tells the seconds of every stage: not the same bytes every time */
} lam_write_options;

/* What was written; meaningful with LAM_OK. */
typedef struct lam_written {
  int file_count;
  const char *const *files; /* paths that start with the folder; owned by the session */
  int removed;  /* files of the last build of this design that this one does not make: taken away.
                  With only or skip none are */
  int left_out; /* files that could not be made, such as a picture without POV-Ray; the session's
                   notes say why */
} lam_written;

/* Whether the names in options->only and options->skip are formats, and no name is empty: to be
 * asked before a long computation. The folder may be NULL here. LAM_BAD_INPUT, LAM_NO_MEMORY. */
LAM_API lam_status lam_write_options_check(lam_session *session, const lam_write_options *options);

/* Writes all that the model gives, and the templates that the files need beside them. A format that
 * is made from another one brings that with it: the picture its scene. The names of the files are
 * kept in folder/.lamella-files, for the next build of the same design.
 *
 * Every file appears complete or not at all, and report.json last: when it is there, so is all
 * else. While a build writes, no other one writes into the folder: it waits, up to ten minutes.
 * Nothing that the model was made from is overwritten, and no link to a folder is followed. A file
 * that was changed since the last build is kept as NAME~, with a note. A picture that cannot be
 * rendered, because POV-Ray is missing or fails, is a note (lam_session_notes) and no error.
 *
 *   model    not changed
 *   written  may be NULL
 *
 *   LAM_BAD_INPUT  a format that does not exist, an output that is an input or lies behind a link,
 *                  a path that options->deps cannot name; nothing was written
 *   LAM_IO         a file cannot be written, the templates are not found, or another build goes on
 *                  writing into the folder
 *   LAM_FAILED     the library behind a format failed
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_model_write(lam_session *session, const lam_model *model,
                                   const lam_write_options *options, lam_written *written);

/* ---- writing into memory ---- */

/* One file as bytes, for programs that write files themselves. Owned by the session. */
typedef struct lam_bytes {
  const char *name; /* relative to the output folder, for instance "parts/A07a.stl" */
  const char *data; /* length bytes, followed by a zero that is not counted */
  size_t length;
} lam_bytes;

/* The number of files that a format makes of the model; 0 when it has nothing to write, or is made
 * by another program (png), or does not exist. Any thread. */
LAM_API int lam_model_file_count(const lam_model *model, const char *format);
/* File i of a format, 0 <= i < lam_model_file_count. Nothing is written to disk, and templates that
 * the file needs beside it are not given. The same bytes every time: the report has no seconds.
 * *file is meaningful with LAM_OK.
 *
 *   LAM_BAD_INPUT  there is no such file
 *   LAM_FAILED     the library behind the format failed
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_model_encode(lam_session *session, const lam_model *model,
                                    const char *format, int i, lam_bytes *file);

/* ---- reading ----
 * The format follows from the ending. Lengths are in meters afterwards: STL files are in
 * millimeters, other meshes in meters, CAD files say their unit. What is read is owned by the
 * session, and meaningful with LAM_OK. All return
 *
 *   LAM_BAD_INPUT  the ending is of no format that holds this, or the content is wrong (the message
 *                  has the line)
 *   LAM_IO         the file cannot be read
 *   LAM_NO_MEMORY */

/* The faces of a mesh file (.obj, .off, .ply), with three or four corners each; nets take quads
 * alone. Vertices in no face are left out, and faces that are turned the other way are turned;
 * lam_session_notes says so. */
LAM_API lam_status lam_read_mesh(lam_session *session, const char *path, lam_mesh *mesh);
/* The triangles of a mesh file (.obj, .off, .ply, .stl); faces with more corners are split into
 * triangles. */
LAM_API lam_status lam_read_triangles(lam_session *session, const char *path, lam_trimesh *mesh);
/* Surface number face (from 1) of a CAD file. *note: what of it is not read, such as its trimming
 * curves, as a sentence; NULL: nothing. */
LAM_API lam_status lam_read_surface(lam_session *session, const char *path, int face,
                                    lam_spline_surface *surface, const char **note);
/* All curves of a CAD file, those that bound its surfaces included: (*curves)[0 .. *count - 1]. */
LAM_API lam_status lam_read_curves(lam_session *session, const char *path, int *count,
                                   const lam_named_curve **curves);
/* All points of a text file (.xyz, .csv, ...), with the numbers as they are written there, or the
 * vertices of a mesh file in meters: (*points)[0 .. *count - 1]. */
LAM_API lam_status lam_read_points(lam_session *session, const char *path, int *count,
                                   const lam_vec3 **points);

LAM_END_DECLS

#endif
