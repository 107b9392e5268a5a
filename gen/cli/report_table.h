/* The report as a short table for a person. Called by verb_build.c and verb_measure.c. */
#ifndef LAM_CLI_REPORT_TABLE_H
#define LAM_CLI_REPORT_TABLE_H

#include <lamella/model.h>
#include <stdio.h>

/* Writes all stages of a report to out. timings: with the seconds of every stage. */
void lam_report_print(const lam_report *report, bool timings, FILE *out);
/* Writes count measures alone, a line each, indented by two. */
void lam_measures_print(const lam_measure *measures, int count, FILE *out);
/* Prints a line for every stage that did not converge or failed: what stays to be said when the
 * rest is not wanted. */
void lam_report_print_failed(const lam_report *report, FILE *out);

#endif
