#include "cli/verb_diff.h"

#include "cli/mesh_input.h"
#include "cli/verbs.h"
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "usage: lamella diff A B [--tolerance T] [--mask FILE.png] [--json]\n"
    "\n"
    "Compares two meshes (STL in millimeters, OBJ in meters) or two PNG pictures.\n"
    "\n"
    "Meshes are the same when both are closed or both are open, components and Euler number agree, "
    "volume and area\n"
    "agree to 1e-4 of their size, and no corner of the bounding box and no sampled point is "
    "further than the\n"
    "tolerance from the other mesh.\n"
    "Pictures are the same when they have the same size, and the share of pixels that differ by "
    "more than 4 of 255\n"
    "in a channel is at most the tolerance. The hash of the decoded pixels is printed too.\n"
    "\n"
    "  --tolerance T     meshes: largest distance in millimeters (0.05); pictures: share of pixels "
    "in percent (0.02)\n"
    "  --mask FILE.png   pictures: write a picture with the differing pixels in red\n"
    "  --json            the result as JSON, in SI units\n"
    "  --help            this text\n"
    "\n"
    "exit code: 0 the same; 1 different; 2 bad input\n";

/* Above every character, so that getopt_long's optopt tells short options from long ones. */
enum { option_json = 256, option_help, option_mask, option_tolerance };

static bool is_picture(const char *path) {
  size_t length = strlen(path);
  return length >= 4 && strcasecmp(path + length - 4, ".png") == 0;
}

static int diff(lam_arena *arena, const lam_diff_request *request) {
  lam_errors errors = {.arena = arena};
  bool pictures = is_picture(request->paths[0]);
  if (pictures != is_picture(request->paths[1]))
    return lam_verb_error("diff", "%s and %s: a picture cannot be compared with a mesh",
                          request->paths[0], request->paths[1]);
  if (!pictures && request->mask) return lam_verb_error("diff", "--mask is for pictures");
  int code = (pictures ? lam_diff_images : lam_diff_meshes)(arena, request, &errors);
  lam_verb_errors("diff", &errors);
  return code;
}

int lam_verb_diff(int argc, char **argv) {
  static const struct option options[] = {{"tolerance", required_argument, NULL, option_tolerance},
                                          {"mask", required_argument, NULL, option_mask},
                                          {"json", no_argument, NULL, option_json},
                                          {"help", no_argument, NULL, option_help},
                                          {NULL, 0, NULL, 0}};
  lam_diff_request request = {.tolerance = -1};
  opterr = optind = 0;
  for (int result; (result = getopt_long(argc, argv, ":", options, NULL)) != -1;) {
    char *end = NULL;
    switch (result) {
    case option_help:
      return fputs(help, stdout) < 0 ? 2 : 0;
    case option_json:
      request.json = true;
      break;
    case option_mask:
      request.mask = optarg;
      break;
    case option_tolerance:
      request.tolerance = strtod(optarg, &end);
      if (end == optarg || *end || !isfinite(request.tolerance) || request.tolerance < 0)
        return lam_verb_error(argv[0], "--tolerance: \"%s\" given, a number of at least 0 expected",
                              optarg);
      break;
    default:
      return lam_verb_option_error(argv, result);
    }
  }
  if (argc - optind != 2)
    return lam_verb_error(argv[0], "%d files given, 2 expected (see --help)", argc - optind);
  request.paths[0] = argv[optind];
  request.paths[1] = argv[optind + 1];
  lam_arena *arena = lam_arena_new();
  if (!arena) return lam_verb_error(argv[0], "out of memory");
  int code =
      LAM_ARENA_TRY(arena) ? diff(arena, &request) : lam_verb_error(argv[0], "out of memory");
  lam_arena_free(arena);
  return code;
}
