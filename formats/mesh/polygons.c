/* Vertices and faces on their way from a file to a mesh. Called by obj.c, off.c and ply.c. */
#include "formats/mesh/polygons.h"
#include "core/grow.h"

enum { most_errors = 20 }; /* more of them help nobody */

static void append(lam_arena *arena, lam_int_list *list, int item) {
  LAM_APPEND(arena, list->items, list->count, list->capacity, item);
}

void lam_polygons_vertex(lam_polygons *polygons, lam_vec3 vertex) {
  LAM_APPEND(polygons->arena, polygons->vertices, polygons->vertex_count, polygons->vertex_capacity,
             vertex);
}

void lam_polygons_corner(lam_polygons *polygons, int vertex) {
  append(polygons->arena, &polygons->corners, vertex);
}

/* The corners of a face that is none stay in the list, where no face begins. */
void lam_polygons_face(lam_polygons *polygons, int start, lam_location location,
                       lam_errors *errors) {
  int corners = polygons->corners.count - start;
  if (corners < 3 || corners > polygons->most_corners) {
    const char *expected = polygons->most_corners == 4 ? "3 or 4" : "3 or more";
    lam_error_add(errors, location, NULL, "face: %d corners given, %s expected", corners, expected);
    return;
  }
  append(polygons->arena, &polygons->starts, start);
  append(polygons->arena, &polygons->lines, location.line);
}

/* The first corner that is not face i's any more. */
static int end_of(const lam_polygons *polygons, int i) {
  return i + 1 < polygons->starts.count ? polygons->starts.items[i + 1] : polygons->corners.count;
}

/* Vertices may stand below the faces that use them, so numbers that are too large are found at the
 * end. One message per face. */
bool lam_polygons_check(lam_polygons *polygons, int base, lam_location location,
                        lam_errors *errors) {
  int before = errors->count;
  for (int i = 0; i < polygons->starts.count && errors->count - before < most_errors; i++)
    for (int k = polygons->starts.items[i]; k < end_of(polygons, i); k++) {
      int corner = polygons->corners.items[k];
      if (corner >= 0 && corner < polygons->vertex_count) continue;
      location.line = polygons->lines.items[i];
      lam_error_add(errors, location, NULL, "face: vertex %d given, but the file has %d",
                    corner + base, polygons->vertex_count);
      break;
    }

  location.line = 0;
  if (!polygons->starts.count) lam_error_add(errors, location, NULL, "has no faces");
  return errors->count == before;
}

lam_mesh lam_polygons_mesh(const lam_polygons *polygons) {
  lam_mesh mesh = {.vertex_count = polygons->vertex_count,
                   .vertices = polygons->vertices,
                   .face_count = polygons->starts.count};
  mesh.faces = lam_arena_alloc(polygons->arena, (size_t)mesh.face_count, sizeof *mesh.faces);
  for (int i = 0; i < mesh.face_count; i++) {
    int start = polygons->starts.items[i], corners = end_of(polygons, i) - start;
    for (int k = 0; k < 4; k++)
      mesh.faces[i][k] = k < corners ? polygons->corners.items[start + k] : -1;
  }
  return mesh;
}

lam_trimesh lam_polygons_triangles(const lam_polygons *polygons) {
  int faces = polygons->starts.count;
  const int *corners = polygons->corners.items;
  lam_trimesh mesh = {.vertex_count = polygons->vertex_count, .vertices = polygons->vertices};
  mesh.triangles = lam_arena_alloc(polygons->arena, (size_t)(polygons->corners.count - 2 * faces),
                                   sizeof *mesh.triangles);

  for (int i = 0; i < faces; i++)
    for (int k = polygons->starts.items[i] + 2; k < end_of(polygons, i); k++) {
      int *t = mesh.triangles[mesh.triangle_count++];
      t[0] = corners[polygons->starts.items[i]];
      t[1] = corners[k - 1];
      t[2] = corners[k];
    }
  return mesh;
}
