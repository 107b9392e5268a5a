/* A panel: one face of a net as a plate with its gap to the neighbors. Called by the rows panels
 * and support (whose beams are plates too).
 *
 * Every edge inside the net has a joint plane: it halves the angle between the two faces. The
 * side walls of a plate are square to it, and its outline is moved inward from the edge until the
 * plate stays gap/2 away from the joint plane all through its thickness. Two plates are then
 * exactly `gap` apart where they come closest. With the fold angle a (positive over a ridge,
 * negative over a valley, seen from the side of the normal) and heights h along the normal:
 *   distance of the wall at inset d to the joint plane = d cos(a/2) + h sin(a/2) >= gap/2
 *   for low <= h <= high */
#ifndef LAM_FAB_PARTS_PANEL_H
#define LAM_FAB_PARTS_PANEL_H

#include "core/arena.h"
#include "core/model.h"
#include "mesh/net.h"

/* Where plates lie over the net and how they are made, in meters. */
typedef struct lam_panel_layer {
  double low, high; /* heights of the two sides over the net, along its normal */
  double gap;
  /* A face whose diagonals pass at no more than this share of their mean length becomes a flat
   * plate. */
  double tolerance;
} lam_panel_layer;

typedef struct lam_panel {
  lam_vec3 corner[4]; /* of the outline, in the height of the net; of a flat panel in one plane */
  lam_vec3 normal;    /* unit, of the plane of best fit */
  bool flat;
  double warp;     /* distance between the diagonals of the face, m */
  double diagonal; /* mean length of the diagonals of the face */
} lam_panel;

/* For every face and side k (from corner k to the next) the face beyond it, or -1. neighbor:
 * face_count rows, filled here. */
void lam_panel_neighbors(const lam_net *net, int (*neighbor)[4]);

/* The panel of a face. neighbor: as lam_panel_neighbors fills it. False when the face has no area
 * or its gaps leave nothing of it; panel is incomplete then. */
bool lam_panel_make(const lam_net *net, const int (*neighbor)[4], int face,
                    const lam_panel_layer *layer, lam_panel *panel);

/* The closed solid, owned by arena: a plate, or a bilinear patch in 4 x 4 cells, thickened along
 * its own normals. */
lam_trimesh lam_panel_solid(lam_arena *arena, const lam_panel *panel, const lam_panel_layer *layer);

/* The flat pattern of a flat panel, owned by arena: the outline on CUT (first corner at the origin,
 * second on the x axis, seen from the side of the normal), the name on LABEL in the middle, along
 * the first side, where it has room. */
lam_flat *lam_panel_flat(lam_arena *arena, const lam_panel *panel, const lam_panel_layer *layer,
                         const char *name);

/* Numbers flat panels that are the same plate, turned over or not, to a tenth of a millimeter:
 * class[i] (count of them) counts from first on in order of appearance, and is 0 where panels[i]
 * is not flat. Returns the number of classes. */
int lam_panel_classes(lam_arena *arena, const lam_panel *panels, int count, int first, int *class);

#endif
