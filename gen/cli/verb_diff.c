/* lamella diff A B: two meshes or two pictures, the same or not. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/diff.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char usage[] =
    "usage: lamella diff A B [--tolerance T] [--mask FILE.png] [--json]\n"
    "\n"
    "Compares two meshes (STL in millimeters; OBJ, OFF and PLY in meters) or two PNG pictures.\n"
    "\n"
    "Meshes are the same when both are closed or both are open, components and Euler number "
    "agree, volume and area\n"
    "agree to 1e-4 of their size, and no corner of the bounding box and no sampled point is "
    "further than the\n"
    "tolerance from the other mesh.\n"
    "Pictures are the same when they have the same size, and the share of pixels that differ by "
    "more than 4 of 255\n"
    "in a channel is at most the tolerance. The hash of the decoded pixels is printed too.\n"
    "\n"
    "  --tolerance T     meshes: largest distance in millimeters (0.05); pictures: share of "
    "pixels in percent (0.02)\n"
    "  --mask FILE.png   pictures: write a picture with the differing pixels in red\n"
    "  --json            the result as JSON, in SI units\n"
    "  --help            this text\n"
    "\n"
    "exit code: 0 the same; 1 different; 2 bad input";

static bool is_picture(const char *path) {
  size_t length = strlen(path);
  return length >= 4 && strcasecmp(path + length - 4, ".png") == 0;
}

/* Reads the tolerance; NULL: the default, a negative number. False: it is none. */
static bool read_tolerance(const char *text, double *tolerance) {
  char *end;
  *tolerance = -1;
  if (!text) return true;
  *tolerance = strtod(text, &end);
  return end != text && !*end && *tolerance >= 0 && isfinite(*tolerance);
}

/* Both files are of one kind, which their names tell. */
static int diff(lam_session *session, int argc, char **argv) {
  lam_diff_request request = {0};
  const char *tolerance = NULL;
  const lam_option table[] = {{"--tolerance", .value = &tolerance},
                              {"--mask", .value = &request.mask},
                              {"--json", .flag = &request.json},
                              {.name = NULL}};
  lam_arguments arguments = {usage, table, 2, 2, "two files"};
  int count, status = lam_arguments_read(&arguments, argc, argv, request.paths, &count);
  if (status >= 0) return status;

  if (!read_tolerance(tolerance, &request.tolerance))
    return lam_complain_plain(2, "diff: --tolerance \"%s\"; expected a number of at least 0",
                              tolerance);

  bool pictures = is_picture(request.paths[0]);
  if (pictures != is_picture(request.paths[1]))
    return lam_complain_plain(2, "diff: %s and %s: a picture cannot be compared with a mesh",
                              request.paths[0], request.paths[1]);
  if (!pictures && request.mask) return lam_complain_plain(2, "diff: --mask is for pictures");
  return (pictures ? lam_diff_pictures : lam_diff_meshes)(session, &request);
}

int lam_verb_diff(int argc, char **argv) { return lam_verb_run(diff, argc, argv); }
