/* How a lamella grid is made: the parameters of the row, and the steps that turn a net into
 * strips, and strips into solids. For the files of fab/lamella and their tests. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_MAKE_H
#define LAM_FAB_LAMELLA_LAMELLA_MAKE_H

#include "fab/lamella/lamella.h"
#include "fab/workshop.h"

enum { LAM_JOINT_HALF_LAP, LAM_JOINT_NONE };

/* The keys of `joint`: meters, and radians for scissor (0: nodes do not turn). */
typedef struct lam_joint_keys {
  int kind; /* LAM_JOINT_... */
  double clearance, scissor;
} lam_joint_keys;

/* The keys of a `lamella` row; their meaning stands in the table of lamella.c. Meters. */
typedef struct lam_lamella_keys {
  lam_list families; /* of int */
  double height, thickness, pair;
  int every;
  double extend;
  lam_joint_keys joint;
  int material; /* index in lam_materials */
  bool boundary;
} lam_lamella_keys;

/* The opening that a partner of the same thickness needs at angle a (in (0, pi)): its own width
 * thickness / sin a and the shadow of the slotted sheet thickness |cos a| / sin a, with clearance
 * on both sides. */
static inline double lam_slot_width(double thickness, double clearance, double a) {
  return thickness * (1 + fabs(cos(a))) / sin(a) + 2 * clearance;
}

/* How far the middle line of a partner moves along a sheet while the node turns. With the sheet
 * at distance d from the axis of the node and the partner at distance e, both to the left, they
 * meet at
 *   x(theta) = (d cos theta - e) / sin theta.
 * theta runs from min(angle, scissor) to max(angle, pi - scissor) when scissor > 0, and stays at
 * angle otherwise. x is monotonic for |d| = |e|, so its extremes are at the ends. */
typedef struct lam_slot_range {
  double low, high; /* x - x(angle): low <= 0 <= high */
  double smallest;  /* the smallest angle reached, in (0, pi/2] */
} lam_slot_range;
lam_slot_range lam_slot_sweep(double d, double e, double angle, double scissor);

/* The extent of a station along its t: its slot, or nothing (0, 0) where there is none. */
void lam_station_extent(const lam_lamella_grid *grid, const lam_station *station, double *low,
                        double *high);

/* Which polylines of a family carry lamellas, a flag per polyline of the net: every k-th (see
 * lamella_select.c), without those along the boundary unless `boundary`. every >= 1; owned by
 * arena. */
bool *lam_lamella_select(lam_arena *arena, const lam_net *net, int family, int every,
                         bool boundary);

/* Fills grid with strips and nodes of workshop->net (with workshop->normals); parts are numbered
 * from part on. False when the keys do not fit the net: errors are added with location, and grid
 * is incomplete. Everything is allocated in the workshop's arena. */
bool lam_lamella_layout(lam_workshop *workshop, const lam_lamella_keys *keys, lam_location location,
                        int part, lam_lamella_grid *grid);

/* The solid of a strip: closed, oriented, 2-manifold by construction (see lamella_solid.c). Owned
 * by arena. */
lam_trimesh lam_lamella_solid(lam_arena *arena, const lam_lamella_grid *grid,
                              const lam_sheet_strip *strip);

/* Numbers strips that are the same flat part: class[i] (strip_count of them) counts from first
 * on; classes in order of appearance. Returns the number of classes. */
int lam_lamella_classes(lam_arena *arena, const lam_lamella_grid *grid, int first, int *class);

#endif
