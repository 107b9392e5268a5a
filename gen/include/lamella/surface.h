/* Smooth surfaces x(u,v): evaluating those of the library, and adding one's own. */
#ifndef LAMELLA_SURFACE_H
#define LAMELLA_SURFACE_H

#include <lamella/session.h>

LAM_BEGIN_DECLS

/* A point (meters) with its derivatives: x_u, x_v, x_uu, x_uv, x_vv. */
typedef struct lam_jet {
  lam_vec3 x, u, v, uu, uv, vv;
} lam_jet;

/* ---- a surface of the library ---- */

/* A surface that can be evaluated; owned by the session. */
typedef struct lam_surface lam_surface;

/* A surface from what stands after `surface:` in a design, in the form with braces: "{kind:
 * enneper, order: 2}". A file that it names is read, from the current folder where the path is
 * relative. Its keys of placement (u, v, size, rotate, ...) are checked, not applied. The kinds are
 * those of lam_reference_list(session, "surfaces", ...).
 *
 *   surface  NULL with any other status than LAM_OK
 *
 *   LAM_BAD_INPUT  the keys are wrong, alone or together
 *   LAM_IO         the file cannot be read
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_surface_read(lam_session *session, const char *keys,
                                    const lam_surface **surface);
/* The rectangle of its natural parameters: low and high of u, of v. Any thread. */
LAM_API void lam_surface_domain(const lam_surface *surface, double u[2], double v[2]);
/* The jet at (u,v) of the rectangle. Any thread may call it while the surface lives, if the
 * callback of a surface of one's own allows it. */
LAM_API void lam_surface_jet(const lam_surface *surface, double u, double v, lam_jet *jet);

/* ---- a surface of one's own ---- */

typedef enum lam_quantity { LAM_PLAIN_NUMBER, LAM_LENGTH, LAM_ANGLE } lam_quantity;

/* A key of the surface in designs. Its value reaches eval in meters or radians. */
typedef struct lam_surface_number {
  const char *name;      /* as in `{kind: wave, height: 2 m}`: letters, digits, - and _ */
  lam_quantity quantity; /* LENGTH and ANGLE are written with a unit */
  const char *initial;   /* the default as a design would write it, "2 m"; NULL: must be given */
  double min, max;       /* inclusive, in meters or radians; min == max: no limit */
  const char *doc;       /* a sentence; not NULL */
} lam_surface_number;

typedef struct lam_surface_definition {
  const char *name;  /* as written after `kind:`: letters, digits, - and _; no other surface of
                             the session has it */
  const char *title; /* a few words; NULL: the name */
  const char *doc;   /* a paragraph; NULL: nothing */
  int number_count;
  const lam_surface_number *numbers; /* its keys */
  double u[2], v[2];                 /* the default rectangle, from smaller to larger numbers */
  bool closed_u, closed_v;           /* whether it closes up there */
  /* Writes the jet at (u,v). numbers: values of the keys, in their order. Pure: it is called often,
   * and what is the same has to come out the same. A design may ask for another rectangle (keys
   * u and v). */
  void (*eval)(const void *context, const double *numbers, double u, double v, lam_jet *jet);
  const void *context; /* handed to eval; outlives the session; may be NULL */
} lam_surface_definition;

/* Makes the surface known to all designs of this session: `surface: {kind: NAME, ...}`; it stays
 * when the session is cleared. The definition and its texts are copied. Its derivatives are
 * compared with difference quotients at the middle of the rectangle: here when all numbers have
 * defaults, and whenever a design makes it.
 *
 *   LAM_BAD_INPUT  the name is taken or has other letters, eval is missing, a range is empty, a
 *                  number has no name or doc, or a derivative is wrong; nothing is added then
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_surface_add(lam_session *session, const lam_surface_definition *definition);

LAM_END_DECLS

#endif
