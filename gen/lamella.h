/* lamella: surfaces, discrete nets and the parts they are built from.
 *
 * Conventions, once:
 *   units       SI inside: meters, radians, kilograms; z is up. OpenSCAD, STL, DXF and SVG are in
 * millimeters; glTF in meters, y up (one root node turns it). surfaces    x(u,v) with derivatives;
 * boundary curves r1: v = 0, r3: v = 1 (both along u), r2: u = 0, r4: u = 1 (along v). nets two
 * families of polylines: family 0 runs along u, family 1 along v. A regular vertex star lists its
 * neighbors as +u, +v, -u, -v: counterclockwise around the normal. Irregular vertices are legal
 * everywhere; what needs a regular star skips them, and the report says how many. grids vertex (i,
 * j) has index i * m + j, i along family 0. scale       what is minimized is scale-free: lengths
 * are divided by the net's mean edge. A tolerance means the same on a desk model and on a roof.
 * arguments   inputs first, then what is changed, then outputs, errors last. memory      comes from
 * a lam_arena that the caller makes and frees; results live as long as it does. Allocation does not
 * fail by NULL: it jumps to LAM_ARENA_TRY. failures    a bug of the caller: assert. Wrong input:
 * messages in lam_errors (file, line, key, what was given, what is expected). Non-convergence: a
 * result, with its residual and the reason.
 *
 * A whole run:
 *   lam_arena *arena = lam_arena_new();
 *   if (!LAM_ARENA_TRY(arena)) ...                              out of memory
 *   lam_errors errors = {.arena = arena};
 *   lam_design design;
 *   lam_model model;
 *   if (lam_design_parse(arena, text, length, "my.yaml", NULL, 0, &errors, &design) &&
 *       lam_design_build(arena, &design, NULL, NULL, &errors, &model)) ...
 *   lam_arena_free(arena);
 */
#ifndef LAMELLA_H
#define LAMELLA_H

#include "con/constraint.h"
#include "core/arena.h"
#include "core/error.h"
#include "core/key.h"
#include "core/model.h"
#include "core/progress.h"
#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "core/text.h"
#include "core/vec3.h"
#include "design/design.h"
#include "design/pipeline_run.h"
#include "fab/workshop.h"
#include "mesh/net.h"
#include "net/measures/measure.h"
#include "net/net_kind.h"
#include "net/optimize.h"
#include "solve/guided.h"
#include "surf/surface.h"

#endif
