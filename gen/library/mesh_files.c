#include "library/mesh_files.h"
#include "core/file.h"
#include "formats/format.h"
#include "formats/mesh/points.h"
#include <string.h>
#include <strings.h>

enum { largest_mesh_file = 1 << 30 };

/* The format and content of a mesh file; NULL with a message. */
static const lam_format *open_mesh(lam_arena *arena, const char *path, lam_errors *errors,
                                   char **bytes, size_t *count) {
  const lam_format *format = lam_format_for(path);
  if (!format || !format->read_triangles) {
    lam_error_add(errors, (lam_location){.file = path}, NULL,
                  "not a mesh file that is read; expected .obj or .stl");
    return NULL;
  }
  return lam_file_read(arena, path, largest_mesh_file, errors, bytes, count) == LAM_OK ? format
                                                                                       : NULL;
}

bool lam_input_mesh(lam_arena *arena, const char *path, lam_errors *errors, lam_mesh *mesh) {
  char *bytes;
  size_t count;
  const lam_format *format = open_mesh(arena, path, errors, &bytes, &count);
  if (!format) return false;
  if (format->read_mesh)
    return format->read_mesh(arena, bytes, count, (lam_location){.file = path}, errors, mesh);
  lam_error_add(errors, (lam_location){.file = path}, NULL, "%s has no quads; expected .obj",
                format->name);
  return false;
}

bool lam_input_triangles(lam_arena *arena, const char *path, lam_errors *errors,
                         lam_trimesh *mesh) {
  char *bytes;
  size_t count;
  const lam_format *format = open_mesh(arena, path, errors, &bytes, &count);
  return format &&
         format->read_triangles(arena, bytes, count, (lam_location){.file = path}, errors, mesh);
}

static const char spline_endings[] = ".step, .stp, .igs, .iges, .json or .obj";

bool lam_input_surface(lam_arena *arena, const char *path, int face, lam_errors *errors,
                       lam_spline_surface *surface, const char **note) {
  lam_location location = {.file = path};
  const lam_format *format = lam_format_for(path);
  char *bytes;
  size_t count;
  lam_spline_list read;
  if (!format || !format->read_surfaces) {
    lam_error_add(errors, location, NULL, "not a file of surfaces; expected %s", spline_endings);
    return false;
  }
  if (lam_file_read(arena, path, largest_mesh_file, errors, &bytes, &count) != LAM_OK) return false;
  if (!format->read_surfaces(arena, bytes, count, location, errors, &read)) return false;
  if (face > read.count) {
    lam_error_add(errors, location, NULL,
                  "face %d asked for, but the file has %d B-spline surface%s", face, read.count,
                  read.count == 1 ? "" : "s");
    return false;
  }
  *surface = read.items[face - 1];
  *note = read.notes[face - 1];
  return true;
}

bool lam_input_curves(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_named_curve **curves) {
  lam_location location = {.file = path};
  const lam_format *format = lam_format_for(path);
  char *bytes;
  size_t size;
  lam_curve_list read;
  if (!format || !format->read_curves) {
    lam_error_add(errors, location, NULL, "not a file of curves; expected %s", spline_endings);
    return false;
  }
  if (lam_file_read(arena, path, largest_mesh_file, errors, &bytes, &size) != LAM_OK) return false;
  if (!format->read_curves(arena, bytes, size, location, errors, &read)) return false;
  *count = read.count;
  *curves = read.items;
  return true;
}

/* Whether the file is text with a point in each line, by its ending. */
static bool is_point_list(const char *path) {
  static const char *const endings[] = {".xyz", ".pts", ".csv", ".txt", ".asc"};
  const char *ending = strrchr(path, '.');
  for (size_t i = 0; ending && i < sizeof endings / sizeof endings[0]; i++)
    if (strcasecmp(ending, endings[i]) == 0) return true;
  return false;
}

bool lam_input_points(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_vec3 **points) {
  lam_location location = {.file = path};
  char *bytes;
  size_t size;
  if (is_point_list(path))
    return lam_file_read(arena, path, largest_mesh_file, errors, &bytes, &size) == LAM_OK &&
           lam_points_parse(arena, bytes, size, location, errors, count, points);
  const lam_format *format = lam_format_for(path);
  lam_trimesh mesh;
  if (!format || !format->read_triangles) {
    lam_error_add(errors, location, NULL,
                  "not a file of points; expected .xyz, .pts, .csv, .txt, .asc, .obj or .stl");
    return false;
  }
  if (!lam_input_triangles(arena, path, errors, &mesh)) return false;
  *count = mesh.vertex_count;
  *points = mesh.vertices;
  return true;
}
