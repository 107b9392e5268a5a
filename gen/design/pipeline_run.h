/* The pipeline: design -> surface -> net -> parts -> sheets -> model. */
#ifndef LAM_DESIGN_PIPELINE_RUN_H
#define LAM_DESIGN_PIPELINE_RUN_H

#include "core/model.h"
#include "core/progress.h"
#include "design/design.h"

/* How the pipeline gets at meshes that a design names: the caller reads files, the library does
 * not. Paths are as in the design. Each adds errors at place and returns false when there is no
 * such mesh. */
typedef struct lam_loader {
  bool (*mesh)(void *context, lam_arena *arena, const char *path, lam_location location,
               lam_errors *errors, lam_mesh *mesh);
  bool (*triangles)(void *context, lam_arena *arena, const char *path, lam_location location,
                    lam_errors *errors, lam_trimesh *mesh);
  void *context;
  /* The finished net of another design, by its name or file. May be NULL. */
  bool (*net)(void *context, lam_arena *arena, const char *design, lam_location location,
              lam_errors *errors, lam_mesh *mesh);
  /* Surface number `face` (from 1) of a file; note says what of it is not read, NULL: nothing. May
   * be NULL. */
  bool (*surface)(void *context, lam_arena *arena, const char *path, int face,
                  lam_location location, lam_errors *errors, lam_spline_surface *surface,
                  const char **note);
  /* All curves of a file. May be NULL. */
  bool (*curves)(void *context, lam_arena *arena, const char *path, lam_location location,
                 lam_errors *errors, int *count, const lam_named_curve **curves);
  /* All points of a file. May be NULL. */
  bool (*points)(void *context, lam_arena *arena, const char *path, lam_location location,
                 lam_errors *errors, int *count, const lam_vec3 **points);
} lam_loader;

/* Builds the model of a parsed design. loader and progress may be NULL. Wrong input adds to errors
 * and returns false; a net that does not converge is no error: the report says so. Everything is
 * owned by arena. */
bool lam_design_build(lam_arena *arena, const lam_design *design, const lam_loader *loader,
                      const lam_progress *progress, lam_errors *errors, lam_model *model);

/* Whether every stage of a report converged. */
bool lam_report_converged(const lam_report *report);

#endif
