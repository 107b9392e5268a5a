/* What kinds of surfaces share: domains, jets of revolution, units of listed points. For the
 * files of surf/ only. */
#ifndef LAM_SURF_SURFACE_KIND_H
#define LAM_SURF_SURFACE_KIND_H

#include "surf/surface.h"

/* A rectangle of chart parameters. */
typedef struct lam_domain {
  double p[2], q[2];
  bool closed[2];
} lam_domain;

/* Hands a domain out through the arguments of lam_surface_kind.domain; returns true. */
static inline bool lam_domain_give(lam_domain domain, double p[2], double q[2], bool closed[2]) {
  for (int i = 0; i < 2; i++) {
    p[i] = domain.p[i];
    q[i] = domain.q[i];
    closed[i] = domain.closed[i];
  }
  return true;
}

/* The lam_surface_kind.locate of kinds whose charts all have the natural parameters. */
static inline void lam_locate_natural(const void *data, lam_chart chart, int sector, double p,
                                      double q, double *u, double *v) {
  (void)data;
  (void)chart;
  (void)sector;
  *u = p;
  *v = q;
}

/* The diagonals of a grid, u = p - q and v = p + q: a turn by 45 degrees, which keeps the
 * orientation. */
static inline void lam_diagonal(double p, double q, double *u, double *v) {
  *u = p - q;
  *v = p + q;
}

/* A point of a meridian with first and second derivatives: distance from the axis and height. */
typedef struct lam_meridian {
  double r, z, dr, dz, ddr, ddz;
} lam_meridian;

/* The surface of revolution x = (r(v) cos u, r(v) sin u, z(v)). Its normal x_u x x_v =
 * r (z' cos u, z' sin u, -r') points outward where the meridian rises. F = M = 0: the parameter
 * lines are curvature lines. */
static inline void lam_jet_revolve(lam_meridian m, double u, lam_jet *jet) {
  double c = cos(u), s = sin(u);
  jet->x = lam_v3(m.r * c, m.r * s, m.z);
  jet->u = lam_v3(-m.r * s, m.r * c, 0);
  jet->v = lam_v3(m.dr * c, m.dr * s, m.dz);
  jet->uu = lam_v3(-m.r * c, -m.r * s, 0);
  jet->uv = lam_v3(-m.dr * s, m.dr * c, 0);
  jet->vv = lam_v3(m.ddr * c, m.ddr * s, m.ddz);
}

/* Names of the units in which control points may be listed. */
static const char *const lam_point_units[] = {"m", "cm", "mm", NULL};

/* The length in meters of a unit: an index of lam_point_units. */
static inline double lam_point_unit(int choice) {
  static const double meters[] = {1, 0.01, 0.001};
  return meters[choice];
}

#endif
