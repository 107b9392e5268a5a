/* surface.obj (listed in formats/list/formats.c): the spline surfaces and curves as free-form
 * geometry of Wavefront OBJ (specification 3.0), in meters. Control points are listed with u
 * running fastest; weights are the fourth number of a vertex, which is not multiplied by them.
 * surface_obj_read.c reads such files. */
#include "formats/format.h"

enum { items_in_a_line = 16 };

static int count(const lam_model *model) {
  return model->surface_count > 0 || model->curve_count > 0;
}

static void path(const lam_model *model, int i, lam_text *out) {
  (void)model, (void)i;
  lam_text_add(out, "surface.obj");
}

static void add_real(lam_text *out, double value) {
  lam_text_add(out, " ");
  lam_text_real(out, value);
}

/* A backslash carries a statement over to the next line. */
static void break_line(lam_text *out, int item) {
  if (item && item % items_in_a_line == 0) lam_text_add(out, " \\\n");
}

/* v x y z, with the weight behind when there is one (weight NULL: none). */
static void add_vertex(lam_text *out, lam_vec3 p, const double *weight) {
  lam_text_add(out, "v");
  add_real(out, p.x);
  add_real(out, p.y);
  add_real(out, p.z);
  if (weight) add_real(out, *weight);
  lam_text_add(out, "\n");
}

/* The knots of one direction, u or v. */
static void add_knots(lam_text *out, char direction, const double *knots, int count) {
  lam_text_printf(out, "parm %c", direction);
  for (int i = 0; i < count; i++) {
    break_line(out, i);
    add_real(out, knots[i]);
  }
  lam_text_add(out, "\n");
}

/* Ends a statement with the numbers of `count` vertices from `first` (from 0; from 1 in the
 * file); `items` stand before them in the line. */
static void add_references(lam_text *out, int first, int count, int items) {
  for (int k = 0; k < count; k++) {
    break_line(out, k + items);
    lam_text_printf(out, " %d", first + k + 1);
  }
  lam_text_add(out, "\n");
}

/* The vertices, which get the numbers from `first` on, then the element: its domain and vertices,
 * its knots. */
static void add_surface(lam_text *out, const lam_spline_surface *s, int first) {
  int total = s->count[0] * s->count[1];
  for (int k = 0; k < total; k++) {
    int at = k % s->count[0] * s->count[1] + k / s->count[0];
    add_vertex(out, s->points[at], s->weights ? &s->weights[at] : NULL);
  }

  lam_text_printf(out, "g %s\ncstype %sbspline\ndeg %d %d\nsurf", s->name, s->weights ? "rat " : "",
                  s->degree[0], s->degree[1]);
  for (int d = 0; d < 2; d++) {
    add_real(out, s->knots[d][s->degree[d]]);
    add_real(out, s->knots[d][s->count[d]]);
  }

  add_references(out, first, total, 4);
  for (int d = 0; d < 2; d++)
    add_knots(out, d ? 'v' : 'u', s->knots[d], s->count[d] + s->degree[d] + 1);
  lam_text_add(out, "end\n");
}

/* The same for a curve. */
static void add_curve(lam_text *out, const lam_named_curve *named, int first) {
  const lam_spline_curve *c = &named->spline;
  for (int k = 0; k < c->count; k++)
    add_vertex(out, c->points[k], c->weights ? &c->weights[k] : NULL);

  lam_text_printf(out, "g %s\ncstype %sbspline\ndeg %d\ncurv", named->name,
                  c->weights ? "rat " : "", c->degree);
  add_real(out, c->knots[c->degree]);
  add_real(out, c->knots[c->count]);
  add_references(out, first, c->count, 2);
  add_knots(out, 'u', c->knots, c->count + c->degree + 1);
  lam_text_add(out, "end\n");
}

/* Vertices are numbered through the whole file. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  int first = 0;
  lam_text_printf(out, "# %s: smooth surfaces and curves, meters\n", model->name);

  for (int s = 0; s < model->surface_count; s++) {
    add_surface(out, &model->surfaces[s], first);
    first += model->surfaces[s].count[0] * model->surfaces[s].count[1];
  }

  for (int c = 0; c < model->curve_count; c++) {
    add_curve(out, &model->curves[c], first);
    first += model->curves[c].spline.count;
  }
  return LAM_OK;
}

const lam_format lam_format_surface_obj = {
    .name = "surface_obj",
    .doc = "The smooth surfaces, and the axes of lamellas or the lines of the net as curves, as "
           "free-form geometry of Wavefront OBJ, in meters.",
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
};
