/* STEP, IGES, surface.json and free-form OBJ files of any bytes: the readers of surfaces and curves
 * must not crash, must say what is wrong in one line, and what they do read must be evaluated and
 * written again without harm.
 *
 * As a fuzzer:
 *   clang -g -O1 -std=c11 -D_GNU_SOURCE -fsanitize=fuzzer,address,undefined -Igen -I.
 * tests/torture/fuzz_surface.c \
 *     formats/step*.c formats/iges*.c formats/mesh/obj.c formats/surface_*.c formats/spline/shell.c
 * formats/spline/spline.c \ formats/spline/curves.c formats/scan.c \
 * build/liblamella.a -ljansson -lstdc++ -lm -o
 * fuzz_surface
 *   ./fuzz_surface -max_len=8192 corpus
 * As a test, with -DLAM_FUZZ_DRIVER: mutates small files in a fixed sequence.
 *   fuzz_surface [ROUNDS [SEED]] */
#include "curve/bspline/basis.h"
#include "formats/format.h"
#include "formats/spline/curves.h"
#include "surf/spline/spline_surface.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const lam_format lam_format_step, lam_format_iges, lam_format_surface,
    lam_format_surface_obj, lam_format_obj;
static const lam_format *const formats[] = {&lam_format_step, &lam_format_iges, &lam_format_surface,
                                            &lam_format_obj};
static const lam_format *const writers[] = {&lam_format_step, &lam_format_iges, &lam_format_surface,
                                            &lam_format_surface_obj};
enum { format_count = 4 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void fail(const char *what) {
  fprintf(stderr, "fuzz_surface: %s\n", what);
  abort();
}

/* Evaluates a surface at its corners and in the middle. */
static void evaluate(lam_arena *arena, const lam_spline_surface *s) {
  for (int d = 0; d < 2; d++)
    if (s->degree[d] > LAM_BASIS_MAX_DEGREE ||
        lam_knots_problem(s->degree[d], s->count[d], s->count[d] + s->degree[d] + 1, s->knots[d]))
      return; /* refused when the surface is made */
  const lam_nurbs *nurbs = lam_nurbs_make(arena, s);
  double p[2], q[2];
  bool closed[2];
  lam_jet jet;
  lam_nurbs_domain(nurbs, LAM_CHART_NATURAL, p, q, closed);
  for (int k = 0; k < 3; k++)
    lam_nurbs_eval(nurbs, p[0] + k * (p[1] - p[0]) / 2, q[0] + k * (q[1] - q[0]) / 2, &jet);
}

/* What was written of the model must be read: a surface, or a curve. */
static void write_again(lam_arena *arena, const lam_model *model) {
  for (int i = 0; i < format_count; i++) {
    lam_text text = {.arena = arena};
    lam_errors errors = {.arena = arena};
    lam_spline_list list;
    lam_curve_list curves;
    lam_location location = {.file = "again"};
    if (writers[i]->write(model, 0, &text) != LAM_OK) fail("not written");
    if (model->surface_count
            ? formats[i]->read_surfaces(arena, text.data, text.length, location, &errors, &list)
            : formats[i]->read_curves(arena, text.data, text.length, location, &errors, &curves))
      continue;
    fprintf(stderr, "%s: %s\n", formats[i]->name, errors.first->text);
    fail("what was written is not read");
  }
}

/* Where numbers overflow on the way to millimeters nothing is promised. */
static void write_surface(lam_arena *arena, const lam_spline_surface *s) {
  lam_spline_surface named = *s;
  named.name = "surface";
  for (int i = 0; i < s->count[0] * s->count[1]; i++)
    if (!(lam_length(s->points[i]) < 1e100) ||
        (s->weights && !(s->weights[i] < 1e100 && s->weights[i] > 1e-100)))
      return;
  for (int d = 0; d < 2; d++) {
    double size = s->knots[d][s->count[d]] - s->knots[d][s->degree[d]];
    for (int i = 0; i < s->count[d] + s->degree[d] + 1; i++)
      if (!(fabs(s->knots[d][i]) < 1e6 * size)) return;
    if (lam_knots_problem(s->degree[d], s->count[d], s->count[d] + s->degree[d] + 1, s->knots[d]))
      return;
  }
  lam_model model = {.name = "fuzz", .version = "0", .surface_count = 1, .surfaces = &named};
  write_again(arena, &model);
}

static void write_curve(lam_arena *arena, const lam_named_curve *named) {
  const lam_spline_curve *c = &named->spline;
  double size = c->knots[c->count] - c->knots[c->degree];
  if (c->degree > LAM_BASIS_MAX_DEGREE ||
      lam_knots_problem(c->degree, c->count, c->count + c->degree + 1, c->knots))
    return;
  for (int i = 0; i < c->count; i++)
    if (!(lam_length(c->points[i]) < 1e100) ||
        (c->weights && !(c->weights[i] < 1e100 && c->weights[i] > 1e-100)))
      return;
  for (int i = 0; i < c->count + c->degree + 1; i++)
    if (!(fabs(c->knots[i]) < 1e6 * size)) return;
  lam_named_curve copy = {"curve", 0, *c};
  lam_model model = {.name = "fuzz", .version = "0", .curve_count = 1, .curves = &copy};
  write_again(arena, &model);
}

static void check_messages(const lam_errors *errors, bool good) {
  if (errors->count != !good) fail("messages and result disagree");
  for (const lam_error *e = errors->first; e; e = e->next)
    if (!e->text[0] || strchr(e->text, '\n') || e->location.line < 0)
      fail("a message is not one line");
}

static bool try_surfaces(lam_arena *arena, const lam_format *format, const char *bytes,
                         size_t size) {
  lam_errors errors = {.arena = arena};
  lam_spline_list list;
  bool good =
      format->read_surfaces(arena, bytes, size, (lam_location){.file = "fuzz"}, &errors, &list);
  check_messages(&errors, good);
  for (int k = 0; good && k < list.count; k++) {
    if (lam_spline_problem(&list.items[k])) fail("an unfit surface was read");
    evaluate(arena, &list.items[k]);
    write_surface(arena, &list.items[k]);
  }
  return good;
}

static bool try_curves(lam_arena *arena, const lam_format *format, const char *bytes, size_t size) {
  lam_errors errors = {.arena = arena};
  lam_curve_list list;
  bool good =
      format->read_curves(arena, bytes, size, (lam_location){.file = "fuzz"}, &errors, &list);
  check_messages(&errors, good);
  for (int k = 0; good && k < list.count; k++) {
    const char *name = list.items[k].name;
    if (lam_curve_problem(&list.items[k].spline)) fail("an unfit curve was read");
    if (!name || !*name || strchr(name, '\n')) fail("a curve without a name in one line");
    write_curve(arena, &list.items[k]);
  }
  return good;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  for (int i = 0; i < format_count; i++) {
    lam_arena *arena = lam_arena_new();
    if (!arena) return 0;
    char *bytes = lam_arena_alloc(arena, size, 1);
    if (size) memcpy(bytes, data, size);
    try_surfaces(arena, formats[i], bytes, size);
    try_curves(arena, formats[i], bytes, size);
    lam_arena_free(arena);
  }
  return 0;
}

#ifdef LAM_FUZZ_DRIVER
#include "tests/torture/fuzz.h"

enum { largest = 8192, seeds = 8 };

/* What other programs write of edges: a line, a circle, a trimmed curve, a polyline; a face. */
static const char edges[] =
    "ISO-10303-21;\nDATA;\n#1=CARTESIAN_POINT('',(0.,2.,1.));\n#2=CARTESIAN_POINT('',(2.,0.,1.));"
    "\n#3=VERTEX_POINT('',#"
    "1);\n"
    "#4=VERTEX_POINT('',#2);\n#5=DIRECTION('',(1.,-1.,0.));\n#6=VECTOR('',#5,1.);\n#7=LINE('',#1,#"
    "6);\n"
    "#8=EDGE_CURVE('a',#3,#4,#7,.T.);\n#11=DIRECTION('',(0.,0.,1.));\n#13=AXIS2_PLACEMENT_3D('',#1,"
    "#11,$);\n"
    "#14=CIRCLE('',#13,2.);\n#15=SURFACE_CURVE('',#14,(#1),.C.);\n#16=EDGE_CURVE('b',#3,#4,#15,.F.)"
    ";\n"
    "#17=CARTESIAN_POINT('',(1.,2.,3.));\n#24=B_SPLINE_CURVE_WITH_KNOTS('',2,(#1,#17,#2),.U.,.F.,."
    "F.,(3,3),(0.,3.),.U.)"
    ";\n#27=EDGE_CURVE('',#4,#3,#24,.F.);\n"
    "#30=TRIMMED_CURVE('c',#14,(PARAMETER_VALUE(90.)),(PARAMETER_VALUE(270.)),.T.,.P.);\n#40="
    "POLYLINE('',(#1,#2));\n"
    "#41=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#2),(#1,#2)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),("
    "0.,1.),.U.);\n"
    "#42=ORIENTED_EDGE('',*,*,#8,.T.);\n#43=EDGE_LOOP('',(#42));\n#44=FACE_OUTER_BOUND('',#43,.T.);"
    "\n"
    "#45=ADVANCED_FACE('',(#44),#41,.T.);\n#90=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#91)));\n"
    "#91=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\nENDSEC;\nEND-ISO-10303-21;\n";

/* The same in IGES: a surface trimmed by a composite curve of a line, an arc and a polyline, and by
 * a boundary. */
static void add_iges_edges(lam_text *text) {
  static const int types[] = {128, 110, 100, 106, 102, 142, 144, 141, 143};
  static const char *const parameters[] = {
      "128,1,1,1,1,,,1,,,0,0,1,1,0,0,1,1,1,1,1,1,,,,2,,,,2,,2,2,,0,1,0,1;",
      "110,0,0,0,2,2,0;",
      "100,0,0,0,1,0,0,1;",
      "106,2,2,0,0,0,1,1,1;",
      "102,3,3,5,7;",
      "142,1,1,3,9,2;",
      "144,1,1,0,11;",
      "141,1,1,1,1,3,1,1,5;",
      "143,1,1,1,15;"};
  enum { entities = 9 };
  lam_text_printf(text, "%-72sS%7d\n%-72sG%7d\n", "", 1, "1H,,1H;,,,,,32,38,6,308,15,,1.0,6,1HM;",
                  1);
  for (int i = 0; i < entities; i++)
    lam_text_printf(text, "%8d%8d%40s%16sD%7d\n%8d%24d%8d%32sD%7d\n", types[i], i + 1, "",
                    "00000000", 2 * i + 1, types[i], 1, types[i] == 106 ? 12 : 0, "", 2 * i + 2);
  for (int i = 0; i < entities; i++) lam_text_printf(text, "%-72sP%7d\n", parameters[i], i + 1);
  lam_text_printf(text, "%-72sT%7d\n", "", 1);
}

/* A biquadratic by linear rational patch and a cubic in each format, then as STEP and IGES without
 * weights and with open knots, then edges. */
static size_t seed(lam_arena *arena, int i, uint8_t *bytes) {
  static const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 2, 2}, open_u[] = {0, 1, 2, 3, 4, 5},
                      weights[] = {1, 2, 3, 4, 5, 6}, cubic[] = {0, 0, 0, 0, .5, 1, 1, 1, 1};
  static const lam_vec3 points[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                    {1, 1, 0}, {2, 0, 0}, {2, 1, .25}};
  lam_spline_surface s = {"roof", {2, 1}, {3, 2}, {i < format_count ? u : open_u, v}, points, NULL};
  if (i < format_count) s.weights = weights;
  lam_named_curve curve = {"A01", 0, {3, 5, cubic, points, NULL}};
  lam_model model = {.name = "fuzz",
                     .version = "0",
                     .surface_count = 1,
                     .surfaces = &s,
                     .curve_count = 1,
                     .curves = &curve};
  lam_text text = {.arena = arena};
  if (i == seeds - 1)
    add_iges_edges(&text);
  else if (i == seeds - 2)
    lam_text_add(&text, edges);
  else
    writers[i % format_count]->write(&model, 0, &text);
  if (text.length > largest) fail("the seed is too large");
  memcpy(bytes, text.data, text.length);
  return text.length;
}

static const char likely[] = "00112345679.,-/E#()';$ \nHDPT";

int main(int argc, char **argv) {
  long rounds = argc > 1 ? atol(argv[1]) : 10000;
  uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
  if (!state) state = 1;
  static uint8_t files[seeds][largest], bytes[largest];
  size_t sizes[seeds];
  lam_arena *arena = lam_arena_new();
  if (!arena) return 1;
  for (int i = 0; i < seeds; i++) {
    int read = 0;
    sizes[i] = seed(arena, i, files[i]);
    for (int f = 0; f < format_count; f++)
      read += try_surfaces(arena, formats[f], (const char *)files[i], sizes[i]) +
              try_curves(arena, formats[f], (const char *)files[i], sizes[i]);
    if (read != 2) fail("a seed is not read");
  }
  for (long i = 0; i < rounds; i++) {
    size_t size = sizes[i % seeds];
    memcpy(bytes, files[i % seeds], size);
    if (i >= seeds)
      size = fuzz_mutate(&state, likely, bytes, size, largest); /* the seeds themselves first */
    LLVMFuzzerTestOneInput(bytes, size);
  }
  lam_arena_free(arena);
  printf("%ld files\n", rounds);
  return 0;
}
#endif
