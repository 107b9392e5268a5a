#include "mesh/net_sides.h"

#include <string.h>

const char *const lam_side_names[] = {"u0", "u1", "v0", "v1", NULL};

static int family_of(const lam_net *net, int a, int b) {
  for (int e = 0; e < net->edge_count; e++) {
    const int *v = net->edges[e].vertex;
    if ((v[0] == a && v[1] == b) || (v[0] == b && v[1] == a)) return net->edges[e].family;
  }
  return -1;
}

/* vertices[from .. from + count - 1] of a loop, cyclically, forwards or backwards. */
static lam_polyline piece(lam_arena *arena, const lam_polyline *loop, int from, int count,
                          bool backwards, int family) {
  lam_polyline line = {family, false, count, LAM_NEW(arena, int, count)};
  for (int k = 0; k < count; k++)
    line.vertices[backwards ? count - 1 - k : k] = loop->vertices[(from + k) % loop->count];
  return line;
}

/* One loop with four corners. */
static bool rectangle_side(lam_arena *arena, const lam_net *net, lam_side side,
                           lam_polyline *line) {
  const lam_polyline *loop = &net->loops[0];
  int corner[4], corners = 0, first = 0;
  for (int k = 0; k < loop->count; k++) {
    int v = loop->vertices[k];
    if (net->ring_start[v + 1] - net->ring_start[v] != 2) continue;
    if (corners == 4) return false;
    corner[corners++] = k;
  }
  if (corners != 4) return false;
  for (int c = 1; c < 4; c++)
    if (loop->vertices[corner[c]] < loop->vertices[corner[first]]) first = c;
  /* the loop runs counterclockwise: v0, u1, v1 backwards, u0 backwards; the other way around from a
   * net whose faces begin along family 1 */
  static const lam_side order[2][4] = {{LAM_SIDE_V0, LAM_SIDE_U1, LAM_SIDE_V1, LAM_SIDE_U0},
                                       {LAM_SIDE_U0, LAM_SIDE_V1, LAM_SIDE_U1, LAM_SIDE_V0}};
  int start = corner[first],
      family = family_of(net, loop->vertices[start], loop->vertices[(start + 1) % loop->count]);
  for (int k = 0; k < 4; k++) {
    int from = corner[(first + k) & 3], to = corner[(first + k + 1) & 3];
    int count = (to - from + loop->count) % loop->count + 1;
    if (order[family][k] == side) *line = piece(arena, loop, from, count, k >= 2, family ^ (k & 1));
  }
  return true;
}

/* Two loops without corners. */
static bool tube_side(lam_arena *arena, const lam_net *net, lam_side side, lam_polyline *line) {
  const lam_polyline *loops = net->loops;
  int family = family_of(net, loops[0].vertices[0], loops[0].vertices[1]), low[2] = {0, 0};
  bool along_u = side == LAM_SIDE_V0 || side == LAM_SIDE_V1,
       last = side == LAM_SIDE_U1 || side == LAM_SIDE_V1;
  for (int l = 0; l < 2; l++) {
    low[l] = loops[l].vertices[0];
    for (int k = 0; k < loops[l].count; k++) {
      int v = loops[l].vertices[k];
      if (net->ring_start[v + 1] - net->ring_start[v] != 3) return false;
      if (v < low[l]) low[l] = v;
    }
  }
  if (family != (along_u ? 0 : 1)) return false;
  const lam_polyline *loop = &loops[(low[1] < low[0]) != last];
  int start = 0;
  while (loop->vertices[start] != low[loop - loops]) start++;
  *line = piece(arena, loop, start, loop->count, false, family);
  line->closed = true;
  return true;
}

bool lam_net_side(lam_arena *arena, const lam_net *net, lam_side side, lam_polyline *line) {
  if (net->loop_count == 1) return rectangle_side(arena, net, side, line);
  return net->loop_count == 2 && tube_side(arena, net, side, line);
}

int lam_net_grid_vertex(lam_arena *arena, const lam_net *net, int i, int j) {
  lam_polyline bottom;
  if (net->loop_count != 1 || !lam_net_side(arena, net, LAM_SIDE_V0, &bottom)) return -1;
  if (i < 0 || i >= bottom.count || j < 0) return -1;
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->closed || line->family == bottom.family || j >= line->count) continue;
    if (line->vertices[0] == bottom.vertices[i]) return line->vertices[j];
    if (line->vertices[line->count - 1] == bottom.vertices[i])
      return line->vertices[line->count - 1 - j];
  }
  return -1;
}
