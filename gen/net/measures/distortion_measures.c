/* How much a net is drawn out against a picture of it in the plane: the flattened net, or a
 * rectangle of even cells. In the middle of a face the map takes the medians of the flat face to
 * those in space. Rows of the list in net/measures/measure.c; measure.c and measure_map.c ask for
 * the pictures (layout.h). */
#include "core/solid/triangles.h"
#include "net/measures/layout.h"
#include "net/measures/measuring.h"
#include "surf/flatten/flatten.h"

#include <string.h>

/* ---- the net laid flat ---- */

static const lam_vec2 *evenly_spaced(const lam_measuring *in);

/* The vertices of the flattened net in in->arena, turned like the rectangle where there is one,
 * so that the pictures can be compared; NULL: the net is no disk. */
static const lam_vec2 *flattened(const lam_measuring *in) {
  const lam_net *net = in->net;
  int n = net->mesh.vertex_count;
  lam_mesh mesh = net->mesh;
  lam_flat_mesh disk;
  mesh.vertices = LAM_NEW(in->arena, lam_vec3, n);
  memcpy(mesh.vertices, in->positions, (size_t)n * sizeof *mesh.vertices);
  const lam_vec3 *normals = lam_measuring_normals(in);
  lam_trimesh triangles = lam_mesh_triangles(in->arena, &mesh);
  if (!lam_flat_disk(in->arena, n, mesh.vertices, normals, triangles.triangle_count,
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

/* Writes the index of every vertex along its polyline of a family, and the number of vertices of
 * these lines; false unless all of them are open, of one length, and meet every vertex once. */
static bool indices_along(const lam_net *net, int family, int *index, int *count) {
  *count = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++) index[v] = -1;

  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->family != family) continue;
    if (line->closed || (*count && line->count != *count)) return false;
    *count = line->count;
    for (int k = 0; k < line->count; k++) {
      if (index[line->vertices[k]] >= 0) return false;
      index[line->vertices[k]] = k;
    }
  }

  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (index[v] < 0) return false;
  return true;
}

/* Whether every line of the other family keeps one index along the lines of this one. */
static bool is_crossed_in_order(const lam_net *net, int family, const int *index) {
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    for (int k = 1; line->family == 1 - family && k < line->count; k++)
      if (index[line->vertices[k]] != index[line->vertices[0]]) return false;
  }
  return true;
}

/* Mean length of the first and the last line of a family, those with the index 0 and `last` along
 * the other one. */
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

/* The vertices on a rectangle of even cells with the mean lengths of the net's opposite sides, in
 * in->arena; NULL: the net is no grid. */
static const lam_vec2 *evenly_spaced(const lam_measuring *in) {
  const lam_net *net = in->net;
  int *index[2], count[2];
  for (int d = 0; d < 2; d++) {
    index[d] = LAM_NEW(in->arena, int, net->mesh.vertex_count);
    if (!indices_along(net, d, index[d], &count[d]) || !is_crossed_in_order(net, d, index[d]))
      return NULL;
  }
  if (count[0] * count[1] != net->mesh.vertex_count) return NULL;

  double cell[2];
  for (int d = 0; d < 2; d++)
    cell[d] = side_length(in, d, index[1 - d], count[1 - d] - 1) / (count[d] - 1);
  lam_vec2 *layout = LAM_NEW(in->arena, lam_vec2, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    layout[v] = (lam_vec2){cell[0] * index[0][v], cell[1] * index[1][v]};
  return layout;
}

/* ---- singular values ---- */

/* A picture of the net: vertex_count points, or NULL. */
typedef const lam_vec2 *layout_of(const lam_measuring *in);

/* The singular values of the map from the flat face f to the face, in its middle: p and q are the
 * medians of the flat face along and across, a and b those of the face. */
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

/* One figure of the singular values for every face; undefined when there is no picture. */
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

/* The rows of the list: name, picture in the plane, figure of the singular values, words. */
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

/* What layout.h tells of the measures. Measures with one word in scale share their colors. */
static const struct {
  const lam_measure_kind *kind;
  layout_of *layout;
  const char *scale;
} pictures[] = {{&lam_measure_flattening_distortion, flattened, "distortion"},
                {&lam_measure_flattening_stretch, flattened, "stretch"},
                {&lam_measure_flattening_compression, flattened, "stretch"},
                {&lam_measure_parameter_distortion, evenly_spaced, "distortion"},
                {&lam_measure_parameter_stretch, evenly_spaced, "stretch"},
                {&lam_measure_parameter_compression, evenly_spaced, "stretch"}};
enum { picture_count = sizeof pictures / sizeof *pictures };

/* Three look-ups of the table: measures that are not in it have no picture. */
const lam_vec2 *lam_measure_layout(const lam_measure_kind *kind, const lam_measuring *in) {
  for (int i = 0; i < picture_count; i++)
    if (pictures[i].kind == kind) return pictures[i].layout(in);
  return NULL;
}

bool lam_measure_is_slow(const lam_measure_kind *kind) {
  for (int i = 0; i < picture_count; i++)
    if (pictures[i].kind == kind) return pictures[i].layout == flattened;
  return false;
}

const char *lam_measure_scale(const lam_measure_kind *kind) {
  for (int i = 0; i < picture_count; i++)
    if (pictures[i].kind == kind) return pictures[i].scale;
  return NULL;
}
