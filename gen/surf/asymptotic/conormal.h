/* Edges of a skin from conormals, and patches between them. For the files of this folder only:
 * conormal.c makes an edge, conormal_fit.c finds the conormals of a whole skin, conormal_patch.c
 * makes a patch over four edges, skin_patches.c puts them together. */
#ifndef LAM_SURF_ASYMPTOTIC_CONORMAL_H
#define LAM_SURF_ASYMPTOTIC_CONORMAL_H

#include "surf/asymptotic/asymptotic_skin.h"
#include "surf/asymptotic/quad_parts.h"

enum {
  LAM_CONORMAL_DEGREE = 4, /* of the conormals along an edge */
  LAM_CONORMAL_POINTS = LAM_CONORMAL_DEGREE + 1,
  LAM_CONORMAL_CURVE = 2 * LAM_CONORMAL_DEGREE - 1, /* degree of the edge */
  LAM_CONORMAL_SURFACE = 9                          /* degree of the patch, in u and v */
};

/* Between two vertices. At end 0 the edge leaves, at end 1 it arrives along the first direction of
 * the vertex after `turn` quarter turns. */
typedef struct lam_conormal_arc {
  int vertex[2], turn[2];
  lam_vec3 middle; /* the middle one of the five control points of the conormals */
  int sign;        /* of its torsion: +1 or -1; set by lam_conormal_signs */
} lam_conormal_arc;

/* The slope of a vertex after quarter turns: along u, v, -u, -v. */
static inline lam_vec3 lam_conormal_slope(const lam_conormal_vertex *v, int turn) {
  return lam_scale(v->slope[turn & 1], turn & 2 ? -1 : 1);
}

/* Chooses the signs: curves that cross have opposite torsion, so that there is one choice for every
 * connected part. Returns how many edges contradict it: their chord does not go with the conormals
 * at their ends. */
int lam_conormal_signs(lam_arena *arena, int vertex_count, const lam_conormal_vertex *vertices,
                       int edge_count, lam_conormal_arc *edges);
/* Moves conormals and slopes as little as it takes for all edges to end at their vertices, and sets
 * the middle control points of the edges, whose signs are set. Not converged is a result: what was
 * reached stands then. */
lam_skin_fit lam_conormal_fit(lam_arena *arena, int vertex_count, lam_conormal_vertex *vertices,
                              int edge_count, lam_conormal_arc *edges);

/* A curve with its conormals. */
typedef struct lam_conormal_edge {
  lam_vec3 points[LAM_CONORMAL_CURVE + 1];
  lam_vec3 conormals[LAM_CONORMAL_POINTS];
} lam_conormal_edge;

/* The curve of an edge with its conormals, by its vertices, middle control point and sign. */
lam_conormal_edge lam_conormal_edge_make(const lam_conormal_vertex *vertices,
                                         const lam_conormal_arc *edge);

/* What all patches share: 10 x 10 control points over the unit square, and their thin-plate energy.
 * Owned by arena. */
typedef struct lam_conormal_plate lam_conormal_plate;
const lam_conormal_plate *lam_conormal_plate_make(lam_arena *arena);
/* The 10 x 10 control points, v running fastest, of the patch over four edges in the order and
 * direction r1, r2, r3, r4, and its thin-plate energy (m^2). false: it folds over along an edge. */
bool lam_conormal_patch_make(const lam_conormal_plate *plate, const lam_conormal_edge edges[4],
                             lam_vec3 *points, double *energy);

#endif
