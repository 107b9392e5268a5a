/* The row `frames`: the moving frame along the boundary of spline surfaces, as small plates with
 * a pin. Called through the registry (part_kinds.c) by design/parts_stage.c. */
#include "fab/mesh_fill.h"
#include "fab/part_names.h"
#include "fab/workshop.h"
#include "surf/spline/spline_surface.h"

/* The keys of a row, in meters; count: frames per side of a surface. */
typedef struct frames_keys {
  int count, material;
  double size, gap, thickness;
} frames_keys;

/* A plate from y = gap outward, x across, with a pin along z on its middle: closed, in one piece.
 * The plate's faces are a grid of 3 x 3 fields, of which the middle one is lifted on top. */
static lam_trimesh plate_with_pin(lam_arena *arena, const frames_keys *k) {
  double s = k->size, t = k->thickness, pin = fmin(s / 4, 2 * t);
  const double x[4] = {-s / 2, -pin / 2, pin / 2, s / 2};
  const double y[4] = {k->gap, k->gap + (s - pin) / 2, k->gap + (s + pin) / 2, k->gap + s};

  /* Corners of the grid: 0 to 15 above, 16 to 31 below, 32 to 35 on top of the pin. */
  lam_trimesh mesh = lam_trimesh_empty(arena, 36, 2 * (9 + 9 + 12 + 4));
  for (int i = 0; i < 16; i++) {
    mesh.vertices[i] = lam_v3(x[i % 4], y[i / 4], t / 2);
    mesh.vertices[16 + i] = lam_v3(x[i % 4], y[i / 4], -t / 2);
  }

  static const int middle[4] = {5, 6, 10, 9}, rim[12] = {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4};
  for (int i = 0; i < 4; i++)
    mesh.vertices[32 + i] = lam_along(mesh.vertices[middle[i]], s, lam_v3(0, 0, 1));

  /* Below all nine fields, above all but the middle one; then the rim, and the pin. */
  for (int f = 0; f < 9; f++) {
    int a = f / 3 * 4 + f % 3;
    lam_trimesh_quad(&mesh, 16 + a, 16 + a + 4, 16 + a + 5, 16 + a + 1);
    if (f == 4) continue;
    lam_trimesh_quad(&mesh, a, a + 1, a + 5, a + 4);
  }

  for (int i = 0; i < 12; i++) {
    int a = rim[i], b = rim[(i + 1) % 12];
    lam_trimesh_quad(&mesh, a, 16 + a, 16 + b, b);
  }
  for (int i = 0; i < 4; i++) {
    int next = (i + 1) % 4;
    lam_trimesh_quad(&mesh, middle[i], middle[next], 32 + next, 32 + i);
  }
  lam_trimesh_quad(&mesh, 32, 33, 34, 35);
  return mesh;
}

/* The frame on side r1, r2, r3 or r4 (0 to 3) of a surface at t in [0, 1]: x along the curve, y
 * outward in the tangent plane, z along the normal. Returns the sine of the angle between the
 * normal and that of the osculating plane: 0 for asymptotic curves; NaN where the curve is
 * straight. */
static double frame_at(const lam_spline_surface *s, const lam_nurbs *nurbs, int side, double t,
                       lam_pose *frame) {
  lam_jet jet;
  double at[2] = {side == 3, side == 2}, parameter[2];
  at[side % 2] = t;
  for (int d = 0; d < 2; d++) {
    double low = s->knots[d][s->degree[d]], high = s->knots[d][s->count[d]];
    parameter[d] = low + at[d] * (high - low);
  }

  lam_nurbs_eval(nurbs, parameter[0], parameter[1], &jet);
  lam_vec3 along = side % 2 ? jet.v : jet.u, second = side % 2 ? jet.vv : jet.uu;
  lam_vec3 normal = lam_unit(lam_cross(jet.u, jet.v)), bend = lam_cross(along, second);

  bool clockwise = side == 1 || side == 2; /* the patch lies on the right */
  frame->origin = jet.x;
  frame->axis[0] = lam_scale(lam_unit(along), clockwise ? -1 : 1);
  frame->axis[2] = normal;
  frame->axis[1] = lam_cross(normal, frame->axis[0]);
  for (int i = 0; i < 2; i++)
    frame->axis[i] = lam_scale(frame->axis[i], -1); /* outward, still right-handed */

  double size = lam_length(bend);
  return size > 1e-9 * pow(lam_length(along), 2)
             ? lam_length(lam_cross(normal, lam_scale(bend, 1 / size)))
             : NAN;
}

/* How far normals are from the osculating planes of the boundary: sines, where it is curved. */
typedef struct tilt_range {
  double max, sum;
  long count;
} tilt_range;

/* Places frames along the four sides of one surface, evenly in the parameter and half a step from
 * the corners: adds instances to the part and takes down their tilt. */
static void add_frames(lam_workshop *shop, const frames_keys *k, const lam_spline_surface *surface,
                       lam_part *part, tilt_range *tilt) {
  const lam_nurbs *nurbs = lam_nurbs_make(shop->arena, surface);
  for (int g = 0; g < 4 * k->count; g++) {
    double t = (g % k->count + 0.5) / k->count;
    double sine =
        frame_at(surface, nurbs, g / k->count, t, &part->instances[part->instance_count++]);
    if (isnan(sine)) continue;
    tilt->max = fmax(tilt->max, sine);
    tilt->sum += sine;
    tilt->count++;
  }
}

/* One part with count instances on each of the four sides of every surface. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const frames_keys *k = params;
  if (shop->surface_count == 0) {
    lam_error_add(shop->errors, location, "kind",
                  "frames stand along the boundary of a spline surface; expected one, such as "
                  "asymptotic-quad");
    return;
  }

  lam_part part = {.name = lam_part_name(shop, "T1"),
                   .kind = "frames",
                   .family = -1,
                   .group = -1,
                   .congruence = lam_workshop_next_class(shop)};
  part.material = &lam_materials[k->material];
  part.solid = plate_with_pin(shop->arena, k);
  part.instances = LAM_NEW(shop->arena, lam_pose, 4 * k->count * shop->surface_count);

  tilt_range tilt = {0};
  for (int i = 0; i < shop->surface_count; i++)
    add_frames(shop, k, &shop->surfaces[i], &part, &tilt);
  lam_workshop_part(shop, part);

  lam_stage *stage = lam_workshop_stage(shop, "frames");
  lam_stage_count(shop->arena, stage, "frame_count", part.instance_count);
  if (tilt.count)
    lam_stage_measure(shop->arena, stage, "normal_binormal_sine", "", tilt.max,
                      tilt.sum / (double)tilt.count, tilt.count);
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(frames_keys, "count", count, "7", 1, 1000,
                    "Frames along each of the four boundary curves."),
    LAM_LENGTH_KEY(frames_keys, "size", size, "200 mm", 1e-4, 10,
                   "Side of the plate and length of the pin above it."),
    LAM_LENGTH_KEY(frames_keys, "gap", gap, "10 mm", 0, 10,
                   "Between the boundary curve and the plate."),
    LAM_LENGTH_KEY(frames_keys, "thickness", thickness, "5 mm", 1e-5, 1, "Thickness of the plate."),
    LAM_CHOICE_KEY(frames_keys, "material", material, "brass", lam_material_names,
                   "What the plates are made of."),
    {0}};

const lam_part_kind lam_part_frames = {
    .head = {.name = "frames",
             .title = "Frames along the boundary",
             .doc = "Small plates along the boundary of a spline surface, each in the tangent "
                    "plane of the surface with a pin along its normal. Along asymptotic curves "
                    "the plates also lie in the osculating planes of the boundary: they go on "
                    "where the surface ends, and the curve bends within them. Keep them apart "
                    "from each other and from a curve that bulges outward by `size` and `gap`.",
             .source = "thesis 2.1",
             .keys = keys,
             .params_size = sizeof(frames_keys)},
    .make = make};
