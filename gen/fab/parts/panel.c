/* Plates and twisted panels on faces: outlines with gaps, solids, flat patterns, and which plates
 * are equal. Called by panels.c and support.c. */
#include "fab/parts/panel.h"

#include "core/numeric/fit.h"
#include "fab/flat/lettering.h"
#include "fab/mesh_fill.h"

#include <stdlib.h>

/* Cells of a twisted panel in each direction. */
enum { twisted_cells = 4 };

/* ---- the outline ---- */

/* An edge is found in each of its faces by the vertex from which the face runs along it. */
void lam_panel_neighbors(const lam_net *net, int (*neighbor)[4]) {
  for (int f = 0; f < net->mesh.face_count; f++)
    for (int k = 0; k < 4; k++) neighbor[f][k] = -1;
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      int f = net->edges[e].face[side], from = net->edges[e].vertex[side];
      if (f < 0) continue;
      for (int k = 0; k < 4; k++)
        if (net->mesh.faces[f][k] == from) neighbor[f][k] = net->edges[e].face[1 - side];
    }
}

/* The unit normal of a face along its side k: of the plane through the side and the middle of the
 * opposite side. */
static lam_vec3 normal_at(const lam_mesh *mesh, int face, int k) {
  const int *c = mesh->faces[face];
  const lam_vec3 *x = mesh->vertices;
  lam_vec3 a = x[c[k]], b = x[c[(k + 1) % 4]],
           m = lam_mix(x[c[(k + 2) % 4]], x[c[(k + 3) % 4]], 0.5);
  return lam_unit(lam_cross(lam_sub(b, a), lam_sub(m, a)));
}

/* How far the outline lies inside of side k, in meters: the inset d of the header, the larger one
 * of those for both sides of the plate. 0 at the boundary. A fold of nearly 180 degrees is held
 * at a cosine of .001. */
static double inset(const lam_mesh *mesh, const int (*neighbor)[4], int face, int k,
                    const lam_panel_layer *layer) {
  int other = neighbor[face][k], j = 0;
  if (other < 0) return 0;

  int from = mesh->faces[face][k], to = mesh->faces[face][(k + 1) % 4];
  while (j < 3 && mesh->faces[other][j] != to) j++;
  lam_vec3 along = lam_unit(lam_sub(mesh->vertices[to], mesh->vertices[from]));
  lam_vec3 own = normal_at(mesh, face, k), beyond = normal_at(mesh, other, j);

  double half = atan2(lam_dot(lam_cross(own, beyond), along), lam_dot(own, beyond)) / 2;
  double s = sin(half);
  return (layer->gap / 2 - fmin(layer->low * s, layer->high * s)) / fmax(cos(half), 1e-3);
}

/* Corner k of the quad x where its two sides are moved inward by own (side k) and before (side k
 * - 1). */
static lam_vec3 moved_corner(const lam_vec3 x[4], int k, double own, double before) {
  lam_vec3 u = lam_unit(lam_sub(x[(k + 1) % 4], x[k])), w = lam_unit(lam_sub(x[(k + 3) % 4], x[k]));

  double sine = fmax(lam_length(lam_cross(u, w)), 1e-6);
  return lam_along(lam_along(x[k], before / sine, u), own / sine, w);
}

/* Warp is the distance of the diagonals as lines; a flat panel is projected into the plane of
 * best fit before its sides are moved. */
bool lam_panel_make(const lam_net *net, const int (*neighbor)[4], int face,
                    const lam_panel_layer *layer, lam_panel *panel) {
  const lam_mesh *mesh = &net->mesh;
  lam_vec3 x[4], center;
  double spread[3];
  for (int k = 0; k < 4; k++) x[k] = mesh->vertices[mesh->faces[face][k]];

  lam_vec3 d1 = lam_sub(x[2], x[0]), d2 = lam_sub(x[3], x[1]), across = lam_cross(d1, d2);
  double doubled = lam_length(across);
  panel->diagonal = (lam_length(d1) + lam_length(d2)) / 2;
  if (!(doubled > 1e-9 * panel->diagonal * panel->diagonal)) return false;

  panel->warp = fabs(lam_dot(across, lam_sub(x[1], x[0]))) / doubled;
  panel->flat = panel->warp <= layer->tolerance * panel->diagonal;

  panel->normal = lam_fit_plane(x, 4, &center, spread);
  if (lam_dot(panel->normal, across) < 0) panel->normal = lam_scale(panel->normal, -1);
  if (panel->flat)
    for (int k = 0; k < 4; k++)
      x[k] = lam_along(x[k], -lam_dot(lam_sub(x[k], center), panel->normal), panel->normal);

  double d[4];
  for (int k = 0; k < 4; k++) d[k] = inset(mesh, neighbor, face, k, layer);
  for (int k = 0; k < 4; k++) panel->corner[k] = moved_corner(x, k, d[k], d[(k + 3) % 4]);

  /* Where the gaps are too wide a side turns around. */
  for (int k = 0; k < 4; k++) {
    lam_vec3 side = lam_sub(panel->corner[(k + 1) % 4], panel->corner[k]),
             old = lam_sub(x[(k + 1) % 4], x[k]);
    if (!(lam_dot(side, old) > 1e-3 * lam_dot(old, old))) return false;
  }
  return true;
}

/* ---- the solid ---- */

/* 0 or 1: the corner from which a diagonal splits the quad into two triangles that both face up.
 * At a reentrant corner the diagonal must start there, or at the opposite one. */
static int split_corner(const lam_panel *panel) {
  const lam_vec3 *x = panel->corner;
  for (int k = 1; k < 4; k += 2) {
    lam_vec3 turn = lam_cross(lam_sub(x[(k + 1) % 4], x[k]), lam_sub(x[(k + 3) % 4], x[k]));
    if (lam_dot(turn, panel->normal) <= 0) return 1;
  }
  return 0;
}

/* The quad a b c d, counterclockwise from above, on the upper side, and the same turned over on
 * the lower side, whose points are `down` further on. */
static void add_cell(lam_trimesh *mesh, int a, int b, int c, int d, int down) {
  lam_trimesh_quad(mesh, a, b, c, d);
  lam_trimesh_triangle(mesh, down + a, down + c, down + b);
  lam_trimesh_triangle(mesh, down + a, down + d, down + c);
}

/* The wall below the upper edge from -> to, with the panel on its left. */
static void add_wall(lam_trimesh *mesh, int from, int to, int down) {
  lam_trimesh_quad(mesh, from, down + from, down + to, to);
}

/* Eight corners: 0 to 3 above, 4 to 7 below. */
static lam_trimesh flat_solid(lam_arena *arena, const lam_panel *panel,
                              const lam_panel_layer *layer) {
  lam_trimesh mesh = lam_trimesh_empty(arena, 8, 12);
  int s = split_corner(panel);
  for (int k = 0; k < 4; k++) {
    mesh.vertices[k] = lam_along(panel->corner[k], layer->high, panel->normal);
    mesh.vertices[4 + k] = lam_along(panel->corner[k], layer->low, panel->normal);
  }

  add_cell(&mesh, s, s + 1, (s + 2) % 4, (s + 3) % 4, 4);
  for (int k = 0; k < 4; k++) add_wall(&mesh, k, (k + 1) % 4, 4);
  return mesh;
}

/* The point of the bilinear patch and its unit normal x_u x x_v, with
 *   x(u,v) = (1-u)(1-v) x0 + u (1-v) x1 + u v x2 + (1-u) v x3.
 * Where the patch folds over, the normal of the plane of best fit takes its place. */
static lam_vec3 bilinear(const lam_panel *panel, double u, double v, lam_vec3 *normal) {
  const lam_vec3 *x = panel->corner;
  lam_vec3 low = lam_mix(x[0], x[1], u), high = lam_mix(x[3], x[2], u);
  lam_vec3 along = lam_mix(lam_sub(x[1], x[0]), lam_sub(x[2], x[3]), v);
  lam_vec3 n = lam_unit(lam_cross(along, lam_sub(high, low)));
  *normal = lam_dot(n, panel->normal) > 0 ? n : panel->normal;
  return lam_mix(low, high, v);
}

/* The patch in n x n cells: all upper points first, row by row, then all lower ones. */
static lam_trimesh twisted_solid(lam_arena *arena, const lam_panel *panel,
                                 const lam_panel_layer *layer) {
  enum { n = twisted_cells, row = n + 1, points = row * row };
  lam_trimesh mesh = lam_trimesh_empty(arena, 2 * points, 4 * n * n + 8 * n);
  for (int i = 0; i < row; i++)
    for (int j = 0; j < row; j++) {
      lam_vec3 normal, x = bilinear(panel, (double)i / n, (double)j / n, &normal);
      mesh.vertices[i * row + j] = lam_along(x, layer->high, normal);
      mesh.vertices[points + i * row + j] = lam_along(x, layer->low, normal);
    }

  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      int a = i * row + j;
      add_cell(&mesh, a, a + row, a + row + 1, a + 1, points);
    }

  for (int i = 0; i < n; i++) {
    add_wall(&mesh, i * row, (i + 1) * row, points);
    add_wall(&mesh, n * row + i, n * row + i + 1, points);
    add_wall(&mesh, (i + 1) * row + n, i * row + n, points);
    add_wall(&mesh, i + 1, i, points);
  }
  return mesh;
}

lam_trimesh lam_panel_solid(lam_arena *arena, const lam_panel *panel,
                            const lam_panel_layer *layer) {
  return panel->flat ? flat_solid(arena, panel, layer) : twisted_solid(arena, panel, layer);
}

/* ---- the flat pattern ---- */

/* The outline in the plane of the panel: the first corner at the origin, the second on the x
 * axis. */
static void panel_outline(const lam_panel *panel, lam_vec2 outline[4]) {
  lam_vec3 x = lam_unit(lam_sub(panel->corner[1], panel->corner[0])),
           y = lam_cross(panel->normal, x);
  for (int k = 0; k < 4; k++) {
    lam_vec3 p = lam_sub(panel->corner[k], panel->corner[0]);
    outline[k] = lam_v2(lam_dot(p, x), lam_dot(p, y));
  }
}

/* Whether a box around the middle keeps the margin from all sides of a convex outline. */
static bool has_room(const lam_vec2 outline[4], lam_vec2 middle, double width, double height,
                     double margin) {
  for (int k = 0; k < 4; k++) {
    lam_vec2 a = outline[k], b = outline[(k + 1) % 4];
    double length = hypot(b.x - a.x, b.y - a.y), nx = -(b.y - a.y) / length,
           ny = (b.x - a.x) / length;
    double inside = (middle.x - a.x) * nx + (middle.y - a.y) * ny;
    if (inside - fabs(nx) * width / 2 - fabs(ny) * height / 2 < margin) return false;
  }
  return true;
}

/* The name in the middle of the outline, at the largest height that has room; none when even
 * 1/200 of the size has none. */
static void add_name(lam_paths *paths, const lam_vec2 outline[4], const char *name, double size) {
  lam_vec2 middle = {0, 0};
  for (int k = 0; k < 4; k++)
    middle = lam_v2(middle.x + outline[k].x / 4, middle.y + outline[k].y / 4);

  double least = size / 200;
  for (double height = fmin(size / 8, 0.05); height > least; height *= 0.8) {
    double width = lam_lettering_width(name, height);
    if (!has_room(outline, middle, width, height, height / 2)) continue;
    lam_lettering_add(paths, LAM_LAYER_LABEL, name,
                      lam_v2(middle.x - width / 2, middle.y - height / 2), 0, height);
    return;
  }
}

/* The outline is cut; the name is sized by the diagonal. */
lam_flat *lam_panel_flat(lam_arena *arena, const lam_panel *panel, const lam_panel_layer *layer,
                         const char *name) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_vec2 outline[4];
  panel_outline(panel, outline);
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4, outline);
  add_name(&paths, outline, name, panel->diagonal);

  flat->thickness = layer->high - layer->low;
  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* ---- equal plates ---- */

static const double same_length = 1e-4; /* meters */

/* A flat panel by its lengths: the four sides in turn, their sum, and the two diagonals. They
 * determine a quad up to reflection. */
typedef struct measured_panel {
  int index;
  double around, side[4], diagonal[2];
} measured_panel;

/* For qsort: by the length around, then by the index. */
static int by_size(const void *a, const void *b) {
  const measured_panel *p = a, *q = b;
  if (p->around != q->around) return p->around < q->around ? -1 : 1;
  return p->index - q->index;
}

/* Whether p agrees with q when the outline of q is begun at corner `start` and read forwards (way
 * 1) or backwards (way -1). Backwards the side before the corner comes first. */
static bool agree(const measured_panel *p, const measured_panel *q, int start, int way) {
  for (int k = 0; k < 4; k++) {
    int j = way > 0 ? (start + k) % 4 : (start + 7 - k) % 4;
    if (fabs(p->side[k] - q->side[j]) > same_length) return false;
  }
  for (int k = 0; k < 2; k++)
    if (fabs(p->diagonal[k] - q->diagonal[(start + k) % 2]) > same_length) return false;
  return true;
}

/* Whether two panels are the same plate in any position, turned over or not. */
static bool same_plate(const measured_panel *p, const measured_panel *q) {
  for (int start = 0; start < 4; start++)
    if (agree(p, q, start, 1) || agree(p, q, start, -1)) return true;
  return false;
}

/* Measures the flat ones of the panels and sorts them by size. measured has room for count;
 * returns how many there are. */
static int measure(const lam_panel *panels, int count, measured_panel *measured) {
  int n = 0;
  for (int i = 0; i < count; i++) {
    const lam_vec3 *x = panels[i].corner;
    measured_panel *m = &measured[n];
    if (!panels[i].flat) continue;

    *m = (measured_panel){.index = i,
                          .diagonal = {lam_distance(x[0], x[2]), lam_distance(x[1], x[3])}};
    for (int k = 0; k < 4; k++) m->around += m->side[k] = lam_distance(x[k], x[(k + 1) % 4]);
    n++;
  }

  qsort(measured, (size_t)n, sizeof *measured, by_size);
  return n;
}

/* Samples are the first panels of each class in the order of sizes; only those of nearly the same
 * length around can agree, and they follow from `from` on. Classes are numbered afterwards, in
 * the order of the panels. */
int lam_panel_classes(lam_arena *arena, const lam_panel *panels, int count, int first, int *class) {
  measured_panel *measured = LAM_NEW(arena, measured_panel, count);
  int n = measure(panels, count, measured), *sample = LAM_NEW(arena, int, n),
      *of = LAM_NEW(arena, int, count);
  int *number = LAM_NEW(arena, int, n), samples = 0, from = 0, classes = 0;

  for (int i = 0; i < n; i++) {
    int s = samples;
    while (from < samples && measured[i].around - measured[sample[from]].around > 4 * same_length)
      from++;

    for (int k = from; k < samples && s == samples; k++)
      if (same_plate(&measured[i], &measured[sample[k]])) s = k;
    if (s == samples) sample[samples++] = i;
    of[measured[i].index] = s + 1;
  }

  for (int i = 0; i < count; i++) {
    class[i] = 0;
    if (!of[i]) continue;
    if (!number[of[i] - 1]) number[of[i] - 1] = ++classes;
    class[i] = first + number[of[i] - 1] - 1;
  }
  return classes;
}
