/* The list of formats. To add one: write its file, and add its line here. Called by library/. */
#include "formats/list/formats.h"

#include <string.h>
#include <strings.h>

/* clang-format off */
#define FORMATS(row) \
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
  row(animation) \
  row(off) \
  row(ply) \
  row(points) \
  row(report)
/* clang-format on */

#define DECLARE(name) extern const lam_format lam_format_##name;
FORMATS(DECLARE)

#define POINT(name) &lam_format_##name,
const lam_format *const lam_formats[] = {FORMATS(POINT)};
const int lam_format_count = sizeof lam_formats / sizeof *lam_formats;

const lam_format *lam_format_named(const char *name) {
  for (int i = 0; i < lam_format_count; i++)
    if (strcmp(lam_formats[i]->name, name) == 0) return lam_formats[i];
  return NULL;
}

/* Whether a list of endings, parted by blanks, has this one. */
static bool has_ending(const char *list, const char *ending) {
  size_t length = strlen(ending);
  for (; list; list = strchr(list, ' ')) {
    list += *list == ' ';
    bool starts = length && strncasecmp(list, ending, length) == 0;
    if (starts && (list[length] == 0 || list[length] == ' ')) return true;
  }
  return false;
}

const lam_format *lam_format_for(const char *path) {
  const char *dot = strrchr(path, '.');
  for (int i = 0; dot && i < lam_format_count; i++)
    if (has_ending(lam_formats[i]->ending, dot + 1)) return lam_formats[i];
  return NULL;
}

bool lam_format_reads(const lam_format *format, lam_content content) {
  const bool reads[] = {[LAM_CONTENT_MESH] = format->read_mesh,
                        [LAM_CONTENT_TRIANGLES] = format->read_triangles,
                        [LAM_CONTENT_SURFACES] = format->read_surfaces,
                        [LAM_CONTENT_CURVES] = format->read_curves,
                        [LAM_CONTENT_POINTS] = format->read_points || format->read_triangles};
  return reads[content];
}

/* Appends the endings of one list, ".step, .stp"; last: the ending to be joined by "or". */
static void add_endings(lam_text *text, const char *list, int *left) {
  for (; list; list = strchr(list, ' ')) {
    list += *list == ' ';
    const char *join = text->length == 0 ? "" : *left == 1 ? " or " : ", ";
    lam_text_printf(text, "%s.%.*s", join, (int)strcspn(list, " "), list);
    (*left)--;
  }
}

const char *lam_format_endings(lam_arena *arena, lam_content content) {
  lam_text text = {.arena = arena};
  int left = 0;
  for (int i = 0; i < lam_format_count; i++)
    for (const char *at = lam_format_reads(lam_formats[i], content) ? lam_formats[i]->ending : NULL;
         at; at = strchr(at + 1, ' '))
      left++;

  for (int i = 0; i < lam_format_count; i++)
    if (lam_format_reads(lam_formats[i], content))
      add_endings(&text, lam_formats[i]->ending, &left);
  return text.data;
}
