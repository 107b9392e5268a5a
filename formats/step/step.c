/* STEP (ISO 10303-214, "automotive design") in millimeters (NAME.step; listed in
 * formats/list/formats.c): the spline surfaces of the model as faces with their natural
 * boundaries, in shells whose faces share edges, and its curves by family. */
#include "formats/step/step.h"
#include "formats/spline/shell.h"
#include "formats/step/step_write.h"

/* What was written of the surfaces: numbers of entities. */
typedef struct written {
  const lam_spline_surface *surfaces; /* clamped */
  int **points;                       /* per surface: numbers of its control points */
  int *vertices, *edges, *faces;
} written;

/* ---- shells ---- */

/* A VERTEX_POINT for each vertex of the shell, at the control point of the corner that it is. */
static void add_vertices(lam_step_writer *s, const lam_shell *shell, written *w) {
  w->vertices = LAM_NEW(s->out->arena, int, shell->vertex_count);
  for (int i = 0; i < shell->vertex_count; i++) {
    int surface = shell->vertices[i] / 4,
        at = lam_shell_corner(&w->surfaces[surface], shell->vertices[i] % 4);
    w->vertices[i] = lam_step_begin(s);
    lam_text_printf(s->out, "VERTEX_POINT('',#%d)", w->points[surface][at]);
    lam_step_end(s);
  }
}

/* An EDGE_CURVE for each edge of the shell, on the curve of the side that it is, from vertex to
 * vertex. */
static void add_edges(lam_step_writer *s, const lam_shell *shell, written *w) {
  w->edges = LAM_NEW(s->out->arena, int, shell->edge_count);
  for (int i = 0; i < shell->edge_count; i++) {
    const lam_shell_edge *e = &shell->edges[i];
    lam_spline_side side = lam_spline_side_of(&w->surfaces[e->surface], e->side);
    int curve = lam_step_curve(s, "", &side, w->points[e->surface]);
    w->edges[i] = lam_step_begin(s);
    lam_text_printf(s->out, "EDGE_CURVE('',#%d,#%d,#%d,.T.)", w->vertices[e->vertex[0]],
                    w->vertices[e->vertex[1]], curve);
    lam_step_end(s);
  }
}

/* The face of surface i, whose entity is `surface`; returns its number. Its boundary is passed
 * counterclockwise around the surface's own normal, which is along sides 0 and 1 and against
 * sides 2 and 3; a face that is turned over says so twice, at its boundary and at itself. A side
 * that is a point has no edge. */
static int add_face(lam_step_writer *s, const lam_shell *shell, const written *w, int i,
                    int surface) {
  int loop[4], count = 0;
  for (int k = 0; k < 4; k++) {
    lam_shell_use use = shell->uses[4 * i + k];
    if (use.edge < 0) continue;
    loop[count++] = lam_step_begin(s);
    lam_text_printf(s->out, "ORIENTED_EDGE('',*,*,#%d,.%c.)", w->edges[use.edge],
                    use.forward == (k < 2) ? 'T' : 'F');
    lam_step_end(s);
  }

  int edge_loop = lam_step_begin(s);
  lam_text_add(s->out, "EDGE_LOOP('',");
  lam_step_references(s, loop, count, 1);
  lam_text_add(s->out, ")");
  lam_step_end(s);

  int bound = lam_step_begin(s);
  char sense = shell->flipped[i] ? 'F' : 'T';
  lam_text_printf(s->out, "FACE_OUTER_BOUND('',#%d,.%c.)", edge_loop, sense);
  lam_step_end(s);

  int face = lam_step_begin(s);
  lam_text_add(s->out, "ADVANCED_FACE(");
  lam_step_quoted(s, w->surfaces[i].name);
  lam_text_printf(s->out, ",(#%d),#%d,.%c.)", bound, surface, sense);
  lam_step_end(s);
  return face;
}

/* A shell for each connected part, open when it has a border; returns the model of them all.
 * faces: per surface. */
static int add_shells(lam_step_writer *s, const lam_shell *shell, int count, const int *faces) {
  int *shells = LAM_NEW(s->out->arena, int, shell->part_count),
      *own = LAM_NEW(s->out->arena, int, count);
  for (int part = 0; part < shell->part_count; part++) {
    int n = 0;
    for (int i = 0; i < count; i++)
      if (shell->part[i] == part) own[n++] = faces[i];
    shells[part] = lam_step_begin(s);
    lam_text_add(s->out, shell->border[part] ? "OPEN_SHELL(''," : "CLOSED_SHELL('',");
    lam_step_references(s, own, n, 1);
    lam_text_add(s->out, ")");
    lam_step_end(s);
  }

  int all = lam_step_begin(s);
  lam_text_add(s->out, "SHELL_BASED_SURFACE_MODEL('',");
  lam_step_references(s, shells, shell->part_count, 1);
  lam_text_add(s->out, ")");
  lam_step_end(s);
  return all;
}

/* All surfaces with their shells; returns the number of the shell model. */
static int add_surfaces(lam_step_writer *s, const lam_model *model) {
  lam_arena *arena = s->out->arena;
  int count = model->surface_count, *surfaces = LAM_NEW(arena, int, count),
      *faces = LAM_NEW(arena, int, count);
  lam_spline_surface *clamped = LAM_NEW(arena, lam_spline_surface, count);
  written w = {.surfaces = clamped, .points = LAM_NEW(arena, int *, count)};

  for (int i = 0; i < count; i++) {
    clamped[i] = lam_spline_clamped(arena, &model->surfaces[i]);
    int total = clamped[i].count[0] * clamped[i].count[1];
    w.points[i] = LAM_NEW(arena, int, total);
    for (int k = 0; k < total; k++) w.points[i][k] = lam_step_point(s, clamped[i].points[k]);
    surfaces[i] = lam_step_surface(s, &clamped[i], w.points[i]);
  }

  lam_shell shell = lam_shell_make(arena, count, clamped);
  add_vertices(s, &shell, &w);
  add_edges(s, &shell, &w);
  for (int i = 0; i < count; i++) faces[i] = add_face(s, &shell, &w, i, surfaces[i]);
  return add_shells(s, &shell, count, faces);
}

/* ---- curves ---- */

/* The curves of a family as a set, whose number is returned, and on a layer; 0: there are none. */
static int add_family(lam_step_writer *s, const lam_model *model, int family) {
  int n = 0, *curves = LAM_NEW(s->out->arena, int, model->curve_count);
  for (int i = 0; i < model->curve_count; i++) {
    const lam_named_curve *c = &model->curves[i];
    if (c->family != family) continue;
    lam_spline_side side = lam_spline_side_of_curve(&c->spline);
    int *points = LAM_NEW(s->out->arena, int, side.count);
    for (int k = 0; k < side.count; k++) points[k] = lam_step_point(s, side.points[k]);
    curves[n++] = lam_step_curve(s, c->name, &side, points);
  }

  if (!n) return 0;
  const char *name = family < 0 ? "curves" : lam_arena_printf(s->out->arena, "family %d", family);
  lam_step_begin(s);
  lam_text_printf(s->out, "PRESENTATION_LAYER_ASSIGNMENT('%s','',", name);
  lam_step_references(s, curves, n, 1);
  lam_text_add(s->out, ")");
  lam_step_end(s);

  int set = lam_step_begin(s);
  lam_text_printf(s->out, "GEOMETRIC_CURVE_SET('%s',", name);
  lam_step_references(s, curves, n, 1);
  lam_text_add(s->out, ")");
  lam_step_end(s);
  return set;
}

/* ---- the file ---- */

/* The header section. Its date is fixed, so that the same model gives the same bytes. */
static void add_head(lam_step_writer *s, const lam_model *model) {
  lam_text_add(s->out, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('smooth surfaces and curves, "
                       "millimeters'),'2;1');\nFILE_NAME(");
  lam_step_quoted(s, model->name);
  lam_text_printf(s->out,
                  ",'2000-01-01T00:00:00',(''),(''),'lamella %s','lamella','');\n"
                  "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n",
                  model->version);
}

/* Product and units, entities 1 to 13, which refer to each other by these numbers. Returns the
 * context of the geometry, and in shape the definition that it belongs to. */
static int add_product(lam_step_writer *s, const lam_model *model, int *shape) {
  lam_step_plain(s, "APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
  lam_step_plain(
      s, "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1)");
  lam_step_plain(s, "PRODUCT_CONTEXT('',#1,'mechanical')");

  lam_step_begin(s);
  lam_text_add(s->out, "PRODUCT(");
  lam_step_quoted(s, model->name);
  lam_text_add(s->out, ",");
  lam_step_quoted(s, model->title ? model->title : model->name);
  lam_text_add(s->out, ",'',(#3))");
  lam_step_end(s);

  lam_step_plain(s, "PRODUCT_DEFINITION_FORMATION('','',#4)");
  lam_step_plain(s, "PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design')");
  lam_step_plain(s, "PRODUCT_DEFINITION('design','',#5,#6)");
  *shape = lam_step_plain(s, "PRODUCT_DEFINITION_SHAPE('','',#7)");

  lam_step_plain(s, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  lam_step_plain(s, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  lam_step_plain(s, "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  lam_step_plain(
      s, "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.0E-5),#9,'distance_accuracy_value','')");
  return lam_step_plain(
      s, "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))"
         "GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))REPRESENTATION_CONTEXT('',''))");
}

static int count(const lam_model *model) {
  return model->surface_count > 0 || model->curve_count > 0;
}

static void path(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_printf(out, "%s.step", model->name);
}

/* A shape representation of items in a context; returns its number. */
static int add_representation(lam_step_writer *s, const char *kind, const int *items,
                              int item_count, int context) {
  int number = lam_step_begin(s);
  lam_text_printf(s->out, "%s('',", kind);
  lam_step_references(s, items, item_count, 1);
  lam_text_printf(s->out, ",#%d)", context);
  lam_step_end(s);
  return number;
}

/* Adds the position that representations have as their first item; returns its number. */
static int add_frame(lam_step_writer *s) {
  int origin = lam_step_point(s, lam_v3(0, 0, 0)), frame = lam_step_begin(s);
  lam_text_printf(s->out, "AXIS2_PLACEMENT_3D('',#%d,$,$)", origin);
  lam_step_end(s);
  return frame;
}

/* The representation of the curves of all families; 0: there are none. */
static int add_curves(lam_step_writer *s, const lam_model *model, int frame, int context) {
  int sets[4] = {frame}, count_of = 1;
  for (int family = -1; family < 2; family++) {
    sets[count_of] = add_family(s, model, family);
    count_of += sets[count_of] > 0;
  }
  if (count_of == 1) return 0;
  return add_representation(s, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", sets,
                            count_of, context);
}

/* Surfaces are the shape of the product; curves are, too, or are another representation beside
 * them. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_step_writer s = {out, 0};
  int shape, shells = 0;
  add_head(&s, model);
  int context = add_product(&s, model, &shape), frame = add_frame(&s);

  if (model->surface_count) {
    int items[2] = {frame, add_surfaces(&s, model)};
    shells = add_representation(&s, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", items, 2, context);
  }
  int curves = add_curves(&s, model, frame, context);

  lam_step_begin(&s);
  lam_text_printf(out, "SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)", shape, shells ? shells : curves);
  lam_step_end(&s);

  if (shells && curves) {
    lam_step_begin(&s);
    lam_text_printf(out, "SHAPE_REPRESENTATION_RELATIONSHIP('','',#%d,#%d)", shells, curves);
    lam_step_end(&s);
  }

  lam_text_add(out, "ENDSEC;\nEND-ISO-10303-21;\n");
  return LAM_OK;
}

const lam_format lam_format_step = {
    .name = "step",
    .doc = "The smooth surfaces as shells, and the axes of lamellas or the lines of the net as "
           "curves, for CAD programs (STEP AP214), in millimeters.",
    .ending = "step stp",
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
    .read_surfaces = lam_step_read_surfaces,
    .read_curves = lam_step_read_curves,
};
