/* Color maps as glTF binaries (plots/MEASURE.glb; listed in formats/list/formats.c): the net with
 * vertex colors, in meters, y up through the root's matrix. Values of faces are flat colors (a
 * face has its own four vertices), values of edges colored lines. The range is in the extras. A
 * layout in the plane lies beside the net. */
#include "formats/format.h"
#include "formats/gltf/gltf_scene.h"
#include "formats/plot/color_scale.h"

#include <math.h>

/* The mesh of one map while it is built; build() makes room for all of it. */
typedef struct builder {
  const lam_model *model;
  const lam_map *map;
  const lam_vec3 *points; /* the net's vertices, or where they lie in the layout */
  lam_color_scale scale;
  float *positions, *normals, *colors;
  int *indices;
  int vertex_count, index_count;
} builder;

/* Adds the net's vertex `source` with the color of a value; returns its number in the mesh. The
 * normal is used for faces only; a zero one becomes (0, 0, 1). */
static int add_vertex(builder *b, int source, lam_vec3 normal, double value) {
  lam_rgb color = lam_color_of(&b->scale, value);
  lam_gltf_vector(b->positions + 3 * b->vertex_count, b->points[source]);
  if (b->normals)
    lam_gltf_vector(b->normals + 3 * b->vertex_count,
                    lam_length(normal) > 0 ? normal : lam_v3(0, 0, 1));
  lam_gltf_vector(b->colors + 3 * b->vertex_count, lam_v3(color.r, color.g, color.b));
  return b->vertex_count++;
}

/* The unit normal of a quad: across both diagonals. */
static lam_vec3 face_normal(const lam_vec3 *x, const int *c) {
  return lam_unit(lam_cross(lam_sub(x[c[2]], x[c[0]]), lam_sub(x[c[3]], x[c[1]])));
}

/* Adds the faces at b->points. Values on faces: every face gets vertices of its own, of one
 * color. Values on vertices: faces share the net's vertices, which are added first. */
static void add_quads(builder *b) {
  const lam_mesh *net = b->model->net;
  bool flat = b->map->on == LAM_MAP_FACES, in_plane = b->points != net->vertices;
  int before = b->vertex_count;

  for (int v = 0; !flat && v < net->vertex_count; v++)
    add_vertex(b, v, in_plane ? lam_v3(0, 0, 1) : b->map->normals[v], b->map->values[v]);

  for (int f = 0; f < net->face_count; f++) {
    static const int split[6] = {0, 1, 2, 0, 2, 3};
    int corners[4];
    for (int k = 0; k < 4; k++)
      corners[k] = flat ? add_vertex(b, net->faces[f][k], face_normal(b->points, net->faces[f]),
                                     b->map->values[f])
                        : before + net->faces[f][k];
    for (int k = 0; k < 6; k++) b->indices[b->index_count++] = corners[split[k]];
  }
}

/* Adds an edge as two vertices of its own, in one color. */
static void add_lines(builder *b) {
  for (int e = 0; e < b->map->count; e++)
    for (int k = 0; k < 2; k++)
      b->indices[b->index_count++] =
          add_vertex(b, b->map->edges[e][k], lam_v3(0, 0, 0), b->map->values[e]);
}

/* The points of the layout beside the net, a tenth of the net's width away, on the level of its
 * lowest vertex. */
static const lam_vec3 *lay_beside(lam_arena *arena, const lam_mesh *net, const lam_vec2 *layout) {
  static const double gap = 0.1;
  lam_vec3 low = lam_v3(INFINITY, INFINITY, INFINITY), high = lam_scale(low, -1);
  lam_vec2 corner = {INFINITY, INFINITY};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, net->vertex_count);

  for (int v = 0; v < net->vertex_count; v++) {
    lam_vec3 x = net->vertices[v];
    low = lam_v3(fmin(low.x, x.x), fmin(low.y, x.y), fmin(low.z, x.z));
    high = lam_v3(fmax(high.x, x.x), fmax(high.y, x.y), fmax(high.z, x.z));
    corner = (lam_vec2){fmin(corner.x, layout[v].x), fmin(corner.y, layout[v].y)};
  }

  double left = high.x + gap * (high.x - low.x);
  for (int v = 0; v < net->vertex_count; v++)
    points[v] = lam_v3(left + layout[v].x - corner.x, low.y + layout[v].y - corner.y, low.z);
  return points;
}

/* Makes room for the vertices and adds the net, and beside it its layout where the map has one. */
static void build(builder *b, lam_arena *arena) {
  bool lines = b->map->on == LAM_MAP_EDGES;

  size_t room = (size_t)(lines ? 2 * b->map->count
                               : 4 * b->model->net->face_count + b->model->net->vertex_count),
         faces = (size_t)b->model->net->face_count;
  if (b->map->layout) room *= 2, faces *= 2;
  b->positions = LAM_NEW(arena, float, 3 * room);
  b->normals = lines ? NULL : LAM_NEW(arena, float, 3 * room);
  b->colors = LAM_NEW(arena, float, 3 * room);
  b->indices = LAM_NEW(arena, int, lines ? room : 6 * faces);

  b->points = b->model->net->vertices;
  if (lines) {
    add_lines(b);
    return;
  }
  add_quads(b);
  if (!b->map->layout) return;
  b->points = lay_beside(arena, b->model->net, b->map->layout);
  add_quads(b);
}

static int count(const lam_model *model) { return model->net ? model->map_count : 0; }

static void path(const lam_model *model, int i, lam_text *name) {
  lam_text_printf(name, "plots/%s.glb", model->maps[i].summary.name);
}

/* What the map shows, as extras of its node; figures that are not finite are left out. Returns the
 * number of extras, at most six. */
static int list_extras(const lam_measure *m, lam_gltf_extra extras[6]) {
  static const char *const names[3] = {"min", "mean", "max"};
  const double figures[3] = {m->min, m->mean, m->max};
  int n = 0;
  extras[n++] = (lam_gltf_extra){"measure", m->name, 0};
  extras[n++] = (lam_gltf_extra){"unit", m->unit, 0};
  for (int k = 0; k < 3; k++)
    if (isfinite(figures[k])) extras[n++] = (lam_gltf_extra){names[k], NULL, figures[k] + 0.};
  extras[n++] = (lam_gltf_extra){"count", NULL, (double)m->count};
  return n;
}

/* Colors of the vertices multiply the white of the material, which is seen from both sides. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  const lam_map *map = &model->maps[i];
  const lam_measure *m = &map->summary;
  builder b = {.model = model, .map = map, .scale = lam_map_scale(map)};
  build(&b, out->arena);

  lam_gltf_material material = {"map", {1, 1, 1}, 0, 1, true};
  lam_gltf_mesh mesh = {.name = m->name,
                        .vertex_count = b.vertex_count,
                        .positions = b.positions,
                        .normals = b.normals,
                        .colors = b.colors,
                        .index_count = b.index_count,
                        .indices = b.indices};

  lam_gltf_extra extras[6];
  int extra_count = list_extras(m, extras);
  lam_gltf_node nodes[2] = {{model->name, -1, -1, lam_gltf_root(out->arena, model), 0, NULL},
                            {m->name, 0, 0, NULL, extra_count, extras}};
  lam_gltf_scene scene = {model->name, 1, 1, 2, &material, &mesh, nodes, {NULL, 0}, NULL, 0};
  return lam_glb_write(&scene, out);
}

const lam_format lam_format_plot_gltf = {
    .name = "plot-gltf",
    .doc = "Color maps of the net as glTF 2.0 binaries with vertex colors, in meters, y up.",
    .count = count,
    .path = path,
    .write = write,
};
