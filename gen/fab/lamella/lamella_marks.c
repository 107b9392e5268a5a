/* What is written on the flat pattern of a lamella: ticks and partners' names at crossings, its
 * own name, its family and which way is up. Called by lamella_flat.c. */
#include "fab/flat/face.h"
#include "fab/flat/lettering.h"
#include "fab/lamella/lamella_flat.h"

#include <math.h>

/* What is written on one strip. */
typedef struct writer {
  lam_face face;
  const lam_flat *flat;
  lam_paths *paths;
  double free_half; /* middle of the half without slots, across */
  /* Where else to write, across, best first: away from the partners' names, which go to the free
   * half. */
  double rows[3];
} writer;

/* Ticks stand where the partner's middle line crosses, in the half without slots, a margin away
 * from floor and edge. Slots and ticks are taken from the face. */
static void draw_ticks(writer *marks) {
  double half = marks->flat->height / 2, margin = marks->face.margin;
  for (int i = 0; i < marks->flat->slot_count; i++) {
    const lam_flat_slot *slot = &marks->flat->slots[i];
    bool open_up = slot->top >= half;
    double bottom = open_up ? -half + margin : slot->top + margin,
           top = open_up ? slot->bottom - margin : half - margin;

    double s = slot->at;
    lam_face_take(&marks->face, (lam_face_box){slot->low, slot->high, slot->bottom, slot->top});

    if (top <= bottom) continue;
    lam_face_stroke(&marks->face, marks->paths, LAM_LAYER_ENGRAVE, false,
                    (lam_vec2[]){{s, bottom}, {s, top}}, 2);
    lam_face_take(&marks->face, (lam_face_box){s, s, bottom, top});
  }
}

/* Finds room for a partner's name of the given size right of its tick, or else left of it, takes
 * it, and returns its box. False when there is none. */
static bool place_partner(writer *marks, const char *name, double tick, double size,
                          lam_face_box *box) {
  double width = lam_lettering_width(name, size),
         space = fmax(0.5 * size, 1.001 * marks->face.margin);

  for (int side = 0; side < 2; side++) {
    double low = side == 0 ? tick + space : tick - space - width;
    *box =
        (lam_face_box){low, low + width, marks->free_half - size / 2, marks->free_half + size / 2};

    if (!lam_face_is_free(&marks->face, *box)) continue;
    lam_face_take(&marks->face, *box);
    return true;
  }
  return false;
}

/* All partners' names at the largest size at which every one fits; at the smallest size those
 * that do. names: one per slot. */
static void write_partners(writer *marks, const char *const *names) {
  int n = marks->flat->slot_count, before = marks->face.taken_count;
  lam_face_box *boxes = LAM_NEW(marks->face.arena, lam_face_box, n);
  bool *fits = LAM_NEW(marks->face.arena, bool, n);

  for (int i = 0; i < lam_letter_step_count; i++) {
    double size = lam_letter_height(marks->flat->height) * lam_letter_steps[i];
    /* Every size begins with the room that was free before the names. */
    int fit = 0;
    marks->face.taken_count = before;
    for (int k = 0; k < n; k++) {
      fits[k] = place_partner(marks, names[k], marks->flat->slots[k].at, size, &boxes[k]);
      fit += fits[k];
    }

    if (fit < n && i + 1 < lam_letter_step_count) continue;
    for (int k = 0; k < n; k++)
      if (fits[k])
        lam_face_text(&marks->face, marks->paths, LAM_LAYER_LABEL, names[k], boxes[k].low,
                      boxes[k].bottom, size);
    return;
  }
}

/* Symbol of the family, arrow and words, in a box of height `size` whose lower left corner is (s,
 * h). All strokes are given for the size 1. */
static void draw_sign(writer *marks, int family, const char *words, double s, double h,
                      double size) {
  static const lam_vec2 triangle[] = {{0, 0}, {1, 0}, {0.5, 1}},
                        square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  static const lam_vec2 shaft[] = {{1.7, 0}, {1.7, 1}}, head[] = {{1.4, 0.6}, {1.7, 1}, {2, 0.6}};
  const struct {
    const lam_vec2 *points;
    int count;
    bool closed;
  } strokes[] = {{family == 1 ? square : triangle, family == 1 ? 4 : 3, true},
                 {shaft, 2, false},
                 {head, 3, false}};

  for (int i = 0; i < 3; i++) {
    lam_vec2 points[4];
    for (int k = 0; k < strokes[i].count; k++)
      points[k] = lam_v2(s + size * strokes[i].points[k].x, h + size * strokes[i].points[k].y);
    lam_face_stroke(&marks->face, marks->paths, LAM_LAYER_ENGRAVE, strokes[i].closed, points,
                    strokes[i].count);
  }

  lam_face_text(&marks->face, marks->paths, LAM_LAYER_ENGRAVE, words, s + 2.6 * size, h, size);
}

/* The sign of the family near the start of the strip, at the largest size that fits; letters are
 * .8 of those of names. It is left out where it fits at no size. */
static void write_sign(writer *marks, int family, bool pair) {
  const lam_face *face = &marks->face;
  const char *words = pair ? "UP OUT" : "UP";
  for (int i = 0; i < lam_letter_step_count; i++) {
    double size = 0.8 * lam_letter_height(face->height) * lam_letter_steps[i];
    double width = 2.6 * size + lam_lettering_width(words, size);

    double from = face->low + face->margin,
           reach = fmin((face->high - face->low) / 2, 10 * face->height);
    lam_face_box box;
    if (!lam_face_find(face, width, size, from, from + reach, marks->rows, 3, &box)) continue;

    draw_sign(marks, family, words, box.low, box.bottom, size);
    lam_face_take(&marks->face, box);
    return;
  }
}

/* What matters most finds room first: ticks, the own name at both ends, partners, the sign. */
void lam_flat_marks(lam_arena *arena, const lam_flat *flat, const char *name, int family, bool pair,
                    const char *const *names, lam_paths *paths) {
  lam_axis axis = lam_axis_make(arena, flat->axis, flat->axis_count);
  double free_half = (family == 1 ? 1 : -1) * flat->height / 4;
  writer marks = {lam_face_make(arena, &axis, 0, axis.length, flat->height),
                  flat,
                  paths,
                  free_half,
                  {-free_half, 0, free_half}};

  draw_ticks(&marks);

  /* Names stand away from the free half when they can: it is kept for the partners. */
  for (int end = 0; end < 2; end++)
    if (!lam_face_name(&marks.face, paths, name, end == 0, marks.rows, 2))
      lam_face_name(&marks.face, paths, name, end == 0, marks.rows + 2, 1);

  write_partners(&marks, names);
  write_sign(&marks, family, pair);
}
