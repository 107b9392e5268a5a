/* Memory that runs out at every possible place: of a complete small design (parsing, surface, net,
 * lamellas, sheets, every writer) and of reading meshes. Each time control comes back to the
 * recovery point, everything is given back, and the next run works.
 *
 * Allocations of an arena come out of blocks, so a failing block stands for any of the allocations
 * that fill the one before. To hit others than the few at the end of a block, part of the first
 * block is used up beforehand, by another amount each time. */
#include "design/design.h"
#include "design/pipeline.h"
#include "formats/list/formats.h"
#include "library/session_state.h"
#include <lamella/lamella.h>

#include <malloc.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

enum {
  block = 1 << 18,
  piece = 1 << 9
}; /* of core/arena.c; other values only change which allocations are hit */

static const char design_text[] = "lamella: 1\nname: small\nsurface: {kind: enneper, size: 4 m}\n"
                                  "net: {kind: asymptotic, grid: [4, 4], orthogonal: yes}\n"
                                  "parts:\n  - {kind: lamella, height: 60 mm, thickness: 1 mm}\n"
                                  "sheets: {stock: [3 m, 1.5 m], kerf: 0.2 mm}\n";
static const char near_text[] =
    "lamella: 1\nname: near\nsurface: {kind: enneper, u: [-0.3, 0.3], v: [-0.3, 0.3], size: 4 m}\n"
    "net: {kind: free, grid: [4, 4], reference: {file: reference.obj}}\n";
static const char obj_text[] = "# a saddle\nv -3 -3 -2\nv 3 -3 2\nv 3 3 -2\nv -3 3 2\nf 1 2 3 4\n";
static const char stl_text[] =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";

enum { said_so = 1 };

/* A design from text to files; returns the bytes that it makes. Checks of the parts have memory of
 * their own: when that runs out, the build goes on, and the report must say that a stage has not
 * succeeded. */
static size_t make(lam_arena *arena, lam_errors *errors, const char *text) {
  lam_design design;
  lam_model model;
  lam_trimesh reference;
  lam_inputs inputs = {.reference = &reference};
  lam_design_text source = {.bytes = text, .count = strlen(text), .path = "small.yaml"};
  const lam_format *obj = lam_format_named("obj");
  if (!obj->read_triangles(arena, obj_text, strlen(obj_text), (lam_location){0}, errors,
                           &reference))
    return 0;
  if (!lam_design_parse(arena, &source, errors, &design)) return 0;
  if (!lam_pipeline_run(arena, &design, &inputs, NULL, errors, &model)) return 0;
  for (int i = 0; i < model.report->stage_count; i++) model.report->stages[i].seconds = 0;
  if (!lam_report_converged(model.report)) return said_so;
  size_t bytes = 0;
  for (int k = 0; k < lam_format_count; k++) {
    const lam_format *format = lam_formats[k];
    for (int i = 0; format->write && i < format->count(&model);
         i++) { /* the picture is rendered by a program */
      lam_text path = {.arena = arena}, out = {.arena = arena};
      format->path(&model, i, &path);
      if (format->write(&model, i, &out) != LAM_OK) return 0;
      bytes += path.length + out.length;
    }
  }
  return bytes;
}

static size_t make_design(lam_arena *arena, lam_errors *errors) {
  return make(arena, errors, design_text);
}
static size_t make_near(lam_arena *arena, lam_errors *errors) {
  return make(arena, errors, near_text);
}

static size_t read_meshes(lam_arena *arena, lam_errors *errors) {
  lam_mesh quads;
  lam_trimesh triangles;
  lam_location location = {"mesh", 0, 0};
  const lam_format *obj = lam_format_for("a.obj"), *stl = lam_format_for("a.stl");
  size_t read = 0;
  if (obj->read_mesh(arena, obj_text, strlen(obj_text), location, errors, &quads))
    read += (size_t)quads.vertex_count;
  if (obj->read_triangles(arena, obj_text, strlen(obj_text), location, errors, &triangles))
    read += (size_t)triangles.triangle_count;
  if (stl->read_triangles(arena, stl_text, strlen(stl_text), location, errors, &triangles))
    read += (size_t)triangles.triangle_count;
  return read;
}

/* A surface and a curve, written and read in every format that takes them. */
static size_t exchange_splines(lam_arena *arena, lam_errors *errors) {
  static const char *const files[][2] = {
      {"step", "a.step"}, {"iges", "a.igs"}, {"surface", "a.json"}, {"surface_obj", "a.obj"}};
  static const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 2, 2}, weights[] = {1, 2, 3, 4, 5, 6};
  static const lam_vec3 points[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                    {1, 1, 0}, {2, 0, 0}, {2, 1, .25}};
  lam_spline_surface roof = {"roof", {2, 1}, {3, 2}, {u, v}, points, weights};
  lam_named_curve line = {"A01", 0, {2, 3, u, points, weights}};
  lam_model model = {.name = "splines",
                     .version = "0",
                     .surface_count = 1,
                     .surfaces = &roof,
                     .curve_count = 1,
                     .curves = &line};
  size_t read = 0;
  for (int f = 0; f < 4; f++)
    for (int k = 0; k < lam_format_count; k++) {
      if (strcmp(lam_formats[k]->name, files[f][0]) != 0) continue;
      lam_text text = {.arena = arena};
      lam_spline_list surfaces;
      lam_curve_list curves;
      lam_location location = {files[f][1], 0, 0};
      const lam_format *reads = lam_format_for(files[f][1]);
      if (lam_formats[k]->write(&model, 0, &text) != LAM_OK) return 0;
      if (reads->read_surfaces(arena, text.data, text.length, location, errors, &surfaces))
        read += (size_t)surfaces.count;
      if (reads->read_curves(arena, text.data, text.length, location, errors, &curves))
        read += (size_t)curves.count;
    }
  return read;
}

/* What goes wrong on purpose: messages take memory too. */
static size_t complain(lam_arena *arena, lam_errors *errors) {
  static const char wrong[] = "lamella: 1\nname: wrong\nsurfaces: {kind: enneper}\nnet: {kind: "
                              "asymptotik, grid: [1]}\nsheets: 7\n";
  lam_design design;
  lam_design_text text = {.bytes = wrong, .count = strlen(wrong), .path = "wrong.yaml"};
  if (lam_design_parse(arena, &text, errors, &design)) return 0;
  size_t bytes = 0;
  for (const lam_error *e = errors->first; e; e = e->next) bytes += strlen(e->text);
  errors->count = 0;
  return bytes;
}

typedef size_t (*task)(lam_arena *arena, lam_errors *errors);

/* One run in which allocation number `failing` fails and `used` bytes of the first block are gone
 * beforehand. Returns the bytes made, 0 when memory ran out. */
static size_t run(task work, long failing, size_t used) {
  lam_alloc_fail_after(failing);
  lam_arena *arena = lam_arena_new();
  if (!arena) return 0;
  jmp_buf point;
  if (!LAM_ARENA_TRY(arena, point)) {
    lam_arena_free(arena);
    return 0;
  }
  for (size_t i = 0; i < used; i += piece) lam_arena_alloc(arena, piece, 1);
  lam_errors *errors = LAM_NEW(arena, lam_errors, 1);
  errors->arena = arena;
  size_t made = work(arena, errors);
  if (errors->count)
    fail_msg("allocation %ld, %zu bytes used: %s", failing, used, errors->first->text);
  lam_arena_free(arena);
  return made;
}

/* Fails allocations with the first block used up to different degrees, from `first` to `last` of
 * `steps`. Every step takes each stride-th allocation, another one than the step before. Returns
 * the number of failures. */
static long fail_everywhere(task work, int first, int last, int steps, int stride,
                            size_t expected) {
  long failures = 0;
  for (int step = first; step < last; step++) {
    size_t used = (size_t)block * (size_t)step / (size_t)steps;
    for (long n = step % stride;; n += stride, failures++) {
      size_t made = run(work, n, used);
      bool failed = lam_alloc_fail_after(-1) > n; /* the allocation that was to fail has come */
      if (!failed && made != expected)
        fail_msg("%zu bytes instead of %zu after failures", made, expected);
      if (failed && made && made != expected && made != said_so)
        fail_msg("allocation %ld, %zu bytes used: %zu bytes instead of %zu, and nobody says so", n,
                 used, made, expected);
      if (!failed) break;
    }
  }
  return failures;
}

/* Libraries and the allocator keep something of the first times: in the second half of the steps,
 * the memory in use grows by no more than a page and a few bytes per failure. (A leak sanitizer
 * sees the rest.) */
static void exhaust(task work, int steps, int stride) {
  size_t expected = run(work, -1, 0);
  assert_true(expected > said_so);
  assert_true(fail_everywhere(work, 0, steps / 2, steps, stride, expected) > 0);
  size_t before = mallinfo2().uordblks;
  long failures = fail_everywhere(work, steps / 2, steps, steps, stride, expected);
  size_t after = mallinfo2().uordblks;
  assert_true(failures > 0);
  if (after > before + 4096 + 16 * (size_t)failures)
    fail_msg("%zu bytes leak in %ld failures", after - before, failures);
}

static void a_design_survives(void **state) {
  (void)state;
  exhaust(make_design, 6, 6);
}

static void a_net_near_a_reference_survives(void **state) {
  (void)state;
  exhaust(make_near, 64, 1);
}

static void reading_meshes_survives(void **state) {
  (void)state;
  exhaust(read_meshes, 500, 1);
}

static void exchanging_splines_survives(void **state) {
  (void)state;
  exhaust(exchange_splines, 200, 1);
}

static void complaining_survives(void **state) {
  (void)state;
  exhaust(complain, 300, 1);
}

/* ---- sessions ---- */

/* z = x y, with its derivatives up to the second. */
static void saddle(const void *context, const double *numbers, double u, double v, lam_jet *jet) {
  (void)context;
  (void)numbers;
  *jet = (lam_jet){.x = {u, v, u * v}, .u = {1, 0, v}, .v = {0, 1, u}, .uv = {0, 0, 1}};
}

/* Adds a surface with allocation n failing and `used` bytes of the session's first block gone. It
 * is added, or the session knows nothing of it. Returns whether memory ran out. */
static bool add_surface(long n, size_t used) {
  const lam_surface_definition own = {
      .name = "own-saddle", .u = {-1, 1}, .v = {-1, 1}, .eval = saddle};
  lam_session *session;
  const lam_surface *surface;
  assert_int_equal(lam_session_new(&session), LAM_OK);
  for (size_t i = 0; i < used; i += piece) lam_arena_alloc(session->arena, piece, 1);

  lam_alloc_fail_after(n);
  lam_status added = lam_surface_add(session, &own);
  lam_alloc_fail_after(-1);
  assert_int_equal(lam_surface_read(session, "own-saddle", &surface),
                   added == LAM_OK ? LAM_OK : LAM_BAD_INPUT);
  lam_session_free(session);
  return added == LAM_NO_MEMORY;
}

/* The session's block ends at every place of the way in turn. */
static void a_surface_is_added_or_not(void **state) {
  (void)state;
  int failures = 0;
  for (size_t left = 0; left < 64; left++)
    for (long n = 0; n < 3; n++) failures += add_surface(n, block - left * piece);
  assert_true(failures > 64);
}

static int opened, closed;

static void count_closed(void *handle) {
  (void)handle;
  closed++;
}

static void defer_until_it_fails(lam_arena *arena) {
  jmp_buf point;
  if (!LAM_ARENA_TRY(arena, point)) return;
  for (;;) {
    opened++;
    lam_arena_defer(arena, count_closed, arena);
  }
}

/* What is handed over is closed exactly once, even when there is no memory left to remember it. */
static void what_is_deferred_is_closed(void **state) {
  (void)state;
  for (long n = 1; n < 4; n++) {
    opened = closed = 0;
    lam_alloc_fail_after(n);
    lam_arena *arena = lam_arena_new();
    assert_non_null(arena);
    defer_until_it_fails(arena);
    lam_arena_free(arena);
    lam_alloc_fail_after(-1);
    assert_int_equal(closed, opened);
    assert_true(opened > 1000 * (n - 1));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_surface_is_added_or_not),
      cmocka_unit_test(what_is_deferred_is_closed),
      cmocka_unit_test(a_design_survives),
      cmocka_unit_test(a_net_near_a_reference_survives),
      cmocka_unit_test(reading_meshes_survives),
      cmocka_unit_test(exchanging_splines_survives),
      cmocka_unit_test(complaining_survives),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
