#include "cli/mesh_files.h"
#include "core/file.h"
#include "formats/format.h"

enum { largest_mesh_file = 1 << 30 };

/* The format and content of a mesh file; NULL with a message. */
static const lam_format *open_mesh(lam_arena *arena, const char *path, lam_errors *errors, char **bytes,
                                   size_t *count) {
  const lam_format *format = lam_format_for(path);
  if (!format || !format->read_triangles) {
    lam_error_add(errors, (lam_place){.file = path}, NULL, "not a mesh file that is read; expected .obj or .stl");
    return NULL;
  }
  return lam_file_read(arena, path, largest_mesh_file, errors, bytes, count) == LAM_OK ? format : NULL;
}

bool lam_input_mesh(lam_arena *arena, const char *path, lam_errors *errors, lam_mesh *mesh) {
  char *bytes;
  size_t count;
  const lam_format *format = open_mesh(arena, path, errors, &bytes, &count);
  if (!format) return false;
  if (format->read_mesh) return format->read_mesh(arena, bytes, count, (lam_place){.file = path}, errors, mesh);
  lam_error_add(errors, (lam_place){.file = path}, NULL, "%s has no quads; expected .obj", format->name);
  return false;
}

bool lam_input_triangles(lam_arena *arena, const char *path, lam_errors *errors, lam_trimesh *mesh) {
  char *bytes;
  size_t count;
  const lam_format *format = open_mesh(arena, path, errors, &bytes, &count);
  return format && format->read_triangles(arena, bytes, count, (lam_place){.file = path}, errors, mesh);
}

static const char spline_endings[] = ".step, .stp, .igs, .iges, .json or .obj";

bool lam_input_surface(lam_arena *arena, const char *path, int face, lam_errors *errors, lam_spline_surface *surface,
                       const char **note) {
  lam_place place = {.file = path};
  const lam_format *format = lam_format_for(path);
  char *bytes;
  size_t count;
  lam_spline_list read;
  if (!format || !format->read_surfaces) {
    lam_error_add(errors, place, NULL, "not a file of surfaces; expected %s", spline_endings);
    return false;
  }
  if (lam_file_read(arena, path, largest_mesh_file, errors, &bytes, &count) != LAM_OK) return false;
  if (!format->read_surfaces(arena, bytes, count, place, errors, &read)) return false;
  if (face > read.count) {
    lam_error_add(errors, place, NULL, "face %d asked for, but the file has %d B-spline surface%s", face, read.count,
                  read.count == 1 ? "" : "s");
    return false;
  }
  *surface = read.items[face - 1];
  *note = read.notes[face - 1];
  return true;
}

bool lam_input_curves(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_named_curve **curves) {
  lam_place place = {.file = path};
  const lam_format *format = lam_format_for(path);
  char *bytes;
  size_t size;
  lam_curve_list read;
  if (!format || !format->read_curves) {
    lam_error_add(errors, place, NULL, "not a file of curves; expected %s", spline_endings);
    return false;
  }
  if (lam_file_read(arena, path, largest_mesh_file, errors, &bytes, &size) != LAM_OK) return false;
  if (!format->read_curves(arena, bytes, size, place, errors, &read)) return false;
  *count = read.count;
  *curves = read.items;
  return true;
}
