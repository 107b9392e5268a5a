/* The top level of a design: its keys and those of render, sheets and texture. Read by parse.c, and
 * by library/ for reference pages. */
#include "design/design.h"
#include "fab/workshop.h"
#include "net/net_kind.h"
#include "surf/flatten/texture.h"
#include "surf/placement.h"
#include "surf/surface.h"

/* Versions of the design language that are understood. */
static const char *const languages[] = {"1", NULL};

/* Sections of templates/pov/render.ini. */
const char *const lam_qualities[] = {"draft", "golden", "mask",  "thumb", "middle",
                                     "final", "exact",  "print", NULL};

static const lam_key render_keys[] = {
    LAM_TEXT_KEY(lam_render_keys, "setting", setting, "plaza",
                 "The surroundings: a file of templates/pov, without its ending."),
    LAM_TEXT_KEY(lam_render_keys, "view", view, "auto",
                 "The camera: a view that the setting knows, or auto."),
    LAM_INTEGER_KEY(lam_render_keys, "size", size, "[1600, 900]", 16, 16384,
                    "Width and height of the picture in pixels."),
    /* The parser stores the index; the word itself follows from it (parse.c). */
    LAM_CHOICE_KEY(
        lam_render_keys, "quality", quality_index, "draft", lam_qualities,
        "A section of templates/pov/render.ini (--picture names another one): draft takes "
        "seconds and has no indirect light, thumb (for small pictures) and middle a minute, final "
        "minutes, print longer; exact is final with the same pixels every time; golden and mask "
        "(a flat color per part) are for comparing."),
    {.name = NULL},
};

static const lam_key sheet_keys[] = {
    LAM_LENGTH_KEY(lam_sheet_keys, "stock", stock, "[3 m, 1.5 m]", 0.01, 100,
                   "Length and width of one sheet of material."),
    LAM_LENGTH_KEY(lam_sheet_keys, "kerf", kerf, "0", 0, 0.01,
                   "The width that the cut itself removes: outlines grow by half of it, holes "
                   "shrink. 0 leaves it to the workshop."),
    LAM_LENGTH_KEY(lam_sheet_keys, "margin", margin, "10 mm", 0, 1,
                   "The distance of parts from the edge of the sheet."),
    LAM_LENGTH_KEY(lam_sheet_keys, "spacing", spacing, "5 mm", 0, 1,
                   "The distance between parts on a sheet."),
    {.name = NULL},
};

static const lam_key texture_keys[] = {
    LAM_CHOICE_KEY(lam_texture_keys, "motif", motif, "letter", lam_motif_names,
                   "What is printed: the letter B on squared paper, a checkerboard, or, in the "
                   "colors of the plots, the distortion of the print itself: the ratio of its "
                   "singular values, from 1 to the largest."),
    LAM_CHOICE_KEY(
        lam_texture_keys, "layout", layout, "flattening", lam_print_layout_names,
        "How the picture comes onto the surface: through the flattened surface, through the "
        "parameter lines, or both side by side with the prints laid flat in front of them."),
    LAM_INTEGER_KEY(lam_texture_keys, "cells", cells, "40", 2, 200,
                    "Cells in each direction of the grid that carries the print."),
    {.name = NULL},
};

const lam_key lam_design_keys[] = {
    LAM_CHOICE_KEY(lam_design, "lamella", language, NULL, languages,
                   "The version of the design language that the file is written in."),
    LAM_TEXT_KEY(lam_design, "name", name, NULL,
                 "The name of the design and of the files made from it: letters, digits, - and _."),
    LAM_TEXT_KEY(lam_design, "title", title, "", "The title, for people. Left out: the name."),
    LAM_TEXT_KEY(lam_design, "source", source, "",
                 "Where the design comes from: a paper, a building."),
    LAM_ROW_KEY(lam_design, "surface", surface, "", &lam_surfaces,
                "The smooth surface that the net starts from.", .keys = lam_placement_key_table,
                .size = sizeof(lam_placement_keys)),
    LAM_ROW_KEY(lam_design, "net", net, "", &lam_nets,
                "The net of quadrilaterals on the surface: its polylines become the parts.",
                .keys = lam_net_common_keys, .size = sizeof(lam_net_common)),
    LAM_ROW_KEY(lam_design, "parts", parts, "[]", &lam_part_kinds,
                "What is made from the net, in this order."),
    LAM_TEXT_KEY(lam_design, "plots", plots, "[]",
                 "Measures of the net that are drawn as color maps, into plots/: names of `lamella "
                 "list measures`."),
    LAM_MAP_KEY(lam_design, "texture", texture, "{}", texture_keys,
                "A picture printed on the surface, shown instead of the net; for surfaces that are "
                "splines.",
                LAM_GIVEN(lam_design, has_texture)),
    LAM_MAP_KEY(lam_design, "render", render, "{}", render_keys,
                "The picture. Left out: the defaults are used.", LAM_GIVEN(lam_design, has_render)),
    LAM_MAP_KEY(lam_design, "sheets", sheets, "{}", sheet_keys,
                "The sheets that flat parts are cut from. Left out: the defaults are used.",
                LAM_GIVEN(lam_design, has_sheets)),
    {.name = NULL},
};
