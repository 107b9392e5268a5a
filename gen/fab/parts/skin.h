/* Smooth skins over asymptotic nets: from the net to the cells of the skin and the data of its
 * vertices (skin_cells.c), from patches to thin solids (skin_shell.c), and measures
 * (skin_measure.c). Called by the row `skin` in skin.c, and by tests. Patches are made in
 * surf/asymptotic. Meters. */
#ifndef LAM_FAB_PARTS_SKIN_H
#define LAM_FAB_PARTS_SKIN_H

#include "mesh/net.h"
#include "surf/asymptotic/asymptotic_skin.h"

/* The cells of a skin. */
typedef struct lam_skin_net {
  int every; /* edges of the net along a side of a cell */
  int cell_count;
  lam_skin_cell *cells; /* vertices are those of the net */
  int irregular;        /* cells left out because a corner has no two lines through it */
  int uncovered;        /* faces of the net in no cell, left out or not */
  /* Per vertex of the net; slopes belong to `every` edges. Zero where no two lines cross. */
  lam_conormal_vertex *vertices;
  /* Per cell and side r1, r2, r3, r4: the first vertex, and the entry of net->ring (counted from
   * ring_start) in which the side leaves it. */
  int (*sides)[4][2];
} lam_skin_net;

/* Cells of every x every faces (every >= 1). Conormals are the discrete Lelieuvre normals of the
 * net; their slopes are those of polynomials of degree 4 through five vertices in sequence along
 * its lines, where there are so many, shifted inward at its border. Owned by arena. */
lam_skin_net lam_skin_net_make(lam_arena *arena, const lam_net *net, int every);
/* Walks `steps` edges straight ahead from v, which is left by entry `slot` of its ring, and
 * returns the vertex reached; *back is the entry there that leads back. -1: the line ends. */
int lam_skin_walk(const lam_net *net, int v, int slot, int steps, int *back);

/* Points of patches with normals, shared along common sides. */
typedef struct lam_skin_mesh {
  int subdivisions, cell_count;
  int *grid;           /* per cell (subdivisions + 1)^2 indices of points, v running fastest */
  int (*neighbors)[4]; /* per cell and side: the cell there, or -1 */
  int point_count;
  lam_vec3 *points, *normals;
} lam_skin_mesh;

/* Samples count patches (surfaces over the unit square or any other knots) in subdivisions x
 * subdivisions facets; those with four equal end points of sides, in either direction, are
 * neighbors. Owned by arena. */
lam_skin_mesh lam_skin_mesh_make(lam_arena *arena, int count, const lam_spline_surface *surfaces,
                                 int subdivisions);
/* The solid between the points moved by low and by high (low < high) along the normals, over the
 * cells whose piece (piece: one number per cell) has this number. Closed when the piece is a
 * sheet; owned by arena. */
lam_trimesh lam_skin_shell(lam_arena *arena, const lam_skin_mesh *mesh, const int *piece,
                           int number, double low, double high);
/* Numbers the connected pieces from 0 (piece: one number per cell); returns how many there are. */
int lam_skin_pieces(lam_arena *arena, const lam_skin_mesh *mesh, int *piece);

/* What was measured of a skin. */
typedef struct lam_skin_facts {
  /* Common sides of two patches, and across them: largest distance, largest angle of the normals
   * and sum of its means per side. */
  int seams;
  double gap, jump, jump_sum;
  /* Ends of sides at which another side continues them, and the largest angle there. */
  long joints;
  double kink;
  /* Sides of patches, and those of them along which |k_n| <= 1e-8 sqrt(-K). */
  long sides, exact;
  /* Largest |k_n| / sqrt(-K) along sides, and sum of the means: 0 for asymptotic curves, 1 for the
   * principal lines of a minimal surface. */
  double slant, slant_sum;
  double energy, largest_energy; /* of thin plates: sum and largest of all patches */
  /* Samples inside the patches, and those where the Gaussian curvature is not negative. */
  long samples, domes;
  double least_k, largest_k; /* Gaussian curvature there, 1/m^2 */
  double least_sine;         /* of the angle between the parameter lines */
} lam_skin_facts;
/* surfaces: those that mesh was made from, over the unit square. */
lam_skin_facts lam_skin_measure(lam_arena *arena, const lam_skin_mesh *mesh,
                                const lam_spline_surface *surfaces);
/* The largest distance of the net's vertices between the corners of cells from the sides of the
 * patches, meters. patches: one per cell; those without a surface are left out. */
double lam_skin_distance(const lam_net *net, const lam_skin_net *cells,
                         const lam_asymptotic_patch *patches);

#endif
