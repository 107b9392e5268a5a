/* The states of a net on its way to the result, one OBJ each (frames/NAME-NNN.obj; listed in
 * formats/list/formats.c); the net itself is written by obj.c. */
#include "formats/format.h"
#include "formats/mesh/obj.h"

static int count(const lam_model *model) { return model->net ? model->frame_count : 0; }

static void path(const lam_model *model, int i, lam_text *out) {
  lam_text_printf(out, "frames/%s-%03d.obj", model->name, i);
}

/* The file says which state it is, from 1; its name counts from 0. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  lam_text_printf(out, "# %s: net, state %d of %d, meters\n", model->name, i + 1,
                  model->frame_count);
  lam_obj_net(model, model->frames[i], out);
  return LAM_OK;
}

const lam_format lam_format_frames = {
    .name = "frames",
    .doc = "The states of the net that `animate` keeps, as OBJ files in meters.",
    .count = count,
    .path = path,
    .write = write,
    .in_place = true,
};
