/* Room on the face of a strip: taken boxes, the search for a free one, and strokes and texts
 * bent with the axis. Called by fab/flat/splice.c and fab/lamella/lamella_marks.c. */
#include "fab/flat/face.h"
#include "core/grow.h"
#include "fab/flat/lettering.h"

#include <math.h>

const double lam_letter_steps[] = {1, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1};
const int lam_letter_step_count = sizeof lam_letter_steps / sizeof *lam_letter_steps;

double lam_letter_height(double strip_height) { return fmin(strip_height / 5, 0.020); }

/* The margin is a share of the height, for letters are too. */
lam_face lam_face_make(lam_arena *arena, const lam_axis *axis, double low, double high,
                       double height) {
  return (lam_face){.arena = arena,
                    .axis = axis,
                    .low = low,
                    .high = high,
                    .height = height,
                    .margin = height * 0.04};
}

void lam_face_take(lam_face *face, lam_face_box box) {
  LAM_APPEND(face->arena, face->taken, face->taken_count, face->taken_capacity, box);
}

/* The first taken box that comes nearer to box than the margin, or NULL. */
static const lam_face_box *in_the_way(const lam_face *face, lam_face_box box) {
  double m = face->margin;
  for (int i = 0; i < face->taken_count; i++) {
    const lam_face_box *taken = &face->taken[i];
    if (box.low < taken->high + m && taken->low < box.high + m && box.bottom < taken->top + m &&
        taken->bottom < box.top + m)
      return taken;
  }
  return NULL;
}

/* Whether a box keeps the margin from the ends and the edges; rounding is forgiven. */
static bool inside(const lam_face *face, lam_face_box box) {
  double m = face->margin * (1 - 1e-9), half = face->height / 2;
  return box.low >= face->low + m && box.high <= face->high - m && box.bottom >= -half + m &&
         box.top <= half - m;
}

bool lam_face_is_free(const lam_face *face, lam_face_box box) {
  return inside(face, box) && !in_the_way(face, box);
}

/* Slides a box along the strip from `from` towards `to`, past everything in its way, to the
 * first free position. False when it passes `to`, or when that position is not inside the
 * strip. */
static bool slide(const lam_face *face, double width, double height, double from, double to,
                  double center, lam_face_box *box) {
  bool onward = to >= from;
  double low = onward ? from : from - width, step = face->margin * 1.000001;
  for (;;) {
    *box = (lam_face_box){low, low + width, center - height / 2, center + height / 2};
    if (onward ? box->high > to : box->low < to) return false;

    const lam_face_box *taken = in_the_way(face, *box);
    if (!taken) return inside(face, *box);
    low = onward ? taken->high + step : taken->low - step - width;
  }
}

/* One slide per center; see the header for which one wins. */
bool lam_face_find(const lam_face *face, double width, double height, double from, double to,
                   const double *centers, int center_count, lam_face_box *box) {
  bool found = false;
  for (int i = 0; i < center_count; i++) {
    lam_face_box candidate;
    if (!slide(face, width, height, from, to, centers[i], &candidate)) continue;
    if (found && fabs(candidate.low - from) > fabs(box->low - from) - width / 4) continue;
    *box = candidate;
    found = true;
  }
  return found;
}

/* Added as it is, then bent point by point. */
void lam_face_stroke(const lam_face *face, lam_paths *paths, lam_layer layer, bool closed,
                     const lam_vec2 *points, int count) {
  lam_path *path = lam_paths_add(paths, layer, closed, count, points);
  for (int i = 0; i < count; i++)
    path->points[i] = lam_axis_point(face->axis, points[i].x, points[i].y, NULL);
}

/* The text is lettered along the x axis first, then bent point by point. */
void lam_face_text(const lam_face *face, lam_paths *paths, lam_layer layer, const char *text,
                   double s, double h, double height) {
  int first = paths->count;
  lam_lettering_add(paths, layer, text, lam_v2(s, h), 0, height);
  for (int i = first; i < paths->count; i++)
    for (int k = 0; k < paths->items[i].count; k++) {
      lam_vec2 *point = &paths->items[i].points[k];
      *point = lam_axis_point(face->axis, point->x, point->y, NULL);
    }
}

/* Sizes are tried from the largest; the frame is the box of the text and a pad of .3 of its
 * size. */
bool lam_face_name(lam_face *face, lam_paths *paths, const char *name, bool at_start,
                   const double *centers, int center_count) {
  double low = face->low + face->margin, high = face->high - face->margin,
         middle = (low + high) / 2;
  for (int i = 0; i < lam_letter_step_count; i++) {
    double size = lam_letter_height(face->height) * lam_letter_steps[i], pad = 0.3 * size;
    double width = lam_lettering_width(name, size) + 2 * pad;

    double from = at_start ? low : high, reach = fmin(fabs(middle - from), 6 * face->height);
    lam_face_box box;
    if (!lam_face_find(face, width, size + 2 * pad, from, at_start ? from + reach : from - reach,
                       centers, center_count, &box))
      continue;

    lam_vec2 frame[4] = {
        {box.low, box.bottom}, {box.high, box.bottom}, {box.high, box.top}, {box.low, box.top}};
    lam_face_stroke(face, paths, LAM_LAYER_ENGRAVE, true, frame, 4);
    lam_face_text(face, paths, LAM_LAYER_LABEL, name, box.low + pad, box.bottom + pad, size);
    lam_face_take(face, box);
    return true;
  }
  return false;
}
