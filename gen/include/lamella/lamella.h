/* lamella: surfaces, discrete nets and the parts they are built from. This header includes all
 * others; each of them can be included alone.
 *
 * Conventions, once:
 *   units       SI inside: meters, radians, kilograms; z is up. OpenSCAD, STL, DXF and SVG are in
 *               millimeters; glTF in meters, y up (one root node turns it)
 *   surfaces    x(u,v) with derivatives; boundary curves r1: v = 0, r3: v = 1 (both along u),
 *               r2: u = 0, r4: u = 1 (along v)
 *   nets        two families of polylines: family 0 runs along u, family 1 along v. A regular
 *               vertex star lists its neighbors as +u, +v, -u, -v: counterclockwise around the
 *               normal. Irregular vertices are legal everywhere; what needs a regular star skips
 *               them, and the report says how many
 *   grids       vertex (i, j) has index i * m + j, i along family 0
 *   scale       what is minimized is scale-free: lengths are divided by the net's mean edge. A
 *               tolerance means the same on a desk model and on a roof
 *   arguments   the session first, then inputs, outputs last; a pointer must not be NULL unless
 *               its comment says so
 *   memory      what the library gives belongs to the session; what it is given is only read, and
 *               copied where it has to last
 *   texts       UTF-8, zero-terminated
 *   failures    every function that can fail returns a lam_status; messages stand in the session
 *               (file, line, key, what was given, what is expected). A net that does not converge
 *               is a result, with its residual and the reason
 *   threads     one thread per session; any number of sessions
 *
 * A whole program, compiled with `cc my.c $(pkg-config --cflags --libs lamella)`:
 *
 *   #include <lamella/lamella.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     lam_session *session;
 *     if (lam_session_new(&session) != LAM_OK) return 1;
 *
 *     lam_design_source source = {.path = "my.yaml"};
 *     lam_write_options options = {.folder = "out"};
 *     const lam_design *design;
 *     const lam_model *model;
 *     lam_status status = lam_design_read(session, &source, &design);
 *     if (status == LAM_OK) status = lam_design_build(session, design, &model);
 *     if (status == LAM_OK) status = lam_model_write(session, model, &options, NULL);
 *
 *     for (const lam_error *e = lam_session_messages(session); e; e = e->next) puts(e->text);
 *     lam_session_free(session);
 *     return (int)status;
 *   }
 */
#ifndef LAMELLA_H
#define LAMELLA_H

#include <lamella/api.h>
#include <lamella/bench.h>
#include <lamella/design.h>
#include <lamella/error.h>
#include <lamella/format.h>
#include <lamella/model.h>
#include <lamella/net.h>
#include <lamella/reference.h>
#include <lamella/session.h>
#include <lamella/solid.h>
#include <lamella/surface.h>
#include <lamella/types.h>

LAM_BEGIN_DECLS

/* The version of the library that runs, "0.1.0": it may be newer than the headers. A static text.
 * Any thread. */
LAM_API const char *lam_version(void);

LAM_END_DECLS

#endif
