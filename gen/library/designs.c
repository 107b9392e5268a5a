/* Designs of a session: reading, checking, describing, building, copying shipped ones. Called
 * through lamella/design.h. */
#include "core/file.h"
#include "design/pipeline.h"
#include "design/tree.h"
#include "library/names.h"
#include "library/new_files.h"
#include "library/sources.h"
#include "library/templates.h"
#include "net/net_kind.h"

#include <string.h>

/* ---- reading ---- */

/* What only shows when surface and start are made from what the design names. */
static void check_start(lam_session *session, const lam_design *design) {
  lam_origin *origin = LAM_NEW(session->arena, lam_origin, 1);
  lam_inputs inputs;
  if (lam_sources_read(session, design, origin, &inputs))
    lam_pipeline_check(session->arena, design, &inputs, &session->errors);
}

/* Parses a design and checks what it names; make: makes surface and start too. *out is set when
 * there was nothing to complain about. */
static lam_status read_design(lam_session *session, const lam_design_source *source, bool make,
                              const lam_design **out) {
  lam_design *design = LAM_NEW(session->arena, lam_design, 1);
  if (lam_source_parse(session, source, design)) {
    /* Where the net starts from another design's, that one would have to be solved first. */
    const lam_net_common *net = design->net.head ? design->net.common : NULL;
    bool start = make && !(net && net->from.design);
    lam_sources_check(session, design, make && !start);
    if (start && !session->errors.count) check_start(session, design);
  }
  if (!session->errors.count) *out = design;
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/design.h. */
lam_status lam_design_read(lam_session *session, const lam_design_source *source,
                           const lam_design **design) {
  *design = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, read_design(session, source, false, design));
}

/* Longer than reading: the surface is made. */
lam_status lam_design_check(lam_session *session, const lam_design_source *source,
                            const lam_design **design) {
  *design = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, read_design(session, source, true, design));
}

const char *lam_design_name(const lam_design *design) { return design->name; }

/* ---- building ---- */

/* Reads what the design names, then runs the pipeline. What the model was made from is remembered
 * for make rules (write/make_rule.c). */
static lam_status build(lam_session *session, const lam_design *design, const lam_model **out) {
  lam_inputs inputs;
  lam_model *model = LAM_NEW(session->arena, lam_model, 1);
  lam_origin *origin = LAM_NEW(session->arena, lam_origin, 1);
  *origin = (lam_origin){.model = model, .path = design->path, .next = session->origins};

  if (!lam_sources_read(session, design, origin, &inputs) ||
      !lam_pipeline_run(session->arena, design, &inputs, &session->progress, &session->errors,
                        model))
    return LAM_OK; /* the messages say what is wrong */

  session->origins = origin;
  *out = model;
  return LAM_OK;
}

/* The model stays NULL unless all of it was built. */
lam_status lam_design_build(lam_session *session, const lam_design *design,
                            const lam_model **model) {
  *model = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, build(session, design, model));
}

/* ---- shipped designs ---- */

/* By its ending: the other files that designs name are meshes, points and the like. */
static bool is_design(const char *name) {
  const char *ending = strrchr(name, '.');
  return ending && strcmp(ending, ".yaml") == 0;
}

/* Reads file i of the copies; when it is a design, the files that it names are added to the copies.
 * False with messages. */
static bool read_copy(lam_session *session, lam_new_files *copies, int i) {
  lam_new_file *file = &copies->files[i];
  if (!lam_new_file_read(session->arena, file, &session->errors)) return false;
  if (!is_design(file->source)) return true;

  lam_design *design = LAM_NEW(session->arena, lam_design, 1);
  lam_design_source source = {.path = file->source, .text = file->bytes, .length = file->count};
  const char *names[LAM_SOURCES];
  if (!lam_source_parse(session, &source, design)) return false;
  int count = lam_sources_list(session->arena, design, names);
  for (int k = 0; k < count; k++) lam_new_files_add(session->arena, copies, names[k]);
  return true;
}

/* Copies grow while they are read: the design, then what it names, then what designs among those
 * name. */
static lam_status copy_design(lam_session *session, const char *name, const char *target,
                              const char *const **files) {
  lam_errors *errors = &session->errors;
  const char *templates = lam_session_needs_templates(session);
  if (!templates) return LAM_OK; /* the message decides */
  const char *const *names = lam_template_designs(session->arena, templates);
  if (!lam_name_known(errors, names, name, "no shipped design is called",
                      "lamella list designs shows them"))
    return LAM_OK;

  /* All are read before the first is written; what is there already must be the same. */
  lam_new_files copies = {.source = lam_arena_printf(session->arena, "%s/designs", templates)};
  lam_new_files_begin(session->arena, &copies, lam_arena_printf(session->arena, "%s.yaml", name),
                      target);
  for (int i = 0; i < copies.count; i++)
    if (!read_copy(session, &copies, i) ||
        !lam_new_file_allowed(session->arena, &copies.files[i], i > 0, errors))
      return LAM_OK;

  return lam_new_files_write(session->arena, &copies, errors, files);
}

/* A status without one of its own is that of the messages. */
lam_status lam_design_copy(lam_session *session, const char *name, const char *target,
                           const char *const **files) {
  *files = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, copy_design(session, name, target, files));
}
