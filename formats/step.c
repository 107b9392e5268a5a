/* STEP (ISO 10303-214, "automotive design") in millimeters: every spline surface of the model as a face with its
 * natural boundary, all in one open shell. Reals carry a decimal point and an upper-case E: readers silently misread
 * others. */
#include "formats/step.h"

typedef struct step {
  lam_text *out;
  int last; /* number of the last entity */
} step;

static int begin(step *s) {
  lam_text_printf(s->out, "#%d=", ++s->last);
  return s->last;
}

static void end(step *s) { lam_text_add(s->out, ";\n"); }

static int plain(step *s, const char *entity) {
  int number = begin(s);
  lam_text_add(s->out, entity);
  end(s);
  return number;
}

static void add_real(step *s, double value, bool first) {
  if (!first) lam_text_add(s->out, ",");
  lam_text_real(s->out, value);
}

static int add_point(step *s, lam_vec3 p) {
  int number = begin(s);
  lam_text_add(s->out, "CARTESIAN_POINT('',(");
  add_real(s, 1000 * p.x, true);
  add_real(s, 1000 * p.y, false);
  add_real(s, 1000 * p.z, false);
  lam_text_add(s->out, "))");
  end(s);
  return number;
}

static void add_references(step *s, const int *numbers, int count, int stride) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++) lam_text_printf(s->out, "%s#%d", i ? "," : "", numbers[i * stride]);
  lam_text_add(s->out, ")");
}

static void add_multiplicities(step *s, const double *knots, int count) {
  lam_text_add(s->out, "(");
  for (int i = 0, n = 1; i < count; i++, n++)
    if (i + 1 == count || knots[i + 1] != knots[i]) {
      lam_text_printf(s->out, "%s%d", i + 1 > n ? "," : "", n);
      n = 0;
    }
  lam_text_add(s->out, ")");
}

static void add_distinct(step *s, const double *knots, int count) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++)
    if (i == 0 || knots[i] != knots[i - 1]) add_real(s, knots[i], i == 0);
  lam_text_add(s->out, ")");
}

static void add_weights(step *s, const double *weights, int count, int stride) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++) add_real(s, weights[i * stride], i == 0);
  lam_text_add(s->out, ")");
}

/* ---- curves ---- */

static int add_curve(step *s, const lam_spline_side *c, const int *points) {
  int number = begin(s), knots = c->count + c->degree + 1;
  if (c->weights) lam_text_add(s->out, "(BOUNDED_CURVE()");
  lam_text_printf(s->out, c->weights ? "B_SPLINE_CURVE(%d," : "B_SPLINE_CURVE_WITH_KNOTS('',%d,", c->degree);
  add_references(s, points + c->first, c->count, c->stride);
  lam_text_add(s->out, ",.UNSPECIFIED.,.F.,.F.");
  lam_text_add(s->out, c->weights ? ")B_SPLINE_CURVE_WITH_KNOTS(" : ",");
  add_multiplicities(s, c->knots, knots);
  lam_text_add(s->out, ",");
  add_distinct(s, c->knots, knots);
  lam_text_add(s->out, ",.UNSPECIFIED.)");
  if (c->weights) {
    lam_text_add(s->out, "CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(");
    add_weights(s, c->weights + c->first, c->count, c->stride);
    lam_text_add(s->out, ")REPRESENTATION_ITEM(''))");
  }
  end(s);
  return number;
}

/* ---- surfaces ---- */

static int add_surface(step *s, const lam_spline_surface *b, const int *points) {
  int number = begin(s);
  if (b->weights) lam_text_add(s->out, "(BOUNDED_SURFACE()");
  lam_text_printf(s->out, b->weights ? "B_SPLINE_SURFACE(%d,%d,(" : "B_SPLINE_SURFACE_WITH_KNOTS('',%d,%d,(",
                  b->degree[0], b->degree[1]);
  for (int i = 0; i < b->count[0]; i++) {
    if (i) lam_text_add(s->out, ",");
    add_references(s, points + i * b->count[1], b->count[1], 1);
  }
  lam_text_add(s->out, "),.UNSPECIFIED.,.F.,.F.,.F.");
  lam_text_add(s->out, b->weights ? ")B_SPLINE_SURFACE_WITH_KNOTS(" : ",");
  for (int d = 0; d < 2; d++) {
    add_multiplicities(s, b->knots[d], b->count[d] + b->degree[d] + 1);
    lam_text_add(s->out, ",");
  }
  for (int d = 0; d < 2; d++) {
    add_distinct(s, b->knots[d], b->count[d] + b->degree[d] + 1);
    lam_text_add(s->out, ",");
  }
  lam_text_add(s->out, ".UNSPECIFIED.)");
  if (b->weights) {
    lam_text_add(s->out, "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE((");
    for (int i = 0; i < b->count[0]; i++) {
      if (i) lam_text_add(s->out, ",");
      add_weights(s, b->weights + i * b->count[1], b->count[1], 1);
    }
    lam_text_add(s->out, "))REPRESENTATION_ITEM('')SURFACE())");
  }
  end(s);
  return number;
}

/* The four corners, counterclockwise from (0, 0); those that coincide share a vertex. */
static void add_vertices(step *s, const lam_spline_surface *b, const int *points, int vertices[4]) {
  int n = b->count[0], m = b->count[1], corners[4] = {0, (n - 1) * m, n * m - 1, m - 1};
  for (int k = 0; k < 4; k++) {
    vertices[k] = 0;
    for (int j = 0; j < k; j++)
      if (lam_spline_meet(b->points[corners[j]], b->points[corners[k]])) vertices[k] = vertices[j];
    if (vertices[k]) continue;
    vertices[k] = begin(s);
    lam_text_printf(s->out, "VERTEX_POINT('',#%d)", points[corners[k]]);
    end(s);
  }
}

/* The loop around a surface; returns the number of its edges, as they are passed. A side that is a point has no edge;
 * sides that coincide share theirs (a seam). */
static int add_loop(step *s, const lam_spline_surface *b, const int *points, int loop[4]) {
  static const int ends[4][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}}; /* corners, along the curve */
  int vertices[4], edges[4] = {0}, count = 0;
  add_vertices(s, b, points, vertices);
  for (int k = 0; k < 4; k++) {
    lam_spline_side c = lam_spline_side_of(b, k), opposite = lam_spline_side_of(b, k ^ 2);
    if (lam_spline_side_is_point(&c)) continue;
    if (k >= 2 && edges[k - 2] && lam_spline_sides_meet(&c, &opposite)) edges[k] = edges[k - 2];
    if (!edges[k]) {
      int curve = add_curve(s, &c, points);
      edges[k] = begin(s);
      lam_text_printf(s->out, "EDGE_CURVE('',#%d,#%d,#%d,.T.)", vertices[ends[k][0]], vertices[ends[k][1]], curve);
      end(s);
    }
    loop[count++] = begin(s);
    lam_text_printf(s->out, "ORIENTED_EDGE('',*,*,#%d,.%c.)", edges[k], k < 2 ? 'T' : 'F');
    end(s);
  }
  return count;
}

static int add_face(step *s, const lam_spline_surface *b) {
  int total = b->count[0] * b->count[1], *points = LAM_NEW(s->out->arena, int, total), loop[4];
  for (int i = 0; i < total; i++) points[i] = add_point(s, b->points[i]);
  int surface = add_surface(s, b, points), loop_count = add_loop(s, b, points, loop), edge_loop = begin(s);
  lam_text_add(s->out, "EDGE_LOOP('',");
  add_references(s, loop, loop_count, 1);
  lam_text_add(s->out, ")");
  end(s);
  int bound = begin(s);
  lam_text_printf(s->out, "FACE_OUTER_BOUND('',#%d,.T.)", edge_loop);
  end(s);
  int face = begin(s);
  lam_text_printf(s->out, "ADVANCED_FACE('%s',(#%d),#%d,.T.)", b->name, bound, surface);
  end(s);
  return face;
}

/* ---- the file ---- */

/* The code point that begins at *at, in UTF-8; *at moves behind it. What is not well formed is passed over as it is. */
static unsigned long next_code_point(const char **at) {
  const unsigned char *c = (const unsigned char *)*at;
  int more = c[0] >= 0xf0 ? 3 : c[0] >= 0xe0 ? 2 : c[0] >= 0xc0 ? 1 : 0, i = 1;
  unsigned long code = more ? c[0] & (0x3fu >> more) : c[0];
  for (; i <= more && (c[i] & 0xc0) == 0x80; i++) code = code << 6 | (c[i] & 0x3fu);
  *at += i;
  return code;
}

/* A string in ASCII: quotes and backslashes are doubled, other letters written by their code point. */
static void add_quoted(lam_text *out, const char *string) {
  lam_text_add(out, "'");
  while (*string) {
    unsigned long code = next_code_point(&string);
    if (code == '\'' || code == '\\') lam_text_printf(out, "%c", (int)code);
    if (code >= ' ' && code < 127)
      lam_text_printf(out, "%c", (int)code);
    else if (code > 127)
      lam_text_printf(out, code > 0xffff ? "\\X4\\%08lX\\X0\\" : "\\X2\\%04lX\\X0\\", code);
  }
  lam_text_add(out, "'");
}

static void add_head(step *s, const lam_model *model) {
  lam_text_add(s->out, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('smooth surfaces, millimeters'),'2;1');\nFILE_NAME(");
  add_quoted(s->out, model->name);
  lam_text_printf(s->out,
                  ",'2000-01-01T00:00:00',(''),(''),'lamella %s','lamella','');\n"
                  "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n",
                  model->version);
}

/* Product and units; returns the context of the geometry, and the shape it defines. */
static int add_product(step *s, const lam_model *model, int *shape) {
  plain(s, "APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
  plain(s, "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1)");
  plain(s, "PRODUCT_CONTEXT('',#1,'mechanical')");
  begin(s);
  lam_text_add(s->out, "PRODUCT(");
  add_quoted(s->out, model->name);
  lam_text_add(s->out, ",");
  add_quoted(s->out, model->title ? model->title : model->name);
  lam_text_add(s->out, ",'',(#3))");
  end(s);
  plain(s, "PRODUCT_DEFINITION_FORMATION('','',#4)");
  plain(s, "PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design')");
  plain(s, "PRODUCT_DEFINITION('design','',#5,#6)");
  *shape = plain(s, "PRODUCT_DEFINITION_SHAPE('','',#7)");
  plain(s, "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  plain(s, "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  plain(s, "(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  plain(s, "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.0E-5),#9,'distance_accuracy_value','')");
  return plain(s, "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))"
                  "GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))REPRESENTATION_CONTEXT('',''))");
}

static int count(const lam_model *model) { return model->surface_count > 0; }

static void path(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_printf(out, "%s.step", model->name);
}

static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  step s = {out, 0};
  int shape, *faces = LAM_NEW(out->arena, int, model->surface_count);
  add_head(&s, model);
  int context = add_product(&s, model, &shape);
  for (int f = 0; f < model->surface_count; f++) {
    lam_spline_surface clamped = lam_spline_clamped(out->arena, &model->surfaces[f]);
    faces[f] = add_face(&s, &clamped);
  }
  int shell = begin(&s);
  lam_text_add(out, "OPEN_SHELL('',");
  add_references(&s, faces, model->surface_count, 1);
  lam_text_add(out, ")");
  end(&s);
  int shells = begin(&s);
  lam_text_printf(out, "SHELL_BASED_SURFACE_MODEL('',(#%d))", shell);
  end(&s);
  int origin = add_point(&s, lam_v3(0, 0, 0)), frame = begin(&s);
  lam_text_printf(out, "AXIS2_PLACEMENT_3D('',#%d,$,$)", origin);
  end(&s);
  int representation = begin(&s);
  lam_text_printf(out, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#%d,#%d),#%d)", frame, shells, context);
  end(&s);
  begin(&s);
  lam_text_printf(out, "SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)", shape, representation);
  end(&s);
  lam_text_add(out, "ENDSEC;\nEND-ISO-10303-21;\n");
  return LAM_OK;
}

const lam_format lam_format_step = {
    .name = "step",
    .doc = "The smooth surfaces as an open shell for CAD programs (STEP AP214), in millimeters.",
    .ending = "step stp",
    .count = count,
    .path = path,
    .write = write,
    .read_surfaces = lam_step_read,
};
