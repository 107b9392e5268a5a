/* Pictures of scenes, made by POV-Ray. */
#ifndef LAM_LIBRARY_WRITE_RENDER_H
#define LAM_LIBRARY_WRITE_RENDER_H

#include "core/error.h"
#include "core/model.h"

/* Renders dir/pov_name (NAME.pov) to dir/NAME.png at the picture's size and quality (a section of
 * render.ini). The picture appears complete or not at all; an earlier one stays when rendering
 * fails. The scene's template files stand in dir, as lam_format.support lists them (POV-Ray's
 * default rules forbid it to read elsewhere); those that do not are looked for in
 * templates_dir/pov, which may be NULL. LAM_MISSING_PROGRAM  povray is not installed: one message
 * LAM_IO no scene, or the picture cannot be put in place: one message LAM_FAILED           povray
 * gave up: one message with its reason */
lam_status lam_render_scene(const char *dir, const char *pov_name, const lam_picture *picture,
                            const char *templates_dir, lam_errors *errors);

#endif
