/* Room on the face of a strip, and what is written there. */
#include "fab/flat/face.h"
#include "fab/flat/lettering.h"
#include "tests/unit/asserts.h"

/* A straight strip of 2 m x 0.1 m: its margin is 4 mm. */
static const lam_vec2 ends[2] = {{0, 0}, {2, 0}};
static lam_axis axis;

static lam_face face_of(lam_arena *arena) {
  axis = lam_axis_make(arena, ends, 2);
  return lam_face_make(arena, &axis, 0, 2, 0.1);
}

static void assert_box(lam_face_box box, double low, double high, double bottom, double top) {
  if (!(fabs(box.low - low) < 1e-7 && fabs(box.high - high) < 1e-7 &&
        fabs(box.bottom - bottom) < 1e-7 && fabs(box.top - top) < 1e-7))
    fail_msg("the box is %.7f to %.7f, %.7f to %.7f; expected %.7f to %.7f, %.7f to %.7f", box.low,
             box.high, box.bottom, box.top, low, high, bottom, top);
}

/* A fifth of the strip, at most 20 mm; then smaller step by step, down to a tenth. */
static void letters_shrink_with_the_strip(void **state) {
  (void)state;
  assert_near(lam_letter_height(0.05), 0.01, 1e-17);
  assert_near(lam_letter_height(0.3), 0.02, 0);
  assert_near(lam_letter_steps[0], 1, 0);
  for (int i = 1; i < lam_letter_step_count; i++)
    assert_true(lam_letter_steps[i] < lam_letter_steps[i - 1]);
  assert_near(lam_letter_steps[lam_letter_step_count - 1], 0.1, 0);
}

/* 4 mm are free along all four edges; the taken box 1 m to 1.2 m, -10 mm to 10 mm, keeps them too.
 */
static void margins_are_kept_free(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_face face = face_of(arena);
  static const struct {
    lam_face_box box;
    bool free;
  } cases[] = {
      {{.004, 1.996, -.046, .046}, true}, {{.0039, 1, 0, .01}, false},
      {{1.5, 1.9961, 0, .01}, false},     {{.5, .6, -.0461, 0}, false},
      {{.5, .6, 0, .0461}, false},
  };
  static const struct {
    lam_face_box box;
    bool free;
  } beside[] = {{{.9, .9959, -.01, .01}, true},    {{.9, .9961, -.01, .01}, false},
                {{1.2041, 1.3, -.01, .01}, true},  {{1.2039, 1.3, -.01, .01}, false},
                {{1, 1.2, .0141, .03}, true},      {{1, 1.2, .0139, .03}, false},
                {{1, 1.2, -.03, -.0141}, true},    {{1, 1.2, -.03, -.0139}, false},
                {{1.05, 1.1, -.005, .005}, false}, {{.9, 1.3, -.03, .03}, false}};
  assert_near(face.margin, .004, 1e-17);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    if (lam_face_is_free(&face, cases[i].box) != cases[i].free) fail_msg("case %zu", i);
  lam_face_take(&face, (lam_face_box){1, 1.2, -.01, .01});
  assert_int_equal(face.taken_count, 1);
  for (size_t i = 0; i < sizeof beside / sizeof *beside; i++)
    if (lam_face_is_free(&face, beside[i].box) != beside[i].free) fail_msg("beside %zu", i);
  lam_arena_free(arena);
}

/* A box of 100 mm x 20 mm, past what is in its way: it comes to stand a margin away. */
static void boxes_slide_to_the_first_free_place(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_face face = face_of(arena);
  lam_face_box box;
  const double middle[1] = {0.01};
  lam_face_take(&face, (lam_face_box){.05, .3, -.05, .05});
  lam_face_take(&face, (lam_face_box){.35, .4, -.05, .05}); /* 50 mm between are too few */
  lam_face_take(&face, (lam_face_box){1.7, 1.8, -.05, .05});
  assert_true(lam_face_find(&face, .1, .02, .004, 1, middle, 1, &box));
  assert_box(box, .404, .504, 0, .02);
  assert_true(lam_face_find(&face, .1, .02, .004, .504001, middle, 1, &box));
  assert_false(lam_face_find(&face, .1, .02, .004, .5, middle, 1, &box));
  assert_true(lam_face_find(&face, .1, .02, 1.996, 1, middle, 1, &box));
  assert_box(box, 1.896, 1.996, 0, .02);
  assert_true(lam_face_find(&face, .1, .02, 1.9, 1, middle, 1, &box));
  assert_box(box, 1.596, 1.696, 0, .02);
  assert_false(lam_face_find(&face, .1, .02, 1.9, 1.6, middle, 1, &box));
  assert_false(lam_face_find(&face, .1, .1, .004, 1, middle, 1, &box)); /* too high */
  /* exactly as wide as the way (in binary) */
  assert_true(lam_face_find(&face, .125, .02, .5, .625, middle, 1, &box));
  assert_true(lam_face_find(&face, .125, .02, .625, .5, middle, 1, &box));
  assert_box(box, .5, .625, 0, .02);
  lam_arena_free(arena);
}

/* The middle is blocked as far as 0.3 m. The second center wins when that saves more than a quarter
 * of the width (of 100 mm), and the first one otherwise. */
static void a_later_center_must_come_nearer(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const double centers[2] = {0, -.03};
  for (int k = 0; k < 2; k++) {
    lam_face face = face_of(arena);
    lam_face_box box;
    double blocked = k ? .03 : .02;
    lam_face_take(&face, (lam_face_box){0, blocked, -.012, .012});
    assert_true(lam_face_find(&face, .1, .02, .004, 1, centers, 2, &box));
    if (k) /* 34 mm on, against 4 mm: 30 mm are saved */
      assert_box(box, .004, .104, -.04, -.02);
    else /* 24 mm on: 20 mm would be saved */
      assert_box(box, .024, .124, -.01, .01);
  }
  lam_arena_free(arena);
}

/* Letters of 20 mm, 6 mm of frame around them. */
static void names_are_framed_at_both_ends(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_face face = face_of(arena);
  lam_paths paths = {.arena = arena};
  const double centers[1] = {.01};
  double width = lam_lettering_width("LL", .02) + .012;
  for (int end = 0; end < 2; end++) {
    int first = paths.count;
    assert_true(lam_face_name(&face, &paths, "LL", end == 0, centers, 1));
    double low = end ? 1.996 - width : .004;
    const lam_path *frame = &paths.items[first], *letter = frame + 1;
    assert_int_equal(paths.count, first + 3);
    assert_true(frame->layer == LAM_LAYER_ENGRAVE && frame->closed && frame->count == 4);
    assert_box((lam_face_box){frame->points[0].x, frame->points[2].x, frame->points[0].y,
                              frame->points[2].y},
               low, low + width, -.006, .026);
    assert_near(frame->points[1].x - frame->points[0].x, width, 1e-9);
    assert_near(frame->points[3].y - frame->points[0].y, .032, 1e-9);
    assert_int_equal(letter->layer, LAM_LAYER_LABEL);
    assert_near(letter->points[1].x, low + .006, 1e-7); /* the corner of the L */
    assert_near(letter->points[1].y, 0, 1e-12);
    assert_near(letter->points[0].y, .02, 1e-12);
    assert_int_equal(face.taken_count, end + 1);
    assert_box(face.taken[end], low, low + width, -.006, .026);
  }
  lam_arena_free(arena);
}

/* No further than the middle (1 m), and six heights (0.6 m), from the end; smaller where large ones
 * do not fit. */
static void names_stay_near_their_end(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths paths = {.arena = arena};
  const double centers[1] = {0};
  double width = lam_lettering_width("LL", .002) + .0012; /* at a tenth of the size */
  /* {the face is free from, it is found at a tenth of the size} */
  const struct {
    double low, high, from;
    bool found;
  } cases[] = {{0, 2, .604 - width - .005, true},
               {0, 2, .604 - width + .001, false},
               {0, .4, .2 - width - .005, true},
               {0, .4, .2 - width + .001, false}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    axis = lam_axis_make(arena, ends, 2);
    lam_face face = lam_face_make(arena, &axis, cases[i].low, cases[i].high, .1);
    lam_face_take(&face, (lam_face_box){0, cases[i].from, -.05, .05});
    int before = paths.count;
    if (lam_face_name(&face, &paths, "LL", true, centers, 1) != cases[i].found)
      fail_msg("case %zu", i);
    assert_int_equal(paths.count, before + (cases[i].found ? 3 : 0));
  }
  /* A slit of 9 mm between edge and a taken box: with margins 1 mm is left, so letters of .6 mm
   * would do, and 2 mm, the smallest, do not. 20 mm of room take 12 mm: letters of 7 mm, .35 of
   * 20 mm. */
  lam_face low = lam_face_make(arena, &axis, 0, 2, .1);
  lam_face_take(&low, (lam_face_box){0, 2, -.05, .03});
  const double top[1] = {.04};
  assert_true(lam_face_name(&low, &paths, "LL", true, top, 1));
  assert_near(low.taken[1].top - low.taken[1].bottom, 1.6 * .02 * .35, 1e-12);
  lam_arena_free(arena);
}

/* Strokes and letters follow the axis: 3 m along x, then along y; there left is -x. */
static void strokes_bend_with_the_axis(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  static const lam_vec2 bent[3] = {{0, 0}, {3, 0}, {3, 4}};
  axis = lam_axis_make(arena, bent, 3);
  lam_face face = lam_face_make(arena, &axis, 0, 7, 1);
  lam_paths paths = {.arena = arena};
  const lam_vec2 stroke[3] = {{0, .5}, {7, .5}, {8, -1}};
  lam_face_stroke(&face, &paths, LAM_LAYER_ENGRAVE, true, stroke, 3);
  assert_true(paths.items[0].closed && paths.items[0].layer == LAM_LAYER_ENGRAVE);
  const lam_vec2 expected[3] = {{0, .5}, {2.5, 4}, {4, 5}};
  for (int i = 0; i < 3; i++) {
    assert_near(paths.items[0].points[i].x, expected[i].x, 1e-15);
    assert_near(paths.items[0].points[i].y, expected[i].y, 1e-15);
  }
  lam_face_text(&face, &paths, LAM_LAYER_LABEL, "I", 7, 0, .9); /* beyond the end, along y */
  const lam_path *foot = &paths.items[1]; /* from 0 to 2 of 9 parts, .8 as wide: 0.16 m */
  assert_int_equal(foot->layer, LAM_LAYER_LABEL);
  assert_near(foot->points[0].x, 3, 1e-12);
  assert_near(foot->points[0].y, 4, 1e-12);
  assert_near(foot->points[1].x, 3, 1e-12);
  assert_near(foot->points[1].y, 4.16, 1e-12);
  assert_near(paths.items[2].points[0].x, 2.1, 1e-12); /* the top, 0.9 m to the left */
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(letters_shrink_with_the_strip),
      cmocka_unit_test(margins_are_kept_free),
      cmocka_unit_test(boxes_slide_to_the_first_free_place),
      cmocka_unit_test(a_later_center_must_come_nearer),
      cmocka_unit_test(names_are_framed_at_both_ends),
      cmocka_unit_test(names_stay_near_their_end),
      cmocka_unit_test(strokes_bend_with_the_axis),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
