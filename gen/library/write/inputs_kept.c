/* Outputs and inputs are compared by what their paths lead to, not by how they are written: by
 * device and number of the file. Called by models.c. */
#include "library/write/inputs_kept.h"
#include "core/file.h"

#include <string.h>
#include <sys/stat.h>

bool lam_inputs_have(const lam_origin *origin, const lam_output *output, const char *path) {
  if (origin && origin->path && lam_path_same(origin->path, path)) return true;
  for (int i = 0; origin && i < origin->file_count; i++)
    if (lam_path_same(origin->files[i], path)) return true;
  for (int i = 0; i < output->count; i++) {
    const char *copied = output->files[i].template_path;
    if (copied && lam_path_same(copied, path)) return true;
  }
  return false;
}

/* A link on the way would lead out of the folder. Names of the same folder follow each other: it is
 * looked at once. */
static void check_folders(lam_session *session, const lam_output *output, const char *folder) {
  const char *before = "";
  for (int i = 0; i < output->count; i++) {
    const char *name = output->files[i].name, *slash = strchr(name, '/');
    size_t length = slash ? (size_t)(slash - name) : 0;
    if (!length || strncmp(before, name, length + 1) == 0) continue;
    before = name;

    struct stat info;
    const char *path = lam_arena_printf(session->arena, "%s/%.*s", folder, (int)length, name);
    if (lstat(path, &info) == 0 && S_ISLNK(info.st_mode))
      lam_error_add(&session->errors, (lam_location){.file = path}, NULL,
                    "is a link; expected a folder, as files are not written through links");
  }
}

void lam_inputs_check(lam_session *session, const lam_origin *origin, const lam_output *output,
                      const char *folder, const char *deps) {
  for (int i = 0; i < output->count; i++) {
    const char *path = lam_arena_printf(session->arena, "%s/%s", folder, output->files[i].name);
    if (lam_inputs_have(origin, output, path))
      lam_error_add(&session->errors, (lam_location){.file = path}, NULL,
                    "the model is made from this file, and would overwrite it; expected another "
                    "folder, or another name of the design");
  }

  if (deps && lam_inputs_have(origin, output, deps))
    lam_error_add(&session->errors, (lam_location){.file = deps}, "--deps",
                  "the model is made from this file; expected another one for the rule");
  check_folders(session, output, folder);
}
