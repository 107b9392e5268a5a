/* Elements that several constraints are put on: stars, half stars, faces, sides of the boundary.
 * The constraints of this folder and of con/thesis call these functions. */
#include "con/constraint.h"

/* Per vertex: the family of the edge to its first neighbor. */
static int *first_families(lam_arena *arena, const lam_net *net) {
  int *family = LAM_NEW(arena, int, net->mesh.vertex_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      int v = net->edges[e].vertex[k];
      if (net->ring[net->ring_start[v]] == net->edges[e].vertex[1 - k])
        family[v] = net->edges[e].family;
    }
  return family;
}

/* Appends the reentrant corners of the boundary to a list of count stars; returns the new count. A
 * corner's four edges are turned so that the first one belongs to family 0. */
static int append_reentrant(const lam_scope *scope, int *list, int count) {
  const lam_net *net = scope->net;
  const int *family = first_families(scope->problem->arena, net);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (!net->boundary[v] || lam_net_valence(net, v) != 4) continue;
    list[5 * count] = v;
    for (int k = 0; k < 4; k++)
      list[5 * count + 1 + k] = net->ring[net->ring_start[v] + ((k + 3 * family[v]) & 3)];
    count++;
  }
  return count;
}

/* The inner stars come first, in the net's order. */
int lam_scope_stars(lam_scope *scope, bool border, const int **nodes) {
  const lam_net *net = scope->net;
  int *list = LAM_NEW(scope->problem->arena, int, 5 * net->mesh.vertex_count);
  for (int s = 0; s < net->star_count; s++) {
    list[5 * s] = net->stars[s].center;
    for (int k = 0; k < 4; k++) list[5 * s + 1 + k] = net->stars[s].neighbor[k];
  }
  scope->skipped += net->irregular_count;
  *nodes = list;
  return border ? append_reentrant(scope, list, net->star_count) : net->star_count;
}

/* The ring of such a vertex has three neighbors: border, inner, border. */
int lam_scope_half_stars(lam_scope *scope, const int **nodes) {
  const lam_net *net = scope->net;
  int count = 0, *list = LAM_NEW(scope->problem->arena, int, 4 * net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (!net->boundary[v] || lam_net_valence(net, v) != 3) continue;
    list[4 * count] = v;
    for (int k = 0; k < 3; k++) list[4 * count + 1 + k] = net->ring[net->ring_start[v] + k];
    count++;
  }
  *nodes = list;
  return count;
}

/* ---- sides of the boundary ---- */

static bool is_corner(const lam_net *net, int v) { return lam_net_valence(net, v) == 2; }

/* The position of the first corner in the loop at or after `from`; count: there is none. */
static int next_corner(const lam_net *net, const lam_polyline *loop, int from) {
  while (from < loop->count && !is_corner(net, loop->vertices[from])) from++;
  return from;
}

/* The side of the loop from the corner at position `from` to the next corner, both included; where
 * it is the only corner the side comes back to it. */
static lam_polyline side_from(lam_arena *arena, const lam_net *net, const lam_polyline *loop,
                              int from) {
  int n = loop->count, length = 1;
  while (length < n && !is_corner(net, loop->vertices[(from + length) % n])) length++;
  lam_polyline side = {-1, false, length + 1, LAM_NEW(arena, int, length + 1)};
  for (int i = 0; i <= length; i++) side.vertices[i] = loop->vertices[(from + i) % n];
  return side;
}

/* A loop with corners has as many sides as corners. */
int lam_scope_sides(lam_scope *scope, const lam_polyline **sides) {
  const lam_net *net = scope->net;
  int most = 0, count = 0;
  for (int l = 0; l < net->loop_count; l++) most += net->loops[l].count;
  lam_polyline *list = LAM_NEW(scope->problem->arena, lam_polyline, most);

  for (int l = 0; l < net->loop_count; l++) {
    const lam_polyline *loop = &net->loops[l];
    int corner = next_corner(net, loop, 0);
    if (corner == loop->count) list[count++] = *loop;
    for (; corner < loop->count; corner = next_corner(net, loop, corner + 1))
      list[count++] = side_from(scope->problem->arena, net, loop, corner);
  }
  *sides = list;
  return count;
}

/* ---- blocks ---- */

/* Nothing is added on a net without such stars. */
void lam_star_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        bool border, double weight) {
  lam_block block = {.name = name, .kernel = kernel, .rows = rows, .weight = weight, .arity = 5};
  block.count = lam_scope_stars(scope, border, &block.nodes);
  lam_problem_add(scope->problem, block);
}

/* The nodes are the mesh's own table of corners. */
void lam_face_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        double weight) {
  lam_block block = {.name = name, .kernel = kernel, .rows = rows, .weight = weight, .arity = 4};
  block.count = scope->net->mesh.face_count;
  block.nodes = scope->net->mesh.faces[0];
  lam_problem_add(scope->problem, block);
}

const lam_key lam_star_keys[] = {LAM_FLAG_KEY(lam_star_params, "border", border, "no",
                                              "Vertices of the border take part: half stars, and "
                                              "reentrant corners, which have four edges."),
                                 {0}};
