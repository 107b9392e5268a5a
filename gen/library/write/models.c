/* Models of a session: into a folder, or as bytes. Called through lamella/format.h. */
#include "core/file.h"
#include "formats/in_place.h"
#include "formats/list/formats.h"
#include "library/session_state.h"
#include "library/write/inputs_kept.h"
#include "library/write/make_rule.h"
#include <lamella/format.h>

#include <string.h>

static const lam_location nowhere;

/* ---- into a folder ---- */

/* All are looked at, so that all mistakes are told at once. False with messages. */
static bool check_options(lam_session *session, const lam_write_options *options) {
  if (options->folder && !*options->folder)
    lam_error_add(&session->errors, nowhere, "-o", "given an empty name; expected a folder");
  if (options->deps && !*options->deps)
    lam_error_add(&session->errors, nowhere, "--deps", "given an empty name; expected a file");
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

/* ---- the steps of a build's writing ---- */

/* What all steps need. */
typedef struct writing {
  lam_session *session;
  const lam_write_options *options;
  const lam_model *model;   /* as it is shown: without seconds, unless they are asked for */
  const lam_origin *origin; /* NULL: this session did not build it */
  lam_output output;
  lam_folder *folder;
  lam_manifest old, list; /* that was there, perhaps another design's; that is written */
  bool same_design;       /* the old list is this design's */
  int removed;
} writing;

/* The folder without slashes at its end, but for the top one. */
static const char *trimmed(lam_arena *arena, const char *folder) {
  size_t length = strlen(folder);
  while (length > 1 && folder[length - 1] == '/') length--;
  return lam_arena_printf(arena, "%.*s", length == 1 && *folder == '/' ? 0 : (int)length, folder);
}

/* Whether all of it may be written, and where; false with messages, and nothing has been
 * written. */
static bool prepare(writing *w, const lam_model *model) {
  lam_session *session = w->session;
  lam_arena *arena = session->arena;
  if (!check_options(session, w->options)) return false;

  w->output.templates = lam_session_needs_templates(session);
  if (!w->output.templates) return false;

  const char *folder = trimmed(arena, w->options->folder);
  w->model = w->options->timings || !model->report ? model : without_times(arena, model);
  w->origin = origin_of(session, model);
  lam_output_plan(arena, w->model, &w->output);
  lam_inputs_check(session, w->origin, &w->output, folder, w->options->deps);
  if (w->options->deps && !session->errors.count)
    lam_make_rule_check(session, w->options->deps, folder, w->origin, &w->output);
  if (session->errors.count) return false;

  enum { wait = 600 }; /* seconds; a picture may take as long */
  w->folder = lam_folder_open(arena, folder, wait, &session->progress, &session->errors);
  return w->folder != NULL;
}

/* An empty list of this design with room for the plan and for what was listed before. */
static lam_manifest new_list(const writing *w) {
  int room = w->output.count + w->old.count;
  return (lam_manifest){.design = w->model->name,
                        .files = LAM_NEW(w->session->arena, lam_listed_file, room)};
}

/* Appends those of the old files that are not listed yet and that `stays` wants. The list is sorted
 * before: it is searched as it was. */
static void append_old(writing *w, lam_manifest *list,
                       bool (*stays)(writing *w, const lam_listed_file *file)) {
  const lam_manifest before = *list;
  for (int i = 0; w->same_design && i < w->old.count; i++)
    if (!lam_manifest_find(&before, w->old.files[i].name) && stays(w, &w->old.files[i]))
      list->files[list->count++] = w->old.files[i];
}

static bool always(writing *w, const lam_listed_file *file) { return w && file; }

/* Before the first file is written, the list names all that may come, so that a build that is
 * killed leaves nothing unlisted; and the report of the last build goes: it tells of a folder that
 * is not there any more. */
static lam_status begin(writing *w) {
  lam_arena *arena = w->session->arena;
  w->old = lam_manifest_read(arena, w->folder);
  w->same_design = w->old.design && strcmp(w->old.design, w->model->name) == 0;

  lam_manifest list = new_list(w);
  for (int i = 0; i < w->output.count; i++)
    list.files[list.count++] = (lam_listed_file){.name = w->output.files[i].name};
  lam_manifest_sort(&list);
  append_old(w, &list, always);
  lam_status status = lam_manifest_write(w->folder, &list, &w->session->errors);

  for (int i = 0; i < w->output.count && status == LAM_OK; i++)
    if (w->output.files[i].format->last &&
        !lam_manifest_changed(arena, w->folder, &w->old, w->output.files[i].name))
      lam_folder_remove(w->folder, w->output.files[i].name);
  return status;
}

/* What becomes of a file that the last build made and this one does not: it goes, unless it was
 * changed since, or something is made from it now. True: it stays, and stays listed. */
static bool retire(writing *w, const lam_listed_file *file) {
  lam_session *session = w->session;
  const char *path = lam_arena_printf(session->arena, "%s/%s", w->folder->path, file->name);
  if (w->options->only || w->options->skip) return true;
  if (lam_inputs_have(w->origin, &w->output, path)) return false;

  if (lam_manifest_changed(session->arena, w->folder, &w->old, file->name)) {
    lam_error_add(&session->notes, nowhere, NULL,
                  "%s is not made any more, and stays: it was changed since the last build", path);
    return false;
  }
  w->removed += lam_folder_remove(w->folder, file->name);
  return false;
}

/* Takes away what is gone, and lists what is there and the report, which is still to come. */
static lam_status write_list(writing *w) {
  w->list = new_list(w);
  for (int i = 0; i < w->output.count; i++) {
    const lam_output_file *file = &w->output.files[i];
    if (file->written || file->format->last)
      w->list.files[w->list.count++] = (lam_listed_file){file->name, file->written, file->hash};
  }
  lam_manifest_sort(&w->list);
  append_old(w, &w->list, retire);
  return lam_manifest_write(w->folder, &w->list, &w->session->errors);
}

/* The report is written: its hash is known now. */
static lam_status list_report(writing *w) {
  bool found = false;
  for (int i = 0; i < w->output.count; i++) {
    const lam_output_file *file = &w->output.files[i];
    for (int k = 0; file->format->last && k < w->list.count; k++)
      if (strcmp(w->list.files[k].name, file->name) == 0) {
        w->list.files[k] = (lam_listed_file){file->name, file->written, file->hash};
        found = true;
      }
  }
  return found ? lam_manifest_write(w->folder, &w->list, &w->session->errors) : LAM_OK;
}

/* Everything but the report, then the list and the make rule, then the report: when that is there,
 * so is all else, and make may rely on it. */
static lam_status write_all(writing *w) {
  lam_session *session = w->session;
  lam_output *output = &w->output;
  lam_status status = lam_output_write(session->arena, w->model, output, w->folder, &w->old, false,
                                       &session->notes, &session->errors);
  if (status == LAM_OK) status = write_list(w);
  if (status == LAM_OK && w->options->deps)
    status = lam_make_rule_write(session, w->options->deps, w->folder->path, w->origin, output);
  if (status == LAM_OK)
    status = lam_output_write(session->arena, w->model, output, w->folder, &w->old, true,
                              &session->notes, &session->errors);
  return status == LAM_OK ? list_report(w) : status;
}

/* The paths of what was written, in the order of the formats. */
static lam_written tell_written(const writing *w) {
  lam_arena *arena = w->session->arena;
  const char **paths = LAM_NEW(arena, const char *, w->output.count + 1);
  int count = 0;
  for (int i = 0; i < w->output.count; i++)
    if (w->output.files[i].written)
      paths[count++] = lam_arena_printf(arena, "%s/%s", w->folder->path, w->output.files[i].name);
  return (lam_written){count, paths, w->removed, w->output.left_out};
}

static lam_status write_model(lam_session *session, const lam_model *model,
                              const lam_write_options *options, lam_written *written) {
  writing w = {
      .session = session,
      .options = options,
      .output = {.only = options->only, .skip = options->skip, .progress = &session->progress}};
  if (!prepare(&w, model)) return LAM_OK; /* the messages tell */

  lam_status status = begin(&w);
  if (status == LAM_OK) status = write_all(&w);
  lam_folder_close(w.folder);
  if (status != LAM_OK) return status;

  lam_progress_tell(&session->progress, NULL, 1, "");
  if (written) *written = tell_written(&w);
  return LAM_OK;
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
