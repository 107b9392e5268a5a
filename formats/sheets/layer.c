/* The layers of sheet drawings, for dxf.c and svg.c. */
#include "formats/sheets/layer.h"

const lam_layer_style lam_layer_styles[LAM_LAYER_COUNT] = {
    [LAM_LAYER_CUT] = {"CUT", "CUT", 1, "#ff0000", "outlines and holes to cut"},
    [LAM_LAYER_ENGRAVE] = {"ENGRAVE", "ENGRAVE", 5, "#0000ff", "marks to engrave"},
    [LAM_LAYER_LABEL] = {"LABEL", "LABEL", 3, "#00a000", "part names, as single strokes"},
    /* CAD programs never plot what lies on DEFPOINTS, and a program for lasers takes this color for
     * a help line that is not sent to the machine. */
    [LAM_LAYER_SHEET] = {"SHEET", "DEFPOINTS", 8, "#f36926", "edge of the stock; not to be cut"},
};
