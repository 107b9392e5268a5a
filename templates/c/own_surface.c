/* Adds a surface of one's own, a wave, and builds a net of planar quads and panels on it.
 *
 *   cc own_surface.c $(pkg-config --cflags --libs lamella) -lm -o own_surface
 *   ./own_surface out */
#include <lamella/lamella.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* x(u,v) = (u, v, h (cos(k u) - cos(k v))), with its derivatives. numbers: amplitude h (meters),
 * frequency k (per meter). The net below follows lines of curvature, which have no direction where
 * the surface is flat: this one is flat only where k u and k v are both a quarter turn. */
static void wave(const void *context, const double *numbers, double u, double v, lam_jet *jet) {
  (void)context;
  double h = numbers[0], k = numbers[1];
  double c = cos(k * u), s = sin(k * u), C = cos(k * v), S = sin(k * v);
  jet->x = (lam_vec3){u, v, h * (c - C)};
  jet->u = (lam_vec3){1, 0, -h * k * s};
  jet->v = (lam_vec3){0, 1, h * k * S};
  jet->uu = (lam_vec3){0, 0, -h * k * k * c};
  jet->uv = (lam_vec3){0, 0, 0};
  jet->vv = (lam_vec3){0, 0, h * k * k * C};
}

static const lam_surface_number numbers[] = {
    {"amplitude", LAM_LENGTH, "1 m", 0, 10, "Of both waves."},
    {"frequency", LAM_PLAIN_NUMBER, "0.5", 0, 10, "Radians per meter."},
};

static const lam_surface_definition definition = {
    .name = "wave",
    .title = "Wave in two directions",
    .doc = "A surface of translation that this program adds.",
    .number_count = 2,
    .numbers = numbers,
    .u = {-2, 2},
    .v = {-3, 3},
    .eval = wave,
};

/* A design like one from a file: the new kind has a name and keys like all others. */
static const char text[] = "lamella: 1\n"
                           "name: wave-roof\n"
                           "surface: {kind: wave, amplitude: 0.8 m}\n"
                           "net: {kind: planar-quads, grid: [12, 16]}\n"
                           "parts: [{kind: panels, thickness: 10 mm, gap: 8 mm}]\n";

/* What the report says about the faces of the net. */
static void print_planarity(const lam_report *report) {
  for (int i = 0; i < report->stage_count; i++) {
    const lam_stage *stage = &report->stages[i];
    for (int k = 0; k < stage->measure_count; k++)
      if (strcmp(stage->measures[k].name, "face_planarity") == 0)
        printf("%s: planarity at most %.1e, %s\n", stage->name, stage->measures[k].max,
               stage->reason);
  }
}

int main(int argc, char **argv) {
  if (argc != 2) return fprintf(stderr, "usage: %s FOLDER\n", argv[0]), LAM_BAD_INPUT;

  lam_session *session;
  lam_status status = lam_session_new(&session);
  if (status != LAM_OK) return fprintf(stderr, "%s\n", lam_status_text(status)), status;

  /* The surface first: designs of this session know it then. */
  lam_design_source source = {.path = "wave-roof.yaml", .text = text, .length = strlen(text)};
  lam_write_options options = {.folder = argv[1], .skip = "png"};
  const lam_design *design;
  const lam_model *model;
  status = lam_surface_add(session, &definition);
  if (status == LAM_OK) status = lam_design_read(session, &source, &design);
  if (status == LAM_OK) status = lam_design_build(session, design, &model);
  if (status == LAM_OK) status = lam_model_write(session, model, &options, NULL);

  for (const lam_error *e = lam_session_messages(session); e; e = e->next)
    fprintf(stderr, "%s%s%s\n", e->key ? e->key : "", e->key ? ": " : "", e->text);
  if (status == LAM_OK) print_planarity(model->report);

  lam_session_free(session);
  return status;
}
