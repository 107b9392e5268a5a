/* The face as a program sees it: sessions, messages, memory that runs out, the host's settings,
 * surfaces and nets of a program's own. Includes the public headers alone, but for the allocator's
 * test hook. */
#include <lamella/lamella.h>

#include <fenv.h>
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* core/arena.h: the n-th allocation from now on fails; a negative n: none. */
long lam_alloc_fail_after(long n);
/* solve/factor/front.h: an instruction set by name, or NULL; used from now on, NULL: the best. */
struct lam_front_kernels;
const struct lam_front_kernels *lam_front_kernels_named(const char *name);
void lam_front_kernels_force(const struct lam_front_kernels *kernels);

static const char small[] = "lamella: 1\nname: small\nsurface: {kind: enneper, size: 4 m}\n"
                            "net: {kind: asymptotic, grid: [6, 6], orthogonal: yes}\n"
                            "parts:\n  - {kind: lamella, height: 60 mm, thickness: 1 mm}\n"
                            "sheets: {stock: [3 m, 1.5 m], kerf: 0.2 mm}\n";

static lam_session *opened(void) {
  lam_session *session;
  assert_int_equal(lam_session_new(&session), LAM_OK);
  return session;
}

static lam_design_source source_of(const char *text) {
  return (lam_design_source){.path = "small.yaml", .text = text, .length = strlen(text)};
}

static const lam_model *built(lam_session *session, const char *text) {
  lam_design_source source = source_of(text);
  const lam_design *design;
  const lam_model *model;
  if (lam_design_read(session, &source, &design) != LAM_OK ||
      lam_design_build(session, design, &model) != LAM_OK)
    fail_msg("%s", lam_session_messages(session)->text);
  return model;
}

/* ---- versions and statuses ---- */

static void the_library_is_the_version_of_its_headers(void **state) {
  (void)state;
  char version[32];
  snprintf(version, sizeof version, "%d.%d.%d", LAM_VERSION_MAJOR, LAM_VERSION_MINOR,
           LAM_VERSION_PATCH);
  assert_string_equal(lam_version(), version);
  assert_string_equal(LAM_VERSION, version);
  assert_int_equal(LAM_VERSION_NUMBER, 100); /* 0.1.0 */
}

static void every_status_has_a_text_of_its_own(void **state) {
  (void)state;
  for (int a = LAM_OK; a <= LAM_FAILED; a++)
    for (int b = LAM_OK; b < a; b++)
      assert_string_not_equal(lam_status_text((lam_status)a), lam_status_text((lam_status)b));
  assert_string_equal(lam_status_text((lam_status)99), "unknown status");
}

/* ---- messages ---- */

static void messages_are_those_of_the_last_call(void **state) {
  (void)state;
  lam_session *session = opened();
  lam_design_source wrong = source_of("lamella: 1\nname: x\nsurface: {kind: ennepper}\nnte: {}\n");
  const lam_design *design = (const lam_design *)session;
  assert_int_equal(lam_design_read(session, &wrong, &design), LAM_BAD_INPUT);
  assert_null(design);

  const lam_error *first = lam_session_messages(session);
  assert_non_null(first);
  assert_string_equal(first->location.file, "small.yaml");
  assert_int_equal(first->location.line, 3);
  assert_string_equal(first->key, "surface.kind");
  assert_non_null(strstr(first->text, "(did you mean enneper?)"));
  assert_non_null(first->next);
  assert_string_equal(first->next->key, "nte");

  assert_string_equal(built(session, small)->name, "small");
  assert_null(lam_session_messages(session));
  lam_session_free(session);
}

static void a_missing_file_is_io_and_names_it(void **state) {
  (void)state;
  lam_session *session = opened();
  lam_design_source source = {.path = "/nowhere/at-all.yaml"};
  lam_mesh mesh;
  const lam_design *design;
  assert_int_equal(lam_design_read(session, &source, &design), LAM_IO);
  assert_string_equal(lam_session_messages(session)->location.file, "/nowhere/at-all.yaml");
  assert_int_equal(lam_read_mesh(session, "/nowhere/net.obj", &mesh), LAM_IO);
  assert_int_equal(lam_read_mesh(session, "/nowhere/net.txt", &mesh), LAM_BAD_INPUT);
  assert_non_null(strstr(lam_session_messages(session)->text, "expected .obj"));
  lam_session_free(session);
}

/* Two designs that start from each other's nets. */
static void write_text(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

static void designs_that_start_from_each_other_are_refused(void **state) {
  (void)state;
  char folder[] = "/tmp/lamella-session-XXXXXX", path[2][64];
  assert_non_null(mkdtemp(folder));
  for (int i = 0; i < 2; i++) {
    char text[200];
    snprintf(path[i], sizeof path[i], "%s/%c.yaml", folder, 'a' + i);
    snprintf(text, sizeof text,
             "lamella: 1\nname: %c\nnet: {kind: asymptotic, from: {design: %c}}\n", 'a' + i,
             'b' - i);
    write_text(path[i], text);
  }

  lam_session *session = opened();
  lam_design_source source = {.path = path[0]};
  const lam_design *design;
  const lam_model *model;
  assert_int_equal(lam_design_read(session, &source, &design), LAM_OK);
  assert_int_equal(lam_design_build(session, design, &model), LAM_BAD_INPUT);
  assert_null(model);
  assert_non_null(strstr(lam_session_messages(session)->text, "starts from itself, through 2"));

  lam_session_free(session);
  for (int i = 0; i < 2; i++) remove(path[i]);
  remove(folder);
}

/* ---- memory ---- */

/* The bytes of all files of the model but the picture; 0 when a call fails. */
static size_t encode_all(lam_session *session, const lam_model *model) {
  static const char *const formats[] = {"report", "obj", "stl", "scad", "dxf", "svg",
                                        "gltf",   "bom", "pov", "step", "iges"};
  size_t bytes = 0;
  for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
    for (int i = 0; i < lam_model_file_count(model, formats[f]); i++) {
      lam_bytes file;
      if (lam_model_encode(session, model, formats[f], i, &file) != LAM_OK) return 0;
      bytes += file.length;
    }
  return bytes;
}

/* Allocation number n fails: every call says LAM_NO_MEMORY, or all succeed. Afterwards the same
 * session does the whole work. */
static void memory_that_runs_out_is_a_status(void **state) {
  (void)state;
  lam_session *session = opened();
  size_t whole = encode_all(session, built(session, small));
  assert_true(whole > 100000);
  lam_session_clear(session);

  int failed = 0;
  for (long n = 0; n < 60; n++) {
    const char *const finer[] = {"net.grid=[24, 24]"};
    lam_design_source source = source_of(small);
    source.overrides = finer; /* its memory comes in more than a few blocks */
    source.override_count = 1;
    const lam_design *design;
    const lam_model *model = NULL;
    lam_alloc_fail_after(n);
    lam_status status = lam_design_read(session, &source, &design);
    if (status == LAM_OK) status = lam_design_build(session, design, &model);
    lam_alloc_fail_after(-1);

    if (status != LAM_OK) {
      assert_int_equal(status, LAM_NO_MEMORY);
      assert_string_equal(lam_session_messages(session)->text, "out of memory");
      failed++;
    } else {
      assert_non_null(model);
    }
    lam_session_clear(session);
  }
  assert_true(failed > 5);
  assert_int_equal(encode_all(session, built(session, small)), whole);
  lam_session_free(session);
}

static void what_was_given_before_memory_ran_out_stays(void **state) {
  (void)state;
  lam_session *session = opened();
  const lam_model *model = built(session, small);
  size_t whole = encode_all(session, model);

  lam_design_source source = source_of(small);
  const lam_design *design;
  lam_alloc_fail_after(0);
  lam_status status = LAM_OK;
  for (int i = 0; i < 100 && status == LAM_OK; i++)
    status = lam_design_read(session, &source, &design);
  lam_alloc_fail_after(-1);
  assert_int_equal(status, LAM_NO_MEMORY);
  assert_int_equal(encode_all(session, model), whole);
  lam_session_free(session);
}

static void no_memory_for_a_session_is_a_status(void **state) {
  (void)state;
  for (long n = 0; n < 2; n++) {
    lam_session *session = (lam_session *)1;
    lam_alloc_fail_after(n);
    assert_int_equal(lam_session_new(&session), LAM_NO_MEMORY);
    lam_alloc_fail_after(-1);
    assert_null(session);
  }
  lam_session_free(NULL);
}

/* ---- the host ---- */

/* Rounding mode, locale and a signal handler are as before. */
static void the_host_keeps_its_settings(void **state) {
  (void)state;
  fesetround(FE_UPWARD);
  void (*handler)(int) = signal(SIGINT, SIG_IGN);

  lam_session *session = opened();
  built(session, small);
  lam_session_free(session);

  assert_int_equal(fegetround(), FE_UPWARD);
  fesetround(FE_TONEAREST);
  assert_ptr_equal(signal(SIGINT, handler), SIG_IGN);
  assert_string_equal(setlocale(LC_ALL, NULL), "C");
}

/* Every instruction set gives the same model, byte by byte. */
static void the_processor_makes_no_difference(void **state) {
  static const char *const sets[] = {"plain", "avx2", "avx512", "neon"};
  (void)state;
  char *first = NULL;
  for (int i = 0; i < 4; i++) {
    if (!lam_front_kernels_named(sets[i])) continue;
    lam_front_kernels_force(lam_front_kernels_named(sets[i]));
    lam_session *session = opened();
    const lam_model *model = built(session, small);
    lam_bytes file;
    assert_int_equal(lam_model_encode(session, model, "report", 0, &file), LAM_OK);
    if (!first) first = strdup(file.data);
    assert_string_equal(file.data, first);
    lam_session_free(session);
  }
  free(first);
  lam_front_kernels_force(NULL);
}

/* ---- designs and models ---- */

/* Building twice from one design gives the same: it is not changed. */
static void a_design_is_only_read(void **state) {
  (void)state;
  lam_session *session = opened();
  lam_design_source source = {.path = "templates/designs/sail.yaml"};
  const lam_design *design;
  const lam_model *models[2];
  assert_int_equal(lam_design_read(session, &source, &design), LAM_OK);
  const char *text[2];
  assert_int_equal(lam_design_describe(session, design, &text[0]), LAM_OK);
  for (int i = 0; i < 2; i++)
    assert_int_equal(lam_design_build(session, design, &models[i]), LAM_OK);
  assert_int_equal(lam_design_describe(session, design, &text[1]), LAM_OK);
  assert_string_equal(text[0], text[1]);

  const lam_mesh *a = models[0]->net, *b = models[1]->net;
  assert_int_equal(a->vertex_count, b->vertex_count);
  assert_memory_equal(a->vertices, b->vertices, sizeof *a->vertices * (size_t)a->vertex_count);
  lam_session_free(session);
}

static void overrides_change_a_design(void **state) {
  (void)state;
  lam_session *session = opened();
  const char *const overrides[] = {"name=other", "net.grid=[4, 8]"};
  lam_design_source source = source_of(small);
  source.overrides = overrides;
  source.override_count = 2;
  const lam_design *design;
  const lam_model *model;
  assert_int_equal(lam_design_read(session, &source, &design), LAM_OK);
  assert_string_equal(lam_design_name(design), "other");
  assert_int_equal(lam_design_build(session, design, &model), LAM_OK);
  assert_int_equal(model->net->vertex_count, 5 * 9);
  lam_session_free(session);
}

static void files_are_counted_and_named(void **state) {
  (void)state;
  lam_session *session = opened();
  const lam_model *model = built(session, small);
  lam_bytes file;
  assert_int_equal(lam_model_file_count(model, "report"), 1);
  assert_int_equal(lam_model_file_count(model, "png"), 0);
  assert_int_equal(lam_model_file_count(model, "nonsense"), 0);
  assert_int_equal(lam_model_encode(session, model, "report", 0, &file), LAM_OK);
  assert_string_equal(file.name, "report.json");
  assert_int_equal(strlen(file.data), file.length);
  assert_int_equal(lam_model_encode(session, model, "report", 1, &file), LAM_BAD_INPUT);
  assert_int_equal(lam_model_encode(session, model, "report", -1, &file), LAM_BAD_INPUT);
  assert_null(file.data);
  lam_session_free(session);
}

static void formats_that_do_not_exist_are_refused(void **state) {
  (void)state;
  lam_session *session = opened();
  lam_write_options options = {.folder = "/nowhere", .only = "stl,dfx"};
  assert_int_equal(lam_write_options_check(session, &options), LAM_BAD_INPUT);
  assert_string_equal(lam_session_messages(session)->key, "--only");
  assert_non_null(strstr(lam_session_messages(session)->text, "(did you mean dxf?)"));
  assert_int_equal(lam_model_write(session, built(session, small), &options, NULL), LAM_BAD_INPUT);
  lam_session_free(session);
}

/* ---- surfaces ---- */

/* The paraboloid z = a (u^2 + v^2): at the origin both curvatures are 2 a. wrong: the factor of
 * x_uv, 0 in truth. */
static void paraboloid(const void *context, const double *numbers, double u, double v,
                       lam_jet *jet) {
  double a = numbers[0], wrong = context ? *(const double *)context : 0;
  jet->x = (lam_vec3){u, v, a * (u * u + v * v)};
  jet->u = (lam_vec3){1, 0, 2 * a * u};
  jet->v = (lam_vec3){0, 1, 2 * a * v};
  jet->uu = jet->vv = (lam_vec3){0, 0, 2 * a};
  jet->uv = (lam_vec3){0, 0, wrong};
}

static const lam_surface_number steepness[] = {
    {"steepness", LAM_PLAIN_NUMBER, "0.25", -10, 10, "Half the curvature at the middle."}};
static const lam_surface_definition bowl = {.name = "bowl",
                                            .number_count = 1,
                                            .numbers = steepness,
                                            .u = {-1, 1},
                                            .v = {-2, 3},
                                            .eval = paraboloid};

static void a_surface_of_ones_own_has_keys_and_a_net(void **state) {
  (void)state;
  lam_session *session = opened();
  assert_int_equal(lam_surface_add(session, &bowl), LAM_OK);

  const lam_surface *surface;
  double u[2], v[2];
  lam_jet jet;
  assert_int_equal(lam_surface_read(session, "{kind: bowl, steepness: 0.5}", &surface), LAM_OK);
  lam_surface_domain(surface, u, v);
  assert_true(u[0] == -1 && u[1] == 1 && v[0] == -2 && v[1] == 3);
  lam_surface_jet(surface, .5, 2, &jet);
  assert_true(jet.x.z == .5 * (.25 + 4) && jet.uu.z == 1);

  const lam_model *model = built(session, "{lamella: 1, name: b, surface: {kind: bowl, u: [-1, 1], "
                                          "v: [-1, 1]}, net: {kind: planar-quads, grid: [6, 6], "
                                          "from: {lines: natural}}}");
  assert_int_equal(model->net->vertex_count, 49);
  const char *page, *list;
  assert_int_equal(lam_reference_page(session, "bowl", &page), LAM_OK);
  assert_non_null(strstr(page, "Half the curvature at the middle."));
  assert_int_equal(lam_reference_list(session, "surfaces", &list), LAM_OK);
  assert_non_null(strstr(list, "\nbowl "));

  /* It stays when the session is cleared, and is unknown to another session. */
  lam_session_clear(session);
  assert_int_equal(lam_surface_read(session, "bowl", &surface), LAM_OK);
  lam_session *other = opened();
  assert_int_equal(lam_surface_read(other, "bowl", &surface), LAM_BAD_INPUT);
  lam_session_free(other);
  lam_session_free(session);
}

static void refused(lam_session *session, lam_surface_definition definition, const char *words) {
  assert_int_equal(lam_surface_add(session, &definition), LAM_BAD_INPUT);
  const lam_error *error = lam_session_messages(session);
  if (!strstr(error->text, words)) fail_msg("%s; expected: %s", error->text, words);
  const lam_surface *surface;
  if (definition.name && strcmp(definition.name, "enneper") != 0)
    assert_int_equal(lam_surface_read(session, definition.name, &surface), LAM_BAD_INPUT);
}

static void a_wrong_definition_is_refused(void **state) {
  (void)state;
  static const double off = .1;
  lam_session *session = opened();
  lam_surface_definition d = bowl;
  d.context = &off;
  refused(session, d, "differs from its difference quotient");
  d = bowl;
  d.name = "enneper";
  refused(session, d, "of this name already");
  d = bowl;
  d.name = "two words";
  refused(session, d, "expected letters");
  d = bowl;
  d.eval = NULL;
  refused(session, d, "missing");
  d = bowl;
  d.u[1] = -1;
  refused(session, d, "from a smaller to a larger");
  assert_int_equal(lam_surface_add(session, &bowl), LAM_OK); /* the refused ones left nothing */
  lam_session_free(session);
}

/* ---- nets ---- */

enum { side = 7, vertex_count = side * side, face_count = (side - 1) * (side - 1) };

static lam_mesh saddle(lam_vec3 *vertices, int (*faces)[4]) {
  for (int i = 0; i < side; i++)
    for (int j = 0; j < side; j++) {
      double x = (i - 3) * .2, y = (j - 3) * .2;
      vertices[i * side + j] = (lam_vec3){x, y, .3 * x * y + .05 * x * x * x};
    }
  for (int i = 0, f = 0; i + 1 < side; i++)
    for (int j = 0; j + 1 < side; j++, f++) {
      int corner = i * side + j;
      faces[f][0] = corner, faces[f][1] = corner + side;
      faces[f][2] = corner + side + 1, faces[f][3] = corner + 1;
    }
  return (lam_mesh){vertex_count, vertices, face_count, faces};
}

static const lam_measure *named(int count, const lam_measure *measures, const char *name) {
  for (int i = 0; i < count; i++)
    if (strcmp(measures[i].name, name) == 0) return &measures[i];
  fail_msg("no measure %s", name);
  return NULL;
}

static void a_net_from_arrays_is_solved_and_measured(void **state) {
  (void)state;
  lam_vec3 vertices[vertex_count];
  int faces[face_count][4];
  lam_session *session = opened();
  lam_net_task task = {.net = "asymptotic", .start = saddle(vertices, faces)};
  lam_vec3 before = vertices[10];
  lam_net_solution solution;
  assert_int_equal(lam_net_solve(session, &task, &solution), LAM_OK);
  assert_true(solution.converged);
  assert_int_equal(solution.mesh.vertex_count, vertex_count);
  assert_int_equal(solution.polyline_count, 2 * side);
  assert_memory_equal(&before, &vertices[10], sizeof before); /* what is given is only read */

  lam_measure_task measuring = {.mesh = &solution.mesh, .as = "asymptotic"};
  lam_measured measured;
  assert_int_equal(lam_measure_net(session, &measuring, &measured), LAM_OK);
  const lam_measure *own = named(solution.measure_count, solution.measures, "star_planarity");
  const lam_measure *again = named(measured.measure_count, measured.measures, "star_planarity");
  assert_true(own->max < 1e-9);
  assert_true(own->max == again->max);
  assert_int_equal(measured.boundary_loops, 1);
  lam_session_free(session);
}

static void a_net_that_is_none_is_refused(void **state) {
  (void)state;
  lam_vec3 vertices[vertex_count];
  int faces[face_count][4];
  lam_session *session = opened();
  lam_net_solution solution;
  lam_net_task task = {.net = "{kind: nothing}", .start = saddle(vertices, faces)};
  assert_int_equal(lam_net_solve(session, &task, &solution), LAM_BAD_INPUT);
  task.net = "asymptotic";
  faces[3][2] = vertex_count;
  assert_int_equal(lam_net_solve(session, &task, &solution), LAM_BAD_INPUT);
  assert_non_null(strstr(lam_session_messages(session)->text, "face 4 names vertex 50"));
  assert_null(solution.mesh.vertices);
  lam_session_free(session);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_library_is_the_version_of_its_headers),
      cmocka_unit_test(every_status_has_a_text_of_its_own),
      cmocka_unit_test(messages_are_those_of_the_last_call),
      cmocka_unit_test(a_missing_file_is_io_and_names_it),
      cmocka_unit_test(designs_that_start_from_each_other_are_refused),
      cmocka_unit_test(memory_that_runs_out_is_a_status),
      cmocka_unit_test(what_was_given_before_memory_ran_out_stays),
      cmocka_unit_test(no_memory_for_a_session_is_a_status),
      cmocka_unit_test(the_host_keeps_its_settings),
      cmocka_unit_test(the_processor_makes_no_difference),
      cmocka_unit_test(a_design_is_only_read),
      cmocka_unit_test(overrides_change_a_design),
      cmocka_unit_test(files_are_counted_and_named),
      cmocka_unit_test(formats_that_do_not_exist_are_refused),
      cmocka_unit_test(a_surface_of_ones_own_has_keys_and_a_net),
      cmocka_unit_test(a_wrong_definition_is_refused),
      cmocka_unit_test(a_net_from_arrays_is_solved_and_measured),
      cmocka_unit_test(a_net_that_is_none_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
