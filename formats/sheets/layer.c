/* The layers of sheet drawings, for dxf.c and svg.c. */
#include "formats/sheets/layer.h"

const lam_layer_style lam_layer_styles[LAM_LAYER_COUNT] = {
    [LAM_LAYER_CUT] = {"CUT", 1, "#ff0000", "outlines and holes to cut"},
    [LAM_LAYER_ENGRAVE] = {"ENGRAVE", 5, "#0000ff", "marks to engrave"},
    [LAM_LAYER_LABEL] = {"LABEL", 3, "#00a000", "part names, as single strokes"},
    [LAM_LAYER_SHEET] = {"SHEET", 8, "#808080", "edge of the stock; not to be cut"},
};
