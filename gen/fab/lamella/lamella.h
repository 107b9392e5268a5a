/* Lamellas: strips normal to the net along its polylines, as stations. A sheet is one strip of
 * material; a lamella is one sheet, or a pair of sheets `pair` apart. Made by lamella_grid.c;
 * read by all of fab/lamella, and by later rows through lam_workshop.lamella_grid. Meters and
 * radians.
 *
 * A station is a cross-section of a sheet. With the position x on the sheet's middle line, the
 * unit height direction m (along the net's normal) and the unit direction of travel t
 * (perpendicular to m), the thickness direction is b = m x t. The material is
 *   { x + h m + y b : |h| <= height/2, |y| <= thickness/2 },
 * interpolated between stations. At a crossing both sheets have a station at the same point with
 * the same m: they share the line x + h m, so the joint is exact whatever the twist.
 *
 * At a crossing station the section becomes two, at x + low t and x + high t (both with the
 * directions of the station), and the cell between them is left out above the floor (family 0,
 * which opens up) or below it (family 1, which opens down):
 *   low   = slot_low  - width/2
 *   high  = slot_high + width/2
 *   width = thickness (1 + |cos a|) / sin a + 2 clearance
 *   floor: h = -clearance for family 0, +clearance for family 1
 * slot_low <= 0 <= slot_high is where the partner's middle line moves while the grid is turned
 * from the crossing angle to the scissor angle, both ways; a is the smallest angle reached. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_H
#define LAM_FAB_LAMELLA_LAMELLA_H

#include "core/model.h"

typedef struct lam_station {
  lam_vec3 x, t, m;
  double s;       /* arc length along the sheet's curve (lamella_curve.h), from 0 at its start */
  double heading; /* direction of travel in the plane when the strip is developed, with m upwards
                     and 0 along +x */
  bool between;   /* it stands between nodes, only to follow the curve; no node, and not an end */
  int vertex;     /* of the net that it belongs to; -1: none */
  int partner;    /* sheet index that crosses here; -1: no crossing */
  int crossing;   /* index of the net crossing in the grid; -1 */
  double angle;   /* crossing angle, in (0, pi); 0 when no crossing */
  double slot_low, slot_high; /* see above; 0 when no crossing */
  double slot_angle;          /* a, see above */
} lam_station;

/* One sheet of a lamella. */
typedef struct lam_sheet_strip {
  const char *name;          /* "A07", or "A07a" and "A07b" in a pair */
  int family, number, group; /* number counts from 1 in its family; group: index of the lamella */
  double offset;             /* signed distance from the net's polyline along b */
  int station_count;
  lam_station *stations;
  double length;
  int part; /* index of the part made from it */
} lam_sheet_strip;

/* A node: where two lamellas cross (2 x 2 sheets in pairs). */
typedef struct lam_grid_node {
  int vertex;     /* of the net */
  int lamella[2]; /* per family */
  lam_vec3 x, normal, t[2];
  double angle;
} lam_grid_node;

typedef struct lam_lamella_grid {
  double height, thickness, pair, clearance; /* pair: 0 when lamellas are single sheets */
  int strip_count;
  lam_sheet_strip *strips;
  lam_polyline *axes; /* per lamella (strips[].group): vertices of the net, first to last */
  int node_count;
  lam_grid_node *nodes;
  const lam_material *material;
} lam_lamella_grid;

/* The kind of part that makes grids; node_connector.c looks for its rows. */
extern const struct lam_part_kind lam_part_lamella;

#endif
