/* Texts, numbers as digits, messages and guesses, arrays that grow, whole files: what every writer
 * and reader stands on. */
#include "core/file.h"
#include "core/grow.h"
#include "core/image.h"
#include "core/key.h"
#include "core/stage.h"
#include "core/text.h"
#include "tests/unit/asserts.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

/* ---- numbers ---- */

static void numbers_have_no_zeros_at_their_end(void **state) {
  static const struct {
    double value;
    int decimals;
    const char *text;
  } rows[] = {{1.5, 3, "1.5"},
              {1, 3, "1"},
              {-2.25, 2, "-2.25"},
              {-2.256, 2, "-2.26"},
              {100, 0, "100"},
              {1200, 2, "1200"},
              {-0.0004, 3, "0"},
              {0.0004, 3, "0"},
              {-0.4, 0, "0"},
              {1e20, 1, "100000000000000000000"},
              {0.1, 20, "0.10000000000000000555"},
              {-10, 0, "-10"},
              {-1.04, 1, "-1"},
              {10.5, 1, "10.5"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_text text = {.arena = *state};
    lam_text_number(&text, rows[i].value, rows[i].decimals);
    assert_string_equal(text.data, rows[i].text);
    assert_int_equal(text.length, strlen(rows[i].text));
  }
}

/* The shortest digits that read back as the same number; an exponent below 1e-4 and from 1e16. */
static void reals_read_back(void **state) {
  static const struct {
    double value;
    const char *text;
  } rows[] = {{0, "0.0"},
              {-0.0, "0.0"},
              {0.25, "0.25"},
              {-12, "-12.0"},
              {1.5e-7, "1.5E-7"},
              {-2e-5, "-2.0E-5"},
              {1e-4, "0.0001"},
              {0.00123, "0.00123"},
              {0.1, "0.1"},
              {1e15, "1000000000000000.0"},
              {1.25e15, "1250000000000000.0"},
              {1e16, "1.0E16"},
              {1.25e16, "1.25E16"},
              {123.456, "123.456"},
              {1234567, "1234567.0"},
              {1. / 3, "0.3333333333333333"},
              {5e-324, "5.0E-324"},
              {1.7976931348623157e308, "1.7976931348623157E308"},
              {0.30000000000000004, "0.30000000000000004"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_text text = {.arena = *state};
    lam_text_real(&text, rows[i].value);
    assert_string_equal(text.data, rows[i].text);
    assert_true(strtod(text.data, NULL) == rows[i].value);
  }
}

static void bytes_have_the_little_end_first(void **state) {
  lam_text text = {.arena = *state};
  lam_text_u16(&text, 0x1234);
  lam_text_u32(&text, 0x89abcdef);
  lam_text_f32(&text, -1.5f); /* sign 1, exponent 127, fraction 1/2: bf c0 00 00 */
  static const unsigned char bytes[] = {0x34, 0x12, 0xef, 0xcd, 0xab, 0x89, 0, 0, 0xc0, 0xbf};
  assert_int_equal(text.length, 10);
  assert_memory_equal(text.data, bytes, 10);
}

/* ---- texts ---- */

static void quoted_texts_are_one_line(void **state) {
  lam_text text = {.arena = *state};
  lam_text_quoted(&text, "a \"b\" \\ c\n\t\x1f \x7f\xc3\xa9");
  assert_string_equal(text.data, "\"a \\\"b\\\" \\\\ c \x7f\xc3\xa9\"");
}

/* Pieces of 1 to 300 bytes, across many moves of the buffer, and one that is larger than all of
 * it: the text is what was put in, and ends with a zero each time. */
static void texts_grow(void **state) {
  lam_text text = {.arena = *state};
  size_t expected = 0;
  char piece[301], *large = calloc(40001, 1);
  for (int i = 0; i < 300; i++) {
    memset(piece, 'a' + i % 26, sizeof piece);
    if (i % 2) lam_text_bytes(&text, piece, (size_t)i + 1);
    if (i % 2 == 0) lam_text_printf(&text, "%.*s", i + 1, piece);
    expected += (size_t)i + 1;
    assert_int_equal(text.length, expected);
    assert_int_equal(strlen(text.data), expected);
  }
  memset(large, 'x', 40000);
  lam_text_add(&text, large);
  free(large);
  assert_int_equal(strlen(text.data), expected + 40000);
  for (size_t i = 0, at = 0; i < 300; at += i + 1, i++)
    assert_true(text.data[at] == (char)('a' + i % 26) && text.data[at + i] == text.data[at]);
  assert_true(text.capacity < 4 * text.length); /* doubled, no more */
}

static void arrays_keep_their_items(void **state) {
  int *items = NULL, count = 0, capacity = 0;
  for (int i = 0; i < 1000; i++) LAM_APPEND((lam_arena *)*state, items, count, capacity, 3 * i);
  assert_int_equal(count, 1000);
  assert_true(capacity >= 1000 && capacity < 2100);
  for (int i = 0; i < 1000; i++) assert_int_equal(items[i], 3 * i);
}

/* ---- memory ---- */

static int closed[3], closings;
static void note_closing(void *handle) { closed[closings++] = *(int *)handle; }

/* A release closes what was deferred after the mark, the last one first, and gives the bytes out
 * again as zeros. */
static void marks_release_what_came_after(void **state) {
  lam_arena *arena = *state;
  int numbers[3] = {1, 2, 3};
  closings = 0;
  char *kept = lam_arena_copy(arena, "kept");
  lam_arena_defer(arena, note_closing, &numbers[0]);
  lam_arena_mark mark = lam_arena_mark_get(arena);
  for (int i = 1; i < 3; i++) lam_arena_defer(arena, note_closing, &numbers[i]);
  lam_arena_defer(arena, note_closing, NULL); /* nothing to close */
  char *first = lam_arena_alloc(arena, 100, 1);
  memset(first, 'x', 100);
  for (int i = 0; i < 50; i++) memset(lam_arena_alloc(arena, 3, 50000), 'y', 150000);
  lam_arena_release(arena, mark);
  assert_int_equal(closings, 2);
  assert_int_equal(closed[0], 3);
  assert_int_equal(closed[1], 2);
  assert_string_equal(kept, "kept");
  for (int i = 0; i < 50; i++) {
    char *again = lam_arena_alloc(arena, 100, 1);
    assert_int_equal((uintptr_t)again % 16, 0);
    for (int k = 0; k < 100; k++) assert_int_equal(again[k], 0);
  }
  assert_string_equal(lam_arena_printf(arena, "%s-%03d", "a", 7), "a-007");
  assert_null(lam_arena_copy(arena, NULL));
}

/* ---- messages ---- */

static void messages_keep_their_order_and_are_one_line(void **state) {
  lam_errors errors = {.arena = *state};
  assert_int_equal(lam_errors_status(&errors), LAM_OK);
  char file[] = "a.yaml";
  lam_error_add(&errors, (lam_location){file, 3, 9}, "net.grid", "given %s\n\tand %d", "x", 5);
  file[0] = 'b'; /* copied */
  lam_error_add(&errors, (lam_location){0}, NULL, "second");
  lam_error_add(&errors, (lam_location){0}, NULL, "third");
  assert_int_equal(errors.count, 3);
  assert_string_equal(errors.first->text, "given x  and 5");
  assert_string_equal(errors.first->location.file, "a.yaml");
  assert_int_equal(errors.first->location.line, 3);
  assert_int_equal(errors.first->location.column, 9);
  assert_string_equal(errors.first->key, "net.grid");
  assert_string_equal(errors.first->next->text, "second");
  assert_null(errors.first->next->key);
  assert_string_equal(errors.last->text, "third");
  assert_null(errors.last->next);
  assert_int_equal(lam_errors_status(&errors), LAM_BAD_INPUT);
  errors.status = LAM_IO;
  assert_int_equal(lam_errors_status(&errors), LAM_IO);
}

/* Edits: put in, left out, replaced, swapped with the neighbor; as many as a third of the name,
 * rounded up. The beginning of a name, from three letters on, is a guess too. */
/* Counted are all; the first 20 are kept, and one line for the others. */
static void messages_have_an_end(void **state) {
  lam_errors errors = {.arena = *state};
  int kept = 0;
  for (int i = 0; i < 16001; i++) lam_error_add(&errors, (lam_location){0}, NULL, "number %d", i);
  for (const lam_error *e = errors.first; e; e = e->next) kept++;
  assert_int_equal(errors.count, 16001);
  assert_int_equal(kept, 21);
  assert_string_equal(errors.first->text, "number 0");
  assert_string_equal(errors.last->text, "more messages are left out");
  assert_null(errors.last->next);
}

static void guesses_at_names(void **state) {
  (void)state;
  static const char *const names[] = {"enneper", "helicoid", "torus", "sphere", "asymptotic", NULL};
  static const struct {
    const char *given, *guess;
  } rows[] = {{"ennepper", "enneper"},
              {"eneper", "enneper"},
              {"ENNEPER", "enneper"},
              {"enenper", "enneper"},
              {"torsu", "torus"},
              {"tours", "torus"},
              {"spheer", "sphere"},
              {"xxheer", NULL},
              {"tor", "torus"},
              {"to", NULL},
              {"asy", "asymptotic"},
              {"asymptotik", "asymptotic"},
              {"asxmptotjk", "asymptotic"},
              {"xsxmxtxtic", "asymptotic"},
              {"xsxmxtxtix", NULL},
              {"txrxs", "torus"},
              {"txrxx", NULL},
              {"", NULL},
              {"hel", "helicoid"},
              {"helicoid surface of a kind that "
               "nobody has thought of",
               NULL},
              {"torustor", NULL},
              {"orus", "torus"},
              {"storus", "torus"}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    const char *guess = lam_did_you_mean(rows[i].given, names);
    if (!rows[i].guess && guess) fail_msg("%s: %s, expected nothing", rows[i].given, guess);
    if (rows[i].guess && (!guess || strcmp(guess, rows[i].guess) != 0))
      fail_msg("%s: %s, expected %s", rows[i].given, guess ? guess : "nothing", rows[i].guess);
  }
  static const char *const alike[] = {"abcd", "abce", NULL};
  assert_string_equal(lam_did_you_mean("abcf", alike), "abcd"); /* the first of two */
  assert_string_equal(lam_did_you_mean("abce", alike), "abce");
}

/* ---- files ---- */

typedef struct folder {
  char path[32], file[64], deep[64];
} folder;

static folder made(void) {
  folder f = {.path = "/tmp/lamella-text-XXXXXX"};
  assert_non_null(mkdtemp(f.path));
  snprintf(f.file, sizeof f.file, "%s/a", f.path);
  snprintf(f.deep, sizeof f.deep, "%s/b/c", f.path);
  return f;
}

/* Up to its limit a file is read whole, zeros included; one byte more is refused. */
static void files_are_read_up_to_their_limit(void **state) {
  folder f = made();
  lam_errors errors = {.arena = *state};
  char *bytes;
  size_t count;
  assert_int_equal(lam_file_write_atomic(f.file, "ab\0cd", 5, &errors), LAM_OK);
  assert_int_equal(lam_file_read(*state, f.file, 5, &errors, &bytes, &count), LAM_OK);
  assert_int_equal(count, 5);
  assert_memory_equal(bytes, "ab\0cd", 6);
  assert_int_equal(lam_file_read(*state, f.file, 4, &errors, &bytes, &count), LAM_BAD_INPUT);
  assert_string_equal(errors.last->text, "is larger than 4 bytes");
  assert_string_equal(errors.last->location.file, f.file);
  assert_null(bytes);
  assert_int_equal(lam_file_write_atomic(f.file, "", 0, &errors), LAM_OK); /* over an old one */
  assert_int_equal(lam_file_read(*state, f.file, 5, &errors, &bytes, &count), LAM_OK);
  assert_int_equal(count, 0);
  assert_string_equal(bytes, "");
  unlink(f.file);
  assert_int_equal(lam_file_read(*state, f.file, 5, &errors, &bytes, &count), LAM_IO);
  assert_int_equal(errors.status, LAM_IO);
  assert_string_equal(errors.last->text, "cannot be opened: No such file or directory");
  assert_int_equal(rmdir(f.path), 0); /* no temporary file is left */
}

/* A pipe says no size before: 100000 bytes come in pieces. */
static void pipes_are_read_to_their_end(void **state) {
  lam_errors errors = {.arena = *state};
  char *bytes, name[32];
  size_t count;
  FILE *program = popen("head -c 100000 /dev/zero | tr '\\0' z", "r");
  assert_non_null(program);
  snprintf(name, sizeof name, "/dev/fd/%d", fileno(program));
  assert_int_equal(lam_file_read(*state, name, 1 << 20, &errors, &bytes, &count), LAM_OK);
  pclose(program);
  assert_int_equal(count, 100000);
  assert_int_equal(strspn(bytes, "z"), 100000);
}

static void folders_are_made_from_the_top(void **state) {
  folder f = made();
  struct stat info;
  lam_errors errors = {.arena = *state};
  for (int i = 0; i < 2; i++) assert_int_equal(lam_path_make_dirs(f.deep, &errors), LAM_OK);
  assert_true(stat(f.deep, &info) == 0 && S_ISDIR(info.st_mode));
  assert_int_equal(lam_path_make_dirs("", &errors), LAM_OK);

  /* a file in the way */
  char below[80];
  rmdir(f.deep);
  assert_int_equal(lam_file_write_atomic(f.deep, "x", 1, &errors), LAM_OK);
  assert_int_equal(lam_path_make_dirs(f.deep, &errors), LAM_IO);
  assert_string_equal(errors.last->text, "is not a folder: Not a directory");
  snprintf(below, sizeof below, "%s/d", f.deep);
  assert_int_equal(lam_path_make_dirs(below, &errors), LAM_IO);
  assert_int_equal(lam_file_write_atomic(below, "x", 1, &errors), LAM_IO);
  assert_string_equal(errors.last->text, "cannot be written: Not a directory");
  assert_string_equal(errors.last->location.file, below);
  unlink(f.deep);
  *strrchr(f.deep, '/') = 0;
  rmdir(f.deep);
  assert_int_equal(rmdir(f.path), 0);
}

/* ---- reports and pictures ---- */

static void stages_collect_measures_and_notes(void **state) {
  lam_stage stage = lam_stage_begin("net");
  assert_true(stage.converged && stage.iterations == -1);
  assert_string_equal(stage.reason, "done");
  for (int i = 0; i < 20; i++)
    lam_stage_measure(*state, &stage, i % 2 ? "odd" : "even", "m", 2 * i, i, 100 + i);
  assert_int_equal(stage.measure_count, 20);
  for (int i = 0; i < 20; i++) {
    const lam_measure *m = &stage.measures[i];
    assert_string_equal(m->name, i % 2 ? "odd" : "even");
    assert_string_equal(m->unit, "m");
    assert_true(isnan(m->min) && m->max == 2 * i && m->mean == i && m->count == 100 + i);
  }
  for (int i = 0; i < 3; i++) lam_stage_note(*state, &stage, "note %d", i);
  assert_int_equal(stage.note_count, 3);
  assert_string_equal(stage.notes[2], "note 2");
}

static const lam_row_head torus = {.name = "torus"}, dome = {.name = "dome"},
                          roof = {.name = "roof"};

static void added_rows_come_last(void **state) {
  const lam_row_head *own[] = {&torus}, *more[] = {&dome, &roof};
  lam_registry registry = {"surfaces", "surface", own, 1}, other = registry;
  lam_added_rows added = {.registry = &registry, .rows = more, .count = 2};
  const lam_registry *larger = lam_registry_with(*state, &registry, &added);
  assert_int_equal(larger->count, 3);
  assert_ptr_equal(lam_registry_find(larger, "roof"), &roof);
  assert_ptr_equal(lam_registry_find(larger, "torus"), &torus);
  assert_ptr_equal(larger->rows[0], &torus);
  assert_ptr_equal(larger->rows[1], &dome);
  assert_string_equal(larger->name, "surfaces");
  assert_null(lam_registry_find(&registry, "roof"));
  assert_ptr_equal(lam_registry_with(*state, &other, &added), &other);
  assert_ptr_equal(lam_registry_with(*state, &registry, NULL), &registry);
  added.count = 0;
  assert_ptr_equal(lam_registry_with(*state, &registry, &added), &registry);
}

/* Gray of (40, 80, 120): (40 + 2 80 + 120) / 4 = 80, in the upper quarter: 192 + 20. A difference
 * of 5 counts, one of 4 does not. */
static void masks_of_pictures(void **state) {
  lam_image a = lam_image_new(*state, 3, 1), b = lam_image_new(*state, 3, 1),
            mask = lam_image_new(*state, 3, 1);
  static const unsigned char pixel[3] = {40, 80, 120};
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) a.pixels[3 * i + k] = b.pixels[3 * i + k] = pixel[k];
  b.pixels[3 + 2] = 124, b.pixels[6 + 2] = 125;
  lam_image_difference d = lam_image_compare(&a, &b, &mask);
  assert_near(d.share, 1. / 3, 1e-15);
  assert_int_equal(d.max, 5);
  assert_near(d.psnr, 10 * log10(255. * 255 * 9 / (16 + 25)), 1e-12);
  static const unsigned char expected[9] = {212, 212, 212, 212, 212, 212, 255, 0, 0};
  assert_memory_equal(mask.pixels, expected, 9);
}

/* RFC 3629, section 3 and 10: the ends of each length; overlong forms, surrogates, numbers above
 * 10FFFF and cut-off sequences are none. Quoted, each wrong byte becomes a question mark. */
static void only_utf8_is_a_character(void **state) {
  static const struct {
    const char *text;
    int size;
  } cases[] = {{"", 0},
               {"a", 1},
               {"\x7f", 1},
               {"\xc2\x80", 2},
               {"\xdf\xbf", 2},
               {"\xe0\xa0\x80", 3},
               {"\xef\xbf\xbd", 3},
               {"\xf0\x90\x80\x80", 4},
               {"\xf4\x8f\xbf\xbf", 4},
               {"\xc0\x80", 0},
               {"\xc1\xbf", 0},
               {"\xe0\x9f\xbf", 0},
               {"\xed\xa0\x80", 0},
               {"\xef\xbf\xbe", 0},
               {"\xef\xbf\xbf", 0},
               {"\xf4\x90\x80\x80", 0},
               {"\x80", 0},
               {"\xff", 0},
               {"\xe2\x82", 0}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_int_equal(lam_utf8_size(cases[i].text), cases[i].size);

  lam_text text = {.arena = *state};
  lam_text_quoted(&text, "\xe2\x82\xac\xff\xe2\x82");
  assert_string_equal(text.data, "\"\xe2\x82\xac???\"");
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(numbers_have_no_zeros_at_their_end),
      TEST(reals_read_back),
      TEST(bytes_have_the_little_end_first),
      TEST(quoted_texts_are_one_line),
      TEST(only_utf8_is_a_character),
      TEST(texts_grow),
      TEST(arrays_keep_their_items),
      TEST(marks_release_what_came_after),
      TEST(messages_keep_their_order_and_are_one_line),
      TEST(messages_have_an_end),
      TEST(guesses_at_names),
      TEST(files_are_read_up_to_their_limit),
      TEST(pipes_are_read_to_their_end),
      TEST(folders_are_made_from_the_top),
      TEST(stages_collect_measures_and_notes),
      TEST(added_rows_come_last),
      TEST(masks_of_pictures),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
