/* File formats: one writer or reader per file; the list is formats/list/formats.c. A writer turns
 * the model into bytes; it opens no file. A format may make several files: they are enumerated,
 * named and written one by one. */
#ifndef LAM_FORMATS_FORMAT_H
#define LAM_FORMATS_FORMAT_H

#include "core/error.h"
#include "core/key.h"
#include "core/model.h"
#include "core/text.h"

/* A list of spline surfaces that were read. */
typedef struct lam_spline_list {
  int count, capacity;
  lam_spline_surface *items;
  const char **notes; /* per item: what of it is not read, as a sentence; NULL when all is */
} lam_spline_list;

/* A list of curves that were read. */
typedef struct lam_curve_list {
  int count, capacity;
  lam_named_curve *items; /* clamped; named as in the file, or after their place in it */
  const char
      *other; /* a kind of curve that the file has and that is not read; NULL: none was met */
} lam_curve_list;

typedef struct lam_format {
  const char *name;   /* as in --only */
  const char *doc;    /* one sentence */
  const char *ending; /* of the files it reads, for instance "obj" or "step stp"; NULL when it only
                         writes */
  const char *needs;  /* the format that its files are made from, and that is written with it; NULL:
                         none */
  bool last;          /* written when all others are there: the target of make rules */
  double unit; /* of the coordinates of meshes that it reads, meters: what they are taken for */
  /* How many files the model gives (0: nothing to write). NULL: a reader only. */
  int (*count)(const lam_model *model);
  /* The name of file i relative to the output folder, for instance "parts/A07a.stl". */
  void (*path)(const lam_model *model, int i, lam_text *path);
  /* The content of file i. LAM_OK, or LAM_FAILED when an outside library failed. */
  lam_status (*write)(const lam_model *model, int i, lam_text *out);
  /* Written where the model stands, because its numbers have enough digits; others are written
   * about model->origin, and say so in their own way where they can. */
  bool in_place;
  /* NULL-terminated list of template files (relative to templates/) that must stand beside the
   * output; may be NULL. They depend on the model (a scene needs only its own setting). */
  const char *const *(*support)(lam_arena *arena, const lam_model *model);
  /* Reads a quad mesh / a triangle mesh from bytes. location.file names the file; errors name its
   * line. NULL: not read. */
  bool (*read_mesh)(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                    lam_errors *errors, lam_mesh *mesh);
  bool (*read_triangles)(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                         lam_errors *errors, lam_trimesh *mesh);
  /* Reads the spline surfaces, in meters; at least one when it succeeds. NULL: not read. */
  bool (*read_surfaces)(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                        lam_errors *errors, lam_spline_list *surfaces);
  /* Reads the curves, in meters, those that bound surfaces included; at least one when it succeeds.
   * NULL: not read. */
  bool (*read_curves)(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors, lam_curve_list *curves);
  /* Reads points as they are written, without a unit. NULL: not read; points are then the vertices
   * of what read_triangles gives, if anything. */
  bool (*read_points)(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors, int *point_count, const lam_vec3 **points);
} lam_format;

#endif
