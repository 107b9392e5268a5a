/* Building a shipped design in a test. */
#ifndef LAM_DESIGN_FIXTURE_H
#define LAM_DESIGN_FIXTURE_H

#include "core/file.h"
#include "design/pipeline.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* The model of a design that names no files, with overrides. Fails the test with the first
 * message. */
static inline lam_model design_built(lam_arena *arena, const char *path, int count,
                                     const char *const *overrides) {
  lam_errors errors = {.arena = arena};
  lam_design_text text = {.path = path, .override_count = count, .overrides = overrides};
  lam_design *design = LAM_NEW(arena, lam_design, 1);
  lam_inputs inputs = {0};
  lam_model model;
  char *bytes;
  bool read = lam_file_read(arena, path, 1 << 20, &errors, &bytes, &text.count) == LAM_OK;
  text.bytes = bytes;
  if (!read || !lam_design_parse(arena, &text, &errors, design) ||
      !lam_pipeline_run(arena, design, &inputs, NULL, &errors, &model))
    fail_msg("%s", errors.first->text);
  return model;
}

#endif
