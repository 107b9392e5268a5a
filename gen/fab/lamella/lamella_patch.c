/* The surface around a vertex of the net to second order, and what stations on sheets beside its
 * polylines follow from it. Called by lamella_grid.c; lam_station_extent by all that needs the
 * size of a slot. */
#include "fab/lamella/lamella_patch.h"
#include "core/numbers.h"

/* The header has the formula: x at both ends of the turn, relative to where it is now. */
lam_slot_range lam_slot_sweep(double d, double e, double angle, double scissor) {
  double least = angle, most = angle;
  if (scissor > 0) least = fmin(angle, scissor), most = fmax(angle, LAM_PI - scissor);

  double here = (d * cos(angle) - e) / sin(angle);
  double a = (d * cos(least) - e) / sin(least) - here, b = (d * cos(most) - e) / sin(most) - here;
  return (lam_slot_range){fmin(fmin(a, b), 0), fmax(fmax(a, b), 0), fmin(least, LAM_PI - most)};
}

/* The range of the partner's middle line, and half a slot's width on both sides. */
void lam_station_extent(const lam_lamella_grid *grid, const lam_station *q, double *low,
                        double *high) {
  *low = *high = 0;
  if (q->partner < 0) return;
  double half = lam_slot_width(grid->thickness, grid->clearance, q->slot_angle) / 2;
  *low = q->slot_low - half;
  *high = q->slot_high + half;
}

/* The vertices before and after number i of a line; -1 beyond an end. */
static void around(const lam_polyline *line, int i, int side[2]) {
  int n = line->count;
  side[0] = i > 0 ? line->vertices[i - 1] : line->closed ? line->vertices[n - 1] : -1;
  side[1] = i + 1 < n ? line->vertices[i + 1] : line->closed ? line->vertices[0] : -1;
}

/* The unit direction of travel at number i of a line: the bisector of the unit edges. At an end,
 * the neighbor's tangent mirrored in the edge: the tangent of the arc through the end with the
 * neighbor's tangent. */
static lam_vec3 tangent(const lam_vec3 *at, const lam_polyline *line, int i) {
  int side[2], v = line->vertices[i];
  around(line, i, side);
  lam_vec3 back = {0, 0, 0}, on = {0, 0, 0};
  if (side[0] >= 0) back = lam_unit(lam_sub(at[v], at[side[0]]));
  if (side[1] >= 0) on = lam_unit(lam_sub(at[side[1]], at[v]));
  if (side[0] >= 0 && side[1] >= 0) return lam_unit(lam_add(back, on));

  lam_vec3 edge = lam_add(back, on);
  if (line->count < 3) return edge;
  lam_vec3 next = tangent(at, line, i == 0 ? 1 : i - 1);
  return lam_unit(lam_along(lam_scale(next, -1), 2 * lam_dot(next, edge), edge));
}

/* The derivative of the normals along a line at its number i, per meter: a difference between the
 * vertices on both sides, or with the vertex itself at an end. */
static lam_vec3 normal_change(const lam_vec3 *at, const lam_vec3 *normals, const lam_polyline *line,
                              int i) {
  int side[2], v = line->vertices[i];
  around(line, i, side);

  int before = side[0] >= 0 ? side[0] : v, after = side[1] >= 0 ? side[1] : v;
  double length = lam_distance(at[before], at[v]) + lam_distance(at[v], at[after]);
  return lam_scale(lam_sub(normals[after], normals[before]), length > 0 ? 1 / length : 0);
}

/* Tangents are made perpendicular to the normal. Below a sine of .02 two tangents are no use as
 * axes: the one of `family` stays, and the other is turned square to it. */
lam_patch lam_patch_make(const lam_net *net, const lam_vec3 *normals, int v,
                         const lam_polyline *const line[2], const int index[2], int family) {
  const lam_vec3 *at = net->mesh.vertices;
  lam_patch p = {.x = at[v], .n = normals[v]};
  for (int f = 0; f < 2; f++) {
    if (!line[f]) continue;
    lam_vec3 t = tangent(at, line[f], index[f]);
    p.t[f] = lam_unit(lam_along(t, -lam_dot(t, p.n), p.n));
    p.dn[f] = normal_change(at, normals, line[f], index[f]);
  }

  p.angle = line[0] && line[1] ? lam_angle(p.t[0], p.t[1]) : LAM_PI / 2;
  bool skew = sin(p.angle) < 0.02;
  if (!line[0] || (skew && family == 1)) p.t[0] = lam_cross(p.t[1], p.n);
  if (!line[1] || (skew && family == 0)) p.t[1] = lam_cross(p.n, p.t[0]);

  p.sine = lam_dot(lam_cross(p.t[0], p.t[1]), p.n);
  p.cosine = lam_dot(p.t[0], p.t[1]);
  return p;
}

/* h_ij of the patch, symmetric in i and j. */
static double form(const lam_patch *p, int i, int j) {
  return -(lam_dot(p->dn[i], p->t[j]) + lam_dot(p->dn[j], p->t[i])) / 2;
}

/* The station of a sheet of the family at the coordinates A = a, B = b of the patch: the surface,
 * its normal, and the tangent of the polyline made perpendicular to it. */
static lam_station station_on(const lam_patch *p, double a, double b, int family) {
  double rise = (form(p, 0, 0) * a * a + 2 * form(p, 0, 1) * a * b + form(p, 1, 1) * b * b) / 2;
  lam_station q = {.partner = -1, .crossing = -1};
  q.x = lam_along(lam_along(lam_along(p->x, a, p->t[0]), b, p->t[1]), rise, p->n);
  q.m = lam_unit(lam_along(lam_along(p->n, a, p->dn[0]), b, p->dn[1]));
  q.t = lam_unit(lam_along(p->t[family], -lam_dot(p->t[family], q.m), q.m));
  return q;
}

/* A sheet of family 0 has B = own / sin, one of family 1 has A = -own / sin; the foot of the
 * perpendicular gives the other coordinate. */
lam_station lam_patch_station(const lam_patch *p, int family, double own) {
  double a = family == 0 ? -own * p->cosine / p->sine : -own / p->sine;
  double b = family == 0 ? own / p->sine : own * p->cosine / p->sine;
  return station_on(p, a, b, family);
}

/* Both distances hold: B = (distance in family 0) / sin, A = -(distance in family 1) / sin. The
 * angle is the one on the surface there, between the tangents of both families. The range of the
 * slot is given in the direction of travel of the sheet. */
lam_station lam_patch_crossing(const lam_patch *p, int family, double own, double other,
                               double scissor) {
  double first = family == 0 ? own : other, second = family == 0 ? other : own;
  double a = -second / p->sine, b = first / p->sine;

  lam_station q = station_on(p, a, b, family);
  q.angle = lam_angle(station_on(p, a, b, 0).t, station_on(p, a, b, 1).t);
  lam_slot_range r = lam_slot_sweep(own, other, q.angle, scissor);

  bool forward = (family == 0) == (p->sine > 0); /* otherwise x runs against t */
  q.slot_low = forward ? r.low : -r.high;
  q.slot_high = forward ? r.high : -r.low;
  q.slot_angle = r.smallest;
  return q;
}
