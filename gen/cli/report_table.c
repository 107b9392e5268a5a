/* Reports and measures as text. Called by verb_build.c and verb_measure.c. */
#include "cli/report_table.h"

#include <math.h>
#include <string.h>

/* A word and its number in 16 columns, blank for a number that a stage does not keep. */
static void print_number(const char *word, double value, FILE *out) {
  char number[32] = "";
  if (!isnan(value)) snprintf(number, sizeof number, "%s %.5g", word, value);
  fprintf(out, "%-15s ", number);
}

/* The numbers of a measure that has some: a count or a sum alone, or all with their unit. */
static void print_numbers(const lam_measure *m, FILE *out) {
  if (strcmp(m->unit, LAM_UNIT_COUNT) == 0) {
    fprintf(out, "%.0f\n", m->max);
    return;
  }
  if (isnan(m->min) && m->mean == m->max) {
    fprintf(out, "%.6g%s%s\n", m->max, *m->unit ? " " : "", m->unit);
    return;
  }
  print_number("min", m->min, out);
  print_number("mean", m->mean, out);
  print_number("max", m->max, out);
  fprintf(out, "count %ld%s%s\n", m->count, *m->unit ? "  " : "", m->unit);
}

/* A line per measure; "undefined" for one that no element has a value of, or that has a value that
 * is not a number. */
void lam_measures_print(const lam_measure *measures, int count, FILE *out) {
  for (int i = 0; i < count; i++) {
    const lam_measure *m = &measures[i];
    fprintf(out, "  %-26s ", m->name);
    if (isnan(m->max))
      fprintf(out, "undefined\n");
    else
      print_numbers(m, out);
  }
}

/* A line per stage with its verdict, its measures and notes under it. */
void lam_report_print(const lam_report *report, bool timings, FILE *out) {
  for (int i = 0; i < report->stage_count; i++) {
    const lam_stage *stage = &report->stages[i];
    fprintf(out, "%s", stage->name);

    /* A stage that does not iterate has nothing to say when all is well. */
    if (stage->iterations >= 0)
      fprintf(out, ": %s%s, %d iterations, residual %.1e",
              stage->converged ? "" : "NOT CONVERGED: ", stage->reason, stage->iterations,
              stage->residual);
    else if (!stage->converged)
      fprintf(out, ": FAILED: %s", stage->reason);
    if (timings && stage->seconds > 0) fprintf(out, " (%.2f s)", stage->seconds);
    fputc('\n', out);

    lam_measures_print(stage->measures, stage->measure_count, out);
    for (int k = 0; k < stage->note_count; k++) fprintf(out, "  %s\n", stage->notes[k]);
  }
}

/* In the order in which they ran: the net comes before the parts that do not fit it. */
void lam_report_print_failed(const lam_report *report, FILE *out) {
  for (int i = 0; i < report->stage_count; i++) {
    const lam_stage *stage = &report->stages[i];
    if (!stage->converged)
      fprintf(out, "lamella: %s: %s: %s\n", stage->name,
              stage->iterations >= 0 ? "not converged" : "failed", stage->reason);
  }
}
