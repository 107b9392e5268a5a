/* Kinds of surfaces out of definitions: the keys become a key table of numbers, the callback is
 * wrapped, and its derivatives are compared with difference quotients. Called by
 * library/own_surfaces.c when a program adds a surface, and by lam_surface_make. */
#include "surf/defined.h"
#include "surf/surface_kind.h"

#include <string.h>

static const lam_location nowhere;

/* A definition with the values of its keys. */
typedef struct instance {
  const lam_surface_definition *definition;
  const double *numbers;
} instance;

/* The callback, with the values of the keys. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const instance *surface = data;
  surface->definition->eval(surface->definition->context, surface->numbers, u, v, jet);
}

/* A surface of one's own has no chart but its natural one: other lines are traced on it. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  const lam_surface_definition *d = ((const instance *)data)->definition;
  if (chart != LAM_CHART_NATURAL) return false;
  return lam_domain_give(
      (lam_domain){{d->u[0], d->u[1]}, {d->v[0], d->v[1]}, {d->closed_u, d->closed_v}}, p, q,
      closed);
}

/* Both are kept by pointer. */
const void *lam_surface_defined_data(lam_arena *arena, const lam_surface_definition *definition,
                                     const double *numbers) {
  instance *surface = LAM_NEW(arena, instance, 1);
  *surface = (instance){definition, numbers};
  return surface;
}

/* ---- what can be wrong ---- */

/* The largest difference between a derivative and its difference quotient, relative to the size
 * of both. Step h: quotients of second order are wrong by about h^2. */
static double derivative_error(const lam_surface_definition *d, const double *numbers) {
  static const double h = 1e-5;
  double u = (d->u[0] + d->u[1]) / 2, v = (d->v[0] + d->v[1]) / 2;
  double hu = h * (d->u[1] - d->u[0]), hv = h * (d->v[1] - d->v[0]);
  lam_jet here, east, west, north, south;
  d->eval(d->context, numbers, u, v, &here);
  d->eval(d->context, numbers, u + hu, v, &east);
  d->eval(d->context, numbers, u - hu, v, &west);
  d->eval(d->context, numbers, u, v + hv, &north);
  d->eval(d->context, numbers, u, v - hv, &south);

  const lam_vec3 given[] = {here.u, here.v, here.uu, here.uv, here.vv};
  const lam_vec3 quotient[] = {
      lam_scale(lam_sub(east.x, west.x), .5 / hu), lam_scale(lam_sub(north.x, south.x), .5 / hv),
      lam_scale(lam_sub(east.u, west.u), .5 / hu), lam_scale(lam_sub(north.u, south.u), .5 / hv),
      lam_scale(lam_sub(north.v, south.v), .5 / hv)};

  /* Second derivatives may vanish: they are compared in units of the first ones. */
  double width[] = {1, 1, d->u[1] - d->u[0], d->u[1] - d->u[0], d->v[1] - d->v[0]};
  double size = lam_length(here.u) + lam_length(here.v), worst = 0;
  for (int i = 0; i < 5; i++)
    worst = fmax(worst, width[i] * lam_distance(given[i], quotient[i]) / size);
  return isfinite(worst) ? worst : INFINITY;
}

/* Names become parts of designs and of file names. */
static bool is_word(const char *name) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  return name && *name && strspn(name, letters) == strlen(name);
}

/* Whether name, eval, ranges and keys are there; all of what is wrong is told at once. */
static bool is_complete(const lam_surface_definition *d, lam_errors *errors) {
  int before = errors->count;
  if (!is_word(d->name))
    lam_error_add(errors, nowhere, "name", "given %s; expected letters, digits, - and _",
                  d->name ? d->name : "nothing");

  if (!d->eval) lam_error_add(errors, nowhere, "eval", "missing");
  if (!(d->u[0] < d->u[1]) || !(d->v[0] < d->v[1]))
    lam_error_add(errors, nowhere, "u, v", "expected ranges from a smaller to a larger number");

  for (int i = 0; i < d->number_count; i++)
    if (!is_word(d->numbers[i].name) || !d->numbers[i].doc)
      lam_error_add(errors, nowhere, "numbers", "number %d has no name or no doc", i + 1);
  return errors->count == before;
}

/* ---- the kind ---- */

/* The key of number i, whose value is the i-th of the parameters. */
static lam_key key_of(lam_arena *arena, const lam_surface_number *number, int i) {
  static const lam_key_unit units[] = {[LAM_PLAIN_NUMBER] = LAM_UNIT_NONE,
                                       [LAM_LENGTH] = LAM_UNIT_LENGTH,
                                       [LAM_ANGLE] = LAM_UNIT_ANGLE};
  return (lam_key){.name = lam_arena_copy(arena, number->name),
                   .type = LAM_KEY_NUMBER,
                   .unit = units[number->quantity],
                   .offset = (size_t)i * sizeof(double),
                   .count = 1,
                   .initial = lam_arena_copy(arena, number->initial),
                   .min = number->min,
                   .max = number->max,
                   .doc = lam_arena_copy(arena, number->doc)};
}

/* Texts are copied: the program need not keep them. */
const lam_surface_kind *lam_surface_kind_defined(lam_arena *arena,
                                                 const lam_surface_definition *definition,
                                                 lam_errors *errors) {
  if (!is_complete(definition, errors)) return NULL;

  lam_surface_definition *copy = LAM_NEW(arena, lam_surface_definition, 1);
  *copy = *definition;
  copy->name = lam_arena_copy(arena, definition->name);
  copy->title = lam_arena_copy(arena, definition->title ? definition->title : definition->name);
  copy->doc = lam_arena_copy(arena, definition->doc ? definition->doc : "");

  /* One key per number, and the empty row that ends a table. */
  lam_key *keys = LAM_NEW(arena, lam_key, definition->number_count + 1);
  for (int i = 0; i < definition->number_count; i++)
    keys[i] = key_of(arena, &definition->numbers[i], i);

  lam_surface_kind *kind = LAM_NEW(arena, lam_surface_kind, 1);
  *kind =
      (lam_surface_kind){.head = {.name = copy->name,
                                  .title = copy->title,
                                  .doc = copy->doc,
                                  .source = "added by a program",
                                  .keys = keys,
                                  .params_size = sizeof(double) * (size_t)definition->number_count},
                         .eval = eval,
                         .domain = domain,
                         .definition = copy};
  return kind;
}

/* The middle of the rectangle stands for all of it. */
bool lam_surface_defined_check(const lam_surface_kind *kind, const double *numbers,
                               lam_location location, lam_errors *errors) {
  static const double limit = 1e-4; /* a wrong derivative is off by its own size */
  double worst = derivative_error(kind->definition, numbers);
  if (worst <= limit) return true;
  lam_error_add(errors, location, kind->head.name,
                "a derivative differs from its difference quotient by %.2g of the first "
                "derivatives; expected at most %g",
                worst, limit);
  return false;
}
