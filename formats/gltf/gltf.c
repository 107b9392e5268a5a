/* glTF binary (NAME.glb; listed in formats/list/formats.c): meters, y up through the matrix of one
 * root node. Below it a node per family with a named node per part, and for a part with instances
 * a node with one child per instance, all of one mesh. Facts about a part are in the extras of
 * its node. A model without parts shows its prints, or its net as lines. */
#include "core/image.h"
#include "core/numbers.h"
#include "formats/corner_normals.h"
#include "formats/format.h"
#include "formats/gltf/gltf_scene.h"
#include "formats/print.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Faces that meet at less than this are shaded as one surface. */
static const double smooth_angle = 25 * LAM_PI / 180;
static const char *const family_names[] = {"A", "B"};

static int gltf_count(const lam_model *model) { return model->part_count || model->net ? 1 : 0; }

static void gltf_path(const lam_model *model, int i, lam_text *path) {
  (void)i;
  lam_text_printf(path, "%s.glb", model->name);
}

/* The scene while it is built; the arrays have room for everything (make_room). */
typedef struct builder {
  lam_arena *arena;
  const lam_model *model;
  lam_gltf_material *materials;
  lam_gltf_mesh *meshes;
  lam_gltf_node *nodes;
  int material_count, mesh_count, node_count;
} builder;

/* ---- materials and meshes ---- */

/* The index of the material with this name, added when it is new. color is linear RGB. */
static int add_material(builder *b, const char *name, const double color[3], double metallic,
                        double roughness) {
  for (int i = 0; i < b->material_count; i++)
    if (!strcmp(b->materials[i].name, name)) return i;

  b->materials[b->material_count] =
      (lam_gltf_material){name, {color[0], color[1], color[2]}, metallic, roughness, false};
  return b->material_count++;
}

/* The vectors as floats, three each: those that source lists, or the first count when it is
 * NULL. */
static float *floats_of(lam_arena *arena, const lam_vec3 *vectors, const int *source, int count) {
  float *values = LAM_NEW(arena, float, 3 * (size_t)count);
  for (int i = 0; i < count; i++) lam_gltf_vector(values + 3 * i, vectors[source ? source[i] : i]);
  return values;
}

/* Adds the solid of a part. Returns the index of the mesh, or -1 when the solid has no triangle. */
static int add_mesh(builder *b, const lam_part *part) {
  lam_shaded_mesh shaded = lam_shaded_mesh_make(b->arena, &part->solid, smooth_angle);
  if (!shaded.triangle_count) return -1;

  const lam_material *m = part->material;
  b->meshes[b->mesh_count] = (lam_gltf_mesh){
      .name = part->name,
      .material = add_material(b, m->name, m->color, m->metallic, m->roughness),
      .vertex_count = shaded.vertex_count,
      .positions = floats_of(b->arena, part->solid.vertices, shaded.source, shaded.vertex_count),
      .normals = floats_of(b->arena, shaded.normals, NULL, shaded.vertex_count),
      .index_count = 3 * shaded.triangle_count,
      .indices = &shaded.triangles[0][0],
  };
  return b->mesh_count++;
}

/* Adds the net as lines along its polylines. Returns the index of the mesh, -1: there are no
 * lines. */
static int add_net(builder *b) {
  const lam_model *model = b->model;
  const double gray[3] = {.2, .2, .2};
  int count, *indices = lam_gltf_lines(b->arena, model, &count);
  if (!count) return -1;

  b->meshes[b->mesh_count] = (lam_gltf_mesh){
      .name = "net",
      .material = add_material(b, "lines", gray, 0, 1),
      .vertex_count = model->net->vertex_count,
      .positions = floats_of(b->arena, model->net->vertices, NULL, model->net->vertex_count),
      .index_count = count,
      .indices = indices};
  return b->mesh_count++;
}

/* Adds a printed surface and returns the index of its mesh. Texture coordinates count from the
 * lower left corner of the picture in the model, from the upper left corner in glTF. */
static int add_print(builder *b, const lam_printed *sheet) {
  static const double white[3] = {1, 1, 1};
  int n = sheet->mesh.vertex_count;
  float *texture = LAM_NEW(b->arena, float, 2 * (size_t)n);
  for (int v = 0; v < n; v++) {
    texture[2 * v] = (float)sheet->texture[v].x;
    texture[2 * v + 1] = (float)(1 - sheet->texture[v].y);
  }

  int material = add_material(b, "print", white, 0, 0.7);
  b->materials[material].double_sided = true;

  b->meshes[b->mesh_count] = (lam_gltf_mesh){
      .name = sheet->name,
      .material = material,
      .vertex_count = n,
      .positions = floats_of(b->arena, sheet->mesh.vertices, NULL, n),
      .normals = floats_of(b->arena, lam_print_normals(b->arena, &sheet->mesh), NULL, n),
      .texture = texture,
      .index_count = 3 * sheet->mesh.triangle_count,
      .indices = &sheet->mesh.triangles[0][0]};
  return b->mesh_count++;
}

/* ---- nodes ---- */

/* Adds a node without extras and returns its index. parent -1: a root; mesh -1: none; matrix
 * NULL: the identity. */
static int add_node(builder *b, const char *name, int parent, int mesh, const double *matrix) {
  b->nodes[b->node_count] =
      (lam_gltf_node){.name = name, .parent = parent, .mesh = mesh, .matrix = matrix};
  return b->node_count++;
}

/* Nine significant digits: enough for anything measured, and readable. Never a negative zero. */
static double rounded(double value) {
  char digits[40];
  snprintf(digits, sizeof digits, "%.9g", value);
  return strtod(digits, NULL) + 0.0;
}

/* The column-major matrix of an instance: its axes, then its origin. */
static double *matrix_of(lam_arena *arena, const lam_pose *pose) {
  double *m = LAM_NEW(arena, double, 16);
  for (int c = 0; c < 4; c++) {
    lam_vec3 v = c < 3 ? pose->axis[c] : pose->origin;
    m[4 * c] = rounded(v.x), m[4 * c + 1] = rounded(v.y), m[4 * c + 2] = rounded(v.z);
  }
  m[15] = 1;
  return m;
}

/* The first number in a name: 7 for "A07a"; 0 when there is none. */
static int number_in(const char *name) { return atoi(name + strcspn(name, "0123456789")); }

/* Facts come first: a name given again below replaces the fact (glb.c keeps the last value). */
static void add_extras(builder *b, int node, const lam_part *part) {
  lam_gltf_extra *extras = LAM_NEW(b->arena, lam_gltf_extra, part->fact_count + 8);
  int n = 0;
  for (int i = 0; i < part->fact_count; i++)
    if (isfinite(part->facts[i].value))
      extras[n++] = (lam_gltf_extra){part->facts[i].name, NULL, rounded(part->facts[i].value)};

  extras[n++] = (lam_gltf_extra){"kind", part->kind, 0};
  extras[n++] = (lam_gltf_extra){"material", part->material->name, 0};
  extras[n++] = (lam_gltf_extra){"mass", NULL, rounded(part->mass)};
  if (part->family >= 0) extras[n++] = (lam_gltf_extra){"family", family_names[part->family], 0};
  if (part->family >= 0) extras[n++] = (lam_gltf_extra){"number", NULL, number_in(part->name)};
  if (part->length > 0) extras[n++] = (lam_gltf_extra){"length", NULL, rounded(part->length)};
  if (part->congruence > 0) extras[n++] = (lam_gltf_extra){"congruence", NULL, part->congruence};
  if (part->instance_count) extras[n++] = (lam_gltf_extra){"count", NULL, part->instance_count};

  b->nodes[node].extras = extras;
  b->nodes[node].extra_count = n;
}

/* The node of a part below parent; its mesh hangs on that node, or on one child per instance. */
static void add_part(builder *b, const lam_part *part, int parent) {
  int mesh = add_mesh(b, part);
  int node = add_node(b, part->name, parent, part->instance_count ? -1 : mesh, NULL);
  add_extras(b, node, part);
  for (int i = 0; i < part->instance_count; i++)
    add_node(b, lam_arena_printf(b->arena, "%s %d", part->name, i + 1), node, mesh,
             matrix_of(b->arena, &part->instances[i]));
}

/* The nodes of all parts of a family (0, 1, or 2: of none) and that of the family itself, which is
 * made for the first of them; parts of no family hang on the root. */
static void add_family(builder *b, int root, int family) {
  int parent = family < 2 ? -1 : root;
  for (int i = 0; i < b->model->part_count; i++) {
    const lam_part *part = &b->model->parts[i];
    if ((part->family < 0 ? 2 : part->family) != family) continue;
    if (parent < 0)
      parent = add_node(b, lam_arena_printf(b->arena, "family %s", family_names[family]), root, -1,
                        NULL);
    add_part(b, part, parent);
  }
}

/* The whole scene below one root: parts by family, then prints; the net when there is nothing
 * else. */
static void add_nodes(builder *b) {
  const lam_model *model = b->model;
  int root = add_node(b, model->name, -1, -1, lam_gltf_root(b->arena, model));
  for (int family = 0; family < 3; family++) add_family(b, root, family);

  int prints = model->print ? model->print->count : 0;
  for (int i = 0; i < prints; i++)
    add_node(b, model->print->sheets[i].name, root, add_print(b, &model->print->sheets[i]), NULL);
  if (!model->part_count && !prints) add_node(b, "net", root, add_net(b), NULL);
}

/* ---- the file ---- */

/* Makes room for everything that add_nodes may add: a root, two families, the net and every print;
 * a node per part and per instance; materials of parts, of the print and of lines. */
static void make_room(builder *b) {
  const lam_model *model = b->model;
  int prints = model->print ? model->print->count : 0;
  size_t nodes = 4 + (size_t)prints;
  for (int k = 0; k < model->part_count; k++) nodes += 1 + (size_t)model->parts[k].instance_count;

  b->materials = LAM_NEW(b->arena, lam_gltf_material, model->part_count + 2);
  b->meshes = LAM_NEW(b->arena, lam_gltf_mesh, model->part_count + prints + 1);
  b->nodes = LAM_NEW(b->arena, lam_gltf_node, nodes);
}

/* The picture of a print goes into the file as PNG. */
static lam_status gltf_write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  builder b = {.arena = out->arena, .model = model};
  make_room(&b);
  add_nodes(&b);

  lam_gltf_scene scene = {.name = model->title ? model->title : model->name,
                          .material_count = b.material_count,
                          .mesh_count = b.mesh_count,
                          .node_count = b.node_count,
                          .materials = b.materials,
                          .meshes = b.meshes,
                          .nodes = b.nodes};
  if (model->print && model->print->count) {
    uint8_t *bytes;
    lam_image image = {model->print->width, model->print->height,
                       (uint8_t *)model->print->pixels}; /* only read */
    if (!lam_image_encode(b.arena, &image, &bytes, &scene.picture_size)) return LAM_FAILED;
    scene.picture = bytes;
  }
  return lam_glb_write(&scene, out);
}

const lam_format lam_format_gltf = {
    .name = "gltf",
    .doc = "glTF 2.0 binary: the model with named nodes, materials and facts, in meters, y up",
    .count = gltf_count,
    .path = gltf_path,
    .write = gltf_write,
};
