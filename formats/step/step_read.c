/* What is read of a STEP file (ISO 10303-42): all B-spline surfaces, or all curves. Called
 * through the format's row in step.c; entities come from step_tree.c, geometry from
 * step_splines.c and step_curves.c. */
#include "formats/step/step.h"
#include "formats/step/step_reader.h"

#include <string.h>

static bool begin(lam_step_reader *r) { return lam_step_tree_read(r->arena, &r->scan, &r->tree); }

/* ---- notes ---- */

/* Whether an edge of a loop leaves the boundary of the clamped surface. What cannot be read is
 * passed over: its messages go into a list that is dropped. */
static bool loop_trims(lam_step_reader *r, const lam_step_entity *loop,
                       const lam_spline_surface *clamped) {
  const lam_step_value *edges =
      lam_step_typed(lam_step_record(loop, "EDGE_LOOP"), 1, LAM_STEP_LIST);
  for (int i = 0; edges && i < edges->count; i++) {
    const lam_step_value *oriented =
        lam_step_record(lam_step_referred(r, edges, i), "ORIENTED_EDGE");
    const lam_step_entity *edge = lam_step_referred(r, oriented, 3);

    lam_errors *errors = r->scan.errors, ignored = {.arena = r->arena};
    lam_spline_curve curve = {0};
    const char *other;
    r->scan.errors = &ignored;
    bool read = lam_step_record(edge, "EDGE_CURVE") && lam_step_curve_of(r, edge, &curve, &other) &&
                curve.count;
    r->scan.errors = errors;

    if (read && !lam_curve_is_border(r->arena, &curve, clamped)) return true;
  }
  return false;
}

/* Whether a face is only a part of its surface: a boundary of it leaves that of the surface. */
static bool face_trims(lam_step_reader *r, const lam_step_value *face,
                       const lam_spline_surface *surface) {
  lam_spline_surface clamped = lam_spline_clamped(r->arena, surface);
  const lam_step_value *bounds = lam_step_typed(face, 1, LAM_STEP_LIST);
  for (int i = 0; bounds && i < bounds->count; i++) {
    const lam_step_entity *entity = lam_step_referred(r, bounds, i);
    const lam_step_value *bound = lam_step_record(entity, "FACE_OUTER_BOUND");
    if (!bound) bound = lam_step_record(entity, "FACE_BOUND");
    if (loop_trims(r, lam_step_referred(r, bound, 1), &clamped)) return true;
  }
  return false;
}

/* The faces by the surface that they lie on: per entity, the record of a face; NULL: none. Of
 * several faces the last one stays. */
static const lam_step_value **find_faces(const lam_step_reader *r) {
  const lam_step_value **faces = LAM_NEW(r->arena, const lam_step_value *, r->tree.count);
  for (int i = 0; i < r->tree.count; i++) {
    const lam_step_value *face = lam_step_record(&r->tree.entities[i], "ADVANCED_FACE");
    if (!face) face = lam_step_record(&r->tree.entities[i], "FACE_SURFACE");
    const lam_step_entity *surface = lam_step_referred(r, face, 2);
    if (surface) faces[surface - r->tree.entities] = face;
  }
  return faces;
}

/* Whether the file places components. */
static bool is_assembly(const lam_step_reader *r) {
  for (int i = 0; i < r->tree.count; i++)
    if (lam_step_record(&r->tree.entities[i], "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION") ||
        lam_step_record(&r->tree.entities[i], "MAPPED_ITEM"))
      return true;
  return false;
}

/* ---- surfaces ---- */

/* A message that says which other surface the file has instead of a B-spline surface. */
static void complain_of_none(lam_step_reader *r) {
  static const char *const others[] = {"PLANE",
                                       "CYLINDRICAL_SURFACE",
                                       "CONICAL_SURFACE",
                                       "SPHERICAL_SURFACE",
                                       "TOROIDAL_SURFACE",
                                       "SURFACE_OF_REVOLUTION",
                                       "SURFACE_OF_LINEAR_EXTRUSION",
                                       "OFFSET_SURFACE"};

  r->scan.location.line = 0;
  for (int i = 0; i < r->tree.count; i++)
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
      if (lam_step_record(&r->tree.entities[i], others[k])) {
        lam_error_add(r->scan.errors, r->scan.location, NULL,
                      "has no B-spline surface, but %s; expected surfaces saved as NURBS",
                      others[k]);
        return;
      }
  lam_error_add(r->scan.errors, r->scan.location, NULL,
                "has no surface; expected at least one B-spline surface");
}

/* Units are looked for when the first surface is met. */
bool lam_step_read_surfaces(lam_arena *arena, const char *bytes, size_t count,
                            lam_location location, lam_errors *errors, lam_spline_list *surfaces) {
  lam_step_reader r = {.arena = arena,
                       .scan = lam_scan_begin(arena, bytes, count, location, errors)};
  *surfaces = (lam_spline_list){0};
  if (!begin(&r)) return false;

  const lam_step_value **faces = find_faces(&r);
  bool placed = is_assembly(&r);
  for (int i = 0, form; i < r.tree.count; i++) {
    const lam_step_value *record = lam_step_spline_surface_record(&r.tree.entities[i], &form);
    lam_spline_surface s = {0};
    if (!record) continue;

    if (r.unit == 0 && !lam_step_units(&r)) return false;
    r.entity = &r.tree.entities[i];
    r.what = "surface";
    if (!lam_step_spline_surface(&r, record, form, &s)) return false;

    bool trimmed = faces[i] && face_trims(&r, faces[i], &s);
    lam_spline_append(arena, surfaces, &s, lam_spline_note(trimmed, placed));
  }

  if (!surfaces->count) complain_of_none(&r);
  return surfaces->count > 0;
}

/* ---- curves ---- */

/* Curves besides B-splines that are listed by themselves. */
static const char *const curve_keywords[] = {"EDGE_CURVE", "TRIMMED_CURVE", "POLYLINE"};

/* Marks an entity as used; NULL is none. */
static void mark(const lam_step_reader *r, bool *used, const lam_step_entity *entity) {
  if (entity) used[entity - r->tree.entities] = true;
}

/* Curves that only serve others, per entity: those that edges and trimmed curves lie on, and
 * those in the parameters of surfaces. */
static bool *find_used(const lam_step_reader *r) {
  static const struct {
    const char *keyword;
    int item;
  } users[] = {{"EDGE_CURVE", 3},
               {"TRIMMED_CURVE", 1},
               {"SURFACE_CURVE", 1},
               {"SEAM_CURVE", 1},
               {"INTERSECTION_CURVE", 1}};

  bool *used = LAM_NEW(r->arena, bool, r->tree.count);
  for (int i = 0; i < r->tree.count; i++) {
    const lam_step_entity *entity = &r->tree.entities[i];
    for (size_t k = 0; k < sizeof users / sizeof *users; k++)
      mark(r, used, lam_step_referred(r, lam_step_record(entity, users[k].keyword), users[k].item));

    const lam_step_value *items =
        lam_step_typed(lam_step_record(entity, "DEFINITIONAL_REPRESENTATION"), 1, LAM_STEP_LIST);
    for (int k = 0; items && k < items->count; k++) mark(r, used, lam_step_referred(r, items, k));
    if (lam_step_is_plane_curve(r, entity)) used[i] = true;
  }
  return used;
}

/* The letters of item i, a string, between its quotes, without control characters; NULL: it is
 * none or has none. */
static const char *name_in(const lam_step_reader *r, const lam_step_value *record, int i) {
  const lam_step_value *text = lam_step_typed(record, i, LAM_STEP_TEXT);
  if (!text || text->word.length < 3 || text->word.text[0] != '\'') return NULL;

  char *name = lam_arena_alloc(r->arena, (size_t)text->word.length, 1);
  int n = 0;
  for (int k = 1; k < text->word.length - 1; k++) {
    char c = text->word.text[k];
    if (c == '\'' && text->word.text[k + 1] == '\'') k++;
    if ((unsigned char)c >= ' ' && c != 127) name[n++] = c;
  }
  return n ? name : NULL;
}

/* The name of an entity: a complex instance has it in a record of its own; its number when it has
 * none. */
static const char *name_of(const lam_step_reader *r, const lam_step_entity *entity) {
  const char *name = name_in(r, lam_step_record(entity, "REPRESENTATION_ITEM"), 0);
  if (!name) name = name_in(r, entity->records, 0);
  return name ? name : lam_arena_printf(r->arena, "#%ld", entity->number);
}

/* Whether an entity is listed as a curve, unless another one uses it. */
static bool is_curve(const lam_step_entity *entity) {
  int form;
  for (size_t k = 0; k < sizeof curve_keywords / sizeof *curve_keywords; k++)
    if (lam_step_record(entity, curve_keywords[k])) return true;
  return lam_step_spline_curve_record(entity, &form) != NULL;
}

/* Units are looked for when the first curve is met. */
bool lam_step_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                          lam_errors *errors, lam_curve_list *curves) {
  lam_step_reader r = {.arena = arena,
                       .scan = lam_scan_begin(arena, bytes, count, location, errors)};
  *curves = (lam_curve_list){0};
  if (!begin(&r)) return false;

  const bool *used = find_used(&r);
  for (int i = 0; i < r.tree.count; i++) {
    const lam_step_entity *entity = &r.tree.entities[i];
    lam_spline_curve curve;
    if (used[i] || !is_curve(entity)) continue;
    if (r.unit == 0 && !lam_step_units(&r)) return false;
    if (!lam_step_curve_of(&r, entity, &curve, &curves->other)) return false;
    if (curve.count) lam_curve_append(arena, curves, name_of(&r, entity), -1, curve);
  }

  r.scan.location.line = 0;
  if (!curves->count)
    lam_error_add(errors, r.scan.location, NULL,
                  "has no curve%s%s; expected B-splines, lines or arcs",
                  curves->other ? " but " : "", curves->other ? curves->other : "");
  return curves->count > 0;
}
