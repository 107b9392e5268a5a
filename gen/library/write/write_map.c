/* A color map of a measure as one file; PNG is made from SVG by rsvg-convert. Called by
 * measure_net.c. */
#include "library/write/write_map.h"
#include "core/file.h"
#include "core/process.h"
#include "formats/list/formats.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* Case does not count; a name is more than its ending. */
static bool ends_with(const char *path, const char *ending) {
  size_t length = strlen(path), part = strlen(ending);
  return length > part && strcasecmp(path + length - part, ending) == 0;
}

/* Messages name the option of `lamella measure`, which is what a person gave. */
bool lam_measure_map_check(const char *path, lam_errors *errors) {
  if (ends_with(path, ".svg") || ends_with(path, ".png") || ends_with(path, ".glb")) return true;
  lam_error_add(errors, (lam_location){0}, "-o",
                "given %s; expected a name that ends with .svg, .png or .glb", path);
  return false;
}

/* Writes the first file that a format makes of the model. */
static lam_status write_as(const lam_model *model, const char *format, const char *path,
                           lam_errors *errors) {
  lam_text text = {.arena = errors->arena};
  for (int i = 0; i < lam_format_count; i++) {
    if (strcmp(lam_formats[i]->name, format) != 0) continue;
    lam_status status = lam_formats[i]->write(model, 0, &text);
    if (status == LAM_OK) return lam_file_write_atomic(path, text.data, text.length, errors);
  }

  lam_error_add(errors, (lam_location){.file = path}, NULL, "the library behind %s failed", format);
  return errors->status = LAM_FAILED;
}

/* Makes a PNG file of an SVG file, in 200 dots per inch where SVG has 96. */
static lam_status convert(const char *svg, const char *png, lam_errors *errors) {
  const char *arguments[] = {"rsvg-convert", "--zoom=2.0833333", "--output", png, svg, NULL};
  lam_text output = {.arena = errors->arena};
  lam_process process = {
      .arguments = arguments, .package = "librsvg2-bin", .output = &output, .timeout = 120};

  int code = 0;
  lam_status status = lam_process_run(&process, &code, errors);
  if (status == LAM_OK && code != 0) {
    lam_error_add(errors, (lam_location){.file = png}, NULL, "%s failed: %.300s", arguments[0],
                  output.data ? output.data : "no message");
    status = errors->status = LAM_FAILED;
  }
  return status;
}

/* Both files have other names in the same folder until the picture is complete. */
static lam_status write_png(const lam_model *model, const char *path, lam_errors *errors) {
  const char *svg = lam_arena_printf(errors->arena, "%s.part.svg", path);
  const char *png = lam_arena_printf(errors->arena, "%s.part.png", path);
  lam_status status = write_as(model, "plot", svg, errors);
  if (status == LAM_OK) status = convert(svg, png, errors);

  if (status == LAM_OK && rename(png, path) != 0) {
    lam_error_add(errors, (lam_location){.file = path}, NULL, "cannot be put in place");
    status = errors->status = LAM_IO;
  }

  unlink(svg);
  if (status != LAM_OK) unlink(png);
  return status;
}

lam_status lam_measure_map_write(const lam_model *model, const char *path, lam_errors *errors) {
  if (ends_with(path, ".glb")) return write_as(model, "plot-gltf", path, errors);
  if (ends_with(path, ".svg")) return write_as(model, "plot", path, errors);
  return write_png(model, path, errors);
}
