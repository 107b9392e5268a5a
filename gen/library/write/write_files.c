/* The formats one after the other: the plan of names, then bytes, files, templates beside them, the
 * picture. Called by models.c. */
#include "library/write/write_files.h"
#include "core/file.h"
#include "core/grow.h"
#include "formats/in_place.h"
#include "formats/list/formats.h"
#include "library/write/render.h"

#include <string.h>

/* ---- lists of formats ---- */

/* Whether name stands in the comma-separated list, which may be NULL. */
static bool listed(const char *only, const char *name) {
  size_t length = strlen(name);
  for (const char *at = only; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
    if (strncmp(at, name, length) == 0 && (at[length] == 0 || at[length] == ',')) return true;
  return false;
}

/* Says that there is no such format, and which one may have been meant. */
static void complain_format(const char *option, const char *name, lam_errors *errors) {
  const char **names = LAM_NEW(errors->arena, const char *, lam_format_count + 1);
  for (int i = 0; i < lam_format_count; i++) names[i] = lam_formats[i]->name;

  const char *near = lam_did_you_mean(name, names);
  lam_error_add(errors, (lam_location){0}, option,
                "%s; expected formats of `lamella list formats`%s%s%s", name,
                near ? " (did you mean " : "", near ? near : "", near ? "?)" : "");
}

/* Every name is looked at, so that all mistakes are told at once. */
bool lam_output_check(const char *option, const char *list, lam_errors *errors) {
  int before = errors->count;
  for (const char *at = list; at;) {
    const char *comma = strchr(at, ',');
    size_t length = comma ? (size_t)(comma - at) : strlen(at);
    const char *name = lam_arena_printf(errors->arena, "%.*s", (int)length, at);
    if (!lam_format_named(name)) complain_format(option, name, errors);
    at = comma ? comma + 1 : NULL;
  }
  return errors->count == before;
}

/* ---- the plan ---- */

/* Adds a file; a template that several formats need is there once. */
static void plan_file(lam_arena *arena, lam_output *output, lam_output_file file) {
  for (int i = 0; file.template_path && i < output->count; i++)
    if (strcmp(output->files[i].name, file.name) == 0) return;
  LAM_APPEND(arena, output->files, output->count, output->capacity, file);
}

/* Whether the lists allow a format, or a format that is made from it. */
static bool is_wanted(const lam_output *output, const lam_format *format) {
  if ((!output->only || listed(output->only, format->name)) && !listed(output->skip, format->name))
    return true;
  for (int i = 0; i < lam_format_count; i++) {
    const char *needs = lam_formats[i]->needs;
    if (needs && strcmp(needs, format->name) == 0 && is_wanted(output, lam_formats[i])) return true;
  }
  return false;
}

/* All files of a format, then the templates that have to stand beside them, by their own names. */
static void plan_format(lam_arena *arena, const lam_model *model, const lam_format *format,
                        lam_output *output) {
  int files = format->count(model);
  for (int i = 0; i < files; i++) {
    lam_text name = {.arena = arena};
    format->path(model, i, &name);
    plan_file(arena, output, (lam_output_file){.name = name.data, .format = format, .index = i});
  }

  if (files == 0 || !format->support) return;
  for (const char *const *names = format->support(arena, model); names && *names; names++) {
    const char *slash = strrchr(*names, '/');
    const char *path = lam_arena_printf(arena, "%s/%s", output->templates, *names);
    plan_file(arena, output,
              (lam_output_file){slash ? slash + 1 : *names, format, 0, path, false, 0});
  }
}

/* In the order of the list of formats, in which the scene stands before its picture. */
void lam_output_plan(lam_arena *arena, const lam_model *model, lam_output *output) {
  for (int i = 0; i < lam_format_count; i++)
    if (lam_formats[i]->count && is_wanted(output, lam_formats[i]))
      plan_format(arena, model, lam_formats[i], output);
}

/* ---- files ---- */

/* What all steps of writing need. */
typedef struct writing {
  lam_arena *arena;
  const lam_model *model, *in_place; /* about its origin, and where it stands */
  lam_output *output;
  const lam_folder *folder;
  const lam_manifest *old;
  lam_errors *notes, *errors;
} writing;

/* The first name of the kind NAME~, NAME~2, ... that is free, without its folders. */
static const char *free_name(const writing *w, const char *name) {
  const char *kept = lam_arena_printf(w->arena, "%s~", name);
  for (int i = 2; lam_folder_has(w->folder, kept); i++)
    kept = lam_arena_printf(w->arena, "%s~%d", name, i);
  const char *slash = strrchr(kept, '/');
  return slash ? slash + 1 : kept;
}

/* What somebody has changed since the last build is not lost: it gets another name, unless the new
 * bytes are the same. */
static void keep_changes(const writing *w, const lam_output_file *file) {
  if (!lam_manifest_changed(w->arena, w->folder, w->old, file->name)) return;

  size_t count;
  const char *bytes = lam_folder_read(w->arena, w->folder, file->name, &count);
  if (bytes && lam_manifest_hash(bytes, count) == file->hash) return;

  const char *kept = free_name(w, file->name);
  if (lam_folder_rename(w->folder, file->name, kept) == 0)
    lam_error_add(w->notes, (lam_location){0}, NULL,
                  "%s/%s was changed since the last build; the changed one is kept as %s",
                  w->folder->path, file->name, kept);
}

/* Writes one file of the plan. A name that two files have is written twice, and was not changed by
 * anybody in between. */
static lam_status write_bytes(const writing *w, lam_output_file *file, const void *bytes,
                              size_t count) {
  bool again = false;
  for (int i = 0; i < w->output->count && !again; i++)
    again = w->output->files[i].written && strcmp(w->output->files[i].name, file->name) == 0;

  file->hash = lam_manifest_hash(bytes, count);
  if (!again) keep_changes(w, file);
  lam_status status = lam_folder_write(w->folder, file->name, bytes, count, w->errors);
  file->written = status == LAM_OK;
  return status;
}

/* A copy of a template. */
static lam_status copy_template(const writing *w, lam_output_file *file) {
  char *bytes;
  size_t count;
  lam_status status =
      lam_file_read(w->arena, file->template_path, (size_t)1 << 24, w->errors, &bytes, &count);
  return status == LAM_OK ? write_bytes(w, file, bytes, count) : status;
}

/* What the format makes. */
static lam_status write_content(const writing *w, lam_output_file *file) {
  lam_text content = {.arena = w->arena};
  lam_status status = file->format->write(file->format->in_place ? w->in_place : w->model,
                                          file->index, &content);
  if (status != LAM_OK) {
    lam_error_add(w->errors, (lam_location){.file = file->name}, NULL,
                  "the library behind %s failed", file->format->name);
    return status;
  }
  return write_bytes(w, file, content.data ? content.data : "", content.length);
}

/* Renders the scene that was written before. A failure is a note: the files are good without the
 * picture. */
static lam_status render(const writing *w, lam_output_file *file) {
  lam_text scene = {.arena = w->arena};
  lam_text_printf(&scene, "%s.pov", w->model->name);
  lam_progress_tell(w->output->progress, "render", -1, w->model->picture.quality);
  keep_changes(w, file);

  const lam_output *output = w->output;
  lam_status status = lam_render_scene(w->folder, scene.data, file->name, &w->model->picture,
                                       output->templates, output->progress, w->notes);
  if (status != LAM_OK) {
    w->output->left_out++;
    return LAM_OK;
  }

  size_t count;
  lam_arena_mark mark = lam_arena_mark_get(w->arena);
  const char *bytes = lam_folder_read(w->arena, w->folder, file->name, &count);
  file->written = bytes != NULL;
  if (bytes) file->hash = lam_manifest_hash(bytes, count);
  lam_arena_release(w->arena, mark);
  return LAM_OK;
}

/* Where a format stands in the list, as a share of it. */
static double place_of(const lam_format *format) {
  int i = 0;
  while (i < lam_format_count - 1 && lam_formats[i] != format) i++;
  return (double)i / lam_format_count;
}

lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            const lam_folder *folder, const lam_manifest *old, bool last,
                            lam_errors *notes, lam_errors *errors) {
  const lam_model *in_place = lam_model_in_place(arena, model);
  const writing w = {arena, model, in_place, output, folder, old, notes, errors};
  const lam_format *told = NULL;
  lam_status status = LAM_OK;
  for (int i = 0; status == LAM_OK && i < output->count; i++) {
    lam_output_file *file = &output->files[i];
    if (file->format->last != last) continue;
    if (file->format != told)
      lam_progress_tell(output->progress, file->format->name, place_of(file->format), "");
    told = file->format;

    if (file->template_path)
      status = copy_template(&w, file);
    else
      status = file->format->write ? write_content(&w, file) : render(&w, file);
  }
  return status;
}
