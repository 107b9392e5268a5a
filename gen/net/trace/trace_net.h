/* The parts of lam_trace_net. For the files of net/trace_*.c only. */
#ifndef LAM_NET_TRACE_TRACE_NET_H
#define LAM_NET_TRACE_TRACE_NET_H

#include "net/trace/trace.h"

/* A net of the lines of two fields, through `at`, where they run along d. Cells and spacing as in
 * lam_trace_options. False: there is no cell. */
bool lam_weave_net(lam_arena *arena, const lam_line_field field[2], const lam_vec2 d[2],
                   const double at[2], const int grid[2], double spacing, lam_mesh *mesh);

/* Geodesic parallels and circles. False: there is no cell. */
bool lam_geodesic_parallel_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                               int base, const int grid[2], double spacing, lam_mesh *mesh);
bool lam_geodesic_polar_net(lam_arena *arena, const lam_line_field *field, const double at[2],
                            const int grid[2], int hole, double spacing, lam_mesh *mesh);

#endif
