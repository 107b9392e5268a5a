/* IGES 5.3 in millimeters (NAME.igs; listed in formats/list/formats.c): every spline surface of the
 * model as a rational B-spline surface (entity 128), and its four sides and the curves of the
 * model as rational B-spline curves (entity 126). Fixed columns: 72 of data, a letter for the
 * section, 7 for the number. */
#include "formats/iges/iges.h"
#include "formats/spline/spline.h"

#include <stdio.h>
#include <string.h>

enum { data_width = 72, parameter_width = 64 };

/* The file while it is written: sections that stand behind others are gathered here first. */
typedef struct iges {
  lam_text *out;
  lam_text directory, parameters;
  int directory_lines, parameter_lines;
  lam_text line; /* of parameters, not yet written */
  int pointer;   /* of the entity being written: its first directory line */
} iges;

/* A line of a section: the data padded to its width, the letter, the number. */
static void put_line(lam_text *out, const char *data, int width, char section, int number) {
  lam_text_printf(out, "%-*s%c%7d\n", width, data, section, number);
}

/* Writes the gathered parameters as a line of their section, which ends with the entity's
 * pointer. */
static void flush_parameters(iges *g) {
  if (g->line.length == 0) return;

  char data[data_width + 1];
  snprintf(data, sizeof data, "%-*s%8d", parameter_width, g->line.data, g->pointer);
  put_line(&g->parameters, data, data_width, 'P', ++g->parameter_lines);
  g->line.length = 0;
}

/* One parameter with its delimiter; a line is broken between parameters. */
static void put_parameter(iges *g, const char *parameter, char delimiter) {
  size_t length = strlen(parameter) + 1;
  if (g->line.length + length > parameter_width) flush_parameters(g);
  lam_text_add(&g->line, parameter);
  lam_text_bytes(&g->line, &delimiter, 1);
}

static void put_integer(iges *g, int value) {
  char digits[16];
  snprintf(digits, sizeof digits, "%d", value);
  put_parameter(g, digits, ',');
}

/* A real number; the last parameter of an entity has the record delimiter. */
static void put_real(iges *g, double value, bool last) {
  lam_text digits = {.arena = g->out->arena};
  lam_text_real(&digits, value);
  put_parameter(g, digits.data, last ? ';' : ',');
}

/* The two directory lines of an entity whose parameters begin at the given line and end at the last
 * one. Fields of eight columns: type, first parameter line, structure, line font, level, view,
 * transformation, label display, status; type, line weight, color, number of parameter lines, form,
 * two reserved ones, label, subscript. */
static void put_directory(iges *g, int type, int first, int level, const char *label) {
  char data[2 * data_width]; /* wide enough for any numbers */
  snprintf(data, sizeof data, "%8d%8d%8d%8d%8d%8d%8d%8d%08d", type, first, 0, 1, level, 0, 0, 0, 0);
  put_line(&g->directory, data, data_width, 'D', ++g->directory_lines);

  snprintf(data, sizeof data, "%8d%8d%8d%8d%8d%8s%8s%8.8s%8d", type, 0, 0,
           g->parameter_lines - first + 1, 0, "", "", label, 0);
  put_line(&g->directory, data, data_width, 'D', ++g->directory_lines);
}

/* Begins the parameter list, whose first number is the type. */
static void begin_entity(iges *g, int type) {
  g->pointer = g->directory_lines + 1;
  put_integer(g, type);
}

static void end_entity(iges *g, int type, int first, int level, const char *label) {
  flush_parameters(g);
  put_directory(g, type, first, level, label);
}

static void put_point(iges *g, lam_vec3 p) {
  put_real(g, 1000 * p.x, false);
  put_real(g, 1000 * p.y, false);
  put_real(g, 1000 * p.z, false);
}

/* Whether the surface closes up in direction d. */
static bool closes_up(const lam_spline_surface *s, int d) {
  lam_spline_side low = lam_spline_side_of(s, d ? 0 : 3), high = lam_spline_side_of(s, d ? 2 : 1);
  return lam_spline_sides_meet(&low, &high);
}

/* Entity 128: K1, K2, M1, M2 (counts less one, degrees), five flags, knots in u and v, weights
 * and points with u running fastest, the domain. Knots must be clamped. */
static void put_surface(iges *g, const lam_spline_surface *s) {
  int first = g->parameter_lines + 1, total = s->count[0] * s->count[1];
  begin_entity(g, 128);

  for (int d = 0; d < 2; d++) put_integer(g, s->count[d] - 1);
  for (int d = 0; d < 2; d++) put_integer(g, s->degree[d]);
  for (int d = 0; d < 2; d++) put_integer(g, closes_up(s, d));
  put_integer(g, s->weights == NULL); /* 1: polynomial */
  put_integer(g, 0);                  /* not periodic in u */
  put_integer(g, 0);                  /* not periodic in v */

  for (int d = 0; d < 2; d++)
    for (int k = 0; k < s->count[d] + s->degree[d] + 1; k++) put_real(g, s->knots[d][k], false);
  for (int k = 0; k < total; k++) {
    int at = k % s->count[0] * s->count[1] + k / s->count[0];
    put_real(g, s->weights ? s->weights[at] : 1, false);
  }
  for (int k = 0; k < total; k++)
    put_point(g, s->points[k % s->count[0] * s->count[1] + k / s->count[0]]);

  for (int d = 0; d < 2; d++) {
    put_real(g, s->knots[d][s->degree[d]], false);
    put_real(g, s->knots[d][s->count[d]], d == 1);
  }
  end_entity(g, 128, first, 0, "SURFACE");
}

/* Entity 126: K, M (count less one, degree), four flags (planar, closed, polynomial, periodic),
 * knots, weights, points, the range of parameters, a normal that counts for planar curves only. */
static void put_curve(iges *g, const lam_spline_side *c, int level, const char *label) {
  int line = g->parameter_lines + 1, last = c->first + (c->count - 1) * c->stride;
  begin_entity(g, 126);
  put_integer(g, c->count - 1);
  put_integer(g, c->degree);
  put_integer(g, 0); /* not known to be planar */
  put_integer(g, lam_spline_meet(c->points[c->first], c->points[last]));
  put_integer(g, c->weights == NULL);
  put_integer(g, 0);

  for (int i = 0; i < c->count + c->degree + 1; i++) put_real(g, c->knots[i], false);
  for (int i = 0; i < c->count; i++)
    put_real(g, c->weights ? c->weights[c->first + i * c->stride] : 1, false);
  for (int i = 0; i < c->count; i++) put_point(g, c->points[c->first + i * c->stride]);

  put_real(g, c->knots[c->degree], false);
  put_real(g, c->knots[c->count], false);
  for (int i = 0; i < 3; i++) put_real(g, 0, i == 2);
  end_entity(g, 126, line, level, label);
}

/* A side as a curve. One that is only a point, or lies on the opposite one, is left out. */
static void put_side(iges *g, const lam_spline_surface *s, int k) {
  lam_spline_side c = lam_spline_side_of(s, k);
  if (!lam_spline_side_is_point(&c) && !(k >= 2 && closes_up(s, k == 2)))
    put_curve(g, &c, 0, "SIDE");
}

/* Families have levels of their own: 1 and 2, curves of no family 3; surfaces and their sides are
 * on level 0. */
static int level_of(int family) { return family < 0 ? 3 : family + 1; }

/* A string as IGES has it: nH and its n bytes, then the delimiter. */
static void add_string(lam_text *out, const char *string) {
  lam_text_printf(out, "%dH%s,", (int)strlen(string), string);
}

/* The global section (IGES 5.3, 2.2.4.3): delimiters, names, precision, unit 2 = mm, and fixed
 * dates, so that the same model gives the same bytes. Returns its number of lines. */
static int put_global(iges *g, const lam_model *model) {
  lam_text all = {.arena = g->out->arena};
  lam_text_add(&all, "1H,,1H;,");
  add_string(&all, model->name);
  add_string(&all, lam_arena_printf(g->out->arena, "%s.igs", model->name));
  add_string(&all, "lamella");
  add_string(&all, model->version);
  lam_text_add(&all, "32,38,6,308,15,");
  add_string(&all, model->name);
  lam_text_add(&all,
               "1.0,2,2HMM,1,0.01,15H20000101.000000,1.0E-5,1.0E5,,,11,0,15H20000101.000000;");

  /* Lines of this section are broken anywhere, also within a parameter. */
  int lines = 0;
  for (size_t at = 0; at < all.length; at += data_width) {
    char data[data_width + 1];
    snprintf(data, sizeof data, "%.*s", data_width, all.data + at);
    put_line(g->out, data, data_width, 'G', ++lines);
  }
  return lines;
}

static int count(const lam_model *model) {
  return model->surface_count > 0 || model->curve_count > 0;
}

static void path(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_printf(out, "%s.igs", model->name);
}

/* Sections follow one another: start, global, directory, parameters, terminate. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  iges g = {.out = out};
  g.directory.arena = g.parameters.arena = g.line.arena = out->arena;
  put_line(out, "smooth surfaces and curves of a design, in millimeters", data_width, 'S', 1);
  int global_lines = put_global(&g, model);

  for (int s = 0; s < model->surface_count; s++) {
    lam_spline_surface clamped = lam_spline_clamped(out->arena, &model->surfaces[s]);
    put_surface(&g, &clamped);
    for (int k = 0; k < 4; k++) put_side(&g, &clamped, k);
  }

  for (int c = 0; c < model->curve_count; c++) {
    lam_spline_side side = lam_spline_side_of_curve(&model->curves[c].spline);
    put_curve(&g, &side, level_of(model->curves[c].family), model->curves[c].name);
  }

  lam_text_bytes(out, g.directory.data, g.directory.length);
  lam_text_bytes(out, g.parameters.data, g.parameters.length);
  char data[data_width + 1];
  snprintf(data, sizeof data, "S%7dG%7dD%7dP%7d", 1, global_lines, g.directory_lines,
           g.parameter_lines);
  put_line(out, data, data_width, 'T', 1);
  return LAM_OK;
}

const lam_format lam_format_iges = {
    .name = "iges",
    .doc = "The smooth surfaces and their sides, and the axes of lamellas or the lines of the net "
           "as curves, for CAD programs (IGES 5.3, entities 128 and 126), in millimeters.",
    .ending = "igs iges",
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
    .read_surfaces = lam_iges_read_surfaces,
    .read_curves = lam_iges_read_curves,
};
