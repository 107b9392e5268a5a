/* lamella build DESIGN: from a design file to a folder of files. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/report_table.h"
#include "cli/terminal.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/lamella.h>

#include <stdio.h>

static const char usage[] =
    "usage: lamella build DESIGN.yaml [-o DIR] [--set KEY=VALUE]... [--only|--skip FORMAT,...] "
    "[--picture QUALITY] [--deps FILE] [--quiet] [--timings]\n"
    "  -o DIR           the folder for the files (default: the design's name)\n"
    "  --set KEY=VALUE  overrides a key of the design, as in --set net.grid=[40,40]\n"
    "  --only FORMATS   writes only these formats (see lamella list formats); png brings pov\n"
    "  --skip FORMATS   writes all formats but these\n"
    "  --picture QUALITY  of the picture, in place of render.quality: draft (seconds), middle,\n"
    "                   final (minutes), print\n"
    "  --deps FILE      writes a make rule: what DIR/report.json was made from\n"
    "  --quiet          prints errors only\n"
    "  --timings        adds the seconds of every stage to the report";

/* Prints the report of a model and what became of its files. */
static void tell_result(const lam_model *model, const lam_written *written,
                        const lam_write_options *options) {
  lam_report_print(model->report, options->timings, stdout);
  printf("%d files in %s\n", written->file_count, options->folder);
  if (written->removed)
    printf("%d files of the last build, which this one does not make, were removed\n",
           written->removed);
}

/* Writes the model and returns the exit status: 2 when the request is wrong, 1 when a stage did not
 * converge, when a file that was asked for is missing or when writing fails. */
static int write_model(lam_session *session, const lam_model *model,
                       const lam_write_options *options, bool quiet) {
  lam_written written;
  lam_status status = lam_model_write(session, model, options, &written);
  for (const lam_error *note = lam_session_notes(session); note; note = note->next)
    fprintf(stderr, "lamella: %s\n", note->text);

  if (status != LAM_OK) {
    int told = lam_verb_status(session, status);
    return status == LAM_BAD_INPUT ? told : 1;
  }
  if (quiet)
    lam_report_print_failed(model->report, stderr);
  else
    tell_result(model, &written, options);
  return lam_report_converged(model->report) && !written.left_out ? 0 : 1;
}

/* Builds the model and writes it, told about at the terminal. Returns the exit status. */
static int build_design(lam_session *session, const lam_design *design, lam_write_options *options,
                        bool quiet) {
  lam_terminal terminal;
  lam_progress progress = lam_terminal_progress(&terminal, quiet);
  lam_session_set_progress(session, &progress);

  const lam_model *model;
  lam_status built = lam_design_build(session, design, &model);
  if (built != LAM_OK) {
    lam_terminal_clear(&progress);
    return lam_verb_status(session, built);
  }

  if (!options->folder) options->folder = lam_design_name(design);
  return write_model(session, model, options, quiet);
}

/* Everything that is wrong with the request is said before anything is computed. */
static int build(lam_session *session, int argc, char **argv) {
  const char *overrides[argc], *path, *quality = NULL; /* no more overrides than arguments */
  bool quiet = false;
  lam_design_source source = {.overrides = overrides};
  lam_write_options options = {0};
  const lam_option table[] = {{"-o", .value = &options.folder},
                              {"--set", .values = overrides, .count = &source.override_count},
                              {"--only", .value = &options.only},
                              {"--skip", .value = &options.skip},
                              {"--picture", .value = &quality},
                              {"--deps", .value = &options.deps},
                              {"--quiet", .flag = &quiet},
                              {"--timings", .flag = &options.timings},
                              {.name = NULL}};
  lam_arguments arguments = {usage, table, 1, 1, "a design file"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &path, &count);
  if (status >= 0) return status;

  char override[64];
  if (quality) {
    snprintf(override, sizeof override, "render.quality=%s", quality);
    overrides[source.override_count++] = override;
  }

  const lam_design *design;
  source.path = path;
  status = lam_verb_status(session, lam_write_options_check(session, &options));
  if (!status) status = lam_verb_status(session, lam_design_read(session, &source, &design));
  return status ? status : build_design(session, design, &options, quiet);
}

int lam_verb_build(int argc, char **argv) { return lam_verb_run(build, argc, argv); }
