/* Opening a file and handing its bytes to the format that its ending names. Called through
 * lamella/format.h, by sources.c, compare_meshes.c and bench/bench_run.c. */
#include "library/read_files.h"
#include "core/file.h"
#include "formats/list/formats.h"
#include "library/session_state.h"
#include "library/start_mesh.h"
#include <lamella/format.h>

enum { largest_file = 1 << 30 };

/* A file that was read: its format and its bytes. */
typedef struct opened {
  const lam_format *format;
  lam_location location;
  char *bytes;
  size_t count;
} opened;

/* Reads a file that should hold this content; noun names it in the message. False with a
 * message. */
static bool open_file(lam_arena *arena, const char *path, lam_content content, const char *noun,
                      lam_errors *errors, opened *file) {
  *file = (opened){.format = lam_format_for(path), .location = {.file = path}};
  if (!file->format || !lam_format_reads(file->format, content)) {
    lam_error_add(errors, file->location, NULL, "not a %s; expected %s", noun,
                  lam_format_endings(arena, content));
    return false;
  }
  return lam_file_read(arena, path, largest_file, errors, &file->bytes, &file->count) == LAM_OK;
}

bool lam_input_mesh(lam_arena *arena, const char *path, lam_errors *errors, lam_mesh *mesh) {
  opened f;
  return open_file(arena, path, LAM_CONTENT_MESH, "file of quads", errors, &f) &&
         f.format->read_mesh(arena, f.bytes, f.count, f.location, errors, mesh);
}

/* Faces of more corners become triangles in the format. */
bool lam_input_triangles(lam_arena *arena, const char *path, lam_errors *errors,
                         lam_trimesh *mesh) {
  opened f;
  return open_file(arena, path, LAM_CONTENT_TRIANGLES, "mesh file that is read", errors, &f) &&
         f.format->read_triangles(arena, f.bytes, f.count, f.location, errors, mesh);
}

/* A format reads all surfaces of a file; one of them is taken. */
bool lam_input_surface(lam_arena *arena, const char *path, int face, lam_errors *errors,
                       lam_spline_surface *surface, const char **note) {
  opened f;
  lam_spline_list read;
  if (!open_file(arena, path, LAM_CONTENT_SURFACES, "file of surfaces", errors, &f)) return false;
  if (!f.format->read_surfaces(arena, f.bytes, f.count, f.location, errors, &read)) return false;

  if (face < 1 || face > read.count) {
    lam_error_add(errors, f.location, NULL,
                  "face %d asked for, but the file has %d B-spline surface%s", face, read.count,
                  read.count == 1 ? "" : "s");
    return false;
  }

  *surface = read.items[face - 1];
  *note = read.notes[face - 1];
  return true;
}

/* A list of the format, taken apart. */
bool lam_input_curves(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_named_curve **curves) {
  opened f;
  lam_curve_list read;
  if (!open_file(arena, path, LAM_CONTENT_CURVES, "file of curves", errors, &f)) return false;
  if (!f.format->read_curves(arena, f.bytes, f.count, f.location, errors, &read)) return false;
  *count = read.count;
  *curves = read.items;
  return true;
}

/* A format without points of its own gives the vertices of its triangles. */
bool lam_input_points(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_vec3 **points) {
  opened f;
  lam_trimesh mesh;
  if (!open_file(arena, path, LAM_CONTENT_POINTS, "file of points", errors, &f)) return false;

  if (f.format->read_points)
    return f.format->read_points(arena, f.bytes, f.count, f.location, errors, count, points);
  if (!f.format->read_triangles(arena, f.bytes, f.count, f.location, errors, &mesh)) return false;
  *count = mesh.vertex_count;
  *points = mesh.vertices;
  return true;
}

/* ---- the face ----
 * Declared in include/lamella/format.h. The status is that of the messages. */

/* A mesh as a net can take it; what was done to it is told in notes. */
static lam_status read_mesh(lam_session *session, const char *path, lam_mesh *mesh) {
  lam_inputs inputs = {0};
  lam_net_source from = {0};
  if (!lam_start_mesh_read(session->arena, path, &from, (lam_location){0}, &session->errors,
                           &inputs))
    return LAM_OK;
  *mesh = *inputs.net;
  for (int i = 0; i < inputs.net_note_count; i++)
    lam_error_add(&session->notes, (lam_location){.file = path}, NULL, "%s", inputs.net_notes[i]);
  return LAM_OK;
}

lam_status lam_read_mesh(lam_session *session, const char *path, lam_mesh *mesh) {
  LAM_ENTER(session);
  return lam_session_leave(session, read_mesh(session, path, mesh));
}

lam_status lam_read_triangles(lam_session *session, const char *path, lam_trimesh *mesh) {
  LAM_ENTER(session);
  lam_input_triangles(session->arena, path, &session->errors, mesh);
  return lam_session_leave(session, LAM_OK);
}

/* Neither output is set when there is no such surface. */
lam_status lam_read_surface(lam_session *session, const char *path, int face,
                            lam_spline_surface *surface, const char **note) {
  LAM_ENTER(session);
  lam_input_surface(session->arena, path, face, &session->errors, surface, note);
  return lam_session_leave(session, LAM_OK);
}

/* Neither output is set when there are no curves. */
lam_status lam_read_curves(lam_session *session, const char *path, int *count,
                           const lam_named_curve **curves) {
  LAM_ENTER(session);
  lam_input_curves(session->arena, path, &session->errors, count, curves);
  return lam_session_leave(session, LAM_OK);
}

/* Points before a mistake may be set: the status tells. */
lam_status lam_read_points(lam_session *session, const char *path, int *count,
                           const lam_vec3 **points) {
  LAM_ENTER(session);
  lam_input_points(session->arena, path, &session->errors, count, points);
  return lam_session_leave(session, LAM_OK);
}
