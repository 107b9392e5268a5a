/* Handles: their keys, and the vertices and positions that they mean on a net. Called by
 * design/parse.c (the keys' check), net/net_keys.c (the table) and net/optimize.c (resolution). */
#include "net/handles.h"
#include "core/grow.h"
#include "curve/bspline/basis.h"
#include "mesh/net_sides.h"
#include <string.h>

#include <math.h>

const lam_key lam_handle_keys[] = {
    LAM_INTEGER_KEY(
        lam_handle, "vertex", index, "[]", 0, 0,
        "One vertex: grid position [i, j], or its index, from 0 in the order of the OBJ file."),
    LAM_LENGTH_KEY(lam_handle, "at", at, "", 0, 0,
                   "Or the vertex of the start that is nearest to this point.",
                   LAM_GIVEN(lam_handle, at_given)),
    LAM_CHOICE_KEY(lam_handle, "side", side, "u0", lam_side_names,
                   "Or a whole side: u0 and u1 are where the lines of family 0 begin and end, v0 "
                   "and v1 the same for family 1.",
                   LAM_GIVEN(lam_handle, side_given)),
    LAM_LENGTH_KEY(lam_handle, "to", goal, "[]", 0, 0,
                   "Where it has to be: x, y, z. For a side the control points of a B-spline, one "
                   "after the other, from its beginning to its end; its vertices come to the same "
                   "shares of the curve's length that they have of the side's."),
    LAM_LENGTH_KEY(lam_handle, "by", by, "", 0, 0, "Or how far it moves from the start.",
                   LAM_GIVEN(lam_handle, by_given)),
    LAM_INTEGER_KEY(
        lam_handle, "degree", degree, "3", 1, 9,
        "Of the B-spline of a side, at most the number of its points less one; 1: a polyline."),
    LAM_INTEGER_KEY(lam_handle, "steps", steps, "1", 1, 1000,
                    "The handle is moved there in this many steps; the net is solved after each."),
    LAM_FLAG_KEY(
        lam_handle, "release", release, "no",
        "The handle lets go at the end, and the net comes to rest where its constraints allow."),
    {0}};

/* Made by a program, not by keys: `vertex` and `to` are meant as they are. */
static bool is_plain(const lam_handle *handle) {
  return !handle->index.count && !handle->goal.count && !handle->at_given && !handle->side_given &&
         !handle->by_given;
}

/* What is wrong with the keys of a handle (static text), or NULL. */
static const char *problem_of(const lam_handle *handle) {
  int choices = (handle->index.count > 0) + handle->at_given + handle->side_given;
  if (choices != 1)
    return choices ? "several of vertex, at and side" : "none of vertex, at and side";
  if (handle->index.count > 2) return "a vertex with more than two numbers";

  if (!handle->goal.count && !handle->by_given) return "neither to nor by";
  if (handle->goal.count && handle->by_given) return "both to and by";
  if (handle->by_given) return NULL;

  if (handle->side_given) {
    if (handle->goal.count % 3 != 0 || handle->goal.count < 6)
      return "to without x, y, z of at least two points";
  } else if (handle->goal.count != 3)
    return "to without the three numbers x, y, z";
  return NULL;
}

/* A message per wrong handle, under its number in the list. */
void lam_handles_check(const lam_net_common *common, lam_location location, lam_errors *errors) {
  for (int h = 0; h < common->handles.count; h++) {
    const char *problem = problem_of((const lam_handle *)common->handles.items + h);
    if (problem)
      lam_error_add(
          errors, location, lam_arena_printf(errors->arena, "net.handles[%d]", h),
          "given %s; expected one of vertex: [i, j], at: [x, y, z] and side: u0, with to or by",
          problem);
  }
}

/* ---- places ---- */

/* Moves count points of three numbers each. */
static void move(double *xyz, int count, lam_vec3 origin) {
  for (int i = 0; i < count; i++) {
    xyz[3 * i] -= origin.x;
    xyz[3 * i + 1] -= origin.y;
    xyz[3 * i + 2] -= origin.z;
  }
}

lam_list lam_handles_moved(lam_arena *arena, lam_list handles, lam_vec3 origin) {
  lam_handle *moved = LAM_NEW(arena, lam_handle, handles.count);
  for (int h = 0; h < handles.count; h++) {
    lam_handle *handle = &moved[h];
    *handle = ((const lam_handle *)handles.items)[h];
    double *goal = LAM_NEW(arena, double, handle->goal.count);
    if (handle->goal.count)
      memcpy(goal, handle->goal.items, (size_t)handle->goal.count * sizeof *goal);
    handle->goal.items = goal;

    move(handle->to, 1, origin);
    move(handle->at, 1, origin);
    move(goal, handle->goal.count / 3, origin);
  }
  return (lam_list){handles.count, moved};
}

/* ---- vertices ---- */

/* What the handles are resolved on, and the list of resolved ones. */
typedef struct resolver {
  lam_arena *arena;
  const lam_net_common *common;
  const lam_net *net;
  const lam_vec3 *positions; /* of the start, meters */
  lam_location location;
  lam_errors *errors;
  int count, capacity;
  lam_handle *handles;
} resolver;

/* Vertex (i, j) of a net that is closed in one or both directions and was sampled from a surface:
 * i and j count the grid's lines. -1: there is none, or the net is not of this kind. */
static int closed_grid_vertex(const resolver *r, int i, int j) {
  const lam_net *net = r->net;
  const int *grid = r->common->grid;
  lam_polyline line;
  if (r->common->from.file || r->common->from.design || (net->loop_count && net->loop_count != 2))
    return -1;

  /* A tube whose sides are v0 and v1 is closed along family 0, else along family 1; without a
   * boundary the net is closed along both. An open direction has one line more than cells. */
  bool along_u = net->loop_count && lam_net_side(r->arena, net, LAM_SIDE_V0, &line);
  bool along_v = net->loop_count && lam_net_side(r->arena, net, LAM_SIDE_U0, &line);
  if (net->loop_count && !along_u && !along_v) return -1;
  int rows = grid[0] + along_v, columns = grid[1] + along_u;

  bool inside = i >= 0 && j >= 0 && i < rows && j < columns;
  return inside && net->mesh.vertex_count == rows * columns ? i * columns + j : -1;
}

/* The vertex of the start that is nearest to x. */
static int nearest_vertex(const resolver *r, lam_vec3 x) {
  int best = 0;
  for (int v = 1; v < r->net->mesh.vertex_count; v++)
    if (lam_distance(r->positions[v], x) < lam_distance(r->positions[best], x)) best = v;
  return best;
}

/* The vertex that a handle on a single vertex means; -1, with an error, when it is not there. */
static int find_vertex(const resolver *r, const lam_handle *handle) {
  int n = r->net->mesh.vertex_count;
  if (handle->at_given)
    return nearest_vertex(r, lam_v3(handle->at[0], handle->at[1], handle->at[2]));

  /* Two numbers are a grid position, but [index, -1] is an index like a single number. */
  const int *index = handle->index.items;
  int i = is_plain(handle) ? handle->vertex[0] : index[0], v = i;
  if (!is_plain(handle) && handle->index.count == 2 && index[1] != -1) {
    v = lam_net_grid_vertex(r->arena, r->net, i, index[1]);
    if (v < 0) v = closed_grid_vertex(r, i, index[1]);
    if (v < 0) {
      lam_error_add(r->errors, r->location, "net.handles",
                    "vertex [%d, %d] does not exist; expected a position on the grid, or an index "
                    "from 0 to %d",
                    i, index[1], n - 1);
      return -1;
    }
  }

  if (v >= 0 && v < n) return v;
  lam_error_add(r->errors, r->location, "net.handles",
                "vertex %d does not exist; expected an index from 0 to %d", v, n - 1);
  return -1;
}

/* Appends a resolved handle on one vertex, with the steps and the release of the given one. to:
 * meters. A fixed boundary cannot be moved. */
static void append(resolver *r, const lam_handle *handle, int vertex, lam_vec3 to) {
  if (r->common->boundary == LAM_BOUNDARY_FIXED && r->net->boundary[vertex])
    lam_error_add(r->errors, r->location, "net.handles",
                  "vertex %d lies on the boundary, which is fixed; expected boundary: free, or an "
                  "inner vertex",
                  vertex);

  lam_handle resolved = {.vertex = {vertex, -1},
                         .to = {to.x, to.y, to.z},
                         .steps = handle->steps,
                         .release = handle->release};
  LAM_APPEND(r->arena, r->handles, r->count, r->capacity, resolved);
}

/* Resolves a handle on a single vertex. */
static void resolve_vertex(resolver *r, const lam_handle *handle) {
  int v = find_vertex(r, handle);
  if (v < 0) return;
  const double *to = is_plain(handle) ? handle->to : handle->goal.items;
  lam_vec3 by = lam_v3(handle->by[0], handle->by[1], handle->by[2]);
  append(r, handle, v,
         handle->by_given ? lam_add(r->positions[v], by) : lam_v3(to[0], to[1], to[2]));
}

/* ---- sides ---- */

/* A clamped B-spline through space over [0, 1] with its length, measured on a fine polyline. */
typedef struct curve {
  int degree, count;
  const double *points; /* count * 3 */
  double *knots;
  double *length; /* from the beginning to t = k / samples */
} curve;
enum { samples = 2000 };

/* The point at t in [0, 1]. */
static lam_vec3 curve_point(const curve *c, double t) {
  double values[LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(c->degree, c->count, c->knots, t);
  lam_vec3 x = {0, 0, 0};
  lam_basis_eval(c->degree, c->knots, span, t, 0, values);
  for (int k = 0; k <= c->degree; k++) {
    const double *p = c->points + 3 * (size_t)(span - c->degree + k);
    x = lam_along(x, values[k], lam_v3(p[0], p[1], p[2]));
  }
  return x;
}

/* The curve of the control points in `to`, of the handle's degree or as high as
 * their number allows. */
static curve make_curve(lam_arena *arena, const lam_handle *handle) {
  curve c = {.count = handle->goal.count / 3,
             .points = handle->goal.items,
             .length = LAM_NEW(arena, double, samples + 1)};
  c.degree = handle->degree < c.count ? handle->degree : c.count - 1;
  c.knots = LAM_NEW(arena, double, c.count + c.degree + 1);
  lam_knots_clamped(c.degree, c.count, c.knots);

  for (int k = 1; k <= samples; k++)
    c.length[k] = c.length[k - 1] + lam_distance(curve_point(&c, (double)(k - 1) / samples),
                                                 curve_point(&c, (double)k / samples));
  return c;
}

/* The point at a share of the curve's length. */
static lam_vec3 curve_at_share(const curve *c, double share) {
  double wanted = share * c->length[samples];
  int k = 1;
  while (k < samples && c->length[k] < wanted) k++;
  double piece = c->length[k] - c->length[k - 1],
         part = piece > 0 ? (wanted - c->length[k - 1]) / piece : 0;
  return curve_point(c, fmin(fmax((k - 1 + part) / samples, 0), 1));
}

/* The vertices of the handle's side; false, with an error, when the net has no such side or the
 * handle's curve cannot be laid along it. */
static bool find_side(const resolver *r, const lam_handle *handle, lam_polyline *line) {
  const char *name = lam_side_names[handle->side];
  if (!lam_net_side(r->arena, r->net, (lam_side)handle->side, line)) {
    lam_error_add(
        r->errors, r->location, "net.handles",
        "the net has no side %s; expected a net with four corners, or a tube with its two rims",
        name);
    return false;
  }

  if (line->closed && handle->goal.count) {
    lam_error_add(r->errors, r->location, "net.handles",
                  "side %s is closed and has no beginning for a curve; expected by", name);
    return false;
  }
  return true;
}

/* Resolves a handle on a side into one per vertex. Along a curve the vertices come to the same
 * shares of its length that they have of the side's; otherwise all move by the same vector. */
static void resolve_side(resolver *r, const lam_handle *handle) {
  lam_polyline line;
  if (!find_side(r, handle, &line)) return;

  double total = 0, before = 0;
  for (int k = 1; k < line.count; k++)
    total += lam_distance(r->positions[line.vertices[k - 1]], r->positions[line.vertices[k]]);
  curve c = {0};
  if (handle->goal.count) c = make_curve(r->arena, handle);

  for (int k = 0; k < line.count; k++) {
    lam_vec3 x = r->positions[line.vertices[k]],
             by = lam_v3(handle->by[0], handle->by[1], handle->by[2]);
    if (k) before += lam_distance(r->positions[line.vertices[k - 1]], x);
    append(r, handle, line.vertices[k],
           handle->goal.count ? curve_at_share(&c, total > 0 ? before / total : 0)
                              : lam_add(x, by));
  }
}

/* In the order of the design, a side's handles in the order of its vertices. */
lam_list lam_handles_resolve(lam_arena *arena, const lam_net_common *common, const lam_net *net,
                             const lam_vec3 *positions, lam_location location, lam_errors *errors) {
  resolver r = {.arena = arena,
                .common = common,
                .net = net,
                .positions = positions,
                .location = location,
                .errors = errors};

  for (int h = 0; h < common->handles.count; h++) {
    const lam_handle *handle = (const lam_handle *)common->handles.items + h;
    if (handle->side_given)
      resolve_side(&r, handle);
    else
      resolve_vertex(&r, handle);
  }
  return (lam_list){r.count, r.handles};
}
