/* Color maps as drawings for print (plots/MEASURE.svg; listed in formats/list/formats.c): the net
 * in the colors of a measure (plot_view.c), beside it the histogram of the measure
 * (plot_histogram.c), whose bars explain the colors. */
#include "formats/format.h"
#include "formats/plot/plot.h"
#include "formats/xml.h"

#include <math.h>
#include <string.h>

/* Millimeters. */
static const double page_width = 196, page_height = 112;
static const lam_box view_box = {6, 26, 108, 80}, histogram_box = {134, 32, 54, 40};

/* The text on lines of at most `columns` characters, broken at blanks; size: height of the
 * letters. */
static void add_paragraph(lam_text *out, double x, double y, double size, int columns,
                          const char *text) {
  while (*text) {
    size_t length = strlen(text);
    if (length > (size_t)columns)
      for (length = (size_t)columns; length > 1 && text[length] != ' ';) length--;
    lam_plot_text(out, x, y, size, "start",
                  lam_arena_printf(out->arena, "%.*s", (int)length, text));
    text += length + strspn(text + length, " ");
    y += 1.3 * size;
  }
}

/* A row of the table under the histogram: a name and what it stands for. */
static void add_row(lam_text *out, double y, const char *name, const char *text) {
  lam_plot_text(out, 134, y, 2.8, "start", name);
  lam_plot_text(out, 154, y, 2.8, "start", text);
}

/* Minimum, mean, maximum and numbers, under the histogram; undefined values with their color. */
static void add_summary(lam_text *out, const lam_map *map) {
  const lam_measure *m = &map->summary;
  static const char *const names[3] = {"minimum", "mean", "maximum"};
  const double values[3] = {m->min, m->mean, m->max};
  const char *unit = lam_plot_unit(out->arena, m->unit);

  for (int k = 0; k < 3; k++)
    add_row(out, 91 + 4 * k, names[k],
            lam_arena_printf(out->arena, "%.6g%s%s", values[k] + 0., *unit ? " " : "", unit));
  add_row(out, 103, "counted",
          lam_arena_printf(out->arena, "%ld %s", m->count, lam_map_elements[map->on]));

  if (map->count == m->count) return;
  add_row(out, 107, "undefined", lam_arena_printf(out->arena, "%ld", (long)map->count - m->count));
  lam_text_add(out, "<rect x=\"150\" y=\"105\" width=\"2.4\" height=\"2.4\" fill=\"");
  lam_rgb_write(out, lam_color_of(&(lam_color_scale){0, 1, false, false}, NAN));
  lam_text_add(out, "\"/>\n");
}

static int count(const lam_model *model) { return model->net ? model->map_count : 0; }

static void path(const lam_model *model, int i, lam_text *name) {
  lam_text_printf(name, "plots/%s.svg", model->maps[i].summary.name);
}

/* The beginning of the drawing: page, title, and a heading that is smaller when it is long. */
static void add_head(lam_text *out, const char *heading) {
  lam_text_printf(
      out,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"%gmm\" height=\"%gmm\" viewBox=\"0 0 %g %g\" font-family=\"Helvetica, Arial, "
      "sans-serif\" fill=\"#202020\">\n<title>",
      page_width, page_height, page_width, page_height);
  lam_xml_escaped(out, heading);
  lam_text_printf(out, "</title>\n<rect width=\"%g\" height=\"%g\" fill=\"#ffffff\"/>\n",
                  page_width, page_height);
  lam_plot_text(out, 8, 10, fmin(4.4, 300 / (double)strlen(heading)), "start", heading);
}

/* A measure without any value, or whose mean is not a number, has no histogram. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  const lam_map *map = &model->maps[i];
  const lam_measure *m = &map->summary;
  const char *title = model->title && *model->title ? model->title : model->name;
  const char *heading = lam_arena_printf(out->arena, "%s: %s", title, m->name);
  lam_color_scale scale = lam_map_scale(map);
  add_head(out, heading);
  add_paragraph(out, 8, 15, 2.8, 125, map->doc);
  lam_plot_view(out, model->net, map, &scale, view_box);

  if (m->count > 0 && isfinite(m->mean)) {
    lam_plot_histogram(out, map, &scale, histogram_box);
    add_summary(out, map);
  } else
    lam_plot_text(out, histogram_box.x, histogram_box.y, 2.8, "start",
                  m->count ? "Some values are not numbers." : "No element has a value.");
  lam_text_add(out, "</svg>\n");
  return LAM_OK;
}

const lam_format lam_format_plot = {
    .name = "plot",
    .doc = "Color maps of the net with histograms, as SVG for print.",
    .count = count,
    .path = path,
    .write = write,
};
