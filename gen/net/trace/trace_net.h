/* The parts of lam_trace_net: each makes a mesh, and tells in cells where its vertices lie in (u,
 * v); both are owned by arena. For the files trace_*.c of this folder only. */
#ifndef LAM_NET_TRACE_TRACE_NET_H
#define LAM_NET_TRACE_TRACE_NET_H

#include "net/trace/trace_cover.h"

/* A net of the lines of two fields, through `at`, where they run along d. Cells and spacing as in
 * lam_trace_options. False: there is no cell. */
bool lam_weave_net(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                   const double at[2], const int grid[2], double spacing, lam_mesh *mesh,
                   lam_cells *cells);
/* The same roughly and without a mesh, to see what it would cover: a few cells. */
bool lam_weave_roughly(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                       const double at[2], lam_cells *cells);

/* Geodesics at right angles to the parameter line of `base` through `at`, and their points at
 * equal distance from it; cells and spacing as in lam_trace_options. False: there is no cell. */
bool lam_geodesic_parallel_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                               int base, const int grid[2], double spacing, lam_mesh *mesh,
                               lam_cells *cells);
/* Geodesics from the pole `at` and the circles around it; grid: rings and spokes. The innermost
 * max(1, hole) rings are left out. False: there is no cell. */
bool lam_geodesic_polar_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                            const int grid[2], int hole, double spacing, lam_mesh *mesh,
                            lam_cells *cells);

/* Cuts the range [from, to] of arc length down to multiples of the spacing, at most `cells` cells
 * of them, as evenly around 0 as the range allows; returns the number of cells. */
int lam_spaced_range(double spacing, int cells, double *from, double *to);

#endif
