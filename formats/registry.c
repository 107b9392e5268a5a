#include "formats/format.h"

#include <string.h>
#include <strings.h>

extern const lam_format lam_format_obj, lam_format_stl, lam_format_scad, lam_format_dxf, lam_format_svg,
    lam_format_gltf, lam_format_bom, lam_format_nodes, lam_format_assembly, lam_format_pov, lam_format_png,
    lam_format_report, lam_format_surface, lam_format_step, lam_format_iges, lam_format_plot, lam_format_plot_gltf;

const lam_format *const lam_formats[] = {
    &lam_format_report, &lam_format_obj,  &lam_format_stl,     &lam_format_scad,  &lam_format_dxf,
    &lam_format_svg,    &lam_format_gltf, &lam_format_bom,     &lam_format_nodes, &lam_format_assembly,
    &lam_format_pov,    &lam_format_png,  &lam_format_surface, &lam_format_step,  &lam_format_iges,
    &lam_format_plot,   &lam_format_plot_gltf,
};
const int lam_format_count = sizeof lam_formats / sizeof *lam_formats;

const lam_format *lam_format_for(const char *path) {
  const char *dot = strrchr(path, '.');
  for (int i = 0; dot && i < lam_format_count; i++)
    if (lam_formats[i]->ending && strcasecmp(lam_formats[i]->ending, dot + 1) == 0) return lam_formats[i];
  return NULL;
}
