/* Jacobi's elliptic functions of real argument for a fixed parameter m, accurate to rounding.
 * Used by surf/kinds/delaunay.c and scherk.c. */
#ifndef LAM_SURF_ELLIPTIC_H
#define LAM_SURF_ELLIPTIC_H

enum { LAM_ELLIPTIC_LEVELS = 16 };

/* What depends on m alone. */
typedef struct lam_elliptic {
  double complement; /* 1 - m */
  double quarter;    /* K, the complete integral of the first kind: a quarter period */
  double slope;      /* E / K, mean of dn^2 */
  int levels;
  /* The arithmetic-geometric means a_n and the half differences c_n, n <= levels. */
  double a[LAM_ELLIPTIC_LEVELS], c[LAM_ELLIPTIC_LEVELS];
} lam_elliptic;

/* complement = 1 - m in (0, 1]: given instead of m so that nothing is lost as m nears 1. */
lam_elliptic lam_elliptic_make(double complement);

/* sn, cn and dn at x, and the integral of dn^2 from 0 to x, which is the incomplete integral of
 * the second kind at am(x). */
typedef struct lam_jacobi {
  double sn, cn, dn;
  double epsilon; /* the integral */
} lam_jacobi;

/* Any real x. Pure. */
lam_jacobi lam_jacobi_eval(const lam_elliptic *elliptic, double x);

#endif
