/* Pictures of scenes: POV-Ray started in the folder of the scene, its complaints turned into one
 * line. Called by write_files.c. */
#include "library/write/render.h"

#include "core/process.h"
#include <stdio.h>
#include <string.h>

static const lam_location nowhere;
static const double longest = 7200; /* seconds, for a picture: the largest take an hour */

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
                             lam_errors *errors) {
  /* -D: no window; +L: folders that the scene includes files from. The rest of the list is NULL. */
  const char *arguments[12] = {"povray",
                               lam_arena_printf(arena, "render.ini[%s]", picture->quality),
                               lam_arena_printf(arena, "+I%s", scene),
                               "+O" LAM_FOLDER_PICTURE,
                               lam_arena_printf(arena, "+W%d", picture->width),
                               lam_arena_printf(arena, "+H%d", picture->height),
                               "-D",
                               "+L."};
  if (templates_dir) arguments[8] = lam_arena_printf(arena, "+L%s/pov", templates_dir);

  lam_text said = {.arena = arena};
  const lam_process process = {.arguments = arguments,
                               .package = "povray",
                               .directory = dir,
                               .output = &said,
                               .timeout = longest};
  int exit_code = 0;
  lam_status status = lam_process_run(&process, &exit_code, errors);
  if (status != LAM_OK) return status;

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
                            lam_errors *errors) {
  lam_arena *arena = errors->arena;
  if (!lam_folder_has(folder, scene)) {
    lam_error_add(errors, nowhere, NULL, "%s/%s: there is no such scene", folder->path, scene);
    return errors->status = LAM_IO;
  }

  lam_status status =
      run_povray(arena, *folder->path ? folder->path : "/", scene, picture, templates_dir, errors);
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
