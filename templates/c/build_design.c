/* Builds a design and writes its solids (STL) and cutting sheets (DXF) into a folder.
 *
 *   cc build_design.c $(pkg-config --cflags --libs lamella) -o build_design
 *   ./build_design my.yaml out */
#include <lamella/lamella.h>
#include <stdio.h>

/* What went wrong, a line each; returns the exit status. */
static int complain(const lam_session *session, lam_status status) {
  for (const lam_error *e = lam_session_messages(session); e; e = e->next)
    fprintf(stderr, "%s:%d: %s\n", e->location.file ? e->location.file : "", e->location.line,
            e->text);
  return (int)status;
}

int main(int argc, char **argv) {
  if (argc != 3) return fprintf(stderr, "usage: %s DESIGN.yaml FOLDER\n", argv[0]), 2;

  lam_session *session;
  if (lam_session_new(&session) != LAM_OK) return 1;

  /* Read and check, compute, write. */
  lam_design_source source = {.path = argv[1]};
  lam_write_options options = {.folder = argv[2], .only = "stl,dxf,report"};
  const lam_design *design;
  const lam_model *model = NULL;
  lam_written written;
  lam_status status = lam_design_read(session, &source, &design);
  if (status == LAM_OK) status = lam_design_build(session, design, &model);
  if (status == LAM_OK) status = lam_model_write(session, model, &options, &written);

  int result = 0;
  if (status != LAM_OK) {
    result = complain(session, status);
  } else {
    printf("%s: %d parts, %d sheets, %d files, %s\n", model->title, model->part_count,
           model->sheet_count, written.file_count,
           lam_report_converged(model->report) ? "converged" : "NOT converged");
  }
  lam_session_free(session);
  return result;
}
