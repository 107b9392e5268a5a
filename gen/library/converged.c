/* Whether a report is good as a whole. Called through lamella/design.h, by cli/verb_build.c, and by
 * sources.c for designs that others start from. */
#include <lamella/design.h>

/* Stages that do not iterate are converged unless they failed. */
bool lam_report_converged(const lam_report *report) {
  for (int i = 0; i < report->stage_count; i++)
    if (!report->stages[i].converged) return false;
  return true;
}
