/* surface.json: the control nets of the model's spline surfaces, in meters. Numbers read back exactly. */
#include "formats/format.h"

static int count(const lam_model *model) { return model->surface_count > 0; }

static void path(const lam_model *model, int i, lam_text *out) {
  (void)model, (void)i;
  lam_text_add(out, "surface.json");
}

static void add_numbers(lam_text *out, const double *numbers, int n) {
  lam_text_add(out, "[");
  for (int i = 0; i < n; i++) {
    if (i) lam_text_add(out, ", ");
    lam_text_real(out, numbers[i]);
  }
  lam_text_add(out, "]");
}

static void add_surface(lam_text *out, const lam_spline_surface *s) {
  lam_text_add(out, "    {\n      \"name\": ");
  lam_text_quoted(out, s->name);
  lam_text_printf(out, ",\n      \"degree\": [%d, %d],\n      \"count\": [%d, %d],\n", s->degree[0], s->degree[1],
                  s->count[0], s->count[1]);
  for (int d = 0; d < 2; d++) {
    lam_text_printf(out, "      \"knots_%c\": ", d ? 'v' : 'u');
    add_numbers(out, s->knots[d], s->count[d] + s->degree[d] + 1);
    lam_text_add(out, ",\n");
  }
  lam_text_add(out, "      \"points\": [");
  int total = s->count[0] * s->count[1];
  for (int i = 0; i < total; i++) {
    lam_text_add(out, i ? ",\n        " : "\n        ");
    add_numbers(out, (double[3]){s->points[i].x, s->points[i].y, s->points[i].z}, 3);
  }
  lam_text_add(out, "]");
  if (s->weights) {
    lam_text_add(out, ",\n      \"weights\": ");
    add_numbers(out, s->weights, total);
  }
  lam_text_add(out, "\n    }");
}

static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_add(out, "{\n  \"unit\": \"m\",\n  \"order_of_points\": \"v runs fastest\",\n  \"surfaces\": [\n");
  for (int s = 0; s < model->surface_count; s++) {
    add_surface(out, &model->surfaces[s]);
    lam_text_add(out, s + 1 < model->surface_count ? ",\n" : "\n");
  }
  lam_text_add(out, "  ]\n}\n");
  return LAM_OK;
}

const lam_format lam_format_surface = {
    .name = "surface",
    .doc = "The control nets of the smooth surfaces (degrees, knots, points, weights) as JSON, in meters.",
    .count = count,
    .path = path,
    .write = write,
};
