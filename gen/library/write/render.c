/* Pictures of scenes: POV-Ray started in the folder of the scene, its complaints turned into one
 * line. Called by write_files.c. */
#include "library/write/render.h"

#include "core/process.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const lam_location nowhere;

/* Whether dir/name is a file that can be read. */
static bool is_readable(lam_arena *arena, const char *dir, const char *name) {
  return access(lam_arena_printf(arena, "%s/%s", dir, name), R_OK) == 0;
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

/* A section of render.ini, which lies beside the scene or with the templates. */
static const char *quality_of(lam_arena *arena, const char *dir, const char *templates_dir,
                              const char *quality) {
  if (is_readable(arena, dir, "render.ini") || !templates_dir)
    return lam_arena_printf(arena, "render.ini[%s]", quality);
  return lam_arena_printf(arena, "%s/pov/render.ini[%s]", templates_dir, quality);
}

/* Runs povray inside dir, where its default rules let it read and write. Its picture goes to
 * `part`, a name in dir. */
static lam_status run_povray(lam_arena *arena, const char *dir, const char *scene, const char *part,
                             const lam_picture *picture, const char *templates_dir,
                             lam_errors *errors) {
  /* -D: no window; +L: folders that the scene includes files from. The rest of the list is NULL. */
  const char *arguments[12] = {"povray",
                               quality_of(arena, dir, templates_dir, picture->quality),
                               lam_arena_printf(arena, "+I%s", scene),
                               lam_arena_printf(arena, "+O%s", part),
                               lam_arena_printf(arena, "+W%d", picture->width),
                               lam_arena_printf(arena, "+H%d", picture->height),
                               "-D",
                               "+L."};
  if (templates_dir) arguments[8] = lam_arena_printf(arena, "+L%s/pov", templates_dir);

  lam_text said = {.arena = arena};
  const lam_process process = {
      .arguments = arguments, .package = "povray", .directory = dir, .output = &said, .timeout = 0};
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

/* Under another name first: the picture that is there stays until the new one is complete. */
lam_status lam_render_scene(const char *dir, const char *pov_name, const lam_picture *picture,
                            const char *templates_dir, lam_errors *errors) {
  lam_arena *arena = errors->arena;
  if (!is_readable(arena, dir, pov_name)) {
    lam_error_add(errors, nowhere, NULL, "%s/%s: there is no such scene", dir, pov_name);
    return errors->status = LAM_IO;
  }

  const char *dot = strrchr(pov_name, '.');
  int stem = (int)(dot ? (size_t)(dot - pov_name) : strlen(pov_name));
  const char *part = lam_arena_printf(arena, "%.*s.part.png", stem, pov_name);
  const char *from = lam_arena_printf(arena, "%s/%s", dir, part);
  const char *to = lam_arena_printf(arena, "%s/%.*s.png", dir, stem, pov_name);

  lam_status status = run_povray(arena, dir, pov_name, part, picture, templates_dir, errors);
  if (status == LAM_OK && rename(from, to) != 0) {
    lam_error_add(errors, nowhere, NULL, "%s: cannot be put in place: %s", to, strerror(errno));
    status = errors->status = LAM_IO;
  }
  if (status != LAM_OK) unlink(from);
  return status;
}
