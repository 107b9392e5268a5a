#include "formats/pov/pov_print.h"

#include "core/image.h"
#include "formats/pov/pov_net.h"
#include "formats/print.h"

static void add_sheet(lam_text *out, const lam_printed *sheet, int number, int decimals) {
  const lam_trimesh *mesh = &sheet->mesh;
  const lam_vec3 *normals = lam_print_normals(out->arena, mesh);
  lam_text_printf(out, "// print: %s\n#declare Sheet_%d = mesh2 {\n  vertex_vectors { %d",
                  sheet->name, number, mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_text_add(out, v % 4 ? "," : ",\n    ");
    lam_pov_vector(out, mesh->vertices[v], decimals);
  }
  lam_text_printf(out, " }\n  normal_vectors { %d", mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_text_add(out, v % 4 ? "," : ",\n    ");
    lam_pov_vector(out, normals[v], 4);
  }
  lam_text_printf(out, " }\n  uv_vectors { %d", mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_text_add(out, v % 6 ? ",<" : ",\n    <");
    lam_text_number(out, sheet->places[v].x, 5);
    lam_text_add(out, ",");
    lam_text_number(out, sheet->places[v].y, 5);
    lam_text_add(out, ">");
  }
  lam_text_printf(out, " }\n  face_indices { %d", mesh->triangle_count);
  for (int t = 0; t < mesh->triangle_count; t++)
    lam_text_printf(out, "%s<%d,%d,%d>", t % 8 ? "," : ",\n    ", mesh->triangles[t][0],
                    mesh->triangles[t][1], mesh->triangles[t][2]);
  lam_text_add(out, " }\n}\n");
}

void lam_pov_print_add(lam_text *out, const lam_print *print, int decimals) {
  lam_text_add(
      out,
      "#declare Texture_Print = texture {\n  uv_mapping\n  pigment { image_map { png \"print.png\" "
      "interpolate 2 } }\n  finish { diffuse 0.8 specular 0.08 roughness 0.05 }\n}\n");
  for (int i = 0; i < print->count; i++) add_sheet(out, &print->sheets[i], i + 1, decimals);
}

void lam_pov_print_objects(lam_text *out, const lam_print *print, int number) {
  for (int i = 0; i < print->count; i++)
    lam_text_printf(out,
                    "object { Sheet_%d #if (Mask) texture { pigment { color Mask_Color(%d) } "
                    "finish { ambient 0 "
                    "diffuse 0 emission 1 } } #else texture { Texture_Print } #end }\n",
                    i + 1, number + i + 1);
}

lam_status lam_pov_print_picture(lam_text *out, const lam_print *print) {
  uint8_t *bytes;
  size_t count;
  lam_image image = {print->width, print->height, (uint8_t *)print->pixels}; /* only read */
  if (!lam_image_encode(out->arena, &image, &bytes, &count)) return LAM_FAILED;
  lam_text_bytes(out, bytes, count);
  return LAM_OK;
}
