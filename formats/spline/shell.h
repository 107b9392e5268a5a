/* Surfaces joined along their sides: what their corners and sides have in common, so that
 * neighbors share vertices and edges, and which way around each has to be taken for all to face
 * the same side. For writers of formats with topology (formats/step/step.c); one that lists
 * surfaces one by one needs spline.h alone, and readers need none of it. */
#ifndef LAM_FORMATS_SPLINE_SHELL_H
#define LAM_FORMATS_SPLINE_SHELL_H

#include "formats/spline/spline.h"

/* A side of a surface, or two of them that coincide point by point. */
typedef struct lam_shell_edge {
  int surface, side; /* whose curve it is */
  int vertex[2];     /* from, to, along that curve: of the shell's vertices */
  int uses;          /* 1 on the border, 2 inside */
} lam_shell_edge;

/* How a surface uses an edge. */
typedef struct lam_shell_use {
  int edge;     /* -1: the side is only a point */
  bool forward; /* whether the side's curve runs with the edge's */
} lam_shell_use;

typedef struct lam_shell {
  int vertex_count, edge_count, part_count;
  int *vertices;         /* corners that are vertices: 4 * surface + corner */
  lam_shell_edge *edges; /* edge_count */
  lam_shell_use *uses;   /* per surface four, in the order of lam_spline_side_of */
  bool *flipped;         /* per surface: taken with its normal turned around */
  int *part;   /* per surface: its connected part, from 0 in the order of first surfaces */
  int *border; /* per part: edges used once; 0: it closes up */
} lam_shell;

/* Corner k of the counterclockwise boundary, where side k begins when k < 2: its index among the
 * surface's points. */
int lam_shell_corner(const lam_spline_surface *surface, int k);

/* The shell of `count` surfaces with clamped knots, which must stay. Corners are one vertex when
 * they are within a billionth of the size of all surfaces or a nanometer; sides are one edge when
 * all their points at corresponding parameters are, in either direction. A third side on an edge,
 * or one that would turn the surface over, keeps an edge of its own. Everything is owned by the
 * arena. */
lam_shell lam_shell_make(lam_arena *arena, int count, const lam_spline_surface *surfaces);

#endif
