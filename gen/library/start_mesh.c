/* The mesh that a net starts from, from a file or another design to what the pipeline takes. Called
 * by sources.c for designs and by read_files.c for programs. */
#include "library/start_mesh.h"
#include "core/solid/triangles.h"
#include "core/text.h"
#include "formats/list/formats.h"
#include "library/read_files.h"
#include "mesh/tidy.h"

#include <string.h>

/* A mesh beyond these is hardly what was meant, meters: its file may be in another unit. */
static const double smallest = .02, largest = 200;

enum { most_notes = 5 };

/* What is told about a mesh. */
typedef struct notes {
  lam_arena *arena;
  int count;
  const char **items; /* most_notes */
} notes;

static void add(notes *list, const char *text) { list->items[list->count++] = text; }

static const char *ending(int count) { return count == 1 ? "" : "s"; }

/* ---- unit and size ---- */

double lam_start_mesh_unit(const char *path, int unit) {
  const lam_format *format = lam_format_for(path);
  return unit && format && format->unit > 0 ? lam_file_units[unit].meters / format->unit : 1;
}

void lam_start_mesh_scale(lam_vec3 *points, int count, double factor) {
  for (int i = 0; factor != 1 && i < count; i++) points[i] = lam_scale(points[i], factor);
}

/* The largest extent along an axis of the vertices that faces name. */
static double extent_of(lam_arena *arena, const lam_mesh *mesh) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_vec3 *corners = LAM_NEW(arena, lam_vec3, 4 * (size_t)mesh->face_count), low, high;
  int count = 0;
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 4 && mesh->faces[f][k] >= 0; k++)
      if (mesh->faces[f][k] < mesh->vertex_count)
        corners[count++] = mesh->vertices[mesh->faces[f][k]];

  lam_points_bounds(corners, count, &low, &high);
  lam_arena_release(arena, mark);
  lam_vec3 d = lam_sub(high, low);
  return fmax(d.x, fmax(d.y, d.z));
}

/* Scales the mesh about the origin to the size that was asked for, if any. */
static bool resize(lam_arena *arena, lam_mesh *mesh, const lam_net_source *from,
                   lam_location location, lam_errors *errors) {
  double extent = extent_of(arena, mesh);
  if (from->size == 0) return true;
  if (!(extent > 0)) {
    lam_error_add(errors, location, "net.from.size", "given, but the mesh has no extent");
    return false;
  }
  lam_start_mesh_scale(mesh->vertices, mesh->vertex_count, from->size / extent);
  return true;
}

/* Says how large the mesh is when that is hardly meant, and nobody has said so. */
static void note_size(notes *list, const lam_mesh *mesh, const lam_net_source *from) {
  double extent = extent_of(list->arena, mesh);
  bool plausible = extent >= smallest && extent <= largest;
  if (plausible || from->unit || from->size > 0) return;
  add(list, lam_arena_printf(list->arena,
                             "the mesh is %.4g m long, as its file has no unit and meters are "
                             "taken; net.from.unit (such as mm) or net.from.size says otherwise",
                             extent));
}

/* ---- tidying ---- */

/* What was done about the mesh, and what a person may want to have done. */
static void note_tidied(notes *list, const lam_tidied *found) {
  lam_arena *arena = list->arena;
  int unused = found->unused, turned = found->turned;
  if (found->welded)
    add(list, lam_arena_printf(arena, "%d vert%s welded to others", found->welded,
                               found->welded == 1 ? "ex" : "ices"));
  if (unused)
    add(list, lam_arena_printf(arena,
                               "%d vert%s in no face left out; vertices behind have lower numbers "
                               "than in the file",
                               unused, unused == 1 ? "ex" : "ices"));
  if (turned)
    add(list, lam_arena_printf(arena, "%d face%s turned to agree with the others", turned,
                               ending(turned)));
  if (found->doubled)
    add(list, lam_arena_printf(arena,
                               "%d vert%s in two places; %d piece%s: net.from.weld (0 is enough) "
                               "joins them",
                               found->doubled, found->doubled == 1 ? "ex lies" : "ices lie",
                               found->pieces, ending(found->pieces)));
}

/* Welds what is asked for, and tidies. False with a message. */
static bool tidy(notes *list, lam_mesh *mesh, const lam_net_source *from, lam_location location,
                 lam_errors *errors) {
  lam_tidied found;
  int face;
  if (!lam_mesh_tidy(list->arena, mesh, from->weld_given ? from->weld : -1, &found, &face)) {
    lam_error_add(errors, location, "net.from.weld",
                  "%g m given, which joins corners of face %d; expected less than its edges",
                  from->weld, face + 1);
    return false;
  }
  note_tidied(list, &found);
  return true;
}

/* ---- the whole ---- */

/* Hands the mesh and the notes over. */
static bool finish(const notes *list, const lam_mesh *mesh, lam_inputs *inputs) {
  lam_mesh *kept = LAM_NEW(list->arena, lam_mesh, 1);
  *kept = *mesh;
  inputs->net = kept;
  inputs->net_note_count = list->count;
  inputs->net_notes = list->items;
  return true;
}

bool lam_start_mesh_read(lam_arena *arena, const char *path, const lam_net_source *from,
                         lam_location location, lam_errors *errors, lam_inputs *inputs) {
  notes list = {.arena = arena, .items = LAM_NEW(arena, const char *, most_notes)};
  lam_mesh mesh;
  if (!lam_input_mesh(arena, path, errors, &mesh)) return false;

  lam_start_mesh_scale(mesh.vertices, mesh.vertex_count, lam_start_mesh_unit(path, from->unit));
  if (!resize(arena, &mesh, from, location, errors)) return false;
  note_size(&list, &mesh, from);
  return tidy(&list, &mesh, from, location, errors) && finish(&list, &mesh, inputs);
}

/* A finished net is in meters and in order. */
bool lam_start_mesh_take(lam_arena *arena, const lam_mesh *mesh, const lam_net_source *from,
                         lam_location location, lam_errors *errors, lam_inputs *inputs) {
  notes none = {.arena = arena};
  lam_mesh copy = *mesh;
  if (from->unit || from->weld_given) {
    lam_error_add(errors, location, from->unit ? "net.from.unit" : "net.from.weld",
                  "given, but another design's net is in meters and in one piece; expected a file "
                  "beside it");
    return false;
  }

  copy.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  if (mesh->vertex_count)
    memcpy(copy.vertices, mesh->vertices, (size_t)mesh->vertex_count * sizeof *copy.vertices);
  return resize(arena, &copy, from, location, errors) && finish(&none, &copy, inputs);
}
