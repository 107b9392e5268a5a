/* Smooth surfaces x(u,v): evaluating those of the library, and adding one's own. */
#ifndef LAMELLA_SURFACE_H
#define LAMELLA_SURFACE_H

#include <lamella/session.h>

LAM_BEGIN_DECLS

/* A point with derivatives up to the second. */
typedef struct lam_jet {
  lam_vec3 x, u, v, uu, uv, vv;
} lam_jet;

typedef struct lam_surface lam_surface;

/* A surface from what stands after `surface:` in a design: "{kind: enneper, order: 2}"; a file that
 * it names is read. Its keys of placement (u, v, size, rotate, ...) are checked, not applied.
 * LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY. */
LAM_API lam_status lam_surface_read(lam_session *session, const char *keys,
                                    const lam_surface **surface);
/* The rectangle of its natural parameters: low and high of u, of v. */
LAM_API void lam_surface_domain(const lam_surface *surface, double u[2], double v[2]);
/* The jet at (u,v). Any thread may call it while the session lives. */
LAM_API void lam_surface_jet(const lam_surface *surface, double u, double v, lam_jet *jet);

/* ---- a surface of one's own ---- */

typedef enum lam_quantity { LAM_PLAIN_NUMBER, LAM_LENGTH, LAM_ANGLE } lam_quantity;

/* A key of the surface in designs. Its value reaches eval in meters or radians. */
typedef struct lam_surface_number {
  const char *name;      /* as in `{kind: wave, height: 2 m}` */
  lam_quantity quantity; /* LENGTH and ANGLE are written with a unit */
  const char *initial;   /* the default as a design would write it, "2 m"; NULL: must be given */
  double min, max;       /* inclusive, in meters or radians; min == max: no limit */
  const char *doc;       /* a sentence */
} lam_surface_number;

typedef struct lam_surface_definition {
  const char *name; /* as written after `kind:`; no other surface has it */
  const char *title, *doc;
  int number_count;
  const lam_surface_number *numbers; /* its keys */
  double u[2], v[2];                 /* the default rectangle */
  bool closed_u, closed_v;           /* whether it closes up there */
  /* Writes the jet at (u,v). numbers: values of the keys, in their order. Pure: it is called often,
   * and what is the same has to come out the same. */
  void (*eval)(const void *context, const double *numbers, double u, double v, lam_jet *jet);
  const void *context; /* handed to eval; outlives the session */
} lam_surface_definition;

/* Makes the surface known to all designs of this session: `surface: {kind: NAME, ...}`. The
 * definition is copied. LAM_BAD_INPUT: the name is taken or not file-name safe, a number has no
 * name, eval is missing, or a derivative that eval gives differs from a difference quotient at the
 * middle of the rectangle. LAM_NO_MEMORY. */
LAM_API lam_status lam_surface_add(lam_session *session, const lam_surface_definition *definition);

LAM_END_DECLS

#endif
