/* OpenSCAD (listed in formats/list/formats.c). Two files: NAME.scad is short and made for people:
 * the literals of the Customizer, and what the templates make of the data; NAME_data.scad has the
 * numbers. Parts with records are built by the template of their kind, the others are solids
 * placed by frames. Millimeters; faces clockwise seen from outside.
 *
 * A template X.scad gives X_solid(records, settings...) and X_outlines(records, names,
 * settings...): see templates/scad/lamella.scad. A new template needs nothing here. */
#include "core/origin.h"
#include "core/solid/triangles.h"
#include "formats/format.h"
#include "formats/identifier.h"

#include <string.h>

/* The template files that must stand beside the output: the library, and the template of every
 * kind of part that has records. */
static const char *const *scad_support(lam_arena *arena, const lam_model *model) {
  const char **files = LAM_NEW(arena, const char *, model->record_kind_count + 2);
  files[0] = "scad/parts.scad";
  for (int i = 0; i < model->record_kind_count; i++)
    files[i + 1] = lam_arena_printf(arena, "scad/%s", model->record_kinds[i].scad);
  return files;
}

static int scad_count(const lam_model *model) { return model->part_count ? 2 : 0; }

static void scad_path(const lam_model *model, int i, lam_text *path) {
  lam_text_printf(path, i ? "%s_data.scad" : "%s.scad", model->name);
}

/* ---- names ---- */

/* The part's record kind, or -1 when OpenSCAD gets the solid itself. */
static int record_kind(const lam_model *model, const lam_part *part) {
  for (int k = 0; part->record && k < model->record_kind_count; k++)
    if (!strcmp(model->record_kinds[k].kind, part->kind)) return k;
  return -1;
}

static const char *base_name(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash ? slash + 1 : path;
}

/* Begins a call of a template's function: "lamella_solid(". */
static void add_function(lam_text *out, const lam_record_kind *kind, const char *function) {
  const char *base = base_name(kind->scad);
  lam_text_bytes(out, base, strcspn(base, "."));
  lam_text_printf(out, "_%s(", function);
}

/* The variable of a setting: its name, or with the kind in front when an earlier kind has a
 * setting of that name. kind: its number among the record kinds. */
static void add_variable(lam_text *out, const lam_model *model, int kind,
                         const lam_setting *setting) {
  for (int k = 0; k < kind; k++)
    for (int i = 0; i < model->record_kinds[k].setting_count; i++)
      if (!strcmp(model->record_kinds[k].settings[i].name, setting->name)) {
        lam_identifier_add(out, model->record_kinds[kind].kind);
        lam_text_add(out, "_");
        lam_text_add(out, setting->name);
        return;
      }
  lam_text_add(out, setting->name);
}

/* A comment of one line: line breaks in the text become blanks. unit is added at its end. */
static void add_comment(lam_text *out, const char *text, const char *unit) {
  lam_text_add(out, "// ");
  for (; *text; text++) lam_text_bytes(out, (unsigned char)*text < ' ' ? " " : text, 1);
  lam_text_add(out, unit);
  lam_text_add(out, "\n");
}

/* ---- the main file ---- */

/* How far families are raised when exploded: a quarter of the largest extent of a part, rounded
 * up to centimeters; in millimeters. */
static int raise_of(const lam_model *model) {
  double most = 0;
  for (int i = 0; i < model->part_count; i++) {
    lam_vec3 low, high;
    lam_points_bounds(model->parts[i].solid.vertices, model->parts[i].solid.vertex_count, &low,
                      &high);
    lam_vec3 size = lam_sub(high, low);
    most = fmax(most, fmax(size.x, fmax(size.y, size.z)));
  }
  return 10 * (1 + (int)(25 * most));
}

/* The first section of the Customizer: what is shown, and which part when it is only one. */
static void add_show(lam_text *out, const lam_model *model) {
  lam_text_add(out, "/* [Show] */\n// What to show\nshow = \"all parts\"; // [all parts, one part, "
                    "family A, family B, nodes, exploded, flat outlines, engraving, one outline, "
                    "one engraving]\n"
                    "// The one part that is shown when one is asked for\npart = ");
  lam_text_quoted(out, model->parts[0].name);
  lam_text_add(out, "; // [");
  for (int i = 0; i < model->part_count; i++) {
    lam_text_add(out, i ? ", " : "");
    lam_text_add(out, model->parts[i].name);
  }

  int raise = raise_of(model);
  lam_text_printf(out,
                  "]\n// How far families are raised above each other when exploded, mm\nraise = "
                  "%d; // [0:10:%d]\n",
                  raise, 4 * raise);
}

/* A section of the Customizer: the settings of all kinds that name it, with their sentence, unit
 * and range. Lengths become millimeters. */
static void add_section(lam_text *out, const lam_model *model, const char *section) {
  lam_text_printf(out, "\n/* [%s] */\n", section);
  for (int k = 0; k < model->record_kind_count; k++)
    for (int i = 0; i < model->record_kinds[k].setting_count; i++) {
      const lam_setting *setting = &model->record_kinds[k].settings[i];
      if (strcmp(setting->section, section)) continue;

      add_comment(out, setting->doc, setting->is_length ? ", mm" : "");
      add_variable(out, model, k, setting);
      lam_text_add(out, " = ");
      lam_text_number(out, setting->is_length ? 1000 * setting->value : setting->value, 6);
      lam_text_add(out, ";");
      if (setting->range) lam_text_printf(out, " // %s", setting->range);
      lam_text_add(out, "\n");
    }
}

/* Whether no earlier setting names the same section. */
static bool is_first_of_section(const lam_model *model, int kind, int setting) {
  const char *section = model->record_kinds[kind].settings[setting].section;
  for (int k = 0; k <= kind; k++)
    for (int i = 0; i < (k < kind ? model->record_kinds[k].setting_count : setting); i++)
      if (!strcmp(model->record_kinds[k].settings[i].section, section)) return false;
  return true;
}

/* The settings of all kinds by section, in the order in which sections are first named; then the
 * kerf, which is that of the first sheet. */
static void add_settings(lam_text *out, const lam_model *model) {
  for (int k = 0; k < model->record_kind_count; k++)
    for (int i = 0; i < model->record_kinds[k].setting_count; i++)
      if (is_first_of_section(model, k, i))
        add_section(out, model, model->record_kinds[k].settings[i].section);

  lam_text_add(out, "\n/* [Flat outlines] */\n// Width that the cutting tool takes away, mm: "
                    "outlines grow by half of it; 0 leaves it to the workshop\nkerf = ");
  lam_text_number(out, model->sheet_count ? 1000 * model->sheets[0].kerf : 0, 6);
  lam_text_add(out, "; // [0:0.01:1]\n");
}

/* Where the local origin lies, for models that are not about (0, 0, 0). */
static void add_place(lam_text *out, const lam_model *model) {
  const double origin[3] = {model->origin.x, model->origin.y, model->origin.z};
  if (!lam_is_moved(model->origin)) return;

  lam_text_add(out, "\n/* [Place] */\n// Where the parts stand, mm: they are drawn about this "
                    "origin\norigin = [");
  for (int k = 0; k < 3; k++) {
    lam_text_add(out, k ? ", " : "");
    lam_text_number(out, 1000 * origin[k], 4);
  }
  lam_text_add(out, "];\n// Draw them there instead: exports have too few digits for it\n"
                    "in_place = false;\n");
}

/* The settings of a kind as named arguments, which end a call that add_function began. */
static void add_arguments(lam_text *out, const lam_model *model, int kind) {
  for (int i = 0; i < model->record_kinds[kind].setting_count; i++) {
    const lam_setting *setting = &model->record_kinds[kind].settings[i];
    lam_text_printf(out, ", %s = ", setting->name);
    add_variable(out, model, kind, setting);
  }
  lam_text_add(out, ")");
}

/* The records of a kind that the Customizer lets be shown. */
static void add_chosen(lam_text *out, const lam_record_kind *kind) {
  lam_text_add(out, "chosen(");
  lam_identifier_add(out, kind->kind);
  lam_text_add(out, "_records, show, part)");
}

/* What is drawn: the solids of a family, the outlines of everything, and the choice between
 * them. */
static void add_view(lam_text *out, const lam_model *model) {
  lam_text_add(out, "\n// The chosen parts of a family: 0 is A, 1 is B, -1 what belongs to none.\n"
                    "function family_solids(family) = concat(\n");

  for (int k = 0; k < model->record_kind_count; k++) {
    lam_text_add(out, "  [");
    add_function(out, &model->record_kinds[k], "solid");
    lam_text_add(out, "of_family(");
    add_chosen(out, &model->record_kinds[k]);
    lam_text_add(out, ", family)");
    add_arguments(out, model, k);
    lam_text_add(out, "],\n");
  }
  lam_text_add(
      out, "  show == \"one part\" ? unplaced(of_family(chosen(solids, show, part), family)) :\n"
           "    placed(of_family(chosen(solids, show, part), family)));\n"
           "function outlines() = concat(");

  for (int k = 0; k < model->record_kind_count; k++) {
    lam_text_add(out, k ? ",\n  " : "");
    add_function(out, &model->record_kinds[k], "outlines");
    add_chosen(out, &model->record_kinds[k]);
    lam_text_add(out, ", part_names");
    add_arguments(out, model, k);
  }

  lam_text_printf(out, ");\n\nif (is_flat(show)) show_flat(show, outlines(), kerf);\nelse %s",
                  lam_is_moved(model->origin) ? "translate(in_place ? origin : [0, 0, 0]) " : "");
  lam_text_add(out, "show_solids([for (family = [0, 1, -1]) family_solids(family)], "
                    "show == \"exploded\" ? raise : 0);\n");
}

/* NAME.scad. What stands below [Hidden] is not shown in the Customizer. */
static void write_main(const lam_model *model, lam_text *out) {
  add_comment(out, model->title ? model->title : model->name, "");
  if (model->source) add_comment(out, model->source, "");
  lam_text_printf(out,
                  "// Written by lamella %s. Millimeters. Change the values here or in OpenSCAD's "
                  "Customizer.\n\n",
                  model->version);

  add_show(out, model);
  add_settings(out, model);
  add_place(out, model);

  lam_text_printf(out, "\n/* [Hidden] */\ninclude <%s_data.scad>\n", model->name);
  lam_text_add(out, "use <parts.scad>\n");
  for (int k = 0; k < model->record_kind_count; k++)
    lam_text_printf(out, "use <%s>\n", model->record_kinds[k].scad);
  add_view(out, model);
}

/* ---- the data file ---- */

/* A vector of count numbers, scaled. */
static void add_values(lam_text *out, const double *values, int count, double scale, int decimals) {
  lam_text_add(out, "[");
  for (int i = 0; i < count; i++) {
    lam_text_add(out, i ? "," : "");
    lam_text_number(out, scale * values[i], decimals);
  }
  lam_text_add(out, "]");
}

static void add_vector(lam_text *out, lam_vec3 v, double scale, int decimals) {
  add_values(out, (double[]){v.x, v.y, v.z}, 3, scale, decimals);
}

/* Begins an entry of a part: [name, family, [ ... */
static void add_head(lam_text *out, const lam_part *part) {
  lam_text_add(out, "[");
  lam_text_quoted(out, part->name);
  lam_text_printf(out, ", %d, [", part->family);
}

/* A part as its record: rows of columns, lengths in millimeters, each with the decimals of its
 * column. */
static void add_record(lam_text *out, const lam_part *part, const lam_record_kind *kind) {
  const lam_record *record = part->record;
  add_head(out, part);

  for (int r = 0; r < record->rows; r++) {
    lam_text_add(out, r ? ",\n[" : "\n[");
    for (int c = 0; c < record->columns; c++) {
      const lam_record_column *column = &kind->columns[c];
      lam_text_add(out, c ? "," : "");
      lam_text_number(out, (column->is_length ? 1000 : 1) * record->values[r * record->columns + c],
                      column->decimals);
    }
    lam_text_add(out, "]");
  }
  lam_text_add(out, "]],\n");
}

/* The frames of the instances of a part: [origin, x axis, y axis, z axis] each; the identity for a
 * solid that stands where it is. */
static void add_frames(lam_text *out, const lam_part *part) {
  const lam_pose here = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  int count = part->instance_count ? part->instance_count : 1;
  for (int i = 0; i < count; i++) {
    const lam_pose *pose = part->instance_count ? &part->instances[i] : &here;
    lam_text_add(out, i ? ",\n[" : "\n[");
    add_vector(out, pose->origin, 1000, 4);
    for (int a = 0; a < 3; a++) {
      lam_text_add(out, ",");
      add_vector(out, pose->axis[a], 1, 7);
    }
    lam_text_add(out, "]");
  }
}

/* A part as points, faces and frames. OpenSCAD wants faces clockwise: two corners change places. */
static void add_solid(lam_text *out, const lam_part *part) {
  const lam_trimesh *mesh = &part->solid;
  add_head(out, part);

  for (int i = 0; i < mesh->vertex_count; i++) {
    lam_text_add(out, i % 6 ? "," : i ? ",\n" : "\n");
    add_vector(out, mesh->vertices[i], 1000, 4);
  }

  lam_text_add(out, "], [");
  for (int i = 0; i < mesh->triangle_count; i++) {
    const int *t = mesh->triangles[i];
    lam_text_printf(out, "%s[%d,%d,%d]", i % 12 ? "," : i ? ",\n" : "\n", t[0], t[2], t[1]);
  }

  lam_text_add(out, "], [");
  add_frames(out, part);
  lam_text_add(out, "]],\n");
}

/* The records of one kind, as the variable KIND_records, below a comment that names the columns. */
static void add_records(lam_text *out, const lam_model *model, int k) {
  const lam_record_kind *kind = &model->record_kinds[k];
  lam_text_add(out, "\n// [name, family, rows]. A row is [");
  for (int c = 0; c < kind->column_count; c++)
    lam_text_printf(out, c ? ", %s" : "%s", kind->columns[c].name);
  lam_text_add(out, "].\n");

  lam_identifier_add(out, kind->kind);
  lam_text_add(out, "_records = [\n");
  for (int i = 0; i < model->part_count; i++)
    if (record_kind(model, &model->parts[i]) == k) add_record(out, &model->parts[i], kind);
  lam_text_add(out, "];\n");
}

/* NAME_data.scad: the names of all parts, the records of every kind, then the solids of the
 * others. */
static void write_data(const lam_model *model, lam_text *out) {
  lam_text_printf(
      out, "// The numbers of %s.scad. Written by lamella %s. Millimeters.\n\npart_names = [",
      model->name, model->version);
  for (int i = 0; i < model->part_count; i++) {
    lam_text_add(out, i % 12 ? ", " : i ? ",\n" : "\n");
    lam_text_quoted(out, model->parts[i].name);
  }
  lam_text_add(out, "];\n");

  for (int k = 0; k < model->record_kind_count; k++) add_records(out, model, k);

  lam_text_add(
      out,
      "\n// [name, family, points, faces, frames]. A frame is [origin, x axis, y axis, z axis].\n"
      "solids = [\n");
  for (int i = 0; i < model->part_count; i++)
    if (record_kind(model, &model->parts[i]) < 0) add_solid(out, &model->parts[i]);
  lam_text_add(out, "];\n");
}

static lam_status scad_write(const lam_model *model, int i, lam_text *out) {
  (i ? write_data : write_main)(model, out);
  return LAM_OK;
}

const lam_format lam_format_scad = {
    .name = "scad",
    .doc = "OpenSCAD: a parametric model with Customizer, and its data",
    .count = scad_count,
    .path = scad_path,
    .write = scad_write,
    .support = scad_support,
};
