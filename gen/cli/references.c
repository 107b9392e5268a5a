#include "cli/references.h"
#include "cli/templates.h"
#include "net/kind.h"
#include "net/map.h"
#include "surf/surface.h"

#include <string.h>
#include <unistd.h>

/* A file that the design names lies relative to the design. */
static void check_file(const lam_design *design, const char *file, const char *key, lam_errors *errors) {
  if (!file) return;
  const char *slash = design->path && file[0] != '/' ? strrchr(design->path, '/') : NULL;
  int folder = slash ? (int)(slash - design->path) + 1 : 0;
  const char *path = lam_arena_printf(errors->arena, "%.*s%s", folder, design->path ? design->path : "", file);
  if (access(path, R_OK) == 0) return;
  lam_error_add(errors, design->net.place, key, "given %s; expected a file that can be read (looked for %s)", file,
                path);
}

/* Without templates there is nothing to compare with. */
static void check_setting(const lam_design *design, lam_errors *errors) {
  const char *folder = lam_template_dir(errors->arena), *setting = design->render.setting;
  if (!folder || access(lam_arena_printf(errors->arena, "%s/pov/%s.inc", folder, setting), R_OK) == 0) return;
  lam_error_add(errors, design->render.place, "render.setting",
                "given %s; expected the name of a file in templates/pov, such as plaza", setting);
}

void lam_references_check(const lam_design *design, lam_errors *errors) {
  if (design->surface.head) lam_surface_make(errors->arena, &design->surface, errors);
  check_setting(design, errors);
  lam_measures_check(&design->plots, true, (lam_place){.file = design->path}, "plots", errors);
  if (!design->net.head) return;
  const lam_net_common *net = design->net.common;
  lam_measures_check(&net->measures, false, design->net.place, "net.measures", errors);
  check_file(design, net->from.file, "net.from.file", errors);
  check_file(design, net->reference.file, "net.reference.file", errors);
}
