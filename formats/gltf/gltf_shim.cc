/* From a scene (gltf_shim.h) to a .glb file with tinygltf; called by gltf_scene.c. */
#include "formats/gltf/gltf_shim.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sstream>
#include <tiny_gltf.h>

namespace {

/* Fills the model's one buffer, in this order, each a buffer view: vertices (positions, normals
 * and colors, 12 bytes each), 32-bit indices, 16-bit indices, single numbers of animations,
 * texture coordinates (8 bytes each); then the picture. */
struct Packer {
  tinygltf::Model model;
  std::vector<unsigned char> vertices, wide, narrow, scalars, pairs;
  enum View { vertex_view, wide_view, narrow_view, scalar_view, pair_view, view_count };

  /* Adds size bytes to the data of a view and an accessor for `count` items in them; returns its
   * index. The view is its number in the enumeration until pack() knows which views there are. */
  int accessor(View view, std::vector<unsigned char> &data, const void *bytes, size_t size,
               int component, int type, int count) {
    tinygltf::Accessor a;
    a.bufferView = view;
    a.byteOffset = data.size();
    a.componentType = component;
    a.type = type;
    a.count = static_cast<size_t>(count);

    const unsigned char *begin = static_cast<const unsigned char *>(bytes);
    data.insert(data.end(), begin, begin + size);
    model.accessors.push_back(a);
    return static_cast<int>(model.accessors.size()) - 1;
  }

  /* Three floats each. */
  int vectors(const float *values, int count) {
    return accessor(vertex_view, vertices, values, sizeof(float) * 3 * static_cast<size_t>(count),
                    TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  }

  /* 16 bits each where they suffice: 65535 is not allowed as an index. */
  int indices(const int *values, int count, int vertex_count) {
    size_t n = static_cast<size_t>(count);
    if (vertex_count < 65535) {
      std::vector<uint16_t> packed(values, values + n);
      return accessor(narrow_view, narrow, packed.data(), sizeof(uint16_t) * n,
                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
    }

    std::vector<uint32_t> packed(values, values + n);
    return accessor(wide_view, wide, packed.data(), sizeof(uint32_t) * n,
                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count);
  }

  /* Three floats each with their bounds, which glTF demands of positions. Precondition: count >
   * 0. */
  int positions(const float *values, int count) {
    int index = vectors(values, count);
    tinygltf::Accessor &a = model.accessors.back();
    for (int k = 0; k < 3; k++) {
      float low = values[k], high = low;
      for (int v = 1; v < count; v++) {
        low = std::min(low, values[3 * v + k]);
        high = std::max(high, values[3 * v + k]);
      }
      a.minValues.push_back(low);
      a.maxValues.push_back(high);
    }
    return index;
  }

  /* Single floats with their bounds, which glTF demands of times. */
  int numbers(const std::vector<float> &values) {
    int index = accessor(scalar_view, scalars, values.data(), sizeof(float) * values.size(),
                         TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR,
                         static_cast<int>(values.size()));
    model.accessors.back().minValues = {*std::min_element(values.begin(), values.end())};
    model.accessors.back().maxValues = {*std::max_element(values.begin(), values.end())};
    return index;
  }

  /* A mesh of one primitive. With texture coordinates its material gets the scene's picture. */
  void mesh(const lam_gltf_mesh &in) {
    tinygltf::Primitive p;
    p.attributes["POSITION"] = positions(in.positions, in.vertex_count);
    if (in.normals) p.attributes["NORMAL"] = vectors(in.normals, in.vertex_count);
    if (in.colors) p.attributes["COLOR_0"] = vectors(in.colors, in.vertex_count);
    if (in.texture) {
      p.attributes["TEXCOORD_0"] = accessor(
          pair_view, pairs, in.texture, sizeof(float) * 2 * static_cast<size_t>(in.vertex_count),
          TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, in.vertex_count);
      model.materials[static_cast<size_t>(in.material)]
          .pbrMetallicRoughness.baseColorTexture.index = 0;
    }

    p.indices = indices(in.indices, in.index_count, in.vertex_count);
    p.material = in.material;
    p.mode = in.normals ? TINYGLTF_MODE_TRIANGLES : TINYGLTF_MODE_LINE;

    for (int t = 0; t < in.target_count; t++) {
      std::map<std::string, int> target;
      target["POSITION"] = positions(in.position_targets[t], in.vertex_count);
      if (in.normals) target["NORMAL"] = vectors(in.normal_targets[t], in.vertex_count);
      p.targets.push_back(target);
    }

    tinygltf::Mesh m;
    m.name = in.name;
    m.weights.assign(static_cast<size_t>(in.target_count), 0.0);
    m.primitives.push_back(p);
    model.meshes.push_back(m);
  }

  /* One channel per node with morph targets: at state k the weight of target k is 1, all others
   * 0. */
  void animation(const lam_gltf_scene &in) {
    tinygltf::Animation animation;
    animation.name = in.animation.name;
    for (int i = 0; i < in.node_count; i++) {
      int targets = in.nodes[i].mesh < 0 ? 0 : in.meshes[in.nodes[i].mesh].target_count;
      if (targets == 0) continue;

      /* There and back: states 0 .. targets, then down to 0 again. */
      std::vector<float> times, weights;
      for (int k = 0; k <= 2 * targets; k++) {
        int state = k <= targets ? k : 2 * targets - k;
        times.push_back(static_cast<float>(k * in.animation.seconds_per_state));
        for (int t = 1; t <= targets; t++) weights.push_back(t == state ? 1.f : 0.f);
      }

      tinygltf::AnimationSampler sampler;
      sampler.input = numbers(times);
      sampler.output = numbers(weights);
      sampler.interpolation = "LINEAR";

      tinygltf::AnimationChannel channel;
      channel.sampler = static_cast<int>(animation.samplers.size());
      channel.target_node = i;
      channel.target_path = "weights";
      animation.samplers.push_back(sampler);
      animation.channels.push_back(channel);
    }
    if (!animation.channels.empty()) model.animations.push_back(animation);
  }

  /* The PNG file as it is, in a view of its own. */
  void picture(const lam_gltf_scene &in, tinygltf::Buffer &buffer) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.data.size();
    view.byteLength = in.picture_size;
    buffer.data.insert(buffer.data.end(), in.picture, in.picture + in.picture_size);
    buffer.data.resize((buffer.data.size() + 3) / 4 * 4);

    tinygltf::Image image;
    image.name = "print";
    image.mimeType = "image/png";
    image.bufferView = static_cast<int>(model.bufferViews.size());
    model.bufferViews.push_back(view);

    tinygltf::Texture texture;
    texture.source = static_cast<int>(model.images.size());
    model.images.push_back(image);
    model.textures.push_back(texture);
  }

  /* Puts the data of the views into the buffer, each padded to four bytes. Views that hold
   * nothing are left out; accessors of the later ones move up. */
  void pack(const lam_gltf_scene &in) {
    tinygltf::Buffer buffer;
    int moved[view_count] = {-1, -1, -1, -1, -1};
    std::vector<unsigned char> *parts[view_count] = {&vertices, &wide, &narrow, &scalars, &pairs};
    for (int v = 0; v < view_count; v++) {
      if (parts[v]->empty()) continue;

      tinygltf::BufferView view;
      view.buffer = 0;
      view.byteOffset = buffer.data.size();
      view.byteLength = parts[v]->size();
      bool of_vertices = v == vertex_view || v == pair_view;
      view.byteStride = v == vertex_view ? 12 : v == pair_view ? 8 : 0;
      if (v != scalar_view)
        view.target =
            of_vertices ? TINYGLTF_TARGET_ARRAY_BUFFER : TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;

      moved[v] = static_cast<int>(model.bufferViews.size());
      model.bufferViews.push_back(view);
      buffer.data.insert(buffer.data.end(), parts[v]->begin(), parts[v]->end());
      buffer.data.resize((buffer.data.size() + 3) / 4 * 4);
    }

    for (tinygltf::Accessor &a : model.accessors) a.bufferView = moved[a.bufferView];
    if (in.picture) picture(in, buffer);
    if (!buffer.data.empty()) model.buffers.push_back(std::move(buffer));
  }
};

/* Colors are opaque. */
tinygltf::Material material_of(const lam_gltf_material &in) {
  tinygltf::Material m;
  m.name = in.name;
  m.pbrMetallicRoughness.baseColorFactor = {in.color[0], in.color[1], in.color[2], 1};
  m.pbrMetallicRoughness.metallicFactor = in.metallic;
  m.pbrMetallicRoughness.roughnessFactor = in.roughness;
  m.doubleSided = in.double_sided;
  return m;
}

/* Whole numbers below 1e9 are written as such, without a decimal point. Of two extras with one
 * name the later one stays. */
tinygltf::Value extras_of(const lam_gltf_node &in) {
  tinygltf::Value::Object object;
  for (int i = 0; i < in.extra_count; i++) {
    const lam_gltf_extra &e = in.extras[i];
    bool whole = e.number == std::floor(e.number) && std::fabs(e.number) < 1e9;
    object[e.name] = e.text  ? tinygltf::Value(std::string(e.text))
                     : whole ? tinygltf::Value(static_cast<int>(e.number))
                             : tinygltf::Value(e.number);
  }
  return tinygltf::Value(object);
}

/* One scene; nodes keep their numbers, so a parent stands before its children. */
void add_nodes(const lam_gltf_scene &in, tinygltf::Model &model) {
  tinygltf::Scene scene;
  scene.name = in.name;
  for (int i = 0; i < in.node_count; i++) {
    const lam_gltf_node &n = in.nodes[i];
    tinygltf::Node node;
    node.name = n.name;
    node.mesh = n.mesh;
    if (n.matrix) node.matrix.assign(n.matrix, n.matrix + 16);
    if (n.extra_count) node.extras = extras_of(n);

    model.nodes.push_back(node);
    if (n.parent < 0)
      scene.nodes.push_back(i);
    else
      model.nodes[static_cast<size_t>(n.parent)].children.push_back(i);
  }
  model.scenes.push_back(scene);
  model.defaultScene = 0;
}

} // namespace

/* Materials come before meshes, which may give them a texture; the buffer is packed when all is
 * in. */
lam_status lam_gltf_encode(const lam_gltf_scene *scene, char **bytes, size_t *count) {
  *bytes = nullptr;
  *count = 0;
  try {
    Packer packer;
    packer.model.asset.version = "2.0";
    packer.model.asset.generator = "lamella";

    for (int i = 0; i < scene->material_count; i++)
      packer.model.materials.push_back(material_of(scene->materials[i]));
    for (int i = 0; i < scene->mesh_count; i++) packer.mesh(scene->meshes[i]);
    if (scene->animation.name) packer.animation(*scene);
    packer.pack(*scene);
    add_nodes(*scene, packer.model);

    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&packer.model, stream, false, true)) return LAM_FAILED;

    std::string glb = stream.str();
    *bytes = static_cast<char *>(std::malloc(glb.size()));
    if (!*bytes) return LAM_NO_MEMORY;
    std::memcpy(*bytes, glb.data(), glb.size());
    *count = glb.size();
    return LAM_OK;
  } catch (const std::bad_alloc &) {
    return LAM_NO_MEMORY;
  } catch (...) {
    return LAM_FAILED;
  }
}
