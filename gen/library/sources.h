/* The files and other designs that a design names: checked, listed, and read, each once. */
#ifndef LAM_LIBRARY_SOURCES_H
#define LAM_LIBRARY_SOURCES_H

#include "design/inputs.h"
#include "library/session_state.h"
#include <lamella/design.h>

/* Reads and parses a design's file, or its text; its own overrides and the rows that the session
 * added are applied. False with messages. */
bool lam_source_parse(lam_session *session, const lam_design_source *source, lam_design *design);

/* Adds a message for every file of the design that cannot be read, for measures that do not exist
 * and for a setting without a template; make_surface: also what the surface finds wrong with its
 * keys when they are taken together, which may take as long as computing it, and which building
 * finds anyway. The design was parsed without errors. */
void lam_sources_check(lam_session *session, const lam_design *design, bool make_surface);

/* The files beside the design that it names: meshes, points, curves, surfaces, and designs as
 * NAME.yaml. Returns how many, at most LAM_SOURCES. The design was parsed without errors. */
enum { LAM_SOURCES = 4 };
int lam_sources_list(lam_arena *arena, const lam_design *design, const char *files[LAM_SOURCES]);

/* Reads what the design names: files, and other designs, which are built as far as their net. Every
 * file that was opened is noted in origin. False with messages. */
bool lam_sources_read(lam_session *session, const lam_design *design, lam_origin *origin,
                      lam_inputs *inputs);

#endif
