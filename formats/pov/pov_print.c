/* Prints as meshes with texture coordinates, for the POV-Ray writer (pov.c). */
#include "formats/pov/pov_print.h"

#include "core/image.h"
#include "formats/pov/pov_net.h"
#include "formats/print.h"

/* A list of mesh2 with one vector per vertex, four in a line, after its name and "{". */
static void add_vectors(lam_text *out, const lam_vec3 *vectors, int count, int decimals) {
  for (int v = 0; v < count; v++) {
    lam_text_add(out, v % 4 ? "," : ",\n    ");
    lam_pov_vector(out, vectors[v], decimals);
  }
}

/* A printed surface as mesh2, called Sheet_NUMBER. Texture coordinates count from the lower left
 * corner of the picture, in POV-Ray as in the model. */
static void add_sheet(lam_text *out, const lam_printed *sheet, int number, int decimals) {
  const lam_trimesh *mesh = &sheet->mesh;
  const lam_vec3 *normals = lam_print_normals(out->arena, mesh);
  lam_text_printf(out, "// print: %s\n#declare Sheet_%d = mesh2 {\n  vertex_vectors { %d",
                  sheet->name, number, mesh->vertex_count);
  add_vectors(out, mesh->vertices, mesh->vertex_count, decimals);
  lam_text_printf(out, " }\n  normal_vectors { %d", mesh->vertex_count);
  add_vectors(out, normals, mesh->vertex_count, 4);

  lam_text_printf(out, " }\n  uv_vectors { %d", mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_text_add(out, v % 6 ? ",<" : ",\n    <");
    lam_text_number(out, sheet->texture[v].x, 5);
    lam_text_add(out, ",");
    lam_text_number(out, sheet->texture[v].y, 5);
    lam_text_add(out, ">");
  }

  lam_text_printf(out, " }\n  face_indices { %d", mesh->triangle_count);
  for (int t = 0; t < mesh->triangle_count; t++)
    lam_text_printf(out, "%s<%d,%d,%d>", t % 8 ? "," : ",\n    ", mesh->triangles[t][0],
                    mesh->triangles[t][1], mesh->triangles[t][2]);
  lam_text_add(out, " }\n}\n");
}

/* One texture for all: each mesh has its own texture coordinates in the one picture. */
void lam_pov_print_add(lam_text *out, const lam_print *print, int decimals) {
  lam_text_add(
      out,
      "#declare Texture_Print = texture {\n  uv_mapping\n  pigment { image_map { png \"print.png\" "
      "interpolate 2 } }\n  finish { diffuse 0.8 specular 0.08 roughness 0.05 }\n}\n");
  for (int i = 0; i < print->count; i++) add_sheet(out, &print->sheets[i], i + 1, decimals);
}

/* A setting that asks for the mask gets the number as a flat color instead of the print. */
void lam_pov_print_objects(lam_text *out, const lam_print *print, int number) {
  for (int i = 0; i < print->count; i++)
    lam_text_printf(out,
                    "object { Sheet_%d #if (Mask) texture { pigment { color Mask_Color(%d) } "
                    "finish { ambient 0 diffuse 0 emission 1 } } #else texture { Texture_Print } "
                    "#end }\n",
                    i + 1, number + i + 1);
}

/* The same pixels give the same bytes. */
lam_status lam_pov_print_picture(lam_text *out, const lam_print *print) {
  uint8_t *bytes;
  size_t count;
  lam_image image = {print->width, print->height, (uint8_t *)print->pixels}; /* only read */
  if (!lam_image_encode(out->arena, &image, &bytes, &count)) return LAM_FAILED;
  lam_text_bytes(out, bytes, count);
  return LAM_OK;
}
