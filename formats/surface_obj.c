/* surface.obj: the spline surfaces as free-form surfaces of Wavefront OBJ (specification 3.0, "free-form geometry"), in
 * meters. Control points are listed with u running fastest; weights are the fourth number of a vertex, which is not
 * multiplied by them. */
#include "formats/format.h"

enum { items_in_a_line = 16 };

static int count(const lam_model *model) { return model->surface_count > 0; }

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

static void add_knots(lam_text *out, const lam_spline_surface *s, int d) {
  lam_text_printf(out, "parm %c", d ? 'v' : 'u');
  for (int i = 0; i < s->count[d] + s->degree[d] + 1; i++) {
    break_line(out, i);
    add_real(out, s->knots[d][i]);
  }
  lam_text_add(out, "\n");
}

static void add_surface(lam_text *out, const lam_spline_surface *s, int first) {
  int total = s->count[0] * s->count[1];
  for (int k = 0; k < total; k++) {
    int at = k % s->count[0] * s->count[1] + k / s->count[0];
    lam_text_add(out, "v");
    add_real(out, s->points[at].x);
    add_real(out, s->points[at].y);
    add_real(out, s->points[at].z);
    if (s->weights) add_real(out, s->weights[at]);
    lam_text_add(out, "\n");
  }
  lam_text_printf(out, "g %s\ncstype %sbspline\ndeg %d %d\nsurf", s->name, s->weights ? "rat " : "", s->degree[0],
                  s->degree[1]);
  for (int d = 0; d < 2; d++) {
    add_real(out, s->knots[d][s->degree[d]]);
    add_real(out, s->knots[d][s->count[d]]);
  }
  for (int k = 0; k < total; k++) {
    break_line(out, k + 4);
    lam_text_printf(out, " %d", first + k + 1);
  }
  lam_text_add(out, "\n");
  for (int d = 0; d < 2; d++) add_knots(out, s, d);
  lam_text_add(out, "end\n");
}

static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_printf(out, "# %s: smooth surfaces, meters\n", model->name);
  for (int s = 0, first = 0; s < model->surface_count; s++) {
    add_surface(out, &model->surfaces[s], first);
    first += model->surfaces[s].count[0] * model->surfaces[s].count[1];
  }
  return LAM_OK;
}

const lam_format lam_format_surface_obj = {
    .name = "surface_obj",
    .doc = "The smooth surfaces as free-form surfaces of Wavefront OBJ, in meters.",
    .count = count,
    .path = path,
    .write = write,
};
