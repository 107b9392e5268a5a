/* Which strips are the same flat part. A strip is described by where its slots begin and end
 * along its length, and by the side on which they open. Turning a strip over about its height
 * direction swaps its ends and keeps the side, so a strip equals another one forwards or
 * backwards. Called by lamella.c, which numbers parts with it. */
#include "fab/lamella/lamella_make.h"

static const double tolerance = 1e-4; /* meters */

/* Begin and end of every slot and then the length, in meters, measured from the start, or from
 * the end when reversed. marks has room for 2 station_count + 1 numbers. Returns how many there
 * are. */
static int describe(const lam_lamella_grid *grid, const lam_sheet_strip *strip, bool reversed,
                    double *marks) {
  int count = 0, n = strip->station_count;
  for (int i = 0; i < n; i++) {
    const lam_station *q = &strip->stations[reversed ? n - 1 - i : i];
    if (q->partner < 0) continue;

    double low, high;
    lam_station_extent(grid, q, &low, &high);
    marks[count++] = reversed ? strip->length - q->s - high : q->s + low;
    marks[count++] = reversed ? strip->length - q->s - low : q->s + high;
  }
  marks[count++] = strip->length;
  return count;
}

/* Whether two descriptions of the same count agree to the tolerance. */
static bool agree(const double *a, const double *b, int count) {
  for (int i = 0; i < count; i++)
    if (fabs(a[i] - b[i]) > tolerance) return false;
  return true;
}

/* Compares every strip with the first one of every class so far, both ways around. */
int lam_lamella_classes(lam_arena *arena, const lam_lamella_grid *grid, int first, int *class) {
  int n = grid->strip_count, classes = 0, *sample = LAM_NEW(arena, int, n),
      *count = LAM_NEW(arena, int, n);
  double **marks = LAM_NEW(arena, double *, n);

  for (int i = 0; i < n; i++) {
    const lam_sheet_strip *strip = &grid->strips[i];
    int most = 2 * strip->station_count + 1, k = 0;
    double *back = LAM_NEW(arena, double, most);
    marks[i] = LAM_NEW(arena, double, most);
    count[i] = describe(grid, strip, false, marks[i]);
    describe(grid, strip, true, back);

    for (; k < classes; k++) {
      int s = sample[k];
      if (grid->strips[s].family == strip->family && count[s] == count[i] &&
          (agree(marks[s], marks[i], count[i]) || agree(marks[s], back, count[i])))
        break;
    }

    if (k == classes) sample[classes++] = i;
    class[i] = first + k;
  }
  return classes;
}
