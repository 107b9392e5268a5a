/* SVG: a file per sheet (sheets/NAME.svg; listed in formats/list/formats.c), true to size (one user
 * unit is a millimeter), a group per part. SVG's y axis points down: y is mirrored. */
#include "formats/format.h"
#include "formats/sheets/layer.h"
#include "formats/xml.h"

#include <string.h>

enum { DECIMALS = 4 };

static void number(lam_text *out, double meters) { lam_text_number(out, meters * 1e3, DECIMALS); }

/* The style sheet: a class per layer. */
static void style(lam_text *out) {
  lam_text_add(out, "<style>\npath { fill: none; stroke-width: 0.1; stroke-linejoin: round; "
                    "stroke-linecap: round }\n");
  for (int i = 0; i < LAM_LAYER_COUNT; i++)
    lam_text_printf(out, ".%s { stroke: %s }\n", lam_layer_styles[i].name,
                    lam_layer_styles[i].color);
  lam_text_add(out, "</style>\n");
}

/* A path of a sheet of the given height (meters); colors are repeated as attributes for programs
 * that do not read style sheets. */
static void draw(lam_text *out, const lam_path *path, double height) {
  const lam_layer_style *layer = &lam_layer_styles[path->layer];
  lam_text_printf(out, "<path class=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"0.1\" d=\"M",
                  layer->name, layer->color);

  for (int i = 0; i < path->count; i++) {
    if (i) lam_text_add(out, i == 1 ? " L" : " ");
    number(out, path->points[i].x);
    lam_text_add(out, ",");
    number(out, height - path->points[i].y);
  }
  lam_text_add(out, path->closed ? " Z\"/>\n" : "\"/>\n");
}

/* The beginning of the drawing: its size, what the sheet is of, whether the kerf is compensated. */
static void head(lam_text *out, const lam_model *model, const lam_sheet *sheet) {
  lam_text_add(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "
                    "xmlns=\"http://www.w3.org/2000/svg\" width=\"");
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

/* A piece as a group. The label is the id; copy counts from 1, and the second and later copies on
 * a sheet get it as a number. */
static void group(lam_text *out, const lam_sheet *sheet, int index, int copy) {
  const lam_sheet_piece *placed = &sheet->placed[index];
  lam_text_add(out, "<g class=\"part\" id=\"");
  lam_xml_escaped(out, placed->label);
  if (copy > 1) lam_text_printf(out, "-copy-%d", copy);
  lam_text_add(out, "\">\n");
  for (int i = 0; i < placed->path_count; i++) draw(out, &placed->paths[i], sheet->height);
  lam_text_add(out, "</g>\n");
}

static int count_files(const lam_model *model) { return model->sheet_count; }

static void path_of(const lam_model *model, int i, lam_text *path) {
  lam_text_printf(path, "sheets/%s.svg", model->sheets[i].name);
}

/* The border of the sheet, then the pieces. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  const lam_sheet *sheet = &model->sheets[i];
  double w = sheet->width, h = sheet->height;
  lam_path border = {LAM_LAYER_SHEET, true, false, 4, (lam_vec2[]){{0, 0}, {w, 0}, {w, h}, {0, h}}};

  head(out, model, sheet);
  draw(out, &border, h);
  for (int p = 0; p < sheet->piece_count; p++) {
    int copy = 1;
    for (int q = 0; q < p; q++) copy += strcmp(sheet->placed[q].label, sheet->placed[p].label) == 0;
    group(out, sheet, p, copy);
  }

  lam_text_add(out, "</svg>\n");
  return LAM_OK;
}

const lam_format lam_format_svg = {
    .name = "svg",
    .doc = "Cutting sheets as SVG, true to size in millimeters, a group per part, the same layers "
           "and colors as in DXF.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
