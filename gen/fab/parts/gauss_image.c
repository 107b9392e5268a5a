/* The row `gauss-image`: the net's Gauss image on a sphere beside it, for the parts of the rows
 * that follow. Called through the registry (part_kinds.c) by design/parts_stage.c.
 *
 * The unit normals of the faces are the image's vertices, and every inner vertex with four faces
 * becomes a face of it. At a conical vertex the four normals make one angle with the axis of its
 * cone, so that they lie on a circle: the image of a conical net is a circular net (thesis
 * 3.5.2). */
#include "core/solid/triangles.h"
#include "fab/part_names.h"
#include "fab/turned.h"
#include "fab/workshop.h"
#include "mesh/offset.h"
#include "net/measures/measure.h"

/* The keys of a row, in meters. */
typedef struct image_keys {
  double radius, at[3];
  int material;
  bool ball;
} image_keys;

/* Turns the image over when most of it faces inward: normals run around against the faces where
 * the net is a saddle. The sum is six times the volume between the image and the center. */
static void turn_outward(lam_mesh *image) {
  double inside = 0;
  for (int f = 0; f < image->face_count; f++) {
    const int *c = image->faces[f];
    const lam_vec3 *n = image->vertices;
    inside += lam_dot(n[c[0]], lam_cross(lam_sub(n[c[2]], n[c[0]]), lam_sub(n[c[3]], n[c[1]])));
  }

  if (inside >= 0) return;
  for (int f = 0; f < image->face_count; f++) {
    int keep = image->faces[f][1];
    image->faces[f][1] = image->faces[f][3];
    image->faces[f][3] = keep;
  }
}

/* The sphere itself, to be looked at: a ball around the center. */
static void add_ball(lam_workshop *shop, const image_keys *k, lam_vec3 center) {
  lam_part part = {.name = lam_part_name(shop, "gauss-sphere"),
                   .kind = "gauss-image",
                   .family = -1,
                   .group = -1,
                   .drawn = true};
  part.material = &lam_materials[k->material];
  part.solid = lam_ball(shop->arena, k->radius);
  for (int v = 0; v < part.solid.vertex_count; v++)
    part.solid.vertices[v] = lam_add(part.solid.vertices[v], center);
  lam_workshop_part(shop, part);
}

/* Builds the image as a net of its own, measures it, and puts it and its normals in place of the
 * workshop's net for the rows that follow. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const image_keys *k = params;
  lam_vec3 center = lam_sub(lam_v3(k->at[0], k->at[1], k->at[2]), shop->origin);
  lam_mesh image = lam_net_gauss_image(shop->arena, shop->net, shop->net->mesh.vertices, NULL);
  if (!image.face_count) {
    lam_error_add(shop->errors, location, "kind",
                  "the net has no inner vertex with four faces; its Gauss image is empty");
    return;
  }

  turn_outward(&image);
  lam_vec3 *normals = LAM_NEW(shop->arena, lam_vec3, image.vertex_count);
  for (int v = 0; v < image.vertex_count; v++) {
    normals[v] = image.vertices[v];
    image.vertices[v] = lam_along(center, k->radius, normals[v]);
  }

  lam_net *net = LAM_NEW(shop->arena, lam_net, 1);
  if (!lam_net_build(shop->arena, &image, location, shop->errors, net)) return;

  lam_stage *stage = lam_workshop_stage(shop, "gauss-image");
  static const char *const names[] = {"circularity", "face_planarity"};
  for (int i = 0; i < 2; i++)
    lam_stage_measure_add(shop->arena, stage,
                          lam_net_measure_one(shop->arena, net, net->mesh.vertices, names[i]));
  stage->converged = true;
  lam_stage_note(shop->arena, stage,
                 "the rows that follow are made on the image: %d vertices, %d faces",
                 net->mesh.vertex_count, net->mesh.face_count);

  if (k->ball) add_ball(shop, k, center);
  shop->net = net;
  shop->normals = normals;
  shop->lamella_grid = NULL;
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(image_keys, "radius", radius, "1 m", 1e-3, 1e4, "Radius of the sphere."),
    LAM_LENGTH_KEY(image_keys, "at", at, "[0, 0, 0]", -1e6, 1e6, "Its center."),
    LAM_FLAG_KEY(image_keys, "ball", ball, "no",
                 "Draws the sphere; parts outside it need an `offset`."),
    LAM_CHOICE_KEY(image_keys, "material", material, "card", lam_material_names,
                   "What the sphere looks like."),
    {0}};

const lam_part_kind lam_part_gauss_image = {
    .head = {.name = "gauss-image",
             .title = "The net's image on a sphere",
             .doc = "Every face gives a point of a sphere, in the direction of its normal, and "
                    "every inner vertex with four faces a quad between their points. The rows of "
                    "`parts` that follow are made on this image instead of the net: panels, bars, "
                    "circles. The image of a conical net is a circular net, and the report says "
                    "how nearly. Where the net bulges on one side and is a saddle on the other, "
                    "the image folds over itself.",
             .source = "thesis 3.5.2, figure 3.48",
             .keys = keys,
             .params_size = sizeof(image_keys)},
    .make = make};
