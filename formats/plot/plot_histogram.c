/* The histogram of a plot, whose bars explain the colors, and texts for plots. Called by
 * plot_svg.c. */
#include "formats/plot/plot.h"
#include "formats/xml.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { bins = 24 };
static const double label_size = 2.6; /* mm */

const char *const lam_map_elements[] = {
    [LAM_MAP_VERTICES] = "vertices", [LAM_MAP_EDGES] = "edges", [LAM_MAP_FACES] = "faces"};

/* Two decimals: a hundredth of a millimeter. */
void lam_plot_text(lam_text *out, double x, double y, double size, const char *anchor,
                   const char *text) {
  lam_text_add(out, "<text x=\"");
  lam_text_number(out, x, 2);
  lam_text_add(out, "\" y=\"");
  lam_text_number(out, y, 2);
  lam_text_add(out, "\" font-size=\"");
  lam_text_number(out, size, 2);
  lam_text_printf(out, "\" text-anchor=\"%s\">", anchor);
  lam_xml_escaped(out, text);
  lam_text_add(out, "</text>\n");
}

/* Only areas and volumes are raised. */
const char *lam_plot_unit(lam_arena *arena, const char *unit) {
  size_t length = strlen(unit);
  if (length < 2 || unit[length - 2] != 'm' || (unit[length - 1] != '2' && unit[length - 1] != '3'))
    return unit;
  return lam_arena_printf(arena, "%.*s%s", (int)length - 1, unit,
                          unit[length - 1] == '2' ? "\u00b2" : "\u00b3");
}

/* Begins a rectangle; the caller adds its color and ends it. */
static void rectangle(lam_text *out, const char *class, lam_box box) {
  lam_text_printf(out, "<rect class=\"%s\" x=\"", class);
  lam_text_number(out, box.x, 3);
  lam_text_add(out, "\" y=\"");
  lam_text_number(out, box.y, 3);
  lam_text_add(out, "\" width=\"");
  lam_text_number(out, box.width, 3);
  lam_text_add(out, "\" height=\"");
  lam_text_number(out, box.height, 3);
  lam_text_add(out, "\"");
}

/* A line of a class of the style sheet. */
static void line(lam_text *out, const char *class, double x1, double y1, double x2, double y2) {
  const double values[4] = {x1, y1, x2, y2};
  static const char *const names[4] = {"x1", "y1", "x2", "y2"};
  lam_text_printf(out, "<line class=\"%s\"", class);
  for (int k = 0; k < 4; k++) {
    lam_text_printf(out, " %s=\"", names[k]);
    lam_text_number(out, values[k], 3);
    lam_text_add(out, "\"");
  }
  lam_text_add(out, "/>\n");
}

/* The distance of ticks: 1, 2 or 5 times a power of ten, at least span / count. span > 0. */
static double tick_step(double span, int count) {
  double power = pow(10, floor(log10(span / count)));
  for (int k = 0; k < 3; k++) {
    static const double factors[3] = {1, 2, 5};
    if (factors[k] * power * count >= span * (1 - 1e-9)) return factors[k] * power;
  }
  return 10 * power;
}

/* Writes a tick's value with enough digits to tell neighboring ticks apart; whole numbers below a
 * million in full, never 1e+02. */
static void tick_label(char text[32], double value, double step) {
  double size = fabs(value) / step;
  int digits = size > 1 ? (int)ceil(log10(size + .5)) + 1 : 1;
  if (step > 1 && digits < 6) digits = 6;
  snprintf(text, 32, "%.*g", digits > 15 ? 15 : digits, fabs(value) < step * 1e-6 ? 0 : value);
}

/* The width of the widest label of ticks from low to high, in mm: .62 of the height per letter. */
static double widest_label(double low, double high, double step) {
  char text[32];
  double widest = 0;
  for (double t = ceil(low / step); t <= high / step; t++) {
    tick_label(text, t * step, step);
    double width = 0;
    for (const char *c = text; *c; c++) width += .62 * label_size;
    widest = fmax(widest, width);
  }
  return widest;
}

/* Ticks at multiples of the step, as many (up to six) as their labels have room for, 2 mm apart. */
static void value_axis(lam_text *out, double low, double high, lam_box box) {
  char text[32];
  double step = 0;
  for (int count = 6; count > 0; count--) {
    step = tick_step(high - low, count);
    if (widest_label(low, high, step) + 2 < box.width * step / (high - low)) break;
  }

  double y = box.y + box.height;
  for (double t = ceil(low / step - 1e-9); t <= high / step + 1e-9; t++) {
    double x = box.x + box.width * (t * step - low) / (high - low);
    tick_label(text, t * step, step);
    line(out, "axis", x, y + 3, x, y + 4);
    lam_plot_text(out, x, y + 4.6 + label_size * .8, label_size, "middle", text);
  }
}

/* Whole numbers from 0, with lines across the box; about five. */
static void count_axis(lam_text *out, long most, lam_box box) {
  double step = fmax(1, tick_step((double)most, 5));
  for (double t = 0; t * step <= (double)most; t++) {
    char text[32];
    double y = box.y + box.height * (1 - t * step / (double)most);
    snprintf(text, sizeof text, "%.0f", t * step);
    line(out, "grid", box.x, y, box.x + box.width, y);
    lam_plot_text(out, box.x - 1.2, y + .35 * label_size, label_size, "end", text);
  }
}

/* A bar and, below the axis, its color. k: which bin, of count; value: how many elements it has,
 * at most `most`; low, high: ends of the scale. A title says what it stands for. */
static void bar(lam_text *out, const lam_color_scale *scale, lam_box box, int k, int count,
                long value, long most, double low, double high) {
  double width = box.width / count, height = box.height * (double)value / (double)most;
  double from = low + (high - low) * k / count, to = low + (high - low) * (k + 1) / count;
  lam_text color = {.arena = out->arena};
  lam_rgb_write(&color, lam_color_of(scale, (from + to) / 2));

  rectangle(out, "bin", (lam_box){box.x + k * width, box.y + box.height - height, width, height});
  lam_text_printf(out, " fill=\"%s\"><title>%ld from %.6g to %.6g</title></rect>\n", color.data,
                  value, from, to);
  rectangle(out, "color", (lam_box){box.x + k * width, box.y + box.height + 1, width, 2});
  lam_text_printf(out, " fill=\"%s\"/>\n", color.data);
}

/* Counts the values of each bin; those that are not finite in none. count bins from low to high.
 * Returns the largest number, at least 1. */
static long count_values(const lam_map *map, double low, double high, int count,
                         long in_bin[bins]) {
  long most = 1;
  for (int i = 0; i < map->count; i++) {
    if (!isfinite(map->values[i])) continue;
    int k = count == 1 ? 0 : (int)((map->values[i] - low) / (high - low) * count);
    in_bin[k < count ? k : count - 1]++;
  }
  for (int k = 0; k < count; k++) most = in_bin[k] > most ? in_bin[k] : most;
  return most;
}

/* Below the bars: the one value of a constant map, or an axis and a line at the mean; then the name
 * of the measure with its unit. */
static void label_values(lam_text *out, const lam_map *map, bool constant, double low, double high,
                         lam_box box) {
  const lam_measure *m = &map->summary;
  if (constant) {
    lam_plot_text(out, box.x + box.width / 2, box.y + box.height + 6.7, label_size, "middle",
                  lam_arena_printf(out->arena, "%.9g", m->mean));
  } else {
    double x = box.x + box.width * (m->mean - low) / (high - low);
    value_axis(out, low, high, box);
    line(out, "mean", x, box.y - 1, x, box.y + box.height);
    lam_plot_text(out, x, box.y - 1.6, label_size, "middle", "mean");
  }

  const char *open = *m->unit ? " (" : "", *close = *m->unit ? ")" : "";
  lam_plot_text(out, box.x + box.width / 2, box.y + box.height + 11, label_size + .2, "middle",
                lam_arena_printf(out->arena, "%s%s%s%s", m->name, open,
                                 lam_plot_unit(out->arena, m->unit), close));
}

/* The range is that of the colors when maps share one, so that their histograms compare. */
void lam_plot_histogram(lam_text *out, const lam_map *map, const lam_color_scale *scale,
                        lam_box box) {
  bool shared = map->range[0] < map->range[1];
  double low = shared ? map->range[0] : map->summary.min,
         high = shared ? map->range[1] : map->summary.max;
  int count = scale->constant ? 1 : bins;
  long in_bin[bins] = {0}, most = count_values(map, low, high, count, in_bin);

  lam_text_add(
      out,
      "<g class=\"histogram\">\n<style>.axis { stroke: #202020; stroke-width: .2 } .grid { stroke: "
      "#d0d0d0; stroke-width: .12 } .mean { stroke: #202020; stroke-width: .3; stroke-dasharray: "
      "1 .7 } .bin { stroke: #202020; stroke-width: .1 } .color { shape-rendering: crispEdges "
      "}</style>\n");
  lam_plot_text(out, box.x, box.y - 5, label_size, "start",
                lam_arena_printf(out->arena, "Number of %s", lam_map_elements[map->on]));

  count_axis(out, most, box);
  for (int k = 0; k < count; k++) bar(out, scale, box, k, count, in_bin[k], most, low, high);
  line(out, "axis", box.x, box.y + box.height, box.x + box.width, box.y + box.height);
  label_values(out, map, scale->constant, low, high, box);
  lam_text_add(out, "</g>\n");
}
