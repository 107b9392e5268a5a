/* lamella new DESIGN [-o FILE]: copies a shipped design to start from. */
#include "cli/complain.h"
#include "cli/run.h"
#include "cli/templates.h"
#include "cli/verbs.h"
#include "core/error.h"
#include "core/file.h"
#include "design/tree.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char usage[] = "usage: lamella new DESIGN [-o FILE]   (lamella list designs shows the names)";

static bool is_listed(const char *const *names, const char *name) {
  for (; *names; names++) {
    if (strcmp(*names, name) == 0) return true;
  }
  return false;
}

/* Writes a file that must not exist yet. Removes what it wrote when it fails. */
static int write_new(const char *path, const char *bytes, size_t count) {
  int file = open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (file < 0 && errno == EEXIST)
    return lam_complain_plain(2, "new: %s exists; choose another name with -o FILE", path);
  if (file < 0) return lam_complain_plain(1, "new: %s: %s", path, strerror(errno));
  bool good = true;
  for (size_t done = 0; done < count && good;) {
    ssize_t written = write(file, bytes + done, count - done);
    good = written > 0 || (written < 0 && errno == EINTR);
    if (written > 0) done += (size_t)written;
  }
  int problem = errno;
  good = close(file) == 0 && good;
  if (good) return 0;
  unlink(path);
  return lam_complain_plain(1, "new: %s: %s", path, strerror(problem));
}

static int copy_design(lam_arena *arena, const char *name, const char *target) {
  const char *const *names = lam_template_designs(arena);
  if (!is_listed(names, name)) {
    const char *guess = lam_did_you_mean(name, names);
    if (guess) return lam_complain_plain(2, "new: no shipped design is called %s (did you mean %s?)", name, guess);
    return lam_complain_plain(2, "new: no shipped design is called %s; lamella list designs shows them", name);
  }
  lam_errors errors = {.arena = arena};
  char *bytes = NULL;
  size_t count = 0;
  const char *path = lam_template_design_path(arena, name);
  if (lam_file_read(arena, path, (size_t)LAM_DESIGN_MAX_BYTES, &errors, &bytes, &count) != LAM_OK) {
    lam_complain(&errors);
    return 1;
  }
  if (!target) target = lam_arena_printf(arena, "%s.yaml", name);
  int status = write_new(target, bytes, count);
  if (status == 0) printf("%s\n", target);
  return status;
}

static int new_design(lam_arena *arena, int argc, char **argv) {
  const char *name = NULL, *target = NULL;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--help") == 0) return puts(usage) < 0;
    if (strcmp(argv[i], "-o") == 0) {
      if (++i == argc) return lam_complain_plain(2, "new: -o without a file\n%s", usage);
      target = argv[i];
    } else if (argv[i][0] == '-' || name) {
      return lam_complain_plain(2, "new: %s is not expected here\n%s", argv[i], usage);
    } else {
      name = argv[i];
    }
  }
  if (!name) return lam_complain_plain(2, "new: expected the name of a shipped design\n%s", usage);
  return copy_design(arena, name, target);
}

int lam_verb_new(int argc, char **argv) { return lam_verb_run(new_design, argc, argv); }
