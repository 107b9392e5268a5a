/* DXF, release 12 (AC1009): a file per sheet (sheets/NAME.dxf; listed in formats/list/formats.c),
 * in millimeters. Everything is a POLYLINE or a CIRCLE, so that every laser, plasma and water-jet
 * program reads it; a closed polyline has flag 1 and does not repeat its first point. Colors are
 * those of the layers. */
#include "core/flat_shape.h"
#include "formats/format.h"
#include "formats/sheets/layer.h"
#include "formats/sheets/sheet_order.h"

enum { DECIMALS = 4 };

/* A group of the file: a code, which says what the value means, and the value, a line each. */
static void pair(lam_text *out, int code, const char *value) {
  lam_text_printf(out, "%3d\n%s\n", code, value);
}
static void pair_int(lam_text *out, int code, int value) {
  lam_text_printf(out, "%3d\n%d\n", code, value);
}
static void pair_mm(lam_text *out, int code, double meters) {
  lam_text_printf(out, "%3d\n", code);
  lam_text_number(out, meters * 1e3, DECIMALS);
  lam_text_add(out, "\n");
}

/* Variables of the header: a point, an integer. */
static void variable_point(lam_text *out, const char *name, double x, double y) {
  pair(out, 9, name);
  pair_mm(out, 10, x);
  pair_mm(out, 20, y);
  pair_mm(out, 30, 0);
}

static void variable_int(lam_text *out, const char *name, int value) {
  pair(out, 9, name);
  pair_int(out, 70, value);
}

/* The header: version, code page, millimeters (INSUNITS 4, metric), the sheet as extent and
 * limits. */
static void header(lam_text *out, const lam_sheet *sheet) {
  pair(out, 0, "SECTION");
  pair(out, 2, "HEADER");
  pair(out, 9, "$ACADVER");
  pair(out, 1, "AC1009");
  pair(out, 9, "$DWGCODEPAGE");
  pair(out, 3, "ANSI_1252");

  variable_int(out, "$INSUNITS", 4);
  variable_int(out, "$MEASUREMENT", 1);

  variable_point(out, "$INSBASE", 0, 0);
  variable_point(out, "$EXTMIN", 0, 0);
  variable_point(out, "$EXTMAX", sheet->width, sheet->height);

  pair(out, 9, "$LIMMIN");
  pair_mm(out, 10, 0);
  pair_mm(out, 20, 0);
  pair(out, 9, "$LIMMAX");
  pair_mm(out, 10, sheet->width);
  pair_mm(out, 20, sheet->height);
  pair(out, 0, "ENDSEC");
}

static void table(lam_text *out, const char *name, int entries) {
  pair(out, 0, "TABLE");
  pair(out, 2, name);
  pair_int(out, 70, entries);
}

/* One line type and the layers, of which layer 0 is always there. */
static void tables(lam_text *out) {
  pair(out, 0, "SECTION");
  pair(out, 2, "TABLES");

  table(out, "LTYPE", 1);
  pair(out, 0, "LTYPE");
  pair(out, 2, "CONTINUOUS");
  pair_int(out, 70, 0);
  pair(out, 3, "Solid line");
  pair_int(out, 72, 65);
  pair_int(out, 73, 0);
  pair_int(out, 40, 0);
  pair(out, 0, "ENDTAB");

  table(out, "LAYER", LAM_LAYER_COUNT + 1);
  for (int i = -1; i < LAM_LAYER_COUNT; i++) {
    pair(out, 0, "LAYER");
    pair(out, 2, i < 0 ? "0" : lam_layer_styles[i].dxf_name);
    pair_int(out, 70, 0);
    pair_int(out, 62, i < 0 ? 7 : lam_layer_styles[i].aci);
    pair(out, 6, "CONTINUOUS");
  }
  pair(out, 0, "ENDTAB");
  pair(out, 0, "ENDSEC");
}

/* Whether points fall together when rounded: then they are written once. */
static bool same(lam_vec2 a, lam_vec2 b) {
  double scale = 1e7; /* DECIMALS of a millimeter */
  return round(a.x * scale) == round(b.x * scale) && round(a.y * scale) == round(b.y * scale);
}

/* A path as POLYLINE, VERTEX ... SEQEND, with z = 0; one of fewer than two points is left out. */
static void polyline(lam_text *out, const lam_path *path) {
  const char *layer = lam_layer_styles[path->layer].dxf_name;
  int count = path->count;
  while (path->closed && count > 1 && same(path->points[0], path->points[count - 1])) count--;
  if (count < 2) return;

  pair(out, 0, "POLYLINE");
  pair(out, 8, layer);
  pair_int(out, 66, 1);
  pair_mm(out, 10, 0);
  pair_mm(out, 20, 0);
  pair_mm(out, 30, 0);
  pair_int(out, 70, path->closed ? 1 : 0);

  for (int i = 0; i < count; i++) {
    if (i && same(path->points[i - 1], path->points[i])) continue;
    pair(out, 0, "VERTEX");
    pair(out, 8, layer);
    pair_mm(out, 10, path->points[i].x);
    pair_mm(out, 20, path->points[i].y);
    pair_mm(out, 30, 0);
  }

  pair(out, 0, "SEQEND");
  pair(out, 8, layer);
}

static void circle(lam_text *out, const lam_path *path) {
  lam_vec2 center = lam_path_center(path);
  pair(out, 0, "CIRCLE");
  pair(out, 8, lam_layer_styles[path->layer].dxf_name);
  pair_mm(out, 10, center.x);
  pair_mm(out, 20, center.y);
  pair_mm(out, 30, 0);
  pair_mm(out, 40, path->radius);
}

/* Comments (code 999): what the sheet is of, and whether the kerf is compensated. */
static void remarks(lam_text *out, const lam_model *model, const lam_sheet *sheet) {
  lam_text_printf(out, "999\n%s, %s: %s, ", model->name, sheet->name,
                  sheet->material ? sheet->material->name : "any material");
  lam_text_number(out, sheet->thickness * 1e3, 3);
  lam_text_add(out, " mm thick; millimeters\n999\n");

  if (sheet->kerf > 0) {
    lam_text_add(out, "kerf of ");
    lam_text_number(out, sheet->kerf * 1e3, 3);
    lam_text_add(out, " mm is compensated: cut along the lines\n");
  } else
    lam_text_add(out, "kerf is not compensated: lines are the true edges of the parts\n");
}

/* The paths of all pieces in the order in which they are made. */
static void draw_pieces(lam_text *out, const lam_sheet *sheet) {
  lam_sheet_line *lines;
  int count = lam_sheet_order(out->arena, sheet, &lines);
  for (int i = 0; i < count; i++) {
    const lam_path *paths = &sheet->placed[lines[i].piece].paths[lines[i].first];
    for (int k = 0; k < lines[i].count; k++)
      paths[k].radius > 0 ? circle(out, &paths[k]) : polyline(out, &paths[k]);
  }
}

static int count_files(const lam_model *model) { return model->sheet_count; }

static void path_of(const lam_model *model, int i, lam_text *path) {
  lam_text_printf(path, "sheets/%s.dxf", model->sheets[i].name);
}

/* The border of the sheet with what it warns of, then the pieces. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  const lam_sheet *sheet = &model->sheets[i];
  double w = sheet->width, h = sheet->height;
  lam_path border = {.layer = LAM_LAYER_SHEET,
                     .closed = true,
                     .count = 4,
                     .points = (lam_vec2[]){{0, 0}, {w, 0}, {w, h}, {0, h}}};

  remarks(out, model, sheet);
  header(out, sheet);
  tables(out);

  pair(out, 0, "SECTION");
  pair(out, 2, "ENTITIES");
  polyline(out, &border);
  for (int k = 0; k < sheet->warning_count; k++) polyline(out, &sheet->warnings[k]);
  draw_pieces(out, sheet);
  pair(out, 0, "ENDSEC");
  pair(out, 0, "EOF");
  return LAM_OK;
}

const lam_format lam_format_dxf = {
    .name = "dxf",
    .doc = "Cutting sheets for lasers, plasma and water jets: DXF release 12, layers CUT, "
           "ENGRAVE and LABEL, the frame of the sheet on DEFPOINTS, which is never plotted; marks "
           "before holes before outlines, small parts first; millimeters.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
