/* Sides and grid positions of rectangular nets and tubes, for the handles of net/handles.c. */
#include "mesh/net_sides.h"

#include <string.h>

const char *const lam_side_names[] = {"u0", "u1", "v0", "v1", NULL};

/* The family of the edge between vertices a and b; -1: there is none. */
static int family_of(const lam_net *net, int a, int b) {
  for (int e = 0; e < net->edge_count; e++)
    if (lam_edge_joins(&net->edges[e], a, b)) return net->edges[e].family;
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

/* ---- one loop with four corners ---- */

/* The positions of four corners (vertices with two edges) in the loop, in its direction, beginning
 * with the corner of the smallest vertex. False: there are fewer or more. */
static bool find_corners(const lam_net *net, const lam_polyline *loop, int corner[4]) {
  int found[4], corners = 0, first = 0;
  for (int k = 0; k < loop->count; k++) {
    if (lam_net_valence(net, loop->vertices[k]) != 2) continue;
    if (corners == 4) return false;
    found[corners++] = k;
  }
  if (corners != 4) return false;

  for (int c = 1; c < 4; c++)
    if (loop->vertices[found[c]] < loop->vertices[found[first]]) first = c;
  for (int c = 0; c < 4; c++) corner[c] = found[(first + c) & 3];
  return true;
}

/* lam_net_side on a net with one loop. */
static bool rectangle_side(lam_arena *arena, const lam_net *net, lam_side side,
                           lam_polyline *line) {
  const lam_polyline *loop = &net->loops[0];
  int corner[4];
  if (!find_corners(net, loop, corner)) return false;

  /* From the first corner the loop runs along v0 or, on a net whose faces begin along family 1,
   * along u0: the first edge tells. The last two sides are met backwards. */
  static const lam_side order[2][4] = {{LAM_SIDE_V0, LAM_SIDE_U1, LAM_SIDE_V1, LAM_SIDE_U0},
                                       {LAM_SIDE_U0, LAM_SIDE_V1, LAM_SIDE_U1, LAM_SIDE_V0}};
  int start = corner[0], next = (start + 1) % loop->count;
  int family = family_of(net, loop->vertices[start], loop->vertices[next]);
  for (int k = 0; k < 4; k++) {
    int from = corner[k], to = corner[(k + 1) & 3];
    int count = (to - from + loop->count) % loop->count + 1;
    if (order[family][k] == side) *line = piece(arena, loop, from, count, k >= 2, family ^ (k & 1));
  }
  return true;
}

/* ---- two loops without corners ---- */

/* The vertex of the loop with the smallest index; -1: a vertex has other than three edges. */
static int lowest_vertex(const lam_net *net, const lam_polyline *loop) {
  int low = loop->vertices[0];
  for (int k = 0; k < loop->count; k++) {
    int v = loop->vertices[k];
    if (lam_net_valence(net, v) != 3) return -1;
    if (v < low) low = v;
  }
  return low;
}

/* lam_net_side on a net with two loops: the one with the smallest vertex is u0 (v0). */
static bool tube_side(lam_arena *arena, const lam_net *net, lam_side side, lam_polyline *line) {
  const lam_polyline *loops = net->loops;
  int family = family_of(net, loops[0].vertices[0], loops[0].vertices[1]), low[2];
  bool along_u = side == LAM_SIDE_V0 || side == LAM_SIDE_V1,
       last = side == LAM_SIDE_U1 || side == LAM_SIDE_V1;
  for (int l = 0; l < 2; l++) {
    low[l] = lowest_vertex(net, &loops[l]);
    if (low[l] < 0) return false;
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

/* The i-th vertex of v0, and from there j edges along the line of the other family. */
int lam_net_grid_vertex(lam_arena *arena, const lam_net *net, int i, int j) {
  lam_polyline bottom;
  if (net->loop_count != 1 || !lam_net_side(arena, net, LAM_SIDE_V0, &bottom)) return -1;
  if (i < 0 || i >= bottom.count || j < 0) return -1;

  /* up the line of the other family that begins, or ends, at the i-th vertex of v0 */
  for (int l = 0; l < net->polyline_count; l++) {
    const lam_polyline *line = &net->polylines[l];
    if (line->closed || line->family == bottom.family || j >= line->count) continue;
    if (line->vertices[0] == bottom.vertices[i]) return line->vertices[j];
    if (line->vertices[line->count - 1] == bottom.vertices[i])
      return line->vertices[line->count - 1 - j];
  }
  return -1;
}
