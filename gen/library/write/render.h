/* Pictures of scenes, made by POV-Ray. Called by write_files.c. */
#ifndef LAM_LIBRARY_WRITE_RENDER_H
#define LAM_LIBRARY_WRITE_RENDER_H

#include "core/error.h"
#include "core/model.h"
#include "core/progress.h"
#include "library/write/folder.h"

/* Renders a scene in a folder to a picture beside it. The picture appears complete or not at all;
 * an earlier one stays when rendering fails. It takes seconds to minutes, and is given up after two
 * hours.
 *
 *   scene          its name in the folder, NAME.pov
 *   name           of the picture in the folder
 *   picture        its size, and its quality: a section of render.ini
 *   templates_dir  whose folder pov is looked in for template files that do not stand beside the
 *                  scene, as lam_format.support lists them (POV-Ray's default rules forbid it to
 *                  read elsewhere); NULL: nowhere
 *   progress       told of stage "render" while the picture grows; NULL: nobody
 *
 *   LAM_MISSING_PROGRAM  povray is not installed: one message
 *   LAM_IO               no scene, or the picture cannot be put in place: one message
 *   LAM_FAILED           povray gave up, or took too long: one message with its reason */
lam_status lam_render_scene(const lam_folder *folder, const char *scene, const char *name,
                            const lam_picture *picture, const char *templates_dir,
                            const lam_progress *progress, lam_errors *errors);

#endif
