/* The list of formats. To add one: write its file, and add its line here. */
#include "formats/format.h"

#include <string.h>
#include <strings.h>

/* clang-format off */
#define FORMATS(row) \
  row(report) \
  row(obj) \
  row(stl) \
  row(scad) \
  row(dxf) \
  row(svg) \
  row(gltf) \
  row(bom) \
  row(nodes) \
  row(assembly) \
  row(pov) \
  row(png) \
  row(surface) \
  row(step) \
  row(iges) \
  row(surface_obj) \
  row(plot) \
  row(plot_gltf) \
  row(frames) \
  row(animation)
/* clang-format on */

#define DECLARE(name) extern const lam_format lam_format_##name;
FORMATS(DECLARE)

#define POINT(name) &lam_format_##name,
const lam_format *const lam_formats[] = {FORMATS(POINT)};
const int lam_format_count = sizeof lam_formats / sizeof *lam_formats;

/* Whether a list of endings, parted by blanks, has this one. */
static bool has_ending(const char *list, const char *ending) {
  size_t length = strlen(ending);
  for (; list; list = strchr(list, ' ')) {
    list += *list == ' ';
    if (length && strncasecmp(list, ending, length) == 0 &&
        (list[length] == 0 || list[length] == ' '))
      return true;
  }
  return false;
}

const lam_format *lam_format_for(const char *path) {
  const char *dot = strrchr(path, '.');
  for (int i = 0; dot && i < lam_format_count; i++)
    if (has_ending(lam_formats[i]->ending, dot + 1)) return lam_formats[i];
  return NULL;
}
