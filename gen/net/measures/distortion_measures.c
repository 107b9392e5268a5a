/* How much a net is drawn out against a picture of it in the plane: the flattened net, or a
 * rectangle of even cells. In the middle of a face the map takes the medians of the flat face to
 * those in space. */
#include "core/solid/triangles.h"
#include "net/measures/layout.h"
#include "surf/flatten/flatten.h"

#include <string.h>

/* ---- the net laid flat ---- */

static const lam_vec2 *evenly_spaced(const lam_measuring *in);

/* Turned like the rectangle, so that the pictures can be compared. */
static const lam_vec2 *flattened(const lam_measuring *in) {
  const lam_net *net = in->net;
  int n = net->mesh.vertex_count;
  lam_mesh placed = net->mesh;
  lam_flat_mesh disk;
  lam_vec3 *normals = LAM_NEW(in->arena, lam_vec3, n);
  placed.vertices = LAM_NEW(in->arena, lam_vec3, n);
  memcpy(placed.vertices, in->positions, (size_t)n * sizeof *placed.vertices);
  lam_net_normals(net, in->positions, normals);
  lam_trimesh triangles = lam_mesh_triangles(in->arena, &placed);
  if (!lam_flat_disk(in->arena, n, placed.vertices, normals, triangles.triangle_count,
                     (const int(*)[3])triangles.triangles, &disk))
    return NULL;
  const lam_vec2 *points = lam_flatten(in->arena, &disk).points, *rectangle = evenly_spaced(in);
  if (!rectangle) return points;
  lam_vec2 *turned = LAM_NEW(in->arena, lam_vec2, n);
  memcpy(turned, points, (size_t)n * sizeof *turned);
  lam_flat_align(n, rectangle, turned);
  return turned;
}

/* ---- a rectangle of even cells ---- */

/* Writes the place of every vertex on its polyline of a family; false unless all lines are open and
 * of one length. */
static bool places_along(const lam_net *net, int family, int *place, int *count) {
  *count = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++) place[v] = -1;
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->family != family) continue;
    if (line->closed || (*count && line->count != *count)) return false;
    *count = line->count;
    for (int k = 0; k < line->count; k++) {
      if (place[line->vertices[k]] >= 0) return false;
      place[line->vertices[k]] = k;
    }
  }
  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (place[v] < 0) return false;
  return true;
}

/* Whether every line of the other family stays at one place. */
static bool is_crossed(const lam_net *net, int family, const int *place) {
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    for (int k = 1; line->family == 1 - family && k < line->count; k++)
      if (place[line->vertices[k]] != place[line->vertices[0]]) return false;
  }
  return true;
}

/* Mean length of the first and the last line of a family. */
static double side_length(const lam_measuring *in, int family, const int *across, int last) {
  double sum = 0;
  for (int l = 0; l < in->net->polyline_count; l++) {
    const lam_polyline *line = &in->net->polylines[l];
    if (line->family != family || (across[line->vertices[0]] && across[line->vertices[0]] != last))
      continue;
    for (int k = 1; k < line->count; k++)
      sum +=
          lam_distance(in->positions[line->vertices[k - 1]], in->positions[line->vertices[k]]) / 2;
  }
  return sum;
}

static const lam_vec2 *evenly_spaced(const lam_measuring *in) {
  const lam_net *net = in->net;
  int *place[2], count[2];
  for (int d = 0; d < 2; d++) {
    place[d] = LAM_NEW(in->arena, int, net->mesh.vertex_count);
    if (!places_along(net, d, place[d], &count[d]) || !is_crossed(net, d, place[d])) return NULL;
  }
  if (count[0] * count[1] != net->mesh.vertex_count) return NULL;
  double cell[2];
  for (int d = 0; d < 2; d++)
    cell[d] = side_length(in, d, place[1 - d], count[1 - d] - 1) / (count[d] - 1);
  lam_vec2 *layout = LAM_NEW(in->arena, lam_vec2, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    layout[v] = (lam_vec2){cell[0] * place[0][v], cell[1] * place[1][v]};
  return layout;
}

/* ---- singular values ---- */

typedef const lam_vec2 *layout_of(const lam_measuring *in);

static lam_vec2 stretch_of(const lam_measuring *in, const lam_vec2 *flat, int f) {
  const int *c = in->net->mesh.faces[f];
  lam_vec2 p = {0}, q = {0};
  lam_vec3 a = {0}, b = {0};
  for (int k = 0; k < 4; k++) {
    double along = k == 1 || k == 2 ? 0.5 : -0.5, across = k < 2 ? -0.5 : 0.5;
    p = (lam_vec2){p.x + along * flat[c[k]].x, p.y + along * flat[c[k]].y};
    q = (lam_vec2){q.x + across * flat[c[k]].x, q.y + across * flat[c[k]].y};
    a = lam_along(a, along, in->positions[c[k]]);
    b = lam_along(b, across, in->positions[c[k]]);
  }
  return lam_flat_stretch(p, q, a, b);
}

static void stretches(const lam_measuring *in, layout_of *layout, double (*of)(lam_vec2 stretch),
                      double *values) {
  const lam_vec2 *flat = layout(in);
  for (int f = 0; flat && f < in->net->mesh.face_count; f++)
    values[f] = of(stretch_of(in, flat, f));
}

static double ratio(lam_vec2 s) { return s.x / s.y; }
static double larger(lam_vec2 s) { return s.x; }
static double smaller(lam_vec2 s) { return s.y; }

#define FROM_PATTERN " of the map from the flattened net to the net, on a face"
#define FROM_RECTANGLE                                                                             \
  " of the map from a rectangle of even cells, with the mean lengths of opposite sides, to the "   \
  "net, on a face"

/* name, plane picture, figure, words: the rows of the list. */
#define ROW(row, of_plane, figure, words)                                                          \
  static void row(const lam_measuring *in, double *values) {                                       \
    stretches(in, of_plane, figure, values);                                                       \
  }                                                                                                \
  const lam_measure_kind lam_measure_##row = {#row, "", words, LAM_ON_FACES, row};

ROW(flattening_distortion, flattened, ratio, "ratio of the singular values" FROM_PATTERN)
ROW(flattening_stretch, flattened, larger, "larger singular value" FROM_PATTERN)
ROW(flattening_compression, flattened, smaller, "smaller singular value" FROM_PATTERN)
ROW(parameter_distortion, evenly_spaced, ratio, "ratio of the singular values" FROM_RECTANGLE)
ROW(parameter_stretch, evenly_spaced, larger, "larger singular value" FROM_RECTANGLE)
ROW(parameter_compression, evenly_spaced, smaller, "smaller singular value" FROM_RECTANGLE)

static const struct {
  const lam_measure_kind *kind;
  layout_of *layout;
  const char *scale;
} planes[] = {{&lam_measure_flattening_distortion, flattened, "distortion"},
              {&lam_measure_flattening_stretch, flattened, "stretch"},
              {&lam_measure_flattening_compression, flattened, "stretch"},
              {&lam_measure_parameter_distortion, evenly_spaced, "distortion"},
              {&lam_measure_parameter_stretch, evenly_spaced, "stretch"},
              {&lam_measure_parameter_compression, evenly_spaced, "stretch"}};
enum { plane_count = sizeof planes / sizeof *planes };

const lam_vec2 *lam_measure_layout(const lam_measure_kind *kind, const lam_measuring *in) {
  for (int i = 0; i < plane_count; i++)
    if (planes[i].kind == kind) return planes[i].layout(in);
  return NULL;
}

bool lam_measure_is_slow(const lam_measure_kind *kind) {
  for (int i = 0; i < plane_count; i++)
    if (planes[i].kind == kind) return planes[i].layout == flattened;
  return false;
}

const char *lam_measure_scale(const lam_measure_kind *kind) {
  for (int i = 0; i < plane_count; i++)
    if (planes[i].kind == kind) return planes[i].scale;
  return NULL;
}
