#include "surf/flatten/texture.h"
#include "surf/flatten/flatten.h"

#include <string.h>

const char *const lam_print_layout_names[] = {"flattening", "parameters", "compare", NULL};

enum { picture_size = 1024 };

/* The part of the plane that the picture covers. */
typedef struct frame {
  lam_vec2 middle;
  double size;
} frame;

/* A square around both layouts. */
static frame frame_around(int count, const lam_vec2 *a, const lam_vec2 *b) {
  lam_vec2 low = a[0], high = a[0];
  for (int i = 0; i < 2 * count; i++) {
    lam_vec2 p = i < count ? a[i] : b[i - count];
    low = (lam_vec2){fmin(low.x, p.x), fmin(low.y, p.y)};
    high = (lam_vec2){fmax(high.x, p.x), fmax(high.y, p.y)};
  }
  lam_vec2 middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  return (frame){middle, fmax(high.x - low.x, high.y - low.y)};
}

static const lam_vec2 *places_in(lam_arena *arena, frame f, int count, const lam_vec2 *layout) {
  lam_vec2 *places = LAM_NEW(arena, lam_vec2, count);
  for (int i = 0; i < count; i++)
    places[i] = (lam_vec2){0.5 + (layout[i].x - f.middle.x) / f.size,
                           0.5 + (layout[i].y - f.middle.y) / f.size};
  return places;
}

/* On the color scale from 1 to `most`: the mean ratio of the triangles around a vertex. */
static const lam_vec2 *places_on_scale(lam_arena *arena, const lam_flat_mesh *mesh,
                                       const lam_vec2 *layout, double most) {
  int n = mesh->vertex_count, *around = LAM_NEW(arena, int, n);
  double *ratios = LAM_NEW(arena, double, mesh->triangle_count), margin = 0.5 / picture_size;
  lam_vec2 *places = LAM_NEW(arena, lam_vec2, n);
  lam_flat_anisotropy(mesh, layout, ratios);
  for (int t = 0; t < mesh->triangle_count; t++)
    for (int k = 0; k < 3; k++) {
      places[mesh->triangles[t][k]].x += ratios[t];
      around[mesh->triangles[t][k]]++;
    }
  for (int v = 0; v < n; v++) {
    double share = most > 1 ? (places[v].x / around[v] - 1) / (most - 1) : 0;
    places[v] = (lam_vec2){margin + (1 - 2 * margin) * share, 0.5};
  }
  return places;
}

static lam_printed printed(const char *name, const lam_flat_mesh *mesh, lam_vec3 *vertices,
                           const lam_vec2 *places) {
  lam_printed sheet = {.name = name, .places = places};
  /* a solid's triangles are not written to after it is made */
  sheet.mesh =
      (lam_trimesh){mesh->vertex_count, vertices, mesh->triangle_count, (int(*)[3])mesh->triangles};
  return sheet;
}

static void measure(lam_arena *arena, const lam_flat_mesh *mesh, const lam_vec2 *layout,
                    lam_printed *sheet) {
  double *ratios = LAM_NEW(arena, double, mesh->triangle_count);
  sheet->max_stretch = lam_flat_anisotropy(mesh, layout, ratios);
  sheet->mean_stretch = 0;
  for (int t = 0; t < mesh->triangle_count; t++)
    sheet->mean_stretch += ratios[t] / mesh->triangle_count;
}

static void bounds(int count, const lam_vec3 *x, lam_vec3 *low, lam_vec3 *high) {
  *low = *high = x[0];
  for (int i = 1; i < count; i++) {
    *low = lam_v3(fmin(low->x, x[i].x), fmin(low->y, x[i].y), fmin(low->z, x[i].z));
    *high = lam_v3(fmax(high->x, x[i].x), fmax(high->y, x[i].y), fmax(high->z, x[i].z));
  }
}

static lam_vec3 *moved(lam_arena *arena, int count, const lam_vec3 *x, lam_vec3 by) {
  lam_vec3 *to = LAM_NEW(arena, lam_vec3, count);
  for (int i = 0; i < count; i++) to[i] = lam_add(x[i], by);
  return to;
}

lam_print *lam_print_make(lam_arena *arena, const lam_spline_surface *surface, lam_motif motif,
                          lam_print_layout layout, int cells) {
  lam_print *print = LAM_NEW(arena, lam_print, 1);
  lam_flat_mesh *mesh = LAM_NEW(arena, lam_flat_mesh, 1);
  *mesh = lam_flat_grid(arena, surface, cells, LAM_FLAT_GEODESICS);
  lam_flattening flattening = lam_flatten(arena, mesh);
  int n = mesh->vertex_count;
  lam_vec2 *flat = LAM_NEW(arena, lam_vec2, n);
  memcpy(flat, flattening.points, (size_t)n * sizeof *flat);
  lam_flat_align(n, mesh->start, flat);
  frame f = frame_around(n, mesh->start, flat);
  lam_vec2 corner = mesh->start[n - 1];
  const lam_vec2 *layouts[2] = {flat, mesh->start}, *places[2];
  f.middle =
      (lam_vec2){corner.x / 2, corner.y / 2}; /* of the letter: the middle of the rectangle */
  f.size *= 1.25;                             /* the layouts need not be centered there */
  double most = 1;
  for (int k = 0; k < 2; k++)
    if (layout == LAM_PRINT_COMPARE || (int)layout == k)
      most = fmax(most, lam_flat_anisotropy(mesh, layouts[k], NULL));
  for (int k = 0; k < 2; k++)
    places[k] = motif == LAM_MOTIF_DISTORTION ? places_on_scale(arena, mesh, layouts[k], most)
                                              : places_in(arena, f, n, layouts[k]);
  print->width = print->height = picture_size;
  print->pixels = lam_motif_draw(arena, motif, corner.x / f.size, corner.y / f.size, picture_size);
  static const char *const names[2] = {"flattening", "parameters"}, *const flat_names[2] = {
                                                                        "flattening-flat",
                                                                        "parameters-flat"};
  lam_printed *sheets = LAM_NEW(arena, lam_printed, 4);
  lam_vec3 low, high;
  bounds(n, mesh->vertices, &low, &high);
  double gap = 0.15 * (high.x - low.x);
  for (int k = 0; k < 2; k++) {
    if (layout != LAM_PRINT_COMPARE && (int)layout != k) continue;
    lam_vec3 by =
        lam_v3(k && layout == LAM_PRINT_COMPARE ? fmax(high.x - low.x, corner.x) + gap : 0, 0, 0);
    lam_printed *sheet = &sheets[print->count++];
    *sheet = printed(names[k], mesh, moved(arena, n, mesh->vertices, by), places[k]);
    measure(arena, mesh, layouts[k], sheet);
    if (layout != LAM_PRINT_COMPARE) continue;
    lam_vec3 *lying = LAM_NEW(arena, lam_vec3, n), lying_low, lying_high;
    for (int v = 0; v < n; v++) lying[v] = lam_v3(flat[v].x, flat[v].y, 0);
    bounds(n, lying, &lying_low, &lying_high);
    lam_vec3 to = lam_v3((low.x + high.x - lying_low.x - lying_high.x) / 2,
                         low.y - gap - lying_high.y, low.z + 2e-3 * f.size);
    sheets[print->count] =
        printed(flat_names[k], mesh, moved(arena, n, lying, lam_add(by, to)), places[k]);
    sheets[print->count].max_stretch = sheet->max_stretch;
    sheets[print->count++].mean_stretch = sheet->mean_stretch;
  }
  print->sheets = sheets;
  return print;
}
