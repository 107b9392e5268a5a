/* Pictures of scenes: POV-Ray started in the folder of the scene, its complaints turned into one
 * line. Called by write_files.c. */
#include "library/write/render.h"

#include "core/process.h"
#include <stdio.h>
#include <string.h>

static const lam_location nowhere;
static const double longest = 7200; /* seconds, for a picture: the largest take an hour */

/* What povray says, line by line as it comes. */
typedef struct listener {
  const lam_progress *progress; /* told how much of the picture is done */
  const char *quality;
  int length;     /* of the line so far */
  char line[200]; /* longer ones are cut */
  lam_text *said; /* all lines but those about progress */
} listener;

/* A line is complete: what it says of progress is told, any other one is kept. */
static void hear_line(listener *l) {
  l->line[l->length] = 0;
  double done, all;
  if (sscanf(l->line, "Rendered %lf of %lf pixels", &done, &all) == 2 && all > 0)
    lam_progress_tell(l->progress, "render", done / all, l->quality);
  else
    lam_text_printf(l->said, "%s\n", l->line);
  l->length = 0;
}

/* Lines about progress end with a carriage return: each is to be written over by the next. */
static void hear(void *context, const char *bytes, size_t count) {
  listener *l = context;
  for (size_t i = 0; i < count; i++) {
    if (bytes[i] == '\n' || bytes[i] == '\r')
      hear_line(l);
    else if (l->length < (int)sizeof l->line - 1)
      l->line[l->length++] = bytes[i];
  }
}

/* What povray says went wrong: from the first line with "Error" on, at most three lines joined to
 * one. said may be NULL. */
static const char *find_reason(lam_arena *arena, const char *said) {
  const char *at = said ? strstr(said, "Error") : NULL;
  if (!at) return "it gave no reason";
  while (at > said && at[-1] != '\n') at--;

  lam_text reason = {.arena = arena};
  for (int lines = 0; lines < 3 && *at; lines++) {
    size_t length = strcspn(at, "\n");
    if (strncmp(at, "Fatal error", 11) == 0) break;
    if (lines) lam_text_add(&reason, " ");
    lam_text_bytes(&reason, at, length);
    at += length + (at[length] == '\n');
  }

  return reason.data;
}

/* Runs povray inside dir, where its default rules let it read and write. Its picture goes to
 * LAM_FOLDER_PICTURE. */
static lam_status run_povray(lam_arena *arena, const char *dir, const char *scene,
                             const lam_picture *picture, const char *templates_dir,
                             const lam_progress *progress, lam_errors *errors) {
  /* -D: no window; +V: progress is said; +L: folders that the scene includes files from. The rest
   * of the list is NULL. */
  const char *arguments[12] = {"povray",
                               lam_arena_printf(arena, "render.ini[%s]", picture->quality),
                               lam_arena_printf(arena, "+I%s", scene),
                               "+O" LAM_FOLDER_PICTURE,
                               lam_arena_printf(arena, "+W%d", picture->width),
                               lam_arena_printf(arena, "+H%d", picture->height),
                               "-D",
                               "+V",
                               "+L."};
  if (templates_dir) arguments[9] = lam_arena_printf(arena, "+L%s/pov", templates_dir);

  lam_text said = {.arena = arena};
  listener l = {.progress = progress, .quality = picture->quality, .said = &said};
  const lam_process process = {.arguments = arguments,
                               .package = "povray",
                               .directory = dir,
                               .hear = hear,
                               .context = &l,
                               .timeout = longest};
  int exit_code = 0;
  lam_status status = lam_process_run(&process, &exit_code, errors);
  if (status != LAM_OK) return status;

  hear_line(&l);
  if (exit_code != 0) {
    lam_error_add(errors, nowhere, NULL, "%s/%s: povray failed: %s", dir, scene,
                  find_reason(arena, said.data));
    return errors->status = LAM_FAILED;
  }
  return LAM_OK;
}

/* Under another name first: the picture that is there stays until the new one is complete. POV-Ray
 * keeps a state beside it, to go on after an interruption; nobody does. */
lam_status lam_render_scene(const lam_folder *folder, const char *scene, const char *name,
                            const lam_picture *picture, const char *templates_dir,
                            const lam_progress *progress, lam_errors *errors) {
  lam_arena *arena = errors->arena;
  if (!lam_folder_has(folder, scene)) {
    lam_error_add(errors, nowhere, NULL, "%s/%s: there is no such scene", folder->path, scene);
    return errors->status = LAM_IO;
  }

  const char *dir = *folder->path ? folder->path : "/";
  lam_status status = run_povray(arena, dir, scene, picture, templates_dir, progress, errors);
  int reason = status == LAM_OK ? lam_folder_rename(folder, LAM_FOLDER_PICTURE, name) : 0;
  if (reason) {
    lam_error_add(errors, nowhere, NULL, "%s/%s: cannot be put in place: %s", folder->path, name,
                  strerror(reason));
    status = errors->status = LAM_IO;
  }

  lam_folder_remove(folder, LAM_FOLDER_PICTURE);
  lam_folder_remove(folder, LAM_FOLDER_STATE);
  return status;
}
