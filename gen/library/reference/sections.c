/* The sections of the reference, and what each of them lists: rows of the registries, or what
 * stands elsewhere. Called by reference.c. */
#include "library/reference/sections.h"
#include "con/constraint.h"
#include "core/file.h"
#include "design/design.h"
#include "design/tree.h"
#include "fab/material.h"
#include "fab/workshop.h"
#include "formats/list/formats.h"
#include "library/templates.h"
#include "net/net_kind.h"
#include "surf/placement.h"
#include "surf/surface.h"

/* ---- rows ---- */

/* The rows of the section's registry, with those that were added to the session. */
static lam_listed *collect_rows(lam_session *session, const lam_section *section, int *count) {
  lam_arena *arena = session->arena;
  lam_added_rows added = lam_session_rows(session);
  const lam_registry *registry = lam_registry_with(arena, section->registry, &added);

  lam_listed *listed = LAM_NEW(arena, lam_listed, registry->count);
  for (int i = 0; i < registry->count; i++) {
    const lam_row_head *head = registry->rows[i];
    listed[i] = (lam_listed){.name = head->name,
                             .title = head->title,
                             .doc = head->doc,
                             .equation = head->equation,
                             .source = head->source,
                             .keys = head->keys};
  }
  *count = registry->count;
  return listed;
}

/* ---- nets ---- */

/* "fairness of positions", or "fairness of displacements, closeness 0.3". */
static void add_guide(lam_text *text, const lam_guide *guide) {
  lam_text_printf(text, "fairness of %s", lam_fairness_choices[guide->fair]);
  if (guide->closeness > 0) lam_text_printf(text, ", closeness %g", guide->closeness);
  if (guide->stiffness > 0) lam_text_printf(text, ", stiffness %g", guide->stiffness);
}

/* Where the net starts, how it is solved, what it is measured by: a line each. */
static const char *facts_of(lam_arena *arena, const lam_net_kind *kind) {
  lam_text text = {.arena = arena};
  if (kind->start)
    lam_text_add(&text, "makes its own start, without a surface\n");
  else
    lam_text_printf(&text, "starts from the %s lines of a surface, or from a mesh\n",
                    lam_chart_names[kind->chart]);

  if (kind->levels > 0)
    lam_text_printf(&text, "coarse to fine: %d coarser nets are solved first\n", kind->levels);
  if (kind->schedule.fairness > 0) {
    add_guide(&text, &kind->guide);
    lam_text_printf(&text, "; weight %g, faded out after %d iterations\n", kind->schedule.fairness,
                    lam_schedule_fade(&kind->schedule));
    if (kind->file_closeness > kind->guide.closeness)
      lam_text_printf(&text, "closeness %g where it starts from a mesh\n", kind->file_closeness);
  } else {
    lam_text_add(&text, "no fairness: the start is near the solution\n");
  }

  lam_text_add(&text, "measured by ");
  for (int k = 0; kind->measures[k]; k++)
    lam_text_printf(&text, "%s%s", k ? ", " : "", kind->measures[k]);
  if (kind->constrain_thesis)
    lam_text_add(&text, "\nalso in the thesis' own formulation: solver: thesis");
  return text.data;
}

/* Rows, with what kinds of nets have beyond the head of a row. */
static lam_listed *collect_nets(lam_session *session, const lam_section *section, int *count) {
  lam_listed *listed = collect_rows(session, section, count);
  for (int i = 0; i < *count; i++) {
    const lam_net_kind *kind = (const lam_net_kind *)section->registry->rows[i];
    listed[i].use = kind->use;
    listed[i].trouble = kind->trouble;
    listed[i].facts = facts_of(session->arena, kind);
  }
  return listed;
}

/* ---- tables without keys ---- */

/* Of a measure: what it has values on, and their unit. */
static lam_listed *collect_measures(lam_session *session, const lam_section *section, int *count) {
  lam_arena *arena = session->arena;
  (void)section;
  static const char *const elements[] = {[LAM_ON_VERTICES] = "A value per vertex",
                                         [LAM_ON_EDGES] = "A value per edge",
                                         [LAM_ON_FACES] = "A value per face",
                                         [LAM_ON_NET] = "One value for the net"};

  lam_listed *listed = LAM_NEW(arena, lam_listed, lam_measure_count);
  for (int i = 0; i < lam_measure_count; i++) {
    const lam_measure_kind *kind = lam_measures[i];
    const char *facts = lam_arena_printf(arena, "%s%s%s.", elements[kind->on],
                                         *kind->unit ? ", in " : "", kind->unit);
    listed[i] = (lam_listed){.name = kind->name, .title = kind->doc, .doc = facts};
  }
  *count = lam_measure_count;
  return listed;
}

/* Of a material: density and elastic limit. */
static lam_listed *collect_materials(lam_session *session, const lam_section *section, int *count) {
  lam_arena *arena = session->arena;
  (void)section;
  lam_listed *listed = LAM_NEW(arena, lam_listed, lam_material_count);
  for (int i = 0; i < lam_material_count; i++) {
    const lam_material *material = &lam_materials[i];
    const char *facts =
        lam_arena_printf(arena, "Density %g kg/m^3, elastic up to a strain of %g %%.",
                         material->density, 100 * material->max_strain);
    listed[i] = (lam_listed){.name = material->name, .title = material->doc, .doc = facts};
  }
  *count = lam_material_count;
  return listed;
}

/* Of a format: whether it is written, read, or both. */
static lam_listed *collect_formats(lam_session *session, const lam_section *section, int *count) {
  lam_arena *arena = session->arena;
  (void)section;
  lam_listed *listed = LAM_NEW(arena, lam_listed, lam_format_count);
  for (int i = 0; i < lam_format_count; i++) {
    const lam_format *format = lam_formats[i];
    bool reads = format->ending != NULL;
    const char *ways =
        format->path ? reads ? "It is written and read." : "It is written." : "It is read.";
    listed[i] = (lam_listed){.name = format->name, .title = format->doc, .doc = ways};
  }
  *count = lam_format_count;
  return listed;
}

/* ---- shipped designs ---- */

/* A shipped design's title and source; a design that is not valid is listed without them. folder:
 * of the templates. */
static lam_listed describe_design(lam_arena *arena, const char *folder, const char *name) {
  lam_errors errors = {.arena = arena};
  lam_design design = {0};
  char *bytes = NULL;
  const char *path = lam_template_design_path(arena, folder, name);
  lam_design_text text = {.path = path};
  lam_listed listed = {.name = name, .title = "not valid: see lamella check", .file = path};
  if (lam_file_read(arena, path, (size_t)LAM_DESIGN_MAX_BYTES, &errors, &bytes, &text.count) !=
      LAM_OK)
    return listed;

  text.bytes = bytes;
  if (!lam_design_parse(arena, &text, &errors, &design)) return listed;
  listed.title = design.title;
  listed.source = design.source[0] ? design.source : NULL;
  return listed;
}

/* Of a design: what its file says. Every file is read anew: designs may be put into the folder. */
static lam_listed *collect_designs(lam_session *session, const lam_section *section, int *count) {
  (void)section;
  const char *folder = lam_session_templates(session);
  const char *const *names = lam_template_designs(session->arena, folder);
  *count = 0;
  while (names[*count]) (*count)++;

  lam_listed *listed = LAM_NEW(session->arena, lam_listed, *count);
  for (int i = 0; i < *count; i++) listed[i] = describe_design(session->arena, folder, names[i]);
  return listed;
}

/* ---- the list ---- */

const lam_section lam_sections[] = {
    {.name = "surfaces",
     .noun = "surface",
     .doc = "The smooth surface that a net starts from.",
     .usage = "surface: {kind: %s",
     .common = lam_placement_key_table,
     .registry = &lam_surfaces,
     .collect = collect_rows},
    {.name = "nets",
     .noun = "net",
     .doc = "The discrete net on the surface.",
     .usage = "net: {kind: %s",
     .common = lam_net_common_keys,
     .registry = &lam_nets,
     .collect = collect_nets},
    {.name = "constraints",
     .noun = "constraint",
     .doc = "Further constraints of a net, beside its own.",
     .usage = "net: {..., constraints: [{kind: %s",
     .registry = &lam_constraints,
     .collect = collect_rows},
    {.name = "measures",
     .noun = "measure",
     .doc = "What is measured on a net: lamella measure; net: {measures: [NAME]}; plots: [NAME].",
     .collect = collect_measures},
    {.name = "parts",
     .noun = "part",
     .doc = "What is made from the net.",
     .usage = "parts: [{kind: %s",
     .registry = &lam_part_kinds,
     .collect = collect_rows},
    {.name = "materials",
     .noun = "material",
     .doc = "What parts are made of.",
     .collect = collect_materials},
    {.name = "formats",
     .noun = "format",
     .doc = "The files that are written and read; --only takes these names.",
     .collect = collect_formats},
    {.name = "designs",
     .noun = "design",
     .doc = "Shipped designs to start from: lamella new NAME.",
     .collect = collect_designs},
    {.name = NULL},
};

/* For guesses at the name of a section. */
const char *const *lam_section_names(lam_arena *arena) {
  int count = 0;
  while (lam_sections[count].name) count++;
  const char **names = LAM_NEW(arena, const char *, count + 1);
  for (int i = 0; i < count; i++) names[i] = lam_sections[i].name;
  return names;
}
