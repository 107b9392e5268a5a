/* Reports and measures as text. Called by verb_build.c and verb_measure.c. */
#include "cli/report_table.h"

#include <math.h>
#include <string.h>

/* A word and a number in 16 columns, blank when nobody has kept the number. */
static void print_value(const char *word, double value, FILE *out) {
  if (isnan(value))
    fprintf(out, "%-*s ", (int)strlen(word) + 12, "");
  else
    fprintf(out, "%s %-11.5g ", word, value);
}

/* A line per measure; "undefined" for one that no element has a value of. What is one number, such
 * as a count or a sum, has neither mean nor maximum. */
void lam_measures_print(const lam_measure *measures, int count, FILE *out) {
  for (int i = 0; i < count; i++) {
    const lam_measure *m = &measures[i];
    fprintf(out, "  %-26s ", m->name);
    if (m->count == 0 && isnan(m->max)) {
      fprintf(out, "undefined\n");
      continue;
    }

    if (isnan(m->min) && m->mean == m->max) {
      fprintf(out, "%.6g%s%s\n", m->max, *m->unit ? " " : "", m->unit);
      continue;
    }
    print_value("min", m->min, out);
    print_value("mean", m->mean, out);
    print_value("max", m->max, out);
    fprintf(out, "count %ld%s%s\n", m->count, *m->unit ? "  " : "", m->unit);
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
