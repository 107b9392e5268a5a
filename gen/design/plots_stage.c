/* The stages that draw: color maps of measures on the net, and a picture printed on the surface.
 * Called by pipeline_run.c. */
#include "core/solid/triangles.h"
#include "design/stages.h"
#include "net/measures/measure_map.h"
#include "surf/flatten/texture.h"

#include <string.h>

/* ---- color maps ---- */

/* Lets measures see the surface when the vertices are still where they were sampled on it, to a
 * billionth of the net's size: their surface parameters are known then. */
static void relate_to_surface(lam_build *build) {
  const lam_vec2 *at = build->placement.parameters;
  const lam_mesh *mesh = &build->net->mesh;
  if (!at || build->sampled != mesh->vertex_count) return;

  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_jet jet;
    lam_surface_eval(&build->surface, at[v].x, at[v].y, &jet);
    if (!(lam_distance(lam_placement_apply(&build->placement, jet.x), mesh->vertices[v]) <=
          1e-9 * lam_distance(low, high)))
      return;
  }

  build->measuring.surface = &build->surface;
  build->measuring.parameters = at;
  build->measuring.surface_scale = build->placement.scale;
}

/* A solved net brings what it was measured with (net_stage.c); one that was only sampled is
 * measured by its positions alone. */
bool lam_build_maps(lam_build *build) {
  const lam_list *plots = &build->design->plots;
  int before = build->errors->count;
  lam_location location = {.file = build->design->path};

  /* Also without a net, so that all mistakes are told. */
  lam_measures_check(plots, true, location, "plots", build->errors);
  if (plots->count && !build->net)
    lam_error_add(build->errors, location, "plots",
                  "there is no net to plot; expected a surface or a net");
  if (build->errors->count > before) return false;

  if (!build->measuring.net && plots->count)
    build->measuring = lam_measuring_of(build->arena, build->net, build->net->mesh.vertices);
  if (plots->count) relate_to_surface(build);

  build->model->map_count = plots->count;
  if (plots->count) build->model->maps = lam_net_maps(&build->measuring, plots);
  return true;
}

/* ---- prints ---- */

/* How much the print is drawn out is measured on the surface, in the report's stage `texture`. */
bool lam_build_print(lam_build *build, const lam_workshop *workshop) {
  const lam_texture_keys *keys = &build->design->texture;
  if (!build->design->has_texture) return true;
  if (!workshop->surface_count) {
    lam_error_add(build->errors, (lam_location){.file = build->design->path}, "texture",
                  "there is no spline surface to print on; expected a surface such as developable, "
                  "bezier or nurbs");
    return false;
  }

  lam_stage *stage = lam_build_stage(build, "texture");
  lam_print *print = lam_print_make(build->arena, workshop->surfaces, (lam_motif)keys->motif,
                                    (lam_print_layout)keys->layout, keys->cells);

  for (int i = 0; i < print->count; i++) {
    const lam_printed *sheet = &print->sheets[i];
    /* A name with a hyphen is that of a print that is shown once more, laid flat. */
    if (strchr(sheet->name, '-')) continue;
    lam_stage_measure(build->arena, stage,
                      lam_arena_printf(build->arena, "distortion_%s", sheet->name), "",
                      sheet->max_stretch, sheet->mean_stretch, sheet->mesh.triangle_count);
  }

  build->model->print = print;
  lam_build_stage_end(build, stage);
  return true;
}
