/* What tests of written files share: a file as text, and its comparison line by line. */
#ifndef LAM_TESTS_TEXT_FIXTURE_H
#define LAM_TESTS_TEXT_FIXTURE_H

#include "formats/format.h"
#include "tests/unit/asserts.h"

#include <string.h>

static inline int text_set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static inline int text_tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

#define TEXT_TEST(function) cmocka_unit_test_setup_teardown(function, text_set_up, text_tear_down)

/* File i of a model. */
static inline const char *text_of(lam_arena *arena, const lam_format *format,
                                  const lam_model *model, int i) {
  lam_text text = {.arena = arena};
  assert_int_equal(format->write(model, i, &text), LAM_OK);
  return text.data;
}

/* The name of file i of a model. */
static inline const char *text_path(lam_arena *arena, const lam_format *format,
                                    const lam_model *model, int i) {
  lam_text text = {.arena = arena};
  format->path(model, i, &text);
  return text.data;
}

/* Fails with the first line that differs. */
static inline void assert_lines(const char *what, const char *value, const char *expected) {
  for (int line = 1;; line++) {
    size_t a = strcspn(value, "\n"), b = strcspn(expected, "\n");
    if (a != b || memcmp(value, expected, a) != 0)
      fail_msg("%s, line %d: \"%.*s\", expected \"%.*s\"", what, line, (int)a, value, (int)b,
               expected);
    if (value[a] != expected[b])
      fail_msg("%s: %s line %d", what, value[a] ? "goes on after" : "ends with", line);
    if (!value[a]) return;
    value += a + 1, expected += b + 1;
  }
}

/* The same for a text that is expected in pieces, up to NULL. */
static inline void assert_pieces(lam_arena *arena, const char *what, const char *value,
                                 const char *const *expected) {
  lam_text text = {.arena = arena};
  for (; *expected; expected++) lam_text_add(&text, *expected);
  assert_lines(what, value, text.data);
}

/* Fails when the text does not hold the piece, or when it holds what it must not. */
static inline void assert_holds(const char *text, const char *piece) {
  if (!strstr(text, piece)) fail_msg("no \"%s\" in:\n%s", piece, text);
}
static inline void assert_lacks(const char *text, const char *piece) {
  if (strstr(text, piece)) fail_msg("\"%s\" stands in:\n%s", piece, text);
}

#endif
