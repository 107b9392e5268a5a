/* Vectors and meshes of POV-Ray scene language, and the net in it. Called by pov.c and
 * pov_print.c. */
#include "formats/pov/pov_net.h"

#include "core/solid/triangles.h"
#include "formats/corner_normals.h"
#include <stdlib.h>

/* Radius of a line inside the net, as a share of the mean edge. */
static const double line_share = 0.026;

/* ---- pieces of scene language ---- */

/* No blanks: scenes are large. */
void lam_pov_vector(lam_text *out, lam_vec3 v, int decimals) {
  lam_text_add(out, "<");
  lam_text_number(out, v.x, decimals);
  lam_text_add(out, ",");
  lam_text_number(out, v.y, decimals);
  lam_text_add(out, ",");
  lam_text_number(out, v.z, decimals);
  lam_text_add(out, ">");
}

/* A list of mesh2: name { count, <x,y,z>, ... }, four vectors in a line. */
static void add_vectors(lam_text *out, const char *name, const lam_vec3 *vectors, int count,
                        int decimals) {
  lam_text_printf(out, "  %s { %d", name, count);
  for (int i = 0; i < count; i++) {
    lam_text_add(out, i % 4 ? "," : ",\n    ");
    lam_pov_vector(out, vectors[i], decimals);
  }
  lam_text_add(out, " }\n");
}

/* The faces of mesh2, eight in a line; indices count from 0. */
static void add_triples(lam_text *out, const char *name, const int (*triples)[3], int count) {
  lam_text_printf(out, "  %s { %d", name, count);
  for (int i = 0; i < count; i++) {
    lam_text_printf(out, "%s<%d,%d,%d>", i % 8 ? "," : ",\n    ", triples[i][0], triples[i][1],
                    triples[i][2]);
  }
  lam_text_add(out, " }\n");
}

/* Normals need few decimals. */
void lam_pov_mesh(lam_text *out, const char *name, const lam_trimesh *solid, double smooth_angle,
                  int decimals) {
  lam_shaded_mesh mesh = lam_shaded_mesh_make(out->arena, solid, smooth_angle);
  lam_vec3 *vertices = LAM_NEW(out->arena, lam_vec3, mesh.vertex_count);
  for (int i = 0; i < mesh.vertex_count; i++) vertices[i] = solid->vertices[mesh.source[i]];

  lam_text_printf(out, "#declare %s = mesh2 {\n", name);
  add_vectors(out, "vertex_vectors", vertices, mesh.vertex_count, decimals);
  add_vectors(out, "normal_vectors", mesh.normals, mesh.vertex_count, 4);
  add_triples(out, "face_indices", (const int(*)[3])mesh.triangles, mesh.triangle_count);
  lam_text_add(out, "}\n");
}

/* ---- lines ---- */

/* An edge by its vertices, low < high. */
typedef struct line {
  int low, high;
} line;

/* For qsort: by the lower, then by the higher vertex; 0 for the same edge. */
static int by_ends(const void *a, const void *b) {
  const line *p = a, *q = b;
  return p->low != q->low ? p->low - q->low : p->high - q->high;
}

/* Every edge as often as it has faces, sorted; the array is the arena's. Returns how many there
 * are. */
static int list_lines(lam_arena *arena, const lam_mesh *net, line **lines) {
  int count = 0;
  *lines = LAM_NEW(arena, line, 4 * net->face_count);
  for (int f = 0; f < net->face_count; f++) {
    int corners = net->faces[f][3] < 0 ? 3 : 4;
    for (int k = 0; k < corners; k++) {
      int a = net->faces[f][k], b = net->faces[f][(k + 1) % corners];
      (*lines)[count++] = (line){a < b ? a : b, a < b ? b : a};
    }
  }
  qsort(*lines, (size_t)count, sizeof **lines, by_ends);
  return count;
}

/* A sphere that rounds off the lines at a vertex. */
static void add_ball(lam_text *out, lam_vec3 x, double radius, int decimals) {
  lam_text_add(out, "  sphere { ");
  lam_pov_vector(out, x, decimals);
  lam_text_add(out, ", ");
  lam_text_number(out, radius, decimals + 1);
  lam_text_add(out, " }\n");
}

/* A cylinder from a to b. The radius, smaller than coordinates, gets a decimal more. */
static void add_line(lam_text *out, lam_vec3 a, lam_vec3 b, double radius, int decimals) {
  lam_text_add(out, "  cylinder { ");
  lam_pov_vector(out, a, decimals);
  lam_text_add(out, ", ");
  lam_pov_vector(out, b, decimals);
  lam_text_add(out, ", ");
  lam_text_number(out, radius, decimals + 1);
  lam_text_add(out, " }\n");
}

/* Lines, and at every vertex a ball as thick as the thickest line there. An edge that is listed
 * once is on the boundary, and twice as thick; one of no length has no cylinder. */
static void add_lines(lam_text *out, const lam_mesh *net, int decimals) {
  line *lines;
  int count = list_lines(out->arena, net, &lines);
  double mean = 0, *radius = LAM_NEW(out->arena, double, net->vertex_count);
  for (int i = 0; i < count; i++)
    mean += lam_distance(net->vertices[lines[i].low], net->vertices[lines[i].high]) / count;

  for (int i = 0; i < count; i++) {
    bool twice = i + 1 < count && by_ends(&lines[i], &lines[i + 1]) == 0;
    double thick = mean * line_share * (twice ? 1 : 2);
    lam_vec3 a = net->vertices[lines[i].low], b = net->vertices[lines[i].high];
    if (lam_distance(a, b) > 1e-6 * mean) add_line(out, a, b, thick, decimals);
    radius[lines[i].low] = fmax(radius[lines[i].low], thick);
    radius[lines[i].high] = fmax(radius[lines[i].high], thick);
    i += twice;
  }

  for (int v = 0; v < net->vertex_count; v++)
    if (radius[v] > 0) add_ball(out, net->vertices[v], radius[v], decimals);
}

/* A union of lines has one texture. */
void lam_pov_net_add(lam_text *out, const lam_mesh *net, double smooth_angle, int decimals) {
  lam_trimesh faces = lam_mesh_triangles(out->arena, net);
  lam_pov_mesh(out, "Net_Faces", &faces, smooth_angle, decimals);

  lam_text_add(out, "#declare Net_Lines = union {\n");
  add_lines(out, net, decimals);
  lam_text_add(out, "}\n");
}
