/* What is read of an IGES 5.3 file: all rational B-spline surfaces, or all curves. Called through
 * the format's row in iges.c; entities come from iges_entities.c. */
#include "formats/iges/iges.h"
#include "formats/iges/iges_entities.h"

#include <string.h>

enum { surface_type = 128, bounded = 143, trimmed_surface = 144, instance = 408, label_field = 7 };

/* Per directory line (from 0): whether a face (144 or 143) on the surface there is trimmed. */
static bool *find_trimmed(lam_iges_reader *r) {
  bool *trimmed = LAM_NEW(r->arena, bool, r->directory.count + 1);
  for (int at = 0, surface; at < r->directory.count; at += 2) {
    int type = lam_iges_field(r, at, 0);
    if ((type == trimmed_surface || type == bounded) && lam_iges_trims(r, at, &surface) &&
        surface >= 0)
      trimmed[surface] = true;
  }
  return trimmed;
}

/* Goes through the directory once for the notes and once for the surfaces. */
bool lam_iges_read_surfaces(lam_arena *arena, const char *bytes, size_t count,
                            lam_location location, lam_errors *errors, lam_spline_list *surfaces) {
  lam_iges_reader r = {.arena = arena,
                       .scan = lam_scan_begin(arena, bytes, count, location, errors)};
  *surfaces = (lam_spline_list){0};
  if (!lam_iges_begin(&r)) return false;

  const bool *trimmed = find_trimmed(&r);
  bool placed = false;
  for (int at = 0; at < r.directory.count; at += 2) placed |= lam_iges_field(&r, at, 0) == instance;

  for (int at = 0; at < r.directory.count; at += 2) {
    lam_spline_surface s = {0};
    if (lam_iges_field(&r, at, 0) != surface_type) continue;
    if (!lam_iges_surface(&r, at, &s)) return false;
    lam_spline_append(arena, surfaces, &s, lam_spline_note(trimmed[at], placed));
  }

  if (!surfaces->count)
    lam_iges_fail_at(&r, 0,
                     "has no B-spline surface (entity 128); expected surfaces saved as NURBS");
  return surfaces->count > 0;
}

/* The label of the second directory line (field 18); without one, D and the entry's first line. */
static const char *label_of(const lam_iges_reader *r, int at) {
  enum { width = 8 };
  const char *text = r->directory.lines[at + 1].text + label_field * width;
  char *label = lam_arena_alloc(r->arena, width + 1, 1);

  int n = 0;
  for (int i = 0; i < width; i++)
    if ((unsigned char)text[i] > ' ' && text[i] != 127) label[n++] = text[i];
  return n ? label : lam_arena_printf(r->arena, "D%d", at + 1);
}

/* Curves of no kind that is read are left out; what cannot be read of the others is an error. */
bool lam_iges_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                          lam_errors *errors, lam_curve_list *curves) {
  lam_iges_reader r = {.arena = arena,
                       .scan = lam_scan_begin(arena, bytes, count, location, errors)};
  *curves = (lam_curve_list){0};
  if (!lam_iges_begin(&r)) return false;

  bool *plane = LAM_NEW(arena, bool, r.directory.count + 1);
  lam_iges_mark_plane_curves(&r, plane);
  for (int at = 0; at < r.directory.count; at += 2) {
    lam_spline_curve curve;
    if (plane[at]) continue;
    if (!lam_iges_curve(&r, at, &curve)) return false;
    if (curve.count) lam_curve_append(arena, curves, label_of(&r, at), -1, curve);
  }

  if (!curves->count)
    lam_iges_fail_at(
        &r, 0, "has no curve (entity 126, 110, 100 or 106); expected B-splines, lines or arcs");
  return curves->count > 0;
}
