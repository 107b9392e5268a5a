/* The list of formats, and finding one in it. Called by library/. */
#ifndef LAM_FORMATS_LIST_FORMATS_H
#define LAM_FORMATS_LIST_FORMATS_H

#include "formats/format.h"

extern const lam_format *const lam_formats[];
extern const int lam_format_count;
/* The format with this name, or NULL. */
const lam_format *lam_format_named(const char *name);
/* The format that reads files with this ending (case-insensitive), or NULL. */
const lam_format *lam_format_for(const char *path);

/* What may be read of a file. */
typedef enum lam_content {
  LAM_CONTENT_MESH,
  LAM_CONTENT_TRIANGLES,
  LAM_CONTENT_SURFACES,
  LAM_CONTENT_CURVES,
  LAM_CONTENT_POINTS
} lam_content;
bool lam_format_reads(const lam_format *format, lam_content content);
/* The endings of all formats that read this, for messages: ".obj or .stl". Owned by arena. */
const char *lam_format_endings(lam_arena *arena, lam_content content);

#endif
