/* The top level of a design. */
#include "design/design.h"
#include "fab/workshop.h"
#include "net/net_kind.h"
#include "surf/flatten/texture.h"
#include "surf/placement.h"
#include "surf/surface.h"

#define IN_DESIGN(member) offsetof(lam_design, member)
#define IN_RENDER(member) offsetof(lam_render_keys, member)
#define IN_SHEETS(member) offsetof(lam_sheet_keys, member)

static const char *const languages[] = {"1", NULL};
const char *const lam_qualities[] = {"draft", "golden", "mask",  "thumb", "middle",
                                     "final", "exact",  "print", NULL};

static const lam_key render_keys[] = {
    {.name = "setting",
     .type = LAM_KEY_TEXT,
     .offset = IN_RENDER(setting),
     .count = 1,
     .initial = "plaza",
     .doc = "The surroundings: a file of templates/pov, without its ending."},
    {.name = "view",
     .type = LAM_KEY_TEXT,
     .offset = IN_RENDER(view),
     .count = 1,
     .initial = "auto",
     .doc = "The camera: a view that the setting knows, or auto."},
    {.name = "size",
     .type = LAM_KEY_INTEGER,
     .offset = IN_RENDER(size),
     .count = 2,
     .initial = "[1600, 900]",
     .min = 16,
     .max = 16384,
     .doc = "Width and height of the picture in pixels."},
    {
        .name = "quality",
        .type = LAM_KEY_CHOICE,
        .offset = IN_RENDER(quality_index),
        .count = 1,
        .initial = "final",
        .choices = lam_qualities,
        .doc = "A section of templates/pov/render.ini: draft takes seconds and has no indirect "
               "light, thumb (for small "
               "pictures) and middle a minute, "
               "final "
               "minutes, print longer; exact is final with the same pixels every time; golden and "
               "mask (a flat color "
               "per part) "
               "are for comparing.",
    },
    {.name = NULL},
};

static const lam_key sheet_keys[] = {
    {.name = "stock",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN_SHEETS(stock),
     .count = 2,
     .initial = "[3 m, 1.5 m]",
     .min = 0.01,
     .max = 100,
     .doc = "Length and width of one sheet of material."},
    {.name = "kerf",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN_SHEETS(kerf),
     .count = 1,
     .initial = "0",
     .min = 0,
     .max = 0.01,
     .doc = "The width that the cut itself removes: outlines grow by half of it, holes shrink. 0 "
            "leaves it to the "
            "workshop."},
    {.name = "margin",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN_SHEETS(margin),
     .count = 1,
     .initial = "10 mm",
     .min = 0,
     .max = 1,
     .doc = "The distance of parts from the edge of the sheet."},
    {.name = "spacing",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN_SHEETS(spacing),
     .count = 1,
     .initial = "5 mm",
     .min = 0,
     .max = 1,
     .doc = "The distance between parts on a sheet."},
    {.name = NULL},
};

#define IN_TEXTURE(member) offsetof(lam_texture_keys, member)
static const lam_key texture_keys[] = {
    {.name = "motif",
     .type = LAM_KEY_CHOICE,
     .offset = IN_TEXTURE(motif),
     .count = 1,
     .initial = "letter",
     .choices = lam_motif_names,
     .doc = "What is printed: the letter B on squared paper, a checkerboard, or, in the colors of "
            "the plots, the "
            "distortion of the print itself: the ratio of its singular values, from 1 to the "
            "largest."},
    {.name = "layout",
     .type = LAM_KEY_CHOICE,
     .offset = IN_TEXTURE(layout),
     .count = 1,
     .initial = "flattening",
     .choices = lam_print_layout_names,
     .doc = "How the picture comes onto the surface: through the flattened surface, through the "
            "parameter lines, or "
            "both side by side with the prints laid flat in front of them."},
    {.name = "cells",
     .type = LAM_KEY_INTEGER,
     .offset = IN_TEXTURE(cells),
     .count = 1,
     .initial = "40",
     .min = 2,
     .max = 200,
     .doc = "Cells in each direction of the grid that carries the print."},
    {.name = NULL},
};

const lam_key lam_design_keys[] = {
    {.name = "lamella",
     .type = LAM_KEY_CHOICE,
     .offset = IN_DESIGN(language),
     .count = 1,
     .choices = languages,
     .doc = "The version of the design language that the file is written in."},
    {.name = "name",
     .type = LAM_KEY_TEXT,
     .offset = IN_DESIGN(name),
     .count = 1,
     .doc = "The name of the design and of the files made from it: letters, digits, - and _."},
    {.name = "title",
     .type = LAM_KEY_TEXT,
     .offset = IN_DESIGN(title),
     .count = 1,
     .initial = "",
     .doc = "The title, for people. Left out: the name."},
    {.name = "source",
     .type = LAM_KEY_TEXT,
     .offset = IN_DESIGN(source),
     .count = 1,
     .initial = "",
     .doc = "Where the design comes from: a paper, a building."},
    {.name = "surface",
     .type = LAM_KEY_ROW,
     .offset = IN_DESIGN(surface),
     .count = 1,
     .initial = "",
     .rows = &lam_surfaces,
     .keys = lam_placement_key_table,
     .size = sizeof(lam_placement_keys),
     .doc = "The smooth surface that the net starts from."},
    {.name = "net",
     .type = LAM_KEY_ROW,
     .offset = IN_DESIGN(net),
     .count = 1,
     .initial = "",
     .rows = &lam_nets,
     .keys = lam_net_common_keys,
     .size = sizeof(lam_net_common),
     .doc = "The net of quadrilaterals on the surface: its polylines become the parts."},
    {.name = "parts",
     .type = LAM_KEY_ROW,
     .offset = IN_DESIGN(parts),
     .count = 0,
     .initial = "[]",
     .rows = &lam_part_kinds,
     .doc = "What is made from the net, in this order."},
    {.name = "plots",
     .type = LAM_KEY_TEXT,
     .offset = IN_DESIGN(plots),
     .count = 0,
     .initial = "[]",
     .doc = "Measures of the net that are drawn as color maps, into plots/: names of `lamella list "
            "measures`."},
    {.name = "texture",
     .type = LAM_KEY_MAP,
     .offset = IN_DESIGN(texture),
     .count = 1,
     .initial = "{}",
     .keys = texture_keys,
     .size = sizeof(lam_texture_keys),
     .given_offset = IN_DESIGN(has_texture),
     .doc = "A picture printed on the surface, shown instead of the net; for surfaces that are "
            "splines."},
    {.name = "render",
     .type = LAM_KEY_MAP,
     .offset = IN_DESIGN(render),
     .count = 1,
     .initial = "{}",
     .keys = render_keys,
     .size = sizeof(lam_render_keys),
     .given_offset = IN_DESIGN(has_render),
     .doc = "The picture. Left out: the defaults are used."},
    {.name = "sheets",
     .type = LAM_KEY_MAP,
     .offset = IN_DESIGN(sheets),
     .count = 1,
     .initial = "{}",
     .keys = sheet_keys,
     .size = sizeof(lam_sheet_keys),
     .given_offset = IN_DESIGN(has_sheets),
     .doc = "The sheets that flat parts are cut from. Left out: the defaults are used."},
    {.name = NULL},
};
