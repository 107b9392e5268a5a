/* The layers of sheet drawings: names and colors, the same in every format. Used by dxf.c and
 * svg.c. */
#ifndef LAM_FORMATS_SHEETS_LAYER_H
#define LAM_FORMATS_SHEETS_LAYER_H

#include "core/model.h"

typedef struct lam_layer_style {
  const char *name;
  const char *dxf_name; /* of the layer in DXF */
  int aci;              /* AutoCAD color index */
  const char *color;    /* the same color for the web */
  const char *doc;      /* what the workshop does with it */
} lam_layer_style;

/* In the order of lam_layer. */
extern const lam_layer_style lam_layer_styles[LAM_LAYER_COUNT];

#endif
