/* Models written into folders: which files, the list that is kept of them, rules for make, options,
 * pictures by a stand-in for POV-Ray, color maps. Includes the public headers alone. Runs in the
 * project's folder. */
#include <lamella/lamella.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

/* A net of 2 x 2 cells that starts from a file beside the design. */
static const char design_text[] =
    "lamella: 1\nname: tent\nnet: {kind: free, from: {file: \"my start.obj\"}}\n";
static const char start_text[] = "v 0 0 0\nv 0 1 0\nv 0 2 0\nv 1 0 0\nv 1 1 .5\nv 1 2 0\nv 2 0 0\n"
                                 "v 2 1 0\nv 2 2 0\nf 1 4 5 2\nf 2 5 6 3\nf 4 7 8 5\nf 5 8 9 6\n";

typedef struct fixture {
  lam_session *session;
  const lam_model *model;
  char base[32];              /* a new folder in /tmp */
  char design[64], out[64];   /* base/my $tent #1.yaml, base/out */
  char text[4096], name[128]; /* the file read last; a path made last */
} fixture;

static const char *path_in(fixture *f, const char *folder, const char *name) {
  snprintf(f->name, sizeof f->name, "%s/%s", folder, name);
  return f->name;
}

static void put(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  if (!file) fail_msg("%s cannot be written", path);
  fputs(text, file);
  fclose(file);
}

/* The whole file; NULL: it is not there. */
static const char *get(fixture *f, const char *folder, const char *name) {
  FILE *file = fopen(path_in(f, folder, name), "r");
  if (!file) return NULL;
  f->text[fread(f->text, 1, sizeof f->text - 1, file)] = 0;
  fclose(file);
  return f->text;
}

/* Makes base/bin/NAME a program, and the only folder of PATH with it. */
static void stand_in(fixture *f, const char *name, const char *script) {
  char bin[64], path[96];
  snprintf(bin, sizeof bin, "%s/bin", f->base);
  mkdir(bin, 0777);
  put(path_in(f, bin, name), script);
  chmod(f->name, 0755);
  snprintf(path, sizeof path, "%s:/usr/bin:/bin", bin);
  setenv("PATH", path, 1);
}

static int set_up(void **state) {
  static fixture f;
  f = (fixture){.base = "/tmp/lamella-write-XXXXXX"};
  if (!mkdtemp(f.base) || lam_session_new(&f.session) != LAM_OK) return -1;
  snprintf(f.design, sizeof f.design, "%s/my $tent #1.yaml", f.base);
  snprintf(f.out, sizeof f.out, "%s/out", f.base);
  put(f.design, design_text);
  put(path_in(&f, f.base, "my start.obj"), start_text);
  lam_session_set_templates(f.session, "templates");
  stand_in(&f, "povray", "#!/bin/sh\nexit 1\n"); /* no test waits for a real picture */

  lam_design_source source = {.path = f.design};
  const lam_design *design;
  if (lam_design_read(f.session, &source, &design) != LAM_OK ||
      lam_design_build(f.session, design, &f.model) != LAM_OK) {
    print_error("%s\n", lam_session_messages(f.session)->text);
    return -1;
  }
  *state = &f;
  return 0;
}

static int tear_down(void **state) {
  fixture *f = *state;
  char command[64];
  lam_session_free(f->session);
  snprintf(command, sizeof command, "rm -r %s", f->base);
  return system(command);
}

static lam_written written_as(fixture *f, const lam_model *model, lam_write_options options) {
  lam_written written;
  if (!options.folder) options.folder = f->out;
  lam_status status = lam_model_write(f->session, model, &options, &written);
  if (status != LAM_OK) fail_msg("%d: %s", status, lam_session_messages(f->session)->text);
  return written;
}

static void assert_first(fixture *f, const char *key, const char *text) {
  const lam_error *first = lam_session_messages(f->session);
  assert_non_null(first);
  assert_string_equal(first->text, text);
  if (key) assert_string_equal(first->key, key);
}

/* ---- folders and lists ---- */

/* The names in a folder's list, without the hashes behind them. */
static void assert_listed(fixture *f, const char *folder, const char *expected) {
  char names[sizeof f->text] = "";
  for (char *line = strtok((char *)get(f, folder, ".lamella-files"), "\n"); line;
       line = strtok(NULL, "\n")) {
    char *blank = strrchr(line, ' ');
    if (blank && strlen(blank) == 17) *blank = 0;
    strcat(strcat(names, line), "\n");
  }
  assert_string_equal(names, expected);
}

/* The list has the design's name, then the files in the order of their names; lam_written has them
 * in the order of the formats. */
static void files_are_listed_in_their_folder(void **state) {
  fixture *f = *state;
  char deep[96];
  snprintf(deep, sizeof deep, "%s/a/b", f->base);
  lam_written w =
      written_as(f, f->model, (lam_write_options){.folder = deep, .only = "report,obj"});
  assert_int_equal(w.file_count, 2);
  assert_string_equal(w.files[0], path_in(f, deep, "net.obj"));
  assert_string_equal(w.files[1], path_in(f, deep, "report.json"));
  assert_int_equal(w.removed, 0);
  assert_listed(f, deep, "tent\nnet.obj\nreport.json\n");
  assert_non_null(strstr(get(f, deep, "net.obj"), "f 5 8 9 6"));
}

/* Templates that a scene needs stand beside it, by their own names. */
static void what_files_need_stands_beside_them(void **state) {
  fixture *f = *state;
  written_as(f, f->model, (lam_write_options){.only = "pov"});
  assert_listed(f, f->out,
                "tent\ncamera.inc\nground.inc\nlight.inc\nmaterials.inc\npeople.inc\n"
                "plaza.inc\nrender.ini\nsky.inc\ntent.pov\ntrees.inc\n");
  char copy[sizeof f->text];
  strcpy(copy, get(f, f->out, "camera.inc"));
  assert_string_equal(copy, get(f, "templates/pov", "camera.inc"));
}

/* only and skip keep what they leave out, and its names; a whole build takes away what it does not
 * make: of this design, in this folder. */
static void a_whole_build_takes_away_what_is_gone(void **state) {
  fixture *f = *state;
  written_as(f, f->model, (lam_write_options){.only = "report"});
  put(path_in(f, f->out, "gone.stl"), "x");
  put(path_in(f, f->out, "mine.stl"), "x");
  put(path_in(f, f->base, "outside"), "x");
  char absolute[160];
  snprintf(absolute, sizeof absolute,
           "tent\n../outside\n%s/outside\ngone.stl\nmissing.stl\nx/../y\n", f->base);
  put(path_in(f, f->out, ".lamella-files"), absolute);

  lam_written w = written_as(f, f->model, (lam_write_options){.only = "report,obj"});
  assert_int_equal(w.removed, 0);
  assert_listed(f, f->out, "tent\ngone.stl\nmissing.stl\nnet.obj\nreport.json\n");
  w = written_as(f, f->model, (lam_write_options){.skip = "png,obj,pov"});
  assert_int_equal(w.removed, 0);
  assert_non_null(get(f, f->out, "gone.stl"));

  /* another design leaves all of it, and begins a list of its own */
  lam_model other = *f->model;
  other.name = "tents";
  w = written_as(f, &other, (lam_write_options){0});
  assert_int_equal(w.removed, 0);
  assert_non_null(get(f, f->out, "gone.stl"));
  assert_memory_equal(get(f, f->out, ".lamella-files"), "tents\n", 6);

  put(path_in(f, f->out, ".lamella-files"), absolute);
  lam_model same = other;
  same.name = "tent";
  w = written_as(f, &same, (lam_write_options){0});
  assert_int_equal(w.removed, 1); /* missing.stl was gone already */
  assert_null(get(f, f->out, "gone.stl"));
  assert_non_null(get(f, f->out, "mine.stl"));
  assert_non_null(get(f, f->base, "outside"));
  assert_non_null(get(f, f->out, "net.obj"));
  assert_null(strstr(get(f, f->out, ".lamella-files"), "stl"));
}

/* ---- rules for make ---- */

/* Spaces and # stand behind a backslash, $ is doubled; every file has an empty rule of its own. */
static void rules_name_what_a_build_was_made_from(void **state) {
  fixture *f = *state;
  char deps[64], expected[1024];
  snprintf(deps, sizeof deps, "%s/d", f->base);
  written_as(f, f->model, (lam_write_options){.only = "report", .deps = deps});
  const char *b = f->base;
  snprintf(expected, sizeof expected,
           "%s/out/report.json: \\\n  %s/my\\ $$tent\\ \\#1.yaml \\\n  %s/my\\ start.obj\n"
           "%s/my\\ $$tent\\ \\#1.yaml:\n%s/my\\ start.obj:\n",
           b, b, b, b, b);
  assert_string_equal(get(f, b, "d"), expected);

  /* a model that this session did not build: the templates alone */
  lam_model copy = *f->model;
  written_as(f, &copy, (lam_write_options){.only = "pov", .deps = deps});
  snprintf(expected, sizeof expected, "%s/out/report.json: \\\n  templates/pov/render.ini \\\n", b);
  assert_memory_equal(get(f, b, "d"), expected, strlen(expected));
  assert_non_null(strstr(f->text, "\ntemplates/pov/render.ini:\ntemplates/pov/materials.inc:\n"));
  assert_null(strstr(f->text, "yaml"));
}

/* ---- options ---- */

static void options_name_formats(void **state) {
  fixture *f = *state;
  lam_write_options good = {.only = "report,obj", .skip = "png"},
                    bad = {.folder = f->out, .skip = "obj,reprot,zzz"};
  assert_int_equal(lam_write_options_check(f->session, &good), LAM_OK);
  assert_int_equal(lam_write_options_check(f->session, &bad), LAM_BAD_INPUT);
  assert_first(f, "--skip",
               "reprot; expected formats of `lamella list formats` (did you mean report?)");
  assert_string_equal(lam_session_messages(f->session)->next->text,
                      "zzz; expected formats of `lamella list formats`");
  assert_null(lam_session_messages(f->session)->next->next);

  lam_written written = {7, NULL, 7, 7};
  assert_int_equal(lam_model_write(f->session, f->model, &bad, &written), LAM_BAD_INPUT);
  assert_int_equal(written.file_count, 0);
  assert_int_equal(access(f->out, F_OK), -1); /* nothing was begun */

  /* whole names: surface_obj is neither obj nor surface */
  static const double knots[4] = {0, 0, 1, 1};
  static const lam_vec3 points[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  const lam_spline_surface surface = {"s", {1, 1}, {2, 2}, {knots, knots}, points, NULL};
  lam_model model = *f->model;
  model.surface_count = 1;
  model.surfaces = &surface;
  lam_written w = written_as(f, &model, (lam_write_options){.only = "surface_obj"});
  assert_int_equal(w.file_count, 1);
  assert_string_equal(w.files[0], path_in(f, f->out, "surface.obj"));
  w = written_as(f, f->model, (lam_write_options){.only = "report,obj", .skip = "obj"});
  assert_int_equal(w.file_count, 1);
  assert_string_equal(w.files[0], path_in(f, f->out, "report.json"));
}

/* Seconds are told only when they are asked for; the model keeps its own. */
static void reports_have_no_times_unless_asked(void **state) {
  fixture *f = *state;
  lam_model timed = *f->model;
  lam_stage stages[2] = {f->model->report->stages[0], f->model->report->stages[0]};
  stages[0].seconds = 1.5;
  const lam_report report = {1, stages};
  timed.report = &report;
  written_as(f, &timed, (lam_write_options){.only = "report"});
  assert_null(strstr(get(f, f->out, "report.json"), "\"seconds\""));
  assert_true(stages[0].seconds == 1.5);
  written_as(f, &timed, (lam_write_options){.only = "report", .timings = true});
  assert_non_null(strstr(get(f, f->out, "report.json"), "\"seconds\": 1.5"));
}

static void what_cannot_be_written_is_io(void **state) {
  fixture *f = *state;
  lam_write_options options = {.folder = f->design, .only = "report"};
  assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_IO);
  assert_first(f, NULL, "is not a folder: Not a directory");
  options = (lam_write_options){.folder = f->out, .only = "report", .deps = f->base};
  assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_IO);
  assert_string_equal(lam_session_messages(f->session)->location.file, f->base);

  lam_session_set_templates(f->session, "/nowhere");
  options = (lam_write_options){.folder = f->out, .only = "pov"};
  assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_IO);
  assert_string_equal(lam_session_messages(f->session)->location.file, "/nowhere/pov/render.ini");
}

typedef struct steps {
  int count;
  char stage[16][16];
  double fraction[16];
} steps;

static void note_step(void *context, const char *stage, double fraction, const char *detail) {
  steps *s = context;
  if (s->count < 16) {
    snprintf(s->stage[s->count], sizeof *s->stage, "%s", stage ? stage : "-");
    s->fraction[s->count++] = fraction;
  }
  assert_string_equal(detail, "");
}

/* obj is the first format, and report the last: it is written when all else is there. At the end
 * all is done. */
static void progress_is_told_by_format(void **state) {
  fixture *f = *state;
  steps s = {0};
  const char *formats;
  int count = 0;
  lam_session_set_progress(f->session, &(lam_progress){note_step, &s});
  written_as(f, f->model, (lam_write_options){.only = "report,obj"});
  assert_int_equal(s.count, 3);
  assert_string_equal(s.stage[0], "obj");
  assert_string_equal(s.stage[1], "report");
  assert_string_equal(s.stage[2], "-");
  assert_true(s.fraction[0] == 0 && s.fraction[1] > 0 && s.fraction[2] == 1);
  lam_session_set_progress(f->session, NULL);
  assert_int_equal(lam_reference_list(f->session, "formats", &formats), LAM_OK);
  for (const char *at = formats; *at; at++) count += *at == '\n' && at[1] && at[1] != ' ';
  if (fabs((1 - s.fraction[1]) * (count + 1) - 1) > 1e-12)
    fail_msg("report begins at %.17g, expected 1 - 1 / %d", s.fraction[1], count + 1);
}

static void files_are_given_as_bytes(void **state) {
  fixture *f = *state;
  lam_bytes file;
  assert_int_equal(lam_model_encode(f->session, f->model, "obj", 0, &file), LAM_OK);
  assert_string_equal(file.name, "net.obj");
  assert_int_equal(file.length, strlen(file.data));
  assert_int_equal(lam_model_encode(f->session, f->model, "obj", 1, &file), LAM_BAD_INPUT);
  assert_first(f, NULL, "there is no file 1 of format obj");
  assert_null(file.name);
}

/* ---- pictures ---- */

static void povray_gets_the_scene_and_the_size(void **state) {
  fixture *f = *state;
  lam_model model = *f->model;
  model.picture = (lam_picture){"plaza", "auto", 64, 36, "thumb"};
  stand_in(f, "povray",
           "#!/bin/sh\necho \"$@\" >said; pwd >>said; echo picture >.lamella-part.png\n");
  lam_written w = written_as(f, &model, (lam_write_options){.only = "pov,png"});
  assert_string_equal(w.files[w.file_count - 1], path_in(f, f->out, "tent.png"));
  char expected[160];
  snprintf(
      expected, sizeof expected,
      "render.ini[thumb] +Itent.pov +O.lamella-part.png +W64 +H36 -D +V +L. +Ltemplates/pov\n%s\n",
      f->out);
  assert_string_equal(get(f, f->out, "said"), expected);
  assert_string_equal(get(f, f->out, "tent.png"), "picture\n");
  assert_null(get(f, f->out, ".lamella-part.png"));
  assert_null(lam_session_notes(f->session));
}

/* A picture that fails is a note with povray's own words, and the one before stays. */
static void povray_may_fail(void **state) {
  fixture *f = *state;
  lam_model model = *f->model;
  model.picture = (lam_picture){"plaza", "auto", 64, 36, "thumb"};
  static const struct {
    const char *script, *reason;
  } rows[] = {{"#!/bin/sh\necho half >.lamella-part.png; echo Hello\necho 'tent.pov line 3: Parse "
               "Error: no "
               "such'\necho '  word'\necho 'Fatal error in parser: x'\nexit 1\n",
               "tent.pov line 3: Parse Error: no such   word"},
              {"#!/bin/sh\nprintf 'Error: 1\\n2\\n3\\n4\\n'\nexit 1\n", "Error: 1 2 3"},
              {"#!/bin/sh\nexit 3\n", "it gave no reason"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    char expected[160];
    stand_in(f, "povray", rows[i].script);
    written_as(f, &model, (lam_write_options){.only = "pov"});
    put(path_in(f, f->out, "tent.png"), "old");
    lam_written w = written_as(f, &model, (lam_write_options){.only = "png"});
    assert_int_equal(w.left_out, 1);
    assert_string_not_equal(w.files[w.file_count - 1], path_in(f, f->out, "tent.png"));
    snprintf(expected, sizeof expected, "%s/tent.pov: povray failed: %s", f->out, rows[i].reason);
    assert_non_null(lam_session_notes(f->session));
    assert_string_equal(lam_session_notes(f->session)->text, expected);
    assert_string_equal(get(f, f->out, "tent.png"), "old");
    assert_null(get(f, f->out, ".lamella-part.png"));
  }
}

/* What was told of a picture: its quality, once for each fraction. */
typedef struct told {
  int count;
  double fractions[8];
} told;

static void hear_of_picture(void *context, const char *stage, double fraction,
                            const char *detail) {
  told *t = context;
  if (!stage || strcmp(stage, "render") != 0) return;
  assert_string_equal(detail, "thumb");
  if (t->count < 8) t->fractions[t->count++] = fraction;
}

/* Lines as POV-Ray writes them; 576 of 2304 pixels are a quarter. A line may come in pieces, and
 * what is no line about pixels is not told. */
static void progress_of_povray_is_told(void **state) {
  fixture *f = *state;
  lam_model model = *f->model;
  model.picture = (lam_picture){"plaza", "auto", 64, 36, "thumb"};
  stand_in(f, "povray",
           "#!/bin/sh\nprintf '==== [Rendering...] ====\\nRendered 576 of 2304 pixels (25%%)\\r'"
           ">&2\nprintf 'Rende'\nsleep .05\nprintf 'red 1152 of 2304 pixels (50%%)\\r'\n"
           "echo 'Rendered 5 of 0 pixels'\necho picture >.lamella-part.png\n");
  told t = {0};
  const lam_progress progress = {hear_of_picture, &t};
  lam_session_set_progress(f->session, &progress);
  written_as(f, &model, (lam_write_options){.only = "pov,png"});
  lam_session_set_progress(f->session, NULL);
  assert_int_equal(t.count, 3);
  assert_true(t.fractions[0] < 0);
  assert_true(t.fractions[1] == .25 && t.fractions[2] == .5);
}

/* The scene of another model in the folder is not what is rendered. */
static void a_picture_brings_its_scene(void **state) {
  fixture *f = *state;
  lam_model model = *f->model;
  model.picture = (lam_picture){"plaza", "auto", 64, 36, "thumb"};
  stand_in(f, "povray", "#!/bin/sh\ncp tent.pov .lamella-part.png\n");
  mkdir(f->out, 0777);
  put(path_in(f, f->out, "tent.pov"), "old");
  lam_written w = written_as(f, &model, (lam_write_options){.only = "png"});
  assert_int_equal(w.left_out, 0);
  assert_non_null(strstr(get(f, f->out, "tent.png"), "Model_Parts"));
  w = written_as(f, &model, (lam_write_options){.only = "png", .skip = "pov"});
  assert_string_equal(w.files[w.file_count - 1], path_in(f, f->out, "tent.png"));
}

/* ---- what is there already ---- */

static void refuse(fixture *f, lam_write_options options, const char *file, const char *text) {
  assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_BAD_INPUT);
  assert_string_equal(lam_session_messages(f->session)->location.file, file);
  assert_non_null(strstr(lam_session_messages(f->session)->text, text));
}

/* Directly, through a symbolic and through a hard link. */
static void inputs_are_never_overwritten(void **state) {
  fixture *f = *state;
  char input[64], output[96];
  snprintf(input, sizeof input, "%s/my start.obj", f->base);
  snprintf(output, sizeof output, "%s/net.obj", f->out);
  mkdir(f->out, 0777);
  for (int hard = 0; hard < 2; hard++) {
    assert_int_equal(hard ? link(input, output) : symlink(input, output), 0);
    refuse(f, (lam_write_options){.folder = f->out}, output, "the model is made from this file");
    assert_null(get(f, f->out, "report.json")); /* nothing was begun */
    assert_null(get(f, f->out, ".lamella-files"));
    written_as(f, f->model, (lam_write_options){.only = "report"});
    unlink(path_in(f, f->out, "report.json"));
    unlink(path_in(f, f->out, ".lamella-files"));
    unlink(output);
  }
  refuse(f, (lam_write_options){.folder = f->out, .deps = input}, input, "made from this file");
  lam_write_options nowhere = {.folder = ""};
  assert_int_equal(lam_model_write(f->session, f->model, &nowhere, NULL), LAM_BAD_INPUT);
  assert_first(f, "-o", "given an empty name; expected a folder");

  /* listed by an earlier build, and an input now: it stays */
  snprintf(output, sizeof output, "tent\nmy start.obj\nmy $tent #1.yaml\n");
  put(path_in(f, f->base, ".lamella-files"), output);
  lam_written w = written_as(f, f->model, (lam_write_options){.folder = f->base});
  assert_int_equal(w.removed, 0);
  assert_string_equal(get(f, f->base, "my start.obj"), start_text);
}

/* A folder that is a link is not written through, and a list does not reach through one. */
static void links_do_not_lead_out(void **state) {
  fixture *f = *state;
  char outside[64], path[96];
  snprintf(outside, sizeof outside, "%s/outside", f->base);
  mkdir(outside, 0777);
  mkdir(f->out, 0777);
  put(path_in(f, outside, "victim"), "x");
  assert_int_equal(symlink(outside, path_in(f, f->out, "parts")), 0);
  put(path_in(f, f->out, ".lamella-files"), "tent\nparts/victim\n");
  lam_written w = written_as(f, f->model, (lam_write_options){0});
  assert_int_equal(w.removed, 0);
  assert_non_null(get(f, outside, "victim"));

  lam_part part = {.name = "A01a", .kind = "plate"};
  static const lam_vec3 corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  static const int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  part.solid = (lam_trimesh){4, (lam_vec3 *)corners, 4, (int(*)[3])triangles};
  lam_model model = *f->model;
  model.part_count = 1;
  model.parts = &part;
  lam_write_options options = {.folder = f->out, .only = "stl"};
  assert_int_equal(lam_model_write(f->session, &model, &options, NULL), LAM_BAD_INPUT);
  snprintf(path, sizeof path, "%s/parts", f->out);
  assert_string_equal(lam_session_messages(f->session)->location.file, path);
  assert_null(get(f, outside, "A01a.stl"));
}

/* What a person has changed gets another name, and a note tells; what is the same, or gone, not. */
static void changes_by_hand_are_kept(void **state) {
  fixture *f = *state;
  stand_in(f, "povray", "#!/bin/sh\ncp tent.pov .lamella-part.png\n");
  written_as(f, f->model, (lam_write_options){0});
  written_as(f, f->model, (lam_write_options){0});
  assert_null(lam_session_notes(f->session));

  char expected[256];
  for (int i = 0; i < 2; i++) {
    put(path_in(f, f->out, i ? "report.json" : "net.obj"), "mine");
    written_as(f, f->model, (lam_write_options){0});
    snprintf(expected, sizeof expected,
             "%s was changed since the last build; the changed one is kept as %s", f->name,
             i ? "report.json~" : "net.obj~");
    assert_string_equal(lam_session_notes(f->session)->text, expected);
    assert_string_equal(get(f, f->out, i ? "report.json~" : "net.obj~"), "mine");
    assert_string_not_equal(get(f, f->out, i ? "report.json" : "net.obj"), "mine");
  }
  put(path_in(f, f->out, "net.obj"), "again");
  written_as(f, f->model, (lam_write_options){.only = "obj"});
  assert_string_equal(get(f, f->out, "net.obj~2"), "again");
  assert_string_equal(get(f, f->out, "net.obj~"), "mine");

  /* not made any more: it stays, too */
  put(path_in(f, f->out, "net.obj"), "mine");
  lam_model model = *f->model;
  model.net = NULL;
  written_as(f, &model, (lam_write_options){0});
  assert_non_null(strstr(lam_session_notes(f->session)->text, "is not made any more, and stays"));
  assert_string_equal(get(f, f->out, "net.obj"), "mine");
}

/* The list knows all files before the first is written; the report goes first and comes last. */
static void an_interrupted_build_is_no_finished_one(void **state) {
  fixture *f = *state;
  char folder[96];
  snprintf(folder, sizeof folder, "%s/net.obj", f->out);
  written_as(f, f->model, (lam_write_options){.only = "obj,report"});
  unlink(folder);
  mkdir(folder, 0777); /* what cannot be replaced: writing ends here */
  lam_write_options options = {.folder = f->out};
  assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_IO);
  assert_null(get(f, f->out, "report.json"));
  assert_non_null(strstr(get(f, f->out, ".lamella-files"), "tent.step\n"));
  rmdir(folder);

  /* what a build that was killed has left */
  put(path_in(f, f->out, ".lamella-part"), "half");
  put(path_in(f, f->out, ".lamella-part.png"), "half");
  put(path_in(f, f->out, ".lamella-part.pov-state"), "half");
  written_as(f, f->model, (lam_write_options){0});
  assert_null(get(f, f->out, ".lamella-part"));
  assert_null(get(f, f->out, ".lamella-part.png"));
  assert_null(get(f, f->out, ".lamella-part.pov-state"));
  assert_non_null(get(f, f->out, "report.json"));
}

/* GNU make reads every name that the rule has; a name that it cannot read is refused. */
static void rules_survive_awkward_names(void **state) {
  fixture *f = *state;
  char out[96], deps[64], command[512];
  snprintf(deps, sizeof deps, "%s/d", f->base);
  for (const char *c = ":#$ *?[]~\"'&()<>!,+@{}"; *c; c++) {
    snprintf(out, sizeof out, "%s/o%cx", f->base, *c);
    written_as(f, f->model, (lam_write_options){.folder = out, .only = "report", .deps = deps});
    /* 0: report.json is newer than all that it needs */
    snprintf(command, sizeof command,
             "cd %s && { cat d; printf '%%%%: ; @false\\n'; } >m && make -q -f m >log 2>&1",
             f->base);
    if (system(command) != 0) fail_msg("make does not read a path with %c", *c);
  }
  for (const char *c = ";=|%\\\t\n"; *c; c++) {
    snprintf(out, sizeof out, "%s/n%cx", f->base, *c);
    lam_write_options options = {.folder = out, .only = "report", .deps = deps};
    assert_int_equal(lam_model_write(f->session, f->model, &options, NULL), LAM_BAD_INPUT);
    assert_string_equal(lam_session_messages(f->session)->key, "--deps");
    assert_int_equal(access(out, F_OK), -1);
  }
}

/* ---- color maps ---- */

static lam_status mapped(fixture *f, const char *ending, const char *measure) {
  char path[64];
  snprintf(path, sizeof path, "%s/map%s", f->base, ending);
  lam_measure_task task = {
      .mesh = f->model->net, .name = "some/where/roof.v2.obj", .map = measure, .map_path = path};
  lam_measured measured;
  return lam_measure_net(f->session, &task, &measured);
}

static void maps_are_named_after_their_ending(void **state) {
  fixture *f = *state;
  stand_in(f, "rsvg-convert",
           "#!/bin/sh\necho \"$1 $2\" >\"${3%.part.png}.said\"; cp \"$4\" \"$3\"\n");
  assert_int_equal(mapped(f, ".svg", "edge_ratio"), LAM_OK);
  assert_non_null(strstr(get(f, f->base, "map.svg"), "<svg"));
  assert_non_null(strstr(f->text, "roof.v2"));
  assert_null(strstr(f->text, "roof.v2.obj"));
  char svg[sizeof f->text];
  strcpy(svg, f->text);
  assert_int_equal(mapped(f, ".PNG", "edge_ratio"), LAM_OK); /* the converter copies */
  assert_string_equal(get(f, f->base, "map.PNG"), svg);
  assert_string_equal(get(f, f->base, "map.PNG.said"), "--zoom=2.0833333 --output\n");
  assert_null(get(f, f->base, "map.PNG.part.svg"));
  assert_null(get(f, f->base, "map.PNG.part.png"));
  assert_int_equal(mapped(f, ".glb", "edge_ratio"), LAM_OK);
  assert_memory_equal(get(f, f->base, "map.glb"), "glTF", 4);

  assert_int_equal(mapped(f, ".pdf", "edge_ratio"), LAM_BAD_INPUT);
  char expected[128];
  snprintf(expected, sizeof expected,
           "given %s/map.pdf; expected a name that ends with .svg, .png or .glb", f->base);
  assert_first(f, "-o", expected);
  assert_int_equal(mapped(f, ".svg", "flatness"), LAM_BAD_INPUT);
  assert_string_equal(lam_session_messages(f->session)->key, "--map");

  stand_in(f, "rsvg-convert", "#!/bin/sh\necho half >\"$3\"; echo broken\nexit 1\n");
  assert_int_equal(mapped(f, ".png", "edge_ratio"), LAM_FAILED);
  assert_first(f, NULL, "rsvg-convert failed: broken ");
  assert_null(get(f, f->base, "map.png"));
  assert_null(get(f, f->base, "map.png.part.png"));
}

int main(void) {
#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)
  const struct CMUnitTest tests[] = {
      TEST(files_are_listed_in_their_folder),
      TEST(what_files_need_stands_beside_them),
      TEST(a_whole_build_takes_away_what_is_gone),
      TEST(rules_name_what_a_build_was_made_from),
      TEST(options_name_formats),
      TEST(reports_have_no_times_unless_asked),
      TEST(what_cannot_be_written_is_io),
      TEST(progress_is_told_by_format),
      TEST(files_are_given_as_bytes),
      TEST(povray_gets_the_scene_and_the_size),
      TEST(povray_may_fail),
      TEST(progress_of_povray_is_told),
      TEST(a_picture_brings_its_scene),
      TEST(inputs_are_never_overwritten),
      TEST(links_do_not_lead_out),
      TEST(changes_by_hand_are_kept),
      TEST(an_interrupted_build_is_no_finished_one),
      TEST(rules_survive_awkward_names),
      TEST(maps_are_named_after_their_ending),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
