/* A glTF binary taken apart by its specification (glTF 2.0, 3.6 and 4.4), for the tests of its
 * writers. */
#ifndef LAM_TESTS_GLTF_FIXTURE_H
#define LAM_TESTS_GLTF_FIXTURE_H

#include "tests/unit/text_fixture.h"

#include <jansson.h>
#include <stdio.h>

typedef struct scene {
  json_t *root;
  const char *binary;
} scene;

static inline void release(void *root) { json_decref(root); }

static inline uint32_t word(const char *at) {
  uint32_t value;
  memcpy(&value, at, 4);
  return value;
}

static inline scene read_scene(lam_arena *arena, const lam_format *format, const lam_model *model,
                               int i) {
  lam_text text = {.arena = arena};
  assert_int_equal(format->write(model, i, &text), LAM_OK);
  uint32_t length = word(text.data + 12);
  scene s = {json_loadb(text.data + 20, length, 0, NULL), text.data + 28 + length};
  assert_non_null(s.root);
  lam_arena_defer(arena, release, s.root);
  return s;
}

/* Item i of a list of the file ("nodes", "meshes" ...). */
static inline const json_t *item(const scene *s, const char *list, int i) {
  const json_t *found = json_array_get(json_object_get(s->root, list), (size_t)i);
  if (!found) fail_msg("no %s[%d]", list, i);
  return found;
}

static inline double number(const json_t *object, const char *key) {
  return json_number_value(json_object_get(object, key));
}

static inline void assert_list(const json_t *list, int count, const double *expected,
                               const char *what) {
  assert_int_equal(json_array_size(list), count);
  for (int k = 0; k < count; k++)
    assert_near_named(json_number_value(json_array_get(list, (size_t)k)), expected[k], 1e-7, what);
}

/* Fails when a node has another name, mesh (-1: none) or number of children. */
static inline void assert_node(const scene *s, int i, const char *name, int mesh, int children) {
  const json_t *node = item(s, "nodes", i), *given = json_object_get(node, "mesh");
  assert_string_equal(json_string_value(json_object_get(node, "name")), name);
  assert_int_equal(given ? json_integer_value(given) : -1, mesh);
  assert_int_equal(json_array_size(json_object_get(node, "children")), children);
}

/* The bytes of an accessor of `count` items of this type. */
static inline const char *data_of(const scene *s, int accessor, const char *type, int component,
                                  int count) {
  const json_t *a = item(s, "accessors", accessor);
  const json_t *view = item(s, "bufferViews", (int)number(a, "bufferView"));
  assert_string_equal(json_string_value(json_object_get(a, "type")), type);
  assert_int_equal(number(a, "componentType"), component);
  assert_int_equal(number(a, "count"), count);
  return s->binary + (size_t)(number(view, "byteOffset") + number(a, "byteOffset"));
}

static inline void assert_floats(const scene *s, int accessor, const char *type, int count,
                                 const double *expected, const char *what) {
  int width = strcmp(type, "VEC3") == 0 ? 3 : strcmp(type, "VEC2") == 0 ? 2 : 1;
  const char *bytes = data_of(s, accessor, type, 5126, count);
  for (int i = 0; i < count * width; i++) {
    float value;
    char which[64];
    memcpy(&value, bytes + 4 * i, 4);
    snprintf(which, sizeof which, "%s, number %d", what, i);
    assert_near_named(value, expected[i], 1e-6, which);
  }
}

/* 16-bit indices. */
static inline void assert_indices(const scene *s, const json_t *primitive, int count,
                                  const int *expected) {
  const char *bytes = data_of(s, (int)number(primitive, "indices"), "SCALAR", 5123, count);
  for (int i = 0; i < count; i++) {
    uint16_t value;
    memcpy(&value, bytes + 2 * i, 2);
    assert_int_equal(value, expected[i]);
  }
}

static inline const json_t *primitive_of(const scene *s, int mesh) {
  return json_array_get(json_object_get(item(s, "meshes", mesh), "primitives"), 0);
}

static inline int attribute(const json_t *primitive, const char *name) {
  const json_t *given = json_object_get(json_object_get(primitive, "attributes"), name);
  return given ? (int)json_integer_value(given) : -1;
}

#endif
