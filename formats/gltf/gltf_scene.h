/* From a glTF scene to the bytes of a file. */
#ifndef LAM_FORMATS_GLTF_GLTF_SCENE_H
#define LAM_FORMATS_GLTF_GLTF_SCENE_H

#include "core/text.h"
#include "formats/gltf/gltf_shim.h"

/* Adds the .glb bytes to out. LAM_OK, or LAM_FAILED when the library failed. */
lam_status lam_gltf_write(const lam_gltf_scene *scene, lam_text *out);

#endif
