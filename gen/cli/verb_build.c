/* lamella build DESIGN: from a design file to a folder of files. */
#include "cli/complain.h"
#include "cli/report_table.h"
#include "cli/terminal.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include "core/file.h"
#include "core/text.h"
#include "design/pipeline_run.h"
#include "design/tree.h"
#include "library/manifest.h"
#include "library/mesh_files.h"
#include "library/output.h"
#include "library/references.h"
#include "library/templates.h"
#include "net/net_kind.h"

#include <stdio.h>
#include <string.h>

static const char usage[] =
    "usage: lamella build DESIGN.yaml [-o DIR] [--set KEY=VALUE]... [--only|--skip FORMAT,...] "
    "[--deps FILE] [--quiet] [--timings]\n"
    "  -o DIR           the folder for the files (default: the design's name)\n"
    "  --set KEY=VALUE  overrides a key of the design, as in --set net.grid=[40,40]\n"
    "  --only FORMATS   writes only these formats (see lamella list formats)\n"
    "  --skip FORMATS   writes all formats but these\n"
    "  --deps FILE      writes a make rule: what DIR/report.json was made from\n"
    "  --quiet          prints errors only\n"
    "  --timings        adds the seconds of every stage to the report";

typedef struct arguments {
  const char *path, *folder, *only, *skip, *deps;
  lam_override *overrides;
  int override_count;
  bool quiet, timings;
} arguments;

/* The value of an option that takes one; NULL with a message when it is missing. */
static const char *value_of(int argc, char **argv, int *i) {
  if (*i + 1 < argc) return argv[++*i];
  lam_complain_plain(2, "build: %s needs a value\n%s", argv[*i], usage);
  return NULL;
}

/* -1: go on; otherwise the exit status. */
static int read_arguments(lam_arena *arena, int argc, char **argv, arguments *out) {
  out->overrides = LAM_NEW(arena, lam_override, argc);
  for (int i = 1; i < argc; i++) {
    const char *a = argv[i];
    const char **target = NULL;
    if (strcmp(a, "--help") == 0) return puts(usage) < 0;
    if (strcmp(a, "--quiet") == 0)
      out->quiet = true;
    else if (strcmp(a, "--timings") == 0)
      out->timings = true;
    else if (strcmp(a, "-o") == 0)
      target = &out->folder;
    else if (strcmp(a, "--only") == 0)
      target = &out->only;
    else if (strcmp(a, "--skip") == 0)
      target = &out->skip;
    else if (strcmp(a, "--deps") == 0)
      target = &out->deps;
    else if (strcmp(a, "--set") == 0)
      target = &out->overrides[out->override_count++].text;
    else if (a[0] == '-' || out->path)
      return lam_complain_plain(2, "build: %s is not expected here\n%s", a, usage);
    else
      out->path = a;
    if (target && !(*target = value_of(argc, argv, &i))) return 2;
  }
  return out->path ? -1 : lam_complain_plain(2, "build: expected a design file\n%s", usage);
}

/* Meshes and designs that the design names are looked for beside it. */
typedef struct source_files {
  const char *design;
  struct source_files *user; /* the design whose net starts from this one; NULL: none */
  int count;
  const char *paths[32];
} source_files;
enum { most_designs = 8 };

static void remember(source_files *files, const char *path) {
  while (files->user) files = files->user;
  for (int i = 0; i < files->count; i++)
    if (strcmp(files->paths[i], path) == 0) return;
  if (files->count < 32) files->paths[files->count++] = path;
}

static const char *beside(source_files *files, lam_arena *arena, const char *path) {
  const char *slash = path[0] != '/' ? strrchr(files->design, '/') : NULL;
  int folder = slash ? (int)(slash - files->design) + 1 : 0;
  const char *full = lam_arena_printf(arena, "%.*s%s", folder, files->design, path);
  remember(files, full);
  return full;
}

static bool load_mesh(void *context, lam_arena *arena, const char *path, lam_location location,
                      lam_errors *errors, lam_mesh *mesh) {
  (void)location;
  return lam_input_mesh(arena, beside(context, arena, path), errors, mesh);
}

static bool load_triangles(void *context, lam_arena *arena, const char *path, lam_location location,
                           lam_errors *errors, lam_trimesh *mesh) {
  (void)location;
  return lam_input_triangles(arena, beside(context, arena, path), errors, mesh);
}

static bool load_surface(void *context, lam_arena *arena, const char *path, int face,
                         lam_location location, lam_errors *errors, lam_spline_surface *surface,
                         const char **note) {
  (void)location;
  return lam_input_surface(arena, beside(context, arena, path), face, errors, surface, note);
}

static bool load_curves(void *context, lam_arena *arena, const char *path, lam_location location,
                        lam_errors *errors, int *count, const lam_named_curve **curves) {
  (void)location;
  return lam_input_curves(arena, beside(context, arena, path), errors, count, curves);
}

static bool load_points(void *context, lam_arena *arena, const char *path, lam_location location,
                        lam_errors *errors, int *count, const lam_vec3 **points) {
  (void)location;
  return lam_input_points(arena, beside(context, arena, path), errors, count, points);
}

/* Builds another design as far as its net. */
static bool load_net(void *context, lam_arena *arena, const char *name, lam_location location,
                     lam_errors *errors, lam_mesh *mesh) {
  const char *ending = strrchr(name, '.') ? "" : ".yaml";
  source_files *user = context;
  source_files files = {
      .design = beside(user, arena, lam_arena_printf(arena, "%s%s", name, ending)), .user = user};
  int depth = 1, before = errors->count;
  for (const source_files *f = user; f; f = f->user, depth++)
    if (strcmp(f->design, files.design) == 0 || depth == most_designs) {
      lam_error_add(errors, location, "net.from.design",
                    depth == most_designs
                        ? "%s would be the design number %d in a row; expected at most as many"
                        : "%s starts from itself, through %d designs; expected one that does not",
                    files.design, depth);
      return false;
    }
  char *bytes;
  size_t count;
  lam_design design;
  lam_model model;
  if (lam_file_read(arena, files.design, (size_t)LAM_DESIGN_MAX_BYTES, errors, &bytes, &count) !=
      LAM_OK)
    return false;
  if (!lam_design_parse(arena, bytes, count, files.design, NULL, 0, errors, &design)) return false;
  lam_references_check(&design, false, errors);
  design.parts.count = 0;
  lam_loader loader = {.mesh = load_mesh,
                       .triangles = load_triangles,
                       .context = &files,
                       .net = load_net,
                       .surface = load_surface,
                       .curves = load_curves,
                       .points = load_points};
  if (errors->count > before || !lam_design_build(arena, &design, &loader, NULL, errors, &model))
    return false;
  if (!model.net)
    lam_error_add(errors, location, "net.from.design", "%s has no net", files.design);
  else if (!lam_report_converged(model.report))
    lam_error_add(errors, location, "net.from.design", "the net of %s does not converge",
                  files.design);
  else
    *mesh = *model.net;
  return errors->count == before;
}

/* Spaces and dollars would end a name in a rule. */
static void add_name(lam_text *text, const char *name) {
  for (; *name; name++) {
    if (*name == ' ' || *name == '#') lam_text_add(text, "\\");
    if (*name == '$') lam_text_add(text, "$");
    lam_text_bytes(text, name, 1);
  }
}

static void write_deps(lam_arena *arena, const arguments *given, const char *folder,
                       const source_files *files, const lam_output *output, lam_errors *errors) {
  lam_text text = {.arena = arena}, phony = {.arena = arena};
  add_name(&text, lam_arena_printf(arena, "%s/report.json", folder));
  lam_text_add(&text, ":");
  for (int i = -1; i < files->count + output->template_count; i++) {
    const char *name = i < 0              ? given->path
                       : i < files->count ? files->paths[i]
                                          : output->used_templates[i - files->count];
    lam_text_add(&text, " \\\n  ");
    add_name(&text, name);
    add_name(&phony, name); /* a file that is gone later must not stop make */
    lam_text_add(&phony, ":\n");
  }
  lam_text_printf(&text, "\n%s", phony.data);
  lam_file_write_atomic(given->deps, text.data, text.length, errors);
}

static void forget_times(const lam_report *report) {
  for (int i = 0; i < report->stage_count; i++) report->stages[i].seconds = 0;
}

static int finish(lam_arena *arena, const arguments *given, const lam_model *model,
                  const source_files *files, const lam_progress *progress) {
  lam_errors errors = {.arena = arena}, notes = {.arena = arena};
  const char *folder = given->folder ? given->folder : model->name;
  lam_output output = {.folder = folder,
                       .only = given->only,
                       .skip = given->skip,
                       .templates = lam_template_dir(arena),
                       .progress = progress};
  if (!output.templates)
    return lam_complain_plain(1, "the templates folder is not found; set LAMELLA_TEMPLATES");
  if (!given->timings) forget_times(model->report);
  lam_output_write(arena, model, &output, &notes, &errors);
  int removed = 0;
  if (errors.count == 0)
    removed = lam_manifest_update(arena, folder, model->name, output.file_count, output.files,
                                  given->only || given->skip, &errors);
  if (given->deps && errors.count == 0) write_deps(arena, given, folder, files, &output, &errors);
  lam_progress_tell(progress, NULL, 1, "");
  for (const lam_error *note = notes.first; note; note = note->next)
    fprintf(stderr, "lamella: %s\n", note->text);
  if (errors.count) {
    lam_complain(&errors);
    return 1;
  }
  if (!given->quiet) {
    lam_report_print(model->report, stdout);
    printf("%d files in %s\n", output.file_count, folder);
    if (removed)
      printf("%d files of the last build, which this one does not make, were removed\n", removed);
  }
  return lam_report_converged(model->report) ? 0 : 1;
}

static int build(lam_arena *arena, int argc, char **argv) {
  arguments given = {0};
  lam_errors errors = {.arena = arena};
  int status = read_arguments(arena, argc, argv, &given);
  if (status >= 0) return status;
  char *bytes = NULL;
  size_t count = 0;
  lam_design *design = LAM_NEW(arena, lam_design, 1);
  if (given.only) lam_output_check("--only", given.only, &errors);
  if (given.skip) lam_output_check("--skip", given.skip, &errors);
  if (lam_file_read(arena, given.path, (size_t)LAM_DESIGN_MAX_BYTES, &errors, &bytes, &count) !=
      LAM_OK)
    return lam_complain(&errors);
  lam_design_parse(arena, bytes, count, given.path, given.overrides, given.override_count, &errors,
                   design);
  if (errors.count == 0) lam_references_check(design, false, &errors);
  if (errors.count) return lam_complain(&errors);
  source_files files = {.design = given.path};
  lam_loader loader = {.mesh = load_mesh,
                       .triangles = load_triangles,
                       .context = &files,
                       .net = load_net,
                       .surface = load_surface,
                       .curves = load_curves,
                       .points = load_points};
  lam_progress progress = lam_terminal_progress(arena, given.quiet);
  lam_model *model = LAM_NEW(arena, lam_model, 1);
  if (!lam_design_build(arena, design, &loader, &progress, &errors, model)) {
    lam_progress_tell(&progress, NULL, 1, "");
    return lam_complain(&errors);
  }
  return finish(arena, &given, model, &files, &progress);
}

int lam_verb_build(int argc, char **argv) { return lam_verb_run(build, argc, argv); }
