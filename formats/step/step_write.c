/* Entities of a STEP file, for step.c: points, B-spline curves and surfaces (ISO 10303-42), and
 * what they are written of. */
#include "formats/step/step_write.h"

int lam_step_begin(lam_step_writer *s) {
  lam_text_printf(s->out, "#%d=", ++s->last);
  return s->last;
}

void lam_step_end(lam_step_writer *s) { lam_text_add(s->out, ";\n"); }

/* For entities that depend on no number of the model. */
int lam_step_plain(lam_step_writer *s, const char *entity) {
  int number = lam_step_begin(s);
  lam_text_add(s->out, entity);
  lam_step_end(s);
  return number;
}

/* A number, with a comma before it unless it is the first. */
static void add_real(lam_step_writer *s, double value, bool first) {
  if (!first) lam_text_add(s->out, ",");
  lam_text_real(s->out, value);
}

/* Millimeters. */
int lam_step_point(lam_step_writer *s, lam_vec3 p) {
  int number = lam_step_begin(s);
  lam_text_add(s->out, "CARTESIAN_POINT('',(");
  add_real(s, 1000 * p.x, true);
  add_real(s, 1000 * p.y, false);
  add_real(s, 1000 * p.z, false);
  lam_text_add(s->out, "))");
  lam_step_end(s);
  return number;
}

/* Also for rows and columns of a control net, by their stride. */
void lam_step_references(lam_step_writer *s, const int *numbers, int count, int stride) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++)
    lam_text_printf(s->out, "%s#%d", i ? "," : "", numbers[i * stride]);
  lam_text_add(s->out, ")");
}

/* How often each distinct knot stands; count knots in all. */
static void add_multiplicities(lam_step_writer *s, const double *knots, int count) {
  lam_text_add(s->out, "(");
  for (int i = 0, n = 1; i < count; i++, n++)
    if (i + 1 == count || knots[i + 1] != knots[i]) {
      lam_text_printf(s->out, "%s%d", i + 1 > n ? "," : "", n);
      n = 0;
    }
  lam_text_add(s->out, ")");
}

/* The distinct knots. */
static void add_distinct(lam_step_writer *s, const double *knots, int count) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++)
    if (i == 0 || knots[i] != knots[i - 1]) add_real(s, knots[i], i == 0);
  lam_text_add(s->out, ")");
}

/* Every stride-th of the weights, count of them. */
static void add_weights(lam_step_writer *s, const double *weights, int count, int stride) {
  lam_text_add(s->out, "(");
  for (int i = 0; i < count; i++) add_real(s, weights[i * stride], i == 0);
  lam_text_add(s->out, ")");
}

/* The code point that begins at *at, in UTF-8; *at moves behind it. What is not well formed is
 * passed over as it is. */
static unsigned long next_code_point(const char **at) {
  const unsigned char *c = (const unsigned char *)*at;
  int more = c[0] >= 0xf0 ? 3 : c[0] >= 0xe0 ? 2 : c[0] >= 0xc0 ? 1 : 0, i = 1;
  unsigned long code = more ? c[0] & (0x3fu >> more) : c[0];
  for (; i <= more && (c[i] & 0xc0) == 0x80; i++) code = code << 6 | (c[i] & 0x3fu);
  *at += i;
  return code;
}

/* Letters outside ASCII as ISO 10303-21 has them: \X2\ and four hexadecimal digits, or \X4\ and
 * eight, ended by \X0\. Control characters are dropped. */
void lam_step_quoted(lam_step_writer *s, const char *string) {
  lam_text *out = s->out;
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

/* ---- curves ---- */

/* A polynomial curve is a simple instance, B_SPLINE_CURVE_WITH_KNOTS; a rational one is a complex
 * instance, with the same parts as records in alphabetical order. */
int lam_step_curve(lam_step_writer *s, const char *name, const lam_spline_side *c,
                   const int *points) {
  int number = lam_step_begin(s), knots = c->count + c->degree + 1;
  if (c->weights) lam_text_add(s->out, "(BOUNDED_CURVE()");
  lam_text_add(s->out, c->weights ? "B_SPLINE_CURVE(" : "B_SPLINE_CURVE_WITH_KNOTS(");
  if (!c->weights) {
    lam_step_quoted(s, name);
    lam_text_add(s->out, ",");
  }

  lam_text_printf(s->out, "%d,", c->degree);
  lam_step_references(s, points + c->first, c->count, c->stride);
  lam_text_add(s->out, ",.UNSPECIFIED.,.F.,.F.");
  lam_text_add(s->out, c->weights ? ")B_SPLINE_CURVE_WITH_KNOTS(" : ",");
  add_multiplicities(s, c->knots, knots);
  lam_text_add(s->out, ",");
  add_distinct(s, c->knots, knots);
  lam_text_add(s->out, ",.UNSPECIFIED.)");

  if (c->weights) {
    lam_text_add(s->out, "CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(");
    add_weights(s, c->weights + c->first, c->count, c->stride);
    lam_text_add(s->out, ")REPRESENTATION_ITEM(");
    lam_step_quoted(s, name);
    lam_text_add(s->out, "))");
  }
  lam_step_end(s);
  return number;
}

/* ---- surfaces ---- */

/* Simple or complex as a curve. Rows of control points, v running fastest in each. */
int lam_step_surface(lam_step_writer *s, const lam_spline_surface *b, const int *points) {
  int number = lam_step_begin(s);
  if (b->weights) lam_text_add(s->out, "(BOUNDED_SURFACE()");
  lam_text_printf(
      s->out, b->weights ? "B_SPLINE_SURFACE(%d,%d,(" : "B_SPLINE_SURFACE_WITH_KNOTS('',%d,%d,(",
      b->degree[0], b->degree[1]);

  for (int i = 0; i < b->count[0]; i++) {
    if (i) lam_text_add(s->out, ",");
    lam_step_references(s, points + i * b->count[1], b->count[1], 1);
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
  lam_step_end(s);
  return number;
}
