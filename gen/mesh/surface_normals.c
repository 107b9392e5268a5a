/* Normals of nets without the bias of one-sided stars on the border: a normal from the edges of a
 * border vertex alone leans inward by half an edge's turn, and strips along the border would be
 * cut several per cent off their radius. Called by design/net_stage.c. */
#include "mesh/surface_normals.h"

/* What is known while normals are carried to the border. */
typedef struct carrier {
  const lam_net *net;
  const lam_vec3 *x;
  lam_vec3 *normals, *sum; /* per vertex; sum: of the normals carried there */
  bool *kept;              /* per vertex: it has its normal, and takes no other */
} carrier;

/* ---- inside ---- */

/* A vertex with four edges that lines run through: inside, or in a reentrant corner. */
static bool is_whole(const lam_net *net, int v) {
  return net->star_of_vertex[v] >= 0 || (net->boundary[v] && lam_net_valence(net, v) == 4);
}

/* Square to the circles through such a vertex and its neighbors: their tangents are
 * E1 |E3|^2 - E3 |E1|^2. otherwise: what is taken when these are parallel. */
static lam_vec3 star_normal(const lam_net *net, const lam_vec3 *x, int v, lam_vec3 otherwise) {
  const int *ring = net->ring + net->ring_start[v];
  lam_vec3 t[2];
  for (int f = 0; f < 2; f++) {
    lam_vec3 on = lam_sub(x[ring[f]], x[v]), back = lam_sub(x[ring[f + 2]], x[v]);
    t[f] = lam_unit(lam_along(lam_scale(on, lam_dot(back, back)), -lam_dot(on, on), back));
  }
  lam_vec3 square = lam_cross(t[0], t[1]);
  return lam_length(square) > 1e-3 ? lam_unit(square) : otherwise;
}

/* ---- the border ---- */

/* Whether a vertex with four edges has them square to its normal. Sines; solved nets hold 1e-8. */
static bool has_planar_star(const carrier *c, int v) {
  if (!is_whole(c->net, v)) return false;
  for (int k = 0; k < 4; k++) {
    lam_vec3 e = lam_unit(lam_sub(c->x[c->net->ring[c->net->ring_start[v] + k]], c->x[v]));
    if (fabs(lam_dot(e, c->normals[v])) > 1e-5) return false;
  }
  return true;
}

/* Whether a border vertex belongs to a net of planar stars: the vertex beside it has one, and its
 * own three edges lie in one plane, be it that those along the border leave it open. */
static bool has_planar_edges(const carrier *c, int v) {
  const int *ring = c->net->ring + c->net->ring_start[v];
  if (!c->net->boundary[v] || lam_net_valence(c->net, v) != 3 || !has_planar_star(c, ring[1]))
    return false;
  lam_vec3 e[3];
  for (int k = 0; k < 3; k++) e[k] = lam_unit(lam_sub(c->x[ring[k]], c->x[v]));
  lam_vec3 plane = lam_cross(e[0], e[2]);
  return lam_length(plane) < 1e-3 || fabs(lam_dot(lam_unit(plane), e[1])) < 1e-5;
}

/* A frame of a line: the unit tangent t (the bisector of the edges), n square to it along the
 * normal, and t x n. */
typedef struct frame {
  lam_vec3 axis[3];
} frame;

static frame frame_at(lam_vec3 before, lam_vec3 here, lam_vec3 after, lam_vec3 normal) {
  lam_vec3 t = lam_unit(lam_add(lam_unit(lam_sub(here, before)), lam_unit(lam_sub(after, here))));
  lam_vec3 n = lam_unit(lam_along(normal, -lam_dot(normal, t), t));
  return (frame){{t, n, lam_cross(t, n)}};
}

/* The components of v in the frame, and back. */
static lam_vec3 into(const frame *f, lam_vec3 v) {
  return lam_v3(lam_dot(f->axis[0], v), lam_dot(f->axis[1], v), lam_dot(f->axis[2], v));
}
static lam_vec3 out_of(const frame *f, lam_vec3 v) {
  return lam_along(lam_along(lam_scale(f->axis[0], v.x), v.y, f->axis[1]), v.z, f->axis[2]);
}

/* The normal at the end p[0] of a line of `count` vertices p, from the normals n[1], n[2], n[3].
 * With frames F1, F2, F3 as matrices, the turn from one vertex to the one before it is, as seen
 * from the frames, F2^T F1 and F3^T F2; it goes on as it changes:
 *   n0 = F1 B F1^T n1,  B = (F2^T F1) (F3^T F2)^T (F2^T F1).
 * With four vertices it stays, n0 = F1 F2^T n1. With three n1 is reflected in the plane that halves
 * the edge, which is right on circles. */
static lam_vec3 carried(int count, const lam_vec3 p[5], const lam_vec3 n[4]) {
  if (count == 3) {
    lam_vec3 e = lam_unit(lam_sub(p[1], p[0]));
    return lam_along(n[1], -2 * lam_dot(n[1], e), e);
  }

  frame f1 = frame_at(p[0], p[1], p[2], n[1]), f2 = frame_at(p[1], p[2], p[3], n[2]);
  if (count == 4) return out_of(&f1, into(&f2, n[1]));

  frame f3 = frame_at(p[2], p[3], p[4], n[3]);
  lam_vec3 v = into(&f1, n[1]);
  v = into(&f2, out_of(&f1, v));
  v = into(&f2, out_of(&f3, v)); /* (F3^T F2)^T */
  v = into(&f2, out_of(&f1, v));
  return lam_unit(out_of(&f1, v));
}

/* Adds what a line carries to its ends. along: lines along the border carry, to corners that
 * nothing else has reached; otherwise those that come from inside. What is far from the one-sided
 * normal is no continuation, and not taken. */
static void carry(carrier *c, const lam_polyline *line, bool along) {
  for (int end = 0; end < 2 && !line->closed && line->count > 2; end++) {
    lam_vec3 p[5], n[4];
    const int *v = line->vertices;
    int first = end ? line->count - 1 : 0, step = end ? -1 : 1, w = v[first],
        next = v[first + step];
    bool inside = !c->net->boundary[next] || is_whole(c->net, next);
    if (!c->net->boundary[w] || is_whole(c->net, w) || c->kept[w] || inside == along) continue;

    for (int k = 0; k < 5 && k < line->count; k++) {
      p[k] = c->x[v[first + k * step]];
      if (k < 4) n[k] = c->normals[v[first + k * step]];
    }
    lam_vec3 found = carried(line->count, p, n);
    if (lam_dot(found, n[0]) > 0.7) c->sum[w] = lam_add(c->sum[w], found);
  }
}

/* A corner keeps the plane of its two edges where the vertices beside it have planar stars. */
static void keep_corners(carrier *c) {
  for (int v = 0; v < c->net->mesh.vertex_count; v++) {
    const int *ring = c->net->ring + c->net->ring_start[v];
    if (!c->net->boundary[v] || lam_net_valence(c->net, v) != 2) continue;
    c->kept[v] = true;
    for (int k = 0; k < 2; k++)
      c->kept[v] = c->kept[v] && (c->kept[ring[k]] || has_planar_star(c, ring[k]));
  }
}

/* Takes over what was carried; who has that is done. */
static void settle(carrier *c) {
  for (int v = 0; v < c->net->mesh.vertex_count; v++) {
    if (!(lam_length(c->sum[v]) > 0)) continue;
    c->normals[v] = lam_unit(c->sum[v]);
    c->sum[v] = lam_v3(0, 0, 0);
    c->kept[v] = true;
  }
}

/* Inside first; from there to the border, and along it to the corners. */
void lam_surface_normals(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                         lam_vec3 *normals) {
  int count = net->mesh.vertex_count;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  carrier c = {net, positions, normals, LAM_NEW(arena, lam_vec3, count),
               LAM_NEW(arena, bool, count)};

  lam_net_normals(net, positions, normals);
  for (int v = 0; v < count; v++)
    if (is_whole(net, v)) normals[v] = star_normal(net, positions, v, normals[v]);
  for (int v = 0; v < count; v++) c.kept[v] = has_planar_edges(&c, v);
  keep_corners(&c);

  for (int pass = 0; pass < 2; pass++) {
    for (int i = 0; i < net->polyline_count; i++) carry(&c, &net->polylines[i], pass == 1);
    settle(&c);
  }
  lam_arena_release(arena, mark);
}
