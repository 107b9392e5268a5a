/* The formats one after the other: names, bytes, files, templates beside them, the picture. Called
 * by models.c. */
#include "library/write/write_files.h"
#include "core/file.h"
#include "core/grow.h"
#include "formats/in_place.h"
#include "formats/list/formats.h"
#include "library/write/render.h"

#include <string.h>

/* ---- lists ---- */

/* Adds a path that is not there yet; it is kept by pointer. */
static void remember(lam_arena *arena, lam_paths *paths, const char *path) {
  for (int i = 0; i < paths->count; i++)
    if (strcmp(paths->items[i], path) == 0) return;
  LAM_APPEND(arena, paths->items, paths->count, paths->capacity, path);
}

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

/* ---- files ---- */

/* Writes one file, whose name may have folders in it, and remembers it. */
static lam_status write_file(lam_arena *arena, lam_output *output, const char *name,
                             const lam_text *text, lam_errors *errors) {
  const char *path = lam_arena_printf(arena, "%s/%s", output->folder, name);
  const char *slash = strrchr(path, '/');

  lam_status status =
      lam_path_make_dirs(lam_arena_printf(arena, "%.*s", (int)(slash - path), path), errors);
  if (status == LAM_OK)
    status = lam_file_write_atomic(path, text->data ? text->data : "", text->length, errors);
  if (status == LAM_OK) remember(arena, &output->files, path);
  return status;
}

/* Copies the templates that have to stand beside the output; names are relative to their folder,
 * and NULL-terminated; names may be NULL. */
static lam_status copy_support(lam_arena *arena, lam_output *output, const char *const *names,
                               lam_errors *errors) {
  for (; names && *names; names++) {
    const char *from = lam_arena_printf(arena, "%s/%s", output->templates, *names);
    const char *base = strrchr(*names, '/') ? strrchr(*names, '/') + 1 : *names;

    lam_text text = {.arena = arena};
    char *bytes;
    size_t count;
    lam_status status = lam_file_read(arena, from, (size_t)1 << 24, errors, &bytes, &count);
    if (status != LAM_OK) return status;

    lam_text_bytes(&text, bytes, count);
    status = write_file(arena, output, base, &text, errors);
    if (status != LAM_OK) return status;
    remember(arena, &output->used_templates, from);
  }
  return LAM_OK;
}

/* Writes all files of a format, then its templates. Ends at the first failure. */
static lam_status write_format(lam_arena *arena, const lam_model *model, const lam_format *format,
                               lam_output *output, lam_errors *errors) {
  int files = format->count(model);
  if (format->in_place) model = lam_model_in_place(arena, model);
  for (int i = 0; i < files; i++) {
    lam_text name = {.arena = arena}, content = {.arena = arena};
    format->path(model, i, &name);

    lam_status status = format->write(model, i, &content);
    if (status != LAM_OK) {
      lam_error_add(errors, (lam_location){.file = name.data}, NULL, "the library behind %s failed",
                    format->name);
      return status;
    }

    status = write_file(arena, output, name.data, &content, errors);
    if (status != LAM_OK) return status;
  }

  if (files == 0 || !format->support) return LAM_OK;
  return copy_support(arena, output, format->support(arena, model), errors);
}

/* Renders the scene that was written before. A failure is a note: the files are good without the
 * picture. */
static lam_status render(lam_arena *arena, const lam_model *model, lam_output *output,
                         lam_errors *notes) {
  lam_text scene = {.arena = arena}, picture = {.arena = arena};
  lam_text_printf(&scene, "%s.pov", model->name);
  lam_text_printf(&picture, "%s/%s.png", output->folder, model->name);

  lam_progress_tell(output->progress, "render", -1, model->picture.quality);
  lam_status status =
      lam_render_scene(output->folder, scene.data, &model->picture, output->templates, notes);
  if (status == LAM_OK) remember(arena, &output->files, picture.data);
  return status;
}

/* In the order of the list of formats, in which the scene stands before its picture. */
lam_status lam_output_write(lam_arena *arena, const lam_model *model, lam_output *output,
                            lam_errors *notes, lam_errors *errors) {
  lam_status status = lam_path_make_dirs(output->folder, errors);
  for (int i = 0; status == LAM_OK && i < lam_format_count; i++) {
    const lam_format *format = lam_formats[i];
    bool wanted = (!output->only || listed(output->only, format->name)) &&
                  !listed(output->skip, format->name);
    if (!wanted || !format->count || format->count(model) == 0) continue;

    lam_progress_tell(output->progress, format->name, (double)i / lam_format_count, "");
    if (format->write)
      status = write_format(arena, model, format, output, errors);
    else if (render(arena, model, output, notes) == LAM_NO_MEMORY)
      status = LAM_NO_MEMORY;
  }
  return status;
}
