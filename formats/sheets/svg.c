/* SVG: a file per sheet (sheets/NAME.svg; listed in formats/list/formats.c), true to size (one user
 * unit is a millimeter), a group per layer, as Inkscape has them, and in each a group per part.
 * SVG's y axis points down: y is mirrored. */
#include "core/flat_shape.h"
#include "formats/format.h"
#include "formats/sheets/layer.h"
#include "formats/sheets/sheet_order.h"
#include "formats/xml.h"

#include <string.h>

enum { DECIMALS = 4 };

static void number(lam_text *out, double meters) { lam_text_number(out, meters * 1e3, DECIMALS); }

/* The style sheet: a class per layer. On a screen lines are a pixel wide at any zoom. */
static void style(lam_text *out) {
  lam_text_add(out, "<style>\npath, circle { fill: none; stroke-width: 0.1; "
                    "stroke-linejoin: round; stroke-linecap: round }\n");
  lam_text_add(out, "@media screen { path, circle { stroke-width: 1px; vector-effect: "
                    "non-scaling-stroke } }\n");
  for (int i = 0; i < LAM_LAYER_COUNT; i++)
    lam_text_printf(out, ".%s { stroke: %s }\n", lam_layer_styles[i].name,
                    lam_layer_styles[i].color);
  lam_text_add(out, "</style>\n");
}

/* Begins an element of a layer; colors are repeated as attributes for programs that do not read
 * style sheets. */
static void element(lam_text *out, const char *name, lam_layer layer) {
  const lam_layer_style *look = &lam_layer_styles[layer];
  lam_text_printf(out, "<%s class=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"0.1\"", name,
                  look->name, look->color);
}

/* The points of a path on a sheet of the given height (meters). */
static void points_of(lam_text *out, const lam_path *path, double height) {
  lam_text_add(out, "M");
  for (int i = 0; i < path->count; i++) {
    if (i) lam_text_add(out, i == 1 ? " L" : " ");
    number(out, path->points[i].x);
    lam_text_add(out, ",");
    number(out, height - path->points[i].y);
  }
  if (path->closed) lam_text_add(out, " Z");
}

static void circle(lam_text *out, const lam_path *path, double height) {
  lam_vec2 center = lam_path_center(path);
  element(out, "circle", path->layer);
  lam_text_add(out, " cx=\"");
  number(out, center.x);
  lam_text_add(out, "\" cy=\"");
  number(out, height - center.y);
  lam_text_add(out, "\" r=\"");
  number(out, path->radius);
  lam_text_add(out, "\"/>\n");
}

/* Paths that are one object: a circle, or one element with all their points. */
static void draw(lam_text *out, const lam_path *paths, int count, double height) {
  if (paths->radius > 0) {
    circle(out, paths, height);
    return;
  }
  element(out, "path", paths->layer);
  lam_text_add(out, " d=\"");
  for (int i = 0; i < count; i++) {
    if (i) lam_text_add(out, " ");
    points_of(out, &paths[i], height);
  }
  lam_text_add(out, "\"/>\n");
}

/* The beginning of the drawing: its size, what the sheet is of, whether the kerf is compensated. */
static void head(lam_text *out, const lam_model *model, const lam_sheet *sheet) {
  lam_text_add(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "
                    "xmlns=\"http://www.w3.org/2000/svg\" "
                    "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                    "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" "
                    "width=\"");
  number(out, sheet->width);
  lam_text_add(out, "mm\" height=\"");
  number(out, sheet->height);
  lam_text_add(out, "mm\" viewBox=\"0 0 ");
  number(out, sheet->width);
  lam_text_add(out, " ");
  number(out, sheet->height);

  lam_text_add(out, "\">\n<title>");
  lam_xml_escaped(out, model->title ? model->title : model->name);
  lam_text_printf(out, ": %s</title>\n<desc>%s, ", sheet->name,
                  sheet->material ? sheet->material->name : "any material");
  number(out, sheet->thickness);
  lam_text_add(out, " mm thick; ");

  if (sheet->kerf > 0) {
    lam_text_add(out, "kerf of ");
    number(out, sheet->kerf);
    lam_text_add(out, " mm is compensated</desc>\n");
  } else
    lam_text_add(out, "kerf is not compensated</desc>\n");
  style(out);
}

/* Which of the pieces with its label, from 1. */
static int copy_of(const lam_sheet *sheet, int index) {
  int copy = 1;
  for (int q = 0; q < index; q++)
    copy += strcmp(sheet->placed[q].label, sheet->placed[index].label) == 0;
  return copy;
}

/* Begins a layer; the edge of the stock is locked, so that nobody moves or cuts it. */
static void begin_layer(lam_text *out, lam_layer layer) {
  const char *name = lam_layer_styles[layer].name;
  const char *lock = layer == LAM_LAYER_SHEET ? " sodipodi:insensitive=\"true\"" : "";
  lam_text_printf(out, "<g id=\"layer-%s\" inkscape:groupmode=\"layer\" inkscape:label=\"%s\"%s>\n",
                  name, name, lock);
}

/* Begins what one step does to a piece. The id is the label, with a number for the second and later
 * copies on a sheet, and the step; that of the outlines is the label alone. */
static void begin_piece(lam_text *out, const lam_sheet *sheet, const lam_sheet_line *line) {
  static const char *const steps[] = {"-engrave", "-label", "-holes", ""};
  int copy = copy_of(sheet, line->piece);
  lam_text_add(out, "<g class=\"part\" id=\"");
  lam_xml_escaped(out, sheet->placed[line->piece].label);
  if (copy > 1) lam_text_printf(out, "-copy-%d", copy);
  lam_text_printf(out, "%s\">\n", steps[line->step]);
}

/* All lines of the sheet, in groups that change with the layer, the step and the piece. */
static void draw_lines(lam_text *out, const lam_sheet *sheet) {
  lam_sheet_line *lines;
  int count = lam_sheet_order(out->arena, sheet, &lines), layer = -1;
  for (int i = 0; i < count; i++) {
    const lam_sheet_line *line = &lines[i], *before = i ? &lines[i - 1] : NULL;
    const lam_path *paths = &sheet->placed[line->piece].paths[line->first];
    bool same_layer = (int)paths->layer == layer;
    bool same_piece = before && before->piece == line->piece && before->step == line->step;

    if (before && !(same_layer && same_piece)) lam_text_add(out, "</g>\n");
    if (before && !same_layer) lam_text_add(out, "</g>\n");
    if (!same_layer) begin_layer(out, paths->layer);
    if (!(same_layer && same_piece)) begin_piece(out, sheet, line);
    draw(out, paths, line->count, sheet->height);
    layer = (int)paths->layer;
  }
  if (count) lam_text_add(out, "</g>\n</g>\n");
}

static int count_files(const lam_model *model) { return model->sheet_count; }

static void path_of(const lam_model *model, int i, lam_text *path) {
  lam_text_printf(path, "sheets/%s.svg", model->sheets[i].name);
}

/* The border of the sheet with what it warns of, then the pieces. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  const lam_sheet *sheet = &model->sheets[i];
  double w = sheet->width, h = sheet->height;
  lam_path border = {.layer = LAM_LAYER_SHEET,
                     .closed = true,
                     .count = 4,
                     .points = (lam_vec2[]){{0, 0}, {w, 0}, {w, h}, {0, h}}};

  head(out, model, sheet);
  begin_layer(out, LAM_LAYER_SHEET);
  draw(out, &border, 1, h);
  if (sheet->warning_count) draw(out, sheet->warnings, sheet->warning_count, h);
  lam_text_add(out, "</g>\n");
  draw_lines(out, sheet);
  lam_text_add(out, "</svg>\n");
  return LAM_OK;
}

const lam_format lam_format_svg = {
    .name = "svg",
    .doc = "Cutting sheets as SVG, true to size in millimeters: layers as in DXF, as Inkscape has "
           "them, a group per part in each; the frame of the sheet is locked.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
