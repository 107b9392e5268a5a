/* One place for what a design refers to outside itself. A name in a design lies beside the design's
 * file. A design whose net starts from another design's net makes that design be built first; a
 * chain of them that comes back to its beginning, or is too long, is an error. Called by designs.c,
 * own_surfaces.c and solve_net.c. */
#include "library/sources.h"
#include "core/file.h"
#include "core/grow.h"
#include "design/pipeline.h"
#include "design/tree.h"
#include "formats/in_place.h"
#include "library/read_files.h"
#include "library/start_mesh.h"
#include "net/measures/measure_map.h"
#include "net/net_kind.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { most_designs = 8 }; /* in a row, each starting from the next */

/* A design in a chain of designs that start from each other. */
typedef struct chain {
  const char *path;
  const struct chain *user; /* the design that starts from this one; NULL: none */
} chain;

/* ---- names ---- */

/* The path of a name in a design whose file is at path (NULL: in memory, names are relative to the
 * current folder). */
static const char *beside(lam_arena *arena, const char *path, const char *name) {
  const char *slash = path && name[0] != '/' ? strrchr(path, '/') : NULL;
  int folder = slash ? (int)(slash - path) + 1 : 0;
  return lam_arena_printf(arena, "%.*s%s", folder, path ? path : "", name);
}

/* The file of a design that another one names with or without its ending. */
static const char *design_file(lam_arena *arena, const char *name) {
  return strrchr(name, '.') ? name : lam_arena_printf(arena, "%s.yaml", name);
}

/* The keys of the design's net that every kind has, or NULL. */
static const lam_net_common *net_of(const lam_design *design) {
  return design->net.head ? design->net.common : NULL;
}

/* The path of the file that the surface names, or NULL. */
static const char *surface_path(const lam_design *design) {
  return design->surface.head ? lam_surface_file_of(&design->surface).path : NULL;
}

/* The surface, the start of the net and its reference; a net starts from a file or a design. */
int lam_sources_list(lam_arena *arena, const lam_design *design, const char *files[LAM_SOURCES]) {
  const lam_net_common *net = net_of(design);
  const char *surface = surface_path(design);
  int count = 0;
  if (surface) files[count++] = surface;
  if (net && net->from.file) files[count++] = net->from.file;
  if (net && net->reference.file) files[count++] = net->reference.file;
  if (net && net->from.design) files[count++] = design_file(arena, net->from.design);
  return count;
}

/* ---- parsing ---- */

/* A text that was given goes before the file. */
bool lam_source_parse(lam_session *session, const lam_design_source *source, lam_design *design) {
  lam_added_rows added = lam_session_rows(session);
  lam_design_text text = {.bytes = source->text,
                          .count = source->length,
                          .path = source->path,
                          .override_count = source->override_count,
                          .overrides = source->overrides,
                          .added = &added};

  if (!source->text) {
    char *bytes;
    if (lam_file_read(session->arena, source->path, (size_t)LAM_DESIGN_MAX_BYTES, &session->errors,
                      &bytes, &text.count) != LAM_OK)
      return false;
    text.bytes = bytes;
  }

  return lam_design_parse(session->arena, &text, &session->errors, design);
}

/* ---- checking ---- */

/* Whether a file that the design names can be read: a plain one, as a pipe would be empty when it
 * is read again. A message under key otherwise. */
static bool check_file(const lam_design *design, const char *name, lam_location location,
                       const char *key, lam_errors *errors) {
  if (!name) return true;
  const char *path = beside(errors->arena, design->path, name);
  struct stat info;
  if (stat(path, &info) == 0 && !S_ISREG(info.st_mode)) {
    lam_error_add(errors, location, key, "given %s, which is a %s; expected a file", name,
                  S_ISDIR(info.st_mode)    ? "folder"
                  : S_ISFIFO(info.st_mode) ? "pipe"
                                           : "device");
    return false;
  }

  if (access(path, R_OK) == 0) return true;
  lam_error_add(errors, location, key, "given %s; expected a file that can be read (looked for %s)",
                name, path);
  return false;
}

/* Reads the file that the surface names, if any, into inputs. False with messages. */
static bool read_surface(lam_arena *arena, const lam_design *design, lam_errors *errors,
                         lam_surface_inputs *inputs) {
  lam_surface_file file = lam_surface_file_of(&design->surface);
  if (file.needs == LAM_NEEDS_NOTHING) return true;

  const char *path = beside(arena, design->path, file.path);
  if (file.needs == LAM_NEEDS_CURVES)
    return lam_input_curves(arena, path, errors, &inputs->curve_count, &inputs->curves);
  if (file.needs == LAM_NEEDS_POINTS)
    return lam_input_points(arena, path, errors, &inputs->point_count, &inputs->points);

  lam_spline_surface *surface = LAM_NEW(arena, lam_spline_surface, 1);
  inputs->surface = surface;
  return lam_input_surface(arena, path, file.face, errors, surface, &inputs->note);
}

/* The file of the surface, and with make what only shows when the surface is made: keys that do not
 * fit together, a file that is damaged. */
static void check_surface(const lam_design *design, bool make, lam_errors *errors) {
  const lam_row *row = &design->surface;
  lam_surface_inputs inputs = {0};
  if (!check_file(design, surface_path(design), row->location, "surface.file", errors)) return;
  if (!make || !read_surface(errors->arena, design, errors, &inputs)) return;

  lam_row filled = lam_surface_row_with(errors->arena, row, &inputs);
  lam_surface_make(errors->arena, &filled, errors);
}

/* The line of a setting that says which views it has, or NULL: other files in its folder are parts
 * of settings. "// Views: entrance (also auto), overview (from above)." */
static const char *views_of(lam_arena *arena, const char *path) {
  lam_errors unread = {.arena = arena};
  char *bytes;
  size_t count;
  if (lam_file_read(arena, path, 1 << 20, &unread, &bytes, &count) != LAM_OK) return NULL;
  char *line = strstr(bytes, "// Views:");
  if (!line) return NULL;
  line[strcspn(line, "\r\n")] = 0;
  return line + strlen("// Views:");
}

/* Whether a view stands in the list: outside of parentheses, or in them after "also". */
static bool has_view(const char *views, const char *view) {
  static const char name_ends[] = " ,.();";
  bool inside = false, also = false;
  for (size_t length; *views; views += length) {
    length = strcspn(views, name_ends);
    if (length == strlen(view) && strncmp(views, view, length) == 0 && (!inside || also))
      return true;
    if (length) also = length == 4 && strncmp(views, "also", 4) == 0;
    if (length) continue;
    if (*views == '(' || *views == ')') inside = *views == '(';
    length = 1;
  }
  return false;
}

/* Whether the setting of the picture is a template, and has the view; without templates there is
 * nothing to compare with. */
static void check_setting(const char *templates, const lam_design *design, lam_errors *errors) {
  const char *setting = design->render.setting;
  if (!templates) return;

  const char *path = lam_arena_printf(errors->arena, "%s/pov/%s.inc", templates, setting);
  const char *views = views_of(errors->arena, path);
  if (!views)
    lam_error_add(errors, design->render.location, "render.setting",
                  "given %s; expected the name of a file in templates/pov, such as plaza", setting);
  else if (!has_view(views, design->render.view))
    lam_error_add(errors, design->render.location, "render.view",
                  "given %s; expected a view that %s has:%s", design->render.view, setting, views);
}

/* The mesh that a net starts from and its reference are read, as a build would do. */
static void check_net_files(const lam_design *design, const lam_net_common *net, bool read,
                            lam_errors *errors) {
  lam_location location = design->net.location;
  lam_inputs inputs = {0};
  lam_trimesh reference;
  if (check_file(design, net->from.file, location, "net.from.file", errors) && read &&
      net->from.file)
    lam_start_mesh_read(errors->arena, beside(errors->arena, design->path, net->from.file),
                        &net->from, location, errors, &inputs);

  const char *near = net->reference.file;
  if (check_file(design, near, location, "net.reference.file", errors) && read && near)
    lam_input_triangles(errors->arena, beside(errors->arena, design->path, near), errors,
                        &reference);
}

/* Everything is looked at, so that all mistakes are shown at once. */
void lam_sources_check(lam_session *session, const lam_design *design, bool make_surface) {
  lam_errors *errors = &session->errors;
  if (design->surface.head) check_surface(design, make_surface, errors);
  check_setting(lam_session_templates(session), design, errors);
  lam_measures_check(&design->plots, true, (lam_location){.file = design->path}, "plots", errors);

  const lam_net_common *net = net_of(design);
  if (!net) return;

  lam_measures_check(&net->measures, false, design->net.location, "net.measures", errors);
  check_net_files(design, net, make_surface, errors);
}

/* ---- reading ---- */

/* Adds a file to what the model is made from, once. */
static void note_file(lam_session *session, lam_origin *origin, const char *path) {
  for (int i = 0; i < origin->file_count; i++)
    if (strcmp(origin->files[i], path) == 0) return;
  LAM_APPEND(session->arena, origin->files, origin->file_count, origin->file_capacity, path);
}

/* Reads what a design of a chain names; defined below: designs name designs. */
static bool read_chain(lam_session *session, const lam_design *design, const chain *self,
                       lam_origin *origin, lam_inputs *inputs);

/* Whether a design may be the next one in a chain: none of those before it (user and its users),
 * and not too many; a message otherwise. */
static bool continues_chain(lam_session *session, const chain *user, const char *path,
                            lam_location location) {
  int depth = 1;
  for (const chain *c = user; c; c = c->user, depth++) {
    bool too_many = depth == most_designs;
    if (!too_many && strcmp(c->path, path) != 0) continue;

    lam_error_add(&session->errors, location, "net.from.design",
                  too_many
                      ? "%s would be the design number %d in a row; expected at most as many"
                      : "%s starts from itself, through %d designs; expected one that does not",
                  path, depth);
    return false;
  }
  return true;
}

/* Builds another design as far as its net. NULL with messages: it is wrong, has no net, or does not
 * converge. user: the chain of designs that starts from it. */
static const lam_mesh *build_net(lam_session *session, const char *path, lam_location location,
                                 const chain *user, lam_origin *origin) {
  lam_errors *errors = &session->errors;
  int before = errors->count;
  if (!continues_chain(session, user, path, location)) return NULL;

  lam_design *design = LAM_NEW(session->arena, lam_design, 1);
  if (!lam_source_parse(session, &(lam_design_source){.path = path}, design)) return NULL;
  lam_sources_check(session, design, false);
  design->parts.count = 0; /* the net is enough */

  chain self = {path, user};
  lam_inputs inputs = {0};
  lam_model *model = LAM_NEW(session->arena, lam_model, 1);
  if (errors->count > before || !read_chain(session, design, &self, origin, &inputs) ||
      !lam_pipeline_run(session->arena, design, &inputs, NULL, errors, model))
    return NULL;

  if (!model->net)
    lam_error_add(errors, location, "net.from.design", "%s has no net", path);
  else if (!lam_report_converged(model->report))
    lam_error_add(errors, location, "net.from.design", "the net of %s does not converge", path);
  return errors->count == before ? lam_model_in_place(session->arena, model)->net : NULL;
}

/* What the net starts from, when that is a file or another design. False with messages. */
static bool read_start(lam_session *session, const lam_design *design, const chain *self,
                       lam_origin *origin, lam_inputs *inputs) {
  const lam_net_common *net = net_of(design);
  if (!net || (!net->from.file && !net->from.design)) return true;

  if (net->from.file) {
    const char *path = beside(session->arena, design->path, net->from.file);
    note_file(session, origin, path);
    return lam_start_mesh_read(session->arena, path, &net->from, design->net.location,
                               &session->errors, inputs);
  }

  const char *name = design_file(session->arena, net->from.design);
  const char *path = beside(session->arena, design->path, name);
  note_file(session, origin, path);
  const lam_mesh *mesh = build_net(session, path, design->net.location, self, origin);
  return mesh && lam_start_mesh_take(session->arena, mesh, &net->from, design->net.location,
                                     &session->errors, inputs);
}

/* The surface that the net stays near, when it stands in a file. False with messages. */
static bool read_reference(lam_session *session, const lam_design *design, lam_origin *origin,
                           lam_inputs *inputs) {
  const lam_net_common *net = net_of(design);
  if (!net || !net->reference_given || !net->reference.file) return true;

  lam_trimesh *mesh = LAM_NEW(session->arena, lam_trimesh, 1);
  const char *path = beside(session->arena, design->path, net->reference.file);
  note_file(session, origin, path);
  inputs->reference = mesh;
  if (!lam_input_triangles(session->arena, path, &session->errors, mesh)) return false;
  lam_start_mesh_scale(mesh->vertices, mesh->vertex_count,
                       lam_start_mesh_unit(path, net->reference.unit));
  return true;
}

/* In the order of the pipeline: surface, start of the net, reference. self: the design as the end
 * of its chain. */
static bool read_chain(lam_session *session, const lam_design *design, const chain *self,
                       lam_origin *origin, lam_inputs *inputs) {
  const char *surface = surface_path(design);
  if (surface) {
    note_file(session, origin, beside(session->arena, design->path, surface));
    if (!read_surface(session->arena, design, &session->errors, &inputs->surface)) return false;
  }

  return read_start(session, design, self, origin, inputs) &&
         read_reference(session, design, origin, inputs);
}

/* A design in memory has no path: nothing can come back to it. */
bool lam_sources_read(lam_session *session, const lam_design *design, lam_origin *origin,
                      lam_inputs *inputs) {
  chain self = {design->path ? design->path : "", NULL};
  *inputs = (lam_inputs){0};
  return read_chain(session, design, &self, origin, inputs);
}
