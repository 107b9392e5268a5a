#include "library/references.h"
#include "library/mesh_files.h"
#include "library/templates.h"
#include "net/measures/measure_map.h"
#include "net/net_kind.h"
#include "surf/spline/sides_keys.h"

#include <string.h>
#include <unistd.h>

/* A file that the design names lies relative to the design. */
static const char *beside(const lam_design *design, const char *file, lam_arena *arena) {
  const char *slash = design->path && file[0] != '/' ? strrchr(design->path, '/') : NULL;
  int folder = slash ? (int)(slash - design->path) + 1 : 0;
  return lam_arena_printf(arena, "%.*s%s", folder, design->path ? design->path : "", file);
}

static bool check_file(const lam_design *design, const char *file, lam_location location,
                       const char *key, lam_errors *errors) {
  if (!file) return true;
  const char *path = beside(design, file, errors->arena);
  if (access(path, R_OK) == 0) return true;
  lam_error_add(errors, location, key, "given %s; expected a file that can be read (looked for %s)",
                file, path);
  return false;
}

/* Reads the file that a surface stands in, or its curves or points. */
static bool read_surface(const lam_design *design, lam_errors *errors) {
  const lam_row *row = &design->surface;
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  lam_surface_source *source = kind->reads_file ? row->params : NULL;
  lam_sides_keys *sides = kind->sides ? kind->sides(row->params) : NULL;
  lam_point_file *cloud = kind->points ? kind->points(row->params) : NULL;
  lam_arena *arena = errors->arena;
  if (source) {
    lam_spline_surface *surface = LAM_NEW(arena, lam_spline_surface, 1);
    const char *path = beside(design, source->file, arena);
    if (!lam_input_surface(arena, path, source->face, errors, surface, &source->note)) return false;
    source->surface = surface;
  }
  if (sides && sides->file &&
      !lam_input_curves(arena, beside(design, sides->file, arena), errors, &sides->read_count,
                        &sides->read))
    return false;
  return !cloud || !cloud->file ||
         lam_input_points(arena, beside(design, cloud->file, arena), errors, &cloud->count,
                          &cloud->points);
}

/* What is wrong with the surface when its keys, or the file that it stands in, are taken together;
 * with make only, as building reads and makes it too. */
static void check_surface(const lam_design *design, bool make, lam_errors *errors) {
  const lam_row *row = &design->surface;
  const lam_surface_kind *kind = (const lam_surface_kind *)row->head;
  const char *file = kind->reads_file ? ((const lam_surface_source *)row->params)->file : NULL;
  if (kind->sides) file = kind->sides(row->params)->file;
  if (kind->points) file = kind->points(row->params)->file;
  if (!check_file(design, file, row->location, "surface.file", errors)) return;
  if (make && read_surface(design, errors)) lam_surface_make(errors->arena, row, errors);
}

/* Without templates there is nothing to compare with. */
static void check_setting(const lam_design *design, lam_errors *errors) {
  const char *folder = lam_template_dir(errors->arena), *setting = design->render.setting;
  if (!folder ||
      access(lam_arena_printf(errors->arena, "%s/pov/%s.inc", folder, setting), R_OK) == 0)
    return;
  lam_error_add(errors, design->render.location, "render.setting",
                "given %s; expected the name of a file in templates/pov, such as plaza", setting);
}

void lam_references_check(const lam_design *design, bool make_surface, lam_errors *errors) {
  if (design->surface.head) check_surface(design, make_surface, errors);
  check_setting(design, errors);
  lam_measures_check(&design->plots, true, (lam_location){.file = design->path}, "plots", errors);
  if (!design->net.head) return;
  const lam_net_common *net = design->net.common;
  lam_measures_check(&net->measures, false, design->net.location, "net.measures", errors);
  check_file(design, net->from.file, design->net.location, "net.from.file", errors);
  check_file(design, net->reference.file, design->net.location, "net.reference.file", errors);
}

int lam_references_list(lam_arena *arena, const lam_design *design,
                        const char *files[LAM_REFERENCES]) {
  const char *named[LAM_REFERENCES] = {NULL};
  int count = 0, all = 0;
  if (design->surface.head) {
    const lam_surface_kind *kind = (const lam_surface_kind *)design->surface.head;
    void *params = design->surface.params;
    if (kind->reads_file) named[all++] = ((const lam_surface_source *)params)->file;
    if (kind->sides) named[all++] = kind->sides(params)->file;
    if (kind->points) named[all++] = kind->points(params)->file;
  }
  if (design->net.head) {
    const lam_net_common *net = design->net.common;
    named[all++] = net->from.file;
    named[all++] = net->reference.file;
    const char *other = net->from.design;
    if (other)
      named[all++] = strrchr(other, '.') ? other : lam_arena_printf(arena, "%s.yaml", other);
  }
  for (int i = 0; i < all; i++)
    if (named[i]) files[count++] = named[i];
  return count;
}
