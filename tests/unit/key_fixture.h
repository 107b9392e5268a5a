/* Messages of the design language, one after the other, for the files
 * tests/unit/design/test_keys.c and test_design.c. */
#ifndef TESTS_UNIT_KEY_FIXTURE_H
#define TESTS_UNIT_KEY_FIXTURE_H

#include "core/error.h"
#include "core/text.h"
#include "tests/unit/asserts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

typedef struct run {
  lam_arena *arena;
  lam_errors errors;
} run;

static int begin(void **state) {
  run *r = test_calloc(1, sizeof *r);
  r->arena = lam_arena_new();
  r->errors.arena = r->arena;
  *state = r;
  return 0;
}

static int end(void **state) {
  run *r = *state;
  lam_arena_free(r->arena);
  test_free(r);
  return 0;
}

/* All messages, one per line, as "line:column: key: text" or "file: key: text" when there is no
 * line. */
static const char *messages(run *r) {
  lam_text text = {.arena = r->arena};
  lam_text_add(&text, "");
  for (const lam_error *error = r->errors.first; error; error = error->next) {
    if (error->location.line)
      lam_text_printf(&text, "%d:%d: ", error->location.line, error->location.column);
    else
      lam_text_printf(&text, "%s: ", error->location.file ? error->location.file : "-");
    if (error->key) lam_text_printf(&text, "%s: ", error->key);
    lam_text_printf(&text, "%s\n", error->text);
  }
  r->errors = (lam_errors){.arena = r->arena};
  return text.data;
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

#endif
