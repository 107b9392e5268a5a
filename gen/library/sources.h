/* The files and other designs that a design names: checked, listed, and read, each once. Called by
 * designs.c, own_surfaces.c and solve_net.c. */
#ifndef LAM_LIBRARY_SOURCES_H
#define LAM_LIBRARY_SOURCES_H

#include "design/inputs.h"
#include "library/session_state.h"
#include <lamella/design.h>

/* Reads and parses a design's file, or its text, with its overrides; the surfaces that were added
 * to the session are known. design is filled, in the session's memory. False with messages. */
bool lam_source_parse(lam_session *session, const lam_design_source *source, lam_design *design);

/* Adds a message for every file of the design that cannot be read, for measures that do not exist
 * and for a setting without a template.
 *
 *   design        was parsed without errors
 *   make_surface  also makes the surface, to see what is wrong with its keys when they are taken
 *                 together; this may take as long as computing it, and building finds it anyway */
void lam_sources_check(lam_session *session, const lam_design *design, bool make_surface);

enum { LAM_SOURCES = 4 }; /* that a design can name: surface, start (two ways), reference */
/* The files that the design names, as it names them: meshes, points, curves, surfaces, and designs
 * as NAME.yaml. Returns how many, at most LAM_SOURCES. The design was parsed without errors. */
int lam_sources_list(lam_arena *arena, const lam_design *design, const char *files[LAM_SOURCES]);

/* Reads what the design names: files, and other designs, which are built as far as their net.
 *
 *   design  was parsed without errors
 *   origin  gets the path of every file that was opened, once
 *   inputs  filled anew, in the session's memory
 *
 * False with messages. */
bool lam_sources_read(lam_session *session, const lam_design *design, lam_origin *origin,
                      lam_inputs *inputs);

#endif
