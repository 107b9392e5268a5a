/* Prints a picture on a surface through its flattening or through its parameters, and measures
 * how much it is drawn out. Called by the pipeline of design/. */
#include "surf/flatten/texture.h"
#include "surf/flatten/flatten.h"

#include <string.h>

const char *const lam_print_layout_names[] = {"flattening", "parameters", "compare", NULL};

/* Pixels along a side of the picture. */
enum { PICTURE_SIZE = 1024 };

/* The part of the plane that the picture covers. */
typedef struct frame {
  lam_vec2 middle;
  double size;
} frame;

/* A square around both layouts of count points. */
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

/* Where points of the plane are on the picture, 0 to 1 from its lower left corner. */
static const lam_vec2 *coordinates_in(lam_arena *arena, frame f, int count,
                                      const lam_vec2 *layout) {
  lam_vec2 *coordinates = LAM_NEW(arena, lam_vec2, count);
  for (int i = 0; i < count; i++)
    coordinates[i] = (lam_vec2){0.5 + (layout[i].x - f.middle.x) / f.size,
                                0.5 + (layout[i].y - f.middle.y) / f.size};
  return coordinates;
}

/* On the color scale from 1 to `most`: the mean ratio of the triangles around a vertex, half a
 * pixel inside of the ends. */
static const lam_vec2 *coordinates_on_scale(lam_arena *arena, const lam_flat_mesh *mesh,
                                            const lam_vec2 *layout, double most) {
  int n = mesh->vertex_count, *around = LAM_NEW(arena, int, n);
  double *ratios = LAM_NEW(arena, double, mesh->triangle_count), margin = 0.5 / PICTURE_SIZE;
  lam_vec2 *coordinates = LAM_NEW(arena, lam_vec2, n);
  lam_flat_anisotropy(mesh, layout, ratios);

  for (int t = 0; t < mesh->triangle_count; t++)
    for (int k = 0; k < 3; k++) {
      coordinates[mesh->triangles[t][k]].x += ratios[t];
      around[mesh->triangles[t][k]]++;
    }

  for (int v = 0; v < n; v++) {
    double share = most > 1 ? (coordinates[v].x / around[v] - 1) / (most - 1) : 0;
    coordinates[v] = (lam_vec2){margin + (1 - 2 * margin) * share, 0.5};
  }
  return coordinates;
}

/* A sheet: the mesh with other vertices, and where these are on the picture. */
static lam_printed printed(const char *name, const lam_flat_mesh *mesh, lam_vec3 *vertices,
                           const lam_vec2 *coordinates) {
  lam_printed sheet = {.name = name, .texture = coordinates};

  /* The type has no const, but nobody writes to a sheet's triangles. */
  sheet.mesh =
      (lam_trimesh){mesh->vertex_count, vertices, mesh->triangle_count, (int(*)[3])mesh->triangles};
  return sheet;
}

/* The largest and the mean ratio of singular values of a layout. */
static void measure(lam_arena *arena, const lam_flat_mesh *mesh, const lam_vec2 *layout,
                    lam_printed *sheet) {
  double *ratios = LAM_NEW(arena, double, mesh->triangle_count);
  sheet->max_stretch = lam_flat_anisotropy(mesh, layout, ratios);
  sheet->mean_stretch = 0;
  for (int t = 0; t < mesh->triangle_count; t++)
    sheet->mean_stretch += ratios[t] / mesh->triangle_count;
}

/* The box around count points. */
static void bounds(int count, const lam_vec3 *x, lam_vec3 *low, lam_vec3 *high) {
  *low = *high = x[0];
  for (int i = 1; i < count; i++) {
    *low = lam_v3(fmin(low->x, x[i].x), fmin(low->y, x[i].y), fmin(low->z, x[i].z));
    *high = lam_v3(fmax(high->x, x[i].x), fmax(high->y, x[i].y), fmax(high->z, x[i].z));
  }
}

/* The points, moved. */
static lam_vec3 *moved(lam_arena *arena, int count, const lam_vec3 *x, lam_vec3 by) {
  lam_vec3 *to = LAM_NEW(arena, lam_vec3, count);
  for (int i = 0; i < count; i++) to[i] = lam_add(x[i], by);
  return to;
}

/* What the sheets of a print have in common. [0] is the layout by flattening, [1] by
 * parameters. */
typedef struct printing {
  lam_arena *arena;
  const lam_flat_mesh *mesh;
  bool compare; /* both layouts, and each of them laid flat */
  frame frame;
  const lam_vec2 *layouts[2], *coordinates[2];
  lam_vec2 corner;    /* of the rectangle of the parameters that begins at the origin */
  lam_vec3 low, high; /* of the surface */
  double gap;         /* between sheets, m */
} printing;

/* Whether the print shows layout k. */
static bool shows(lam_print_layout layout, int k) {
  return layout == LAM_PRINT_COMPARE || (int)layout == k;
}

/* The part of the plane that the picture covers. Its middle is that of the rectangle, where the
 * letter stands; the layouts need not be centered there, so it is a quarter larger than they
 * are. */
static frame picture_frame(const printing *p) {
  frame f = frame_around(p->mesh->vertex_count, p->mesh->start, p->layouts[0]);
  f.middle = (lam_vec2){p->corner.x / 2, p->corner.y / 2};
  f.size *= 1.25;
  return f;
}

/* Coordinates on the picture: of the layouts, or on the color scale that all sheets share. */
static void find_coordinates(printing *p, lam_motif motif, lam_print_layout layout) {
  double most = 1;
  for (int k = 0; k < 2; k++)
    if (shows(layout, k)) most = fmax(most, lam_flat_anisotropy(p->mesh, p->layouts[k], NULL));

  for (int k = 0; k < 2; k++)
    p->coordinates[k] =
        motif == LAM_MOTIF_DISTORTION
            ? coordinates_on_scale(p->arena, p->mesh, p->layouts[k], most)
            : coordinates_in(p->arena, p->frame, p->mesh->vertex_count, p->layouts[k]);
}

/* The flattened surface with the print of layout k, in front of the surface and moved by
 * `by`. */
static lam_printed lying_sheet(const printing *p, int k, lam_vec3 by) {
  static const char *const names[2] = {"flattening-flat", "parameters-flat"};
  const lam_vec2 *flat = p->layouts[0];
  int n = p->mesh->vertex_count;
  lam_vec3 *lying = LAM_NEW(p->arena, lam_vec3, n), low, high;
  for (int v = 0; v < n; v++) lying[v] = lam_v3(flat[v].x, flat[v].y, 0);
  bounds(n, lying, &low, &high);

  lam_vec3 to = lam_v3((p->low.x + p->high.x - low.x - high.x) / 2, p->low.y - p->gap - high.y,
                       p->low.z + 2e-3 * p->frame.size);
  return printed(names[k], p->mesh, moved(p->arena, n, lying, lam_add(by, to)), p->coordinates[k]);
}

/* The sheets of layout k, appended to sheets: the surface, beside the other one where both are
 * shown, and then the same print laid flat. Returns their number. */
static int add_sheets(const printing *p, int k, lam_printed *sheets) {
  static const char *const names[2] = {"flattening", "parameters"};
  const lam_flat_mesh *mesh = p->mesh;
  lam_vec3 by =
      lam_v3(k && p->compare ? fmax(p->high.x - p->low.x, p->corner.x) + p->gap : 0, 0, 0);
  sheets[0] = printed(names[k], mesh, moved(p->arena, mesh->vertex_count, mesh->vertices, by),
                      p->coordinates[k]);
  measure(p->arena, mesh, p->layouts[k], &sheets[0]);
  if (!p->compare) return 1;

  sheets[1] = lying_sheet(p, k, by);
  sheets[1].max_stretch = sheets[0].max_stretch;
  sheets[1].mean_stretch = sheets[0].mean_stretch;
  return 2;
}

/* The grid is flattened and turned to lie on the rectangle; then the picture, then the sheets. */
lam_print *lam_print_make(lam_arena *arena, const lam_spline_surface *surface, lam_motif motif,
                          lam_print_layout layout, int cells) {
  lam_flat_mesh *mesh = LAM_NEW(arena, lam_flat_mesh, 1);
  *mesh = lam_flat_grid(arena, surface, cells, LAM_FLAT_GEODESICS);
  lam_flattening flattening = lam_flatten(arena, mesh);
  int n = mesh->vertex_count;
  lam_vec2 *flat = LAM_NEW(arena, lam_vec2, n);
  memcpy(flat, flattening.points, (size_t)n * sizeof *flat);
  lam_flat_align(n, mesh->start, flat);

  printing p = {.arena = arena,
                .mesh = mesh,
                .compare = layout == LAM_PRINT_COMPARE,
                .layouts = {flat, mesh->start},
                .corner = mesh->start[n - 1]};
  p.frame = picture_frame(&p);
  find_coordinates(&p, motif, layout);
  bounds(n, mesh->vertices, &p.low, &p.high);
  p.gap = 0.15 * (p.high.x - p.low.x);

  lam_print *print = LAM_NEW(arena, lam_print, 1);
  print->width = print->height = PICTURE_SIZE;
  print->pixels = lam_motif_draw(arena, motif, p.corner.x / p.frame.size, p.corner.y / p.frame.size,
                                 PICTURE_SIZE);
  lam_printed *sheets = LAM_NEW(arena, lam_printed, 4);
  for (int k = 0; k < 2; k++)
    if (shows(layout, k)) print->count += add_sheets(&p, k, sheets + print->count);
  print->sheets = sheets;
  return print;
}
