#include "cli/report_table.h"

void lam_measures_print(const lam_measure *measures, int count, FILE *out) {
  for (int i = 0; i < count; i++) {
    const lam_measure *m = &measures[i];
    fprintf(out, "  %-26s max %-12.5g mean %-12.5g %s\n", m->name, m->max, m->mean, m->unit);
  }
}

void lam_report_print(const lam_report *report, FILE *out) {
  for (int i = 0; i < report->stage_count; i++) {
    const lam_stage *stage = &report->stages[i];
    fprintf(out, "%s", stage->name);
    if (stage->iterations >= 0)
      fprintf(out, ": %s%s, %d iterations, residual %.1e", stage->converged ? "" : "NOT CONVERGED: ", stage->reason,
              stage->iterations, stage->residual);
    else if (!stage->converged)
      fprintf(out, ": FAILED: %s", stage->reason);
    if (stage->seconds > 0) fprintf(out, " (%.2f s)", stage->seconds);
    fputc('\n', out);
    lam_measures_print(stage->measures, stage->measure_count, out);
    for (int k = 0; k < stage->note_count; k++) fprintf(out, "  %s\n", stage->notes[k]);
  }
}
