/* From a scene (glb.h) to a glTF 2.0 binary: a text that describes one buffer, and the buffer.
 * Called by the glTF writers of this folder. */
#include "formats/gltf/glb.h"

#include <math.h>
#include <string.h>

/* The parts of the buffer, in this order, each a buffer view when there is something in it: vectors
 * of 12 bytes, indices of 32 and of 16 bits, single numbers of animations, texture coordinates. */
enum { vertex_view, wide_view, narrow_view, scalar_view, pair_view, view_count };

/* Of glTF: how the numbers of an accessor are stored, and what a view is for. */
enum { u16 = 5123, u32 = 5125, f32 = 5126, array_target = 34962, element_target = 34963 };

/* The scene that is written, the data of the views, and the lists of the text as they grow: their
 * entries with commas in between. */
typedef struct packer {
  const lam_gltf_scene *scene;
  lam_text data[view_count];
  int number[view_count]; /* of the view among those that are written; -1: it is empty */
  lam_text accessors, views, buffer;
  int accessor_count;
} packer;

/* ---- pieces of the text ---- */

static lam_text empty_text(lam_arena *arena) { return (lam_text){.arena = arena}; }

/* A comma unless the text is at its beginning, or at that of a list or map. */
static void separate(lam_text *text) {
  char last = text->length ? text->data[text->length - 1] : '[';
  if (last != '[' && last != '{') lam_text_add(text, ",");
}

/* The next key of a map, with its colon. */
static void add_key(lam_text *text, const char *key) {
  separate(text);
  lam_text_quoted(text, key);
  lam_text_add(text, ":");
}

static void add_name(lam_text *text, const char *key, const char *value) {
  add_key(text, key);
  lam_text_quoted(text, value);
}

static void add_integer(lam_text *text, const char *key, size_t value) {
  add_key(text, key);
  lam_text_printf(text, "%zu", value);
}

/* Whole numbers below 1e9 are written without a decimal point. */
static void add_real(lam_text *text, double value) {
  if (value == floor(value) && fabs(value) < 1e9)
    lam_text_printf(text, "%d", (int)value);
  else
    lam_text_real(text, value);
}

static void add_reals(lam_text *text, const char *key, const double *values, int count) {
  add_key(text, key);
  lam_text_add(text, "[");
  for (int i = 0; i < count; i++) {
    separate(text);
    add_real(text, values[i]);
  }
  lam_text_add(text, "]");
}

/* A list that has been put together; none when it is empty, which glTF does not allow. */
static void add_list(lam_text *text, const char *key, const lam_text *list) {
  if (!list->length) return;
  add_key(text, key);
  lam_text_add(text, "[");
  lam_text_bytes(text, list->data, list->length);
  lam_text_add(text, "]");
}

/* ---- accessors ---- */

/* An accessor for `count` items of a type ("VEC3"), which follow in the view from `offset` on;
 * bounds: least and greatest values, `width` each, or NULL. Returns its number. The views of the
 * text are numbered by pack_views, which is called before. */
static int add_accessor(packer *p, int view, size_t offset, int component, const char *type,
                        int count, const double *bounds, int width) {
  lam_text *text = &p->accessors;
  separate(text);
  lam_text_add(text, "{");
  add_integer(text, "bufferView", (size_t)p->number[view]);
  add_integer(text, "byteOffset", offset);
  add_integer(text, "componentType", (size_t)component);
  add_integer(text, "count", (size_t)count);
  add_name(text, "type", type);

  if (bounds) {
    add_reals(text, "min", bounds, width);
    add_reals(text, "max", bounds + width, width);
  }
  lam_text_add(text, "}");
  return p->accessor_count++;
}

/* Floats of the given width each, at the end of a view. Returns where they begin. */
static size_t add_floats(packer *p, int view, const float *values, size_t count) {
  size_t offset = p->data[view].length;
  for (size_t i = 0; i < count; i++) lam_text_f32(&p->data[view], values[i]);
  return offset;
}

static int add_vectors(packer *p, const float *values, int count) {
  size_t offset = add_floats(p, vertex_view, values, 3 * (size_t)count);
  return add_accessor(p, vertex_view, offset, f32, "VEC3", count, NULL, 0);
}

/* Least and greatest of every k-th of `width` numbers, which glTF demands of positions and times.
 * Precondition: count > 0. */
static void find_bounds(const float *values, int count, int width, double *bounds) {
  for (int k = 0; k < width; k++) {
    bounds[k] = bounds[width + k] = values[k];
    for (int i = 1; i < count; i++) {
      bounds[k] = fmin(bounds[k], values[width * i + k]);
      bounds[width + k] = fmax(bounds[width + k], values[width * i + k]);
    }
  }
}

static int add_positions(packer *p, const float *values, int count) {
  double bounds[6];
  find_bounds(values, count, 3, bounds);
  size_t offset = add_floats(p, vertex_view, values, 3 * (size_t)count);
  return add_accessor(p, vertex_view, offset, f32, "VEC3", count, bounds, 3);
}

static int add_numbers(packer *p, const float *values, int count) {
  double bounds[2];
  find_bounds(values, count, 1, bounds);
  size_t offset = add_floats(p, scalar_view, values, (size_t)count);
  return add_accessor(p, scalar_view, offset, f32, "SCALAR", count, bounds, 1);
}

/* 16 bits suffice for the indices: 65535 is none. */
static bool is_narrow(const lam_gltf_mesh *mesh) { return mesh->vertex_count < 65535; }

static int add_indices(packer *p, const lam_gltf_mesh *mesh) {
  bool narrow = is_narrow(mesh);
  int view = narrow ? narrow_view : wide_view;
  lam_text *data = &p->data[view];
  size_t offset = data->length;
  for (int i = 0; i < mesh->index_count; i++)
    if (narrow)
      lam_text_u16(data, (uint16_t)mesh->indices[i]);
    else
      lam_text_u32(data, (uint32_t)mesh->indices[i]);
  return add_accessor(p, view, offset, narrow ? u16 : u32, "SCALAR", mesh->index_count, NULL, 0);
}

/* ---- meshes and materials ---- */

/* Positions, and normals where the mesh has them, of one state of it. */
static void add_attributes(packer *p, lam_text *text, const lam_gltf_mesh *mesh,
                           const float *positions, const float *normals) {
  add_integer(text, "POSITION", (size_t)add_positions(p, positions, mesh->vertex_count));
  if (mesh->normals)
    add_integer(text, "NORMAL", (size_t)add_vectors(p, normals, mesh->vertex_count));
}

static void add_targets(packer *p, lam_text *text, const lam_gltf_mesh *mesh) {
  if (!mesh->target_count) return;
  add_key(text, "targets");
  lam_text_add(text, "[");
  for (int t = 0; t < mesh->target_count; t++) {
    separate(text);
    lam_text_add(text, "{");
    add_attributes(p, text, mesh, mesh->position_targets[t],
                   mesh->normals ? mesh->normal_targets[t] : NULL);
    lam_text_add(text, "}");
  }
  lam_text_add(text, "]");
}

/* The one primitive of a mesh: triangles (4) or lines (1). */
static void add_primitive(packer *p, lam_text *text, const lam_gltf_mesh *mesh) {
  lam_text_add(text, "{\"attributes\":{");
  add_attributes(p, text, mesh, mesh->positions, mesh->normals);
  if (mesh->colors)
    add_integer(text, "COLOR_0", (size_t)add_vectors(p, mesh->colors, mesh->vertex_count));
  if (mesh->texture) {
    size_t offset = add_floats(p, pair_view, mesh->texture, 2 * (size_t)mesh->vertex_count);
    int pairs = add_accessor(p, pair_view, offset, f32, "VEC2", mesh->vertex_count, NULL, 0);
    add_integer(text, "TEXCOORD_0", (size_t)pairs);
  }
  lam_text_add(text, "}");

  add_integer(text, "indices", (size_t)add_indices(p, mesh));
  add_integer(text, "material", (size_t)mesh->material);
  add_integer(text, "mode", mesh->normals ? 4 : 1);
  add_targets(p, text, mesh);
  lam_text_add(text, "}");
}

static lam_text meshes_of(packer *p) {
  lam_text text = empty_text(p->buffer.arena);
  for (int m = 0; m < p->scene->mesh_count; m++) {
    const lam_gltf_mesh *mesh = &p->scene->meshes[m];
    separate(&text);
    lam_text_add(&text, "{");
    add_name(&text, "name", mesh->name);
    add_key(&text, "primitives");
    lam_text_add(&text, "[");
    add_primitive(p, &text, mesh);
    lam_text_add(&text, "]");

    /* Before it moves, a mesh has none of its targets. */
    for (int t = 0; t < mesh->target_count; t++) lam_text_add(&text, t ? ",0" : ",\"weights\":[0");
    lam_text_add(&text, mesh->target_count ? "]}" : "}");
  }
  return text;
}

/* Whether a mesh of this material has texture coordinates: it gets the scene's picture. */
static bool is_printed(const lam_gltf_scene *scene, int material) {
  for (int m = 0; m < scene->mesh_count; m++)
    if (scene->meshes[m].texture && scene->meshes[m].material == material) return true;
  return false;
}

/* A factor that is 1 without being given. */
static void add_factor(lam_text *text, const char *key, double value) {
  if (value == 1) return;
  add_key(text, key);
  add_real(text, value);
}

/* Colors are opaque. */
static lam_text materials_of(packer *p) {
  lam_text text = empty_text(p->buffer.arena);
  for (int m = 0; m < p->scene->material_count; m++) {
    const lam_gltf_material *in = &p->scene->materials[m];
    const double color[4] = {in->color[0], in->color[1], in->color[2], 1};
    separate(&text);
    lam_text_add(&text, "{");
    add_name(&text, "name", in->name);
    lam_text_add(&text, ",\"pbrMetallicRoughness\":{");
    add_reals(&text, "baseColorFactor", color, 4);
    if (is_printed(p->scene, m)) lam_text_add(&text, ",\"baseColorTexture\":{\"index\":0}");

    add_factor(&text, "metallicFactor", in->metallic);
    add_factor(&text, "roughnessFactor", in->roughness);
    lam_text_add(&text, in->double_sided ? "},\"doubleSided\":true}" : "}}");
  }
  return text;
}

/* ---- nodes ---- */

/* Of two extras with one name the later one stays. */
static bool comes_again(const lam_gltf_node *node, int extra) {
  for (int i = extra + 1; i < node->extra_count; i++)
    if (strcmp(node->extras[i].name, node->extras[extra].name) == 0) return true;
  return false;
}

static void add_extras(lam_text *text, const lam_gltf_node *node) {
  if (!node->extra_count) return;
  add_key(text, "extras");
  lam_text_add(text, "{");
  for (int i = 0; i < node->extra_count; i++) {
    if (comes_again(node, i)) continue;
    add_key(text, node->extras[i].name);
    if (node->extras[i].text)
      lam_text_quoted(text, node->extras[i].text);
    else
      add_real(text, node->extras[i].number);
  }
  lam_text_add(text, "}");
}

/* Adds the numbers of the nodes below `parent` (-1: the roots) under a key, when there are any.
 * first, next: for every node, and at -1 for the roots, the list of what is below. */
static void add_below(lam_text *text, const char *key, int first, const int *next) {
  if (first < 0) return;
  add_key(text, key);
  lam_text_add(text, "[");
  for (int i = first; i >= 0; i = next[i]) {
    separate(text);
    lam_text_printf(text, "%d", i);
  }
  lam_text_add(text, "]");
}

/* All nodes as they are numbered; `below` gets the roots of the scene. */
static lam_text nodes_of(packer *p, lam_text *below) {
  const lam_gltf_scene *scene = p->scene;
  int n = scene->node_count, *first = LAM_NEW(p->buffer.arena, int, n + 1);
  int *next = LAM_NEW(p->buffer.arena, int, n);
  for (int i = 0; i <= n; i++) first[i] = -1;
  for (int i = n; i-- > 0;) { /* from the last to the first, so that lists run upward */
    int parent = scene->nodes[i].parent + 1;
    next[i] = first[parent];
    first[parent] = i;
  }

  lam_text text = empty_text(p->buffer.arena);
  for (int i = 0; i < n; i++) {
    const lam_gltf_node *node = &scene->nodes[i];
    separate(&text);
    lam_text_add(&text, "{");
    add_name(&text, "name", node->name);
    if (node->mesh >= 0) add_integer(&text, "mesh", (size_t)node->mesh);
    if (node->matrix) add_reals(&text, "matrix", node->matrix, 16);
    add_below(&text, "children", first[i + 1], next);
    add_extras(&text, node);
    lam_text_add(&text, "}");
  }
  add_below(below, "nodes", first[0], next);
  return text;
}

/* ---- animation ---- */

/* The sampler of a node with morph targets: at state k the weight of target k is 1, all others 0;
 * there and back, states 0 .. targets, then down to 0 again. */
static void add_sampler(packer *p, lam_text *text, int targets) {
  int states = 2 * targets + 1;
  float *times = LAM_NEW(p->buffer.arena, float, states);
  float *weights = LAM_NEW(p->buffer.arena, float, (size_t)states *(size_t)targets);
  for (int k = 0; k < states; k++) {
    int state = k <= targets ? k : 2 * targets - k;
    times[k] = (float)(k * p->scene->animation.seconds_per_state);
    if (state) weights[k * targets + state - 1] = 1;
  }

  int input = add_numbers(p, times, states), output = add_numbers(p, weights, states * targets);
  separate(text);
  lam_text_printf(text, "{\"input\":%d,\"interpolation\":\"LINEAR\",\"output\":%d}", input, output);
}

/* One channel per node with morph targets; none without such nodes. */
static lam_text animation_of(packer *p) {
  lam_text text = empty_text(p->buffer.arena), samplers = text, channels = text;
  const lam_gltf_scene *scene = p->scene;
  int count = 0;
  for (int i = 0; scene->animation.name && i < scene->node_count; i++) {
    int mesh = scene->nodes[i].mesh, targets = mesh < 0 ? 0 : scene->meshes[mesh].target_count;
    if (!targets) continue;
    add_sampler(p, &samplers, targets);
    separate(&channels);
    lam_text_printf(&channels, "{\"sampler\":%d,\"target\":{\"node\":%d,\"path\":\"weights\"}}",
                    count++, i);
  }
  if (!count) return text;

  lam_text_add(&text, "{");
  add_name(&text, "name", scene->animation.name);
  add_list(&text, "channels", &channels);
  add_list(&text, "samplers", &samplers);
  lam_text_add(&text, "}");
  return text;
}

/* ---- the buffer ---- */

/* Which views hold something, and their numbers: found before the accessors, which name them. */
static void number_views(packer *p) {
  const lam_gltf_scene *scene = p->scene;
  bool used[view_count] = {false};
  for (int m = 0; m < scene->mesh_count; m++) {
    const lam_gltf_mesh *mesh = &scene->meshes[m];
    used[vertex_view] = true;
    used[is_narrow(mesh) ? narrow_view : wide_view] = true;
    used[pair_view] = used[pair_view] || mesh->texture;
  }
  for (int i = 0; scene->animation.name && i < scene->node_count; i++) {
    int mesh = scene->nodes[i].mesh;
    used[scalar_view] = used[scalar_view] || (mesh >= 0 && scene->meshes[mesh].target_count);
  }

  int count = 0;
  for (int v = 0; v < view_count; v++) p->number[v] = used[v] ? count++ : -1;
}

/* Appends bytes to the buffer, padded to four, and a view of them. stride, target: 0: none. */
static void add_view(packer *p, const void *bytes, size_t count, int stride, int target) {
  static const char zeros[4];
  separate(&p->views);
  lam_text_add(&p->views, "{\"buffer\":0");
  add_integer(&p->views, "byteOffset", p->buffer.length);
  add_integer(&p->views, "byteLength", count);
  if (stride) add_integer(&p->views, "byteStride", (size_t)stride);
  if (target) add_integer(&p->views, "target", (size_t)target);
  lam_text_add(&p->views, "}");

  lam_text_bytes(&p->buffer, bytes, count);
  lam_text_bytes(&p->buffer, zeros, (4 - count % 4) % 4);
}

/* Puts the data of the views together; the picture, a PNG file as it is, is the last. Returns the
 * number of the picture's view. */
static int pack(packer *p) {
  static const int stride[view_count] = {12, 0, 0, 0, 8};
  static const int target[view_count] = {array_target, element_target, element_target, 0,
                                         array_target};
  int count = 0;
  for (int v = 0; v < view_count; v++) {
    if (p->number[v] < 0) continue;
    add_view(p, p->data[v].data, p->data[v].length, stride[v], target[v]);
    count++;
  }
  if (p->scene->picture) add_view(p, p->scene->picture, p->scene->picture_size, 0, 0);
  return count;
}

/* ---- the file ---- */

/* The text of the file, with the buffer in p. */
static lam_text describe(packer *p) {
  lam_text text = empty_text(p->buffer.arena), below = text;
  number_views(p);
  lam_text materials = materials_of(p), meshes = meshes_of(p), animation = animation_of(p);
  lam_text nodes = nodes_of(p, &below);
  int picture = pack(p);

  lam_text_add(&text, "{\"asset\":{\"generator\":\"lamella\",\"version\":\"2.0\"},\"scene\":0,"
                      "\"scenes\":[{");
  add_name(&text, "name", p->scene->name);
  if (below.length) separate(&text), lam_text_bytes(&text, below.data, below.length);
  lam_text_add(&text, "}]");

  add_list(&text, "nodes", &nodes);
  add_list(&text, "materials", &materials);
  add_list(&text, "meshes", &meshes);
  add_list(&text, "animations", &animation);
  add_list(&text, "accessors", &p->accessors);
  add_list(&text, "bufferViews", &p->views);
  if (p->scene->picture)
    lam_text_printf(&text,
                    ",\"images\":[{\"bufferView\":%d,\"mimeType\":\"image/png\",\"name\":"
                    "\"print\"}],\"textures\":[{\"source\":0}]",
                    picture);
  if (p->buffer.length)
    lam_text_printf(&text, ",\"buffers\":[{\"byteLength\":%zu}]", p->buffer.length);
  lam_text_add(&text, "}");
  while (text.length % 4) lam_text_add(&text, " ");
  return text;
}

/* A chunk of the file: its size, what it is, its bytes. */
static void add_chunk(lam_text *out, const char *kind, const lam_text *bytes) {
  lam_text_u32(out, (uint32_t)bytes->length);
  lam_text_bytes(out, kind, 4);
  lam_text_bytes(out, bytes->data, bytes->length);
}

/* A head of 12 bytes, then the text and, where there is any, the buffer; see the header. */
lam_status lam_glb_write(const lam_gltf_scene *scene, lam_text *out) {
  packer p = {.scene = scene};
  for (int v = 0; v < view_count; v++) p.data[v].arena = out->arena;
  p.accessors.arena = p.views.arena = p.buffer.arena = out->arena;
  lam_text text = describe(&p);

  size_t size = 12 + 8 + text.length + (p.buffer.length ? 8 + p.buffer.length : 0);
  if (size > UINT32_MAX) return LAM_FAILED;
  lam_text_bytes(out, "glTF", 4);
  lam_text_u32(out, 2);
  lam_text_u32(out, (uint32_t)size);
  add_chunk(out, "JSON", &text);
  if (p.buffer.length) add_chunk(out, "BIN", &p.buffer);
  return LAM_OK;
}
