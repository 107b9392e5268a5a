/* lamella new DESIGN [-o FILE]: copies a shipped design to start from, with the files that it
 * names. */
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "core/error.h"
#include "core/file.h"
#include "design/tree.h"
#include "library/references.h"
#include "library/templates.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char usage[] =
    "usage: lamella new DESIGN [-o FILE]   (lamella list designs shows the names)";

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

/* A file to be copied: of the shipped designs, and where to. */
typedef struct copy {
  const char *name, *target;
  char *bytes;
  size_t count;
  bool there; /* with the same bytes */
} copy;

enum { MOST_COPIES = 32 };

static bool is_design(const char *name) {
  const char *ending = strrchr(name, '.');
  return ending && strcmp(ending, ".yaml") == 0;
}

static bool is_noted(int count, const copy *copies, const char *name) {
  for (int i = 0; i < count; i++)
    if (strcmp(copies[i].name, name) == 0) return true;
  return false;
}

/* Reads file i of the list and, of a design, adds the files that it names to the list. */
static lam_status read_copy(lam_arena *arena, const char *shipped, int i, int *count, copy *copies,
                            lam_errors *errors) {
  copy *c = &copies[i];
  const char *slash = strrchr(shipped, '/'), *path;
  path = lam_arena_printf(arena, "%.*s/%s", (int)(slash - shipped), shipped, c->name);
  lam_status status =
      lam_file_read(arena, path, (size_t)LAM_DESIGN_MAX_BYTES, errors, &c->bytes, &c->count);
  if (status != LAM_OK || !is_design(c->name)) return status;
  lam_design *design = LAM_NEW(arena, lam_design, 1);
  const char *files[LAM_REFERENCES];
  if (!lam_design_parse(arena, c->bytes, c->count, path, NULL, 0, errors, design))
    return LAM_BAD_INPUT;
  int named = lam_references_list(arena, design, files);
  for (int k = 0; k < named; k++)
    if (!is_noted(*count, copies, files[k]) && *count < MOST_COPIES)
      copies[(*count)++].name = files[k];
  return LAM_OK;
}

/* A file that the design names may be there already, the same; the design itself must not. */
static int look_at_target(lam_arena *arena, copy *c, bool named) {
  lam_errors unread = {.arena = arena};
  char *bytes;
  size_t count;
  if (access(c->target, F_OK) != 0) return 0;
  c->there = named &&
             lam_file_read(arena, c->target, (size_t)LAM_DESIGN_MAX_BYTES, &unread, &bytes,
                           &count) == LAM_OK &&
             count == c->count && memcmp(bytes, c->bytes, count) == 0;
  if (c->there) return 0;
  if (named)
    return lam_complain_plain(
        2, "new: %s exists and differs from the one that the design needs; expected another folder",
        c->target);
  return lam_complain_plain(2, "new: %s exists; choose another name with -o FILE", c->target);
}

static int copy_design(lam_arena *arena, const char *name, const char *target) {
  const char *const *names = lam_template_designs(arena);
  if (!is_listed(names, name)) {
    const char *guess = lam_did_you_mean(name, names);
    if (guess)
      return lam_complain_plain(2, "new: no shipped design is called %s (did you mean %s?)", name,
                                guess);
    return lam_complain_plain(
        2, "new: no shipped design is called %s; lamella list designs shows them", name);
  }
  lam_errors errors = {.arena = arena};
  copy copies[MOST_COPIES] = {{.name = lam_arena_printf(arena, "%s.yaml", name)}};
  copies[0].target = target ? target : copies[0].name;
  const char *slash = strrchr(copies[0].target, '/'),
             *shipped = lam_template_design_path(arena, name);
  int count = 1, folder = slash ? (int)(slash - copies[0].target) + 1 : 0;
  for (int i = 0; i < count; i++) {
    copy *c = &copies[i];
    if (i) c->target = lam_arena_printf(arena, "%.*s%s", folder, copies[0].target, c->name);
    if (read_copy(arena, shipped, i, &count, copies, &errors) != LAM_OK) {
      lam_complain(&errors);
      return 1;
    }
    int status = look_at_target(arena, c, i > 0);
    if (status) return status;
  }
  for (int i = 0; i < count; i++) {
    if (copies[i].there) continue;
    int status = write_new(copies[i].target, copies[i].bytes, copies[i].count);
    if (status) return status;
    printf("%s\n", copies[i].target);
  }
  return 0;
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
