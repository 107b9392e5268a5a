/* Models of a session: into a folder, or as bytes. Called through lamella/format.h. */
#include "core/file.h"
#include "formats/in_place.h"
#include "formats/list/formats.h"
#include "library/session_state.h"
#include "library/write/make_rule.h"
#include "library/write/manifest.h"
#include "library/write/write_files.h"
#include <lamella/format.h>

#include <string.h>

static const lam_location nowhere;

/* ---- into a folder ---- */

/* Both lists are looked at, so that all unknown names are told at once. False with messages. */
static bool check_options(lam_session *session, const lam_write_options *options) {
  lam_output_check("--only", options->only, &session->errors);
  lam_output_check("--skip", options->skip, &session->errors);
  return session->errors.count == 0;
}

/* The status is that of the messages. */
static lam_status check(lam_session *session, const lam_write_options *options) {
  check_options(session, options);
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/format.h. */
lam_status lam_write_options_check(lam_session *session, const lam_write_options *options) {
  LAM_ENTER(session);
  return lam_session_leave(session, check(session, options));
}

/* The model without the seconds of its stages, which are not the same every time. */
static const lam_model *without_times(lam_arena *arena, const lam_model *model) {
  lam_model *copy = LAM_NEW(arena, lam_model, 1);
  lam_report *report = LAM_NEW(arena, lam_report, 1);
  *report = (lam_report){model->report->stage_count,
                         LAM_NEW(arena, lam_stage, model->report->stage_count)};

  for (int i = 0; i < report->stage_count; i++) {
    report->stages[i] = model->report->stages[i];
    report->stages[i].seconds = 0;
  }

  *copy = *model;
  copy->report = report;
  return copy;
}

/* What the model was built from; NULL when this session did not build it. */
static const lam_origin *origin_of(const lam_session *session, const lam_model *model) {
  const lam_origin *origin = session->origins;
  while (origin && origin->model != model) origin = origin->next;
  return origin;
}

/* The list of files and the make rule are written last, when all files are there. */
static lam_status write_model(lam_session *session, const lam_model *model,
                              const lam_write_options *options, lam_written *written) {
  lam_output output = {.folder = options->folder,
                       .only = options->only,
                       .skip = options->skip,
                       .templates = lam_session_templates(session),
                       .progress = &session->progress};

  /* What is wrong with the request. */
  if (!check_options(session, options)) return LAM_OK;
  if (!output.templates) {
    lam_error_add(&session->errors, nowhere, NULL,
                  "the templates folder is not found; set LAMELLA_TEMPLATES");
    return LAM_IO;
  }

  /* The files of all formats. */
  const lam_model *shown =
      options->timings || !model->report ? model : without_times(session->arena, model);
  lam_status status =
      lam_output_write(session->arena, shown, &output, &session->notes, &session->errors);
  if (session->errors.count) return status;

  /* What goes with them. */
  int removed =
      lam_manifest_update(session->arena, output.folder, model->name, output.files.count,
                          output.files.items, options->only || options->skip, &session->errors);
  if (options->deps && !session->errors.count)
    lam_make_rule_write(session, options->deps, output.folder, origin_of(session, model),
                        &output.used_templates);

  lam_progress_tell(&session->progress, NULL, 1, "");
  if (written) *written = (lam_written){output.files.count, output.files.items, removed};
  return status;
}

/* Nothing was written unless the work says so. */
lam_status lam_model_write(lam_session *session, const lam_model *model,
                           const lam_write_options *options, lam_written *written) {
  if (written) *written = (lam_written){0};
  LAM_ENTER(session);
  return lam_session_leave(session, write_model(session, model, options, written));
}

/* ---- as bytes ---- */

/* Formats without a writer of their own are made by other programs. */
int lam_model_file_count(const lam_model *model, const char *format) {
  const lam_format *f = lam_format_named(format);
  return f && f->write && f->count ? f->count(model) : 0;
}

/* The same writer as for the folder. */
static lam_status encode(lam_session *session, const lam_model *model, const char *format, int i,
                         lam_bytes *file) {
  lam_text name = {.arena = session->arena}, content = {.arena = session->arena};
  if (i < 0 || i >= lam_model_file_count(model, format)) {
    lam_error_add(&session->errors, nowhere, NULL, "there is no file %d of format %s", i, format);
    return LAM_BAD_INPUT;
  }

  const lam_format *f = lam_format_named(format);
  const lam_model *shown = model->report ? without_times(session->arena, model) : model;
  if (f->in_place) shown = lam_model_in_place(session->arena, shown);
  f->path(shown, i, &name);
  lam_status status = f->write(shown, i, &content);
  if (status != LAM_OK)
    lam_error_add(&session->errors, nowhere, NULL, "the library behind %s failed", format);

  *file = (lam_bytes){name.data, content.length ? content.data : "", content.length};
  return status;
}

/* Empty content is an empty text. */
lam_status lam_model_encode(lam_session *session, const lam_model *model, const char *format, int i,
                            lam_bytes *file) {
  *file = (lam_bytes){0};
  LAM_ENTER(session);
  return lam_session_leave(session, encode(session, model, format, i, file));
}
