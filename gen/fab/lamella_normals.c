/* Normals at the boundary. The one-ring of a boundary vertex lies to one side of it, so a normal from the ring is that
 * of a point about half an edge inside. Continuing the normals of the vertices inside, along the polylines that end
 * there, is accurate to the third order in the edge length: N = 3 N1 - 3 N2 + N3, or 2 N1 - N2 on short polylines.
 * Where all edges of the ring lie in one plane its normal is kept: at corners, and on surfaces that are ruled along the
 * boundary. */
#include "fab/lamella_make.h"

static const double planar = 1e-9;
static const double largest_change = 0.26; /* 15 degrees: a net so rough keeps the normals of its rings */

/* The vertex after from -> at, straight on through a regular star; -1: none. */
static int next_on_line(const lam_net *net, int from, int at) {
  const int *ring = net->ring + net->ring_start[at];
  if (net->boundary[at] || net->ring_start[at + 1] - net->ring_start[at] != 4) return -1;
  int k = 0;
  while (ring[k] != from) k++;
  return ring[(k + 2) & 3];
}

/* The continuation to v of the normals at w and the vertices after it inside. False when there are not two of them. */
static bool continued(const lam_net *net, const lam_vec3 *normals, int v, int w, lam_vec3 *normal) {
  int at[3], count = 0, from = v;
  while (count < 3 && w >= 0 && !net->boundary[w]) {
    at[count++] = w;
    int next = next_on_line(net, from, w);
    from = w, w = next;
  }
  if (count < 2) return false;
  *normal = lam_sub(lam_scale(normals[at[0]], 2), normals[at[1]]);
  if (count == 3) *normal = lam_add(lam_scale(lam_sub(normals[at[0]], normals[at[1]]), 3), normals[at[2]]);
  return true;
}

/* The mean of the continuations along the inner edges of v. */
static lam_vec3 improved(const lam_net *net, const lam_vec3 *normals, int v) {
  const lam_vec3 *x = net->mesh.vertices;
  lam_vec3 sum = {0, 0, 0}, normal;
  double tilt = 0;
  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
    tilt = fmax(tilt, fabs(lam_dot(lam_unit(lam_sub(x[net->ring[i]], x[v])), normals[v])));
    if (continued(net, normals, v, net->ring[i], &normal)) sum = lam_add(sum, normal);
  }
  bool usable = tilt > planar && lam_length(sum) > 0 && lam_angle(sum, normals[v]) < largest_change;
  return usable ? lam_unit(sum) : normals[v];
}

lam_vec3 *lam_lamella_normals(lam_arena *arena, const lam_net *net, const lam_vec3 *normals) {
  int n = net->mesh.vertex_count;
  lam_vec3 *better = LAM_NEW(arena, lam_vec3, n);
  for (int v = 0; v < n; v++) better[v] = net->boundary[v] ? improved(net, normals, v) : normals[v];
  return better;
}
