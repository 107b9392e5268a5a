/* The design file: a YAML map read through key tables (core/key.h), of which the top-level one is
 * in design_keys.c. Parsed (parse.c) by library/ and bench/, built by pipeline_run.c. */
#ifndef LAM_DESIGN_DESIGN_H
#define LAM_DESIGN_DESIGN_H

#include "core/error.h"
#include "core/key.h"
#include <lamella/design.h>

/* The keys of `render`: the picture. */
typedef struct lam_render_keys {
  const char *setting, *view; /* files and names of templates/pov, see design_keys.c */
  const char *quality;        /* one of lam_qualities */
  int quality_index;          /* of quality, in lam_qualities */
  lam_location location;      /* of the setting */
  int size[2];                /* pixels: width, height */
} lam_render_keys;

/* The keys of `sheets`: the stock that flat parts are cut from. */
typedef struct lam_sheet_keys {
  double stock[2];              /* length and width of a sheet, meters */
  double kerf, margin, spacing; /* meters */
} lam_sheet_keys;

/* The keys of `texture`: a picture printed on the surface. */
typedef struct lam_texture_keys {
  int motif, layout; /* lam_motif, lam_print_layout (surf/flatten/texture.h) */
  int cells;         /* of the grid that carries the print, in each direction */
} lam_texture_keys;

/* A parsed design. All texts and lists live as long as the arena that it was parsed into. */
struct lam_design {
  int language;       /* version of the design language: 1 */
  const char *name;   /* letters, digits, - and _ */
  const char *title;  /* the name when the design has none */
  const char *source; /* empty when the design has none */
  lam_row surface;    /* common: lam_placement_keys (surf/placement.h); head is NULL when the
                       * design has none */
  lam_row net;        /* common: lam_net_common (net/net_kind.h); head is NULL when the design has
                       * none */
  lam_list parts;     /* of lam_row, no common keys */
  lam_list plots;     /* of const char *: measures to be drawn as color maps */
  bool has_render, has_sheets; /* whether the design gives them; they hold the defaults otherwise */
  bool has_texture;
  lam_texture_keys texture; /* meaningful when has_texture */
  lam_render_keys render;
  lam_sheet_keys sheets;
  const char *path; /* of the file, as given; NULL when parsed from memory without a name */
};

extern const lam_key lam_design_keys[];   /* the top-level table */
extern const char *const lam_qualities[]; /* of pictures: NULL-terminated */

/* What a design is parsed from. */
typedef struct lam_design_text {
  const char *bytes; /* YAML */
  size_t count;
  const char *path;             /* for messages; may be NULL */
  int override_count;           /* changes, in order */
  const char *const *overrides; /* "net.grid=[40,40]", "parts[0].height=80 mm": the value is YAML */
  const lam_added_rows *added;  /* rows beside those of the registries; NULL: none */
} lam_design_text;

/* Parses a design. Every problem found is added to errors; returns true when there was none, and
 * the design must not be built otherwise. Texts and lists live as long as arena; nothing of text
 * is kept but its added rows. Overrides are applied before validation; their messages have the
 * location {"--set net.grid", 0, 0} instead of a file. */
bool lam_design_parse(lam_arena *arena, const lam_design_text *text, lam_errors *errors,
                      lam_design *design);

/* Fills a struct from a key table out of a YAML text: what lam_design_parse does at every level.
 * For tests, which read single tables.
 *
 *   bytes, count  the YAML text
 *   path          for messages; may be NULL
 *   params        the struct that keys fill, zeroed
 *
 * Returns true when no problem was found; every problem is added to errors. */
bool lam_keys_parse(lam_arena *arena, const lam_key *keys, const char *bytes, size_t count,
                    const char *path, lam_errors *errors, void *params);

#endif
