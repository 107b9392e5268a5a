/* The picture: the scene of pov.c, rendered by POV-Ray. gen/library starts the program; this row,
 * listed in formats/list/formats.c, gives its name. */
#include "formats/format.h"

static int count(const lam_model *model) { return model->picture.setting != NULL; }

static void path(const lam_model *model, int i, lam_text *name) {
  (void)i;
  lam_text_printf(name, "%s.png", model->name);
}

const lam_format lam_format_png = {
    .name = "png",
    .doc = "NAME.png: the scene rendered by POV-Ray; pov is written with it.",
    .needs = "pov",
    .count = count,
    .path = path,
};
