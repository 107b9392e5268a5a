/* Sessions in threads: two of them build at the same time, again and again, and each gets the bytes
 * that it gets alone. Run under the thread sanitizer too: make check config=thread. */
#include <lamella/lamella.h>

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static const char *const designs[] = {
    "lamella: 1\nname: a\nsurface: {kind: enneper, size: 4 m}\n"
    "net: {kind: asymptotic, grid: [8, 8], orthogonal: yes}\n"
    "parts: [{kind: lamella, height: 60 mm, thickness: 1 mm}]\n",
    "lamella: 1\nname: b\nsurface: {kind: monge, x2: -0.3, y2: -0.2, size: 3 m}\n"
    "net: {kind: planar-quads, grid: [8, 8]}\nparts: [{kind: panels, thickness: 5 mm}]\n"};

/* FNV-1a over all files of a model: equal for equal bytes. */
static uint64_t hash_files(lam_session *session, const lam_model *model) {
  static const char *const formats[] = {"report", "obj", "stl", "scad", "dxf", "gltf", "bom"};
  uint64_t hash = 14695981039346656037u;
  for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
    for (int i = 0; i < lam_model_file_count(model, formats[f]); i++) {
      lam_bytes file;
      if (lam_model_encode(session, model, formats[f], i, &file) != LAM_OK) return 0;
      for (size_t k = 0; k < file.length; k++)
        hash = (hash ^ (unsigned char)file.data[k]) * 1099511628211u;
    }
  return hash;
}

static uint64_t build(const char *text) {
  lam_session *session;
  lam_design_source source = {.text = text, .length = strlen(text)};
  const lam_design *design;
  const lam_model *model;
  if (lam_session_new(&session) != LAM_OK) return 0;
  uint64_t hash = 0;
  if (lam_design_read(session, &source, &design) == LAM_OK &&
      lam_design_build(session, design, &model) == LAM_OK)
    hash = hash_files(session, model);
  lam_session_free(session);
  return hash;
}

enum { rounds = 4 };

typedef struct worker {
  const char *text;
  uint64_t hash[rounds];
} worker;

static void *work(void *context) {
  worker *w = context;
  for (int i = 0; i < rounds; i++) w->hash[i] = build(w->text);
  return NULL;
}

static void two_sessions_build_at_the_same_time(void **state) {
  (void)state;
  uint64_t alone[2] = {build(designs[0]), build(designs[1])};
  assert_true(alone[0] && alone[1] && alone[0] != alone[1]);

  worker workers[2] = {{.text = designs[0]}, {.text = designs[1]}};
  pthread_t threads[2];
  for (int i = 0; i < 2; i++)
    assert_int_equal(pthread_create(&threads[i], NULL, work, &workers[i]), 0);
  for (int i = 0; i < 2; i++) pthread_join(threads[i], NULL);
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < rounds; k++)
      if (workers[i].hash[k] != alone[i])
        fail_msg("thread %d, round %d: other bytes than alone", i, k);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(two_sessions_build_at_the_same_time)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
