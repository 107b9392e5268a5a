/* The stages that draw: color maps of measures on the net, and a picture printed on the surface. */
#include "core/solid/triangles.h"
#include "design/stages.h"
#include "net/measures/measure_map.h"
#include "surf/flatten/texture.h"

#include <math.h>
#include <string.h>

/* ---- color maps ---- */

/* Lets measures see the surface when the vertices are where they were sampled, to a billionth of
 * the net's size. */
static void relate_to_surface(lam_build *p) {
  const lam_vec2 *at = p->placement.parameters;
  const lam_mesh *mesh = &p->net->mesh;
  if (!at || p->sampled != mesh->vertex_count) return;
  lam_vec3 low, high;
  lam_points_bounds(mesh->vertices, mesh->vertex_count, &low, &high);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_jet jet;
    lam_surface_eval(&p->surface, at[v].x, at[v].y, &jet);
    if (!(lam_distance(lam_placement_apply(&p->placement, jet.x), mesh->vertices[v]) <=
          1e-9 * lam_distance(low, high)))
      return;
  }
  p->measuring.surface = &p->surface;
  p->measuring.parameters = at;
  p->measuring.surface_scale = p->placement.scale;
}

bool lam_build_maps(lam_build *p) {
  const lam_list *plots = &p->design->plots;
  int before = p->errors->count;
  lam_location location = {.file = p->design->path};
  lam_measures_check(plots, true, location, "plots", p->errors);
  if (plots->count && !p->net)
    lam_error_add(p->errors, location, "plots",
                  "there is no net to plot; expected a surface or a net");
  if (p->errors->count > before) return false;
  if (!p->measuring.net && plots->count)
    p->measuring = lam_measuring_of(p->arena, p->net, p->net->mesh.vertices);
  if (plots->count) relate_to_surface(p);
  p->model->map_count = plots->count;
  if (plots->count) p->model->maps = lam_net_maps(&p->measuring, plots);
  return true;
}

/* ---- prints ---- */

bool lam_build_print(lam_build *p, const lam_workshop *workshop) {
  const lam_texture_keys *keys = &p->design->texture;
  if (!p->design->has_texture) return true;
  if (!workshop->surface_count) {
    lam_error_add(p->errors, (lam_location){.file = p->design->path}, "texture",
                  "there is no spline surface to print on; expected a surface such as developable, "
                  "bezier or nurbs");
    return false;
  }
  lam_stage *stage = lam_build_stage(p, "texture");
  lam_print *print = lam_print_make(p->arena, workshop->surfaces, (lam_motif)keys->motif,
                                    (lam_print_layout)keys->layout, keys->cells);
  for (int i = 0; i < print->count; i++) {
    const lam_printed *sheet = &print->sheets[i];
    if (strchr(sheet->name, '-')) continue; /* the same print, laid flat */
    lam_stage_measure(p->arena, stage, lam_arena_printf(p->arena, "distortion_%s", sheet->name), "",
                      sheet->max_stretch, sheet->mean_stretch, sheet->mesh.triangle_count);
  }
  p->model->print = print;
  lam_build_stage_end(p, stage);
  return true;
}
