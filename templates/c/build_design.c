/* Builds a design and writes its solids (STL) and cutting sheets (DXF) into a folder.
 *
 *   cc build_design.c $(pkg-config --cflags --libs lamella) -o build_design
 *   ./build_design my.yaml out
 *
 * The exit status is a lam_status: 0 when all is written, 1 when the design is wrong. The library
 * finds its templates beside itself; a program that is linked statically has to be told where they
 * are, by LAMELLA_TEMPLATES=$(pkg-config --variable=templates lamella). */
#include <lamella/lamella.h>
#include <stdio.h>

/* What went wrong, a line each: "my.yaml:4: net.grid: given 3; expected ...". Parts that a message
 * does not have are left out. */
static void print_messages(const lam_session *session) {
  for (const lam_error *e = lam_session_messages(session); e; e = e->next) {
    if (e->location.file) fprintf(stderr, "%s:", e->location.file);
    if (e->location.line > 0) fprintf(stderr, "%d:", e->location.line);
    if (e->location.file || e->location.line > 0) fputc(' ', stderr);
    if (e->key) fprintf(stderr, "%s: ", e->key);
    fprintf(stderr, "%s\n", e->text);
  }
}

int main(int argc, char **argv) {
  if (argc != 3) return fprintf(stderr, "usage: %s DESIGN.yaml FOLDER\n", argv[0]), LAM_BAD_INPUT;

  lam_session *session;
  lam_status status = lam_session_new(&session);
  if (status != LAM_OK) return fprintf(stderr, "%s\n", lam_status_text(status)), status;

  /* Read and check, compute, write. */
  lam_design_source source = {.path = argv[1]};
  lam_write_options options = {.folder = argv[2], .only = "stl,dxf,report"};
  const lam_design *design;
  const lam_model *model;
  lam_written written;
  status = lam_design_read(session, &source, &design);
  if (status == LAM_OK) status = lam_design_build(session, design, &model);
  if (status == LAM_OK) status = lam_model_write(session, model, &options, &written);

  /* A net that did not converge is a result, and no error. */
  print_messages(session);
  if (status == LAM_OK)
    printf("%s: %d parts, %d sheets, %d files, %s\n", model->title, model->part_count,
           model->sheet_count, written.file_count,
           lam_report_converged(model->report) ? "converged" : "NOT converged");

  lam_session_free(session);
  return status;
}
