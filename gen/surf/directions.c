/* Principal and asymptotic directions and Darboux frames (do Carmo, Differential Geometry of
 * Curves and Surfaces, 3-2, 3-3 and 4-4). Part of the surface kernel; called by the unit tests.
 * In the orthonormal basis e1 = x_u / |x_u|, e2 = n x e1 of the tangent plane the second form
 * is (a, b; b, c); see surf/surface_curvature.c. */
#include "surf/directions.h"

/* The basis e1, e2 and the second form in it. */
typedef struct lam_plane {
  lam_vec3 e[2];
  double a, b, c;
} lam_plane;

/* x_u = |x_u| e1, x_v = f e1 + g e2; a, b, c follow from L, M, N by substitution. */
static lam_plane tangent_plane(const lam_jet *jet, const lam_curvature *k) {
  double length = sqrt(k->E), f = k->F / length, g = sqrt(k->E * k->G - k->F * k->F) / length;

  lam_plane plane = {.a = k->L / k->E};
  plane.e[0] = lam_unit(jet->u);
  plane.e[1] = lam_cross(k->normal, plane.e[0]);
  plane.b = (k->M / length - f * plane.a) / g;
  plane.c = (k->N - f * (f * plane.a + 2 * g * plane.b)) / (g * g);
  return plane;
}

/* (du, dv) of a tangent vector: the first form is inverted. */
static lam_vec2 parameters_of(const lam_jet *jet, const lam_curvature *k, lam_vec3 tangent) {
  double p = lam_dot(tangent, jet->u), q = lam_dot(tangent, jet->v),
         area = k->E * k->G - k->F * k->F;
  return (lam_vec2){(k->G * p - k->F * q) / area, (k->E * q - k->F * p) / area};
}

/* The unit tangent vector at an angle from e1. */
static lam_vec3 turned(const lam_plane *plane, double angle) {
  return lam_along(lam_scale(plane->e[0], cos(angle)), sin(angle), plane->e[1]);
}

/* Euler: k(angle) = H + r cos 2(angle - first), with r cos 2 first = (a - c)/2 and
 * r sin 2 first = b; `first` is the angle of the direction of k1. */
lam_directions lam_jet_directions(const lam_jet *jet) {
  lam_curvature k = lam_jet_curvature(jet);
  lam_directions d = {0};
  if (isnan(k.K)) return d;

  lam_plane plane = tangent_plane(jet, &k);
  double half = (plane.a - plane.c) / 2,
         first = half != 0 || plane.b != 0 ? atan2(plane.b, half) / 2 : 0;

  for (int i = 0; i < 2; i++) {
    d.principal[i] = turned(&plane, first + i * M_PI_2);
    d.principal_uv[i] = parameters_of(jet, &k, d.principal[i]);
  }

  /* Seen from the first principal direction, k1 cos^2 + k2 sin^2 = 0. */
  bool flat = k.k1 == 0 && k.k2 == 0;
  if (flat || k.k1 < 0 || k.k2 > 0) return d;
  double away = atan2(sqrt(k.k1), sqrt(-k.k2));
  d.asymptotic_count = k.k1 == 0 || k.k2 == 0 ? 1 : 2;

  for (int i = 0; i < 2; i++) {
    d.asymptotic[i] = turned(&plane, i ? first - away : first + away);
    d.asymptotic_uv[i] = parameters_of(jet, &k, d.asymptotic[i]);
  }
  return d;
}

/* The curvatures are II(t,t), <x'', s> / |x'|^2 and II(t,s), with x'' by the chain rule. */
lam_darboux lam_jet_darboux(const lam_jet *jet, lam_vec2 first, lam_vec2 second) {
  lam_curvature k = lam_jet_curvature(jet);
  lam_vec3 velocity = lam_along(lam_scale(jet->u, first.x), first.y, jet->v);
  double speed = lam_length(velocity);
  lam_darboux d = {.normal_curvature = NAN, .geodesic_curvature = NAN, .geodesic_torsion = NAN};
  if (isnan(k.K) || !(speed > 0)) return d;

  d.normal = k.normal;
  d.tangent = lam_scale(velocity, 1 / speed);
  d.side = lam_cross(d.normal, d.tangent);

  /* x'' = x_u u'' + x_v v'' + x_uu u'^2 + 2 x_uv u'v' + x_vv v'^2. */
  lam_vec3 acceleration = lam_along(lam_scale(jet->u, second.x), second.y, jet->v);
  acceleration = lam_along(acceleration, first.x * first.x, jet->uu);
  acceleration = lam_along(lam_along(acceleration, 2 * first.x * first.y, jet->uv),
                           first.y * first.y, jet->vv);

  lam_plane plane = tangent_plane(jet, &k);
  double x = lam_dot(d.tangent, plane.e[0]), y = lam_dot(d.tangent, plane.e[1]);

  d.normal_curvature = plane.a * x * x + 2 * plane.b * x * y + plane.c * y * y;
  d.geodesic_curvature = lam_dot(acceleration, d.side) / (speed * speed);
  d.geodesic_torsion =
      -plane.a * x * y + plane.b * (x * x - y * y) + plane.c * x * y; /* II(tangent, side) */
  return d;
}
