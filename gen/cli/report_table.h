/* The report as a short table for a person. */
#ifndef LAM_CLI_REPORT_TABLE_H
#define LAM_CLI_REPORT_TABLE_H

#include <lamella/model.h>
#include <stdio.h>

/* timings: with the seconds of every stage. */
void lam_report_print(const lam_report *report, bool timings, FILE *out);
/* Measures alone, indented by two. */
void lam_measures_print(const lam_measure *measures, int count, FILE *out);

#endif
