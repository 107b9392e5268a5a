/* The pipeline: design -> surface -> net -> parts -> sheets -> model. Called by library/. */
#ifndef LAM_DESIGN_PIPELINE_H
#define LAM_DESIGN_PIPELINE_H

#include "core/model.h"
#include "core/progress.h"
#include "design/design.h"
#include "design/inputs.h"

/* Builds the model of a parsed design from what was read for it.
 *
 *   design    read only; kept by pointer: it has to live as long as the model
 *   inputs    what the design names outside itself; kept by pointer too
 *   progress  told of every stage; may be NULL
 *   model     filled anew; all of it is owned by arena
 *
 * Wrong input adds to errors and returns false; model is not complete then. A net that does not
 * converge is no error: the report says so. */
bool lam_pipeline_run(lam_arena *arena, const lam_design *design, const lam_inputs *inputs,
                      const lam_progress *progress, lam_errors *errors, lam_model *model);

/* Makes the surface and the net's start alone, to see what is wrong with them before anything is
 * solved. Arguments and result as above. */
bool lam_pipeline_check(lam_arena *arena, const lam_design *design, const lam_inputs *inputs,
                        lam_errors *errors);

#endif
