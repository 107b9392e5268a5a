/* Solids in files: measuring one, comparing two. Called through lamella/solid.h, by
 * cli/verb_inspect.c and cli/diff_meshes.c. */
#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "library/read_files.h"
#include "library/session_state.h"

/* How many points are sampled on the larger of two surfaces, about. */
static const double samples = 50000;

/* Reads a file as triangles, merges vertices at the same coordinates, and measures it. False with
 * messages. */
static bool read_solid(lam_session *session, const char *path, bool self_intersections,
                       lam_trimesh *mesh, lam_solid_facts *facts) {
  lam_location location = {.file = path};
  lam_trimesh loose;
  if (!lam_input_triangles(session->arena, path, &session->errors, &loose)) return false;

  *mesh = lam_trimesh_weld(session->arena, &loose, 0);
  if (!mesh->triangle_count) {
    lam_error_add(&session->errors, location, NULL,
                  "has no triangles with three different corners");
    return false;
  }

  lam_status status = lam_solid_measure(mesh, self_intersections, facts);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(session->arena);
  if (status == LAM_OK) return true;

  /* Not the input's fault: the library behind it gave up. */
  lam_error_add(&session->errors, location, NULL, "the mesh cannot be measured");
  session->errors.status = status;
  return false;
}

/* ---- one ---- */

/* The status is that of the messages. */
static lam_status inspect(lam_session *session, const char *path, bool self_intersections,
                          lam_solid_facts *facts) {
  lam_trimesh mesh;
  read_solid(session, path, self_intersections, &mesh, facts);
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/solid.h. */
lam_status lam_inspect(lam_session *session, const char *path, bool self_intersections,
                       lam_solid_facts *facts) {
  *facts = (lam_solid_facts){0};
  LAM_ENTER(session);
  return lam_session_leave(session, inspect(session, path, self_intersections, facts));
}

/* ---- two ---- */

/* The spacing is that of squares which share the larger area among the samples. */
static lam_status compare(lam_session *session, const char *const paths[2],
                          lam_mesh_comparison *c) {
  lam_trimesh mesh[2];
  bool read = true; /* both are read, so that all messages appear at once */
  for (int i = 0; i < 2; i++)
    read = read_solid(session, paths[i], false, &mesh[i], &c->facts[i]) && read;
  if (!read) return LAM_OK;

  c->spacing = sqrt(fmax(c->facts[0].area, c->facts[1].area) / samples);
  lam_status status = lam_solid_hausdorff(&mesh[0], &mesh[1], c->spacing, &c->a_to_b, &c->b_to_a);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(session->arena);
  if (status != LAM_OK)
    lam_error_add(&session->errors, (lam_location){0}, NULL,
                  "the distance between the meshes cannot be measured");
  return status;
}

/* All zero when a file cannot be read. */
lam_status lam_compare_meshes(lam_session *session, const char *a, const char *b,
                              lam_mesh_comparison *comparison) {
  *comparison = (lam_mesh_comparison){0};
  LAM_ENTER(session);
  return lam_session_leave(session, compare(session, (const char *const[]){a, b}, comparison));
}
