/* Three developments of a strip: by its edge planes, by the angles at its points, by its
 * triangles. Called by fab/lamella/lamella_flat.c (patterns) and lamella_checks.c
 * (straightness). */
#include "fab/flat/unroll.h"
#include "core/numbers.h"

/* An edge with its plane: unit direction e, unit up in the plane and perpendicular to e, length. */
typedef struct plane {
  lam_vec3 e, up;
  double length;
} plane;

/* The plane through the edge a b that contains the direction m as nearly as it can. */
static plane edge_plane(lam_vec3 a, lam_vec3 b, lam_vec3 m) {
  plane p = {lam_unit(lam_sub(b, a)), m, lam_distance(a, b)};
  p.up = lam_unit(lam_along(m, -lam_dot(m, p.e), p.e));
  return p;
}

/* An angle moved into (-pi, pi]; it is at most one turn outside. */
static double wrapped(double angle) {
  return angle > LAM_PI ? angle - 2 * LAM_PI : angle <= -LAM_PI ? angle + 2 * LAM_PI : angle;
}

/* The ruling r = n1 x n2 of neighboring planes (n = e x up) is at angle phi1 to the edge before it
 * and at phi2 to the edge after it, each in its own plane. In the development both angles stay: the
 * heading turns by phi1 - phi2. Planes that coincide meet in any line; m is taken then. */
static double turn(plane before, plane after, lam_vec3 m) {
  lam_vec3 r = lam_cross(lam_cross(before.e, before.up), lam_cross(after.e, after.up));
  if (lam_length(r) < 1e-12) r = m;
  return wrapped(atan2(lam_dot(r, before.up), lam_dot(r, before.e)) -
                 atan2(lam_dot(r, after.up), lam_dot(r, after.e)));
}

/* The point at the distance `length` in the direction `heading` (an angle from the x axis). */
static lam_vec2 ahead(lam_vec2 from, double heading, double length) {
  return (lam_vec2){from.x + length * cos(heading), from.y + length * sin(heading)};
}

/* Edge by edge: lengths are kept, and the heading turns at every ruling (see turn). */
void lam_unroll(const lam_vec3 *points, const lam_vec3 *m, int n, lam_vec2 *flat) {
  double heading = 0;
  plane before = {0};
  flat[0] = (lam_vec2){0, 0};

  for (int i = 0; i + 1 < n; i++) {
    plane p = edge_plane(points[i], points[i + 1], lam_unit(lam_add(m[i], m[i + 1])));
    if (i > 0) heading += turn(before, p, m[i]);
    flat[i + 1] = ahead(flat[i], heading, p.length);
    before = p;
  }
}

/* Edge by edge: lengths are kept, and the heading turns by what the two angles to m lack of pi. */
void lam_unroll_angles(const lam_vec3 *points, const lam_vec3 *m, int n, lam_vec2 *flat) {
  double heading = 0;
  flat[0] = (lam_vec2){0, 0};

  for (int i = 0; i + 1 < n; i++) {
    lam_vec3 edge = lam_sub(points[i + 1], points[i]);
    if (i > 0)
      heading +=
          LAM_PI - lam_angle(lam_sub(points[i - 1], points[i]), m[i]) - lam_angle(edge, m[i]);
    flat[i + 1] = ahead(flat[i], heading, lam_length(edge));
  }
}

/* The corner at distances p from a and q from b, to the left (side = 1) or right (side = -1) of
 * a -> b. Triangles that do not close are laid straight. */
static lam_vec2 corner(lam_vec2 a, lam_vec2 b, double p, double q, double side) {
  double dx = b.x - a.x, dy = b.y - a.y, c = hypot(dx, dy);
  double along = (p * p - q * q + c * c) / (2 * c), square = p * p - along * along;
  double across = side * sqrt(square > 0 ? square : 0);
  return (lam_vec2){a.x + (along * dx - across * dy) / c, a.y + (along * dy + across * dx) / c};
}

/* a and b are the lower and upper end of the last section in the plane: the next upper end
 * follows from the diagonal and the upper edge, the next lower end from the section and the
 * lower edge. */
void lam_unroll_triangles(const lam_vec3 *points, const lam_vec3 *m, double height, int n,
                          lam_vec2 *flat) {
  lam_vec3 low = lam_along(points[0], -height / 2, m[0]),
           high = lam_along(points[0], height / 2, m[0]);
  lam_vec2 a = {0, -height / 2}, b = {0, height / 2};
  flat[0] = (lam_vec2){0, 0};

  for (int i = 1; i < n; i++) {
    lam_vec3 low2 = lam_along(points[i], -height / 2, m[i]),
             high2 = lam_along(points[i], height / 2, m[i]);

    lam_vec2 b2 = corner(a, b, lam_distance(low, high2), lam_distance(high, high2), -1);
    lam_vec2 a2 = corner(a, b2, lam_distance(low, low2), lam_distance(high2, low2), -1);

    flat[i] = (lam_vec2){(a2.x + b2.x) / 2, (a2.y + b2.y) / 2};
    a = a2, b = b2, low = low2, high = high2;
  }
}

/* Distances are measured from the line through both ends; where these coincide, from that point. */
double lam_straightness(const lam_vec2 *flat, int n) {
  double length = 0, most = 0;
  double dx = flat[n - 1].x - flat[0].x, dy = flat[n - 1].y - flat[0].y, chord = hypot(dx, dy);

  for (int i = 1; i < n; i++) length += hypot(flat[i].x - flat[i - 1].x, flat[i].y - flat[i - 1].y);
  for (int i = 0; i < n; i++) {
    double x = flat[i].x - flat[0].x, y = flat[i].y - flat[0].y;
    double distance = chord > 0 ? fabs(x * dy - y * dx) / chord : hypot(x, y);
    if (distance > most) most = distance;
  }

  return length > 0 ? most / length : 0;
}
