/* The nodes (nodes.csv; listed in formats/list/formats.c): where lamellas of the two families
 * cross. */
#include "core/numbers.h"
#include "formats/format.h"
#include "formats/tables/csv.h"

static const char *const columns[] = {"node",
                                      "x_mm",
                                      "y_mm",
                                      "z_mm",
                                      "normal_x",
                                      "normal_y",
                                      "normal_z",
                                      "angle_deg",
                                      "flat_angle_deg",
                                      "a_parts",
                                      "a_along_mm",
                                      "b_parts",
                                      "b_along_mm",
                                      "a_second_along_mm",
                                      "b_second_along_mm"};

/* Whether the lamella of a part has another sheet, which the node has a place on too. */
static bool is_pair(const lam_model *model, int part) {
  for (int i = 0; i < model->part_count; i++)
    if (i != part && lam_csv_same_lamella(&model->parts[part], &model->parts[i])) return true;
  return false;
}

/* A node, numbered from 1; the flat angle is empty where it was not computed. Positions along
 * stand in the order of the sheets: those on the second sheets come last, or are empty. */
static void row(lam_text *out, const lam_model *model, int index) {
  const lam_crossing *node = &model->crossings[index];
  const double position[] = {node->position.x, node->position.y, node->position.z};
  const double normal[] = {node->normal.x, node->normal.y, node->normal.z};

  lam_csv_integer(out, index + 1);
  for (int i = 0; i < 3; i++) lam_csv_number(out, position[i] * 1e3, 3);
  for (int i = 0; i < 3; i++) lam_csv_number(out, normal[i], 7);
  lam_csv_number(out, node->angle / LAM_DEGREE, 6);
  lam_csv_number(out, node->flat_angle / LAM_DEGREE, 6);

  for (int f = 0; f < 2; f++) {
    lam_csv_sheets(out, model, node->parts[f]);
    lam_csv_number(out, node->along[f] * 1e3, 3);
  }
  for (int f = 0; f < 2; f++)
    lam_csv_number(out, is_pair(model, node->parts[f]) ? node->second[f] * 1e3 : NAN, 3);
  lam_csv_end_row(out);
}

static int count_files(const lam_model *model) { return model->crossing_count > 0; }
static void path_of(const lam_model *model, int i, lam_text *path) {
  (void)model, (void)i;
  lam_text_add(path, "nodes.csv");
}

/* In the order of the model, from 1 on. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_csv_header(out, columns, sizeof columns / sizeof *columns);
  for (int n = 0; n < model->crossing_count; n++) row(out, model, n);
  return LAM_OK;
}

const lam_format lam_format_nodes = {
    .name = "nodes",
    .doc = "Nodes as CSV: position, normal, crossing angle as built and in the flat grid, the "
           "parts that cross and where along each sheet, from its start.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
    .in_place = true,
};
